// Contexts: creation, sharing, binding and queries (3.7).
// SPDX-License-Identifier: MIT
#include "icd/egl_test.h"

namespace clearpipe::icd {
namespace {

class ContextTest : public EglTest {
 protected:
  void expect_refused(const std::vector<EGLint>& attributes, EGLint error,
                      EGLContext share = EGL_NO_CONTEXT) {
    EXPECT_EGL_FAIL(context_with(attributes, share), EGL_NO_CONTEXT, error);
  }
  void expect_created(const std::vector<EGLint>& attributes, EGLContext share = EGL_NO_CONTEXT) {
    const EGLContext ctx = context_with(attributes, share);
    EXPECT_NE(ctx, EGL_NO_CONTEXT);
    EXPECT_EQ(eglGetError(), EGL_SUCCESS);
    EXPECT_EGL_OK(eglDestroyContext(display, ctx));
  }
};

TEST_F(ContextTest, BindApi) {
  EXPECT_EQ(eglQueryAPI(), static_cast<EGLenum>(EGL_OPENGL_ES_API));
  EXPECT_EGL_OK(eglBindAPI(EGL_OPENGL_ES_API));
  EXPECT_EGL_FAIL(eglBindAPI(EGL_OPENGL_API), EGL_FALSE, EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(eglBindAPI(EGL_OPENVG_API), EGL_FALSE, EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(eglBindAPI(EGL_NONE), EGL_FALSE, EGL_BAD_PARAMETER);
  EXPECT_EQ(eglQueryAPI(), static_cast<EGLenum>(EGL_OPENGL_ES_API));
}

// 3.7.1.1: the versions there are; of these only OpenGL ES 1.x is here.
TEST_F(ContextTest, Versions) {
  expect_created({});
  expect_created({EGL_CONTEXT_CLIENT_VERSION, 1});
  expect_created({EGL_CONTEXT_MAJOR_VERSION, 1, EGL_CONTEXT_MINOR_VERSION, 0});
  expect_created({EGL_CONTEXT_MAJOR_VERSION, 1, EGL_CONTEXT_MINOR_VERSION, 1});
  expect_refused({EGL_CONTEXT_MAJOR_VERSION, 1, EGL_CONTEXT_MINOR_VERSION, 2}, EGL_BAD_MATCH);
  for (const EGLint major : {-1, 0, 2, 3, 99}) {
    expect_refused({EGL_CONTEXT_MAJOR_VERSION, major}, EGL_BAD_MATCH);
  }
  expect_refused({EGL_CONTEXT_MAJOR_VERSION, 1, EGL_CONTEXT_MINOR_VERSION, -1}, EGL_BAD_MATCH);
}

TEST_F(ContextTest, Attributes) {
  expect_created({EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});  // 3.7.1.3: never a reason to fail
  expect_created({EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR});
  expect_created({EGL_CONTEXT_OPENGL_NO_ERROR_KHR, EGL_TRUE});
  expect_created({EGL_CONTEXT_RELEASE_BEHAVIOR_KHR, EGL_CONTEXT_RELEASE_BEHAVIOR_NONE_KHR});
  expect_created({EGL_CONTEXT_RELEASE_BEHAVIOR_KHR, EGL_CONTEXT_RELEASE_BEHAVIOR_FLUSH_KHR});
  expect_created({EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_FALSE});
  expect_created({EGL_CONTEXT_OPENGL_ROBUST_ACCESS_EXT, EGL_FALSE});
  expect_created({EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
  expect_created({EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_TRUE});
  expect_created({EGL_CONTEXT_OPENGL_ROBUST_ACCESS_EXT, EGL_TRUE});
  expect_refused(
      {EGL_CONTEXT_OPENGL_NO_ERROR_KHR, EGL_TRUE, EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_TRUE},
      EGL_BAD_MATCH);
  expect_refused({EGL_CONTEXT_OPENGL_NO_ERROR_KHR, EGL_TRUE, EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE},
                 EGL_BAD_MATCH);
  expect_refused({EGL_CONTEXT_OPENGL_DEBUG, 2}, EGL_BAD_ATTRIBUTE);
  expect_refused({EGL_CONTEXT_OPENGL_NO_ERROR_KHR, 2}, EGL_BAD_ATTRIBUTE);
  expect_refused({EGL_CONTEXT_OPENGL_ROBUST_ACCESS, 2}, EGL_BAD_ATTRIBUTE);
  expect_refused({EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_TRUE}, EGL_BAD_ATTRIBUTE);
  expect_refused({EGL_CONTEXT_RELEASE_BEHAVIOR_KHR, 1}, EGL_BAD_ATTRIBUTE);
  expect_refused({EGL_CONTEXT_FLAGS_KHR, 2}, EGL_BAD_ATTRIBUTE);
  expect_refused({EGL_CONTEXT_OPENGL_PROFILE_MASK, 1}, EGL_BAD_ATTRIBUTE);
  expect_refused({EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE, EGL_TRUE}, EGL_BAD_ATTRIBUTE);
  expect_refused({EGL_WIDTH, 1}, EGL_BAD_ATTRIBUTE);
}

// What the attributes ask for reaches the context (KHR_debug, KHR_no_error).
TEST_F(ContextTest, FlagsReachTheContext) {
  constexpr GLenum kDebugOutput = 0x92e0;  // GL_DEBUG_OUTPUT_KHR
  const auto error_after_a_mistake = [&](const std::vector<EGLint>& attributes, bool debug) {
    EXPECT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_with(attributes)));
    EXPECT_EQ(glIsEnabled(kDebugOutput), debug ? GL_TRUE : GL_FALSE);
    glMatrixMode(GL_RGBA);
    return glGetError();
  };
  EXPECT_EQ(error_after_a_mistake({}, false), static_cast<GLenum>(GL_INVALID_ENUM));
  EXPECT_EQ(error_after_a_mistake({EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE}, true),
            static_cast<GLenum>(GL_INVALID_ENUM));
  EXPECT_EQ(error_after_a_mistake({EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR}, true),
            static_cast<GLenum>(GL_INVALID_ENUM));
  EXPECT_EQ(error_after_a_mistake({EGL_CONTEXT_OPENGL_NO_ERROR_KHR, EGL_TRUE}, false),
            static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(ContextTest, CreateAndDestroyErrors) {
  EXPECT_EGL_FAIL(eglCreateContext(display, random_handle(), EGL_NO_CONTEXT, nullptr),
                  EGL_NO_CONTEXT, EGL_BAD_CONFIG);
  EXPECT_EGL_FAIL(eglCreateContext(display, config, random_handle(), nullptr), EGL_NO_CONTEXT,
                  EGL_BAD_CONTEXT);
  EXPECT_EGL_FAIL(eglDestroyContext(display, EGL_NO_CONTEXT), EGL_FALSE, EGL_BAD_CONTEXT);
  EXPECT_EGL_FAIL(eglDestroyContext(display, random_handle()), EGL_FALSE, EGL_BAD_CONTEXT);
  const EGLContext ctx = context();
  EXPECT_EGL_OK(eglDestroyContext(display, ctx));
  EXPECT_EGL_FAIL(eglDestroyContext(display, ctx), EGL_FALSE, EGL_BAD_CONTEXT);
  EXPECT_EGL_FAIL(eglCreateContext(display, config, ctx, nullptr), EGL_NO_CONTEXT, EGL_BAD_CONTEXT);
  // A surface is no context, nor the other way round.
  const EGLSurface surface = pbuffer(4, 4);
  EXPECT_EGL_FAIL(eglDestroyContext(display, surface), EGL_FALSE, EGL_BAD_CONTEXT);
  EXPECT_EGL_FAIL(eglDestroySurface(display, context()), EGL_FALSE, EGL_BAD_SURFACE);
}

TEST_F(ContextTest, Query) {
  const EGLContext ctx = context();
  EGLint value = 0, id = 0;
  ASSERT_TRUE(eglGetConfigAttrib(display, config, EGL_CONFIG_ID, &id));
  EXPECT_EGL_OK(eglQueryContext(display, ctx, EGL_CONFIG_ID, &value));
  EXPECT_EQ(value, id);
  EXPECT_EGL_OK(eglQueryContext(display, ctx, EGL_CONTEXT_CLIENT_TYPE, &value));
  EXPECT_EQ(value, EGL_OPENGL_ES_API);
  EXPECT_EGL_OK(eglQueryContext(display, ctx, EGL_CONTEXT_CLIENT_VERSION, &value));
  EXPECT_EQ(value, 1);
  EXPECT_EGL_OK(eglQueryContext(display, ctx, EGL_RENDER_BUFFER, &value));
  EXPECT_EQ(value, EGL_NONE);
  const EGLSurface surface = pbuffer(4, 4);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
  EXPECT_EGL_OK(eglQueryContext(display, ctx, EGL_RENDER_BUFFER, &value));
  EXPECT_EQ(value, EGL_BACK_BUFFER);
  value = 77;
  EXPECT_EGL_FAIL(eglQueryContext(display, random_handle(), EGL_CONFIG_ID, &value), EGL_FALSE,
                  EGL_BAD_CONTEXT);
  EXPECT_EGL_FAIL(eglQueryContext(display, EGL_NO_CONTEXT, EGL_CONFIG_ID, &value), EGL_FALSE,
                  EGL_BAD_CONTEXT);
  EXPECT_EGL_FAIL(eglQueryContext(display, ctx, EGL_WIDTH, &value), EGL_FALSE, EGL_BAD_ATTRIBUTE);
  EXPECT_EGL_FAIL(eglQueryContext(display, ctx, EGL_CONFIG_ID, nullptr), EGL_FALSE,
                  EGL_BAD_PARAMETER);
  EXPECT_EQ(value, 77);
}

TEST_F(ContextTest, CurrentObjects) {
  EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
  EXPECT_EQ(eglGetCurrentDisplay(), EGL_NO_DISPLAY);
  EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), EGL_NO_SURFACE);
  const EGLSurface draw = pbuffer(4, 4), read = pbuffer(4, 4);
  const EGLContext ctx = context();
  ASSERT_TRUE(eglMakeCurrent(display, draw, read, ctx));
  EXPECT_EQ(eglGetCurrentContext(), ctx);
  EXPECT_EQ(eglGetCurrentDisplay(), display);
  EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), draw);
  EXPECT_EQ(eglGetCurrentSurface(EGL_READ), read);
  EXPECT_EGL_FAIL(eglGetCurrentSurface(EGL_WIDTH), EGL_NO_SURFACE, EGL_BAD_PARAMETER);
}

// Each error of 3.7.3 leaves what was current current.
TEST_F(ContextTest, MakeCurrentErrors) {
  const EGLSurface surface = pbuffer(4, 4), old = pbuffer(4, 4);
  const EGLContext ctx = context(), current = context();
  ASSERT_TRUE(eglMakeCurrent(display, old, old, current));
  const auto expect = [&](EGLSurface draw, EGLSurface read, EGLContext with, EGLint error) {
    EXPECT_EGL_FAIL(eglMakeCurrent(display, draw, read, with), EGL_FALSE, error);
    EXPECT_EQ(eglGetCurrentContext(), current);
    EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), old);
  };
  expect(surface, surface, random_handle(), EGL_BAD_CONTEXT);
  expect(random_handle(), random_handle(), ctx, EGL_BAD_SURFACE);
  expect(surface, random_handle(), ctx, EGL_BAD_SURFACE);
  expect(random_handle(), surface, ctx, EGL_BAD_SURFACE);
  expect(surface, EGL_NO_SURFACE, ctx, EGL_BAD_MATCH);
  expect(EGL_NO_SURFACE, surface, ctx, EGL_BAD_MATCH);
  expect(surface, surface, EGL_NO_CONTEXT, EGL_BAD_MATCH);
  expect(EGL_NO_SURFACE, surface, EGL_NO_CONTEXT, EGL_BAD_MATCH);
  const EGLSurface gone = pbuffer(4, 4);
  ASSERT_TRUE(eglDestroySurface(display, gone));
  expect(gone, gone, ctx, EGL_BAD_SURFACE);
  const EGLContext dead = context();
  ASSERT_TRUE(eglDestroyContext(display, dead));
  expect(surface, surface, dead, EGL_BAD_CONTEXT);
}

