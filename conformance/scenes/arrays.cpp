// Vertex arrays and buffer objects (2.8, 2.9): types, strides, current values, buffers; points
// whose size comes from an array or from the distance (3.3). SPDX-License-Identifier: MIT
#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

namespace {

// Triangles with integer coordinates within +-120, which every type can hold.
std::vector<int> integer_positions(uint32_t seed, int vertices) {
  Random random(seed);
  std::vector<int> result;
  for (int i = 0; i < vertices * 2; ++i) {
    result.push_back(static_cast<int>(random.below(240)) - 120);
  }
  return result;
}

template <class Type>
std::vector<Type> as(const std::vector<int>& values, int scale) {
  std::vector<Type> result;
  for (const int value : values) result.push_back(static_cast<Type>(value * scale));
  return result;
}

void stage(const Gl& gl) {
  clear(gl);
  gl.MatrixMode(GL_PROJECTION);
  gl.Orthof(-128, 128, -128, 128, -1, 1);
  gl.MatrixMode(GL_MODELVIEW);
  gl.ShadeModel(GL_FLAT);
}

// Flat triangles whose corners come in another type of array; the colours as well.
template <class Type>
void typed(const Gl& gl, GLenum type, int scale) {
  stage(gl);
  gl.Rotatef(11, 0, 0, 1);
  const std::vector<Type> positions = as<Type>(integer_positions(200, 60), scale);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(2, type, 0, positions.data());
  for (int i = 0; i < 20; ++i) {
    const GLubyte shade = static_cast<GLubyte>(i * 12);
    gl.Color4ub(shade, 250 - shade, shade / 2, 255);
    gl.DrawArrays(GL_TRIANGLES, i * 3, 3);
  }
}

}  // namespace

SCENE(arrays, bytes, kExact) { typed<GLbyte>(gl, GL_BYTE, 1); }
SCENE(arrays, shorts, kExact) { typed<GLshort>(gl, GL_SHORT, 1); }
SCENE(arrays, fixed, kExact) { typed<GLfixed>(gl, GL_FIXED, 65536); }
SCENE(arrays, floats, kExact) { typed<GLfloat>(gl, GL_FLOAT, 1); }

SCENE(arrays, buffer_objects, kExact) {
  stage(gl);
  const std::vector<GLshort> positions = as<GLshort>(integer_positions(201, 90), 1);
  Random random(202);
  std::vector<GLubyte> colours(90 * 4);
  for (GLubyte& c : colours) c = random.byte();
  std::vector<GLushort> indices(120);
  for (GLushort& index : indices) index = static_cast<GLushort>(random.below(90));
  GLuint buffers[2];
  gl.GenBuffers(2, buffers);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  const GLsizeiptr position_bytes = static_cast<GLsizeiptr>(positions.size() * sizeof(GLshort));
  gl.BufferData(GL_ARRAY_BUFFER, position_bytes + 360, nullptr, GL_STATIC_DRAW);
  gl.BufferSubData(GL_ARRAY_BUFFER, 0, position_bytes, positions.data());
  gl.BufferSubData(GL_ARRAY_BUFFER, position_bytes, 360, colours.data());
  gl.VertexPointer(2, GL_SHORT, 0, nullptr);
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, reinterpret_cast<const void*>(position_bytes));
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, 240, indices.data(), GL_STATIC_DRAW);
  gl.DrawElements(GL_TRIANGLES, 60, GL_UNSIGNED_SHORT, nullptr);
  gl.DrawElements(GL_LINES, 40, GL_UNSIGNED_SHORT, reinterpret_cast<const void*>(160));
}

SCENE(arrays, fixed_normals_and_colours, kColours) {
  clear(gl);
  perspective(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_COLOR_MATERIAL);
  gl.Translatef(0, 0, -4);
  const std::vector<Vertex> ball = sphere(1.6f, 24, 16);
  std::vector<GLfixed> normals, colours;
  for (const Vertex& v : ball) {
    for (const float c : {v.nx, v.ny, v.nz}) normals.push_back(static_cast<GLfixed>(c * 65536));
    for (const uint8_t c : {v.r, v.g, v.b, v.a}) colours.push_back(c * 257);
  }
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_NORMAL_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, sizeof(Vertex), &ball[0].x);
  gl.NormalPointer(GL_FIXED, 0, normals.data());
  gl.ColorPointer(4, GL_FIXED, 0, colours.data());
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(ball.size()));
}

SCENE(arrays, point_sizes, kExact) {
  stage(gl);
  const std::vector<GLshort> positions = as<GLshort>(integer_positions(203, 80), 1);
  Random random(205);
  std::vector<GLfloat> sizes(80);
  for (GLfloat& size : sizes) size = 0.7f + 0.25f * static_cast<float>(random.below(120));
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_POINT_SIZE_ARRAY_OES);
  gl.VertexPointer(2, GL_SHORT, 0, positions.data());
  gl.PointSizePointerOES(GL_FLOAT, 0, sizes.data());
  for (int i = 0; i < 80; i += 8) {
    gl.Color4ub(static_cast<GLubyte>(i * 3), 180, 80, 255);
    gl.DrawArrays(GL_POINTS, i, 8);
  }
}

// Attenuated points along the axis of sight, where the distance is the depth in Mesa as well.
SCENE(arrays, point_attenuation, kExact) {
  clear(gl);
  perspective(gl);
  const GLfloat attenuation[3] = {0.1f, 0.02f, 0.013f};
  gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
  gl.PointParameterf(GL_POINT_SIZE_MIN, 2);
  gl.PointParameterf(GL_POINT_SIZE_MAX, 33);
  gl.PointSize(25);
  std::vector<Vertex> points;
  for (int i = 0; i < 12; ++i) {
    Vertex v;
    v.z = -1.3f - 2.9f * static_cast<float>(11 - i);
    v.r = static_cast<uint8_t>(20 * i);
    points.push_back(v);
  }
  for (const Vertex& point : points) {
    gl.Viewport(static_cast<GLint>(&point - points.data()) * 20 - 110, 8, 256, 256);
    draw(gl, GL_POINTS, {point});
  }
}

}  // namespace clearpipe::conformance
