// SPDX-License-Identifier: MIT
//
// What happens to a fragment after its colour: blending in layers, fog with the alpha test, stencil
// passes, masks.
#include "bench/scene.h"
#include "bench/shapes.h"

#include <array>

namespace bench {

namespace {

constexpr int kBlendedLayers = 16;
constexpr int kStencilPasses = 4;

double set_up_blend(const View& view) {
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  use_corner_colours(40);
  return view.pixels();
}

// Over what the frame before left, which has to be read; frame 0 starts anew.
void blend(const View&, int number) {
  if (number == 0) glClear(GL_COLOR_BUFFER_BIT);
  draw_whole();
}

double set_up_blend_16(const View& view) {
  set_up_blend(view);
  return kBlendedLayers * view.pixels();
}

void blend_16(const View&, int) {
  glClear(GL_COLOR_BUFFER_BIT);
  for (int i = 0; i < kBlendedLayers; ++i) {
    use_corner_colours(GLubyte(20 + 4 * i));
    draw_whole();
  }
}

double set_up_blend_textures(const View& view) {
  use_noise_texture(1, {.smooth = true});
  use_corner_coordinates(0, 3);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glColor4f(1, 0.9f, 0.8f, 0.7f);
  return 4 * view.pixels();
}

void blend_textures(const View&, int) {
  glClear(GL_COLOR_BUFFER_BIT);
  for (int i = 0; i < 4; ++i) {
    use_corner_coordinates(0, 2 + 0.5f * float(i));
    draw_whole();
  }
}

// A field of leaves that fades away: a textured plane in perspective, fog, and the alpha test. The
// plane is as wide as the view everywhere, and ends at the horizon.
double set_up_fog(const View& view) {
  static const GLfloat fog_colour[] = {0.6f, 0.7f, 0.8f, 1};
  set_perspective(view.width, view.height, 60, 0.5f, 60);
  use_noise_texture(
      5, {.size = 128, .min = GL_NEAREST, .mag = GL_LINEAR, .mipmaps = false, .smooth = true});
  glEnable(GL_FOG);
  glFogf(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 1);
  glFogf(GL_FOG_END, 40);
  glFogfv(GL_FOG_COLOR, fog_colour);
  glEnable(GL_ALPHA_TEST);
  glAlphaFunc(GL_GREATER, 0.4f);
  glEnable(GL_DEPTH_TEST);
  return view.pixels();
}

void draw_fog(const View&, int) {
  static const GLfloat corners[] = {-60, -1, 1, 60, -1, 1, -60, 30, -55, 60, 30, -55};
  static const GLfloat coordinates[] = {0, 0, 24, 0.3f, -0.3f, 12, 24, 12.6f};
  glClearColor(0.6f, 0.7f, 0.8f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, corners);
  glTexCoordPointer(2, GL_FLOAT, 0, coordinates);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

// As shadows are drawn: shapes that only count in the stencil buffer, then a dark rectangle where
// the count is odd.
double set_up_stencil(const View& view) {
  glEnable(GL_STENCIL_TEST);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  return (kStencilPasses + 2) * view.pixels();
}

void draw_stencil(const View&, int) {
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glStencilFunc(GL_ALWAYS, 0, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  use_corner_colours();
  draw_whole(0.5f);

  glDisableClientState(GL_COLOR_ARRAY);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDepthMask(GL_FALSE);
  for (int i = 0; i < kStencilPasses; ++i) {
    glStencilOp(GL_KEEP, GL_KEEP, i % 2 == 0 ? GL_INCR : GL_INVERT);
    glPushMatrix();
    glRotatef(20.0f * float(i), 0, 0, 1);
    draw_whole(0.4f);
    glPopMatrix();
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);

  glStencilFunc(GL_EQUAL, 1, 1);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glColor4f(0.1f, 0.1f, 0.3f, 1);
  draw_whole(0.5f);
}

double set_up_logic_op(const View& view) {
  use_corner_colours();
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_XOR);
  return view.pixels();
}

void logic_op(const View&, int) {
  glClearColor(0.2f, 0.4f, 0.6f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  draw_whole();
}

// Differences of 1/255 add up in layers, and exclusive or makes more of them.
constexpr std::array kScenes = {
    Scene{.name = "blend",
          .what = "one blended rectangle of four colours",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_blend,
          .frame = blend,
          .bytes = 4,
          .traffic = "update"},
    Scene{.name = "blend_16",
          .what = "16 layers of blended rectangles",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_blend_16,
          .frame = blend_16,
          .share = 0.99},
    Scene{.name = "blend_textures",
          .what = "4 layers of blended bilinear textures",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_blend_textures,
          .frame = blend_textures},
    Scene{.name = "fog_alpha_test",
          .what = "a textured plane in fog, with alpha and depth tests",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_fog,
          .frame = draw_fog,
          .share = 0.99},
    Scene{.name = "stencil",
          .what = "4 passes that count in the stencil buffer, and one that asks it",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_stencil,
          .frame = draw_stencil},
    Scene{.name = "logic_op",
          .what = "a rectangle of four colours, exclusive-ored",
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up_logic_op,
          .frame = logic_op,
          .share = 0.95},
};

}  // namespace

std::span<const Scene> fragment_scenes() { return kScenes; }

}  // namespace bench
