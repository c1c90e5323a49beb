// What scenes share: vertices, random numbers that are the same everywhere, textures.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "conformance/scene.h"

namespace clearpipe::conformance {

struct Vertex {
  float x = 0, y = 0, z = 0, w = 1;
  uint8_t r = 255, g = 255, b = 255, a = 255;
  float s = 0, t = 0;
  float nx = 0, ny = 0, nz = 1;
};

// Uniform numbers from a seed; the engine's sequence is the standard's, the mapping is ours.
class Random {
 public:
  explicit Random(uint32_t seed) : engine_(seed) {}
  float uniform(float low, float high) {
    return low + (high - low) * static_cast<float>(engine_() >> 8) * (1.0f / 16777216.0f);
  }
  uint8_t byte() { return static_cast<uint8_t>(engine_() >> 24); }
  uint32_t below(uint32_t bound) { return static_cast<uint32_t>(engine_()) % bound; }

 private:
  std::mt19937 engine_;
};

// Which arrays a draw has beside positions.
enum Arrays : unsigned { kPositions = 0, kColoursArray = 1, kTexCoords = 2, kNormals = 4 };

// Points the arrays at the vertices and draws all of them.
void draw(const Gl& gl, GLenum mode, const std::vector<Vertex>& vertices,
          unsigned arrays = kColoursArray);

// The same by 16-bit indices.
void draw_indexed(const Gl& gl, GLenum mode, const std::vector<Vertex>& vertices,
                  const std::vector<uint16_t>& indices, unsigned arrays = kColoursArray);

void clear(const Gl& gl, float r = 0.1f, float g = 0.1f, float b = 0.15f, float a = 1);

// Window coordinates in pixels, y upwards, z as it is.
void pixel_projection(const Gl& gl, int width = 256, int height = 256);

// A perspective frustum with the eye at the origin: 60 degrees, near 1, far 50.
void perspective(const Gl& gl);

// A rectangle of two triangles at a depth, texture coordinates from (s0, t0) to (s1, t1).
std::vector<Vertex> rectangle(float x0, float y0, float x1, float y1, float z = 0, float s0 = 0,
                              float t0 = 0, float s1 = 1, float t1 = 1);

// The rectangle in one colour.
std::vector<Vertex> coloured(std::vector<Vertex> vertices, uint8_t r, uint8_t g, uint8_t b,
                             uint8_t a = 255);

// Short lines in all directions from and to centres of pixels, corners of pixels and borders of
// diamonds, where the diamond-exit rule (3.4.1) decides: none touches another.
std::vector<Vertex> lines_between_pixels();

// A sphere around the origin with normals and texture coordinates, as triangles.
std::vector<Vertex> sphere(float radius, int slices, int stacks);

// Clears, and draws a plate in perspective with the bound texture, which repeats so often across
// it: from near and magnified to far and minified.
void textured_plate(const Gl& gl, float repeat);

// Binds a new 2D texture of the active unit with random texels over a gradient, RGBA.
GLuint noise_texture(const Gl& gl, int width, int height, uint32_t seed, bool mipmaps = false);

}  // namespace clearpipe::conformance
