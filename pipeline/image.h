// Texture images as the fragment stages sample them: every level RGBA8, rows from t = 0 upwards.
//
// Whatever format an application uploads, api/texture_upload.cpp expands it to RGBA8 once
// (luminance to (L,L,L,1), alpha to (0,0,0,A)), so that a texel is one 32-bit load. An image is
// shared by the texture object and by each pending frame that samples it; it is changed in place
// only when no frame holds it.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

#include "pipeline/image_memory.h"

namespace clearpipe::pipeline {

// The texels of a level. A copy has memory of its own; the memory itself can be shared with a
// buffer that is drawn to and with other levels (api/egl_image.h).
class Texels {
 public:
  Texels() = default;
  // All of one value.
  explicit Texels(size_t size, uint32_t value = 0) : Texels(for_overwrite(size)) {
    std::fill_n(begin(), size, value);
  }
  // With contents that are yet to be written.
  static Texels for_overwrite(size_t size) {
    return {std::allocate_shared_for_overwrite<uint32_t[]>(ImageAllocator<uint32_t>(), size), size};
  }
  Texels(std::initializer_list<uint32_t> texels) : Texels(for_overwrite(texels.size())) {
    std::copy(texels.begin(), texels.end(), begin());
  }
  Texels(std::shared_ptr<uint32_t[]> memory, size_t size)
      : memory_(std::move(memory)), size_(size) {}
  Texels(const Texels& other) : Texels(for_overwrite(other.size_)) {
    std::copy(other.begin(), other.end(), begin());
  }
  Texels(Texels&& other) noexcept
      : memory_(std::move(other.memory_)), size_(std::exchange(other.size_, 0)) {}
  Texels& operator=(Texels other) noexcept {
    memory_.swap(other.memory_);
    std::swap(size_, other.size_);
    return *this;
  }
  ~Texels() = default;

  size_t size() const { return size_; }
  uint32_t* data() { return memory_.get(); }
  const uint32_t* data() const { return memory_.get(); }
  uint32_t* begin() { return data(); }
  uint32_t* end() { return data() + size_; }
  const uint32_t* begin() const { return data(); }
  const uint32_t* end() const { return data() + size_; }
  uint32_t& operator[](size_t i) { return memory_[i]; }
  uint32_t operator[](size_t i) const { return memory_[i]; }

  const std::shared_ptr<uint32_t[]>& memory() const { return memory_; }

 private:
  std::shared_ptr<uint32_t[]> memory_;
  size_t size_ = 0;
};

// Texels are R | G<<8 | B<<16 | A<<24 in little-endian memory order R,G,B,A.
struct ImageLevel {
  int width = 0;  // texels
  int height = 0;
  Texels texels;  // row-major, width * height
};

inline constexpr int kMaxLevels = 15;  // of 16384 texels, down to 1
inline constexpr int kCubeFaces = 6;

// One image with its levels of detail; absent ones have width 0. Those of a cube map's faces follow
// each other in the order +x -x +y -y +z -z: level i of face f is levels[kMaxLevels * f + i].
struct Image {
  std::vector<ImageLevel> levels;
};

using ImageRef = std::shared_ptr<const Image>;

}  // namespace clearpipe::pipeline
