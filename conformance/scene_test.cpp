// Every scene on clearpipe and on the reference, compared. Prints one line a scene; writes the
// pictures of those that disagree, or of all with CLEARPIPE_PICTURES=1, into the folder
// CLEARPIPE_OUTPUT (default scenes/ under the current one), and the records of the report into
// CLEARPIPE_RECORDS, if it is set. Scenes that OSMesa draws are drawn on Mesa's OpenGL ES 1.1 too;
// where these two differ, a line and the report say so.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>

#include "conformance/chapters.h"
#include "conformance/compare.h"
#include "conformance/pictures.h"
#include "conformance/report/entry.h"
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
  if (scene.on_es) {
    static const auto es = open_mesa_through_egl(0);
    return *es;
  }
  static const auto implementation = reference::open_osmesa();
  return *implementation;
}

// Mesa's OpenGL ES 1.1 beside OSMesa; null when the environment names no vendor library of Mesa's.
Implementation* second_reference(const Scene& scene) {
  if (scene.on_es) return nullptr;
  static const auto implementation = []() -> std::unique_ptr<Implementation> {
    try {
      return open_mesa_through_egl(0);
    } catch (const std::runtime_error& error) {
      std::printf("no second reference: %s\n", error.what());
      return nullptr;
    }
  }();
  return implementation.get();
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

struct Drawn {
  Image image;
  GLenum error;
};

Drawn draw(Implementation& implementation, const Scene& scene) {
  const Gl& gl = implementation.begin(scene.width, scene.height);
  scene.draw(gl);
  const GLenum error = gl.GetError();
  if (scene.samples > 0) replace_samples_by_their_mean(gl, scene.width, scene.height);
  Image image = read_image(gl, scene.width, scene.height);
  implementation.end();
  return {std::move(image), error};
}

Image draw_without_error(Implementation& implementation, const Scene& scene) {
  Drawn drawn = draw(implementation, scene);
  EXPECT_EQ(drawn.error, static_cast<GLenum>(GL_NO_ERROR)) << "on " << implementation.name();
  return std::move(drawn.image);
}

// Why the references differ in a scene (reference/second_reference.def); empty if they should not.
std::string cause_of(const std::string& scene) {
  static const std::map<std::string, std::string> causes = {
#define DIFFERS(topic, name, cause) {#topic "." #name, cause},
#include "reference/second_reference.def"
#undef DIFFERS
  };
  const auto found = causes.find(scene);
  return found != causes.end() ? found->second : "";
}

// What the second reference makes of the scene, beside the two pictures that there are.
report::Second draw_on_second(const Scene& scene, const Image& image, const Image& expected) {
  Implementation* implementation = second_reference(scene);
  if (implementation == nullptr) return {};
  report::Second second;
  Drawn drawn = draw(*implementation, scene);
  second.name = "Mesa's OpenGL ES 1.1";
  second.cause = cause_of(std::string(scene.topic) + "." + scene.name);
  if (drawn.error != GL_NO_ERROR) {
    char text[64];
    std::snprintf(text, sizeof text, "it refuses a call, GL error 0x%04x", drawn.error);
    second.complaint = text;
    return second;
  }
  second.with_reference = compare(drawn.image, expected, scene.tolerance);
  second.with_subject = compare(image, drawn.image, scene.tolerance);
  EXPECT_EQ(second.with_reference.equal < 1, !second.cause.empty())
      << "the references agree: " << describe(second.with_reference)
      << "; reference/second_reference.def has the scenes where they do not, with the causes";
  second.image = std::move(drawn.image);
  return second;
}

void print_second(const std::string& name, const report::Second& second) {
  if (!second.complaint.empty()) {
    std::printf("second %s: %s%s%s\n", name.c_str(), second.complaint.c_str(),
                second.cause.empty() ? "" : "; ", second.cause.c_str());
  } else if (!second.name.empty() && second.with_reference.equal < 1) {
    std::printf("second %s: the references differ: %s; clearpipe and the second: %s; %s\n",
                name.c_str(), describe(second.with_reference).c_str(),
                describe(second.with_subject).c_str(), second.cause.c_str());
  }
}

void record(const nlohmann::json& entry) {
  const char* folder = std::getenv("CLEARPIPE_RECORDS");
  if (folder != nullptr) report::write_record(entry, folder);
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
  const std::string name = std::string(scene.topic) + "." + scene.name;
  const Chapter chapter = chapter_of(scene.topic);
  EXPECT_FALSE(chapter.title.empty()) << "chapters.cpp does not know " << scene.topic;
  report::Entry entry;
  entry.chapter = chapter.title;
  entry.section = chapter.section;
  entry.name = name;
  entry.tolerance = scene.tolerance;
  record(report::as_json_without_pictures(entry, "the test ended before this scene was drawn"));

  const Image image = draw_without_error(subject(scene), scene);
  ASSERT_NE(subject(scene).name().find("clearpipe"), std::string::npos)
      << "the loader gave " << subject(scene).name();
  const Image expected = draw_without_error(reference(scene), scene);
  // A scene that draws nothing proves nothing.
  EXPECT_FALSE(is_one_colour(expected)) << "the reference's picture is empty";

  const Agreement agreement = compare(image, expected, scene.tolerance);
  const bool good = holds(agreement, scene.tolerance);
  std::printf("scene %s: %s%s%s\n", name.c_str(), describe(agreement).c_str(),
              scene.tolerance.reason != nullptr ? "; " : "",
              scene.tolerance.reason != nullptr ? scene.tolerance.reason : "");
  entry.second = draw_on_second(scene, image, expected);
  print_second(name, entry.second);
  entry.reference_name = scene.on_es ? "Mesa's OpenGL ES 1.1" : "OSMesa";
  entry.subject = image;
  entry.reference = expected;
  entry.agreement = agreement;
  record(report::as_json(entry));
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
