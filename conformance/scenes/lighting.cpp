// Lighting (2.14.1) and fog (3.8).
// SPDX-License-Identifier: MIT
#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

namespace {

void ball(const Gl& gl, unsigned arrays = kNormals, float scale = 1) {
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.Translatef(0, 0, -4);
  gl.Rotatef(20, 1, 0.3f, 0);
  gl.Scalef(scale, scale, scale);
  gl.Enable(GL_DEPTH_TEST);
  draw(gl, GL_TRIANGLES, sphere(1.7f / scale, 32, 24), arrays);
}

void light(const Gl& gl, GLenum which, float x, float y, float z, float w, float r, float g,
           float b) {
  const GLfloat position[4] = {x, y, z, w}, colour[4] = {r, g, b, 1};
  const GLfloat dim[4] = {r * 0.1f, g * 0.1f, b * 0.1f, 1};
  gl.Enable(which);
  gl.Lightfv(which, GL_POSITION, position);
  gl.Lightfv(which, GL_DIFFUSE, colour);
  gl.Lightfv(which, GL_SPECULAR, colour);
  gl.Lightfv(which, GL_AMBIENT, dim);
}

void material(const Gl& gl, float shininess) {
  const GLfloat diffuse[4] = {0.8f, 0.6f, 0.7f, 0.9f}, specular[4] = {0.7f, 0.7f, 0.4f, 1};
  const GLfloat ambient[4] = {0.3f, 0.2f, 0.5f, 1}, emission[4] = {0.02f, 0.05f, 0, 1};
  gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT, ambient);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_EMISSION, emission);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, shininess);
}

void lit_stage(const Gl& gl) {
  clear(gl);
  perspective(gl);
  gl.Enable(GL_LIGHTING);
}

// A corridor of coloured plates from near to far.
void corridor(const Gl& gl) {
  clear(gl, 0.6f, 0.7f, 0.8f, 1);
  perspective(gl);
  gl.Enable(GL_DEPTH_TEST);
  Random random(70);
  std::vector<Vertex> vertices;
  for (int i = 0; i < 60; ++i) {
    const float x = random.uniform(-5, 5), y = random.uniform(-5, 5), z = random.uniform(-30, -2);
    std::vector<Vertex> plate = coloured(rectangle(x, y, x + 1.5f, y + 1.5f, z), random.byte(),
                                         random.byte(), random.byte());
    plate[2].z = plate[4].z = z - random.uniform(0, 6);
    vertices.insert(vertices.end(), plate.begin(), plate.end());
  }
  draw(gl, GL_TRIANGLES, vertices);
}

void fog(const Gl& gl, GLenum mode) {
  const GLfloat colour[4] = {0.6f, 0.7f, 0.8f, 1};
  gl.Enable(GL_FOG);
  gl.Fogfv(GL_FOG_COLOR, colour);
  gl.Fogf(GL_FOG_MODE, static_cast<GLfloat>(mode));
  gl.Fogf(GL_FOG_DENSITY, 0.09f);
  gl.Fogf(GL_FOG_START, 4);
  gl.Fogf(GL_FOG_END, 24);
  corridor(gl);
}

}  // namespace

SCENE(lighting, directional, kColours) {
  lit_stage(gl);
  light(gl, GL_LIGHT0, 0.5f, 0.7f, 1, 0, 1, 0.9f, 0.8f);
  material(gl, 24);
  ball(gl);
}

SCENE(lighting, positional_attenuated, kColours) {
  lit_stage(gl);
  light(gl, GL_LIGHT0, 2, 1.5f, -1, 1, 1, 0.9f, 0.8f);
  gl.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 0.5f);
  gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.2f);
  gl.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.05f);
  material(gl, 9);
  ball(gl);
}

SCENE(lighting, spot, kColours) {
  lit_stage(gl);
  light(gl, GL_LIGHT0, 0.4f, 0.2f, 0, 1, 1, 1, 0.8f);
  const GLfloat direction[3] = {-0.1f, 0, -1};
  gl.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
  gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 25);
  gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 12);
  material(gl, 40);
  ball(gl);
}

SCENE(lighting, eight_lights, kColours) {
  lit_stage(gl);
  for (GLenum i = 0; i < 8; ++i) {
    const float f = static_cast<float>(i);
    light(gl, GL_LIGHT0 + i, f - 3.5f, 3 - f, f * 0.4f, i % 2 ? 1.0f : 0.0f, 0.1f + 0.05f * f,
          0.4f - 0.03f * f, 0.2f);
  }
  material(gl, 60);
  ball(gl);
}

SCENE(lighting, two_sided,
      except_at_borders("2.11: the clip plane cuts in eye space, in Mesa in clip space")) {
  lit_stage(gl);
  light(gl, GL_LIGHT0, 0.5f, 0.7f, 1, 0, 1, 0.9f, 0.8f);
  gl.LightModelf(GL_LIGHT_MODEL_TWO_SIDE, 1);
  const GLfloat cut[4] = {0, 0, -1, -3.6f};
  gl.ClipPlanef(GL_CLIP_PLANE0, cut);
  gl.Enable(GL_CLIP_PLANE0);
  material(gl, 24);
  ball(gl);
}

SCENE(lighting, colour_material, kColours) {
  lit_stage(gl);
  light(gl, GL_LIGHT0, -0.5f, 0.7f, 1, 0, 1, 1, 1);
  material(gl, 10);
  gl.Enable(GL_COLOR_MATERIAL);
  ball(gl, kNormals | kColoursArray);
}

SCENE(lighting, flat_shaded, kColours) {
  lit_stage(gl);
  light(gl, GL_LIGHT0, 0.5f, 0.7f, 1, 0, 1, 0.9f, 0.8f);
  material(gl, 24);
  gl.ShadeModel(GL_FLAT);
  ball(gl);
}

SCENE(lighting, normalize, kColours) {
  lit_stage(gl);
  light(gl, GL_LIGHT0, 0.5f, 0.7f, 1, 0, 1, 0.9f, 0.8f);
  material(gl, 24);
  gl.Enable(GL_NORMALIZE);
  ball(gl, kNormals, 0.4f);
}

SCENE(lighting, rescale_normal, kColours) {
  lit_stage(gl);
  light(gl, GL_LIGHT0, 0.5f, 0.7f, 1, 0, 1, 0.9f, 0.8f);
  material(gl, 24);
  gl.Enable(GL_RESCALE_NORMAL);
  ball(gl, kNormals, 2.5f);
}

SCENE(lighting, scene_ambient_alone, kColours) {
  lit_stage(gl);
  const GLfloat ambient[4] = {0.9f, 0.5f, 0.3f, 1};
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  material(gl, 1);
  ball(gl);
}

SCENE(fog, linear, kColours) { fog(gl, GL_LINEAR); }
SCENE(fog, exp, kColours) { fog(gl, GL_EXP); }
SCENE(fog, exp2, kColours) { fog(gl, GL_EXP2); }

}  // namespace clearpipe::conformance
