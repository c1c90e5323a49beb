// SPDX-License-Identifier: MIT
//
// See shapes.h.
#include "bench/shapes.h"

#include <GLES/glext.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace bench {

namespace {

constexpr float kPi = 3.14159265358979f;

// What scenes are made of is made quickly, as its time is part of that to the first frame: sines
// and cosines once for each row and column.
std::vector<GLubyte> smooth_texels(int size) {
  const float step = 2 * kPi / float(size);
  std::vector<float> along_x, along_y;  // of each component
  for (int i = 0; i < size; ++i) {
    for (int c = 0; c < 4; ++c) {
      along_x.push_back(std::sin(float(i * (c + 1)) * step));
      along_y.push_back(std::cos(float(i * (4 - c)) * step));
    }
  }
  std::vector<GLubyte> texels(size_t(size) * size_t(size) * 4);
  size_t next = 0;
  for (size_t y = 0; y < size_t(size); ++y) {
    for (size_t x = 0; x < size_t(size); ++x) {
      for (size_t c = 0; c < 4; ++c) {
        const float wave = along_x[4 * x + c] * along_y[4 * y + c];
        texels[next++] = GLubyte(127.5f + 127 * wave);
      }
    }
  }
  return texels;
}

// Each level the mean of the one before, so that both implementations have the same.
std::vector<GLubyte> halved(const std::vector<GLubyte>& texels, int size) {
  std::vector<GLubyte> result;
  result.reserve(texels.size() / 4);
  const auto at = [&](int x, int y, int c) { return int(texels[size_t((y * size + x) * 4 + c)]); };
  for (int y = 0; y < size; y += 2) {
    for (int x = 0; x < size; x += 2) {
      for (int c = 0; c < 4; ++c) {
        const int sum = at(x, y, c) + at(x + 1, y, c) + at(x, y + 1, c) + at(x + 1, y + 1, c);
        result.push_back(GLubyte((sum + 2) / 4));
      }
    }
  }
  return result;
}

void add_grid_indices(Mesh& mesh, int columns, int rows) {
  mesh.indices.resize(size_t(columns) * size_t(rows) * 6);
  GLuint* next = mesh.indices.data();
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const GLuint corner = GLuint(y * (columns + 1) + x), above = corner + GLuint(columns + 1);
      for (const GLuint index : {corner, corner + 1, above, corner + 1, above + 1, above}) {
        *next++ = index;
      }
    }
  }
}

}  // namespace

std::vector<GLubyte> noise_bytes(uint32_t seed, size_t count) {
  Noise noise(seed);
  std::vector<GLubyte> bytes(count);
  for (size_t i = 0; i + 1 < count; i += 2) {
    const uint32_t bits = noise.bits();
    bytes[i] = GLubyte(bits >> 16);
    bytes[i + 1] = GLubyte(bits >> 8);
  }
  return bytes;
}

void fail(const char* what) {
  std::fprintf(stderr, "scenes: %s failed (EGL error 0x%04x)\n", what, unsigned(eglGetError()));
  std::exit(1);
}

void set_perspective(int width, int height, float degrees, float near, float far) {
  const float top = near * std::tan(degrees * kPi / 360.0f);
  const float right = top * float(width) / float(height);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustumf(-right, right, -top, top, near, far);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
}

void draw_whole(float z) {
  const GLfloat corners[] = {-1, -1, z, 1, -1, z, -1, 1, z, 1, 1, z};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, corners);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void use_corner_colours(GLubyte alpha) {
  static GLubyte colours[] = {255, 40, 40, 0, 40, 255, 40, 0, 40, 40, 255, 0, 250, 250, 30, 0};
  for (int corner = 0; corner < 4; ++corner) colours[4 * corner + 3] = alpha;
  glColorPointer(4, GL_UNSIGNED_BYTE, 0, colours);
  glEnableClientState(GL_COLOR_ARRAY);
}

void use_corner_coordinates(GLenum unit, float repeats, bool turned) {
  static GLfloat coordinates[8][8];
  GLfloat* const mine = coordinates[unit];
  // Turned a little, so that no row of texels falls on a row of pixels.
  const float turn = turned ? 0.06f * repeats : 0;
  const GLfloat values[8] = {0, 0, repeats, turn, -turn, repeats, repeats - turn, repeats + turn};
  std::copy(values, values + 8, mine);
  glClientActiveTexture(GL_TEXTURE0 + unit);
  glTexCoordPointer(2, GL_FLOAT, 0, mine);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glClientActiveTexture(GL_TEXTURE0);
}

