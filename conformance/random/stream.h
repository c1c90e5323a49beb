// A command stream as data: calls of the one list with their arguments and the memory they point
// to, which can be replayed on any implementation, shortened, and written as C++ source.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "conformance/gl.h"
#include "conformance/implementation.h"

namespace clearpipe::conformance::random {

// Every command of the list, by name.
enum class Call : uint8_t {
#define CALL(type, name, ...) name,
#include "api/gles1.def"
#undef CALL
};

struct Command {
  Call call;
  // The bits of each parameter, in order. A pointer's entry is an offset into a buffer object, and
  // means nothing while there is data.
  std::vector<uint32_t> arguments;
  // What the command's pointer points to, if not empty.
  std::vector<uint8_t> data;
};

// A picture's size and the commands that draw it. Commands are grouped: what belongs together,
// say a light and its parameters, is one step of the generator.
struct Stream {
  int width = 128, height = 128;
  std::vector<Command> commands;
};

// What an implementation made of a stream.
struct Outcome {
  Image image;                 // the buffer; above it, each part that the stream has read
  std::vector<GLenum> errors;  // of each GetError in the stream, and of one at its end
  std::vector<float> values;   // of each GetFloatv
};

Outcome replay(const Stream& stream, Implementation& implementation);

// False if it draws from memory that it does not have: it must not be replayed.
bool reads_only_its_own(const Stream& stream);

// How many values GetFloatv gives for a name that streams ask for.
int value_count(GLenum pname);

}  // namespace clearpipe::conformance::random
