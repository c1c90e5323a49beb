// The objects of EGL and the rules of their lives: displays own surfaces, contexts and syncs; a
// destroyed object lives on while it is current (3.5.5, 3.7.3). The handle of such an object is a
// number that is never given again, so a handle kept too long cannot name a newer object; the
// handle of a display is its address, because libglvnd must tell the displays of several vendors
// apart. SPDX-License-Identifier: MIT
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "api/context.h"
#include "icd/context_attributes.h"
#include "icd/lock_surface.h"
#include "icd/platform.h"
#include "icd/sync.h"
#include "pipeline/surface.h"

namespace clearpipe::icd {

// What surfaces and contexts have in common.
struct Object {
  void* const handle = next_handle();
  bool current = false;    // bound to some thread
  bool destroyed = false;  // its handle is void; it goes when it is no longer current
  static void* next_handle();
};

struct Surface : Object {
  const Config* config = nullptr;
  pipeline::Target target;               // what is drawn to and read
  std::vector<pipeline::Target> levels;  // of a mipmap, one of which is the target
  // Of a window they change on the thread to which it is current, while others may ask for them.
  std::atomic<EGLint> width = 0, height = 0;
  bool largest_pbuffer = false;
  bool mipmap_texture = false;
  EGLint texture_format = EGL_NO_TEXTURE, texture_target = EGL_NO_TEXTURE;
  std::weak_ptr<api::SurfaceTexture> texture;  // expired: it is bound to none
  EGLint gl_colorspace = EGL_GL_COLORSPACE_LINEAR;
  EGLint swap_behavior = EGL_BUFFER_PRESERVED;
  bool swap_behavior_is_set = false;  // by the program
  EGLint multisample_resolve = EGL_MULTISAMPLE_RESOLVE_DEFAULT;
  EGLint mipmap_level = 0;
  std::unique_ptr<SurfaceLock> lock;  // EGL_KHR_lock_surface3: null while it is not locked

  // Of windows and pixmaps.
  enum class Kind { kPbuffer, kWindow, kPixmap };
  Kind kind = Kind::kPbuffer;
  std::shared_ptr<NativeSurface> native;
  EGLint render_buffer = EGL_BACK_BUFFER;
  EGLint swap_interval = 1;
  bool was_posted = false;     // the window shows these buffers, as they were
  bool age_is_known = false;   // EGL_BUFFER_AGE was asked for in this frame
  bool damage_is_set = false;  // EGL_KHR_partial_update
  ~Surface() {
    if (native != nullptr) native->close();
  }
};

struct Context : Object, api::SurfaceOwner {
  const Config* config = nullptr;  // null: created without a config
  ContextAttributes attributes;
  api::Context* context = nullptr;
  Surface* draw = nullptr;
  Surface* read = nullptr;
  ~Context() {
    if (context != nullptr) api::destroy_context(context);
  }
  void frame_begins() noexcept override;
  void surface_is_drawn() noexcept override;
};

// An EGLImage: api/ has what is behind the handle.
struct Image {
  void* const handle;
  explicit Image(void* image_handle) : handle(image_handle) {}
  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;
  ~Image() { api::destroy_egl_image(handle); }
};

// What a display is a display of; displays of equal origin are one (3.2).
struct Origin {
  EGLenum platform = EGL_PLATFORM_SURFACELESS_MESA;
  void* native = nullptr;
  EGLint screen = -1;  // the default one
  bool operator==(const Origin&) const = default;
};

struct Display {
  const Origin origin;
  bool initialized = false;
  std::shared_ptr<Platform> platform;  // of an initialized display
  std::vector<Config> configs;         // made once, so that their handles stay
  std::string extensions;
  std::vector<std::unique_ptr<Surface>> surfaces;
  std::vector<std::unique_ptr<Context>> contexts;
  std::vector<std::shared_ptr<Sync>> syncs;
  std::vector<std::unique_ptr<Image>> images;
  // Of images, which may live on in textures: to be closed with the display.
  std::vector<std::weak_ptr<NativeSurface>> image_pixmaps;
  std::map<const void*, EGLLabelKHR> labels;  // of the display and its objects (EGL_KHR_debug)

  explicit Display(const Origin& display_origin) : origin(display_origin) {}
  const Config* config(EGLConfig handle) const;
  Surface* surface(EGLSurface handle);  // null: no living surface of this display
  Context* context(EGLContext handle);
  std::shared_ptr<Sync> sync(EGLSync handle) const;
  bool has_image(EGLImage handle) const;

  // Frees what is destroyed and not current; after eglTerminate everything counts as destroyed.
  void sweep();
};

// All EGL state of the process is guarded by this.
std::mutex& egl_mutex();

// All displays there are. They are never freed: a handle stays good for the life of the process
// (3.2).
const std::vector<std::unique_ptr<Display>>& displays();

// The display of a handle, or null.
Display* find_display(EGLDisplay handle);

// The one device (EGL_EXT_device_query).
EGLDeviceEXT the_device();

// The display of an origin, created at the first call.
Display* get_display(const Origin& origin);

// The living context of a handle, of whatever display, or null.
Context* find_context(EGLContext handle);

// What a thread has bound (2.3, 3.7.1). A thread that ends releases its context.
struct Thread {
  EGLint error = EGL_SUCCESS;
  EGLenum api = EGL_OPENGL_ES_API;
  Display* display = nullptr;
  Context* context = nullptr;
  EGLLabelKHR label = nullptr;
  ~Thread();
};
Thread& this_thread();

// Executes what the thread's context has recorded. Called without the mutex, so that a long frame
// holds up no other thread; a context that is current here can be freed by no one else.
void finish_current(const Thread& thread);

// Makes the buffers of the surfaces that a current context has the ones it draws to and reads.
void bind_targets(Context& context);

// Releases the thread's context and surfaces. Call finish_current before.
void release_current(Thread& thread);

}  // namespace clearpipe::icd