GLuint use_noise_texture(uint32_t seed, const TextureOptions& options) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, options.min);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, options.mag);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, options.wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, options.wrap);
  std::vector<GLubyte> texels =
      options.smooth ? smooth_texels(options.size)
                     : noise_bytes(seed, size_t(options.size) * size_t(options.size) * 4);
  for (int size = options.size, level = 0;; size /= 2, ++level) {
    glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
    if (size == 1 || !options.mipmaps) break;
    texels = halved(texels, size);
  }
  glEnable(GL_TEXTURE_2D);
  return name;
}

Mesh wavy_plate(int columns, int rows) {
  Mesh mesh;
  mesh.vertices.reserve(size_t(columns + 1) * size_t(rows + 1));
  struct Column {
    float px, sine, cosine;
  };
  std::vector<Column> all_columns;
  for (int x = 0; x <= columns; ++x) {
    const float px = 2 * float(x) / float(columns) - 1;
    all_columns.push_back({px, std::sin(8 * px), std::cos(8 * px)});
  }
  for (int y = 0; y <= rows; ++y) {
    const float py = 2 * float(y) / float(rows) - 1;
    const float row_sine = std::sin(6 * py), row_cosine = std::cos(6 * py);
    for (const auto& [px, sine, cosine] : all_columns) {
      const float slope_x = 0.96f * cosine * row_cosine;
      const float slope_y = -0.72f * sine * row_sine;
      const float length = std::sqrt(slope_x * slope_x + slope_y * slope_y + 1);
      mesh.vertices.push_back(
          {{px, py, 0.12f * sine * row_cosine},
           {-slope_x / length, -slope_y / length, 1 / length},
           {GLubyte(127 + 127 * px), GLubyte(127 + 127 * py), GLubyte(160 + 90 * slope_x), 255}});
    }
  }
  add_grid_indices(mesh, columns, rows);
  return mesh;
}

Mesh tube(int around, int along) {
  Mesh mesh;
  mesh.vertices.reserve(size_t(around + 1) * size_t(along + 1));
  std::vector<std::array<float, 2>> circle;
  for (int a = 0; a <= around; ++a) {
    const float angle = 2 * kPi * float(a) / float(around);
    circle.push_back({std::cos(angle), std::sin(angle)});
  }
  for (int z = 0; z <= along; ++z) {
    const float pz = 2 * float(z) / float(along) - 1;
    for (const auto& [c, s] : circle) {
      mesh.vertices.push_back(
          {{c, s, pz},
           {-c, -s, 0},
           {GLubyte(127 + 127 * c), GLubyte(127 + 127 * s), GLubyte(127 + 127 * pz), 255}});
    }
  }
  add_grid_indices(mesh, around, along);
  return mesh;
}

void use_mesh(const Mesh& mesh) {
  GLuint buffers[2];
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.vertices.size() * sizeof(MeshVertex)),
               mesh.vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices.size() * sizeof(GLuint)),
               mesh.indices.data(), GL_STATIC_DRAW);
  const auto at = [](size_t offset) { return reinterpret_cast<const void*>(offset); };
  glVertexPointer(3, GL_FLOAT, sizeof(MeshVertex), at(offsetof(MeshVertex, position)));
  glNormalPointer(GL_FLOAT, sizeof(MeshVertex), at(offsetof(MeshVertex, normal)));
  glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(MeshVertex), at(offsetof(MeshVertex, colour)));
  glEnableClientState(GL_VERTEX_ARRAY);
}

void draw_mesh(const Mesh& mesh) {
  glDrawElements(GL_TRIANGLES, GLsizei(mesh.indices.size()), GL_UNSIGNED_INT, nullptr);
}

void grid_of(int triangles, float wide, int* columns, int* rows) {
  *rows = std::max(1, int(std::lround(std::sqrt(float(triangles) / 2 / wide))));
  *columns = std::max(1, int(std::lround(float(triangles) / 2 / float(*rows))));
}

}  // namespace bench
