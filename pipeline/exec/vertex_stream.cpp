// Streams of vertices: see vertex_stream.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/vertex_stream.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <new>
#include <type_traits>

#include "pipeline/fetch_ahead.h"

namespace clearpipe::pipeline {

namespace {

bool reads_array(const AttributeSource& source) {
  return source.is_array && source.pointer != nullptr;
}

// Not 0. What is constant is four floats.
uint8_t code_of(const AttributeSource& source) {
  const bool array = reads_array(source);
  const unsigned type = static_cast<unsigned>(array ? source.type : ComponentType::kFloat);
  const unsigned size = array ? source.size : 4;
  return static_cast<uint8_t>(type << 5 | size << 2 | (array && source.normalized) << 1 | array);
}

}  // namespace

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

void copy_elements(const std::byte* from, size_t from_stride, size_t bytes, size_t count,
                   size_t to_stride, std::byte* to) {
  const auto copy = [&](auto size) {
    for (size_t i = 0; i < count; ++i, from += from_stride, to += to_stride) {
      std::memcpy(to, from, size);
    }
  };
  // The usual sizes as constants, which makes a move or two of a copy.
  switch (bytes) {
    case 4:
      return copy(std::integral_constant<size_t, 4>());
    case 8:
      return copy(std::integral_constant<size_t, 8>());
    case 12:
      return copy(std::integral_constant<size_t, 12>());
    case 16:
      return copy(std::integral_constant<size_t, 16>());
    default:
      return copy(bytes);
  }
}

VertexStream::VertexStream(const StreamFormat& format, const DrawCommand& command)
    : format_(format) {
  for (uint32_t rest = format.attributes; rest != 0; rest &= rest - 1) {
    Part& part = parts_[part_count_];
    part.attribute = static_cast<uint8_t>(std::countr_zero(rest));
    const AttributeSource& source = command.attributes[part.attribute];
    AttributeSource& kept = formats_[part_count_++];
    kept.is_array = true;
    part.is_array = reads_array(source);
    if (part.is_array) {
      kept.type = source.type;
      kept.size = source.size;
      kept.normalized = source.normalized;
    }
    part.bytes = static_cast<uint8_t>(component_bytes(kept.type) * kept.size);
    part.offset = static_cast<uint8_t>(stride_);
    stride_ += (part.bytes + 3u) & ~3u;
  }
  for (uint32_t i = 0; i < part_count_; ++i) formats_[i].stride = stride_;
}

void VertexStream::add_memory(Arena& arena) {
  capacity_ = std::clamp(2 * capacity_, kMinVertices, kMaxVertices);
  memory_ = static_cast<std::byte*>(arena.allocate(size_t{capacity_} * stride_));
  used_ = 0;
  sources_ = new (arena.allocate(sizeof(DrawCommand))) DrawCommand;
  sources_->primitive = format_.points ? Primitive::kPoints : Primitive::kTriangles;
  for (uint32_t i = 0; i < part_count_; ++i) {
    AttributeSource& source = sources_->attributes[parts_[i].attribute];
    source = formats_[i];
    source.pointer = memory_ + parts_[i].offset;
    source.max_index = capacity_ - 1;
  }
}

uint32_t VertexStream::append(const DrawCommand& command, uint32_t first, uint32_t last,
                              Arena& arena) {
  const uint32_t count = last - first + 1;
  if (capacity_ - used_ < count) add_memory(arena);
  std::byte* to = memory_ + size_t{used_} * stride_;
  for (uint32_t i = 0; i < part_count_; ++i) {
    const Part& part = parts_[i];
    const AttributeSource& source = command.attributes[part.attribute];
    if (!part.is_array) {
      copy_elements(reinterpret_cast<const std::byte*>(&source.constant), 0, sizeof(Vec4), count,
                    stride_, to + part.offset);
    } else if (last <= source.max_index) {
      copy_elements(source.pointer + size_t{first} * source.stride, source.stride, part.bytes,
                    count, stride_, to + part.offset);
    } else {
      for (uint32_t k = 0; k < count; ++k) {
        const size_t element = std::min(first + k, source.max_index);
        std::memcpy(to + part.offset + size_t{k} * stride_,
                    source.pointer + element * source.stride, part.bytes);
      }
    }
  }
  constexpr uint32_t kAhead = 64;
  fetch_to_write(memory_ + size_t{std::min(used_ + kAhead, capacity_ - count)} * stride_,
                 size_t{count} * stride_);
  const uint32_t place = used_;
  used_ += count;
  return place;
}

VertexStream* VertexStreams::find(const DrawCommand& command, uint32_t attributes) {
  StreamFormat format;
  format.points = command.primitive == Primitive::kPoints;
  // The size of points comes from the state unless it is an array.
  constexpr auto kSize = static_cast<size_t>(Attribute::kPointSize);
  if (format.points && command.attributes[kSize].is_array) attributes |= 1u << kSize;
  format.attributes = attributes;
  if (std::popcount(attributes) > kStreamAttributes) return nullptr;
  for (uint32_t rest = attributes; rest != 0; rest &= rest - 1) {
    const AttributeSource& source = command.attributes[std::countr_zero(rest)];
    format.codes = format.codes << 8 | code_of(source);
  }
  for (size_t i = 0; i < count_; ++i) {
    if (streams_[i].format() == format) return &streams_[i];
  }
  if (count_ < streams_.size()) {
    streams_[count_] = VertexStream(format, command);
    return &streams_[count_++];
  }
  VertexStream& stream = streams_[next_++ % streams_.size()];
  stream = VertexStream(format, command);
  return &stream;
}

}  // namespace clearpipe::pipeline
