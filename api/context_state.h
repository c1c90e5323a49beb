// A context from within api/: state, objects, derived state and the frame being recorded.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "api/context.h"
#include "api/state.h"
#include "pipeline/exec/frame.h"

namespace clearpipe::api {

struct Context {
  std::shared_ptr<ShareGroup> share;
  State state;
  GLenum error = GL_NO_ERROR;
  uint32_t dirty = kDirtyAll;
  TexturePtr default_texture = std::make_shared<TextureObject>();

  pipeline::Target draw, read;
  bool was_current = false;
  pipeline::Frame frame;
  pipeline::VertexState vertex_state;
  pipeline::RasterState raster_state;
  pipeline::FragmentState fragment_state;
  std::string renderer;

  TextureUnitState& active_unit() {
    return state.texture.unit[static_cast<size_t>(state.texture.active)];
  }
  const TextureUnitState& active_unit() const {
    return state.texture.unit[static_cast<size_t>(state.texture.active)];
  }
  // The first error sticks until it is asked for (2.5).
  void set_error(GLenum value) {
    if (error == GL_NO_ERROR) error = value;
  }
};

// Brings the frame's pipeline state up to date with the context's.
void derive_vertex(Context& context);
void derive_raster(Context& context);
void derive_fragment(Context& context);

MatrixStack& current_stack(Context& context);
const MatrixStack& current_stack(const Context& context);

// The boolean a capability enables (2.4 and each section), with what it makes dirty; null value if
// the enumerant is none.
struct Capability {
  bool* value = nullptr;
  uint32_t dirty = 0;
};
Capability capability(Context& context, GLenum cap);

}  // namespace clearpipe::api
