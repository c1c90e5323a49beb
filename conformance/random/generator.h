// What the parts of the generator share: the numbers, the groups of the seed, and the commands so
// far. Each part sets state of its topic; generate.cpp puts them in order.
// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <vector>

#include "conformance/random/generate.h"
#include "conformance/random/recorder.h"
#include "conformance/scenes/draw.h"

namespace clearpipe::conformance::random {

inline GLfixed fixed(float value) { return static_cast<GLfixed>(value * 65536.0f); }

struct Generator {
  Generator(uint32_t seed, Stream& stream)
      : random(seed), groups(groups_of(seed)), stream(stream) {}

  operator Stream&() { return stream; }

  bool has(Group group) const { return groups[static_cast<size_t>(group)]; }

  float uniform(float low, float high) { return random.uniform(low, high); }
  bool chance(float probability) { return random.uniform(0, 1) < probability; }
  // low to high, both included
  int integer(int low, int high) {
    return low + static_cast<int>(random.below(static_cast<uint32_t>(high - low + 1)));
  }
  template <class T>
  T one_of(std::initializer_list<T> list) {
    return list.begin()[random.below(static_cast<uint32_t>(list.size()))];
  }
  std::vector<float> several(int count, float low, float high) {
    std::vector<float> values(static_cast<size_t>(count));
    for (float& value : values) value = uniform(low, high);
    return values;
  }
  GLenum comparison() { return GL_NEVER + random.below(8); }

  Random random;
  Groups groups;
  Stream& stream;
  int units = 0;             // texture units in use
  bool perspective = false;  // the frustum, or window coordinates
  GLuint names = 1;          // the next unused name of a buffer object
  GLuint textures = 1;       // and of a texture
};

// Transformation, lighting (generate_vertex.cpp)
void set_projection(Generator& g);
void set_clip_planes(Generator& g);
void set_lighting(Generator& g);

// Points, lines, polygons, and the arrays (generate_geometry.cpp)
void set_rasterization(Generator& g);
void draw_something(Generator& g);
// A rectangle over the whole window, at a depth, in window coordinates.
void draw_over_all(Generator& g, float z);

// Textures (generate_texture.cpp)
void set_textures(Generator& g);
void change_textures(Generator& g);

// Fog and the per-fragment operations (generate_fragment.cpp)
void set_fog(Generator& g);
void set_fragment_operations(Generator& g);
void change_fragment_operations(Generator& g);
void show_depth_and_stencil(Generator& g);

// Calls that must fail (generate_errors.cpp)
void make_errors(Generator& g);

}  // namespace clearpipe::conformance::random