TEST_F(ContextTest, MismatchedConfigs) {
  const EGLContext ctx = context();
  const EGLSurface fits = pbuffer(4, 4);
  for (const auto& other : {choose({EGL_ALPHA_SIZE, 8}), choose({EGL_DEPTH_SIZE, 24}),
                            choose({EGL_STENCIL_SIZE, 8}), choose({})}) {
    ASSERT_NE(other, config);
    const EGLSurface surface = pbuffer(other, 4, 4);
    EXPECT_EGL_FAIL(eglMakeCurrent(display, surface, surface, ctx), EGL_FALSE, EGL_BAD_MATCH);
    EXPECT_EGL_FAIL(eglMakeCurrent(display, fits, surface, ctx), EGL_FALSE, EGL_BAD_MATCH);
    EXPECT_EGL_FAIL(eglMakeCurrent(display, surface, fits, ctx), EGL_FALSE, EGL_BAD_MATCH);
    // EGL_KHR_no_config_context: without a config it fits any surface.
    const EGLContext any = eglCreateContext(display, nullptr, EGL_NO_CONTEXT, nullptr);
    EGLint id = -1;
    EXPECT_EGL_OK(eglQueryContext(display, any, EGL_CONFIG_ID, &id));
    EXPECT_EQ(id, 0);
    EXPECT_EGL_OK(eglMakeCurrent(display, surface, surface, any));
    EXPECT_EQ(clear_and_read(0, 0, 1, 1), 0xffff0000u);
    EXPECT_EGL_OK(eglMakeCurrent(display, fits, fits, any));
    EXPECT_EQ(clear_and_read(0, 1, 1, 1), 0xffffff00u);
    EXPECT_EGL_OK(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  }
}

// EGL_KHR_surfaceless_context; GL_OES_surfaceless_context says what drawing does.
TEST_F(ContextTest, WithoutSurfaces) {
  const EGLContext ctx = context();
  EXPECT_EGL_OK(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, ctx));
  EXPECT_EQ(eglGetCurrentContext(), ctx);
  EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), EGL_NO_SURFACE);
  EXPECT_EQ(eglGetCurrentSurface(EGL_READ), EGL_NO_SURFACE);
  GLint box[4] = {1, 1, 1, 1};
  glGetIntegerv(GL_VIEWPORT, box);
  EXPECT_EQ(box[2], 0);
  EXPECT_EQ(box[3], 0);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(glGetError(), 0x0506u);  // GL_INVALID_FRAMEBUFFER_OPERATION_OES
  EXPECT_EGL_OK(eglWaitClient());
  const EGLSurface surface = pbuffer(4, 4);
  EXPECT_EGL_OK(eglMakeCurrent(display, surface, surface, ctx));
  glScissor(0, 0, 4, 4);
  EXPECT_EQ(clear_and_read(1, 1, 1, 1, 3, 3), 0xffffffffu);
}

