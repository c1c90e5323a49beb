// Surfaces of the colour and depth sizes that configs have, and of the sRGB colour space: what is
// drawn, cleared, blended and read.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "icd/egl_test.h"

namespace clearpipe::icd {
namespace {

struct Sizes {
  EGLint red, green, blue, alpha;
};

class SurfaceFormatTest : public EglTest {
 protected:
  EGLint attrib(EGLConfig of, EGLint attribute) {
    EGLint value = -1;
    eglGetConfigAttrib(display, of, attribute, &value);
    return value;
  }
  // The config of exactly these sizes.
  EGLConfig exact(const Sizes& sizes, EGLint depth = 0, EGLint stencil = 0) {
    std::array<EGLConfig, 128> all{};
    EGLint count = 0;
    eglGetConfigs(display, all.data(), 128, &count);
    for (EGLint i = 0; i < count; ++i) {
      const EGLConfig c = all[static_cast<size_t>(i)];
      if (attrib(c, EGL_RED_SIZE) == sizes.red && attrib(c, EGL_GREEN_SIZE) == sizes.green &&
          attrib(c, EGL_BLUE_SIZE) == sizes.blue && attrib(c, EGL_ALPHA_SIZE) == sizes.alpha &&
          attrib(c, EGL_DEPTH_SIZE) == depth && attrib(c, EGL_STENCIL_SIZE) == stencil &&
          attrib(c, EGL_SAMPLES) == 0) {
        return c;
      }
    }
    return nullptr;
  }
  EGLSurface current(EGLConfig with, std::vector<EGLint> list = {}) {
    config = with;
    list.insert(list.end(), {EGL_WIDTH, 64, EGL_HEIGHT, 4, EGL_NONE});
    const EGLSurface surface = eglCreatePbufferSurface(display, config, list.data());
    EXPECT_TRUE(eglMakeCurrent(display, surface, surface, context()));
    return surface;
  }
  static GLint get(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
  }
  static std::array<int, 4> read(int x = 0) {
    std::array<uint8_t, 4> p{};
    glReadPixels(x, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p.data());
    return {p[0], p[1], p[2], p[3]};
  }
  static void draw(const std::array<int, 4>& colour, float z = 0) {
    const GLfloat corners[] = {-1, -1, z, 1, -1, z, -1, 1, z, 1, 1, z};
    glColor4f(unit(colour[0]), unit(colour[1]), unit(colour[2]), unit(colour[3]));
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, corners);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  static float unit(int v) { return static_cast<float>(v) / 255; }
  // The upper bits of a component, repeated.
  static int kept(int v, int bits) {
    if (bits == 0) return 255;
    int wide = v >> (8 - bits) << (8 - bits);
    for (int have = bits; have < 8; have *= 2) wide |= wide >> have;
    return wide;
  }
};

constexpr Sizes kSizes[] = {{8, 8, 8, 8}, {8, 8, 8, 0}, {5, 6, 5, 0}, {5, 5, 5, 1}, {4, 4, 4, 4}};

TEST_F(SurfaceFormatTest, QueriesAndPixels) {
  for (const Sizes& sizes : kSizes) {
    const EGLConfig with = exact(sizes);
    ASSERT_NE(with, nullptr) << sizes.red << sizes.green << sizes.blue << sizes.alpha;
    current(with);
    EXPECT_EQ(get(GL_RED_BITS), sizes.red);
    EXPECT_EQ(get(GL_GREEN_BITS), sizes.green);
    EXPECT_EQ(get(GL_BLUE_BITS), sizes.blue);
    EXPECT_EQ(get(GL_ALPHA_BITS), sizes.alpha);
    const int bits[] = {sizes.red, sizes.green, sizes.blue, sizes.alpha};
    for (int v = 0; v < 256; v += 3) {
      const std::array<int, 4> colour = {v, 255 - v, v / 2, v};
      draw(colour);
      const auto drawn = read();
      glClearColor(unit(colour[0]), unit(colour[1]), unit(colour[2]), unit(colour[3]));
      glClear(GL_COLOR_BUFFER_BIT);
      const auto cleared = read();
      for (size_t c = 0; c < 4; ++c) {
        ASSERT_EQ(drawn[c], kept(colour[c], bits[c])) << v << " " << c;
        const int most = (1 << bits[c]) - 1;
        const int nearest = static_cast<int>(std::lround(unit(colour[c]) * most));
        ASSERT_EQ(cleared[c], bits[c] == 0 ? 255 : kept(nearest << (8 - bits[c]), bits[c]))
            << v << " " << c;
      }
    }
  }
}

// Blending sees what is stored, and is truncated as well; dithering changes nothing.
TEST_F(SurfaceFormatTest, Blending) {
  current(exact({5, 6, 5, 0}));
  EXPECT_TRUE(glIsEnabled(GL_DITHER));
  for (const bool dither : {true, false}) {
    dither ? glEnable(GL_DITHER) : glDisable(GL_DITHER);
    glDisable(GL_BLEND);
    draw({100, 50, 20, 255});
    EXPECT_EQ(read(), (std::array{99, 48, 16, 255}));
    EXPECT_EQ(read(1), read());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    draw({30, 30, 30, 255});
    EXPECT_EQ(read(), (std::array{132, 77, 41, 255}));
  }
}

// Two depths that 24 bits tell apart and 16 do not.
TEST_F(SurfaceFormatTest, Depths) {
  for (const EGLint depth : {16, 24, 32}) {
    current(exact({8, 8, 8, 8}, depth));
    EXPECT_EQ(get(GL_DEPTH_BITS), depth);
    EXPECT_EQ(get(GL_STENCIL_BITS), 0);
    const auto second_passes = [](float step) {
      glDisable(GL_DEPTH_TEST);
      glClear(GL_DEPTH_BUFFER_BIT);
      glEnable(GL_DEPTH_TEST);
      glDepthFunc(GL_LESS);
      glMatrixMode(GL_PROJECTION);
      glLoadIdentity();
      draw({255, 0, 0, 255}, -1 + 2 * 0.00125f);
      draw({0, 255, 0, 255}, -1 + 2 * (0.00125f - step));
      return read()[1] == 255;
    };
    EXPECT_TRUE(second_passes(1 / 30000.0f)) << depth;
    EXPECT_EQ(second_passes(1 / 2000000.0f), depth > 16) << depth;
    glDepthFunc(GL_EQUAL);
    for (const float clear : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
      glDepthFunc(GL_EQUAL);
      glClearDepthf(clear);
      glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
      draw({0, 0, 255, 255}, 2 * clear - 1);
      EXPECT_EQ(read()[2], 255) << depth << " " << clear;
    }
  }
}

// One unit of polygon offset passes on a surface of any depth (3.5.2).
TEST_F(SurfaceFormatTest, PolygonOffset) {
  for (const EGLint depth : {16, 24, 32}) {
    current(exact({8, 8, 8, 8}, depth));
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    for (const float z : {-0.99f, -0.5f, 0.3f, 0.9f}) {
      glDisable(GL_POLYGON_OFFSET_FILL);
      glClear(GL_DEPTH_BUFFER_BIT);
      draw({255, 0, 0, 255}, z);
      draw({0, 255, 0, 255}, z);
      EXPECT_EQ(read()[0], 255) << depth << " " << z;
      glEnable(GL_POLYGON_OFFSET_FILL);
      glPolygonOffset(0, -2);
      draw({0, 0, 255, 255}, z);
      EXPECT_EQ(read()[2], 255) << depth << " " << z;
    }
  }
}

// EGL_GL_COLORSPACE: colours are encoded when they are stored, and blended as what they stand for.
TEST_F(SurfaceFormatTest, ColourSpaceSrgb) {
  const auto encoded = [](double v) {
    return static_cast<int>(
        std::lround(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055)));
  };
  for (const Sizes& sizes : {kSizes[0], kSizes[1]}) {
    const EGLSurface surface = current(exact(sizes), {EGL_GL_COLORSPACE, EGL_GL_COLORSPACE_SRGB});
    EXPECT_EQ(query(surface, EGL_GL_COLORSPACE), EGL_GL_COLORSPACE_SRGB);
    EXPECT_EQ(get(GL_RED_BITS), 8);
    for (int v = 0; v < 256; v += 5) {
      draw({v, 255 - v, 128, 128});
      auto pixel = read();
      EXPECT_NEAR(pixel[0], encoded(v / 255.0), 1);
      EXPECT_NEAR(pixel[1], encoded(1 - v / 255.0), 1);
      EXPECT_EQ(pixel[3], sizes.alpha == 0 ? 255 : 128);  // alpha is not encoded
      glClearColor(unit(v), unit(255 - v), unit(128), unit(128));
      glClear(GL_COLOR_BUFFER_BIT);
      pixel = read();
      EXPECT_NEAR(pixel[0], encoded(v / 255.0), 1);
      EXPECT_NEAR(pixel[2], encoded(128 / 255.0), 1);
    }
    draw({51, 102, 0, 255});
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    draw({51, 51, 255, 255});
    EXPECT_NEAR(read()[0], encoded(0.4), 1);
    EXPECT_NEAR(read()[1], encoded(0.6), 1);
    EXPECT_EQ(read()[2], 255);
    glDisable(GL_BLEND);
  }
  // Linear by default, and for what has fewer bits there is nothing else.
  EXPECT_EQ(query(current(exact(kSizes[0])), EGL_GL_COLORSPACE), EGL_GL_COLORSPACE_LINEAR);
  draw({51, 102, 0, 255});
  EXPECT_EQ(read()[0], 51);
  const EGLint list[] = {EGL_GL_COLORSPACE, EGL_GL_COLORSPACE_SRGB, EGL_NONE};
  EXPECT_EGL_FAIL(eglCreatePbufferSurface(display, exact({5, 6, 5, 0}), list), EGL_NO_SURFACE,
                  EGL_BAD_MATCH);
}

}  // namespace
}  // namespace clearpipe::icd
