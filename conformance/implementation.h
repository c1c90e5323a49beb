// What a scene needs of an implementation: a fresh context over a buffer of a given size, the
// commands, and the pixels afterwards.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "conformance/gl.h"

namespace clearpipe::conformance {

// RGBA, eight bits a channel, rows from the bottom up as glReadPixels gives them.
struct Image {
  int width = 0, height = 0;
  std::vector<uint8_t> pixels;
};

class Implementation {
 public:
  virtual ~Implementation() = default;

  // Makes a new context current in this thread, over a new RGBA8 buffer with 24 bits of depth and
  // 8 of stencil, and gives its commands. Throws std::runtime_error with the reason when it cannot.
  virtual const Gl& begin(int width, int height) = 0;

  // Releases and destroys that context.
  virtual void end() = 0;

  virtual std::string name() const = 0;
};

// The whole buffer, by glReadPixels.
inline Image read_image(const Gl& gl, int width, int height) {
  Image image{width, height, std::vector<uint8_t>(static_cast<size_t>(width) * height * 4)};
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
  return image;
}

}  // namespace clearpipe::conformance
