// What decoders of formats made of 4x4 blocks share: the walk over the blocks of an image.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "api/compressed_format.h"

namespace clearpipe::api {

// One decoded block, its 16 texels row by row.
using BlockTexels = uint32_t[16];

// Of blocks that reach past the image, the texels beyond its edges are dropped.
template <void (*kDecodeBlock)(const uint8_t* block, BlockTexels& texels), int kBlockBytes>
void decode_blocks(const uint8_t* data, const DecodeTarget& to) {
  for (int y = 0; y < to.height; y += 4) {
    for (int x = 0; x < to.width; x += 4, data += kBlockBytes) {
      BlockTexels texels;
      kDecodeBlock(data, texels);
      const int rows = std::min(4, to.height - y), columns = std::min(4, to.width - x);
      for (int j = 0; j < rows; ++j) {
        std::copy_n(texels + 4 * j, columns,
                    to.level.texels.begin() +
                        static_cast<ptrdiff_t>(to.y + y + j) * to.level.width + to.x + x);
      }
    }
  }
}

}  // namespace clearpipe::api
