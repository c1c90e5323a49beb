// Puts the parts of a stream in order: state, then drawing and small changes of state in turns,
// then what makes depth and stencil visible.
// SPDX-License-Identifier: MIT
#include "conformance/random/generate.h"

#include "conformance/random/generator.h"

namespace clearpipe::conformance::random {

const char* name_of(Group group) {
  static constexpr const char* kNames[] = {
#define GROUP(name) #name,
#include "conformance/random/groups.def"
#undef GROUP
  };
  return kNames[static_cast<size_t>(group)];
}

Groups groups_of(uint32_t seed) {
  Groups groups;
  groups.set(seed % kGroups);
  // Another engine than the stream's, so that the choice leaves its numbers alone.
  Random random(~seed);
  for (uint32_t more = random.below(4); more > 0; --more) groups.set(random.below(kGroups));
  return groups;
}

namespace {

void clear_all(Generator& g) {
  to::ClearColor{g, g.uniform(0, 1), g.uniform(0, 1), g.uniform(0, 1), g.uniform(0, 1)};
  // Not 1: primitives beyond it are needed.
  to::ClearDepthf{g, g.uniform(0.3f, 0.9f)};
  to::ClearStencil{g, g.integer(0, 255)};
  to::Clear{g, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT};
}

// Clears of some buffers, of a part, under masks.
void clear_some(Generator& g) {
  to::Enable{g, GL_SCISSOR_TEST};
  to::Scissor{g, g.integer(-20, 90), g.integer(-20, 90), g.integer(0, 120), g.integer(0, 120)};
  to::ColorMask{g, g.chance(0.8f), g.chance(0.8f), g.chance(0.8f), g.chance(0.8f)};
  to::DepthMask{g, g.chance(0.8f)};
  to::StencilMask{g, g.random.byte()};
  clear_all(g);
  to::Clear{g,
            g.one_of<GLbitfield>({GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT,
                                  GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT})};
  to::Disable{g, GL_SCISSOR_TEST};
  to::ColorMask{g, 1, 1, 1, 1};
  to::DepthMask{g, 1};
  to::StencilMask{g, 0xff};
}

// 4.3.1: parts, some of which reach over the edge.
void read_some(Generator& g) {
  to::ReadPixels{g,
                 g.integer(-10, 100),
                 g.integer(-10, 120),
                 g.integer(1, 100),
                 g.integer(1, 20),
                 GL_RGBA,
                 GL_UNSIGNED_BYTE,
                 0};
}

void ask_values(Generator& g) {
  for (const GLenum pname : {GL_MODELVIEW_MATRIX,
                             GL_PROJECTION_MATRIX,
                             GL_TEXTURE_MATRIX,
                             GL_CURRENT_COLOR,
                             GL_CURRENT_NORMAL,
                             GL_FOG_COLOR,
                             GL_FOG_DENSITY,
                             GL_VIEWPORT,
                             GL_SCISSOR_BOX,
                             GL_DEPTH_RANGE,
                             GL_DEPTH_FUNC,
                             GL_STENCIL_FUNC,
                             GL_STENCIL_REF,

                             GL_ALPHA_TEST_REF,
                             GL_LINE_WIDTH,
                             GL_POINT_SIZE,
                             GL_POINT_DISTANCE_ATTENUATION,
                             GL_POLYGON_OFFSET_FACTOR,
                             GL_COLOR_CLEAR_VALUE,
                             GL_DEPTH_CLEAR_VALUE,
                             GL_MATRIX_MODE,
                             GL_MODELVIEW_STACK_DEPTH,
                             GL_SHADE_MODEL,
                             GL_CULL_FACE_MODE,
                             GL_LOGIC_OP_MODE,
                             GL_ACTIVE_TEXTURE,
                             GL_TEXTURE_BINDING_2D,
                             GL_ARRAY_BUFFER_BINDING}) {
    to::GetFloatv{g, pname, 0};
  }
}

}  // namespace

Stream generate(uint32_t seed) {
  Stream stream;
  Generator g(seed, stream);
  // Each step ends by asking for its error.
  const auto step = [&](auto&& part) {
    part(g);
    to::GetError{g};
  };
  step(clear_all);
  step(set_projection);
  step(set_lighting);
  step(set_clip_planes);
  step(set_rasterization);
  step(set_textures);
  step(set_fog);
  step(set_fragment_operations);
  const int draws = g.integer(1, 3);
  for (int i = 0; i < draws; ++i) {
    if (g.has(Group::clears) && i > 0) step(clear_some);
    if (g.has(Group::errors)) step(make_errors);
    step(draw_something);
    if (g.has(Group::reads)) step(read_some);
    if (i + 1 < draws) {
      step(change_textures);
      step(change_fragment_operations);
    }
  }
  step(ask_values);
  step(show_depth_and_stencil);
  return stream;
}

}  // namespace clearpipe::conformance::random
