// The extension string, and extensions that add a name or an enumerant to a command of the core:
// OES_fixed_point, OES_single_precision, IMG_user_clip_plane, EXT_polygon_offset_clamp,
// EXT_blend_minmax, OES_required_internalformat,
// EXT_texture_format_BGRA8888 (with texture_test.cpp), EXT_read_format_bgra.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
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

TEST_F(Extensions, ClipPlanesHaveTheNamesOfImg) {
  const GLfixed right[] = {0x10000, 0, 0, 0};
  const GLfloat upper[] = {0, 1, 0, 0};
  address<decltype(&glClipPlanex)>("glClipPlanexIMG")(GL_CLIP_PLANE0_IMG, right);
  address<decltype(&glClipPlanef)>("glClipPlanefIMG")(GL_CLIP_PLANE5_IMG, upper);
  glEnable(GL_CLIP_PLANE0_IMG);
  glEnable(GL_CLIP_PLANE5_IMG);
  draw_quad();
  EXPECT_EQ(pixel(12, 12), kWhite);
  EXPECT_EQ(pixel(4, 12), 0u);
  EXPECT_EQ(pixel(12, 4), 0u);
  GLint planes = 0;
  glGetIntegerv(GL_MAX_CLIP_PLANES_IMG, &planes);
  EXPECT_GE(planes, 6);
}

// EXT_polygon_offset_clamp: min(o, clamp) if it is positive, max(o, clamp) if it is negative. The
// quad faces the eye, so that o = r * units, with r = 1 / (2^24 - 1).
TEST_F(Extensions, PolygonOffsetIsClamped) {
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_POLYGON_OFFSET_FILL);
  const auto depth_with = [](GLfloat units, GLfloat clamp) {
    glDepthFunc(GL_ALWAYS);
    glPolygonOffsetClampEXT(0, units, clamp);
    draw_quad();
    // The depth of a later quad without an offset is found by halving.
    glPolygonOffset(0, 0);
    glDepthFunc(GL_LESS);
    double low = 0, high = 1;
    for (int i = 0; i < 16; ++i) {
      const double middle = (low + high) / 2;
      glDepthMask(GL_FALSE);
      glClear(GL_COLOR_BUFFER_BIT);
      glDepthRangef(static_cast<GLfloat>(middle), static_cast<GLfloat>(middle));
      draw_quad();
      (pixel(4, 4) == kWhite ? low : high) = middle;
    }
    glDepthMask(GL_TRUE);
    glDepthRangef(0, 1);
    return low;
  };
  constexpr GLfloat kUnits = 16777215.0f / 4;  // a quarter
  const GLfloat kNone = std::numeric_limits<GLfloat>::quiet_NaN(),
                kInfinite = std::numeric_limits<GLfloat>::infinity();
  const struct {
    GLfloat units, clamp;
    double offset;
  } kCases[] = {{kUnits, 0, 0.25},         {kUnits, 0.125f, 0.125},   {kUnits, 0.5f, 0.25},
                {kUnits, -0.125f, 0.25},   {-kUnits, 0, -0.25},       {-kUnits, -0.125f, -0.125},
                {-kUnits, -0.5f, -0.25},   {-kUnits, 0.125f, -0.25},  {kUnits, kNone, 0.25},
                {kUnits, kInfinite, 0.25}, {kUnits, -kInfinite, 0.25}};
  for (const auto& c : kCases) {
    EXPECT_NEAR(depth_with(c.units, c.clamp), 0.5 + c.offset, 1e-4) << c.units << " " << c.clamp;
  }
  GLfloat clamp = 1;
  glPolygonOffsetClampEXT(1, 2, 3);
  glPolygonOffset(1, 2);  // the same with a clamp of zero
  glGetFloatv(GL_POLYGON_OFFSET_CLAMP_EXT, &clamp);
  EXPECT_EQ(clamp, 0.0f);
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

// A sized internal format keeps what its base format keeps, with no fewer bits than it names.
TEST_F(Extensions, SizedInternalFormats) {
  struct {
    GLenum internal, format, type;
    uint32_t texel;  // its bytes, lowest first
    uint32_t drawn;
  } const kRows[] = {
      {GL_RGBA8_OES, GL_RGBA, GL_UNSIGNED_BYTE, 0x81412111, 0x81412111},
      {GL_RGB8_OES, GL_RGB, GL_UNSIGNED_BYTE, 0x412111, 0xff412111},
      {GL_LUMINANCE8_OES, GL_LUMINANCE, GL_UNSIGNED_BYTE, 0x21, 0xff212121},
      {GL_ALPHA8_OES, GL_ALPHA, GL_UNSIGNED_BYTE, 0x21, 0x21ffffff},
      {GL_LUMINANCE8_ALPHA8_OES, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 0x4121, 0x41212121},
      {GL_LUMINANCE4_ALPHA4_OES, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 0xffff, 0xffffffff},
      {GL_RGBA4_OES, GL_RGBA, GL_UNSIGNED_BYTE, 0xff0000ff, 0xff0000ff},
      {GL_RGBA4_OES, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 0x12fc, 0xccff2211},
      {GL_RGB5_A1_OES, GL_RGBA, GL_UNSIGNED_BYTE, 0x00ff00ff, 0x00ff00ff},
      {GL_RGB5_A1_OES, GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 0xf801, 0xff0000ff},
      {GL_RGB565_OES, GL_RGB, GL_UNSIGNED_BYTE, 0x00ff00, 0xff00ff00},
      {GL_RGB565_OES, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 0x001f, 0xffff0000},
  };
  one_colour_texture(0);
  for (const auto& row : kRows) {
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(row.internal), 1, 1, 0, row.format, row.type,
                 &row.texel);
    draw_quad();
    EXPECT_EQ(pixel(3, 3), row.drawn) << std::hex << row.internal << " " << row.type;
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, row.format, row.type, &row.texel);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, row.internal, 0, 0, 1, 1, 0);
    EXPECT_ERROR(GL_NO_ERROR) << std::hex << row.internal;
  }
}

