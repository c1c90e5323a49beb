// Contexts as icd/ sees them: created, made current with targets to draw to and read from, and
// asked for the address of an entry point. Everything else of a context is private to api/.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "pipeline/surface.h"

namespace clearpipe::api {

struct Context;

// EGL_CONTEXT_OPENGL_DEBUG: debug output is enabled at first (KHR_debug). EGL's no-error attribute:
// errors are not reported, except for OUT_OF_MEMORY; calls that are wrong still do nothing.
// `robust_access` and `lose_on_reset` can be asked for (EXT_robustness): every context treats
// buffers like that, and none is ever reset.
struct ContextFlags {
  bool debug = false, no_error = false, robust_access = false, lose_on_reset = false;
};

// Whoever owns the surfaces of a context hears of what the context does with them.
class SurfaceOwner {
 public:
  // Before the first command since expect_frame() that draws to a surface or reads it: here it may
  // set_targets(), as a window may have another size by now. Objects that contexts share are
  // locked.
  virtual void frame_begins() noexcept = 0;
  // By finish(), Finish and Flush: something new is in the surface.
  virtual void surface_is_drawn() noexcept = 0;

 protected:
  ~SurfaceOwner() = default;
};

// Null when memory does not suffice. Textures and buffers are shared with `share` if given.
Context* create_context(Context* share, ContextFlags flags = {},
                        SurfaceOwner* owner = nullptr) noexcept;

// The context must not be current to any thread.
void destroy_context(Context* context) noexcept;

// Binds the context to this thread; a former one is flushed. Null releases. Targets without a
// colour buffer are allowed: draws then give INVALID_FRAMEBUFFER_OPERATION. The first call sets
// viewport and scissor box to the size of `draw` (2.10.1, 4.1.2). False: out of memory.
bool make_current(Context* context, const pipeline::Target& draw,
                  const pipeline::Target& read) noexcept;

Context* current_context() noexcept;

// Executes everything recorded: the draw target then holds the result.
void finish(Context* context) noexcept;

// A frame begins with the next command that draws to a surface or reads it, or by begin_frame().
void expect_frame(Context* context) noexcept;
void begin_frame(Context* context) noexcept;

// Replaces the targets, for a surface that was resized or swapped. Finish first.
void set_targets(Context* context, const pipeline::Target& draw,
                 const pipeline::Target& read) noexcept;

// EGLImages (3.9 of EGL 1.5): a level of a texture or a renderbuffer of the context's share group
// is shared under a handle, which OES_EGL_image takes in any context until it is destroyed. What
// shares the image goes on sharing it after that. Finish the thread's own context before: its frame
// may draw to the source.
enum class ImageSource {
  kTexture2D,
  kCubePositiveX,
  kCubeNegativeX,
  kCubePositiveY,
  kCubeNegativeY,
  kCubePositiveZ,
  kCubeNegativeZ,
  kRenderbuffer
};
enum class ImageError { kNone, kBadParameter, kBadMatch, kBadAccess, kBadAlloc };
ImageError create_egl_image(Context* context, ImageSource source, unsigned name, int level,
                            const void* handle) noexcept;
void destroy_egl_image(const void* handle) noexcept;

// Pixels of the window system's that are shared as an EGLImage (EGL_KHR_image_pixmap): RGBA8, rows
// from the bottom. Both calls may come from any thread, one at a time.
class NativeImage {
 public:
  NativeImage(int image_width, int image_height, bool alpha)
      : width(image_width), height(image_height), has_alpha(alpha) {}
  virtual ~NativeImage() = default;
  NativeImage(const NativeImage&) = delete;
  NativeImage& operator=(const NativeImage&) = delete;
  const int width, height;
  const bool has_alpha;

  // What the window system holds; false: it cannot be had.
  virtual bool load(uint32_t* pixels) noexcept = 0;
  // What a context drew, when it finishes or flushes.
  virtual void store(const uint32_t* pixels) noexcept = 0;
};
ImageError create_egl_image(std::shared_ptr<NativeImage> native, const void* handle) noexcept;

// All such images take over what the window system holds by now (eglWaitNative). A program that
// makes a texture of one of them gets that besides.
void load_native_images() noexcept;

// eglBindTexImage (3.6 of EGL 1.5): the texture bound to the context's active unit gets the colours
// of a surface as its levels, from the base level on, as a copy. With `mipmap`, a texture that
// wants it gets those above the base level by mipmap generation. The result stands for the binding,
// which ends when it is released, or when the texture is specified otherwise or deleted: then it
// expires. Nothing is bound if it is expired from the start: memory does not suffice. Finish
// before.
struct SurfaceTexture;
bool takes_surface_texture(Context* context) noexcept;  // not if it is immutable
std::weak_ptr<SurfaceTexture> bind_surface_texture(
    Context* context, const std::vector<std::shared_ptr<pipeline::ColourBuffer>>& levels,
    bool alpha, bool mipmap) noexcept;
void release_surface_texture(std::weak_ptr<SurfaceTexture> binding) noexcept;

// Whether errors are to be explained on stderr (CLEARPIPE_DEBUG=1).
bool debug_to_stderr() noexcept;

using Proc = void (*)();

// The entry point of that name, or null.
Proc proc_address(const char* name) noexcept;

}  // namespace clearpipe::api
