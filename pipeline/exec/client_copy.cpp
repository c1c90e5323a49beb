// See client_copy.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/client_copy.h"

#include <algorithm>
#include <cstring>

#include "pipeline/exec/pieces.h"
#include "pipeline/exec/vertex_stream.h"

namespace clearpipe::pipeline {

void ClientCopies::start(uint32_t first, uint32_t last) {
  first_ = first;
  elements_ = size_t{last - first} + 1;
  array_count_ = 0;
}

void ClientCopies::add(AttributeSource& source, Arena& arena) {
  const uint32_t bytes = component_bytes(source.type) * source.size;
  const uint32_t stride = (bytes + 3) & ~3u;
  auto* to = static_cast<std::byte*>(arena.allocate(elements_ * stride));
  arrays_[array_count_++] = {source.pointer + first_ * source.stride, to, source.stride, stride,
                             bytes};
  source.pointer = to;
  source.stride = stride;
  source.max_index = static_cast<uint32_t>(elements_ - 1);
}

void ClientCopies::run() {
  constexpr size_t kAlone = 4;  // so many pieces take about as long as to wake a worker
  const size_t count = (elements_ + kPiece - 1) / kPiece;
  if (count * array_count_ <= kAlone) {
    for (size_t piece = 0; piece < count; ++piece) copy_piece(piece);
  } else {
    run_pieces(count, [this](size_t piece) { copy_piece(piece); });
  }
}

void ClientCopies::copy_piece(size_t piece) const {
  const size_t first = piece * kPiece, count = std::min(kPiece, elements_ - first);
  for (size_t i = 0; i < array_count_; ++i) {
    const Array& array = arrays_[i];
    const std::byte* const from = array.from + first * array.from_stride;
    std::byte* const to = array.to + first * array.to_stride;
    if (array.from_stride == array.to_stride) {
      std::memcpy(to, from, (count - 1) * array.to_stride + array.bytes);
    } else {
      copy_elements(from, array.from_stride, array.bytes, count, array.to_stride, to);
    }
  }
}

}  // namespace clearpipe::pipeline
