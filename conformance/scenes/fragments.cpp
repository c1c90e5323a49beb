// Per-fragment operations (4.1, 4.2): scissor, alpha, stencil and depth test, blending, logical
// operation, masks.
// SPDX-License-Identifier: MIT
#include <cstdio>

#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

namespace {

std::vector<Vertex> random_triangles(uint32_t seed, int count, float depth = 1) {
  Random random(seed);
  std::vector<Vertex> vertices(static_cast<size_t>(count) * 3);
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

// Eight vertical and eight horizontal bars, each of another function, over a background.
template <class Prepare>
void bars(const Gl& gl, const GLenum* functions, int count, const Prepare& prepare) {
  for (int i = 0; i < count; ++i) {
    const float width = 256.0f / static_cast<float>(count);
    prepare(functions[i]);
    std::vector<Vertex> bar =
        rectangle(static_cast<float>(i) * width, 0, static_cast<float>(i + 1) * width - 2, 256, 0);
    Random random(static_cast<uint32_t>(i) + 100);
    for (size_t v = 0; v < 3; ++v) {
      bar[v].r = random.byte();
      bar[v].g = random.byte();
      bar[v].b = random.byte();
      bar[v].a = static_cast<uint8_t>(40 + 100 * v);
    }
    for (size_t v = 3; v < 6; ++v) bar[v] = bar[v == 3 ? 0 : v == 4 ? 2 : 5];
    draw(gl, GL_TRIANGLES, bar);
  }
}

constexpr GLenum kComparisons[] = {GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                   GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};

// Tables 4.1 and 4.2: the colour of the other side is a factor, one's own is not.
constexpr GLenum kSourceFactors[] = {GL_ZERO,
                                     GL_ONE,
                                     GL_DST_COLOR,
                                     GL_ONE_MINUS_DST_COLOR,
                                     GL_SRC_ALPHA,
                                     GL_DST_ALPHA,
                                     GL_ONE_MINUS_SRC_ALPHA,
                                     GL_ONE_MINUS_DST_ALPHA,
                                     GL_SRC_ALPHA_SATURATE};

constexpr GLenum kDestinationFactors[] = {
    GL_ZERO,      GL_ONE,       GL_SRC_COLOR,           GL_ONE_MINUS_SRC_COLOR,
    GL_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE_MINUS_DST_ALPHA};

// A smooth picture with varying alpha under what follows.
void background(const Gl& gl) {
  clear(gl, 0.3f, 0.5f, 0.2f, 0.4f);
  pixel_projection(gl);
  draw(gl, GL_TRIANGLES, random_triangles(50, 6));
}

}  // namespace

SCENE(fragments, scissor, kExact) {
  clear(gl);
  pixel_projection(gl);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(37, 61, 150, 103);
  gl.ShadeModel(GL_FLAT);
  draw(gl, GL_TRIANGLES, random_triangles(40, 20));
  gl.Scissor(200, 3, 31, 29);
  clear(gl, 0.9f, 0.2f, 0.1f, 1);
}

SCENE(fragments, viewport, kExact) {
  clear(gl);
  pixel_projection(gl);
  gl.ShadeModel(GL_FLAT);
  gl.Viewport(-30, 17, 180, 120);
  draw(gl, GL_TRIANGLES, random_triangles(41, 12));
  gl.Viewport(131, 140, 200, 90);
  draw(gl, GL_TRIANGLES, random_triangles(42, 12));
}

SCENE(fragments, alpha_test,
      except_at_borders("4.1.4: alpha half-way between two 8-bit values rounds either way")) {
  background(gl);
  gl.Enable(GL_ALPHA_TEST);
  bars(gl, kComparisons, 8, [&](GLenum function) { gl.AlphaFunc(function, 0.503f); });
}

SCENE(fragments, depth_functions, kColours) {
  clear(gl);
  pixel_projection(gl);
  gl.Enable(GL_DEPTH_TEST);
  draw(gl, GL_TRIANGLES, random_triangles(43, 10));
  gl.DepthMask(GL_FALSE);
  bars(gl, kComparisons, 8, [&](GLenum function) { gl.DepthFunc(function); });
}

// Interpenetrating triangles: the pixels where they meet show the depth itself.
SCENE(
    fragments, depth_intersections,
    except_at_borders("4.1.6: where surfaces meet, the last bit of depth decides which is seen")) {
  clear(gl);
  perspective(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.ShadeModel(GL_FLAT);
  Random random(44);
  std::vector<Vertex> vertices(60);
  for (Vertex& v : vertices) {
    v.x = random.uniform(-3, 3);
    v.y = random.uniform(-3, 3);
    v.z = random.uniform(-8, -1.5f);
    v.r = random.byte();
    v.g = random.byte();
    v.b = random.byte();
  }
  draw(gl, GL_TRIANGLES, vertices);
}

SCENE(fragments, depth_range, kColours) {
  clear(gl);
  pixel_projection(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthRangef(0.7f, 0.2f);
  draw(gl, GL_TRIANGLES, random_triangles(45, 10));
  gl.DepthRangef(0.1f, 0.6f);
  draw(gl, GL_TRIANGLES, random_triangles(46, 10));
}

SCENE(fragments, polygon_offset, kColours) {
  clear(gl);
  perspective(gl);
  gl.Translatef(0, 0, -4);
  gl.Enable(GL_DEPTH_TEST);
  const std::vector<Vertex> ball = sphere(1.5f, 16, 12);
  gl.Rotatef(30, 1, 1, 0);
  draw(gl, GL_TRIANGLES, ball);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.PolygonOffset(-1, -8);
  gl.DepthFunc(GL_LESS);
  gl.Color4f(0.9f, 0.9f, 0.2f, 1);
  std::vector<Vertex> some;
  for (size_t i = 0; i + 6 <= ball.size(); i += 12) {
    some.insert(some.end(), ball.begin() + static_cast<ptrdiff_t>(i),
                ball.begin() + static_cast<ptrdiff_t>(i) + 6);
  }
  draw(gl, GL_TRIANGLES, some, kPositions);
  gl.PolygonOffset(2, 50);
  gl.DepthFunc(GL_GREATER);
  gl.Color4f(0.2f, 0.3f, 0.9f, 1);
  draw(gl, GL_TRIANGLES, some, kPositions);
}

SCENE(fragments, stencil_functions, kColours) {
  clear(gl);
  pixel_projection(gl);
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  gl.StencilFunc(GL_ALWAYS, 0, 0xff);
  draw(gl, GL_TRIANGLES, random_triangles(47, 14));
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  bars(gl, kComparisons, 8, [&](GLenum function) { gl.StencilFunc(function, 2, 0x3); });
}

SCENE(fragments, stencil_operations, kColours) {
  constexpr GLenum kOperations[] = {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT};
  clear(gl);
  pixel_projection(gl);
  gl.Enable(GL_STENCIL_TEST);
  gl.Enable(GL_DEPTH_TEST);
  gl.ClearStencil(3);
  gl.Clear(GL_STENCIL_BUFFER_BIT);
  for (uint32_t pass = 0; pass < 6; ++pass) {
    gl.StencilMask(pass == 4 ? 0x5 : 0xff);
    gl.StencilFunc(GL_GEQUAL, 4, 0x7);
    gl.StencilOp(kOperations[pass], kOperations[(pass + 3) % 6], kOperations[(pass + 2) % 6]);
    draw(gl, GL_TRIANGLES, random_triangles(60 + pass, 6));
  }
  gl.Disable(GL_DEPTH_TEST);
  gl.StencilMask(0);
  for (GLint value = 0; value < 8; ++value) {
    gl.StencilFunc(GL_EQUAL, value, 0x7);
    gl.Color4f(static_cast<float>(value & 1), static_cast<float>(value & 2) * 0.5f,
               static_cast<float>(value & 4) * 0.25f, 1);
    draw(gl, GL_TRIANGLES, rectangle(0, 0, 128, 256), kPositions);
  }
}

SCENE(fragments, blend_source_factors, kColours) {
  background(gl);
  gl.Enable(GL_BLEND);
  bars(gl, kSourceFactors, 9, [&](GLenum factor) { gl.BlendFunc(factor, GL_ONE_MINUS_SRC_ALPHA); });
}

SCENE(fragments, blend_destination_factors, kColours) {
  background(gl);
  gl.Enable(GL_BLEND);
  bars(gl, kDestinationFactors, 8, [&](GLenum factor) { gl.BlendFunc(GL_SRC_ALPHA, factor); });
}

SCENE(fragments, blend_layers, kColours) {
  background(gl);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  draw(gl, GL_TRIANGLES, random_triangles(48, 12));
}

SCENE(fragments, logic_operations, kColours) {
  constexpr GLenum kOperations[] = {GL_CLEAR,         GL_AND,         GL_AND_REVERSE, GL_COPY,
                                    GL_AND_INVERTED,  GL_NOOP,        GL_XOR,         GL_OR,
                                    GL_NOR,           GL_EQUIV,       GL_INVERT,      GL_OR_REVERSE,
                                    GL_COPY_INVERTED, GL_OR_INVERTED, GL_NAND,        GL_SET};
  clear(gl, 0.2f, 0.6f, 0.9f, 0.3f);
  pixel_projection(gl);
  gl.ShadeModel(GL_FLAT);
  gl.Enable(GL_COLOR_LOGIC_OP);
  for (int i = 0; i < 16; ++i) {
    gl.LogicOp(kOperations[i]);
    const float x = static_cast<float>(i) * 16;
    draw(gl, GL_TRIANGLES,
         coloured(rectangle(x, 20, x + 14, 236), static_cast<uint8_t>(200 - i), 77, 130, 180));
  }
}

SCENE(fragments, colour_mask, kColours) {
  background(gl);
  gl.ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
  draw(gl, GL_TRIANGLES, random_triangles(49, 5));
  gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  draw(gl, GL_TRIANGLES, random_triangles(51, 5));
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(100, 100, 60, 60);
  gl.ClearColor(1, 1, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
}

SCENE(fragments, smooth_shading, kColours) {
  clear(gl);
  pixel_projection(gl);
  draw(gl, GL_TRIANGLES, random_triangles(52, 12));
}

}  // namespace clearpipe::conformance
