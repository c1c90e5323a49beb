// Libraries that are opened on first use, and never closed: they may have threads and exit
// handlers. SPDX-License-Identifier: MIT
#pragma once

#include <dlfcn.h>

namespace clearpipe::icd {

// Null where there is no such library.
inline void* open_library(const char* name) { return dlopen(name, RTLD_NOW | RTLD_LOCAL); }

// The symbol into `out`; false: it is not there.
template <class Pointer>
bool find_symbol(void* library, const char* name, Pointer& out) {
  out = reinterpret_cast<Pointer>(dlsym(library, name));
  return out != nullptr;
}

}  // namespace clearpipe::icd
