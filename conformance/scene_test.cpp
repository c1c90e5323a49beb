// Every scene on clearpipe and on the reference, compared. Prints one line a scene; writes the
// pictures of those that disagree, or of all with CLEARPIPE_PICTURES=1, into the folder
// CLEARPIPE_OUTPUT (default scenes/ under the current one).
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "conformance/compare.h"
#include "conformance/scene.h"
#include "conformance/through_egl.h"
#include "reference/osmesa_runner.h"

namespace clearpipe::conformance {

namespace {

Implementation& subject(const Scene& scene) {
  if (scene.samples > 0) {
    static const auto multisampled = open_through_egl(4);
    return *multisampled;
  }
  static const auto implementation = open_through_egl();
  return *implementation;
}

Implementation& reference(const Scene& scene) {
  if (scene.samples > 0) {
    static const auto multisampled = open_mesa_through_egl(4);
    return *multisampled;
  }
  static const auto implementation = reference::open_osmesa();
  return *implementation;
}

std::string output_folder() {
  const char* folder = std::getenv("CLEARPIPE_OUTPUT");
  return folder != nullptr ? folder : "scenes";
}

// Mesa's ReadPixels gives one of the samples; copies to textures take their mean, which is what the
// colour buffer holds (4.1.10). So the buffer is copied and drawn where all samples are the same.
void replace_samples_by_their_mean(const Gl& gl, int width, int height) {
  for (const GLenum cap : {GL_ALPHA_TEST, GL_BLEND, GL_COLOR_LOGIC_OP, GL_CULL_FACE, GL_DEPTH_TEST,
                           GL_LIGHTING, GL_MULTISAMPLE, GL_SCISSOR_TEST, GL_STENCIL_TEST}) {
    gl.Disable(cap);
  }
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  for (const GLenum mode : {GL_PROJECTION, GL_MODELVIEW}) {
    gl.MatrixMode(mode);
    gl.LoadIdentity();
  }
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, width, height, 0);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.Enable(GL_TEXTURE_2D);
  const float corners[] = {-1, -1, 1, -1, -1, 1, 1, 1}, coordinates[] = {0, 0, 1, 0, 0, 1, 1, 1};
  gl.DisableClientState(GL_COLOR_ARRAY);
  gl.DisableClientState(GL_NORMAL_ARRAY);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
  gl.VertexPointer(2, GL_FLOAT, 0, corners);
  gl.TexCoordPointer(2, GL_FLOAT, 0, coordinates);
  gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

Image draw(Implementation& implementation, const Scene& scene) {
  const Gl& gl = implementation.begin(scene.width, scene.height);
  scene.draw(gl);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR)) << "on " << implementation.name();
  if (scene.samples > 0) replace_samples_by_their_mean(gl, scene.width, scene.height);
  Image image = read_image(gl, scene.width, scene.height);
  implementation.end();
  return image;
}

bool is_one_colour(const Image& image) {
  for (size_t i = 4; i < image.pixels.size(); i += 4) {
    if (!std::equal(image.pixels.begin(), image.pixels.begin() + 4, image.pixels.begin() + i)) {
      return false;
    }
  }
  return true;
}

class SceneTest : public testing::TestWithParam<Scene> {};

TEST_P(SceneTest, AgreesWithTheReference) {
  const Scene& scene = GetParam();
  const Image image = draw(subject(scene), scene);
  ASSERT_NE(subject(scene).name().find("clearpipe"), std::string::npos)
      << "the loader gave " << subject(scene).name();
  const Image expected = draw(reference(scene), scene);
  // A scene that draws nothing proves nothing.
  EXPECT_FALSE(is_one_colour(expected)) << "the reference's picture is empty";

  const Agreement agreement = compare(image, expected, scene.tolerance);
  const std::string name = std::string(scene.topic) + "." + scene.name;
  const bool good = holds(agreement, scene.tolerance);
  std::printf("scene %s: %s%s%s\n", name.c_str(), describe(agreement).c_str(),
              scene.tolerance.reason != nullptr ? "; " : "",
              scene.tolerance.reason != nullptr ? scene.tolerance.reason : "");
  const bool looser =
      scene.tolerance.near > kColours.near || scene.tolerance.near_share < kColours.near_share ||
      scene.tolerance.far > kColours.far || scene.tolerance.far_share < kColours.far_share;
  EXPECT_EQ(looser, scene.tolerance.reason != nullptr)
      << "what is looser than the default needs a reason, and only that";
  std::string picture;
  if (!good || std::getenv("CLEARPIPE_PICTURES") != nullptr) {
    picture = write_pictures(image, expected, output_folder(), name);
  }
  EXPECT_TRUE(good) << name << " disagrees with " << reference(scene).name() << ": "
                    << agreement.near * 100 << "% within " << scene.tolerance.near << "/255, "
                    << agreement.far * 100 << "% within " << scene.tolerance.far << "/255; see "
                    << picture;
}

INSTANTIATE_TEST_SUITE_P(All, SceneTest, testing::ValuesIn(scenes()),
                         [](const testing::TestParamInfo<Scene>& info) {
                           return std::string(info.param.topic) + "_" + info.param.name;
                         });

}  // namespace

}  // namespace clearpipe::conformance
