/* libGLESv1_CM.so.1 for direct linking: an ELF filter. It has the names; the loader takes what is
 * behind them from libclearpipe.so.0, so these bodies never run. SPDX-License-Identifier: MIT */
#define CALL(type, name, ...)                                 \
  __attribute__((visibility("default"))) void gl##name(void); \
  void gl##name(void) { __builtin_trap(); }
#include "api/gles1.def"
#define ALIAS(name, command) CALL(void, name)
#include "api/gles1_aliases.def"
