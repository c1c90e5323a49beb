// The initial values of tables 6.3 to 6.19 and the constants of 6.20 to 6.23, written down once
// more from the specification, for tests: those of queries hold glGet* against them, those of
// errors hold the state after a refused call against them.
// SPDX-License-Identifier: MIT
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <vector>

#include "api/khr_debug.h"

namespace clearpipe::api {

// How values convert (6.1.2).
enum class Kind { kNumber, kColour, kInteger, kEnumerant, kBoolean };

struct InitialValue {
  GLenum name;
  const char* text;
  Kind kind;
  std::vector<double> values;
};

// Of a context that is current on a surface of 16x16 with alpha, depth and stencil.
inline const std::vector<InitialValue>& initial_values() {
  static const std::vector<InitialValue> kValues = {
#define NUMBER(name, ...) {name, #name, Kind::kNumber, {__VA_ARGS__}},
#define COLOUR(name, ...) {name, #name, Kind::kColour, {__VA_ARGS__}},
#define INTEGER(name, ...) {name, #name, Kind::kInteger, {__VA_ARGS__}},
#define ENUM(name, ...) {name, #name, Kind::kEnumerant, {__VA_ARGS__}},
#define BOOLEAN(name, ...) {name, #name, Kind::kBoolean, {__VA_ARGS__}},
#include "api/initial_state.def"
#undef NUMBER
#undef COLOUR
#undef INTEGER
#undef ENUM
#undef BOOLEAN
  };
  return kValues;
}

}  // namespace clearpipe::api
