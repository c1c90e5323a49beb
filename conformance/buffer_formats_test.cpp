// Every scene on pbuffers of other formats than the scenes are for - 16-bit colours, depths of 16
// and 32 bits, the sRGB colour space - compared with Mesa's OpenGL ES 1.1 on the same. What is
// looked at is what the format does to the pixels: scenes that agree as they are must agree here,
// one step of the format more or less. Prints a line for each format.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>

#include "conformance/compare.h"
#include "conformance/pictures.h"
#include "conformance/scene.h"
#include "conformance/through_egl.h"

namespace clearpipe::conformance {
namespace {

struct Format {
  const char* name;
  Buffers buffers;
  int step;            // of the coarsest component, in 1/255
  double least_equal;  // the share of pixels that must be equal in every scene
};

const Format kFormats[] = {
    {"rgb565_depth16",
     {.red = 5, .green = 6, .blue = 5, .alpha = 0, .depth = 16, .stencil = 0},
     9,
     0.85},
    {"rgb565", {.red = 5, .green = 6, .blue = 5, .alpha = 0}, 9, 0.85},
    {"rgba8888_depth16", {.depth = 16, .stencil = 0}, 2, 0},
    {"rgba8888_depth32", {.depth = 32, .stencil = 0}, 2, 0},
    {"srgb", {.srgb = true}, 8, 0},
};

Image draw(Implementation& implementation, const Scene& scene, GLenum& error) {
  const Gl& gl = implementation.begin(scene.width, scene.height);
  scene.draw(gl);
  error = gl.GetError();
  Image image = read_image(gl, scene.width, scene.height);
  implementation.end();
  return image;
}

std::string output_folder() {
  const char* folder = std::getenv("CLEARPIPE_OUTPUT");
  return folder != nullptr ? folder : "scenes";
}

// Why Mesa's OpenGL ES 1.1 draws a scene otherwise, whatever it is drawn on; or on sRGB.
bool differs_anyway(const std::string& scene, const Format& format) {
  static const std::set<std::string> differing = {
#define DIFFERS(topic, name, cause) #topic "." #name,
#include "reference/second_reference.def"
#undef DIFFERS
  };
  // 4.1.9 knows no exception for encoded colours; Mesa leaves them alone, as OpenGL 3.0 does.
  if (format.buffers.srgb && scene == "fragments.logic_operations") return true;
  return differing.count(scene) != 0;
}

class BufferFormats : public testing::TestWithParam<Format> {};

TEST_P(BufferFormats, ScenesAgreeWithMesa) {
  const Format& format = GetParam();
  const auto subject = open_through_egl(format.buffers);
  const auto reference = open_mesa_through_egl(format.buffers);
  int drawn = 0, refused = 0, equal = 0;
  double least = 1;
  for (const Scene& scene : scenes()) {
    const std::string name = std::string(scene.topic) + "." + scene.name;
    if (scene.samples > 0 || differs_anyway(name, format)) continue;
    GLenum error = GL_NO_ERROR, expected_error = GL_NO_ERROR;
    const Image image = draw(*subject, scene, error);
    const Image expected = draw(*reference, scene, expected_error);
    ASSERT_NE(subject->name().find("clearpipe"), std::string::npos);
    // Some need alpha or stencil, or what Mesa's OpenGL ES 1.1 does not have.
    if (error != GL_NO_ERROR || expected_error != GL_NO_ERROR) {
      ++refused;
      continue;
    }
    Tolerance tolerance = scene.tolerance;
    tolerance.near = std::max(tolerance.near, format.step);
    tolerance.near_share = std::min(tolerance.near_share, 0.995);
    tolerance.far = 255;
    const Agreement agreement = compare(image, expected, tolerance);
    ++drawn;
    if (agreement.equal == 1) ++equal;
    least = std::min(least, agreement.equal);
    // Rounded where Mesa truncates, half of all pixels would be another step.
    if (!holds(agreement, tolerance) || agreement.equal < format.least_equal) {
      ADD_FAILURE() << name << " on " << format.name << ": " << describe(agreement) << "; see "
                    << write_pictures(image, expected, output_folder(),
                                      std::string(format.name) + "." + name);
    }
  }
  std::printf(
      "format %s: %d scenes, %d of them equal, the others in %.1f%% of their pixels or more; "
      "%d refused\n",
      format.name, drawn, equal, 100 * least, refused);
  EXPECT_GT(drawn, 50);
}

INSTANTIATE_TEST_SUITE_P(All, BufferFormats, testing::ValuesIn(kFormats),
                         [](const testing::TestParamInfo<Format>& info) {
                           return std::string(info.param.name);
                         });

}  // namespace
}  // namespace clearpipe::conformance
