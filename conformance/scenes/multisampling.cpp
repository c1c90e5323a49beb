// Multisampling (3.2.1, 4.1.3, 4.1.10) on buffers of four samples a pixel. OSMesa has none: the
// reference is Mesa's own OpenGL ES 1.1.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

namespace {

// Exact coverage of every sample; the mean of four is rounded either way.
constexpr Tolerance kMeans = {1, 1.0, 1, 1.0, nullptr};

std::vector<Vertex> random_vertices(uint32_t seed, int count, float depth = 0) {
  Random random(seed);
  std::vector<Vertex> vertices(static_cast<size_t>(count));
  for (Vertex& v : vertices) {
    v.x = random.uniform(-20, 276);
    v.y = random.uniform(-20, 276);
    v.z = random.uniform(-depth, depth);
    v.r = random.byte();
    v.g = random.byte();
    v.b = random.byte();
    v.a = random.byte();
  }
  return vertices;
}

// Thin triangles around the middle: edges of all slopes.
std::vector<Vertex> star(int count, float radius, float x = 128.3f, float y = 127.6f) {
  Random random(31);
  std::vector<Vertex> vertices;
  for (int i = 0; i < count; ++i) {
    Vertex tip, left, right;
    const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(count);
    tip.x = x + radius * std::cos(angle);
    tip.y = y + radius * std::sin(angle);
    left.x = x - 6 * std::sin(angle);
    left.y = y + 6 * std::cos(angle);
    right.x = x + 6 * std::sin(angle);
    right.y = y - 6 * std::cos(angle);
    for (Vertex* v : {&tip, &left, &right}) {
      v->r = static_cast<uint8_t>(120 + 9 * i);
      v->g = random.byte();
      v->b = static_cast<uint8_t>(250 - 7 * i);
      vertices.push_back(*v);
    }
  }
  return vertices;
}

void begin(const Gl& gl) {
  clear(gl);
  pixel_projection(gl);
}

}  // namespace

MULTISAMPLED_SCENE(multisampling, edges, kMeans) {
  begin(gl);
  gl.ShadeModel(GL_FLAT);
  draw(gl, GL_TRIANGLES, star(24, 120));
}

MULTISAMPLED_SCENE(multisampling, disabled, kExact) {
  begin(gl);
  gl.Disable(GL_MULTISAMPLE);
  gl.ShadeModel(GL_FLAT);
  draw(gl, GL_TRIANGLES, star(24, 120));
}

MULTISAMPLED_SCENE(multisampling, triangles, kColours) {
  begin(gl);
  draw(gl, GL_TRIANGLES, random_vertices(40, 120));
}

MULTISAMPLED_SCENE(multisampling, depth, kColours) {
  begin(gl);
  gl.Enable(GL_DEPTH_TEST);
  draw(gl, GL_TRIANGLES, random_vertices(41, 150, 0.9f));
}

MULTISAMPLED_SCENE(multisampling, perspective_spheres, kColours) {
  clear(gl);
  perspective(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_CULL_FACE);
  for (int i = 0; i < 4; ++i) {
    gl.LoadIdentity();
    gl.Translatef(static_cast<float>(i) - 1.5f, 0.3f * static_cast<float>(i % 2), -4.0f);
    draw(gl, GL_TRIANGLES, sphere(0.8f, 24, 16), kNormals);
  }
}

MULTISAMPLED_SCENE(multisampling, stencil, kColours) {
  begin(gl);
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilFunc(GL_ALWAYS, 0, 255);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw(gl, GL_TRIANGLES, random_vertices(42, 30));
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.StencilFunc(GL_NOTEQUAL, 0, 255);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  draw(gl, GL_TRIANGLES, coloured(rectangle(0, 0, 256, 256), 200, 160, 90));
}

MULTISAMPLED_SCENE(multisampling, blending, kColours) {
  begin(gl);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  draw(gl, GL_TRIANGLES, random_vertices(43, 90));
}

MULTISAMPLED_SCENE(multisampling, logic_op, kMeans) {
  begin(gl);
  gl.ShadeModel(GL_FLAT);
  gl.Enable(GL_COLOR_LOGIC_OP);
  gl.LogicOp(GL_XOR);
  draw(gl, GL_TRIANGLES, random_vertices(44, 60));
}

MULTISAMPLED_SCENE(
    multisampling, alpha_to_coverage,
    except_at_borders("4.1.3: an alpha next to a multiple of 1/4 gives a sample more or less")) {
  begin(gl);
  gl.Enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  draw(gl, GL_TRIANGLES, random_vertices(45, 60));
}

MULTISAMPLED_SCENE(
    multisampling, alpha_to_one,
    except_at_borders("4.1.3: an alpha next to a multiple of 1/4 gives a sample more or less")) {
  begin(gl);
  gl.Enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  gl.Enable(GL_SAMPLE_ALPHA_TO_ONE);
  draw(gl, GL_TRIANGLES, random_vertices(45, 60));
}

MULTISAMPLED_SCENE(multisampling, sample_coverage, kMeans) {
  begin(gl);
  gl.ShadeModel(GL_FLAT);
  gl.Enable(GL_SAMPLE_COVERAGE);
  for (int i = 0; i < 10; ++i) {
    gl.SampleCoverage(static_cast<float>(i / 2) / 4, i % 2 == 0 ? GL_FALSE : GL_TRUE);
    const float x = 24 * static_cast<float>(i);
    draw(gl, GL_TRIANGLES, coloured(rectangle(x, 3, x + 20.3f, 250), 255, 240, 80));
  }
}

MULTISAMPLED_SCENE(multisampling, textured, kColours) {
  begin(gl);
  gl.Enable(GL_TEXTURE_2D);
  noise_texture(gl, 64, 64, 46);
  std::vector<Vertex> vertices = star(12, 120);
  for (size_t i = 0; i < vertices.size(); ++i) {
    vertices[i].s = static_cast<float>(i % 3 == 1);
    vertices[i].t = static_cast<float>(i % 3 == 2);
  }
  draw(gl, GL_TRIANGLES, vertices, kColoursArray | kTexCoords);
}

MULTISAMPLED_SCENE(multisampling, alpha_test,
                   except_at_borders("4.1.4: alphas next to the reference pass or fail")) {
  begin(gl);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_GREATER, 0.4f);
  draw(gl, GL_TRIANGLES, random_vertices(47, 60));
}

MULTISAMPLED_SCENE(multisampling, point_sprites, kMeans) {
  begin(gl);
  gl.Enable(GL_POINT_SPRITE_OES);
  for (int i = 1; i < 20; ++i) {
    gl.PointSize(static_cast<float>(i) * 1.3f);
    draw(gl, GL_POINTS, random_vertices(48 + static_cast<uint32_t>(i), 10));
  }
}

MULTISAMPLED_SCENE(multisampling, lines, kMeans) {
  begin(gl);
  gl.ShadeModel(GL_FLAT);
  for (int i = 1; i < 12; ++i) {
    gl.LineWidth(static_cast<float>(i));
    draw(gl, GL_LINES, random_vertices(80 + static_cast<uint32_t>(i), 6));
  }
}

MULTISAMPLED_SCENE(multisampling, scissor_and_clear, kMeans) {
  begin(gl);
  gl.ShadeModel(GL_FLAT);
  draw(gl, GL_TRIANGLES, star(16, 120));
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(30, 50, 100, 120);
  gl.ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
  clear(gl, 0.9f, 0.9f, 0.1f);
}

}  // namespace clearpipe::conformance
