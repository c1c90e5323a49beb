// Locked surfaces (EGL_KHR_lock_surface3): the colour buffer as pixels in client memory, a copy
// that comes back when the surface is unlocked. SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "icd/config.h"
#include "icd/pixel_layout.h"
#include "pipeline/surface.h"

namespace clearpipe::icd {

struct Surface;

// Whether surfaces of the config can be locked: what they hold are pixels, not samples.
inline bool is_lockable(const Config& config) { return config.samples == 0; }

// What EGL_MATCH_FORMAT_KHR says of a config, and whether a config has the format asked for.
EGLint mapped_format(const Config& config);
bool matches_format(const Config& config, EGLint format);

// How pixels are mapped: rows from the upper left corner on, components as the config has them.
PixelLayout mapped_layout(const Config& config);
size_t mapped_pitch(const Config& config, EGLint width);

// The lock of a surface. Its memory is there from the first time that someone asks for it.
struct SurfaceLock {
  bool preserves_pixels = false;
  bool is_mapped = false;
  std::vector<std::byte> memory;
};

// False: memory does not suffice.
bool map_surface(Surface& surface);

// What was mapped becomes the surface's, which is not locked any more. False: memory does not
// suffice, and the surface keeps its pixels.
bool unlock_surface(Surface& surface);

}  // namespace clearpipe::icd
