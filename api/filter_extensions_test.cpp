// How textures are minified: EXT_texture_lod_bias, APPLE_texture_max_level and
// EXT_texture_filter_anisotropic, seen through mipmaps of one colour a level.
// SPDX-License-Identifier: MIT
#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

class FilterExtensions : public CallTest {
 protected:
  // 64x64 and smaller; every component of level i is 10 i.
  void SetUp() override {
    CallTest::SetUp();
    one_colour_texture(0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_LINEAR);
    levels(6);
  }
  static void levels(GLint last) {
    for (GLint i = 0; i <= last; ++i) {
      const GLsizei size = 64 >> i;
      glTexImage2D(GL_TEXTURE_2D, i, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                   texels(0x0a0a0a0au * static_cast<uint32_t>(i), size).data());
    }
  }
  // The level of detail in tenths, with so many texels a pixel along s and t.
  static uint32_t level_drawn(float along_s, float along_t) {
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glScalef(along_s * kSize / 64, along_t * kSize / 64, 1);
    draw_quad();
    return pixel(5, 9) & 255;
  }
  static float bias() {
    GLfloat value = -1;
    glGetTexEnvfv(GL_TEXTURE_FILTER_CONTROL_EXT, GL_TEXTURE_LOD_BIAS_EXT, &value);
    return value;
  }
};

TEST_F(FilterExtensions, TheBiasIsAdded) {
  EXPECT_EQ(bias(), 0);
  EXPECT_EQ(level_drawn(4, 4), 20u);
  glTexEnvf(GL_TEXTURE_FILTER_CONTROL_EXT, GL_TEXTURE_LOD_BIAS_EXT, 1.5f);
  EXPECT_EQ(bias(), 1.5f);
  EXPECT_EQ(level_drawn(4, 4), 35u);
  glTexEnvx(GL_TEXTURE_FILTER_CONTROL_EXT, GL_TEXTURE_LOD_BIAS_EXT, -0x10000);
  EXPECT_EQ(bias(), -1.0f);
  EXPECT_EQ(level_drawn(4, 4), 10u);
  glTexEnvi(GL_TEXTURE_FILTER_CONTROL_EXT, GL_TEXTURE_LOD_BIAS_EXT, 100);
  EXPECT_EQ(bias(), 100);
  EXPECT_EQ(level_drawn(1.0f / 4, 1.0f / 4), 60u);  // -2 + 15, and the last level is 6
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(FilterExtensions, EachUnitHasItsBias) {
  glTexEnvf(GL_TEXTURE_FILTER_CONTROL_EXT, GL_TEXTURE_LOD_BIAS_EXT, 2);
  glActiveTexture(GL_TEXTURE1);
  EXPECT_EQ(bias(), 0);
  glActiveTexture(GL_TEXTURE0);
  EXPECT_EQ(bias(), 2);
  glTexEnvf(GL_TEXTURE_FILTER_CONTROL_EXT, GL_TEXTURE_ENV_MODE, GL_ADD);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_LOD_BIAS_EXT, 1);
  EXPECT_ERROR(GL_INVALID_ENUM);
  GLfloat value;
  glGetTexEnvfv(GL_TEXTURE_FILTER_CONTROL_EXT, GL_TEXTURE_ENV_MODE, &value);
  EXPECT_ERROR(GL_INVALID_ENUM);
}

TEST_F(FilterExtensions, TheLastLevelBoundsChoiceAndCompleteness) {
  GLint last = 0;
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL_APPLE, &last);
  EXPECT_EQ(last, 1000);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL_APPLE, 2);
  EXPECT_EQ(level_drawn(16, 16), 20u);
  glTexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL_APPLE, 0x30000);
  EXPECT_EQ(level_drawn(16, 16), 30u);

  one_colour_texture(0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_LINEAR);
  levels(2);
  EXPECT_EQ(level_drawn(16, 16), 255u);  // incomplete: white
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL_APPLE, 2);
  EXPECT_EQ(level_drawn(16, 16), 20u);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL_APPLE, 0);
  EXPECT_EQ(level_drawn(16, 16), 0u);
  EXPECT_ERROR(GL_NO_ERROR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL_APPLE, -1);
  EXPECT_ERROR(GL_INVALID_VALUE);
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL_APPLE, &last);
  EXPECT_EQ(last, 0);
}

// A footprint of 16 by 2 texels: level 4 for one sample, 3 for two, 2 for four, 1 from eight on.
TEST_F(FilterExtensions, AnisotropySharpensTheLongerSide) {
  struct {
    float most;
    uint32_t level;
  } const kCases[] = {{1, 40}, {2, 30}, {2.9f, 30}, {4, 20}, {8, 10}, {16, 10}, {1000, 10}};
  for (const auto& c : kCases) {
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, c.most);
    GLfloat set = 0;
    glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, &set);
    EXPECT_EQ(set, c.most);
    EXPECT_EQ(level_drawn(16, 2), c.level) << c.most;
    EXPECT_EQ(level_drawn(2, 16), c.level) << c.most;
    EXPECT_EQ(level_drawn(4, 4), 20u) << c.most;
  }
  EXPECT_ERROR(GL_NO_ERROR);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 0.99f);
  EXPECT_ERROR(GL_INVALID_VALUE);
  GLint set = 0;
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, &set);
  EXPECT_EQ(set, 1000);
}

// Two texels wide, black and white: the mean of samples along s is grey, where one sample of the
// nearest texel is not.
TEST_F(FilterExtensions, AnisotropyTakesTheMean) {
  std::vector<uint32_t> stripes;
  for (size_t i = 0; i < 64 * 64; ++i) stripes.push_back(i % 4 < 2 ? kWhite : 0xff000000u);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, stripes.data());
  const uint32_t one = level_drawn(8, 1);
  EXPECT_TRUE(one == 0 || one == 255) << one;
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
  const uint32_t several = level_drawn(8, 1);
  EXPECT_GT(several, 90u);
  EXPECT_LT(several, 165u);
}

}  // namespace
}  // namespace clearpipe::api
