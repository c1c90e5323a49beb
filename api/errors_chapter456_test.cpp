// Errors of chapters 4 to 6: fragments, the framebuffer, hints and queries.
// SPDX-License-Identifier: MIT
#include "api/error_cases.h"

namespace clearpipe::api {
namespace {

class Chapter456Errors : public ErrorTest {
 protected:
  static void read(GLsizei width, GLsizei height, GLenum format, GLenum type) {
    uint32_t untouched[4] = {7, 7, 7, 7};
    glReadPixels(0, 0, width, height, format, type, untouched);
    for (const uint32_t v : untouched) EXPECT_EQ(v, 7u);
  }
  static const std::vector<ErrorCase>& fragments() {
    static const std::vector<ErrorCase> kCases = {
        REFUSED(GL_INVALID_VALUE, glScissor(0, 0, -1, 1)),
        REFUSED(GL_INVALID_VALUE, glScissor(0, 0, 1, -1)),
        REFUSED(GL_INVALID_ENUM, glAlphaFunc(GL_KEEP, 0.5f)),
        REFUSED(GL_INVALID_ENUM, glAlphaFuncx(GL_ALWAYS + 1, 0x8000)),
        REFUSED(GL_INVALID_ENUM, glStencilFunc(GL_KEEP, 1, 1)),
        REFUSED(GL_INVALID_ENUM, glStencilOp(GL_ALWAYS, GL_ZERO, GL_ZERO)),
        REFUSED(GL_INVALID_ENUM, glStencilOp(GL_ZERO, GL_ALWAYS, GL_ZERO)),
        REFUSED(GL_INVALID_ENUM, glStencilOp(GL_ZERO, GL_ZERO, GL_ALWAYS)),
        REFUSED(GL_INVALID_ENUM, glDepthFunc(GL_NEVER - 1)),
        REFUSED(GL_INVALID_ENUM, glBlendFunc(GL_SRC_COLOR, GL_ZERO)),
        REFUSED(GL_INVALID_ENUM, glBlendFunc(GL_ONE_MINUS_SRC_COLOR, GL_ZERO)),
        REFUSED(GL_INVALID_ENUM, glBlendFunc(GL_ZERO, GL_DST_COLOR)),
        REFUSED(GL_INVALID_ENUM, glBlendFunc(GL_ZERO, GL_ONE_MINUS_DST_COLOR)),
        REFUSED(GL_INVALID_ENUM, glBlendFunc(GL_ZERO, GL_SRC_ALPHA_SATURATE)),
        REFUSED(GL_INVALID_ENUM, glBlendFunc(GL_ADD, GL_ZERO)),
        REFUSED(GL_INVALID_ENUM, glBlendFuncSeparateOES(GL_ZERO, GL_ZERO, GL_ADD, GL_ZERO)),
        REFUSED(GL_INVALID_ENUM, glBlendFuncSeparateOES(GL_ZERO, GL_ZERO, GL_ZERO, GL_ADD)),
        REFUSED(GL_INVALID_ENUM, glBlendEquationOES(GL_ADD)),
        REFUSED(GL_INVALID_ENUM, glBlendEquationSeparateOES(GL_FUNC_SUBTRACT_OES, 0)),
        REFUSED(GL_INVALID_ENUM, glLogicOp(GL_CLEAR - 1)),
        REFUSED(GL_INVALID_ENUM, glLogicOp(GL_SET + 1)),
        REFUSED(GL_INVALID_VALUE, glClear(GL_COLOR_BUFFER_BIT | 1)),
        REFUSED(GL_INVALID_VALUE, read(-1, 1, GL_RGBA, GL_UNSIGNED_BYTE)),
        REFUSED(GL_INVALID_VALUE, read(1, -1, GL_RGBA, GL_UNSIGNED_BYTE)),
        REFUSED(GL_INVALID_ENUM, read(1, 1, GL_FLOAT, GL_UNSIGNED_BYTE)),
        REFUSED(GL_INVALID_ENUM, read(1, 1, GL_RGBA, GL_FLOAT)),
        REFUSED(GL_INVALID_OPERATION, read(1, 1, GL_RGB, GL_UNSIGNED_BYTE)),
        REFUSED(GL_INVALID_OPERATION, read(1, 1, GL_RGB, GL_UNSIGNED_SHORT_5_6_5)),
        REFUSED(GL_INVALID_OPERATION, read(1, 1, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4)),
        REFUSED(GL_INVALID_VALUE, glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
        REFUSED(GL_INVALID_ENUM, glBlendFuncSeparateOES(GL_ADD, GL_ZERO, GL_ZERO, GL_ZERO)),
        REFUSED(GL_INVALID_ENUM, glBlendFuncSeparateOES(GL_ZERO, GL_DST_COLOR, GL_ZERO, GL_ZERO)),
        REFUSED(GL_INVALID_ENUM, glBlendEquationSeparateOES(GL_ADD, GL_FUNC_ADD_OES)),
        REFUSED(GL_INVALID_ENUM, glHint(GL_FOG, GL_NICEST)),
        REFUSED(GL_INVALID_ENUM, glHint(GL_FOG_HINT, GL_FOG)),
    };
    return kCases;
  }

  // Refused queries return zero and write nothing (2.5).
  static const std::vector<ErrorCase>& queries() {
    static const std::vector<ErrorCase> kCases = {
        REFUSED(GL_INVALID_ENUM, glGetBooleanv(0, booleans)),
        REFUSED(GL_INVALID_ENUM, glGetIntegerv(GL_TEXTURE_ENV_MODE, integers)),
        REFUSED(GL_INVALID_ENUM, glGetFixedv(GL_AMBIENT, integers)),
        REFUSED(GL_INVALID_ENUM, glGetFloatv(GL_VERTEX_ARRAY_POINTER, floats)),
        REFUSED(GL_INVALID_ENUM, EXPECT_EQ(glGetString(GL_RGBA), nullptr)),
        REFUSED(GL_INVALID_ENUM, EXPECT_FALSE(glIsEnabled(GL_CURRENT_COLOR))),
        REFUSED(GL_INVALID_ENUM, glGetPointerv(GL_VERTEX_ARRAY, &pointer)),
        REFUSED(GL_INVALID_ENUM, glGetClipPlanef(GL_CLIP_PLANE0 + 8, floats)),
        REFUSED(GL_INVALID_ENUM, glGetClipPlanex(GL_LIGHT0, integers)),
        REFUSED(GL_INVALID_ENUM, glGetLightfv(GL_LIGHT0 + 8, GL_AMBIENT, floats)),
        REFUSED(GL_INVALID_ENUM, glGetLightxv(GL_LIGHT0, GL_EMISSION, integers)),
        REFUSED(GL_INVALID_ENUM, glGetMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, floats)),
        REFUSED(GL_INVALID_ENUM, glGetMaterialxv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, integers)),
        REFUSED(GL_INVALID_ENUM, glGetTexEnvfv(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, floats)),
        REFUSED(GL_INVALID_ENUM, glGetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_WRAP_S, integers)),
        REFUSED(GL_INVALID_ENUM, glGetTexEnvxv(GL_POINT_SPRITE_OES, GL_RGB_SCALE, integers)),
        REFUSED(GL_INVALID_ENUM, glGetTexParameterfv(0, GL_TEXTURE_WRAP_S, floats)),
        REFUSED(GL_INVALID_ENUM, glGetTexParameteriv(GL_TEXTURE_2D, GL_RGB_SCALE, integers)),
        REFUSED(GL_INVALID_ENUM, glGetTexParameterxv(GL_TEXTURE_2D, 0, integers)),
        REFUSED(GL_INVALID_ENUM, glGetBufferParameteriv(0, GL_BUFFER_SIZE, integers)),
        REFUSED(GL_INVALID_ENUM, glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_RGBA, integers)),
    };
    return kCases;
  }
  static inline GLboolean booleans[1] = {7};
  static inline GLint integers[1] = {7};
  static inline GLfloat floats[1] = {7};
  static inline void* pointer = &floats;
};

