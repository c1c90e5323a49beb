// Objects that hold arrays, and lists of draws: OES_mapbuffer, EXT_map_buffer_range,
// OES_vertex_array_object, EXT_multi_draw_arrays. OSMesa's desktop GL has them under other names,
// so the reference is Mesa's OpenGL ES 1.1. SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>

#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

namespace {

const void* at(size_t offset) { return reinterpret_cast<const void*>(offset); }

// Random triangles of one colour each, in a part of the window.
std::vector<Vertex> triangles(uint32_t seed, float low, float high) {
  Random random(seed);
  std::vector<Vertex> vertices(3 * 12);
  for (size_t i = 0; i < vertices.size(); ++i) {
    Vertex& v = vertices[i];
    v.x = random.uniform(low, high);
    v.y = random.uniform(8, 248);
    v.r = i % 3 == 0 ? random.byte() : vertices[i - i % 3].r;
    v.g = i % 3 == 0 ? random.byte() : vertices[i - i % 3].g;
    v.b = i % 3 == 0 ? random.byte() : vertices[i - i % 3].b;
  }
  return vertices;
}

GLuint buffer(const Gl& gl, const std::vector<Vertex>& vertices) {
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  gl.BindBuffer(GL_ARRAY_BUFFER, name);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                vertices.data(), GL_STATIC_DRAW);
  return name;
}

// The arrays of the bound buffer.
void point_at_buffer(const Gl& gl) {
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(4, GL_FLOAT, sizeof(Vertex), at(offsetof(Vertex, x)));
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), at(offsetof(Vertex, r)));
}

}  // namespace

// What is written to a mapped buffer between two draws shows in the second only.
ES_SCENE(objects, mapped_buffers, kExact) {
  clear(gl);
  pixel_projection(gl);
  std::vector<Vertex> vertices = triangles(203, 4, 126);
  const auto bytes = static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex));
  buffer(gl, vertices);
  point_at_buffer(gl);
  gl.DrawArrays(GL_TRIANGLES, 0, 36);
  const std::vector<Vertex> other = triangles(204, 130, 252);
  if (void* mapped = gl.MapBufferOES(GL_ARRAY_BUFFER, GL_WRITE_ONLY_OES)) {
    std::copy(other.begin(), other.end(), static_cast<Vertex*>(mapped));
  }
  gl.UnmapBufferOES(GL_ARRAY_BUFFER);
  gl.DrawArrays(GL_TRIANGLES, 0, 18);
  const GLsizeiptr half = bytes / 2;
  if (void* mapped = gl.MapBufferRangeEXT(GL_ARRAY_BUFFER, half, half,
                                          GL_MAP_WRITE_BIT_EXT | GL_MAP_FLUSH_EXPLICIT_BIT_EXT)) {
    const std::vector<Vertex> quads = coloured(rectangle(100, 20, 156, 60), 250, 250, 90);
    std::copy(quads.begin(), quads.end(), static_cast<Vertex*>(mapped));
    gl.FlushMappedBufferRangeEXT(GL_ARRAY_BUFFER, 0,
                                 static_cast<GLsizeiptr>(quads.size() * sizeof(Vertex)));
  }
  gl.UnmapBufferOES(GL_ARRAY_BUFFER);
  gl.DrawArrays(GL_TRIANGLES, 18, 6);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
}

ES_SCENE(objects, lists_of_draws, kExact) {
  clear(gl);
  pixel_projection(gl);
  const std::vector<Vertex> vertices = triangles(205, 4, 252);
  draw(gl, GL_TRIANGLES, {vertices.begin(), vertices.begin() + 3});
  gl.VertexPointer(4, GL_FLOAT, sizeof(Vertex), &vertices[0].x);
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), &vertices[0].r);
  const GLint first[] = {3, 0, 9};
  const GLsizei count[] = {3, 0, 6};
  gl.MultiDrawArraysEXT(GL_TRIANGLES, first, count, 3);
  const uint8_t strip[] = {20, 19, 18, 21}, fan[] = {24, 25, 26, 27, 28};
  const void* const indices[] = {strip, fan};
  const GLsizei lengths[] = {4, 5};
  gl.ShadeModel(GL_FLAT);
  gl.MultiDrawElementsEXT(GL_TRIANGLE_FAN, lengths, GL_UNSIGNED_BYTE, indices, 2);
}

}  // namespace clearpipe::conformance
