// Rectangles of textures against the equations of OES_draw_texture, pixel by pixel: which pixels
// get a fragment, its texture coordinates, depth, colour and distance for fog. Textures have a
// colour of its own for each texel, and NEAREST shows which was taken. SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>
#include <limits>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

constexpr uint32_t kGrey = 0xff333333u;

// A rectangle on the screen, and its crop rectangle.
struct Rectangle {
  GLfloat x, y, width, height;
  GLint crop[4];
};

class DrawTexture : public CallTest {
 protected:
  static constexpr int kWidth = 8, kHeight = 4;

  void SetUp() override {
    CallTest::SetUp();
    glClearColor(0.2f, 0.2f, 0.2f, 1);
    texture_ = bind_numbered_texture(0);
  }

  static uint32_t texel(int i, int j, uint32_t blue) {
    return 0xff000000u | blue << 16 | static_cast<uint32_t>(40 * j + 10) << 8 |
           static_cast<uint32_t>(20 * i + 5);
  }
  // Each texel's red and green say where it is, its blue is given; wrapped, as REPEAT does.
  static GLuint bind_numbered_texture(uint32_t blue, int width = kWidth, int height = kHeight) {
    std::vector<uint32_t> texels;
    for (int j = 0; j < height; ++j) {
      for (int i = 0; i < width; ++i) texels.push_back(texel(i, j, blue));
    }
    const GLuint name = one_colour_texture(0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
    crop({0, 0, width, height});
    return name;
  }
  static void crop(std::array<GLint, 4> rectangle) {
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, rectangle.data());
  }
  static int wrapped(double u, int size) {
    const int i = static_cast<int>(std::floor(u)) % size;
    return i < 0 ? i + size : i;
  }
  // 5.7: the texel of the fragment at pixel (x, y), with the texture's own size of kWidth x
  // kHeight.
  static uint32_t expected(const Rectangle& r, int x, int y) {
    if (!(x + 1 > r.x && x < r.x + r.width && y + 1 > r.y && y < r.y + r.height)) return kGrey;
    const double s = (r.crop[0] + (x + 0.5 - r.x) * (r.crop[2] / double{r.width})) / kWidth;
    const double t = (r.crop[1] + (y + 0.5 - r.y) * (r.crop[3] / double{r.height})) / kHeight;
    return texel(wrapped(s * kWidth, kWidth), wrapped(t * kHeight, kHeight), 0);
  }
  static void expect_rectangle(const Rectangle& r, const char* what) {
    std::array<uint32_t, kSize * kSize> pixels;
    glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        ASSERT_EQ(pixels[static_cast<size_t>(y * kSize + x)], expected(r, x, y))
            << what << " at " << x << ", " << y;
      }
    }
    EXPECT_ERROR(GL_NO_ERROR) << what;
  }
  static void check(const Rectangle& r, const char* what) {
    glClear(GL_COLOR_BUFFER_BIT);
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, r.crop);
    glDrawTexfOES(r.x, r.y, 0, r.width, r.height);
    expect_rectangle(r, what);
  }
  // The window depth that the pixels of the next quad get, whatever its vertices say.
  static bool has_depth(GLfloat depth) {
    glDepthRangef(depth, depth);
    glDepthFunc(GL_EQUAL);
    glDisable(GL_TEXTURE_2D);
    glColor4f(0, 0, 1, 1);
    draw_quad();
    glColor4f(1, 1, 1, 1);
    glEnable(GL_TEXTURE_2D);
    glDepthFunc(GL_ALWAYS);
    return pixel(4, 4) == kBlue;
  }
  GLuint texture_ = 0;
};

