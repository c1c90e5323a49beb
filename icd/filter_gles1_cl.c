/* libGLESv1_CL.so.1 for direct linking: an ELF filter with the names of the Common-Lite profile,
 * which has no floats. The loader takes what is behind them from libclearpipe.so.0, so these bodies
 * never run. SPDX-License-Identifier: MIT */
#define CALL(type, name, ...)                                 \
  __attribute__((visibility("default"))) void gl##name(void); \
  void gl##name(void) { __builtin_trap(); }
#define COMMON_CALL(...)
#include "api/gles1.def"
#define ALIAS(name, command) CALL(void, name)
#define COMMON_ALIAS(...)
#include "api/gles1_aliases.def"
