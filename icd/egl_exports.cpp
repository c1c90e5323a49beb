// The EGL commands under their C names, for programs linked directly (not through libglvnd).
// SPDX-License-Identifier: MIT
#include "icd/command.h"

#define CALL(type, name, parameters, arguments, object)                                     \
  extern "C" __attribute__((visibility("default"))) type EGLAPIENTRY egl##name parameters { \
    return clearpipe::icd::command::name arguments;                                         \
  }
#include "icd/egl15.def"
#undef CALL
