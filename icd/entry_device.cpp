// EGL commands on devices: EGL_EXT_device_query, EGL_EXT_device_enumeration (together
// EGL_EXT_device_base) and EGL_EXT_device_query_name. There is one device, this processor. Programs
// that see several vendors through libglvnd tell them apart by their devices.
// SPDX-License-Identifier: MIT
#include "icd/entry.h"
#include "icd/extensions.h"

namespace clearpipe::icd::entry {

EGLBoolean QueryDevicesEXT(EGLint max_devices, EGLDeviceEXT* devices,
                           EGLint* num_devices) noexcept {
  if (num_devices == nullptr || (devices != nullptr && max_devices <= 0)) {
    return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  }
  if (devices != nullptr) devices[0] = the_device();
  *num_devices = 1;
  return succeed(EGL_TRUE);
}

EGLBoolean QueryDeviceAttribEXT(EGLDeviceEXT device, EGLint, EGLAttrib*) noexcept {
  if (device != the_device()) return fail(EGL_BAD_DEVICE_EXT, EGL_FALSE);
  return fail(EGL_BAD_ATTRIBUTE, EGL_FALSE);  // no attribute is defined
}

const char* QueryDeviceStringEXT(EGLDeviceEXT device, EGLint name) noexcept {
  const char* none = nullptr;
  if (device != the_device()) return fail(EGL_BAD_DEVICE_EXT, none);
  switch (name) {
    case EGL_EXTENSIONS:
      return succeed(kOffered<Offered::device>.data());
    case EGL_VENDOR:
    case EGL_RENDERER_EXT:
      return succeed("clearpipe");
    default:
      return fail(EGL_BAD_PARAMETER, none);
  }
}

EGLBoolean QueryDisplayAttribEXT(EGLDisplay dpy, EGLint attribute, EGLAttrib* value) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  if (initialized_display(dpy) == nullptr) return EGL_FALSE;
  if (attribute != EGL_DEVICE_EXT) return fail(EGL_BAD_ATTRIBUTE, EGL_FALSE);
  if (value == nullptr) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  *value = reinterpret_cast<EGLAttrib>(the_device());
  return succeed(EGL_TRUE);
}

}  // namespace clearpipe::icd::entry
