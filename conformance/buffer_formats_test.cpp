// Every scene on pbuffers of other formats than the scenes are for - 16-bit colours, depths of 16
// and 32 bits, the sRGB colour space - compared with Mesa's OpenGL ES 1.1 on the same. What is
// looked at is what the format does to the pixels: scenes that agree as they are must agree here,
// one step of the format more or less. Prints a line for each format.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
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
  int step;  // of the coarsest component, in 1/255
};

const Format kFormats[] = {
    {"rgb565_depth16", {.red = 5, .green = 6, .blue = 5, .alpha = 0, .depth = 16, .stencil = 0}, 9},
    {"rgb565", {.red = 5, .green = 6, .blue = 5, .alpha = 0}, 9},
    {"rgba8888_depth16", {.depth = 16, .stencil = 0}, 2},
    {"rgba8888_depth32", {.depth = 32, .stencil = 0}, 2},
    {"srgb", {.srgb = true}, 8},
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

class BufferFormats : public testing::TestWithParam<Format> {};

TEST_P(BufferFormats, ScenesAgreeWithMesa) {
  const Format& format = GetParam();
  const auto subject = open_through_egl(format.buffers);
  const auto reference = open_mesa_through_egl(format.buffers);
  int drawn = 0, refused = 0, equal = 0;
  for (const Scene& scene : scenes()) {
    if (scene.samples > 0) continue;
    const std::string name = std::string(scene.topic) + "." + scene.name;
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
    if (!holds(agreement, tolerance)) {
      ADD_FAILURE() << name << " on " << format.name << ": " << describe(agreement) << "; see "
                    << write_pictures(image, expected, output_folder(),
                                      std::string(format.name) + "." + name);
    }
  }
  std::printf("format %s: %d scenes agree or are reported, %d of them equal; %d refused\n",
              format.name, drawn, equal, refused);
  EXPECT_GT(drawn, 50);
}

INSTANTIATE_TEST_SUITE_P(All, BufferFormats, testing::ValuesIn(kFormats),
                         [](const testing::TestParamInfo<Format>& info) {
                           return std::string(info.param.name);
                         });

}  // namespace
}  // namespace clearpipe::conformance
