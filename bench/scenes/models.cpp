// SPDX-License-Identifier: MIT
//
// Models that somebody made, with their textures: those of the package glmark2-data.
#include "bench/model.h"
#include "bench/scene.h"
#include "bench/shapes.h"

#include <GLES/glext.h>

#include <array>

namespace bench {

namespace {

Model model;

// Positions, normals and texture coordinates in buffer objects.
void use_model(const char* name) {
  model = read_model(name);
  GLuint buffers[4];
  glGenBuffers(4, buffers);
  const auto fill = [&](int i, GLenum kind, const auto& list) {
    glBindBuffer(kind, buffers[i]);
    glBufferData(kind, GLsizeiptr(list.size() * sizeof(list[0])), list.data(), GL_STATIC_DRAW);
  };
  fill(0, GL_ARRAY_BUFFER, model.positions);
  glVertexPointer(3, GL_FLOAT, 0, nullptr);
  glEnableClientState(GL_VERTEX_ARRAY);
  fill(1, GL_ARRAY_BUFFER, model.normals);
  glNormalPointer(GL_FLOAT, 0, nullptr);
  glEnableClientState(GL_NORMAL_ARRAY);
  if (!model.coordinates.empty()) {
    fill(2, GL_ARRAY_BUFFER, model.coordinates);
    for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE1}) {
      glClientActiveTexture(unit);
      glTexCoordPointer(2, GL_FLOAT, 0, nullptr);
      glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    }
  }
  fill(3, GL_ELEMENT_ARRAY_BUFFER, model.indices);
}

void use_light() {
  const GLfloat position[] = {0.4f, 0.8f, 0.6f, 0}, ambient[] = {0.4f, 0.4f, 0.4f, 1};
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_NORMALIZE);
  glLightfv(GL_LIGHT0, GL_POSITION, position);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
}

void draw_model() {
  glDrawElements(GL_TRIANGLES, GLsizei(model.indices.size()), GL_UNSIGNED_INT, nullptr);
}

// A swarm of jellyfish: their own texture, light patterns of water on it, blended, both sides seen.
double set_up_jellyfish(const View& view) {
  set_perspective(view.width, view.height, 45, 1, 100);
  use_light();
  use_model("jellyfish.jobj");
  use_picture("jellyfish256.png");
  glActiveTexture(GL_TEXTURE1);
  use_picture("jellyfish-caustics-01.png");
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
  glActiveTexture(GL_TEXTURE0);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_DEPTH_TEST);
  return double(view.amount) * double(model.indices.size()) / 3;
}

void jellyfish(const View& view, int number) {
  glClearColor(0.05f, 0.2f, 0.35f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (int i = 0; i < view.amount; ++i) {
    glLoadIdentity();
    glTranslatef(4.2f * float(i % 3 - 1), 2.8f * (1 - float(i / 3)), -12 - float(i));
    glRotatef(float(number % 90) + 70 * float(i), 0.2f, 1, 0.1f);
    draw_model();
  }
}

double set_up_bunny(const View& view) {
  const GLfloat shine[] = {0.4f, 0.4f, 0.4f, 1};
  set_perspective(view.width, view.height, 40, 1, 20);
  use_light();
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 30);
  use_model("bunny.obj");
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  return double(model.indices.size()) / 3;
}

void bunny(const View&, int number) {
  glClearColor(0.2f, 0.25f, 0.2f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glLoadIdentity();
  glTranslatef(0, 0, -3.4f);
  glRotatef(float(number % 90), 0, 1, 0);
  draw_model();
}

constexpr std::array kScenes = {
    Scene{.name = "model_jellyfish",
          .what = "9 jellyfish of 4,400 triangles, two textures, lit, blended",
          .unit = "triangle",
          .amount = 9,
          .set_up = set_up_jellyfish,
          .frame = jellyfish,
          .share = 0.95},
    Scene{.name = "model_bunny",
          .what = "69,666 triangles, lit, one side culled",
          .unit = "triangle",
          .amount = 0,
          .set_up = set_up_bunny,
          .frame = bunny,
          .share = 0.98},
};

}  // namespace

std::span<const Scene> model_scenes() { return kScenes; }

}  // namespace bench
