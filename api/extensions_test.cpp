// The extension string, and extensions that add a name or an enumerant to a command of the core:
// OES_fixed_point, OES_single_precision, EXT_blend_minmax.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <sstream>
#include <string>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

class Extensions : public CallTest {
 protected:
  template <typename Function>
  static Function address(const char* name) {
    return reinterpret_cast<Function>(proc_address(name));
  }
};

TEST_F(Extensions, TheStringNamesEachOnceInOrder) {
  std::istringstream text(reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS)));
  std::vector<std::string> names;
  for (std::string name; text >> name;) names.push_back(name);
  ASSERT_FALSE(names.empty());
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  for (const std::string& name : names) EXPECT_EQ(name.rfind("GL_", 0), 0u) << name;
  EXPECT_TRUE(std::count(names.begin(), names.end(), "GL_OES_fixed_point"));
}

TEST_F(Extensions, FixedPointCommandsHaveTheirSuffixedNames) {
  address<decltype(&glColor4x)>("glColor4xOES")(0, 0x10000, 0, 0x10000);
  draw_quad();
  EXPECT_EQ(pixel(3, 3), kGreen);
  address<decltype(&glPointSizex)>("glPointSizexOES")(0x28000);
  GLfixed size = 0;
  address<decltype(&glGetFixedv)>("glGetFixedvOES")(GL_POINT_SIZE, &size);
  EXPECT_EQ(size, 0x28000);
  address<decltype(&glPointSizex)>("glPointSizexOES")(-1);
  EXPECT_ERROR(GL_INVALID_VALUE);
}

TEST_F(Extensions, SinglePrecisionCommandsHaveTheirSuffixedNames) {
  address<decltype(&glDepthRangef)>("glDepthRangefOES")(0.25f, 0.5f);
  GLfloat range[2];
  glGetFloatv(GL_DEPTH_RANGE, range);
  EXPECT_EQ(range[0], 0.25f);
  EXPECT_EQ(range[1], 0.5f);
}

// MIN and MAX take the components as they are; factors do not count.
TEST_F(Extensions, BlendMinimumAndMaximum) {
  const auto equation = address<void(GL_APIENTRY*)(GLenum)>("glBlendEquationEXT");
  glClearColor(0.2f, 0.8f, 0.4f, 1.0f);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_ZERO);
  glColor4ub(153, 102, 102, 51);
  glClear(GL_COLOR_BUFFER_BIT);
  equation(GL_MIN_EXT);
  draw_quad();
  EXPECT_EQ(pixel(3, 3), 0x33666633u);
  glClear(GL_COLOR_BUFFER_BIT);
  equation(GL_MAX_EXT);
  draw_quad();
  EXPECT_EQ(pixel(3, 3), 0xff66cc99u);
  GLint mode = 0;
  glGetIntegerv(GL_BLEND_EQUATION_OES, &mode);
  EXPECT_EQ(mode, GL_MAX_EXT);
  equation(GL_BLEND_EQUATION_OES);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glGetIntegerv(GL_BLEND_EQUATION_ALPHA_OES, &mode);
  EXPECT_EQ(mode, GL_MAX_EXT);
}

}  // namespace
}  // namespace clearpipe::api
