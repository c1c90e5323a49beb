// Debug output (EGL_KHR_debug), and what EGL_MESA_query_driver tells.
// SPDX-License-Identifier: MIT
#include <thread>

#include "icd/egl_test.h"

namespace clearpipe::icd {
namespace {

struct Message {
  EGLenum error;
  std::string command;
  EGLint type;
  EGLLabelKHR thread_label, object_label;
};
std::vector<Message> messages;

void EGLAPIENTRY note(EGLenum error, const char* command, EGLint type, EGLLabelKHR thread_label,
                      EGLLabelKHR object_label, const char* text) {
  messages.push_back({error, command, type, thread_label, object_label});
  EXPECT_NE(text, nullptr);
}

class DebugTest : public EglTest {
 protected:
  void SetUp() override {
    EglTest::SetUp();
    messages.clear();
  }
  void TearDown() override {
    control(nullptr, nullptr);
    label(nullptr, EGL_OBJECT_THREAD_KHR, nullptr, nullptr);
    EglTest::TearDown();
  }
  EGLAttrib query_debug(EGLint attribute) {
    EGLAttrib value = -12345;
    EXPECT_TRUE(query(attribute, &value));
    return value;
  }
  static EGLLabelKHR text(const char* words) { return const_cast<char*>(words); }

  PFNEGLDEBUGMESSAGECONTROLKHRPROC control =
      proc<PFNEGLDEBUGMESSAGECONTROLKHRPROC>("eglDebugMessageControlKHR");
  PFNEGLQUERYDEBUGKHRPROC query = proc<PFNEGLQUERYDEBUGKHRPROC>("eglQueryDebugKHR");
  PFNEGLLABELOBJECTKHRPROC label = proc<PFNEGLLABELOBJECTKHRPROC>("eglLabelObjectKHR");
};

TEST_F(DebugTest, Extensions) {
  EXPECT_TRUE(words(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS)).count("EGL_KHR_debug"));
  EXPECT_TRUE(words(eglQueryString(display, EGL_EXTENSIONS)).count("EGL_MESA_query_driver"));
}

TEST_F(DebugTest, ErrorsAreMessages) {
  EXPECT_EQ(control(note, nullptr), EGL_SUCCESS);
  EXPECT_EQ(query_debug(EGL_DEBUG_CALLBACK_KHR), reinterpret_cast<EGLAttrib>(&note));
  eglDestroySurface(display, random_handle());
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].error, static_cast<EGLenum>(EGL_BAD_SURFACE));
  EXPECT_EQ(messages[0].command, "eglDestroySurface");
  EXPECT_EQ(messages[0].type, EGL_DEBUG_MSG_ERROR_KHR);
  EXPECT_EQ(messages[0].thread_label, nullptr);
  EXPECT_EQ(messages[0].object_label, nullptr);
  EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);  // as without the callback
  EXPECT_NE(pbuffer(4, 4), EGL_NO_SURFACE);
  EXPECT_EQ(messages.size(), 1u);  // what succeeds says nothing
  proc<PFNEGLDESTROYSYNCKHRPROC>("eglDestroySyncKHR")(display, random_handle());
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_EQ(messages[1].command, "eglDestroySyncKHR");
  EXPECT_EQ(control(nullptr, nullptr), EGL_SUCCESS);
  eglDestroySurface(display, random_handle());
  EXPECT_EQ(messages.size(), 2u);
}

TEST_F(DebugTest, TypesOfMessages) {
  EXPECT_EQ(query_debug(EGL_DEBUG_MSG_CRITICAL_KHR), EGL_TRUE);
  EXPECT_EQ(query_debug(EGL_DEBUG_MSG_ERROR_KHR), EGL_TRUE);
  EXPECT_EQ(query_debug(EGL_DEBUG_MSG_WARN_KHR), EGL_FALSE);
  EXPECT_EQ(query_debug(EGL_DEBUG_MSG_INFO_KHR), EGL_FALSE);
  const EGLAttrib no_errors[] = {EGL_DEBUG_MSG_ERROR_KHR, EGL_FALSE, EGL_DEBUG_MSG_INFO_KHR,
                                 EGL_TRUE, EGL_NONE};
  EXPECT_EQ(control(note, no_errors), EGL_SUCCESS);
  EXPECT_EQ(query_debug(EGL_DEBUG_MSG_ERROR_KHR), EGL_FALSE);
  EXPECT_EQ(query_debug(EGL_DEBUG_MSG_INFO_KHR), EGL_TRUE);
  eglDestroySurface(display, random_handle());
  EXPECT_TRUE(messages.empty());
  // Memory that does not suffice is critical, and still reported.
  EXPECT_EQ(pbuffer(0x7fffffff, 1), EGL_NO_SURFACE);
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].type, EGL_DEBUG_MSG_CRITICAL_KHR);
  EXPECT_EQ(messages[0].error, static_cast<EGLenum>(EGL_BAD_ALLOC));
  // Without a callback, all is as it was at first.
  EXPECT_EQ(control(nullptr, no_errors), EGL_SUCCESS);
  EXPECT_EQ(query_debug(EGL_DEBUG_MSG_ERROR_KHR), EGL_TRUE);
  EXPECT_EQ(query_debug(EGL_DEBUG_MSG_INFO_KHR), EGL_FALSE);
}

