/* libEGL.so.1 for direct linking: an ELF filter. It has the names; the loader takes what is behind
 * them from libclearpipe.so.0, so these bodies never run. SPDX-License-Identifier: MIT */
#define CALL(type, name, ...)                                  \
  __attribute__((visibility("default"))) void egl##name(void); \
  void egl##name(void) { __builtin_trap(); }
#include "icd/egl15.def"