TEST_F(DrawTexture, EveryFormOfTheCallPutsTexelsOnPixels) {
  const GLshort s[] = {3, 2, 0, kWidth, kHeight};
  const GLint i[] = {3, 2, 0, kWidth, kHeight};
  const GLfixed x[] = {3 << 16, 2 << 16, 0, kWidth << 16, kHeight << 16};
  const GLfloat f[] = {3, 2, 0, kWidth, kHeight};
  const std::pair<const char*, std::function<void()>> kForms[] = {
      {"s", [&] { glDrawTexsOES(s[0], s[1], s[2], s[3], s[4]); }},
      {"sv", [&] { glDrawTexsvOES(s); }},
      {"i", [&] { glDrawTexiOES(i[0], i[1], i[2], i[3], i[4]); }},
      {"iv", [&] { glDrawTexivOES(i); }},
      {"x", [&] { glDrawTexxOES(x[0], x[1], x[2], x[3], x[4]); }},
      {"xv", [&] { glDrawTexxvOES(x); }},
      {"f", [&] { glDrawTexfOES(f[0], f[1], f[2], f[3], f[4]); }},
      {"fv", [&] { glDrawTexfvOES(f); }},
  };
  for (const auto& [name, draw] : kForms) {
    glClear(GL_COLOR_BUFFER_BIT);
    draw();
    expect_rectangle({3, 2, kWidth, kHeight, {0, 0, kWidth, kHeight}}, name);
  }
}

TEST_F(DrawTexture, CropsAndStretches) {
  check({0, 0, 16, 16, {0, 0, 8, 4}}, "stretched");
  check({2, 3, 4, 2, {3, 1, 4, 2}}, "a part, as large");
  check({1, 1, 13, 11, {2, 1, 5, 3}}, "a part, stretched");
  check({5, 5, 2, 2, {0, 0, 7, 3}}, "shrunk");
  check({0, 0, 16, 16, {-3, -2, 20, 9}}, "beyond the texture");
  check({3, 2, 8, 4, {8, 0, -8, 4}}, "mirrored across");
  check({3, 2, 8, 4, {0, 4, 8, -4}}, "upside down");
  check({1, 2, 11, 13, {7, 3, -5, -2}}, "both, a part");
  check({3, 2, 8, 4, {5, 1, 0, 0}}, "one texel");
}

// A fragment for each pixel that overlaps the rectangle, even where its centre is outside.
TEST_F(DrawTexture, PixelsThatOverlapGetFragments) {
  check({2.25f, 3.75f, 8, 4, {0, 0, 8, 4}}, "between pixels");
  check({2.75f, 3.25f, 0.125f, 0.5f, {2, 2, 1, 1}}, "less than a pixel");
  check({2.75f, 3.25f, 0.5f, 4.5f, {2, 2, 1, 2}}, "two columns");
}

TEST_F(DrawTexture, PartsOutsideOfTheSurfaceAreCut) {
  check({-3, -2, 8, 4, {0, 0, 8, 4}}, "lower left");
  check({13, 14, 8, 4, {0, 0, 8, 4}}, "upper right");
  check({-100, -50, 217, 119, {0, 0, 8, 4}}, "all around");
  check({16, 3, 8, 4, {0, 0, 8, 4}}, "right of it");
  check({3, -4, 8, 4, {0, 0, 8, 4}}, "below it");
  check({-40000000, 0, 80000000, 4, {0, 0, 0, 4}}, "very wide");
}

TEST_F(DrawTexture, NumbersWithoutMeaningDoNoHarm) {
  constexpr GLfloat kInfinity = std::numeric_limits<GLfloat>::infinity(),
                    kNan = std::numeric_limits<GLfloat>::quiet_NaN();
  glDrawTexfOES(kNan, 0, 0, 4, 4);
  glDrawTexfOES(0, -kInfinity, kNan, 4, kInfinity);
  glDrawTexfOES(-kInfinity, 0, 0, 4, 4);
  glDrawTexiOES(INT32_MIN, INT32_MIN, 0, INT32_MAX, INT32_MAX);
  crop({INT32_MAX, INT32_MIN, INT32_MAX, INT32_MIN});
  glDrawTexfOES(0, 0, 0, 1e-30f, 1e30f);
  glFinish();
  EXPECT_ERROR(GL_NO_ERROR);
  glDrawTexfOES(0, 0, 0, kNan, 4);
  EXPECT_ERROR(GL_INVALID_VALUE);
}

// 5.7: one texel for each pixel, also when texels are mixed.
TEST_F(DrawTexture, LinearFiltersMapOneToOne) {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  check({3, 2, 8, 4, {0, 0, 8, 4}}, "linear");
  check({1, 5, 6, 3, {1, 1, 6, 3}}, "linear, a part");
}