TEST_F(ContextTest, DestroyWhileCurrent) {
  const EGLSurface surface = pbuffer(4, 4);
  const EGLContext ctx = context();
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
  EXPECT_EGL_OK(eglDestroyContext(display, ctx));
  EXPECT_EQ(eglGetCurrentContext(), ctx);
  EXPECT_EQ(clear_and_read(1, 0, 0, 1), 0xff0000ffu);
  EXPECT_EGL_FAIL(eglDestroyContext(display, ctx), EGL_FALSE, EGL_BAD_CONTEXT);
  EXPECT_EGL_OK(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  EXPECT_EGL_FAIL(eglMakeCurrent(display, surface, surface, ctx), EGL_FALSE, EGL_BAD_CONTEXT);
}

// The pixels belong to the surface, whichever context draws; the state belongs to the context.
TEST_F(ContextTest, TwoContextsOnOneSurface) {
  const EGLSurface surface = pbuffer(4, 4);
  const EGLContext first = context(), second = context();
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, first));
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, second));
  uint32_t pixel = 0;
  glReadPixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
  EXPECT_EQ(pixel, 0xff00ff00u);
  GLfloat colour[4] = {};
  glGetFloatv(GL_COLOR_CLEAR_VALUE, colour);
  EXPECT_EQ(colour[1], 0.0f);
}

