// SPDX-License-Identifier: MIT
//
// What several scenes draw: rectangles over the whole surface, noise as a texture, meshes.
#pragma once

#include <EGL/egl.h>
#include <GLES/gl.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

[[noreturn]] void fail(const char* what);

// Finds a function of an extension, which the loader's library does not export.
template <typename Function>
void find_function(const char* name, Function& function) {
  function = reinterpret_cast<Function>(eglGetProcAddress(name));
  if (!function) fail(name);
}

// Numbers that look random and are the same in every run.
class Noise {
 public:
  explicit Noise(uint32_t seed) : state_(seed * 2654435761u + 1) {}
  uint32_t bits() {
    state_ = state_ * 1664525u + 1013904223u;
    return state_ >> 8;
  }
  float unit() { return float(bits()) / float(1 << 24); }  // [0, 1)
  float between(float a, float b) { return a + (b - a) * unit(); }

 private:
  uint32_t state_;
};

// An even number of such bytes.
std::vector<GLubyte> noise_bytes(uint32_t seed, size_t count);

// glFrustumf with a vertical angle of view in degrees, and the modelview matrix made current.
void set_perspective(int width, int height, float degrees, float near, float far);

// A rectangle over the whole surface, when both matrices are the identity.
void draw_whole(float z = 0);

// With the colours and texture coordinates that these set; each stays until it is set anew.
void use_corner_colours(GLubyte alpha = 255);
void use_corner_coordinates(GLenum unit, float repeats, bool turned = true);

struct TextureOptions {
  int size = 256;
  GLint min = GL_LINEAR, mag = GL_LINEAR;
  GLint wrap = GL_REPEAT;
  bool mipmaps = false;
  bool smooth = false;  // large shapes rather than noise: what is far away then looks alike
};
// Makes a texture, binds it to the active unit and enables that.
GLuint use_noise_texture(uint32_t seed, const TextureOptions& options);

// A surface over a grid of columns x rows rectangles, two triangles each, in buffer objects.
struct MeshVertex {
  GLfloat position[3];
  GLfloat normal[3];
  GLubyte colour[4];
};
struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<GLuint> indices;

  int triangles() const { return int(indices.size() / 3); }
};
Mesh wavy_plate(int columns, int rows);  // about z = 0, -1 to 1 in x and y
Mesh tube(int around, int along);        // of radius 1 about z, from z = -1 to 1
// Puts both into buffer objects and points the arrays of vertices, normals, colours at them.
void use_mesh(const Mesh& mesh);
void draw_mesh(const Mesh& mesh);
// Two numbers of rectangles that make about this many triangles, `wide` times as many columns as
// rows.
void grid_of(int triangles, float wide, int* columns, int* rows);

}  // namespace bench
