// SPDX-License-Identifier: MIT
//
// Points and lines: one pixel and several wide, sprites, antialiased ones.
#include "bench/scene.h"
#include "bench/shapes.h"

#include <GLES/glext.h>

#include <array>
#include <vector>

namespace bench {

namespace {

std::vector<GLfloat> positions;
std::vector<GLubyte> colours;

void scatter(int count) {
  Noise noise(7);
  positions.reserve(size_t(count) * 3);
  colours.reserve(size_t(count) * 4);
  for (int i = 0; i < count; ++i) {
    for (int axis = 0; axis < 3; ++axis) positions.push_back(noise.between(-0.98f, 0.98f));
    for (int c = 0; c < 4; ++c) colours.push_back(GLubyte(noise.bits() >> 16));
  }
  // Mesa forgets the alpha of antialiased points where they are covered wholly.
  for (size_t i = 3; i < colours.size(); i += 4)
    colours[i] = glIsEnabled(GL_POINT_SMOOTH) ? 255 : colours[i];
  glVertexPointer(3, GL_FLOAT, 0, positions.data());
  glColorPointer(4, GL_UNSIGNED_BYTE, 0, colours.data());
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
}

double set_up_points(const View& view) {
  scatter(view.amount);
  glEnable(GL_DEPTH_TEST);
  return view.amount;
}

void points(const View& view, int) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDrawArrays(GL_POINTS, 0, view.amount);
}

double set_up_smooth_points(const View& view) {
  glEnable(GL_POINT_SMOOTH);
  glPointSize(6);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  scatter(view.amount);
  return view.amount;
}

double set_up_sprites(const View& view) {
  scatter(view.amount);
  use_noise_texture(2, {.size = 32, .smooth = true});
  glTexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, GL_TRUE);
  glEnable(GL_POINT_SPRITE_OES);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE);
  glPointSize(16);
  return view.amount;
}

// Segments of some fifty pixels in any direction: from each scattered point to one beside it.
double set_up_lines(const View& view, float width) {
  scatter(2 * view.amount);
  Noise noise(9);
  for (size_t i = 0; i < positions.size(); i += 6) {
    for (size_t axis = 0; axis < 3; ++axis) {
      positions[i + 3 + axis] = 0.98f * positions[i + axis] + noise.between(-0.1f, 0.1f);
    }
  }
  glLineWidth(width);
  return view.amount;
}

double set_up_thin_lines(const View& view) {
  glEnable(GL_DEPTH_TEST);
  return set_up_lines(view, 1);
}

double set_up_wide_lines(const View& view) {
  glEnable(GL_DEPTH_TEST);
  return set_up_lines(view, 5);
}

double set_up_smooth_lines(const View& view) {
  glEnable(GL_LINE_SMOOTH);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  return set_up_lines(view, 2);
}

void lines(const View& view, int) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDrawArrays(GL_LINES, 0, 2 * view.amount);
}

constexpr Scene scene(const char* name, const char* what, const char* unit, int amount,
                      double (*set_up)(const View&), void (*frame)(const View&, int),
                      double share = 0.99) {
  return {.name = name,
          .what = what,
          .unit = unit,
          .amount = amount,
          .set_up = set_up,
          .frame = frame,
          .share = share};
}

// The coverage of antialiased points and lines is up to the implementation (3.3.1, 3.4.2): their
// rims differ.
constexpr std::array kScenes = {
    scene("points_small", "100,000 points of one pixel, with depth", "point", 100000, set_up_points,
          points),
    scene("points_sprites", "5,000 blended sprites of 16 pixels", "point", 5000, set_up_sprites,
          points),
    scene("points_smooth", "5,000 antialiased points of 6 pixels", "point", 5000,
          set_up_smooth_points, points, 0.6),
    scene("lines_thin", "20,000 lines of one pixel, with depth", "line", 20000, set_up_thin_lines,
          lines),
    scene("lines_wide", "10,000 lines of 5 pixels, with depth", "line", 10000, set_up_wide_lines,
          lines),
    scene("lines_smooth", "2,000 antialiased lines of 2 pixels", "line", 2000, set_up_smooth_lines,
          lines, 0.8),
};

}  // namespace

std::span<const Scene> point_and_line_scenes() { return kScenes; }

}  // namespace bench