TEST_F(DrawTexture, ShrinkingTakesLevels) {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  for (GLint level = 1; level < 4; ++level) {
    const GLsizei width = kWidth >> level, height = std::max(1, kHeight >> level);
    glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels(level == 1 ? kGreen : kRed, width).data());
  }
  glDrawTexiOES(0, 0, 0, kWidth / 2, kHeight / 2);
  EXPECT_EQ(pixel(1, 1), kGreen);
}

// The current colour, not clip planes, matrices, culling, offsets, lights or the viewport.
TEST_F(DrawTexture, VerticesHaveNoPartInIt) {
  const GLfloat nothing[] = {0, 0, 0, -1};
  glViewport(4, 4, 1, 1);
  glClipPlanef(GL_CLIP_PLANE0, nothing);
  glEnable(GL_CLIP_PLANE0);
  glCullFace(GL_FRONT_AND_BACK);
  glEnable(GL_CULL_FACE);
  glEnable(GL_LIGHTING);
  glShadeModel(GL_FLAT);
  glPolygonOffset(100, 1e6f);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_EQUAL);
  glClearDepthf(0);
  glClear(GL_DEPTH_BUFFER_BIT);
  for (const GLenum mode : {GL_PROJECTION, GL_MODELVIEW, GL_TEXTURE}) {
    glMatrixMode(mode);
    glRotatef(30, 1, 2, 3);
    glScalef(5, 7, 11);
  }
  check({3, 2, 8, 4, {0, 0, 8, 4}}, "all of it");
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  glColor4f(0, 1, 0, 1);
  glDrawTexiOES(3, 2, 0, kWidth, kHeight);
  EXPECT_EQ(pixel(3, 2), texel(0, 0, 0) & 0xff00ff00u);
}

TEST_F(DrawTexture, OtherDrawsAreAsBefore) {
  glViewport(0, 0, 8, 16);
  glCullFace(GL_FRONT);
  glEnable(GL_CULL_FACE);
  glMatrixMode(GL_TEXTURE);
  glTranslatef(0, 0.5f, 0);
  glDrawTexiOES(8, 0, 0, kWidth, kHeight);
  draw_quad();
  EXPECT_EQ(pixel(2, 8), 0u) << "culled";
  glFrontFace(GL_CW);
  draw_quad();
  EXPECT_EQ(pixel(2, 0), texel(2, 2, 0));
  EXPECT_EQ(pixel(8, 15), 0u);
}

TEST_F(DrawTexture, TheScissorCuts) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(5, 3, 2, 1);
  glDrawTexiOES(3, 2, 0, kWidth, kHeight);
  glDisable(GL_SCISSOR_TEST);
  EXPECT_EQ(pixel(5, 3), texel(2, 1, 0));
  EXPECT_EQ(pixel(6, 3), texel(3, 1, 0));
  EXPECT_EQ(pixel(7, 3), 0u);
  EXPECT_EQ(pixel(5, 2), 0u);
}

// Zw = n for z <= 0, f for z >= 1, else n + z (f - n).
TEST_F(DrawTexture, DepthIsThatOfTheDepthRange) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  const struct {
    GLfloat n, f, z, depth;
  } kCases[] = {{0, 1, 0.5f, 0.5f},
                {0.25f, 0.75f, 0.5f, 0.5f},
                {0.25f, 0.75f, -3, 0.25f},
                {0.25f, 0.75f, 7, 0.75f},
                {0.75f, 0.25f, 0.25f, 0.625f},
                {0, 1, 0, 0},
                {0, 1, 1, 1}};
  for (const auto& c : kCases) {
    glDepthRangef(c.n, c.f);
    glDrawTexfOES(0, 0, c.z, kSize, kSize);
    EXPECT_TRUE(has_depth(c.depth)) << c.n << " " << c.f << " " << c.z;
  }
  glDepthRangef(0, 1);
  glDrawTexfOES(0, 0, 0.5f, kSize, kSize);
  EXPECT_FALSE(has_depth(0.25f));
}

