// Fog (3.8) and the per-fragment operations (4.1, 4.2).
// SPDX-License-Identifier: MIT
#include "conformance/random/generator.h"

namespace clearpipe::conformance::random {

void set_fog(Generator& g) {
  // Operations on bits make much of a difference of 1/255.
  if (!g.has(Group::fog) || g.has(Group::logic_op)) return;
  to::Enable{g, GL_FOG};
  to::Fogfv{g, GL_FOG_COLOR, floats(g.several(4, 0, 1))};
  to::Fogx{g, GL_FOG_MODE, g.one_of<GLenum>({GL_LINEAR, GL_EXP, GL_EXP2})};
  const float far = g.perspective ? 8.0f : 1.0f;
  to::Fogf{g, GL_FOG_DENSITY, g.uniform(0.2f, 2) / far};
  to::Fogf{g, GL_FOG_START, g.uniform(-0.5f, 0.4f) * far};
  to::Fogx{g, GL_FOG_END, fixed(g.uniform(0.5f, 1.2f) * far)};
}

namespace {

GLenum source_factor(Generator& g) {
  return g.one_of<GLenum>({GL_ZERO, GL_ONE, GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR, GL_SRC_ALPHA,
                           GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA,
                           GL_SRC_ALPHA_SATURATE});
}

GLenum destination_factor(Generator& g) {
  return g.one_of<GLenum>({GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA,
                           GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA});
}

GLenum equation(Generator& g) {
  return g.one_of<GLenum>({GL_FUNC_ADD_OES, GL_FUNC_SUBTRACT_OES, GL_FUNC_REVERSE_SUBTRACT_OES});
}

GLenum stencil_operation(Generator& g) {
  return g.one_of<GLenum>({GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT,
                           GL_INCR_WRAP_OES, GL_DECR_WRAP_OES});
}

void set_blending(Generator& g) {
  to::Enable{g, GL_BLEND};
  if (g.chance(0.5f)) {
    to::BlendFunc{g, source_factor(g), destination_factor(g)};
  } else {
    to::BlendFuncSeparateOES{g, source_factor(g), destination_factor(g), source_factor(g),
                             destination_factor(g)};
  }
  if (g.chance(0.4f)) to::BlendEquationSeparateOES{g, equation(g), equation(g)};
}

void set_stencil(Generator& g) {
  to::Enable{g, GL_STENCIL_TEST};
  to::StencilFunc{g, g.chance(0.4f) ? static_cast<GLenum>(GL_ALWAYS) : g.comparison(),
                  g.integer(0, 255), g.chance(0.5f) ? 0xff : g.integer(0, 255)};
  to::StencilOp{g, stencil_operation(g), stencil_operation(g), stencil_operation(g)};
  if (g.chance(0.3f)) to::StencilMask{g, g.random.byte()};
}

void set_depth(Generator& g) {
  to::Enable{g, GL_DEPTH_TEST};
  to::DepthFunc{g, g.one_of<GLenum>({GL_LESS, GL_LEQUAL, GL_GREATER, GL_GEQUAL, GL_ALWAYS,
                                     GL_NOTEQUAL, GL_LESS, g.comparison()})};
  if (g.chance(0.2f)) to::DepthMask{g, 0};
}

}  // namespace

void set_fragment_operations(Generator& g) {
  if (g.has(Group::scissor)) {
    to::Enable{g, GL_SCISSOR_TEST};
    to::Scissor{g, g.integer(-30, 60), g.integer(-30, 60), g.integer(0, 150), g.integer(20, 150)};
  }
  if (g.has(Group::alpha_test)) {
    to::Enable{g, GL_ALPHA_TEST};
    // Between two 8-bit values.
    to::AlphaFunc{g, g.comparison(), (static_cast<float>(g.integer(20, 230)) + 0.5f) / 255.0f};
  }
  if (g.has(Group::stencil)) set_stencil(g);
  if (g.has(Group::depth) || g.has(Group::polygon_offset)) set_depth(g);
  if (g.has(Group::blending)) set_blending(g);
  if (g.has(Group::logic_op)) {
    to::Enable{g, GL_COLOR_LOGIC_OP};
    to::LogicOp{g, GL_CLEAR + g.random.below(16)};
  }
  if (g.has(Group::masks)) {
    to::ColorMask{g, g.chance(0.7f), g.chance(0.7f), g.chance(0.7f), g.chance(0.7f)};
    to::DepthMask{g, g.chance(0.7f)};
    to::StencilMask{g, g.random.byte()};
  }
}

void change_fragment_operations(Generator& g) {
  if (g.has(Group::stencil) && g.chance(0.5f)) set_stencil(g);
  if (g.has(Group::depth) && g.chance(0.5f)) set_depth(g);
  if (g.has(Group::blending) && g.chance(0.5f)) set_blending(g);
  if (g.has(Group::logic_op) && g.chance(0.5f)) {
    to::LogicOp{g, GL_CLEAR + g.random.below(16)};
  }
}

// Layers of light where depth or stencil lies beyond some values.
void show_depth_and_stencil(Generator& g) {
  const bool depth = g.has(Group::depth) || g.has(Group::polygon_offset);
  const bool stencil = g.has(Group::stencil);
  if (!depth && !stencil && !g.has(Group::masks) && !g.has(Group::clears)) return;
  for (const GLenum off :
       {GL_LIGHTING, GL_FOG, GL_ALPHA_TEST, GL_COLOR_LOGIC_OP, GL_SCISSOR_TEST, GL_CULL_FACE,
        GL_POLYGON_OFFSET_FILL, GL_STENCIL_TEST, GL_CLIP_PLANE0, GL_CLIP_PLANE1, GL_CLIP_PLANE2,
        GL_CLIP_PLANE3, GL_CLIP_PLANE4, GL_CLIP_PLANE5}) {
    to::Disable{g, off};
  }
  for (int unit = 0; unit < g.units; ++unit) {
    to::ActiveTexture{g, GL_TEXTURE0 + unit};
    to::Disable{g, GL_TEXTURE_2D};
    to::ClientActiveTexture{g, GL_TEXTURE0 + unit};
    to::DisableClientState{g, GL_TEXTURE_COORD_ARRAY};
  }
  to::DisableClientState{g, GL_COLOR_ARRAY};
  to::DisableClientState{g, GL_NORMAL_ARRAY};
  to::MatrixMode{g, GL_PROJECTION};
  to::LoadIdentity{g};
  to::MatrixMode{g, GL_MODELVIEW};
  to::LoadIdentity{g};
  to::Viewport{g, 0, 0, 128, 128};
  to::DepthRangef{g, 0, 1};
  to::ColorMask{g, 1, 1, 1, 1};
  to::DepthMask{g, 0};
  to::Enable{g, GL_BLEND};
  to::BlendFunc{g, GL_ONE, GL_ONE_MINUS_SRC_ALPHA};
  to::BlendEquationOES{g, GL_FUNC_ADD_OES};
  to::Enable{g, GL_DEPTH_TEST};
  to::DepthFunc{g, GL_LESS};
  to::Color4f{g, 0.1f, 0.05f, 0, 0.1f};
  for (int i = 0; i < 6; ++i) draw_over_all(g, g.uniform(-0.9f, 0.9f));
  to::Disable{g, GL_DEPTH_TEST};
  to::Enable{g, GL_STENCIL_TEST};
  to::StencilOp{g, GL_KEEP, GL_KEEP, GL_KEEP};
  to::Color4f{g, 0, 0.05f, 0.1f, 0.1f};
  for (int i = 0; i < 6; ++i) {
    to::StencilFunc{g, GL_LESS, g.integer(0, 255), 0xff};
    draw_over_all(g, 0);
  }
}

}  // namespace clearpipe::conformance::random
