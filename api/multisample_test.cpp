// Multisampling through the API (3.2.1, 4.1.3, 4.1.10): what can be seen of four samples in the
// pixels that are read back.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

// White on black where so many samples are white.
constexpr uint32_t kSteps[5] = {0xff000000u, 0xff404040u, 0xff808080u, 0xffbfbfbfu, 0xffffffffu};

class Multisample : public CallTest {
 protected:
  using Picture = std::array<uint32_t, kSize * kSize>;

  void SetUp() override {
    target_ = make_target(kSize, kSize, true, true, true, pipeline::kSampleCount);
    CallTest::SetUp();
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  }

  // The half of the surface below a slanted edge; its complement with `other_side`.
  static void draw_slanted(bool other_side = false, float z = 0) {
    const float end = 0.45f;
    const float below[] = {-1, -1, z, 1, -1, z, 1, end, z, -1, -1, z, 1, end, z, -1, -end, z};
    const float above[] = {-1, -end, z, 1, end, z, 1, 1, z, -1, -end, z, 1, 1, z, -1, 1, z};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, other_side ? above : below);
    glDrawArrays(GL_TRIANGLES, 0, 6);
  }
  static Picture read() {
    Picture picture{};
    glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
    return picture;
  }
  static std::set<uint32_t> colours() {
    const Picture picture = read();
    return {picture.begin(), picture.end()};
  }
  static GLint integer(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
  }
};

TEST_F(Multisample, TheBuffersAreTold) {
  EXPECT_EQ(integer(GL_SAMPLE_BUFFERS), 1);
  EXPECT_EQ(integer(GL_SAMPLES), 4);
  const pipeline::Target single = make_target(kSize, kSize);
  ASSERT_TRUE(make_current(context_, single, single));
  EXPECT_EQ(integer(GL_SAMPLE_BUFFERS), 0);
  EXPECT_EQ(integer(GL_SAMPLES), 0);
}

// The share of the edge's pixels, by the places of the samples, and nothing but the five steps.
TEST_F(Multisample, EdgesHaveFiveSteps) {
  draw_slanted();
  const Picture picture = read();
  std::array<int, 5> seen{};
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      size_t covered = 0;
      for (const pipeline::SamplePlace& place : pipeline::kSamplePlaces) {
        const double px = x + 0.5 + place.x / 256.0, py = y + 0.5 + place.y / 256.0;
        // In the edge's corners y is 4.4 and 11.6, snapped to 1/256.
        const double low = std::nearbyint(4.4 * 256) / 256, high = std::nearbyint(11.6 * 256) / 256;
        if (py < low + (high - low) * px / kSize) ++covered;
      }
      ASSERT_EQ(picture[static_cast<size_t>(y * kSize + x)], kSteps[covered]) << x << "," << y;
      ++seen[covered];
    }
  }
  for (const int count : seen) EXPECT_GT(count, 0);
}

// 3.2.1: without MULTISAMPLE it is rasterization by centres, with full coverage.
TEST_F(Multisample, DisabledThereAreTwoSteps) {
  glDisable(GL_MULTISAMPLE);
  glEnable(GL_SAMPLE_COVERAGE);
  glSampleCoverage(0, GL_FALSE);
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  glColor4f(1, 1, 1, 0.25f);
  draw_slanted();
  EXPECT_EQ(colours(), (std::set<uint32_t>{kSteps[0], 0x40ffffffu}));
}

// What lies behind does not shine through the edge: each sample has a depth of its own.
TEST_F(Multisample, DepthIsTestedPerSample) {
  glEnable(GL_DEPTH_TEST);
  draw_slanted(false, -0.5f);
  glColor4f(1, 0, 0, 1);
  draw_quad();
  const Picture picture = read();
  std::set<uint32_t> found;
  for (const uint32_t colour : picture) {
    const uint32_t red = colour & 255, green = colour >> 8 & 255;
    EXPECT_EQ(red, 255u);
    found.insert(green);
  }
  EXPECT_EQ(found, (std::set<uint32_t>{0, 64, 128, 191, 255}));
}

// Two planes that cross do so between samples.
TEST_F(Multisample, PlanesIntersectBetweenSamples) {
  glEnable(GL_DEPTH_TEST);
  draw_quad();
  const float tilted[] = {-1, -1, -0.2f, 1, -1, -0.9f, -1, 1, 1, 1, 1, 0.3f};
  glVertexPointer(3, GL_FLOAT, 0, tilted);
  glColor4f(0, 0, 0, 1);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_EQ(colours(), (std::set<uint32_t>(std::begin(kSteps), std::end(kSteps))));
}

TEST_F(Multisample, StencilIsTestedPerSample) {
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, 1, 255);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_slanted();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glStencilFunc(GL_EQUAL, 1, 255);
  draw_quad();
  const Picture inside = read();
  EXPECT_EQ(colours().size(), 5u);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_STENCIL_TEST);
  draw_slanted();
  EXPECT_EQ(inside, read());
}

