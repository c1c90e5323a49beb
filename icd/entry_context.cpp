// EGL commands on contexts, and waiting (3.7, 3.8).
// SPDX-License-Identifier: MIT
#include <new>

#include "icd/entry.h"
#include "icd/surface.h"

namespace clearpipe::icd::entry {

namespace {

// 3.7.3: context and surface must have buffers that agree.
bool compatible(const Context& context, const Surface& surface) {
  const Config* a = context.config;
  const Config* b = surface.config;
  return a == nullptr ||
         (a->red == b->red && a->green == b->green && a->blue == b->blue && a->alpha == b->alpha &&
          a->depth == b->depth && a->stencil == b->stencil && a->samples == b->samples);
}

// The rendering API that is current: libglvnd keeps it, if it stands above us.
EGLenum (*current_api_source)() = nullptr;

bool surfaces_valid(const Context& context) {
  return (context.draw == nullptr || !context.draw->destroyed) &&
         (context.read == nullptr || !context.read->destroyed);
}

bool bound_elsewhere(const Surface& surface, const Context* previous) {
  return surface.current &&
         (previous == nullptr || (previous->draw != &surface && previous->read != &surface));
}

}  // namespace

void set_current_api_source(EGLenum (*source)()) { current_api_source = source; }

EGLBoolean BindAPI(EGLenum api) noexcept {
  if (api != EGL_OPENGL_ES_API) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  this_thread().api = api;
  return succeed(EGL_TRUE);
}

EGLenum QueryAPI() noexcept { return succeed(this_thread().api); }

EGLContext CreateContext(EGLDisplay dpy, EGLConfig config, EGLContext share_context,
                         const EGLint* attrib_list) noexcept try {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_NO_CONTEXT;
  // Another vendor's API may be bound, OpenGL for one; it renders to no config of ours (3.7.1).
  if (current_api_source != nullptr && current_api_source() != EGL_OPENGL_ES_API) {
    return fail(EGL_BAD_MATCH, EGL_NO_CONTEXT);
  }
  auto context = std::make_unique<Context>();
  if (config != EGL_NO_CONFIG_KHR) {
    context->config = display->config(config);
    if (context->config == nullptr) return fail(EGL_BAD_CONFIG, EGL_NO_CONTEXT);
  }
  if (const EGLint error = parse_context_attributes(attrib_list, context->attributes);
      error != EGL_SUCCESS) {
    return fail(error, EGL_NO_CONTEXT);
  }
  api::Context* share = nullptr;
  if (share_context != EGL_NO_CONTEXT) {
    const Context* other = find_context(share_context);
    if (other == nullptr) return fail(EGL_BAD_CONTEXT, EGL_NO_CONTEXT);
    if (display->context(share_context) != other ||
        !may_share(other->attributes, context->attributes)) {
      return fail(EGL_BAD_MATCH, EGL_NO_CONTEXT);
    }
    share = other->context;
  }
  context->context = api::create_context(share, context_flags(context->attributes), context.get());
  if (context->context == nullptr) return fail(EGL_BAD_ALLOC, EGL_NO_CONTEXT);
  display->contexts.push_back(std::move(context));
  return succeed<EGLContext>(display->contexts.back()->handle);
} catch (const std::bad_alloc&) {
  return fail(EGL_BAD_ALLOC, EGL_NO_CONTEXT);
}

EGLBoolean DestroyContext(EGLDisplay dpy, EGLContext ctx) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  Context* context = display->context(ctx);
  if (context == nullptr) return fail(EGL_BAD_CONTEXT, EGL_FALSE);
  context->destroyed = true;
  display->labels.erase(ctx);
  display->sweep();
  return succeed(EGL_TRUE);
}