// The distance is zero: (1 - 0) / (1 + 1) of the fragment's colour is left, whatever z is.
TEST_F(DrawTexture, FogTakesADistanceOfZero) {
  const GLfloat colour[] = {0.2f, 0.2f, 0.2f, 1};
  glEnable(GL_FOG);
  glFogfv(GL_FOG_COLOR, colour);
  glFogf(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, -1);
  glFogf(GL_FOG_END, 1);
  fill_texture(kWhite);
  glDrawTexfOES(0, 0, 0.75f, kSize, kSize);
  EXPECT_EQ(pixel(4, 4), 0xff999999u);
  glFogf(GL_FOG_MODE, GL_EXP);
  glDrawTexfOES(0, 0, 0.75f, kSize, kSize);
  EXPECT_EQ(pixel(4, 4), kWhite);
}

// Each unit has the coordinates of its own texture's size and crop rectangle.
TEST_F(DrawTexture, EveryEnabledUnitTakesPart) {
  glActiveTexture(GL_TEXTURE2);
  bind_numbered_texture(100, 4, 2);
  crop({1, 2, 2, -2});
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
  glDrawTexiOES(3, 2, 0, 8, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 8; ++x) {
      const uint32_t first = texel(x, y, 0),
                     second = texel(1 + x / 4, y < 2 ? 1 : 0, 100) & 0xffffffu;
      EXPECT_EQ(pixel(3 + x, 2 + y), first + second) << x << " " << y;
    }
  }
}

TEST_F(DrawTexture, UnitsWithoutACompleteTextureAreDisabled) {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glColor4f(1, 0, 0, 1);
  glDrawTexiOES(3, 2, 0, 8, 4);
  EXPECT_EQ(pixel(3, 2), kRed);
  EXPECT_EQ(pixel(2, 2), 0u);
}

// Rows of framebuffer objects count from the other end of memory.
TEST_F(DrawTexture, FramebufferObjectsToo) {
  GLuint target = 0;
  glGenTextures(1, &target);
  glBindTexture(GL_TEXTURE_2D, target);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, 1);
  glFramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, target, 0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  check({2.25f, 3.75f, 8, 4, {0, 0, 8, 4}}, "to a texture");
  check({1, 1, 13, 11, {2, 1, 5, 3}}, "to a texture, stretched");
}

TEST_F(DrawTexture, TheCropRectangleIsSetAndReadInEveryType) {
  const auto expect_crop = [](std::array<GLint, 4> wanted) {
    GLint i[4];
    GLfixed x[4];
    GLfloat f[4];
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, i);
    glGetTexParameterxv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, x);
    glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, f);
    for (size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(i[k], wanted[k]);
      EXPECT_EQ(x[k], wanted[k] * 65536);
      EXPECT_EQ(f[k], static_cast<GLfloat>(wanted[k]));
    }
  };
  const GLfloat f[] = {1, -2, 3.75f, 4.25f};
  const GLfixed x[] = {5 << 16, -6 * 65536, 7 << 16, 8 << 16};
  glBindTexture(GL_TEXTURE_2D, 77);
  expect_crop({0, 0, 0, 0});
  crop({1, -2, 300, -400});
  expect_crop({1, -2, 300, -400});
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, f);
  expect_crop({1, -2, 4, 4});
  glTexParameterxv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, x);
  expect_crop({5, -6, 7, 8});
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, 9);
  EXPECT_ERROR(GL_INVALID_ENUM);
  expect_crop({5, -6, 7, 8});
}

TEST_F(DrawTexture, Errors) {
  const GLshort flat[] = {0, 0, 0, 8, 0};
  glDrawTexsvOES(flat);
  EXPECT_ERROR(GL_INVALID_VALUE);
  glDrawTexiOES(0, 0, 0, -8, 4);
  EXPECT_ERROR(GL_INVALID_VALUE);
  glDrawTexxOES(0, 0, 0, 0, 0x10000);
  EXPECT_ERROR(GL_INVALID_VALUE);
  EXPECT_EQ(pixel(0, 0), 0u);
  make_current(context_, {}, {});
  glDrawTexfOES(0, 0, 0, 8, 4);
  EXPECT_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
}

}  // namespace
}  // namespace clearpipe::api
