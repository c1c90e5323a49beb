// Debug output (KHR_debug), markers (EXT_debug_marker) and contexts without errors (KHR_no_error).
// SPDX-License-Identifier: MIT
#include <functional>
#include <string>

#include "api/call_fixture.h"
#include "api/debug.h"

namespace clearpipe::api {
namespace {

constexpr GLenum kApplication = GL_DEBUG_SOURCE_APPLICATION_KHR;
constexpr GLenum kOther = GL_DEBUG_TYPE_OTHER_KHR, kHigh = GL_DEBUG_SEVERITY_HIGH_KHR,
                 kLow = GL_DEBUG_SEVERITY_LOW_KHR;

class Debug : public CallTest {
 protected:
  struct Seen {
    GLenum source, type;
    GLuint id;
    GLenum severity;
    std::string text;
  };
  static void GL_APIENTRY callback(GLenum source, GLenum type, GLuint id, GLenum severity,
                                   GLsizei length, const char* message, const void* user) {
    auto& seen = *static_cast<std::vector<Seen>*>(const_cast<void*>(user));
    seen.push_back({source, type, id, severity, {message, static_cast<size_t>(length)}});
    glIsTexture(1);  // not allowed, and yet it must not hang
  }
  void listen() {
    glEnable(GL_DEBUG_OUTPUT_KHR);
    glDebugMessageCallbackKHR(callback, &seen_);
  }
  static void insert(GLuint id, GLenum severity, const char* text) {
    glDebugMessageInsertKHR(kApplication, kOther, id, severity, -1, text);
  }
  static GLint get(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
  }
  std::string take() {  // the oldest logged message
    char text[128] = "none";
    glGetDebugMessageLogKHR(1, sizeof text, nullptr, nullptr, nullptr, nullptr, nullptr, text);
    return text;
  }
  // With vertices in a buffer object.
  void draw_buffered() {
    glBindBuffer(GL_ARRAY_BUFFER, quad_);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, nullptr);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  GLuint quad_ = 0;
  std::vector<Seen> seen_;
};

TEST_F(Debug, AnErrorComesWithItsCallAndArguments) {
  listen();
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_LINEAR);
  glScissor(0, 0, -3, 4);
  glClearColor(0, 0, 0, 0);
  ASSERT_EQ(seen_.size(), 2u);
  EXPECT_EQ(seen_[0].source, static_cast<GLenum>(GL_DEBUG_SOURCE_API_KHR));
  EXPECT_EQ(seen_[0].type, static_cast<GLenum>(GL_DEBUG_TYPE_ERROR_KHR));
  EXPECT_EQ(seen_[0].severity, kHigh);
  EXPECT_EQ(seen_[0].id, static_cast<GLuint>(GL_INVALID_ENUM));
  EXPECT_EQ(seen_[0].text,
            "GL_INVALID_ENUM in glTexParameteri(target = GL_TEXTURE_2D, pname = GL_TEXTURE_WRAP_S, "
            "param = GL_LINEAR): param GL_LINEAR is no wrap mode (3.7.5, table 3.13)");
  EXPECT_EQ(seen_[1].text,
            "GL_INVALID_VALUE in glScissor(x = 0, y = 0, width = -3, height = 4): width -3 is "
            "negative (2.10.1, 4.1.2)");
  EXPECT_ERROR(GL_INVALID_ENUM);
}

// Every way an argument is written: enumerants with and without a name, bits, fixed-point numbers,
// vectors, and several in one rule.
TEST_F(Debug, ArgumentsAreNamedAsTheCallNamesThem) {
  listen();
  const GLfloat spot[4] = {-1};
  glBlendFunc(0x1234, GL_ONE);
  glDisable(GL_QUADRATIC_ATTENUATION);
  glClear(0x10001);
  glPointSizex(-0x8000);
  glLightfv(GL_LIGHT1, GL_SPOT_EXPONENT, spot);
  glLightModelx(GL_LIGHT_MODEL_AMBIENT, 1);
  glBlendEquationOES(GL_ADD);
  glOrthof(-1, 1, 2, 2, 0, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, -2, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glColorPointer(4, GL_BYTE, 0, spot);
  glPopMatrix();
  const char* const kTexts[] = {
      "GL_INVALID_ENUM in glBlendFunc(sfactor = 0x1234, dfactor = 1): sfactor 0x1234 is no factor "
      "of the source (4.1.7, table 4.1)",
      "GL_INVALID_ENUM in glDisable(cap = GL_QUADRATIC_ATTENUATION): cap GL_QUADRATIC_ATTENUATION "
      "is nothing that is enabled with Enable (6.2)",
      "GL_INVALID_VALUE in glClear(mask = 0x10001): mask 0x10001 has bits other than those of the "
      "colour, depth and stencil buffers (4.2.3)",
      "GL_INVALID_VALUE in glPointSizex(size = -0.5): size -0.5 is not positive (3.3, 3.4)",
      "GL_INVALID_VALUE in glLightfv(light = GL_LIGHT1, pname = GL_SPOT_EXPONENT, params): params "
      "-1 is not in [0, 128] (2.12.1, table 2.8)",
      "GL_INVALID_ENUM in glLightModelx(pname = GL_LIGHT_MODEL_AMBIENT, param = 1.52588e-05): "
      "pname GL_LIGHT_MODEL_AMBIENT takes a vector: set it with a form of the call in v (2.3)",
      "GL_INVALID_ENUM in glBlendEquationOES(mode = GL_ADD): mode GL_ADD is no blend equation "
      "(OES_blend_subtract, EXT_blend_minmax)",
      "GL_INVALID_VALUE in glOrthof(l = -1, r = 1, b = 2, t = 2, n = 0, f = 1): b 2 and t 2 are "
      "equal (2.10.2)",
      "GL_INVALID_VALUE in glTexImage2D(target = GL_TEXTURE_2D, level = 0, internalformat = "
      "GL_RGBA, "
      "width = 1, height = -2, border = 0, format = GL_RGBA, type = GL_UNSIGNED_BYTE, pixels = "
      "null): width 1 or height -2 is negative, or larger than MAX_TEXTURE_SIZE allows at this "
      "level (3.7.1)",
      "GL_INVALID_ENUM in glColorPointer(size = 4, type = GL_BYTE, stride = 0, pointer): type "
      "GL_BYTE is no type of this array (2.8, table 2.4)",
      "GL_STACK_UNDERFLOW in glPopMatrix(): the stack of MATRIX_MODE has one entry only (2.10.2)",
  };
  ASSERT_EQ(seen_.size(), std::size(kTexts));
  for (size_t i = 0; i < std::size(kTexts); ++i) EXPECT_EQ(seen_[i].text, kTexts[i]);
}

TEST_F(Debug, NothingIsSaidWhileDisabled) {
  glDebugMessageCallbackKHR(callback, &seen_);
  EXPECT_FALSE(glIsEnabled(GL_DEBUG_OUTPUT_KHR));
  glScissor(0, 0, -3, 4);
  insert(1, kHigh, "lost");
  EXPECT_TRUE(seen_.empty());
  EXPECT_ERROR(GL_INVALID_VALUE);
  Context* debugged = create_context(nullptr, {true, false});
  make_current(debugged, target_, target_);
  EXPECT_TRUE(glIsEnabled(GL_DEBUG_OUTPUT_KHR));
  make_current(context_, target_, target_);
  destroy_context(debugged);
}

// What is slow says so, with its reason; the same calls are silent where they cost nothing.
TEST_F(Debug, SlowCallsSaySo) {
  glDebugMessageCallbackKHR(callback, &seen_);
  glEnable(GL_DEBUG_OUTPUT_KHR);
  glDebugMessageControlKHR(GL_DONT_CARE, GL_DEBUG_TYPE_PERFORMANCE_KHR, GL_DONT_CARE, 0, nullptr,
                           GL_TRUE);
  const auto expect_slow = [this](Slow why, const char* call, const std::function<void()>& slow) {
    glFinish();
    seen_.clear();
    slow();  // nothing is recorded that it could wait for
    EXPECT_TRUE(seen_.empty()) << call << ": " << seen_[0].text;
    glClear(GL_COLOR_BUFFER_BIT);
    draw_buffered();
    seen_.clear();
    slow();
    ASSERT_EQ(seen_.size(), 1u) << call;
    EXPECT_EQ(seen_[0].type, static_cast<GLenum>(GL_DEBUG_TYPE_PERFORMANCE_KHR));
    EXPECT_EQ(seen_[0].id, static_cast<GLuint>(why)) << call;
    EXPECT_EQ(seen_[0].text.find(std::string(call) + ": "), 0u) << seen_[0].text;
  };
  glGenBuffers(1, &quad_);
  glBindBuffer(GL_ARRAY_BUFFER, quad_);
  static const float kQuad[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  glBufferData(GL_ARRAY_BUFFER, sizeof kQuad, kQuad, GL_STATIC_DRAW);
  one_colour_texture(kRed, 4);
  uint32_t texel = kGreen;
  expect_slow(Slow::kWaits, "glReadPixels",
              [&] { glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &texel); });
  expect_slow(Slow::kWaits, "glFlush", [] { glFlush(); });
  expect_slow(Slow::kWaits, "glCopyTexImage2D",
              [] { glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0); });
  expect_slow(Slow::kWaits, "glCopyTexSubImage2D",
              [] { glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 1, 1); });
  const auto change = [&] {
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &texel);
  };
  expect_slow(Slow::kCopies, "glTexSubImage2D", change);
  expect_slow(Slow::kCopies, "glBufferSubData",
              [] { glBufferSubData(GL_ARRAY_BUFFER, 0, 4, kQuad); });
  expect_slow(Slow::kCopies, "glMapBufferOES", [] {
    glMapBufferOES(GL_ARRAY_BUFFER, GL_WRITE_ONLY_OES);
    glUnmapBufferOES(GL_ARRAY_BUFFER);
  });
  fill_texture(kRed, 512);
  expect_slow(Slow::kFinishes, "glTexSubImage2D", change);
  expect_slow(Slow::kChangesTarget, "glBindFramebufferOES",
              [] { glBindFramebufferOES(GL_FRAMEBUFFER_OES, 0); });

  GLint texture = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, 1);
  glFramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D,
                            static_cast<GLuint>(texture), 0);
  seen_.clear();
  draw_buffered();
  ASSERT_EQ(seen_.size(), 1u);
  EXPECT_EQ(seen_[0].id, static_cast<GLuint>(Slow::kSamplesTarget));
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  seen_.clear();
  draw_quad();
  ASSERT_EQ(seen_.size(), 1u);
  EXPECT_EQ(seen_[0].id, static_cast<GLuint>(Slow::kClientArrays));
  EXPECT_EQ(seen_[0].text.find("glDrawArrays: "), 0u);
}