EGLBoolean MakeCurrent(EGLDisplay dpy, EGLSurface draw, EGLSurface read, EGLContext ctx) noexcept
    try {
  Thread& thread = this_thread();
  finish_current(thread);
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = find_display(dpy);
  if (display == nullptr) return fail(EGL_BAD_DISPLAY, EGL_FALSE);
  const bool release_only =
      ctx == EGL_NO_CONTEXT && draw == EGL_NO_SURFACE && read == EGL_NO_SURFACE;
  // Only a release is allowed on a display that is not initialized (3.7.3).
  if (!display->initialized && !release_only) return fail(EGL_NOT_INITIALIZED, EGL_FALSE);
  if (ctx == EGL_NO_CONTEXT) {
    if (draw != EGL_NO_SURFACE || read != EGL_NO_SURFACE) return fail(EGL_BAD_MATCH, EGL_FALSE);
    release_current(thread);
    return succeed(EGL_TRUE);
  }
  Context* context = display->context(ctx);
  if (context == nullptr) return fail(EGL_BAD_CONTEXT, EGL_FALSE);
  if ((draw == EGL_NO_SURFACE) != (read == EGL_NO_SURFACE)) return fail(EGL_BAD_MATCH, EGL_FALSE);
  Surface* draw_surface = draw == EGL_NO_SURFACE ? nullptr : display->surface(draw);
  Surface* read_surface = read == EGL_NO_SURFACE ? nullptr : display->surface(read);
  if (draw != EGL_NO_SURFACE && (draw_surface == nullptr || read_surface == nullptr)) {
    return fail(EGL_BAD_SURFACE, EGL_FALSE);
  }
  if (context->current && thread.context != context) return fail(EGL_BAD_ACCESS, EGL_FALSE);
  for (const Surface* surface : {draw_surface, read_surface}) {
    if (surface == nullptr) continue;
    if (surface->lock || bound_elsewhere(*surface, thread.context))
      return fail(EGL_BAD_ACCESS, EGL_FALSE);
    if (!compatible(*context, *surface)) return fail(EGL_BAD_MATCH, EGL_FALSE);
  }
  for (Surface* surface : {draw_surface, read_surface}) {
    if (surface != nullptr && !follow_size(*surface)) return fail(EGL_BAD_NATIVE_WINDOW, EGL_FALSE);
  }
  if (thread.context != context) release_current(thread);
  if (context->draw != nullptr) context->draw->current = false;
  if (context->read != nullptr) context->read->current = false;
  const pipeline::Target none;
  if (!api::make_current(context->context, draw_surface != nullptr ? draw_surface->target : none,
                         read_surface != nullptr ? read_surface->target : none)) {
    return fail(EGL_BAD_ALLOC, EGL_FALSE);
  }
  api::expect_frame(context->context);
  context->current = true;
  context->draw = draw_surface;
  context->read = read_surface;
  if (draw_surface != nullptr) draw_surface->current = read_surface->current = true;
  thread.context = context;
  thread.display = display;
  display->sweep();
  return succeed(EGL_TRUE);
} catch (const std::bad_alloc&) {
  return fail(EGL_BAD_ALLOC, EGL_FALSE);
}

EGLContext GetCurrentContext() noexcept {
  const Context* context = this_thread().context;
  return succeed<EGLContext>(context != nullptr ? context->handle : EGL_NO_CONTEXT);
}

EGLSurface GetCurrentSurface(EGLint readdraw) noexcept {
  const Context* context = this_thread().context;
  if (readdraw != EGL_DRAW && readdraw != EGL_READ) return fail(EGL_BAD_PARAMETER, EGL_NO_SURFACE);
  if (context == nullptr) return succeed(EGL_NO_SURFACE);
  const Surface* surface = readdraw == EGL_DRAW ? context->draw : context->read;
  return succeed<EGLSurface>(surface != nullptr ? surface->handle : EGL_NO_SURFACE);
}

EGLDisplay GetCurrentDisplay() noexcept { return succeed<EGLDisplay>(this_thread().display); }

EGLBoolean QueryContext(EGLDisplay dpy, EGLContext ctx, EGLint attribute, EGLint* value) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  const Context* context = display->context(ctx);
  if (context == nullptr) return fail(EGL_BAD_CONTEXT, EGL_FALSE);
  if (value == nullptr) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  switch (attribute) {
    case EGL_CONFIG_ID:
      *value = context->config != nullptr ? context->config->id : 0;
      break;
    case EGL_CONTEXT_CLIENT_TYPE:
      *value = EGL_OPENGL_ES_API;
      break;
    case EGL_CONTEXT_CLIENT_VERSION:
      *value = 1;
      break;
    case EGL_RENDER_BUFFER:
      *value = context->draw == nullptr                        ? EGL_NONE
               : context->draw->kind == Surface::Kind::kPixmap ? EGL_SINGLE_BUFFER
                                                               : EGL_BACK_BUFFER;
      break;
    default:
      return fail(EGL_BAD_ATTRIBUTE, EGL_FALSE);
  }
  return succeed(EGL_TRUE);
}

EGLBoolean WaitClient() noexcept {
  const Thread& thread = this_thread();
  finish_current(thread);
  const std::lock_guard<std::mutex> lock(egl_mutex());
  if (thread.context != nullptr && !surfaces_valid(*thread.context)) {
    return fail(EGL_BAD_CURRENT_SURFACE, EGL_FALSE);
  }
  return succeed(EGL_TRUE);
}

EGLBoolean WaitGL() noexcept { return WaitClient(); }

EGLBoolean WaitNative(EGLint engine) noexcept {
  if (engine != EGL_CORE_NATIVE_ENGINE) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  const Thread& thread = this_thread();
  finish_current(thread);
  const std::lock_guard<std::mutex> lock(egl_mutex());
  const Context* context = thread.context;
  if (context == nullptr) return succeed(EGL_TRUE);
  if (!surfaces_valid(*context)) return fail(EGL_BAD_CURRENT_SURFACE, EGL_FALSE);
  api::load_native_images();
  for (const Surface* surface : {context->draw, context->read}) {
    if (surface != nullptr && surface->kind == Surface::Kind::kPixmap) {
      surface->native->fetch(*surface->target.colour);
    }
  }
  return succeed(EGL_TRUE);
}

}  // namespace clearpipe::icd::entry
