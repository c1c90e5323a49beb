// Replays streams: each call of the list is made by one instance of a template, which takes its
// parameters from the command in order.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <type_traits>
#include <utility>

#include "conformance/random/stream.h"

namespace clearpipe::conformance::random {

namespace {

template <class T>
T parameter(const Command& command, size_t index) {
  const uint32_t bits = command.arguments.at(index);
  if constexpr (std::is_pointer_v<T>) {
    if (command.data.empty()) return reinterpret_cast<T>(static_cast<uintptr_t>(bits));
    return reinterpret_cast<T>(const_cast<uint8_t*>(command.data.data()));
  } else if constexpr (std::is_same_v<T, float>) {
    return std::bit_cast<float>(bits);
  } else {
    return static_cast<T>(static_cast<int32_t>(bits));
  }
}

template <class Result, class... Parameters, size_t... index>
void make(Result(GL_APIENTRY* function)(Parameters...), const Command& command,
          std::index_sequence<index...>) {
  function(parameter<Parameters>(command, index)...);
}

template <auto member>
void make_call(const Gl& gl, const Command& command) {
  const auto counted =
      [&]<class Result, class... Parameters>(Result(GL_APIENTRY * function)(Parameters...)) {
        make(function, command, std::index_sequence_for<Parameters...>());
      };
  counted(gl.*member);
}

using Maker = void (*)(const Gl& gl, const Command& command);
constexpr Maker kMakers[] = {
#define CALL(type, name, ...) make_call<&Gl::name>,
#include "api/gles1.def"
#undef CALL
};

// A part read goes above the picture, its rows padded to the picture's width.
void read_part(const Gl& gl, const Command& command, Image& image) {
  const auto at = [&](size_t i) { return static_cast<int>(command.arguments.at(i)); };
  const int width = at(2), height = at(3);
  // What lies outside the buffer is undefined (4.3.1) and must stay as it was.
  std::vector<uint8_t> part(static_cast<size_t>(width) * height * 4, 0x55);
  gl.ReadPixels(at(0), at(1), width, height, GL_RGBA, GL_UNSIGNED_BYTE, part.data());
  const size_t row = static_cast<size_t>(image.width) * 4;
  for (int y = 0; y < height; ++y) {
    const uint8_t* from = part.data() + static_cast<size_t>(y) * width * 4;
    image.pixels.insert(image.pixels.end(), from, from + static_cast<size_t>(width) * 4);
    image.pixels.resize(image.pixels.size() + row - static_cast<size_t>(width) * 4);
  }
  image.height += height;
}

}  // namespace

int value_count(GLenum pname) {
  switch (pname) {
    case GL_MODELVIEW_MATRIX:
    case GL_PROJECTION_MATRIX:
    case GL_TEXTURE_MATRIX:
      return 16;
    case GL_CURRENT_COLOR:
    case GL_FOG_COLOR:
    case GL_VIEWPORT:
    case GL_SCISSOR_BOX:
    case GL_COLOR_CLEAR_VALUE:
      return 4;
    case GL_CURRENT_NORMAL:
    case GL_POINT_DISTANCE_ATTENUATION:
      return 3;
    case GL_DEPTH_RANGE:
      return 2;
    default:
      return 1;
  }
}

Outcome replay(const Stream& stream, Implementation& implementation) {
  const Gl& gl = implementation.begin(stream.width, stream.height);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  Outcome outcome;
  Image parts{stream.width, 0, {}};
  for (const Command& command : stream.commands) {
    switch (command.call) {
      case Call::GetError:
        outcome.errors.push_back(gl.GetError());
        break;
      case Call::GetFloatv: {
        float values[16] = {};
        gl.GetFloatv(command.arguments.at(0), values);
        outcome.values.insert(outcome.values.end(), values,
                              values + value_count(command.arguments.at(0)));
        break;
      }
      case Call::ReadPixels:
        read_part(gl, command, parts);
        break;
      default:
        kMakers[static_cast<size_t>(command.call)](gl, command);
    }
  }
  outcome.errors.push_back(gl.GetError());
  outcome.image = read_image(gl, stream.width, stream.height);
  outcome.image.height += parts.height;
  outcome.image.pixels.insert(outcome.image.pixels.end(), parts.pixels.begin(), parts.pixels.end());
  implementation.end();
  return outcome;
}

}  // namespace clearpipe::conformance::random