TEST_F(DebugTest, RefusedAttributes) {
  const EGLAttrib unknown[] = {EGL_WIDTH, EGL_TRUE, EGL_NONE};
  const EGLAttrib value[] = {EGL_DEBUG_MSG_INFO_KHR, 2, EGL_NONE};
  EXPECT_EQ(control(note, unknown), EGL_BAD_ATTRIBUTE);
  if (!through_libglvnd()) {  // which looks at names alone
    EXPECT_EQ(control(note, value), EGL_BAD_ATTRIBUTE);
    EXPECT_EQ(query_debug(EGL_DEBUG_CALLBACK_KHR), 0);
  }
  EGLAttrib out = 77;
  EXPECT_EGL_FAIL(query(EGL_WIDTH, &out), EGL_FALSE, EGL_BAD_ATTRIBUTE);
  EXPECT_EQ(out, 77);
}

// Labels come with the messages about what has them (table 13.2).
TEST_F(DebugTest, Labels) {
  const EGLSurface surface = pbuffer(4, 4);
  const EGLContext ctx = context();
  EXPECT_EQ(label(nullptr, EGL_OBJECT_THREAD_KHR, nullptr, text("thread")), EGL_SUCCESS);
  EXPECT_EQ(label(display, EGL_OBJECT_DISPLAY_KHR, display, text("display")), EGL_SUCCESS);
  EXPECT_EQ(label(display, EGL_OBJECT_SURFACE_KHR, surface, text("surface")), EGL_SUCCESS);
  EXPECT_EQ(label(display, EGL_OBJECT_CONTEXT_KHR, ctx, text("context")), EGL_SUCCESS);
  control(note, nullptr);
  EGLint value = 0;
  const auto expect = [&](const char* object) {
    ASSERT_EQ(messages.size(), 1u) << object;
    EXPECT_STREQ(static_cast<const char*>(messages[0].object_label), object);
    EXPECT_STREQ(static_cast<const char*>(messages[0].thread_label), "thread");
    messages.clear();
  };
  eglQuerySurface(display, surface, EGL_RED_SIZE, &value);
  expect("surface");
  eglQueryContext(display, ctx, EGL_RED_SIZE, &value);
  expect("context");
  eglCreateContext(display, random_handle(), nullptr, nullptr);
  expect("display");
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, ctx));
  eglWaitNative(77);
  expect("thread");
  // Another thread has no label, and a destroyed object none either.
  std::thread([&] { eglQuerySurface(display, surface, EGL_RED_SIZE, &value); }).join();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].thread_label, nullptr);
  messages.clear();
  eglReleaseThread();
  eglDestroySurface(display, surface);
  eglQuerySurface(display, surface, EGL_WIDTH, &value);
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].object_label, nullptr);
}

TEST_F(DebugTest, RefusedLabels) {
  const EGLSurface surface = pbuffer(4, 4);
  EXPECT_EQ(label(display, EGL_OBJECT_CONTEXT_KHR, surface, nullptr), EGL_BAD_PARAMETER);
  EXPECT_EQ(label(display, EGL_OBJECT_SURFACE_KHR, random_handle(), nullptr), EGL_BAD_PARAMETER);
  EXPECT_EQ(label(display, EGL_OBJECT_SURFACE_KHR, nullptr, nullptr), EGL_BAD_PARAMETER);
  EXPECT_EQ(label(display, EGL_OBJECT_IMAGE_KHR, surface, nullptr), EGL_BAD_PARAMETER);
  EXPECT_EQ(label(display, EGL_OBJECT_SYNC_KHR, surface, nullptr), EGL_BAD_PARAMETER);
  EXPECT_EQ(label(display, EGL_OBJECT_STREAM_KHR, surface, nullptr), EGL_BAD_PARAMETER);
  EXPECT_EQ(label(display, EGL_OBJECT_DISPLAY_KHR, surface, nullptr), EGL_BAD_PARAMETER);
  EXPECT_EQ(label(display, EGL_WIDTH, surface, nullptr), EGL_BAD_PARAMETER);
}

TEST_F(DebugTest, Driver) {
  const auto name = proc<PFNEGLGETDISPLAYDRIVERNAMEPROC>("eglGetDisplayDriverName");
  const auto options = proc<PFNEGLGETDISPLAYDRIVERCONFIGPROC>("eglGetDisplayDriverConfig");
  EXPECT_STREQ(name(display), "clearpipe");
  char* xml = options(display);
  ASSERT_NE(xml, nullptr);
  EXPECT_EQ(std::string(xml), "<driinfo></driinfo>");
  std::free(xml);
  const char* none = nullptr;
  char* no_options = nullptr;
  EXPECT_EGL_FAIL(name(random_handle()), none, EGL_BAD_DISPLAY);
  EXPECT_EGL_FAIL(options(random_handle()), no_options, EGL_BAD_DISPLAY);
  eglTerminate(display);
  EXPECT_EGL_FAIL(name(display), none, EGL_NOT_INITIALIZED);
  EXPECT_EGL_FAIL(options(display), no_options, EGL_NOT_INITIALIZED);
}

}  // namespace
}  // namespace clearpipe::icd
