// What a validator finds wrong with a call: the error it generates (2.5), and the rule it breaks,
// in words for people (debug.h). SPDX-License-Identifier: MIT
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

namespace clearpipe::api {

struct Invalid {
  GLenum error = GL_NO_ERROR;
  int first = 0;
  // "{0}" stands for the first argument of the call, or the one at position `first`, by name and
  // value. The section of the specification follows in parentheses.
  const char* rule = nullptr;

  constexpr Invalid() = default;  // nothing is wrong
  constexpr Invalid(GLenum e, const char* r) : error(e), rule(r) {}
  constexpr explicit operator bool() const { return error != GL_NO_ERROR; }
  // For a rule about a few arguments of a call that has others before them.
  constexpr Invalid from(int position) const {
    Invalid moved = *this;
    moved.first += position;
    return moved;
  }
};

inline constexpr Invalid kOutOfMemory{GL_OUT_OF_MEMORY, "memory does not suffice (2.5)"};

constexpr Invalid enum_unless(bool good, const char* rule) {
  return good ? Invalid() : Invalid(GL_INVALID_ENUM, rule);
}
constexpr Invalid value_unless(bool good, const char* rule) {
  return good ? Invalid() : Invalid(GL_INVALID_VALUE, rule);
}
constexpr Invalid operation_unless(bool good, const char* rule) {
  return good ? Invalid() : Invalid(GL_INVALID_OPERATION, rule);
}

}  // namespace clearpipe::api
