// Every primitive type (2.6.1) and the coverage of points, lines and polygons (3.3 to 3.5), flat
// and opaque: the pixels must be the same ones.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

namespace {

std::vector<Vertex> random_vertices(uint32_t seed, int count, float margin = 0) {
  Random random(seed);
  std::vector<Vertex> vertices(static_cast<size_t>(count));
  for (Vertex& v : vertices) {
    v.x = random.uniform(margin, 256 - margin);
    v.y = random.uniform(margin, 256 - margin);
    v.r = random.byte();
    v.g = random.byte();
    v.b = random.byte();
  }
  return vertices;
}

// A ring around the middle, so that strips and fans make sense.
std::vector<Vertex> ring(int count, float radius) {
  Random random(3);
  std::vector<Vertex> vertices(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    Vertex& v = vertices[static_cast<size_t>(i)];
    const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(count);
    v.x = 128.3f + radius * std::cos(angle);
    v.y = 127.6f + radius * std::sin(angle);
    v.r = random.byte();
    v.g = random.byte();
    v.b = random.byte();
  }
  return vertices;
}

void draw_flat(const Gl& gl, GLenum mode, const std::vector<Vertex>& vertices) {
  clear(gl);
  pixel_projection(gl);
  gl.ShadeModel(GL_FLAT);
  draw(gl, mode, vertices);
}

}  // namespace

SCENE(primitives, points, kExact) { draw_flat(gl, GL_POINTS, random_vertices(1, 400)); }

SCENE(primitives, points_wide, kExact) {
  gl.PointSize(7);
  draw_flat(gl, GL_POINTS, random_vertices(2, 100));
}

SCENE(primitives, lines, kExact) { draw_flat(gl, GL_LINES, random_vertices(4, 80)); }

SCENE(primitives, lines_between_pixels, kExact) { draw_flat(gl, GL_LINES, lines_between_pixels()); }

SCENE(primitives, line_strip, kExact) { draw_flat(gl, GL_LINE_STRIP, random_vertices(5, 40)); }

SCENE(primitives, line_loop, kExact) { draw_flat(gl, GL_LINE_LOOP, ring(17, 100)); }

SCENE(primitives, lines_wide, kExact) {
  gl.LineWidth(5);
  draw_flat(gl, GL_LINES, random_vertices(6, 40));
}

SCENE(primitives, triangles, kExact) { draw_flat(gl, GL_TRIANGLES, random_vertices(7, 90)); }

SCENE(primitives, triangle_strip, kExact) {
  draw_flat(gl, GL_TRIANGLE_STRIP, random_vertices(8, 30));
}

SCENE(primitives, triangle_fan, kExact) {
  std::vector<Vertex> vertices = ring(23, 110);
  Vertex middle;
  middle.x = 120.7f;
  middle.y = 133.2f;
  vertices.insert(vertices.begin(), middle);
  vertices.push_back(vertices[1]);
  draw_flat(gl, GL_TRIANGLE_FAN, vertices);
}

// Triangles of under a pixel to a few pixels: the sample points decide.
SCENE(primitives, small_triangles, kExact) {
  Random random(9);
  std::vector<Vertex> vertices;
  for (int i = 0; i < 3000; ++i) {
    Vertex centre;
    centre.x = random.uniform(0, 256);
    centre.y = random.uniform(0, 256);
    centre.r = random.byte();
    centre.g = random.byte();
    for (int corner = 0; corner < 3; ++corner) {
      Vertex v = centre;
      v.x += random.uniform(-3, 3);
      v.y += random.uniform(-3, 3);
      vertices.push_back(v);
    }
  }
  draw_flat(gl, GL_TRIANGLES, vertices);
}

// Slivers: long, thinner than a pixel.
SCENE(primitives, slivers, kExact) {
  Random random(10);
  std::vector<Vertex> vertices;
  for (int i = 0; i < 200; ++i) {
    Vertex a, b, c;
    a.x = random.uniform(0, 256);
    a.y = random.uniform(0, 256);
    b.x = random.uniform(0, 256);
    b.y = random.uniform(0, 256);
    c.x = b.x + random.uniform(-1, 1);
    c.y = b.y + random.uniform(-1, 1);
    c.r = random.byte();
    c.g = random.byte();
    vertices.insert(vertices.end(), {a, b, c});
  }
  draw_flat(gl, GL_TRIANGLES, vertices);
}

// Vertices on pixel centres and corners: the top-left rule decides.
SCENE(primitives, top_left_rule, kExact) {
  Random random(11);
  std::vector<Vertex> vertices(600);
  for (size_t i = 0; i < vertices.size(); ++i) {
    Vertex& v = vertices[i];
    v.x = static_cast<float>(random.below(512)) * 0.5f;
    v.y = static_cast<float>(random.below(512)) * 0.5f;
    if (i % 3 == 2) {
      v.r = random.byte();
      v.g = random.byte();
      v.b = random.byte();
    }
  }
  draw_flat(gl, GL_TRIANGLES, vertices);
}

// A jittered grid of triangles that share all edges, added up: a gap stays dark, a pixel hit twice
// is brighter.
SCENE(primitives, shared_edges, kExact) {
  Random random(12);
  constexpr int kCells = 24;
  std::vector<Vertex> grid;
  for (int y = 0; y <= kCells; ++y) {
    for (int x = 0; x <= kCells; ++x) {
      Vertex v;
      v.x = 8 + 10 * static_cast<float>(x) + random.uniform(-4, 4);
      v.y = 8 + 10 * static_cast<float>(y) + random.uniform(-4, 4);
      v.r = v.g = v.b = 60;
      grid.push_back(v);
    }
  }
  std::vector<uint16_t> indices;
  for (int y = 0; y < kCells; ++y) {
    for (int x = 0; x < kCells; ++x) {
      const auto at = [&](int dx, int dy) {
        return static_cast<uint16_t>((y + dy) * (kCells + 1) + x + dx);
      };
      indices.insert(indices.end(), {at(0, 0), at(1, 0), at(0, 1), at(1, 0), at(1, 1), at(0, 1)});
    }
  }
  clear(gl, 0, 0, 0, 1);
  pixel_projection(gl);
  gl.ShadeModel(GL_FLAT);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  draw_indexed(gl, GL_TRIANGLES, grid, indices);
}

// Indices of 8 bits, and a vertex order that culling separates (3.5.1).
SCENE(primitives, culled, kExact) {
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_FRONT);
  gl.FrontFace(GL_CW);
  draw_flat(gl, GL_TRIANGLES, random_vertices(13, 120));
}

SCENE(primitives, byte_indices, kExact) {
  clear(gl);
  pixel_projection(gl);
  gl.ShadeModel(GL_FLAT);
  const std::vector<Vertex> vertices = random_vertices(14, 200);
  Random random(15);
  std::vector<uint8_t> indices(90);
  for (uint8_t& index : indices) index = static_cast<uint8_t>(random.below(200));
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(2, GL_FLOAT, sizeof(Vertex), &vertices[0].x);
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), &vertices[0].r);
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_BYTE,
                  indices.data());
}

}  // namespace clearpipe::conformance
