// A scene: one function over the table of commands, which draws a picture. It knows no
// implementation; what it must agree with, and how closely, stands beside it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <ostream>
#include <vector>

#include "conformance/gl.h"

namespace clearpipe::conformance {

// How closely two pictures must agree: at least `near_share` of the pixels within `near`/255 in
// every channel, at least `far_share` within `far`/255. What is looser than the default needs a
// reason, one line with the section of the specification.
struct Tolerance {
  int near = 2;
  double near_share = 0.999;
  int far = 8;
  double far_share = 1.0;
  const char* reason = nullptr;
};

// Flat opaque pictures: which pixels are covered shows in every one of them.
inline constexpr Tolerance kExact = {0, 1.0, 0, 1.0, nullptr};
inline constexpr Tolerance kColours = {};

// As kColours, but a comparison or an edge decides some pixels one way or the other.
constexpr Tolerance except_at_borders(const char* reason) { return {2, 0.999, 8, 0.999, reason}; }

struct Scene {
  const char* topic;  // the file's, a folder in the report
  const char* name;
  void (*draw)(const Gl& gl);
  Tolerance tolerance;
  int samples = 0;     // of the buffers; OSMesa's have none
  bool on_es = false;  // OSMesa cannot draw it: the reference is Mesa's own OpenGL ES 1.1
  int width = 256, height = 256;
};

// For GoogleTest's messages.
inline void PrintTo(const Scene& scene, std::ostream* stream) {
  *stream << scene.topic << "." << scene.name;
}

// All scenes, in the order of topics and files.
std::vector<Scene>& scenes();

struct Registration {
  explicit Registration(const Scene& scene) { scenes().push_back(scene); }
};

// SCENE(topic, name, tolerance) { ... gl.DrawArrays(...) ... }
#define SCENE(topic, name, tolerance) SCENE_OF_KIND(topic, name, tolerance, 0, false)
#define MULTISAMPLED_SCENE(topic, name, tolerance) SCENE_OF_KIND(topic, name, tolerance, 4, true)
#define ES_SCENE(topic, name, tolerance) SCENE_OF_KIND(topic, name, tolerance, 0, true)
#define SCENE_OF_KIND(topic, name, tolerance, samples, on_es)                                     \
  static void topic##_##name(const ::clearpipe::conformance::Gl& gl);                             \
  static const ::clearpipe::conformance::Registration register_##topic##_##name(                  \
      ::clearpipe::conformance::Scene{#topic, #name, topic##_##name, tolerance, samples, on_es}); \
  static void topic##_##name([[maybe_unused]] const ::clearpipe::conformance::Gl& gl)

}  // namespace clearpipe::conformance
