// Limits that applications ask for, textures up to them, sizes of any number (OES_texture_npot),
// and what happens when memory does not suffice (2.5).
// SPDX-License-Identifier: MIT
#include <sys/resource.h>

#include <cstdio>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

class Limits : public CallTest {
 protected:
  // Makes large allocations fail while it lives.
  class LittleMemory {
   public:
    LittleMemory() {
      getrlimit(RLIMIT_AS, &before_);
      rlimit now = before_;
      now.rlim_cur = address_space() + (32u << 20);
      setrlimit(RLIMIT_AS, &now);
    }
    ~LittleMemory() { setrlimit(RLIMIT_AS, &before_); }

   private:
    static rlim_t address_space() {
      long pages = 0;
      if (FILE* file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%ld", &pages) != 1) pages = 0;
        std::fclose(file);
      }
      return static_cast<rlim_t>(pages) * 4096;
    }
    rlimit before_{};
  };
};

struct Limit {
  GLenum name;
  GLint least;
};
// At least what Mesa's llvmpipe says.
constexpr Limit kLimits[] = {
    {GL_MAX_TEXTURE_SIZE, 16384},
    {GL_MAX_VIEWPORT_DIMS, 16384},
    {GL_MAX_TEXTURE_UNITS, 8},
    {GL_MAX_LIGHTS, 8},
    {GL_MAX_CLIP_PLANES, 6},
    {GL_MAX_MODELVIEW_STACK_DEPTH, 32},
    {GL_MAX_PROJECTION_STACK_DEPTH, 32},
    {GL_MAX_TEXTURE_STACK_DEPTH, 10},
    {GL_SUBPIXEL_BITS, 4},
};

TEST_F(Limits, AreNotLowerThanMesas) {
  for (const Limit& limit : kLimits) {
    GLint value[2] = {};
    glGetIntegerv(limit.name, value);
    EXPECT_GE(value[0], limit.least) << std::hex << limit.name;
  }
  GLfloat range[2];
  glGetFloatv(GL_ALIASED_POINT_SIZE_RANGE, range);
  EXPECT_GE(range[1], 255.0f);
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range);
  EXPECT_GE(range[1], 255.0f);
}

TEST_F(Limits, StacksAreAsDeepAsTheySay) {
  const GLenum stacks[][3] = {
      {GL_MODELVIEW, GL_MAX_MODELVIEW_STACK_DEPTH, GL_MODELVIEW_STACK_DEPTH},
      {GL_PROJECTION, GL_MAX_PROJECTION_STACK_DEPTH, GL_PROJECTION_STACK_DEPTH},
      {GL_TEXTURE, GL_MAX_TEXTURE_STACK_DEPTH, GL_TEXTURE_STACK_DEPTH}};
  for (const auto& [mode, max_name, depth_name] : stacks) {
    GLint max = 0, depth = 0;
    glGetIntegerv(max_name, &max);
    glMatrixMode(mode);
    for (GLint i = 1; i < max; ++i) glPushMatrix();
    EXPECT_ERROR(GL_NO_ERROR);
    glPushMatrix();
    EXPECT_ERROR(GL_STACK_OVERFLOW);
    glGetIntegerv(depth_name, &depth);
    EXPECT_EQ(depth, max);
    for (GLint i = 1; i < max; ++i) glPopMatrix();
    EXPECT_ERROR(GL_NO_ERROR);
    glPopMatrix();
    EXPECT_ERROR(GL_STACK_UNDERFLOW);
  }
}

// Every unit adds a bit of its own to the colour: all of them sample.
TEST_F(Limits, AllUnitsSample) {
  GLint units = 0;
  glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
  glColor4f(0, 0, 0, 1);
  uint32_t expected = 0xff000000u;
  for (GLint u = 0; u < units; ++u) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(u));
    one_colour_texture(0xff000000u | 1u << u);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
    expected |= 1u << u;
  }
  draw_quad();
  EXPECT_EQ(pixel(8, 8), expected);
}

// The largest texture has 15 levels and each is sampled.
TEST_F(Limits, TheLargestTextureIsDrawnFromItsLastLevel) {
  GLint max = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &max);
  one_colour_texture(kRed);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  GLint level = 0;
  for (GLint width = max; width > 0; width /= 2, ++level) {
    const uint32_t colour = width == 1 ? kGreen : kRed;
    glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA, width, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 std::vector<uint32_t>(static_cast<size_t>(width), colour).data());
    EXPECT_ERROR(GL_NO_ERROR);
  }
  glViewport(0, 0, 1, 1);
  draw_quad();
  EXPECT_EQ(pixel(0, 0), kGreen);
  glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &kRed);
  EXPECT_ERROR(GL_INVALID_VALUE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, max + 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_ERROR(GL_INVALID_VALUE);
  glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, max, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_ERROR(GL_INVALID_VALUE);
}

