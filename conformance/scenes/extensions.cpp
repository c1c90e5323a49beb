// Extensions of the texture and fragment stages that the desktop has too.
// SPDX-License-Identifier: MIT
#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

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

}  // namespace clearpipe::conformance
