// See draw.h.
// SPDX-License-Identifier: MIT
#include "conformance/scenes/draw.h"

#include <cmath>

namespace clearpipe::conformance {

namespace {

void point_arrays(const Gl& gl, const std::vector<Vertex>& vertices, unsigned arrays) {
  const Vertex* v = vertices.data();
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(4, GL_FLOAT, sizeof(Vertex), &v->x);
  const auto toggle = [&](GLenum which, bool on) {
    (on ? gl.EnableClientState : gl.DisableClientState)(which);
  };
  toggle(GL_COLOR_ARRAY, arrays & kColoursArray);
  if (arrays & kColoursArray) gl.ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), &v->r);
  toggle(GL_TEXTURE_COORD_ARRAY, arrays & kTexCoords);
  if (arrays & kTexCoords) gl.TexCoordPointer(2, GL_FLOAT, sizeof(Vertex), &v->s);
  toggle(GL_NORMAL_ARRAY, arrays & kNormals);
  if (arrays & kNormals) gl.NormalPointer(GL_FLOAT, sizeof(Vertex), &v->nx);
}

}  // namespace

void draw(const Gl& gl, GLenum mode, const std::vector<Vertex>& vertices, unsigned arrays) {
  point_arrays(gl, vertices, arrays);
  gl.DrawArrays(mode, 0, static_cast<GLsizei>(vertices.size()));
}

void draw_indexed(const Gl& gl, GLenum mode, const std::vector<Vertex>& vertices,
                  const std::vector<uint16_t>& indices, unsigned arrays) {
  point_arrays(gl, vertices, arrays);
  gl.DrawElements(mode, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_SHORT, indices.data());
}

void clear(const Gl& gl, float r, float g, float b, float a) {
  gl.ClearColor(r, g, b, a);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void pixel_projection(const Gl& gl, int width, int height) {
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Orthof(0, static_cast<float>(width), 0, static_cast<float>(height), -1, 1);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
}

void perspective(const Gl& gl) {
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Frustumf(-0.57735f, 0.57735f, -0.57735f, 0.57735f, 1, 50);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
}

std::vector<Vertex> rectangle(float x0, float y0, float x1, float y1, float z, float s0, float t0,
                              float s1, float t1) {
  const auto corner = [&](bool right, bool top) {
    Vertex v;
    v.x = right ? x1 : x0;
    v.y = top ? y1 : y0;
    v.z = z;
    v.s = right ? s1 : s0;
    v.t = top ? t1 : t0;
    return v;
  };
  const Vertex a = corner(false, false), b = corner(true, false), c = corner(true, true),
               d = corner(false, true);
  return {a, b, c, a, c, d};
}

void textured_plate(const Gl& gl, float repeat) {
  clear(gl);
  perspective(gl);
  gl.Enable(GL_TEXTURE_2D);
  gl.Translatef(0, -0.6f, -1.2f);
  gl.Rotatef(-72, 1, 0, 0);
  gl.Rotatef(17, 0, 0, 1);
  draw(gl, GL_TRIANGLES, rectangle(-2.2f, -1, 2.2f, 12, 0, -0.3f, -0.2f, repeat, repeat * 3),
       kTexCoords);
}

std::vector<Vertex> lines_between_pixels() {
  constexpr int kReach = 4, kCell = 12, kQuarter = 128;
  std::vector<Vertex> lines;
  for (int place = 0; place < 4; ++place) {
    const float offset = 0.25f * static_cast<float>(place);
    for (int dy = -kReach; dy <= kReach; ++dy) {
      for (int dx = -kReach; dx <= kReach; ++dx) {
        Vertex from;
        from.x = static_cast<float>(kQuarter * (place % 2) + kCell * (dx + kReach) + 9) + offset;
        from.y = static_cast<float>(kQuarter * (place / 2) + kCell * (dy + kReach) + 9) + offset;
        Vertex to = from;
        to.x += static_cast<float>(dx);
        to.y += static_cast<float>(dy);
        lines.insert(lines.end(), {from, to});
      }
    }
  }
  return lines;
}

std::vector<Vertex> coloured(std::vector<Vertex> vertices, uint8_t r, uint8_t g, uint8_t b,
                             uint8_t a) {
  for (Vertex& v : vertices) {
    v.r = r;
    v.g = g;
    v.b = b;
    v.a = a;
  }
  return vertices;
}

std::vector<Vertex> sphere(float radius, int slices, int stacks) {
  constexpr float kPi = 3.14159265f;
  const auto at = [&](int slice, int stack) {
    const float u = static_cast<float>(slice) / static_cast<float>(slices);
    const float v = static_cast<float>(stack) / static_cast<float>(stacks);
    const float longitude = 2 * kPi * u, latitude = kPi * (v - 0.5f);
    Vertex vertex;
    vertex.nx = std::cos(latitude) * std::cos(longitude);
    vertex.ny = std::sin(latitude);
    vertex.nz = std::cos(latitude) * std::sin(longitude);
    vertex.x = radius * vertex.nx;
    vertex.y = radius * vertex.ny;
    vertex.z = radius * vertex.nz;
    vertex.s = u;
    vertex.t = v;
    vertex.r = static_cast<uint8_t>(255 * u);
    vertex.g = static_cast<uint8_t>(255 * v);
    vertex.b = 128;
    return vertex;
  };
  std::vector<Vertex> triangles;
  for (int stack = 0; stack < stacks; ++stack) {
    for (int slice = 0; slice < slices; ++slice) {
      const Vertex a = at(slice, stack), b = at(slice + 1, stack), c = at(slice + 1, stack + 1),
                   d = at(slice, stack + 1);
      // Counter-clockwise from outside.
      triangles.insert(triangles.end(), {a, c, b, a, d, c});
    }
  }
  return triangles;
}

GLuint noise_texture(const Gl& gl, int width, int height, uint32_t seed, bool mipmaps) {
  Random random(seed);
  std::vector<uint8_t> texels;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      texels.push_back(static_cast<uint8_t>((x * 255 / width + random.byte()) / 2));
      texels.push_back(static_cast<uint8_t>((y * 255 / height + random.byte()) / 2));
      texels.push_back(random.byte());
      texels.push_back(random.byte());
    }
  }
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, mipmaps ? GL_TRUE : GL_FALSE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                   mipmaps ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                texels.data());
  return texture;
}

}  // namespace clearpipe::conformance