// Levels of a texture have one internal format, size included.
TEST_F(Extensions, LevelsOfTwoSizesAreIncomplete) {
  one_colour_texture(kRed);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  const uint32_t texels[4] = {kRed, kRed, kRed, kRed};
  for (const GLint second : {GL_RGBA8_OES, GL_RGBA}) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8_OES, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexImage2D(GL_TEXTURE_2D, 1, second, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    draw_quad();
    EXPECT_EQ(pixel(3, 3), second == GL_RGBA ? kWhite : kRed);
  }
}

// Two pixels of 16 bits fill a row of 4 bytes; the row after it begins at the alignment.
TEST_F(Extensions, ReadsBgra) {
  glClearColor(1, 0, 0.4f, 0.2f);  // 0x336600ff
  glClear(GL_COLOR_BUFFER_BIT);
  uint32_t whole = 0;
  glReadPixels(0, 0, 1, 1, GL_BGRA_EXT, GL_UNSIGNED_BYTE, &whole);
  EXPECT_EQ(whole, 0x33ff0066u);
  uint16_t packed[8];
  std::fill(std::begin(packed), std::end(packed), uint16_t{7});
  glPixelStorei(GL_PACK_ALIGNMENT, 8);
  glReadPixels(0, 0, 1, 2, GL_BGRA_EXT, GL_UNSIGNED_SHORT_4_4_4_4_REV_EXT, packed);
  EXPECT_EQ(packed[0], 0x3f06);
  EXPECT_EQ(packed[1], 7);
  EXPECT_EQ(packed[4], 0x3f06);
  EXPECT_EQ(packed[5], 7);
  glClearColor(1, 0, 0.4f, 0.6f);
  glClear(GL_COLOR_BUFFER_BIT);
  glReadPixels(0, 0, 1, 1, GL_BGRA_EXT, GL_UNSIGNED_SHORT_1_5_5_5_REV_EXT, packed);
  EXPECT_EQ(packed[0], 0x8000 | 31 << 10 | 12);
  EXPECT_ERROR(GL_NO_ERROR);
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4_REV_EXT, packed);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  glReadPixels(0, 0, 1, 1, GL_BGRA_EXT, GL_UNSIGNED_SHORT_5_6_5, packed);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  glReadPixels(0, 0, 1, 1, GL_BGRA8_EXT, GL_UNSIGNED_BYTE, packed);
  EXPECT_ERROR(GL_INVALID_ENUM);
}

// What is offered follows the surface: RGB of 5, 6 and 5 bits is read as it is held.
TEST_F(Extensions, Rgb565IsReadAsItIs) {
  const auto offered = [](GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return static_cast<GLenum>(value);
  };
  uint16_t packed[2] = {7, 7};
  EXPECT_EQ(offered(GL_IMPLEMENTATION_COLOR_READ_FORMAT_OES), GLenum{GL_RGBA});
  EXPECT_EQ(offered(GL_IMPLEMENTATION_COLOR_READ_TYPE_OES), GLenum{GL_UNSIGNED_BYTE});
  glReadPixels(0, 0, 1, 1, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, packed);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  pipeline::Target target = make_target(kSize, kSize, false);
  target.colour->format = pipeline::ColourFormat::kRgb565;
  ASSERT_TRUE(make_current(context_, target, target));
  EXPECT_EQ(offered(GL_IMPLEMENTATION_COLOR_READ_FORMAT_OES), GLenum{GL_RGB});
  EXPECT_EQ(offered(GL_IMPLEMENTATION_COLOR_READ_TYPE_OES), GLenum{GL_UNSIGNED_SHORT_5_6_5});
  for (const uint32_t value : {0u, 1u, 17u, 30u, 31u}) {
    const float part = static_cast<float>(value) / 31;
    glClearColor(part, 1 - part, part, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glReadPixels(0, 0, 1, 1, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, packed);
    const uint32_t green = static_cast<uint32_t>(std::lround((1 - part) * 63));
    EXPECT_EQ(packed[0], value << 11 | green << 5 | value);
  }
  EXPECT_EQ(packed[1], 7);
  glReadPixels(0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, packed);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  EXPECT_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace clearpipe::api
