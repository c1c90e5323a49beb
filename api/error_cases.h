// Calls that must be refused: each generates its error, with a message that names the rule, and
// leaves every queriable variable, the bound texture, the bound buffers and the surface as they
// were (2.5).
// SPDX-License-Identifier: MIT
#pragma once

#include <iostream>
#include <span>
#include <string>

#include "api/call_fixture.h"
#include "api/state_table.h"

namespace clearpipe::api {

struct ErrorCase {
  const char* text;
  GLenum error;
  void (*call)();
};
// A call and the error it must generate.
#define REFUSED(error, ...)                  \
  {                                          \
#__VA_ARGS__, error, [] { __VA_ARGS__; } \
  }

class ErrorTest : public CallTest {
 protected:
  // A texture of 4x4 with one level and buffers of 8 bytes are bound; nothing else is set.
  void SetUp() override {
    CallTest::SetUp();
    glBindTexture(GL_TEXTURE_2D, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    fill_texture(kGreen, 4);
    for (const GLenum target : {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER}) {
      glBindBuffer(target, target);
      glBufferData(target, 8, nullptr, GL_STATIC_DRAW);
    }
    ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    glEnable(GL_DEBUG_OUTPUT_KHR);
    glDebugMessageCallbackKHR(
        [](GLenum, GLenum, GLuint, GLenum, GLsizei, const char* text, const void* user) {
          static_cast<ErrorTest*>(const_cast<void*>(user))->message_ = text;
        },
        this);
  }

  // Whatever a test has bound: the surface is as it was, and so is the texture.
  void TearDown() override {
    glDisable(GL_DEBUG_OUTPUT_KHR);
    glBindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
    make_current(context_, target_, target_);
    EXPECT_EQ(pixel(8, 8), 0u) << "the surface has changed";
    glBindVertexArrayOES(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindTexture(GL_TEXTURE_2D, 1);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    draw_quad();
    EXPECT_EQ(pixel(8, 8), kGreen) << "the texture has changed";
    std::cout << "errors: " << cases_ << " cases\n";
    CallTest::TearDown();
  }

  void expect_refused(std::span<const ErrorCase> cases);

  std::string message_;  // of the last error
  size_t cases_ = 0;
  // Something to point to where the call must not look.
  static inline GLfloat f[16] = {};
  static inline GLfixed x[16] = {};
};

}  // namespace clearpipe::api