TEST_F(Chapter456Errors, Fragments) { expect_refused(fragments()); }

TEST_F(Chapter456Errors, Queries) {
  expect_refused(queries());
  EXPECT_EQ(booleans[0], 7);
  EXPECT_EQ(integers[0], 7);
  EXPECT_EQ(floats[0], 7);
  EXPECT_EQ(pointer, &floats);
}

TEST_F(Chapter456Errors, ParametersOfNoBuffer) {
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  const ErrorCase kCases[] = {
      REFUSED(GL_INVALID_OPERATION,
              glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, integers)),
  };
  expect_refused(kCases);
  EXPECT_EQ(integers[0], 7);
}

// Whatever would touch a framebuffer, without one (OES_framebuffer_object, "completeness").
TEST_F(Chapter456Errors, WithoutASurface) {
  make_current(context_, {}, {});
  constexpr GLenum kError = GL_INVALID_FRAMEBUFFER_OPERATION_OES;
  const ErrorCase kCases[] = {
      REFUSED(kError, glClear(GL_COLOR_BUFFER_BIT)),
      REFUSED(kError, glDrawArrays(GL_TRIANGLES, 0, 3)),
      REFUSED(kError, glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, nullptr)),
      REFUSED(kError, glDrawTexiOES(0, 0, 0, 1, 1)),
      REFUSED(kError, read(1, 1, GL_RGBA, GL_UNSIGNED_BYTE)),
      REFUSED(kError, glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 1, 1, 0)),
      REFUSED(kError, glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 1, 1)),
  };
  expect_refused(kCases);
}

}  // namespace
}  // namespace clearpipe::api
