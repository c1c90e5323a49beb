// The vendor library as libglvnd sees it: __egl_Main fills the table through which libEGL reaches
// this implementation (glvnd/libeglabi.h).
// SPDX-License-Identifier: MIT
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <glvnd/libeglabi.h>

#include "icd/dispatch.h"
#include "icd/entry.h"
#include "icd/extensions.h"
#include "icd/origin.h"

namespace clearpipe::icd {

namespace {

// EGL_NONE asks for a vendor's default display, as eglGetDisplay does.
EGLDisplay platform_display(EGLenum platform, void* native_display, const EGLAttrib* attribs) {
  if (platform == EGL_NONE) {
    return entry::GetDisplay(reinterpret_cast<EGLNativeDisplayType>(native_display));
  }
  return entry::GetPlatformDisplay(platform, native_display, attribs);
}

EGLBoolean supports_api(EGLenum api) { return api == EGL_OPENGL_ES_API ? EGL_TRUE : EGL_FALSE; }

const char* vendor_string(int name) {
  return name == __EGL_VENDOR_STRING_PLATFORM_EXTENSIONS ? kOffered<Offered::platform>.data()
                                                         : nullptr;
}

EGLenum find_platform(void* native_display) { return platform_of(native_display); }

void* proc_address(const char* name) {
  return reinterpret_cast<void*>(entry::GetProcAddress(name));
}

}  // namespace

}  // namespace clearpipe::icd

extern "C" __attribute__((visibility("default"))) EGLBoolean __egl_Main(
    uint32_t version, const __EGLapiExports* exports, __EGLvendorInfo*, __EGLapiImports* imports) {
  if (EGL_VENDOR_ABI_GET_MAJOR_VERSION(version) != EGL_VENDOR_ABI_MAJOR_VERSION) {
    return EGL_FALSE;
  }
  clearpipe::icd::set_dispatch_exports(exports);
  clearpipe::icd::entry::set_current_api_source(exports->getCurrentApi);
  imports->getPlatformDisplay = clearpipe::icd::platform_display;
  imports->getSupportsAPI = clearpipe::icd::supports_api;
  imports->getVendorString = clearpipe::icd::vendor_string;
  imports->getProcAddress = clearpipe::icd::proc_address;
  imports->getDispatchAddress = clearpipe::icd::dispatch_address;
  imports->findNativeDisplayPlatform = clearpipe::icd::find_platform;
  imports->setDispatchIndex = clearpipe::icd::set_dispatch_index;
  return EGL_TRUE;
}
