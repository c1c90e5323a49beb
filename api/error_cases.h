// Calls that must be refused: each generates its error, with a message that names the rule, and
// leaves every queriable variable, the bound texture, the bound buffers and the surface as they
// were (2.5).
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <regex>
#include <span>
#include <string>

#include "api/call_fixture.h"
#include "api/initial_state.h"

namespace clearpipe::api {

struct ErrorCase {
  const char* text;
  GLenum error;
  std::function<void()> call;
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

  static std::vector<GLfloat> snapshot() {
    std::vector<GLfloat> all;
    const auto add = [&all](size_t count, const auto& get) {
      GLfloat values[16] = {};
      get(values);
      all.insert(all.end(), values, values + count);
    };
    for (const InitialValue& v : initial_values()) {
      add(v.values.size(), [&v](GLfloat* out) { glGetFloatv(v.name, out); });
    }
    for (GLenum i = 0; i < 8; ++i) {
      for (const GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION,
                                GL_SPOT_EXPONENT, GL_SPOT_CUTOFF, GL_CONSTANT_ATTENUATION,
                                GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION}) {
        add(4, [=](GLfloat* out) { glGetLightfv(GL_LIGHT0 + i, name, out); });
      }
      add(4, [=](GLfloat* out) { glGetClipPlanef(GL_CLIP_PLANE0 + i, out); });
    }
    for (const GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS}) {
      add(4, [=](GLfloat* out) { glGetMaterialfv(GL_FRONT, name, out); });
    }
    for (const GLenum name :
         {GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV_COLOR, GL_COMBINE_RGB, GL_COMBINE_ALPHA, GL_SRC0_RGB,
          GL_SRC1_RGB, GL_SRC2_RGB, GL_SRC0_ALPHA, GL_SRC1_ALPHA, GL_SRC2_ALPHA, GL_OPERAND0_RGB,
          GL_OPERAND1_RGB, GL_OPERAND2_RGB, GL_OPERAND0_ALPHA, GL_OPERAND1_ALPHA, GL_OPERAND2_ALPHA,
          GL_RGB_SCALE, GL_ALPHA_SCALE}) {
      add(4, [=](GLfloat* out) { glGetTexEnvfv(GL_TEXTURE_ENV, name, out); });
    }
    add(1, [](GLfloat* out) { glGetTexEnvfv(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, out); });
    for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S,
                              GL_TEXTURE_WRAP_T, GL_GENERATE_MIPMAP}) {
      add(1, [=](GLfloat* out) { glGetTexParameterfv(GL_TEXTURE_2D, name, out); });
    }
    for (const GLenum target : {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER}) {
      for (const GLenum name : {GL_BUFFER_SIZE, GL_BUFFER_USAGE}) {
        GLint value = 0;
        glGetBufferParameteriv(target, name, &value);
        all.push_back(static_cast<GLfloat>(value));
      }
    }
    return all;
  }

  void expect_refused(std::span<const ErrorCase> cases) {
    const std::vector<GLfloat> before = snapshot();
    for (const ErrorCase& c : cases) {
      c.call();
      EXPECT_EQ(glGetError(), c.error) << c.text;
      EXPECT_EQ(snapshot(), before) << c.text;
      // "GL_... in gl...(...): which argument breaks which rule (section)"
      static const std::regex kRule(R"(GL_\w+ in gl\w+\(.*\): [^{}]+ \([^{}]+\))");
      EXPECT_TRUE(std::regex_match(message_, kRule)) << c.text << ": " << message_;
      message_.clear();
      EXPECT_ERROR(GL_NO_ERROR) << c.text;
    }
    EXPECT_EQ(pixel(8, 8), 0u);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    draw_quad();
    EXPECT_EQ(pixel(8, 8), kGreen) << "the texture has changed";
  }

  std::string message_;  // of the last error
  // Something to point to where the call must not look.
  static inline GLfloat f[16] = {};
  static inline GLfixed x[16] = {};
};

}  // namespace clearpipe::api