TEST_F(ContextTest, ShareGroups) {
  const EGLSurface surface = pbuffer(4, 4);
  const EGLContext first = context(), second = context(first), third = context(second);
  const EGLContext stranger = context();
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, first));
  GLuint texture = 0, buffer = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  const uint32_t texels[4] = {0xff0000ff, 0xff0000ff, 0xff0000ff, 0xff0000ff};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glTexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glGenBuffers(1, &buffer);
  const GLfloat corners[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
  EXPECT_EGL_OK(eglDestroyContext(display, first));  // the objects stay with the others

  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, stranger));
  EXPECT_FALSE(glIsTexture(texture));
  EXPECT_FALSE(glIsBuffer(buffer));
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, third));
  EXPECT_TRUE(glIsTexture(texture));
  EXPECT_TRUE(glIsBuffer(buffer));
  glEnable(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, texture);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  uint32_t pixel = 0;
  glReadPixels(2, 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
  EXPECT_EQ(pixel, 0xff0000ffu);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// What was asked for can be asked of the context (GL_EXT_robustness).
TEST_F(ContextTest, Robustness) {
  const EGLSurface surface = pbuffer(4, 4);
  const auto state = [&](const std::vector<EGLint>& attributes) {
    EXPECT_TRUE(eglMakeCurrent(display, surface, surface, context_with(attributes)));
    std::array<GLint, 2> values{-1, -1};
    glGetIntegerv(GL_CONTEXT_ROBUST_ACCESS_EXT, &values[0]);
    glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY_EXT, &values[1]);
    return values;
  };
  using Values = std::array<GLint, 2>;
  EXPECT_EQ(state({}), (Values{0, GL_NO_RESET_NOTIFICATION_EXT}));
  EXPECT_EQ(state({EGL_CONTEXT_OPENGL_ROBUST_ACCESS_EXT, EGL_TRUE}),
            (Values{1, GL_NO_RESET_NOTIFICATION_EXT}));
  EXPECT_EQ(
      state({EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT, EGL_LOSE_CONTEXT_ON_RESET_EXT}),
      (Values{0, GL_LOSE_CONTEXT_ON_RESET_EXT}));
}

