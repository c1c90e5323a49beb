// Calls that fail alike on both: the first error is kept, and nothing changes (2.5). What is an
// error only in ES, say a material of one face, is the negative tests' matter.
// SPDX-License-Identifier: MIT
#include "conformance/random/generator.h"

namespace clearpipe::conformance::random {

namespace {

void make_error(Generator& g) {
  switch (g.integer(0, 21)) {
    case 0:
      to::Enable{g, 0x1234};
      return;
    case 1:
      to::MatrixMode{g, GL_AMBIENT};
      return;
    case 2:
      to::DepthFunc{g, GL_FRONT};
      return;
    case 3:
      to::PointSize{g, -g.uniform(0, 1)};
      return;
    case 4:
      to::LineWidth{g, 0};
      return;
    case 5:
      to::Viewport{g, 3, 4, -1, 10};
      return;
    case 6:
      to::Scissor{g, 3, 4, 10, -1};
      return;
    case 7:
      to::MatrixMode{g, GL_PROJECTION};
      to::PopMatrix{g};
      to::MatrixMode{g, GL_MODELVIEW};
      return;
    case 8:
      to::Lightf{g, GL_LIGHT0, GL_SPOT_CUTOFF, 100};
      return;
    case 9:
      to::Fogf{g, GL_FOG_DENSITY, -1};
      return;
    case 10:
      to::DrawArrays{g, GL_TRIANGLES, 0, -3};
      return;
    case 11:
      to::DrawArrays{g, 0x77, 0, 3};
      return;
    case 12:
      to::DrawElements{g, GL_TRIANGLES, 3, GL_FLOAT, Data{{0, 1, 2, 0, 0, 0}}};
      return;
    case 13:
      to::BlendFunc{g, GL_ONE, GL_BLEND};
      return;
    case 14:
      to::Clear{g, 0x00000010};
      return;
    case 15:
      to::BindTexture{g, GL_TEXTURE0, 3};
      return;
    case 16:
      to::TexParameteri{g, GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_REPEAT};
      return;
    case 17:
      to::Materialf{g, GL_FRONT_AND_BACK, GL_SHININESS, 129};
      return;
    case 18:
      to::Frustumf{g, -1, 1, -1, 1, -0.5f, 2};
      return;
    case 19:
      to::TexEnvf{g, GL_TEXTURE_ENV, GL_RGB_SCALE, 3};
      return;
    case 20:
      to::StencilOp{g, GL_KEEP, GL_LESS, GL_KEEP};
      return;
    default:
      to::LogicOp{g, GL_NEVER};
      return;
  }
}

}  // namespace

void make_errors(Generator& g) {
  const int count = g.integer(1, 3);
  for (int i = 0; i < count; ++i) make_error(g);
}

}  // namespace clearpipe::conformance::random
