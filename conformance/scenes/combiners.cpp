// Combiner functions (3.7.12) in the forms that random streams found to matter.
// SPDX-License-Identifier: MIT
#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

// DOT3_RGBA goes to all four components; colours have their scale, alpha has its own.
SCENE(combiners, dot3_rgba_scales, kColours) {
  clear(gl);
  pixel_projection(gl);
  noise_texture(gl, 32, 32, 310);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGBA);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_PRIMARY_COLOR);
  gl.Color4f(0.6f, 0.35f, 0.7f, 1);
  constexpr float kScales[] = {1, 2, 4};
  for (int i = 0; i < 9; ++i) {
    gl.TexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, kScales[i / 3]);
    gl.TexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, kScales[i % 3]);
    const float x = static_cast<float>(i / 3) * 85 + 2, y = static_cast<float>(i % 3) * 85 + 2;
    draw(gl, GL_TRIANGLES, rectangle(x, y, x + 80, y + 80), kTexCoords);
  }
}

}  // namespace clearpipe::conformance
