// The EGL commands as programs call them, and the addresses of procedures (3.11): see command.h.
// SPDX-License-Identifier: MIT
#include "icd/command.h"

#include <cstring>

#include "icd/debug.h"
#include "icd/entry.h"

namespace clearpipe::icd {

namespace {

// Primary objects that are no arguments.
const void* current_context_handle() {
  const Context* context = this_thread().context;
  return context != nullptr ? context->handle : nullptr;
}
const void* current_surface_handle() {
  const Context* context = this_thread().context;
  return context != nullptr && context->draw != nullptr ? context->draw->handle : nullptr;
}

}  // namespace

#define thread nullptr
#define current_context current_context_handle()
#define current_surface current_surface_handle()
#define current_display this_thread().display

namespace command {

#define COMMAND(type, name, parameters, arguments, object) \
  type EGLAPIENTRY name parameters noexcept {              \
    const Report report("egl" #name, object);              \
    return entry::name arguments;                          \
  }
#define CALL(type, name, parameters, arguments, object) \
  COMMAND(type, name, parameters, arguments, object)
#include "icd/egl15.def"
#undef CALL
#define CALL(type, name, parameters, arguments, vendor, object) \
  COMMAND(type, name, parameters, arguments, object)
#include "icd/egl_ext.def"
#undef CALL

}  // namespace command

namespace entry {

__eglMustCastToProperFunctionPointerType GetProcAddress(const char* procname) noexcept {
  using Proc = __eglMustCastToProperFunctionPointerType;
  if (procname == nullptr) return succeed<Proc>(nullptr);
  // libglvnd asks for every name it knows, most of them of OpenGL, when a context is first current.
  if (std::strncmp(procname, "egl", 3) != 0) {
    return succeed(reinterpret_cast<Proc>(api::proc_address(procname)));
  }
#define CALL(type, name, ...)                               \
  if (std::strcmp(procname, "egl" #name) == 0) {            \
    return succeed(reinterpret_cast<Proc>(&command::name)); \
  }
#include "icd/egl15.def"
#include "icd/egl_ext.def"
#undef CALL
  return succeed<Proc>(nullptr);
}

}  // namespace entry

}  // namespace clearpipe::icd
