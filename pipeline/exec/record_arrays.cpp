// Taking a draw's data into the frame: see record_arrays.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/record_arrays.h"

#include <algorithm>
#include <cstring>
#include <new>

#include "pipeline/exec/index_range.h"

namespace clearpipe::pipeline {

namespace {

// Draws of so few vertices are copied into a stream, wherever they come from: a vertex job of their
// own would cost more.
constexpr uint32_t kSmallDraw = 32;
constexpr uint32_t kSmallIndices = 2 * kSmallDraw;

struct ElementRange {
  uint32_t first = 0, last = 0;  // inclusive
};

template <class Index>
ElementRange scan_indices(const std::byte* indices, uint32_t count) {
  ElementRange range{0xffffffffu, 0};
  for (uint32_t i = 0; i < count; ++i) {
    Index value;
    std::memcpy(&value, indices + size_t{sizeof(Index)} * i, sizeof(value));
    range.first = std::min<uint32_t>(range.first, value);
    range.last = std::max<uint32_t>(range.last, value);
  }
  return range;
}

ElementRange used_elements(const DrawCommand& command) {
  switch (command.index_type) {
    case IndexType::kNone:
      return {command.first, command.first + (command.count - 1)};
    case IndexType::kUnsignedByte:
      return scan_indices<uint8_t>(command.indices, command.count);
    case IndexType::kUnsignedShort:
      return scan_indices<uint16_t>(command.indices, command.count);
    case IndexType::kUnsignedInt:
      return scan_indices<uint32_t>(command.indices, command.count);
  }
  return {};
}

const std::byte* copy_indices(const DrawCommand& command, Arena& arena) {
  const size_t bytes = size_t{index_bytes(command.index_type)} * command.count;
  auto* copy = static_cast<std::byte*>(arena.allocate(bytes));
  std::memcpy(copy, command.indices, bytes);
  return copy;
}

}  // namespace

void ArrayRecorder::hold(const BufferRef& buffer) {
  // Draws mostly follow others from the same buffers; twice does no harm.
  constexpr size_t kLast = 4;
  const size_t searched = std::min(kLast, buffers_.size());
  if (std::find(buffers_.end() - static_cast<ptrdiff_t>(searched), buffers_.end(), buffer) ==
      buffers_.end()) {
    buffers_.push_back(buffer);
  }
}

bool ArrayRecorder::record_small(const DrawCommand& command, uint32_t attributes, Arena& arena,
                                 DrawRecord& draw) {
  if (command.count > (command.index_type == IndexType::kNone ? kSmallDraw : kSmallIndices)) {
    return false;
  }
  const ElementRange range = used_elements(command);
  if (range.last - range.first >= kSmallDraw) return false;
  VertexStream* stream = streams_.find(command, attributes);
  if (stream == nullptr) return false;
  draw.index_base = range.first - stream->append(command, range.first, range.last, arena);
  draw.sources = stream->sources();
  if (command.index_type != IndexType::kNone) {
    draw.indices = copy_indices(command, arena);
  }
  return true;
}

void ArrayRecorder::record(const DrawCommand& command, uint32_t attributes, Arena& arena,
                           DrawRecord& draw) {
  draw.primitive = command.primitive;
  draw.index_type = command.index_type;
  draw.first = command.first;
  draw.count = command.count;
  if (record_small(command, attributes, arena, draw)) return;

  auto* sources = new (arena.allocate(sizeof(DrawCommand))) DrawCommand(command);
  constexpr uint32_t kSize = 1u << static_cast<uint32_t>(Attribute::kPointSize);
  if (command.primitive == Primitive::kPoints) attributes |= kSize;
  bool client_arrays = false;
  for (uint32_t a = 0; a < kAttributeCount; ++a) {
    AttributeSource& source = sources->attributes[a];
    if ((attributes >> a & 1) == 0) source.is_array = false;
    if (source.is_array && source.buffer != nullptr) hold(*source.buffer);
    client_arrays = client_arrays || (source.is_array && source.buffer == nullptr);
  }
  uint32_t base = 0;
  if (client_arrays) {
    const ElementRange range = used_elements(command);
    base = range.first;
    copies_.start(range.first, range.last);
    for (AttributeSource& source : sources->attributes) {
      if (!source.is_array) {
        continue;
      }
      if (source.buffer == nullptr) {
        copies_.add(source, arena);
      } else if (base <= source.max_index) {
        source.pointer += size_t{base} * source.stride;
        source.max_index -= base;
      } else {
        // Every index lies past the buffer: the fetch clamps to the last element.
        source.pointer += size_t{source.max_index} * source.stride;
        source.max_index = 0;
      }
    }
    copies_.run();
  }
  draw.sources = sources;
  draw.index_base = base;
  draw.indices = command.indices;
  if (command.index_type == IndexType::kNone) return;
  if (command.index_buffer != nullptr) {
    hold(*command.index_buffer);
  } else {
    draw.indices = copy_indices(command, arena);
  }
}

}  // namespace clearpipe::pipeline
