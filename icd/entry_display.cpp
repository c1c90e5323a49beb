// EGL commands on errors, displays and configs (3.1 to 3.4).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <new>

#include "icd/entry.h"
#include "icd/extensions.h"
#include "icd/origin.h"
#include "icd/surface.h"

namespace clearpipe::icd::entry {

namespace {

// What a display offers: all that every one does, and what its configs allow.
std::string extensions_of(const Display& display) {
  const auto has = [&display](EGLint surfaces) {
    return std::any_of(display.configs.begin(), display.configs.end(), [=](const Config& config) {
      return (config.native_surfaces & surfaces) != 0;
    });
  };
  std::string list = kOffered<Offered::display>.data();
  if (has(EGL_WINDOW_BIT)) list += kOffered<Offered::windows>.data();
  if (has(EGL_PIXMAP_BIT)) list += kOffered<Offered::pixmaps>.data();
  return list;
}

EGLBoolean return_configs(const Config* const* list, size_t count, EGLConfig* configs, EGLint size,
                          EGLint* num_config) {
  if (configs == nullptr) {
    *num_config = static_cast<EGLint>(count);
    return succeed(EGL_TRUE);
  }
  EGLint n = 0;
  for (; n < size && n < static_cast<EGLint>(count); ++n) {
    configs[n] = const_cast<Config*>(list[n]);
  }
  *num_config = n;
  return succeed(EGL_TRUE);
}

}  // namespace

Display* initialized_display(EGLDisplay handle) {
  Display* display = find_display(handle);
  if (display == nullptr) return fail(EGL_BAD_DISPLAY, display);
  if (!display->initialized) return fail(EGL_NOT_INITIALIZED, static_cast<Display*>(nullptr));
  return display;
}

EGLint GetError() noexcept {
  const EGLint error = this_thread().error;
  this_thread().error = EGL_SUCCESS;
  return error;
}

EGLDisplay GetDisplay(EGLNativeDisplayType display_id) noexcept try {
  const std::optional<Origin> origin = detect_origin(reinterpret_cast<void*>(display_id));
  // An unknown native display matches nothing, which is no error (3.2).
  if (!origin) return succeed(EGL_NO_DISPLAY);
  const std::lock_guard<std::mutex> lock(egl_mutex());
  return succeed<EGLDisplay>(get_display(*origin));
} catch (const std::bad_alloc&) {
  return fail(EGL_BAD_ALLOC, EGL_NO_DISPLAY);
}

namespace {

template <class Attribute>
EGLDisplay get_platform_display(EGLenum platform, void* native_display,
                                const Attribute* attrib_list) noexcept try {
  Origin origin;
  EGLint error = origin_of(platform, native_display, origin);
  for (; error == EGL_SUCCESS && attrib_list != nullptr && *attrib_list != EGL_NONE;
       attrib_list += 2) {
    if (!is_screen_attribute(platform, attrib_list[0]) || attrib_list[1] < 0 ||
        attrib_list[1] > 0xffff) {
      error = EGL_BAD_ATTRIBUTE;
    } else {
      origin.screen = static_cast<EGLint>(attrib_list[1]);
    }
  }
  if (error != EGL_SUCCESS) return fail(error, EGL_NO_DISPLAY);
  const std::lock_guard<std::mutex> lock(egl_mutex());
  return succeed<EGLDisplay>(get_display(origin));
} catch (const std::bad_alloc&) {
  return fail(EGL_BAD_ALLOC, EGL_NO_DISPLAY);
}

}  // namespace

EGLDisplay GetPlatformDisplay(EGLenum platform, void* native_display,
                              const EGLAttrib* attrib_list) noexcept {
  return get_platform_display(platform, native_display, attrib_list);
}

EGLDisplay GetPlatformDisplayEXT(EGLenum platform, void* native_display,
                                 const EGLint* attrib_list) noexcept {
  return get_platform_display(platform, native_display, attrib_list);
}

EGLBoolean Initialize(EGLDisplay dpy, EGLint* major, EGLint* minor) noexcept try {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = find_display(dpy);
  if (display == nullptr) return fail(EGL_BAD_DISPLAY, EGL_FALSE);
  if (!display->initialized) {
    display->platform = open_platform(display->origin);
    if (display->platform == nullptr) return fail(EGL_NOT_INITIALIZED, EGL_FALSE);
    if (display->configs.empty()) {
      display->configs = display->platform->configs();
      EGLint id = 0;
      for (Config& config : display->configs) config.id = ++id;
      display->extensions = extensions_of(*display);
    }
    display->initialized = true;
  }
  if (major != nullptr) *major = 1;
  if (minor != nullptr) *minor = 5;
  return succeed(EGL_TRUE);
} catch (const std::bad_alloc&) {
  return fail(EGL_BAD_ALLOC, EGL_FALSE);
}

EGLBoolean Terminate(EGLDisplay dpy) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = find_display(dpy);
  if (display == nullptr) return fail(EGL_BAD_DISPLAY, EGL_FALSE);
  for (const auto& surface : display->surfaces) destroy(*surface);
  for (const auto& context : display->contexts) context->destroyed = true;
  for (const auto& sync : display->syncs) sync->signal();  // no thread waits for what is gone
  display->syncs.clear();
  display->images.clear();
  for (const auto& pixmap : display->image_pixmaps) {
    if (const auto open = pixmap.lock()) open->close();
  }
  display->image_pixmaps.clear();
  for (auto label = display->labels.begin(); label != display->labels.end();) {
    label = label->first == display ? std::next(label) : display->labels.erase(label);
  }
  display->sweep();
  display->platform = nullptr;
  display->initialized = false;
  return succeed(EGL_TRUE);
}

