// Records commands into a stream, one type a command: to::PointSize{stream, 3}. Types with braces,
// because the arguments of these are evaluated in order: random ones are the same everywhere.
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "conformance/random/stream.h"

namespace clearpipe::conformance::random {

// The memory a pointer parameter points to.
struct Data {
  std::vector<uint8_t> bytes;
};

template <class T>
Data data_of(const std::vector<T>& values) {
  Data data{std::vector<uint8_t>(values.size() * sizeof(T))};
  if (!values.empty()) std::memcpy(data.bytes.data(), values.data(), data.bytes.size());
  return data;
}

inline Data floats(const std::vector<float>& values) { return data_of(values); }

// The bits of an argument as the command's parameter; data goes into the command.
template <class Parameter, class Argument>
uint32_t parameter_bits([[maybe_unused]] Command& command, const Argument& argument) {
  if constexpr (std::is_same_v<Argument, Data>) {
    static_assert(std::is_pointer_v<Parameter>);
    command.data = argument.bytes;
    return 0;
  } else if constexpr (std::is_same_v<Parameter, float>) {
    return std::bit_cast<uint32_t>(static_cast<float>(argument));
  } else {
    static_assert(!std::is_floating_point_v<Argument>);
    return static_cast<uint32_t>(argument);
  }
}

template <class Result, class... Parameters, class... Arguments>
void record(Stream& stream, Call call, Result(GL_APIENTRY*)(Parameters...),
            const Arguments&... arguments) {
  static_assert(sizeof...(Parameters) == sizeof...(Arguments));
  Command command{call, {}, {}};
  (command.arguments.push_back(parameter_bits<Parameters>(command, arguments)), ...);
  stream.commands.push_back(std::move(command));
}

// Each takes what the command takes; for a pointer, Data or an offset.
namespace to {
#define CALL(type, name, ...)                                                             \
  struct name {                                                                           \
    template <class... Arguments>                                                         \
    explicit name(Stream& stream, const Arguments&... arguments) {                        \
      record(stream, Call::name, static_cast<decltype(Gl::name)>(nullptr), arguments...); \
    }                                                                                     \
  };
#include "api/gles1.def"
#undef CALL
}  // namespace to

}  // namespace clearpipe::conformance::random
