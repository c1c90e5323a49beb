// SPDX-License-Identifier: MIT
//
// Many small draws in a frame: what a call costs, and what a change of state before it does.
#include "bench/scene.h"
#include "bench/shapes.h"

#include <array>
#include <cmath>
#include <vector>

namespace bench {

namespace {

constexpr GLfloat kCorners[] = {-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0};
constexpr GLfloat kCoordinates[] = {0, 0, 1, 0, 0, 1, 1, 1};

GLuint textures[2];

double set_up(const View& view) {
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, kCorners);
  glTexCoordPointer(2, GL_FLOAT, 0, kCoordinates);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  return view.amount;
}

// Draw i of a frame has a place in a square of draws; its rectangle is some pixels wide.
void move_to(const View& view, int i) {
  const int columns = int(std::ceil(std::sqrt(float(view.amount))));
  const float step = 2 / float(columns);
  glLoadIdentity();
  glTranslatef(-1 + step * (0.5f + float(i % columns)), -1 + step * (0.5f + float(i / columns)), 0);
  glScalef(0.35f * step, 0.35f * step, 1);
}

void start() {
  glClearColor(0.1f, 0.1f, 0.1f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void set_colour(int i) {
  glColor4ub(GLubyte(60 + 37 * i % 190), GLubyte(60 + 71 * i % 190), GLubyte(60 + 13 * i % 190),
             200);
}

// One call after another with nothing between them: parts of one array, which hold all places.
std::vector<GLfloat> places;

double set_up_same_state(const View& view) {
  const int columns = int(std::ceil(std::sqrt(float(view.amount))));
  const float step = 2 / float(columns), size = 0.7f * step;
  places.reserve(size_t(view.amount) * 12);
  for (int i = 0; i < view.amount; ++i) {
    const float x = -1 + step * (0.15f + float(i % columns));
    const float y = -1 + step * (0.15f + float(i / columns));
    places.insert(places.end(), {x, y, 0, x + size, y, 0, x, y + size, 0, x + size, y + size, 0});
  }
  set_up(view);
  glVertexPointer(3, GL_FLOAT, 0, places.data());
  return view.amount;
}

void same_state(const View& view, int number) {
  start();
  set_colour(number);
  for (int i = 0; i < view.amount; ++i) glDrawArrays(GL_TRIANGLE_STRIP, 4 * i, 4);
}

void own_matrix(const View& view, int) {
  start();
  for (int i = 0; i < view.amount; ++i) {
    move_to(view, i);
    set_colour(i);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
}

void blending_flips(const View& view, int) {
  start();
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (int i = 0; i < view.amount; ++i) {
    i % 2 == 0 ? glEnable(GL_BLEND) : glDisable(GL_BLEND);
    move_to(view, i);
    set_colour(i);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
}

double set_up_textures(const View& view) {
  textures[0] = use_noise_texture(1, {.size = 64, .smooth = true});
  textures[1] = use_noise_texture(2, {.size = 64, .smooth = true});
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  return set_up(view);
}

void textures_change(const View& view, int) {
  start();
  for (int i = 0; i < view.amount; ++i) {
    glBindTexture(GL_TEXTURE_2D, textures[i % 2]);
    move_to(view, i);
    set_colour(i);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
}

// The state of draw i: a different one from that of the draw before, of sixty-four.
void set_state(int i) {
  static const GLenum depth[] = {GL_LEQUAL, GL_ALWAYS, GL_LESS, GL_NOTEQUAL};
  static const GLint environment[] = {GL_MODULATE, GL_DECAL, GL_BLEND, GL_REPLACE};
  i % 2 == 0 ? glEnable(GL_BLEND) : glDisable(GL_BLEND);
  i / 2 % 2 == 0 ? glEnable(GL_ALPHA_TEST) : glDisable(GL_ALPHA_TEST);
  glDepthFunc(depth[i / 4 % 4]);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, environment[i / 16 % 4]);
}

void states_change(const View& view, int) {
  start();
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glAlphaFunc(GL_GREATER, 0.25f);
  for (int i = 0; i < view.amount; ++i) {
    set_state(i * 5);
    glBindTexture(GL_TEXTURE_2D, textures[i / 2 % 2]);
    move_to(view, i);
    set_colour(i);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
}

// Each frame, one state that no frame before had: numbers that shaders have compiled into them,
// and kinds of everything else, changed as a game does from level to level. The frames are alike
// otherwise, so that the slowest of them shows what a new state costs.
double set_up_new_states(const View& view) {
  set_up_textures(view);
  glActiveTexture(GL_TEXTURE1);
  use_noise_texture(3, {.size = 64, .smooth = true});
  glClientActiveTexture(GL_TEXTURE1);
  glTexCoordPointer(2, GL_FLOAT, 0, kCoordinates);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  return 1;
}

void new_state(const View& view, int number) {
  static const GLint functions[] = {GL_MODULATE,    GL_REPLACE,  GL_ADD,     GL_ADD_SIGNED,
                                    GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB};
  static const GLenum factors[] = {GL_ONE, GL_SRC_ALPHA, GL_DST_COLOR, GL_ONE_MINUS_DST_ALPHA};
  start();
  int n = number;
  const auto digit = [&n](int base) {
    const int result = n % base;
    n /= base;
    return result;
  };
  for (int unit = 0; unit < 2; ++unit) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, functions[digit(7)]);
  }
  glEnable(GL_BLEND);
  glBlendFunc(factors[digit(4)], GL_ONE_MINUS_SRC_ALPHA);
  digit(2) == 0 ? glEnable(GL_ALPHA_TEST) : glDisable(GL_ALPHA_TEST);
  glAlphaFunc(GLenum(GL_NEVER + 1 + digit(7)), 0.3f);
  digit(2) == 0 ? glEnable(GL_FOG) : glDisable(GL_FOG);
  for (int i = 0; i < view.amount; ++i) {
    move_to(view, i);
    set_colour(i);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
}

// The same with three states in turns, which the frames before the measured ones have shown.
void seen_state(const View& view, int number) { new_state(view, number % 3); }

constexpr int kDraws = 5000;

constexpr Scene scene(const char* name, const char* what, double (*prepare)(const View&),
                      void (*frame)(const View&, int)) {
  return {.name = name,
          .what = what,
          .unit = "draw",
          .amount = kDraws,
          .set_up = prepare,
          .frame = frame,
          .share = 0.99};
}

constexpr std::array kScenes = {
    scene("draws_same_state", "5,000 draws of 2 triangles, with nothing between them",
          set_up_same_state, same_state),
    scene("draws_own_matrix", "5,000 draws, each with its matrix and colour", set_up, own_matrix),
    scene("draws_blending_flips", "the same, and blending flips", set_up, blending_flips),
    scene("draws_textures_change", "the same, and the texture changes", set_up_textures,
          textures_change),
    scene("draws_states_change", "5,000 draws, each with another of 64 states", set_up_textures,
          states_change),
    Scene{.name = "states_new",
          .what = "frames of 64 draws, each frame in a state that none before had",
          .unit = "frame",
          .amount = 64,
          .set_up = set_up_new_states,
          .frame = new_state,
          .share = 0.99},
    Scene{.name = "states_seen",
          .what = "the same, each frame in one of three states",
          .unit = "frame",
          .amount = 64,
          .set_up = set_up_new_states,
          .frame = seen_state,
          .share = 0.99},
};

}  // namespace

std::span<const Scene> draw_scenes() { return kScenes; }

}  // namespace bench
