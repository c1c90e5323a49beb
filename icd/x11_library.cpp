// The libraries of X11: see x11_library.h.
// SPDX-License-Identifier: MIT
#include "icd/x11_library.h"

#include <X11/Xlib.h>

#include "icd/library.h"
#include "icd/pointer.h"

namespace clearpipe::icd {

namespace {

bool open_xcb(X11Library& out) {
  void* const library = open_library("libxcb.so.1");
  bool found = library != nullptr;
#define FUNCTION(name) found = found && find_symbol(library, "xcb_" #name, out.name);
  XCB_FUNCTIONS(FUNCTION)
#undef FUNCTION
  return found;
}

void open_shm(X11Library& out) {
  void* const library = open_library("libxcb-shm.so.0");
  bool found = library != nullptr;
#define FUNCTION(name) found = found && find_symbol(library, "xcb_shm_" #name, out.shm.name);
  XCB_SHM_FUNCTIONS(FUNCTION)
#undef FUNCTION
  if (found) find_symbol(library, "xcb_shm_id", out.shm.id);
}

void open_present(X11Library& out) {
  void* const library = open_library("libxcb-present.so.0");
  bool found = library != nullptr;
#define FUNCTION(name) \
  found = found && find_symbol(library, "xcb_present_" #name, out.present.name);
  XCB_PRESENT_FUNCTIONS(FUNCTION)
#undef FUNCTION
  if (found) find_symbol(library, "xcb_present_id", out.present.id);
}

}  // namespace

const X11Library* x11_library() {
  static const X11Library* const library = [] {
    static X11Library functions;
    if (!open_xcb(functions)) return static_cast<X11Library*>(nullptr);
    open_shm(functions);
    open_present(functions);
    return &functions;
  }();
  return library;
}

xcb_connection_t* connection_of_xlib(void* display) {
  static const auto get_connection = [] {
    xcb_connection_t* (*function)(Display*) = nullptr;
    if (void* const library = open_library("libX11-xcb.so.1")) {
      find_symbol(library, "XGetXCBConnection", function);
    }
    return function;
  }();
  return get_connection != nullptr ? get_connection(static_cast<Display*>(display)) : nullptr;
}

int default_screen_of_xlib(void* display) {
  return static_cast<_XPrivDisplay>(display)->default_screen;
}

// As libglvnd knows one: by the function that allocates identifiers, which is the same for all.
bool is_xlib_display(void* pointer) {
  if (!is_readable(pointer, sizeof(*static_cast<_XPrivDisplay>(nullptr)))) return false;
  void* const library = dlopen("libX11.so.6", RTLD_NOW | RTLD_LOCAL | RTLD_NOLOAD);
  if (library == nullptr) return false;
  XID (*allocate)(Display*) = nullptr;
  find_symbol(library, "_XAllocID", allocate);
  dlclose(library);
  return allocate != nullptr && static_cast<_XPrivDisplay>(pointer)->resource_alloc == allocate;
}

}  // namespace clearpipe::icd
