// The vertices of small draws, one draw's behind the other's, so that the draws share what says
// where attributes come from, and a vertex job can take the vertices of many draws at once.
//
// A vertex is the attributes that its draw needs, next to each other as they were found, constant
// ones too: draws whose current colours differ are alike. A stream is for one format.
//
//   memory  | position colour texcoord | position colour texcoord | ...
//             vertex 0 of draw 0         vertex 1 of draw 0
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "pipeline/command.h"
#include "pipeline/exec/arena.h"

namespace clearpipe::pipeline {

// What vertices consist of, comparable as a whole. Draws with more attributes have no stream.
struct StreamFormat {
  uint64_t codes = 0;       // 8 bits for each attribute, in order
  uint32_t attributes = 0;  // bit per Attribute
  bool points = false;
  bool operator==(const StreamFormat&) const = default;
};
inline constexpr int kStreamAttributes = 8;

// Bytes of a component of that type.
uint32_t component_bytes(ComponentType type);

// Copies elements of `bytes` bytes from places `from_stride` apart to places `to_stride` apart.
void copy_elements(const std::byte* from, size_t from_stride, size_t bytes, size_t count,
                   size_t to_stride, std::byte* to);

class VertexStream {
 public:
  VertexStream() = default;
  VertexStream(const StreamFormat& format, const DrawCommand& command);

  const StreamFormat& format() const { return format_; }

  // Takes elements `first` to `last` of the command's arrays; returns the number of the first in
  // the memory that sources() speaks of afterwards. Throws std::bad_alloc.
  uint32_t append(const DrawCommand& command, uint32_t first, uint32_t last, Arena& arena);

  const DrawCommand* sources() const { return sources_; }

  // Workers may read the vertices that there are while more are added: a fetch of whole vectors
  // reads up to 16 bytes of what lies behind one.
  void leave_room() { used_ = std::min(capacity_, used_ + 4); }

 private:
  static constexpr uint32_t kMinVertices = 64, kMaxVertices = 4096;

  struct Part {
    uint8_t attribute = 0, bytes = 0, offset = 0;
    bool is_array = false;
  };

  void add_memory(Arena& arena);

  StreamFormat format_;
  std::array<Part, kStreamAttributes> parts_;
  uint32_t part_count_ = 0;
  uint32_t stride_ = 0;
  std::array<AttributeSource, kStreamAttributes> formats_;
  DrawCommand* sources_ = nullptr;  // of the memory at hand
  std::byte* memory_ = nullptr;
  uint32_t used_ = 0, capacity_ = 0;
};

// The streams of a frame.
class VertexStreams {
 public:
  // The stream for a command whose draws need these attributes; null when there is none.
  VertexStream* find(const DrawCommand& command, uint32_t attributes);

  void leave_room() {
    for (size_t i = 0; i < count_; ++i) streams_[i].leave_room();
  }

  // The frame is done, and the memory gone.
  void reset() { count_ = next_ = 0; }

 private:
  std::array<VertexStream, 4> streams_;
  size_t count_ = 0;
  size_t next_ = 0;  // that gives way when all are in use
};

}  // namespace clearpipe::pipeline
