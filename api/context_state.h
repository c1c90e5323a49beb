// A context from within api/: state, objects, derived state and the frame being recorded.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "api/context.h"
#include "api/debug.h"
#include "api/invalid.h"
#include "api/state.h"
#include "pipeline/exec/frame.h"

namespace clearpipe::api {

// A vertex array object while it is not bound. They are not shared between contexts.
struct VertexArrayObject : VertexArrayState {
  explicit VertexArrayObject(GLuint) {}
  std::string label;
};

// NV_fence: not shared either.
struct FenceObject {
  explicit FenceObject(GLuint) {}
  GLenum condition = GL_ALL_COMPLETED_NV;
  uint64_t frame = 0;  // on the context's clock, when it was set
};

// What the context drew to images of the window system's comes there (native_image.h).
void store_native_images(Context& context) noexcept;

struct Context {
  std::shared_ptr<ShareGroup> share;
  State state;
  GLenum error = GL_NO_ERROR;
  Invalid raised;  // by the call that is running
  ContextFlags flags;
  DebugState debug;
  uint32_t dirty = kDirtyAll;
  TexturePtr default_texture = std::make_shared<TextureObject>(0, GL_TEXTURE_2D);
  TexturePtr default_cube_texture = std::make_shared<TextureObject>(0, GL_TEXTURE_CUBE_MAP_OES);
  TexturePtr default_external_texture = std::make_shared<TextureObject>(0, GL_TEXTURE_EXTERNAL_OES);

  // The surfaces EGL has bound, and what is drawn to and read from: these, or the images of the
  // framebuffer object (framebuffer.h).
  pipeline::Target surface_draw, surface_read;
  SurfaceOwner* surface_owner = nullptr;
  bool frame_expected = false;  // the owner wants to know when the surfaces are used again
  bool surface_drawn = false;   // since the owner was told
  std::vector<EglImagePtr> native_images;  // used since their owners were told (native_image.h)
  pipeline::Target draw, read;
  FramebufferPtr framebuffer;  // null: the window-system framebuffer
  RenderbufferPtr renderbuffer;
  NameTable<VertexArrayObject> vertex_arrays;
  NameTable<FenceObject> fences;
  VertexArrayState default_vertex_array;  // while another one is bound
  bool was_current = false;
  pipeline::Frame frame;
  pipeline::VertexState vertex_state;
  pipeline::MatrixPalette palette;  // of vertex_state
  bool palette_has_normals = false;
  pipeline::RasterState raster_state;
  pipeline::FragmentState fragment_state;
  std::array<uint64_t, kTextureUnits> texture_version{};  // derived from, per unit
  uint32_t textured = 0;  // bit u: unit u had a texture enabled, complete or not
  // The arrays of draws as they were last bound, with what that came to.
  pipeline::DrawCommand draw_command;
  bool arrays_drawable = false;              // all that are needed have elements
  bool client_arrays = false;                // some lie in client memory
  std::vector<BufferObject*> array_buffers;  // those of enabled arrays, which hold them
  uint64_t buffers_version = 0;              // of the share group, bound from
  FrameClock clock = std::make_shared<FrameCounter>();
  std::string renderer;

  TextureUnitState& active_unit() {
    return state.texture.unit[static_cast<size_t>(state.texture.active)];
  }
  const TextureUnitState& active_unit() const {
    return state.texture.unit[static_cast<size_t>(state.texture.active)];
  }
  // For the performance messages of the call that is running.
  void note_slow(Slow what) { debug.slow |= 1u << static_cast<GLuint>(what); }
  // Executes the frame. The only way to do it from api/: the clock goes on only when it succeeded.
  void finish_frame() {
    frame.finish();
    clock->advance();
  }
  void finish_frame(Slow why) {
    if (!frame.empty()) note_slow(why);
    finish_frame();
  }
  void tell_owner() {
    if (surface_drawn && surface_owner) surface_owner->surface_is_drawn();
    surface_drawn = false;
    if (!native_images.empty()) store_native_images(*this);
  }
  // The first error sticks until it is asked for (2.5).
  void set_error(const Invalid& wrong) {
    if (flags.no_error && wrong.error != GL_OUT_OF_MEMORY) return;
    if (error == GL_NO_ERROR) error = wrong.error;
    raised = wrong;
  }
};

// Sets a piece of state from which others are derived, unless it is that already: programs set much
// of what they need before each draw.
template <typename Value>
void set_state(Context& context, Value& to, const std::type_identity_t<Value>& value,
               uint32_t dirty) {
  if (to == value) return;
  to = value;
  context.dirty |= dirty;
}

// Brings the frame's pipeline state up to date with the context's.
void derive_vertex(Context& context);
void derive_raster(Context& context);
void derive_fragment(Context& context);

// Whether data of so many bytes may be written in place; else it must be replaced by a copy. A
// frame of this context that reads it is finished where copying would cost more.
bool may_write_in_place(Context& context, const FrameUses& uses, size_t bytes);

MatrixStack& current_stack(Context& context);
const MatrixStack& current_stack(const Context& context);

// The vertex array of that name (2.8), of CLIENT_ACTIVE_TEXTURE for texture coordinates; null if
// there is none.
ArrayState* find_array(ArraysState& arrays, GLenum name);
const ArrayState* find_array(const ArraysState& arrays, GLenum name);

// The boolean a capability enables (each in its section), with what it makes dirty; null value if
// the enumerant is none.
struct Capability {
  bool* value = nullptr;
  uint32_t dirty = 0;
};
Capability capability(Context& context, GLenum cap);

}  // namespace clearpipe::api
