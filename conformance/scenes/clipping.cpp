// Clipping (2.12): every plane of the view volume, the eye, user clip planes.
// SPDX-License-Identifier: MIT
#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

namespace {

// Random triangles around a point of clip coordinates, flat.
void draw_around(const Gl& gl, uint32_t seed, float x, float y, float z, float spread) {
  clear(gl);
  gl.ShadeModel(GL_FLAT);
  Random random(seed);
  std::vector<Vertex> vertices(90);
  for (Vertex& v : vertices) {
    v.x = x + random.uniform(-spread, spread);
    v.y = y + random.uniform(-spread, spread);
    v.z = z + random.uniform(-spread, spread);
    v.r = random.byte();
    v.g = random.byte();
    v.b = random.byte();
  }
  draw(gl, GL_TRIANGLES, vertices);
}

// Triangles in the frustum of `perspective`, many of them across its planes.
std::vector<Vertex> through_the_eye(uint32_t seed, int count) {
  Random random(seed);
  std::vector<Vertex> vertices(static_cast<size_t>(count) * 3);
  for (Vertex& v : vertices) {
    v.x = random.uniform(-6, 6);
    v.y = random.uniform(-6, 6);
    v.z = random.uniform(-12, 3);
    v.r = random.byte();
    v.g = random.byte();
    v.b = random.byte();
  }
  return vertices;
}

}  // namespace

SCENE(clipping, left, kExact) { draw_around(gl, 21, -1, 0, 0, 0.8f); }
SCENE(clipping, right, kExact) { draw_around(gl, 22, 1, 0, 0, 0.8f); }
SCENE(clipping, bottom, kExact) { draw_around(gl, 23, 0, -1, 0, 0.8f); }
SCENE(clipping, top, kExact) { draw_around(gl, 24, 0, 1, 0, 0.8f); }
SCENE(clipping, near_plane, kExact) { draw_around(gl, 25, 0, 0, -1, 0.8f); }
SCENE(clipping, far_plane, kExact) { draw_around(gl, 26, 0, 0, 1, 0.8f); }
SCENE(clipping, all_planes, kExact) { draw_around(gl, 27, 0, 0, 0, 3); }

SCENE(clipping, through_the_eye, kExact) {
  clear(gl);
  perspective(gl);
  gl.ShadeModel(GL_FLAT);
  draw(gl, GL_TRIANGLES, through_the_eye(28, 24));
}

SCENE(clipping, smooth_through_the_eye, kColours) {
  clear(gl);
  perspective(gl);
  gl.Enable(GL_DEPTH_TEST);
  draw(gl, GL_TRIANGLES, through_the_eye(29, 24));
}

SCENE(clipping, lines, kExact) {
  clear(gl);
  perspective(gl);
  gl.ShadeModel(GL_FLAT);
  draw(gl, GL_LINES, through_the_eye(30, 30));
}

SCENE(clipping, points, kExact) {
  clear(gl);
  perspective(gl);
  gl.PointSize(9);
  draw(gl, GL_POINTS, through_the_eye(31, 200));
}

SCENE(clipping, huge_triangles, kExact) {
  clear(gl);
  pixel_projection(gl);
  gl.ShadeModel(GL_FLAT);
  Random random(32);
  std::vector<Vertex> vertices(60);
  for (Vertex& v : vertices) {
    v.x = random.uniform(-40000, 40000);
    v.y = random.uniform(-40000, 40000);
    v.r = random.byte();
    v.g = random.byte();
    v.b = random.byte();
  }
  draw(gl, GL_TRIANGLES, vertices);
}

// Planes given in object space, transformed by the inverse modelview matrix (2.12).
SCENE(clipping, user_planes, kColours) {
  clear(gl);
  perspective(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Translatef(0, 0, -4);
  gl.Rotatef(25, 0, 1, 0);
  const GLfloat side[4] = {1, 0.3f, 0, 0.6f}, lid[4] = {0, -1, 0.2f, 0.9f};
  gl.ClipPlanef(GL_CLIP_PLANE0, side);
  gl.ClipPlanef(GL_CLIP_PLANE1, lid);
  gl.Enable(GL_CLIP_PLANE0);
  gl.Enable(GL_CLIP_PLANE1);
  gl.Rotatef(40, 1, 0, 0);
  draw(gl, GL_TRIANGLES, sphere(1.5f, 24, 16));
}

}  // namespace clearpipe::conformance