// 3.7.1: contexts whose errors or resets are treated differently do not share.
TEST_F(ContextTest, SharersMustAgree) {
  const EGLContext plain = context();
  const std::vector<EGLint> no_error = {EGL_CONTEXT_OPENGL_NO_ERROR_KHR, EGL_TRUE};
  const std::vector<EGLint> lose = {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                                    EGL_LOSE_CONTEXT_ON_RESET};
  expect_refused(no_error, EGL_BAD_MATCH, plain);
  expect_refused(lose, EGL_BAD_MATCH, plain);
  expect_refused({}, EGL_BAD_MATCH, context_with(no_error));
  expect_created(no_error, context_with(no_error));
  expect_created(lose, context_with(lose));
}

TEST_F(ContextTest, Waiting) {
  EXPECT_EGL_OK(eglWaitClient());
  EXPECT_EGL_OK(eglWaitGL());
  EXPECT_EGL_OK(eglWaitNative(EGL_CORE_NATIVE_ENGINE));
  const EGLSurface surface = pbuffer(4, 4);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
  EXPECT_EGL_OK(eglWaitClient());
  EXPECT_EGL_OK(eglWaitGL());
  EXPECT_EGL_OK(eglWaitNative(EGL_CORE_NATIVE_ENGINE));
  EXPECT_EGL_FAIL(eglWaitNative(EGL_NONE), EGL_FALSE, EGL_BAD_PARAMETER);
}

}  // namespace
}  // namespace clearpipe::icd
