// SPDX-License-Identifier: MIT
//
// Whole surfaces: clears, one rectangle of one or of four colours, and layers of them that hide
// each other.
#include "bench/scene.h"
#include "bench/shapes.h"

#include <array>
#include <vector>

namespace bench {

namespace {

constexpr int kLayers = 8;

void set_colour(int number) {
  glColor4f(0.2f + 0.1f * float(number % 8), 0.9f - 0.1f * float(number % 5), 0.35f, 1);
}

double set_up_nothing(const View& view) { return view.pixels(); }

void clear(const View&, int number) {
  glClearColor(0.1f * float(number % 10), 0.5f, 0.25f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void flat(const View&, int number) {
  set_colour(number);
  draw_whole();
}

double set_up_gouraud(const View& view) {
  use_corner_colours();
  return view.pixels();
}

void gouraud(const View&, int) { draw_whole(); }

// Depth is cleared to 1 once; every frame after that lies where the frame before did.
void use_depth() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
}

double set_up_flat_depth(const View& view) {
  use_depth();
  return view.pixels();
}

double set_up_gouraud_depth(const View& view) {
  use_depth();
  return set_up_gouraud(view);
}

double set_up_layers(const View& view) {
  use_depth();
  use_corner_colours();
  return kLayers * view.pixels();
}

void front_to_back(const View&, int) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (int i = 0; i < kLayers; ++i) draw_whole(-0.8f + 0.2f * float(i));
}

void back_to_front(const View&, int) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (int i = 0; i < kLayers; ++i) draw_whole(0.8f - 0.2f * float(i));
}

// Triangles of about a quarter of the surface each, at any depth, inclined, in one draw: what hides
// what differs from place to place.
std::vector<GLfloat> pile;
std::vector<GLubyte> pile_colours;

double set_up_pile(const View& view) {
  Noise noise(3);
  for (int i = 0; i < 3 * view.amount; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      pile.push_back(axis < 2 ? noise.between(-1, 1) : noise.between(-0.9f, 0.9f));
    }
    for (int c = 0; c < 4; ++c) pile_colours.push_back(GLubyte(noise.bits() >> 16));
  }
  use_depth();
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  return view.amount;
}

void draw_pile(const View& view, int) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glVertexPointer(3, GL_FLOAT, 0, pile.data());
  glColorPointer(4, GL_UNSIGNED_BYTE, 0, pile_colours.data());
  glDrawArrays(GL_TRIANGLES, 0, 3 * view.amount);
}

constexpr std::array kScenes = {
    Scene{.name = "clear",
          .what = "colour and depth cleared",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_nothing,
          .frame = clear,
          .bytes = 8,
          .traffic = "write"},
    Scene{.name = "fill_flat",
          .what = "one rectangle of one colour",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_nothing,
          .frame = flat,
          .bytes = 4,
          .traffic = "write"},
    Scene{.name = "fill_flat_depth",
          .what = "the same, tested against depth and written to it",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_flat_depth,
          .frame = flat,
          .bytes = 8,
          .traffic = "update"},
    Scene{.name = "fill_gouraud",
          .what = "one rectangle of four colours",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_gouraud,
          .frame = gouraud,
          .bytes = 4,
          .traffic = "write"},
    Scene{.name = "fill_gouraud_depth",
          .what = "the same with depth",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_gouraud_depth,
          .frame = gouraud,
          .bytes = 8,
          .traffic = "update"},
    Scene{.name = "layers_front_to_back",
          .what = "8 rectangles with depth, the nearest first",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_layers,
          .frame = front_to_back},
    Scene{.name = "layers_back_to_front",
          .what = "8 rectangles with depth, the nearest last",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_layers,
          .frame = back_to_front},
    Scene{.name = "layers_pile",
          .what = "100 large inclined triangles at any depth",
          .unit = "triangle",
          .amount = 100,
          .set_up = set_up_pile,
          .frame = draw_pile},
};

}  // namespace

std::span<const Scene> fill_scenes() { return kScenes; }

}  // namespace bench
