// What tests of calls start from: a context that is current on a small surface, and short ways to
// draw, to read back and to look at errors.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "api/context.h"
#include "api/prototypes.h"

namespace clearpipe::api {

inline constexpr int kSize = 16;

inline constexpr GLenum k2D = GL_TEXTURE_2D, kCube = GL_TEXTURE_CUBE_MAP_OES;

inline constexpr uint32_t kRed = 0xff0000ffu, kGreen = 0xff00ff00u, kBlue = 0xffff0000u,
                          kWhite = 0xffffffffu;

inline pipeline::Target make_target(int width, int height, bool alpha = true, bool depth = true,
                                    bool stencil = true, int samples = 1) {
  pipeline::Target target;
  target.colour = pipeline::make_colour_buffer(width, height, alpha, samples);
  if (depth || stencil) {
    target.depth_stencil =
        pipeline::make_depth_stencil_buffer(width, height, depth, stencil, samples);
  }
  target.width = width;
  target.height = height;
  return target;
}

class CallTest : public testing::Test {
 protected:
  void SetUp() override {
    context_ = create_context(nullptr);
    ASSERT_NE(context_, nullptr);
    ASSERT_TRUE(make_current(context_, target_, target_));
  }
  void TearDown() override {
    make_current(nullptr, {}, {});
    destroy_context(context_);
  }

  static uint32_t pixel(int x, int y) {
    uint32_t value = 0;
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &value);
    return value;
  }
  // Over the whole viewport, with texture coordinates from 0 to 1 on every unit.
  static void draw_quad() {
    static const float kQuad[] = {-1, -1, 1, -1, -1, 1, 1, 1};
    static const float kCorners[] = {0, 0, 1, 0, 0, 1, 1, 1};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, kQuad);
    GLint units = 0;
    glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
    for (GLint u = 0; u < units; ++u) {
      glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(u));
      glEnableClientState(GL_TEXTURE_COORD_ARRAY);
      glTexCoordPointer(2, GL_FLOAT, 0, kCorners);
    }
    glClientActiveTexture(GL_TEXTURE0);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  // The left or the right half of the surface.
  static void draw_half(int half) {
    glViewport(half * kSize / 2, 0, kSize / 2, kSize);
    draw_quad();
  }
  static uint32_t left() { return pixel(kSize / 4, kSize / 2); }
  static uint32_t right() { return pixel(3 * kSize / 4, kSize / 2); }

  // A texture of one colour that replaces what it is drawn on, bound and enabled.
  static GLuint one_colour_texture(uint32_t colour, GLsizei size = 1) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    fill_texture(colour, size);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    return name;
  }
  static std::vector<uint32_t> texels(uint32_t colour, GLsizei size) {
    return std::vector<uint32_t>(static_cast<size_t>(size) * static_cast<size_t>(size), colour);
  }
  static void fill_texture(uint32_t colour, GLsizei size = 1) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels(colour, size).data());
  }

  pipeline::Target target_ = make_target(kSize, kSize);
  Context* context_ = nullptr;
};

#define EXPECT_ERROR(error) EXPECT_EQ(glGetError(), static_cast<GLenum>(error))

}  // namespace clearpipe::api