TEST_F(Debug, WithoutACallbackMessagesAreLogged) {
  glEnable(GL_DEBUG_OUTPUT_KHR);
  insert(1, kHigh, "first");
  glDebugMessageInsertKHR(kApplication, kOther, 2, kHigh, 3, "second");
  EXPECT_EQ(get(GL_DEBUG_LOGGED_MESSAGES_KHR), 2);
  EXPECT_EQ(get(GL_DEBUG_NEXT_LOGGED_MESSAGE_LENGTH_KHR), 6);
  GLenum sources[3], types[3], severities[3];
  GLuint ids[3];
  GLsizei lengths[3];
  char text[16];
  EXPECT_EQ(glGetDebugMessageLogKHR(3, 9, sources, types, ids, severities, lengths, text), 1u);
  EXPECT_STREQ(text, "first");
  EXPECT_EQ(lengths[0], 6);
  EXPECT_EQ(ids[0], 1u);
  EXPECT_EQ(sources[0], kApplication);
  EXPECT_EQ(take(), "sec");
  EXPECT_EQ(get(GL_DEBUG_LOGGED_MESSAGES_KHR), 0);
  for (GLuint i = 0; i < 200; ++i) insert(i, kHigh, "many");
  EXPECT_EQ(get(GL_DEBUG_LOGGED_MESSAGES_KHR), get(GL_MAX_DEBUG_LOGGED_MESSAGES_KHR));
  EXPECT_EQ(glGetDebugMessageLogKHR(500, 0, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr),
            static_cast<GLuint>(get(GL_MAX_DEBUG_LOGGED_MESSAGES_KHR)));
  glGetDebugMessageLogKHR(1, -1, nullptr, nullptr, nullptr, nullptr, nullptr, text);
  EXPECT_ERROR(GL_INVALID_VALUE);
}

