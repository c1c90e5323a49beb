// The life of a context and its binding to a thread.
// SPDX-License-Identifier: MIT
#include "api/context.h"

#include <algorithm>
#include <new>

#include "api/context_state.h"
#include "api/framebuffer.h"
#include "pipeline/simd.h"

namespace clearpipe::api {

namespace {
#if defined(__GNUC__)
__attribute__((tls_model("initial-exec")))
#endif
thread_local Context* current = nullptr;
}  // namespace

Context* create_context(Context* share, ContextFlags flags, SurfaceOwner* owner) noexcept try {
  auto context = std::make_unique<Context>();
  context->share = share ? share->share : std::make_shared<ShareGroup>();
  for (TextureUnitState& unit : context->state.texture.unit) {
    unit.texture = context->default_texture;
    unit.cube_texture = context->default_cube_texture;
    unit.external_texture = context->default_external_texture;
  }
  context->surface_owner = owner;
  context->debug.output = flags.debug;
  context->flags = flags;
  pipeline::select_simd_target();
  context->renderer = std::string("clearpipe (") + pipeline::simd_target_name() + ")";
  return context.release();
} catch (...) {
  return nullptr;
}

void destroy_context(Context* context) noexcept {
  if (!context) return;
  finish(context);
  if (current == context) current = nullptr;
  const FrameClock clock = context->clock;
  delete context;
  clock->advance();  // whatever became of its last frame
}

bool make_current(Context* context, const pipeline::Target& draw,
                  const pipeline::Target& read) noexcept {
  if (current) finish(current);
  current = context;
  if (!context) return true;
  set_targets(context, draw, read);
  if (!context->was_current) {
    context->was_current = true;
    GLint* viewport = context->state.transform.viewport;
    GLint* scissor = context->state.pixel.scissor;
    viewport[2] = scissor[2] = std::min(draw.width, kMaxViewport);
    viewport[3] = scissor[3] = std::min(draw.height, kMaxViewport);
  }
  return true;
}

Context* current_context() noexcept { return current; }

void finish(Context* context) noexcept try {
  context->finish_frame();
  context->tell_owner();
} catch (...) {
  context->set_error(kOutOfMemory);
}

void expect_frame(Context* context) noexcept {
  context->frame_expected = context->surface_owner != nullptr;
}

void begin_frame(Context* context) noexcept {
  if (!context->frame_expected) return;
  context->frame_expected = false;
  context->surface_owner->frame_begins();
}

void set_targets(Context* context, const pipeline::Target& draw,
                 const pipeline::Target& read) noexcept try {
  context->surface_draw = draw;
  context->surface_read = read;
  if (!context->framebuffer) use_targets(*context, draw, read);
} catch (...) {
  context->set_error(kOutOfMemory);
}

}  // namespace clearpipe::api