const char* QueryString(EGLDisplay dpy, EGLint name) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  const char* none = nullptr;
  if (dpy == EGL_NO_DISPLAY && (name == EGL_EXTENSIONS || name == EGL_VERSION)) {
    return succeed(name == EGL_EXTENSIONS ? kOffered<Offered::client, Offered::platform>.data()
                                          : "1.5 clearpipe");
  }
  const Display* display = initialized_display(dpy);
  if (display == nullptr) return none;
  switch (name) {
    case EGL_CLIENT_APIS:
      return succeed("OpenGL_ES");
    case EGL_EXTENSIONS:
      return succeed(display->extensions.c_str());
    case EGL_VENDOR:
      return succeed("clearpipe");
    case EGL_VERSION:
      return succeed("1.5 clearpipe");
    default:
      return fail(EGL_BAD_PARAMETER, none);
  }
}

const char* GetDisplayDriverName(EGLDisplay dpy) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  const char* none = nullptr;
  return initialized_display(dpy) != nullptr ? succeed("clearpipe") : none;
}

// There are no options. The caller frees the text.
char* GetDisplayDriverConfig(EGLDisplay dpy) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  char* none = nullptr;
  if (initialized_display(dpy) == nullptr) return none;
  char* text = strdup("<driinfo></driinfo>");
  return text != nullptr ? succeed(text) : fail(EGL_BAD_ALLOC, none);
}

EGLBoolean ReleaseThread() noexcept {
  Thread& thread = this_thread();
  finish_current(thread);
  const std::lock_guard<std::mutex> lock(egl_mutex());
  release_current(thread);
  thread.api = EGL_OPENGL_ES_API;
  thread.label = nullptr;
  return succeed(EGL_TRUE);
}

EGLBoolean GetConfigs(EGLDisplay dpy, EGLConfig* out, EGLint config_size,
                      EGLint* num_config) noexcept try {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  const Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  if (num_config == nullptr) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  std::vector<const Config*> list;
  for (const Config& config : display->configs) list.push_back(&config);
  return return_configs(list.data(), list.size(), out, config_size, num_config);
} catch (const std::bad_alloc&) {
  return fail(EGL_BAD_ALLOC, EGL_FALSE);
}

EGLBoolean ChooseConfig(EGLDisplay dpy, const EGLint* attrib_list, EGLConfig* out,
                        EGLint config_size, EGLint* num_config) noexcept try {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  const Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  if (num_config == nullptr) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  std::vector<const Config*> list;
  const auto is_pixmap = [display](EGLint handle) {
    return display->platform->has_pixmap(static_cast<uintptr_t>(handle));
  };
  if (const EGLint error = choose_configs(display->configs, attrib_list, is_pixmap, list);
      error != EGL_SUCCESS) {
    return fail(error, EGL_FALSE);
  }
  return return_configs(list.data(), list.size(), out, config_size, num_config);
} catch (const std::bad_alloc&) {
  return fail(EGL_BAD_ALLOC, EGL_FALSE);
}

EGLBoolean GetConfigAttrib(EGLDisplay dpy, EGLConfig config, EGLint attribute,
                           EGLint* value) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  const Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  const Config* found = display->config(config);
  if (found == nullptr) return fail(EGL_BAD_CONFIG, EGL_FALSE);
  if (value == nullptr) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  if (!config_attrib(*found, attribute, *value)) return fail(EGL_BAD_ATTRIBUTE, EGL_FALSE);
  return succeed(EGL_TRUE);
}

}  // namespace clearpipe::icd::entry
