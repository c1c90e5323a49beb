// The memory a frame is drawn into: colour and depth/stencil planes owned by a drawable or a
// framebuffer object.
//
// Planes are laid out in tiles: tile after tile, row-major, each whole, with its rows of kTileWidth
// (raster/tile.h). A worker then shades in the surface's own memory, and one tile is one stretch of
// it. Only a colour buffer over a texture is laid out in rows, as sampling has it.
//
// Rows run from y = 0 at the bottom, as OpenGL ES counts window coordinates (2.10.1); a platform
// that shows rows top-down flips when it presents.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "pipeline/colour_format.h"
#include "pipeline/raster/samples.h"

namespace clearpipe::pipeline {

// Tiles that hold one value throughout, written down instead of stored: a cleared tile costs no
// memory traffic until it is drawn to (merge/). Of others some bits may be known: depth can be
// cleared alone where all stencil values are the same. Buffers over the same memory share them.
struct UniformTiles {
  // By tile, row-major; one plane's tiles after another's: the bits that all pixels share with
  // `value`. If that is all of them, the memory holds anything.
  std::vector<uint32_t> bits;
  std::vector<uint32_t> value;

  bool is_uniform(size_t tile) const { return bits[tile] == 0xffffffffu; }
};

// The multisample buffer that coexists with a colour buffer (3.2.1): a plane for each sample. It is
// what fragments are drawn to; their mean is in the colour buffer whenever a frame is done.
struct SampleBuffer {
  std::shared_ptr<uint32_t[]> values;  // planes, one after another
  UniformTiles uniform;
  // By tile: every sample is what the colour buffer, laid out in rows, holds for its pixel. Empty:
  // none is.
  std::vector<uint8_t> discarded;
};

// The pixels as they are kept. Colour is always held as RGBA8, if only with values that the format
// has. The memory may be that of a texture level, which then is drawn to and sampled without a
// copy: `pixels` keeps the image alive.
struct ColourBuffer {
  int width = 0, height = 0;
  std::shared_ptr<uint32_t[]> pixels;  // R in the low byte
  ColourFormat format = ColourFormat::kRgba8;
  bool has_alpha = true;                  // else alpha stays 255 in memory: it reads as 1
  bool srgb = false;                      // colours are sRGB-encoded
  std::shared_ptr<UniformTiles> uniform;  // null: laid out in rows of `width`
  std::shared_ptr<SampleBuffer> samples;  // null: one sample, the pixel itself
};

// Depth in the upper 24 bits (unsigned normalised), stencil in the lower 8. Depth of 16 bits is the
// same with smaller numbers; depth of 32 bits, which has no stencil beside it, is all of the word.
// What the buffer does not have is left as it is: another buffer may have it in the same memory. A
// multisampled buffer is a plane for each sample, one after another.
struct DepthStencilBuffer {
  int width = 0, height = 0;
  int samples = 1;
  bool has_depth = true, has_stencil = true;
  int depth_bits = 24;  // 16, 24 or, without stencil, 32
  std::shared_ptr<uint32_t[]> values;
  std::shared_ptr<UniformTiles> uniform;
  bool partial_view = false;  // the memory holds planes that this buffer does not have
};

// Copies `count` pixels of row y, from x on, all inside the buffer, to `out`, which may be aligned
// in any way. No frame may be drawing to the buffer.
void read_pixels(const ColourBuffer& buffer, int x, int y, int count, void* out);

// The opposite, into a buffer without samples.
void write_pixels(ColourBuffer& buffer, int x, int y, int count, const uint32_t* from);

// Copies `rows` rows of `count` pixels from (x, y) on, all inside the buffer, each to a place
// `row_bytes` further in `out`; large ones on all cores.
void read_rectangle(const ColourBuffer& buffer, int x, int y, int count, int rows, void* out,
                    size_t row_bytes);

// Lays out the buffer in rows, as memory that is shared with a texture must be; does nothing when
// it is. False, and no change, when memory does not suffice.
bool lay_out_in_rows(ColourBuffer& buffer);

// How many tiles a plane takes, and where in them a pixel is.
size_t tile_count(int width, int height);
size_t place_in_tiles(int width, int x, int y);

// Allocate with contents of zero (alpha 255 without alpha bits), with 1 or kSampleCount samples;
// null when memory does not suffice.
std::shared_ptr<ColourBuffer> make_colour_buffer(int width, int height, bool has_alpha,
                                                 int samples = 1);
std::shared_ptr<DepthStencilBuffer> make_depth_stencil_buffer(int width, int height, bool has_depth,
                                                              bool has_stencil, int samples = 1);

// A multisample buffer for a colour buffer that is laid out in rows, with all tiles discarded; null
// when memory does not suffice.
std::shared_ptr<SampleBuffer> make_sample_buffer(int width, int height);

// What a frame renders to. `colour` or `depth_stencil` may be null; both have as many samples.
struct Target {
  std::shared_ptr<ColourBuffer> colour;
  std::shared_ptr<DepthStencilBuffer> depth_stencil;
  int width = 0, height = 0;
  // Whether coverage is found with y counted from the top, as Mesa does for window-system surfaces;
  // framebuffer objects count from the bottom (docs/architecture.md, "Mesa's coverage").
  bool mirrored = true;

  int samples() const {
    if (colour) return colour->samples ? kSampleCount : 1;
    return depth_stencil ? depth_stencil->samples : 1;
  }
};

}  // namespace clearpipe::pipeline
