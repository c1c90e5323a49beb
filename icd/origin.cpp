// See origin.h.
// SPDX-License-Identifier: MIT
#include "icd/origin.h"

#include <array>
#include <cstdlib>
#include <string_view>

#include "icd/wayland_platform.h"
#include "icd/x11_library.h"
#include "icd/x11_platform.h"

namespace clearpipe::icd {

namespace {

// The values of EGL_PLATFORM, as with Mesa.
struct PlatformName {
  std::string_view name;
  EGLenum platform;
};
constexpr std::array kNames = {
    PlatformName{"x11", EGL_PLATFORM_X11_KHR},
    PlatformName{"xcb", EGL_PLATFORM_XCB_EXT},
    PlatformName{"wayland", EGL_PLATFORM_WAYLAND_KHR},
    PlatformName{"surfaceless", EGL_PLATFORM_SURFACELESS_MESA},
    PlatformName{"device", EGL_PLATFORM_DEVICE_EXT},
};

EGLenum platform_of_environment() {
  const char* value = std::getenv("EGL_PLATFORM");
  if (value == nullptr) return EGL_NONE;
  for (const PlatformName& known : kNames) {
    if (known.name == value) return known.platform;
  }
  return EGL_NONE;
}

// Whether there is a server at $DISPLAY.
bool x11_answers() {
  const char* name = std::getenv("DISPLAY");
  return name != nullptr && *name != '\0' && open_x11(nullptr, nullptr, -1) != nullptr;
}

// A connection that is inherited can be opened but once, so it is believed to work.
bool wayland_answers() {
  const char* inherited = std::getenv("WAYLAND_SOCKET");
  if (inherited != nullptr && *inherited != '\0') return true;
  const char* name = std::getenv("WAYLAND_DISPLAY");
  return name != nullptr && *name != '\0' && open_wayland(nullptr) != nullptr;
}

EGLenum default_platform() {
  if (x11_answers()) return EGL_PLATFORM_X11_KHR;
  if (wayland_answers()) return EGL_PLATFORM_WAYLAND_KHR;
  return EGL_PLATFORM_SURFACELESS_MESA;
}

}  // namespace

EGLenum platform_of(void* native_display) {
  if (is_wayland_display(native_display)) return EGL_PLATFORM_WAYLAND_KHR;
  if (is_xlib_display(native_display)) return EGL_PLATFORM_X11_KHR;
  return EGL_NONE;
}

EGLint origin_of(EGLenum platform, void* native_display, Origin& out) {
  out = {platform, native_display, -1};
  switch (platform) {
    case EGL_PLATFORM_SURFACELESS_MESA:
      return native_display == nullptr ? EGL_SUCCESS : EGL_BAD_PARAMETER;
    case EGL_PLATFORM_DEVICE_EXT:
      return native_display == the_device() ? EGL_SUCCESS : EGL_BAD_PARAMETER;
    case EGL_PLATFORM_X11_KHR:
    case EGL_PLATFORM_XCB_EXT:
    case EGL_PLATFORM_WAYLAND_KHR:
      return EGL_SUCCESS;
    default:
      return EGL_BAD_PARAMETER;
  }
}

bool is_screen_attribute(EGLenum platform, EGLAttrib attribute) {
  return (platform == EGL_PLATFORM_X11_KHR && attribute == EGL_PLATFORM_X11_SCREEN_KHR) ||
         (platform == EGL_PLATFORM_XCB_EXT && attribute == EGL_PLATFORM_XCB_SCREEN_EXT);
}

bool has_native_surfaces(const Origin& origin) {
  return origin.platform != EGL_PLATFORM_SURFACELESS_MESA &&
         origin.platform != EGL_PLATFORM_DEVICE_EXT;
}

std::optional<Origin> detect_origin(void* native_display) {
  EGLenum platform = platform_of_environment();
  if (platform == EGL_NONE) {
    platform = native_display != nullptr ? platform_of(native_display) : default_platform();
  }
  if (platform == EGL_PLATFORM_DEVICE_EXT && native_display == nullptr) {
    native_display = the_device();
  }
  Origin origin;
  if (origin_of(platform, native_display, origin) != EGL_SUCCESS) return std::nullopt;
  return origin;
}

std::shared_ptr<Platform> open_platform(const Origin& origin) {
  switch (origin.platform) {
    case EGL_PLATFORM_X11_KHR:
      return open_x11(origin.native, nullptr, origin.screen);
    case EGL_PLATFORM_XCB_EXT:
      return open_x11(nullptr, static_cast<xcb_connection_t*>(origin.native), origin.screen);
    case EGL_PLATFORM_WAYLAND_KHR:
      return open_wayland(static_cast<wl_display*>(origin.native));
    default:
      return std::make_shared<Platform>();
  }
}

}  // namespace clearpipe::icd
