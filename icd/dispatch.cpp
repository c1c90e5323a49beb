// Stubs of extension commands: see dispatch.h.
// SPDX-License-Identifier: MIT
#include "icd/dispatch.h"

#include <array>
#include <cstring>

#include "icd/entry.h"

namespace clearpipe::icd {

namespace {

const __EGLapiExports* glvnd = nullptr;

enum Command : size_t {
#define CALL(type, name, parameters, arguments, vendor, object) k##name,
#include "icd/egl_ext.def"
#undef CALL
  kCommandCount
};

std::array<int, kCommandCount> indices;

// The vendor's own function for the command; null, with an error noted, when there is no vendor.
template <class Function>
Function fetch(Command command, __EGLvendorInfo* vendor, EGLint error) {
  const auto proc =
      vendor != nullptr ? glvnd->fetchDispatchEntry(vendor, indices[command]) : nullptr;
  if (proc == nullptr) {
    glvnd->setEGLError(error);
    return nullptr;
  }
  glvnd->setLastVendor(vendor);
  return reinterpret_cast<Function>(proc);
}

__EGLvendorInfo* vendor_of_display(EGLDisplay dpy) { return glvnd->getVendorFromDisplay(dpy); }
__EGLvendorInfo* vendor_of_device(EGLDeviceEXT device) {
  return glvnd->getVendorFromDevice(device);
}

#define FIRST_ARGUMENT(first, ...) first
#define STUB(type, name, parameters, arguments, vendor_of, error)                           \
  type EGLAPIENTRY stub_##name parameters {                                                 \
    using Result = type;                                                                    \
    glvnd->threadInit();                                                                    \
    const auto function =                                                                   \
        fetch<decltype(&entry::name)>(k##name, vendor_of(FIRST_ARGUMENT arguments), error); \
    return function != nullptr ? function arguments : Result{};                             \
  }
#define STUB_by_display(type, name, parameters, arguments) \
  STUB(type, name, parameters, arguments, vendor_of_display, EGL_BAD_DISPLAY)
#define STUB_by_device(type, name, parameters, arguments) \
  STUB(type, name, parameters, arguments, vendor_of_device, EGL_BAD_DEVICE_EXT)
#define STUB_built_in(type, name, parameters, arguments) \
  constexpr std::nullptr_t stub_##name = nullptr;
#define CALL(type, name, parameters, arguments, vendor, object) \
  STUB_##vendor(type, name, parameters, arguments)
#include "icd/egl_ext.def"
#undef CALL

struct Stub {
  const char* name;
  void* address;
};

template <class Function>
void* address_of(Function* function) {
  return reinterpret_cast<void*>(function);
}
void* address_of(std::nullptr_t) { return nullptr; }

const std::array<Stub, kCommandCount>& stubs() {
  static const std::array<Stub, kCommandCount> list = {{
#define CALL(type, name, parameters, arguments, vendor, object) \
  {"egl" #name, address_of(stub_##name)},
#include "icd/egl_ext.def"
#undef CALL
  }};
  return list;
}

}  // namespace

void set_dispatch_exports(const __EGLapiExports* exports) { glvnd = exports; }

void* dispatch_address(const char* name) {
  for (const Stub& stub : stubs()) {
    if (std::strcmp(stub.name, name) == 0) return stub.address;
  }
  return nullptr;
}

void set_dispatch_index(const char* name, int index) {
  for (size_t i = 0; i < kCommandCount; ++i) {
    if (std::strcmp(stubs()[i].name, name) == 0) indices[i] = index;
  }
}

}  // namespace clearpipe::icd
