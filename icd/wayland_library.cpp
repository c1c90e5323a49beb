// libwayland-client: see wayland_library.h.
// SPDX-License-Identifier: MIT
#include "icd/wayland_library.h"

#include <cstring>

#include "icd/library.h"
#include "icd/pointer.h"

namespace clearpipe::icd {

namespace {

bool open_wayland(WaylandLibrary& out) {
  void* const library = open_library("libwayland-client.so.0");
  bool found = library != nullptr;
#define FUNCTION(name) found = found && find_symbol(library, "wl_" #name, out.name);
  WAYLAND_FUNCTIONS(FUNCTION)
#undef FUNCTION
#define INTERFACE(name) \
  found = found && find_symbol(library, "wl_" #name "_interface", out.name##_interface);
  WAYLAND_INTERFACES(INTERFACE)
#undef INTERFACE
  return found;
}

}  // namespace

const WaylandLibrary* wayland_library() {
  static const WaylandLibrary* const library = [] {
    static WaylandLibrary functions;
    return open_wayland(functions) ? &functions : static_cast<WaylandLibrary*>(nullptr);
  }();
  return library;
}

// It begins, as all proxies do, with a pointer to its interface, which begins with its name.
bool is_wayland_display(void* pointer) {
  constexpr char kDisplay[] = "wl_display";
  const wl_interface* interface = nullptr;
  if (!is_readable(pointer, sizeof interface)) return false;
  std::memcpy(&interface, pointer, sizeof interface);
  return is_readable(interface, sizeof *interface) &&
         is_readable(interface->name, sizeof kDisplay) &&
         std::memcmp(interface->name, kDisplay, sizeof kDisplay) == 0;
}

}  // namespace clearpipe::icd