TEST_F(Limits, TheLargestViewportDraws) {
  GLint max[2] = {};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, max);
  const pipeline::Target wide = make_target(max[0], 2);
  make_current(context_, wide, wide);
  glViewport(0, 0, max[0], max[1]);
  draw_quad();
  EXPECT_EQ(pixel(max[0] - 1, 1), kWhite);
  EXPECT_EQ(pixel(0, 0), kWhite);
  glViewport(0, 0, max[0] + 1, 1);
  GLint box[4] = {};
  glGetIntegerv(GL_VIEWPORT, box);
  EXPECT_EQ(box[2], max[0]);  // clamped silently (2.10.1)
}

// A 3x5 texture with every wrap mode: the texel a coordinate outside of [0, 1] falls on.
TEST_F(Limits, SizesNeedNotBePowersOfTwo) {
  constexpr GLsizei kWidth = 3, kHeight = 5;
  std::vector<uint32_t> image;
  for (uint32_t i = 0; i < kWidth * kHeight; ++i) image.push_back(0xff000000u | (i + 1) * 16);
  one_colour_texture(kRed);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kWidth, kHeight, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               image.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  struct {
    GLint mode;
    int s[5];  // texel of columns -3, -1, 1, 4 and 8 of an endless row of 3
  } const kWraps[] = {{GL_REPEAT, {0, 2, 1, 1, 2}},
                      {GL_CLAMP_TO_EDGE, {0, 0, 1, 2, 2}},
                      {GL_MIRRORED_REPEAT_OES, {2, 0, 1, 1, 2}}};
  const int columns[5] = {-3, -1, 1, 4, 8};
  glMatrixMode(GL_TEXTURE);
  for (const auto& wrap : kWraps) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap.mode);
    for (int i = 0; i < 5; ++i) {
      glLoadIdentity();
      glTranslatef((static_cast<float>(columns[i]) + 0.5f) / kWidth, 0.5f, 0);
      glScalef(0, 0, 0);
      draw_quad();
      EXPECT_EQ(pixel(3, 3), image[static_cast<size_t>(2 * kWidth + wrap.s[i])])
          << std::hex << wrap.mode << " column " << std::dec << columns[i];
    }
  }
  // Mipmaps are halved and rounded down: 2x1 needs 1x1, and 3x5 needs 1x2 and 1x1.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
  draw_quad();
  EXPECT_EQ(pixel(3, 3), kWhite);
  glTexImage2D(GL_TEXTURE_2D, 2, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
  draw_quad();
  EXPECT_NE(pixel(3, 3), kWhite);
}

// The allocators of the sanitizers end the process where the ordinary one fails.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kAllocationsMayFail = false;
#else
constexpr bool kAllocationsMayFail = true;
#endif

TEST_F(Limits, WithoutMemoryAnImageIsNotChanged) {
  if (!kAllocationsMayFail) GTEST_SKIP();
  one_colour_texture(kRed, 4);
  {
    const LittleMemory little;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8192, 8192, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_ERROR(GL_OUT_OF_MEMORY);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 8192, 8192, 0);
    EXPECT_ERROR(GL_OUT_OF_MEMORY);
  }
  draw_quad();
  EXPECT_EQ(pixel(8, 8), kRed);
}

TEST_F(Limits, WithoutMemoryABufferKeepsItsData) {
  if (!kAllocationsMayFail) GTEST_SKIP();
  const GLubyte byte = 1;
  glBindBuffer(GL_ARRAY_BUFFER, 1);
  glBufferData(GL_ARRAY_BUFFER, 1, &byte, GL_STATIC_DRAW);
  for (const GLsizeiptr size : {GLsizeiptr{1} << 40, INTPTR_MAX}) {
    glBufferData(GL_ARRAY_BUFFER, size, nullptr, GL_DYNAMIC_DRAW);
    EXPECT_ERROR(GL_OUT_OF_MEMORY);
  }
  GLint value = 0;
  glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &value);
  EXPECT_EQ(value, 1);
  glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_USAGE, &value);
  EXPECT_EQ(value, GL_STATIC_DRAW);
}

}  // namespace
}  // namespace clearpipe::api
