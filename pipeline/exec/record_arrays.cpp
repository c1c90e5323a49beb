// Taking a draw's data into the frame: see record_arrays.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/record_arrays.h"

#include <algorithm>
#include <cstring>

namespace clearpipe::pipeline {

namespace {

uint32_t component_bytes(ComponentType type) {
  switch (type) {
    case ComponentType::kByte:
    case ComponentType::kUnsignedByte:
      return 1;
    case ComponentType::kShort:
      return 2;
    case ComponentType::kFixed:
    case ComponentType::kFloat:
      return 4;
  }
  return 4;
}

uint32_t index_bytes(IndexType type) {
  switch (type) {
    case IndexType::kNone:
      return 0;
    case IndexType::kUnsignedByte:
      return 1;
    case IndexType::kUnsignedShort:
      return 2;
    case IndexType::kUnsignedInt:
      return 4;
  }
  return 0;
}

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

void copy_client_array(AttributeSource& source, const ElementRange& range, Arena& arena) {
  const uint32_t element = component_bytes(source.type) * source.size;
  const uint32_t stride = (element + 3) & ~3u;
  const size_t count = size_t{range.last - range.first} + 1;
  auto* copy = static_cast<std::byte*>(arena.allocate(count * stride));
  const std::byte* from = source.pointer + size_t{range.first} * source.stride;
  if (source.stride == stride) {
    std::memcpy(copy, from, (count - 1) * stride + element);
  } else {
    for (size_t i = 0; i < count; ++i) {
      std::memcpy(copy + i * stride, from + i * source.stride, element);
    }
  }
  source.pointer = copy;
  source.stride = stride;
  source.max_index = range.last - range.first;
}

}  // namespace

uint32_t record_arrays(const DrawCommand& command, Arena& arena, DrawCommand& out) {
  out = command;
  const bool client_arrays =
      std::any_of(out.attributes.begin(), out.attributes.end(),
                  [](const AttributeSource& a) { return a.is_array && !a.buffer; });
  uint32_t base = 0;
  if (client_arrays) {
    const ElementRange range = used_elements(command);
    base = range.first;
    for (AttributeSource& source : out.attributes) {
      if (!source.is_array) {
        continue;
      }
      if (!source.buffer) {
        copy_client_array(source, range, arena);
      } else if (base <= source.max_index) {
        source.pointer += size_t{base} * source.stride;
        source.max_index -= base;
      } else {
        // Every index lies past the buffer: the fetch clamps to the last element.
        source.pointer += size_t{source.max_index} * source.stride;
        source.max_index = 0;
      }
    }
  }
  if (command.index_type != IndexType::kNone && !command.index_buffer) {
    const size_t bytes = size_t{index_bytes(command.index_type)} * command.count;
    auto* copy = static_cast<std::byte*>(arena.allocate(bytes));
    std::memcpy(copy, command.indices, bytes);
    out.indices = copy;
  }
  return base;
}

}  // namespace clearpipe::pipeline
