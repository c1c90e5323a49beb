// eglGetProcAddress (3.11): every name of the lists, and names that nothing has.
// SPDX-License-Identifier: MIT
#include "icd/egl_test.h"

namespace clearpipe::icd {
namespace {

const std::vector<std::string> kEgl = {
#define CALL(type, name, ...) "egl" #name,
#include "icd/egl15.def"
#undef CALL
#define CALL(type, name, ...) "egl" #name,
#include "icd/egl_ext.def"
#undef CALL
};
const std::vector<std::string> kGl = {
#define CALL(type, name, ...) "gl" #name,
#include "api/gles1.def"
#undef CALL
};

TEST(Names, EveryListedNameHasAnAddressOfItsOwn) {
  std::set<void (*)()> addresses;
  for (const auto& list : {kEgl, kGl}) {
    for (const std::string& name : list) {
      const auto proc = eglGetProcAddress(name.c_str());
      EXPECT_NE(proc, nullptr) << name;
      EXPECT_TRUE(addresses.insert(proc).second) << name;
    }
  }
  EXPECT_GT(addresses.size(), 140u);
}

TEST(Names, UnknownNames) {
  for (const char* name :
       {"eglNoSuchCall", "eglGetErro", "eglGetErrorr", "GetError", "", "printf"}) {
    EXPECT_EQ(eglGetProcAddress(name), nullptr) << name;
  }
  // libglvnd makes an entry of any name that starts with gl.
  if (!through_libglvnd()) {
    for (const char* name : {"glNoSuchCall", "gl", "glClea", "glClearr", "glCreateShader"}) {
      EXPECT_EQ(eglGetProcAddress(name), nullptr) << name;
    }
  }
}

// What comes back is the command, not only an address.
TEST_F(EglTest, AddressesWork) {
  const auto query = reinterpret_cast<const char*(EGLAPIENTRYP)(EGLDisplay, EGLint)>(
      eglGetProcAddress("eglQueryString"));
  EXPECT_STREQ(query(display, EGL_VENDOR), "clearpipe");
  const EGLSurface surface = pbuffer(4, 4);
  ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context()));
  const auto get_string =
      reinterpret_cast<const GLubyte*(GL_APIENTRY*)(GLenum)>(eglGetProcAddress("glGetString"));
  EXPECT_EQ(get_string(GL_VENDOR), glGetString(GL_VENDOR));
  EXPECT_NE(get_string(GL_VENDOR), nullptr);
}

}  // namespace
}  // namespace clearpipe::icd