// Triangles that share an edge share out the samples: blending sees none of them twice.
TEST_F(Multisample, BlendingIsDonePerSample) {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glColor4f(0.2f, 0.2f, 0.2f, 1);
  draw_slanted(false);
  draw_slanted(true);
  EXPECT_EQ(colours(), (std::set<uint32_t>{0xff333333u}));
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_XOR);
  glColor4f(1, 1, 1, 0);
  draw_slanted(false);
  draw_slanted(true);
  EXPECT_EQ(colours(), (std::set<uint32_t>{0xffccccccu}));
}

TEST_F(Multisample, AlphaToCoverageAndToOne) {
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  for (int step = 0; step <= 4; ++step) {
    glClear(GL_COLOR_BUFFER_BIT);
    glColor4f(1, 1, 1, static_cast<float>(step) / 4);
    glEnable(GL_SAMPLE_ALPHA_TO_ONE);
    draw_quad();
    EXPECT_EQ(pixel(3, 3), kSteps[step]);
    glDisable(GL_SAMPLE_ALPHA_TO_ONE);
  }
  glClear(GL_COLOR_BUFFER_BIT);
  glColor4f(1, 1, 1, 0.5f);
  draw_quad();
  // Two samples of alpha 128 and two of 255.
  EXPECT_EQ(pixel(3, 3), 0xc0808080u);
}

TEST_F(Multisample, SampleCoverageAndItsInversion) {
  glEnable(GL_SAMPLE_COVERAGE);
  for (int step = 0; step <= 4; ++step) {
    for (const GLboolean invert : {GL_FALSE, GL_TRUE}) {
      glClear(GL_COLOR_BUFFER_BIT);
      if (step % 2 == 0) {
        glSampleCoverage(static_cast<float>(step) / 4, invert);
      } else {
        glSampleCoveragex(step * 0x4000, invert);
      }
      draw_quad();
      EXPECT_EQ(pixel(5, 5), kSteps[invert ? 4 - step : step]) << step;
    }
  }
  // The inverse takes what the other left: two objects fade into one another.
  glClear(GL_COLOR_BUFFER_BIT);
  glSampleCoverage(0.75f, GL_FALSE);
  glColor4f(1, 0, 0, 1);
  draw_quad();
  glSampleCoverage(0.75f, GL_TRUE);
  glColor4f(0, 0, 1, 1);
  draw_quad();
  EXPECT_EQ(pixel(5, 5), 0xff4000bfu);
}

// 3.3.3, 3.4.4: circles and rectangles, whatever POINT_SMOOTH and LINE_SMOOTH say.
TEST_F(Multisample, PointsAndLinesCoverSamples) {
  const float corners[] = {-0.7f, -0.4f, 0.8f, 0.5f};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, corners);
  glLineWidth(3);
  glPointSize(7);
  for (const GLenum mode : {GL_POINTS, GL_LINES}) {
    glClear(GL_COLOR_BUFFER_BIT);
    glDrawArrays(mode, 0, 2);
    const Picture plain = read();
    EXPECT_EQ(colours(), (std::set<uint32_t>(std::begin(kSteps), std::end(kSteps))));
    glEnable(GL_POINT_SMOOTH);
    glEnable(GL_LINE_SMOOTH);
    glClear(GL_COLOR_BUFFER_BIT);
    glDrawArrays(mode, 0, 2);
    EXPECT_EQ(plain, read());
    glDisable(GL_POINT_SMOOTH);
    glDisable(GL_LINE_SMOOTH);
  }
}

TEST_F(Multisample, ScissoredAndMaskedClears) {
  draw_slanted();
  glEnable(GL_SCISSOR_TEST);
  glScissor(3, 0, 5, kSize);
  glColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE);
  glClearColor(0.2f, 1, 1, 1);
  const Picture before = read();
  glClear(GL_COLOR_BUFFER_BIT);
  const Picture after = read();
  for (size_t i = 0; i < before.size(); ++i) {
    const bool inside = i % kSize >= 3 && i % kSize < 8;
    ASSERT_EQ(after[i], inside ? (before[i] & ~255u) | 51u : before[i]) << i;
  }
}

// Reading in between changes nothing: the samples are kept.
TEST_F(Multisample, ReadingDoesNotResolveTheSamplesThemselves) {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  draw_slanted(false);
  const Picture half = read();
  draw_slanted(true);
  EXPECT_NE(half, read());
  EXPECT_EQ(colours(), (std::set<uint32_t>{kWhite}));
}

TEST_F(Multisample, CopiesTakeTheColourBuffer) {
  draw_slanted();
  const Picture drawn = read();
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, kSize, kSize, 0);
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  draw_quad();
  EXPECT_EQ(drawn, read());
}

}  // namespace
}  // namespace clearpipe::api
