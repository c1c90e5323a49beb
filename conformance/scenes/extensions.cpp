// Extensions of the texture and fragment stages.
// SPDX-License-Identifier: MIT
#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

namespace {

// A plate seen in perspective, with mipmaps.
void mipmapped_plate(const Gl& gl) {
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  textured_plate(gl, 5);
}

}  // namespace

SCENE(extensions, lod_bias_up, kColours) {
  noise_texture(gl, 32, 32, 80, true);
  gl.TexEnvf(GL_TEXTURE_FILTER_CONTROL_EXT, GL_TEXTURE_LOD_BIAS_EXT, 1.3f);
  mipmapped_plate(gl);
}

SCENE(extensions, lod_bias_down, kColours) {
  noise_texture(gl, 32, 32, 80, true);
  gl.TexEnvf(GL_TEXTURE_FILTER_CONTROL_EXT, GL_TEXTURE_LOD_BIAS_EXT, -0.75f);
  mipmapped_plate(gl);
}

SCENE(extensions, max_level, kColours) {
  noise_texture(gl, 32, 32, 80, true);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL_APPLE, 2);
  mipmapped_plate(gl);
}

// OES_blend_subtract, EXT_blend_minmax: a bar for each equation.
SCENE(extensions, blend_equations, kColours) {
  constexpr GLenum kEquations[] = {GL_FUNC_ADD_OES, GL_FUNC_SUBTRACT_OES,
                                   GL_FUNC_REVERSE_SUBTRACT_OES, GL_MIN_EXT, GL_MAX_EXT};
  clear(gl, 0.3f, 0.6f, 0.2f, 0.5f);
  pixel_projection(gl);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_DST_ALPHA);
  float y = 4;
  for (const GLenum equation : kEquations) {
    gl.BlendEquationOES(equation);
    std::vector<Vertex> bar = rectangle(6, y, 250, y + 46);
    for (Vertex& v : bar) {
      v.r = v.x > 100 ? 230 : 20;
      v.g = v.y > y + 1 ? 200 : 60;
      v.a = v.x > 100 ? 90 : 240;
    }
    draw(gl, GL_TRIANGLES, bar);
    y += 50;
  }
}

// OES_draw_texture with whole numbers and one unit, where Mesa follows it (numerics.md).
ES_SCENE(extensions, draw_texture, kExact) {
  clear(gl, 0.2f, 0.3f, 0.5f);
  noise_texture(gl, 32, 32, 211);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.Enable(GL_TEXTURE_2D);
  const GLint crops[][4] = {{0, 0, 32, 32}, {4, 8, 16, 8}, {32, 0, -32, 32}, {0, 32, 32, -32}};
  GLint x = 0;
  for (const GLint* crop : crops) {
    gl.TexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, crop);
    gl.DrawTexiOES(x + 4, 10, 0, 32, 32);
    gl.DrawTexiOES(x, 60, 0, 64, 128);
    x += 64;
  }
}

}  // namespace clearpipe::conformance