TEST_F(Debug, MessagesAreControlled) {
  listen();
  insert(1, kLow, "not at first");
  glDebugMessageControlKHR(GL_DONT_CARE, GL_DONT_CARE, kLow, 0, nullptr, GL_TRUE);
  insert(1, kLow, "low");
  const GLuint ids[] = {7, 8};
  glDebugMessageControlKHR(kApplication, kOther, GL_DONT_CARE, 2, ids, GL_FALSE);
  insert(7, kHigh, "disabled");
  insert(9, kHigh, "high");
  glDebugMessageControlKHR(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  insert(9, kHigh, "disabled");
  ASSERT_EQ(seen_.size(), 2u);
  EXPECT_EQ(seen_[0].text, "low");
  EXPECT_EQ(seen_[1].text, "high");
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(Debug, GroupsNestAndRestoreControl) {
  listen();
  glPushDebugGroupKHR(kApplication, 5, -1, "shadow pass");
  glDebugMessageControlKHR(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  insert(1, kHigh, "disabled");
  EXPECT_EQ(get(GL_DEBUG_GROUP_STACK_DEPTH_KHR), 2);
  glPopDebugGroupKHR();
  insert(1, kHigh, "enabled");
  ASSERT_EQ(seen_.size(), 3u);
  EXPECT_EQ(seen_[0].type, static_cast<GLenum>(GL_DEBUG_TYPE_PUSH_GROUP_KHR));
  EXPECT_EQ(seen_[1].type, static_cast<GLenum>(GL_DEBUG_TYPE_POP_GROUP_KHR));
  EXPECT_EQ(seen_[1].text, "shadow pass");
  EXPECT_EQ(seen_[1].id, 5u);
  glPopDebugGroupKHR();
  EXPECT_ERROR(GL_STACK_UNDERFLOW);
  for (GLint i = 1; i < get(GL_MAX_DEBUG_GROUP_STACK_DEPTH_KHR); ++i) {
    glPushDebugGroupKHR(kApplication, 0, 1, "g");
  }
  EXPECT_ERROR(GL_NO_ERROR);
  glPushDebugGroupKHR(kApplication, 0, 1, "g");
  EXPECT_ERROR(GL_STACK_OVERFLOW);
}

TEST_F(Debug, Errors) {
  glEnable(GL_DEBUG_OUTPUT_KHR);
  glDebugMessageInsertKHR(GL_DEBUG_SOURCE_API_KHR, kOther, 0, kHigh, 1, "x");
  EXPECT_ERROR(GL_INVALID_ENUM);
  glDebugMessageInsertKHR(kApplication, GL_DEBUG_TYPE_PUSH_GROUP_KHR, 0, kHigh, 1, "x");
  EXPECT_ERROR(GL_INVALID_ENUM);
  glDebugMessageInsertKHR(kApplication, kOther, 0, 0, 1, "x");
  EXPECT_ERROR(GL_INVALID_ENUM);
  const std::string longest(4095, 'x'), too_long(4096, 'x');
  insert(0, kHigh, longest.c_str());
  EXPECT_ERROR(GL_NO_ERROR);
  insert(0, kHigh, too_long.c_str());
  EXPECT_ERROR(GL_INVALID_VALUE);
  glPushDebugGroupKHR(GL_DEBUG_SOURCE_API_KHR, 0, 1, "x");
  EXPECT_ERROR(GL_INVALID_ENUM);
  glPushDebugGroupKHR(kApplication, 0, -1, too_long.c_str());
  EXPECT_ERROR(GL_INVALID_VALUE);
  const GLuint id = 1;
  glDebugMessageControlKHR(0, kOther, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glDebugMessageControlKHR(GL_DONT_CARE, kOther, GL_DONT_CARE, 1, &id, GL_TRUE);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  glDebugMessageControlKHR(kApplication, kOther, kHigh, 1, &id, GL_TRUE);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  glDebugMessageControlKHR(kApplication, kOther, GL_DONT_CARE, -1, &id, GL_TRUE);
  EXPECT_ERROR(GL_INVALID_VALUE);
  glObjectPtrLabelKHR(&id, 1, "x");
  EXPECT_ERROR(GL_INVALID_VALUE);
}

TEST_F(Debug, ObjectsHaveLabels) {
  const GLuint texture = one_colour_texture(kRed);
  GLuint array = 0;
  glGenVertexArraysOES(1, &array);
  glBindVertexArrayOES(array);
  glBindBuffer(GL_ARRAY_BUFFER, 3);
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, 4);
  glBindRenderbufferOES(GL_RENDERBUFFER_OES, 5);
  const std::pair<GLenum, GLuint> objects[] = {{GL_TEXTURE, texture},
                                               {GL_VERTEX_ARRAY_KHR, array},
                                               {GL_BUFFER_KHR, 3},
                                               {GL_FRAMEBUFFER_OES, 4},
                                               {GL_RENDERBUFFER_OES, 5}};
  for (const auto& [kind, name] : objects) {
    char text[16] = "?";
    GLsizei length = -1;
    glGetObjectLabelKHR(kind, name, sizeof text, &length, text);
    EXPECT_STREQ(text, "");
    glObjectLabelKHR(kind, name, -1, "sky dome");
    glGetObjectLabelKHR(kind, name, 4, &length, text);
    EXPECT_STREQ(text, "sky");
    EXPECT_EQ(length, 3);
    glGetObjectLabelKHR(kind, name, 0, &length, nullptr);
    EXPECT_EQ(length, 8);
    glObjectLabelKHR(kind, name, 0, nullptr);
    glGetObjectLabelKHR(kind, name, 4, &length, text);
    EXPECT_EQ(length, 0);
    EXPECT_ERROR(GL_NO_ERROR);
    glObjectLabelKHR(kind, name + 100, -1, "x");
    EXPECT_ERROR(GL_INVALID_VALUE);
    glObjectLabelKHR(kind, name, -1, std::string(256, 'x').c_str());
    EXPECT_ERROR(GL_INVALID_VALUE);
  }
  glObjectLabelKHR(GL_TEXTURE_2D, texture, -1, "x");
  EXPECT_ERROR(GL_INVALID_ENUM);
  glObjectLabelKHR(GL_SHADER_KHR, 1, -1, "x");
  EXPECT_ERROR(GL_INVALID_VALUE);
}

// EXT_debug_label: the same labels under the extension's own types.
TEST_F(Debug, LabelsOfTheExtension) {
  const GLuint texture = one_colour_texture(kRed);
  glBindBuffer(GL_ARRAY_BUFFER, 3);
  char text[16] = "?";
  GLsizei length = -1;
  glGetObjectLabelEXT(GL_TEXTURE, texture, sizeof text, &length, text);
  EXPECT_STREQ(text, "");
  EXPECT_EQ(length, 0);
  glLabelObjectEXT(GL_TEXTURE, texture, 0, "sky dome");  // zero: up to the null
  glGetObjectLabelKHR(GL_TEXTURE, texture, sizeof text, &length, text);
  EXPECT_STREQ(text, "sky dome");
  glLabelObjectEXT(GL_BUFFER_OBJECT_EXT, 3, 3, "seabed");
  glGetObjectLabelEXT(GL_BUFFER_OBJECT_EXT, 3, sizeof text, nullptr, text);
  EXPECT_STREQ(text, "sea");
  glGetObjectLabelEXT(GL_TEXTURE, texture, 4, &length, text);
  EXPECT_STREQ(text, "sky");
  EXPECT_EQ(length, 3);
  glGetObjectLabelEXT(GL_TEXTURE, texture, 0, &length, nullptr);
  EXPECT_EQ(length, 8);
  glLabelObjectEXT(GL_TEXTURE, texture, 5, nullptr);
  glGetObjectLabelEXT(GL_TEXTURE, texture, sizeof text, &length, text);
  EXPECT_EQ(length, 0);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(Debug, Pointers) {
  listen();
  void* pointer = nullptr;
  glGetPointervKHR(GL_DEBUG_CALLBACK_FUNCTION_KHR, &pointer);
  EXPECT_EQ(pointer, reinterpret_cast<void*>(&callback));
  glGetPointerv(GL_DEBUG_CALLBACK_USER_PARAM_KHR, &pointer);
  EXPECT_EQ(pointer, &seen_);
}

TEST_F(Debug, MarkersAreMessages) {
  listen();
  glPushGroupMarkerEXT(0, "frame");
  glInsertEventMarkerEXT(3, "skyline");
  glPopGroupMarkerEXT();
  glPopGroupMarkerEXT();  // none to pop: ignored
  ASSERT_EQ(seen_.size(), 3u);
  EXPECT_EQ(seen_[0].text, "frame");
  EXPECT_EQ(seen_[1].text, "sky");
  EXPECT_EQ(seen_[1].type, static_cast<GLenum>(GL_DEBUG_TYPE_MARKER_KHR));
  EXPECT_EQ(seen_[2].text, "frame");
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(Debug, ACallbackThatCausesErrorsEnds) {
  static int calls;
  calls = 0;
  glEnable(GL_DEBUG_OUTPUT_KHR);
  glDebugMessageCallbackKHR([](GLenum, GLenum, GLuint, GLenum, GLsizei, const char*,
                               const void*) { ++calls, glScissor(0, 0, -1, -1); },
                            nullptr);
  glScissor(0, 0, -1, -1);
  glScissor(0, 0, -1, -1);
  EXPECT_EQ(calls, 2);
}

// Nothing is reported, and what is wrong still does nothing.
TEST_F(Debug, ContextsWithoutErrors) {
  Context* quiet = create_context(nullptr, {false, true});
  make_current(quiet, target_, target_);
  glScissor(1, 1, -3, 4);
  EXPECT_ERROR(GL_NO_ERROR);
  GLint box[4] = {};
  glGetIntegerv(GL_SCISSOR_BOX, box);
  EXPECT_EQ(box[2], kSize);
  make_current(context_, target_, target_);
  destroy_context(quiet);
}

}  // namespace
}  // namespace clearpipe::api
