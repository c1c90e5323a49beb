// From what programs hand to eglGetDisplay and eglGetPlatformDisplay (3.2) to a platform.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "icd/display.h"

namespace clearpipe::icd {

// The extensions of the platforms there are.
#define PLATFORM_EXTENSIONS                                                \
  "EGL_EXT_platform_device EGL_EXT_platform_wayland EGL_EXT_platform_x11 " \
  "EGL_EXT_platform_xcb EGL_KHR_platform_wayland EGL_KHR_platform_x11 "    \
  "EGL_MESA_platform_surfaceless"

// The origin that eglGetPlatformDisplay's arguments name; the EGL error, or EGL_SUCCESS.
EGLint origin_of(EGLenum platform, void* native_display, Origin& out);

// Whether it is the attribute that chooses a screen of the platform.
bool is_screen_attribute(EGLenum platform, EGLAttrib attribute);

// Whether its displays have windows or pixmaps. Those of EGL_MESA_platform_surfaceless and
// EGL_EXT_platform_device do not.
bool has_native_surfaces(const Origin& origin);

// What eglGetDisplay's argument is: as $EGL_PLATFORM says, else as it looks; for
// EGL_DEFAULT_DISPLAY a window system that can be reached, else none. None at all: nothing that is
// known.
std::optional<Origin> detect_origin(void* native_display);

// The platform of a native display as it looks, for libglvnd; EGL_NONE: unknown.
EGLenum platform_of(void* native_display);

// The platform behind an origin; null: it cannot be opened.
std::shared_ptr<Platform> open_platform(const Origin& origin);

}  // namespace clearpipe::icd
