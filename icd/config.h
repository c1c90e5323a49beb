// Configs (3.4): what surfaces can be made of, how eglChooseConfig picks and sorts them.
// SPDX-License-Identifier: MIT
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <functional>
#include <span>
#include <vector>

#include "pipeline/colour_format.h"

namespace clearpipe::icd {

struct Config {
  EGLint id = 0;
  EGLint red = 8, green = 8, blue = 8, alpha = 8;
  pipeline::ColourFormat format = pipeline::ColourFormat::kRgba8;  // of these sizes
  EGLint depth = 0, stencil = 0;
  EGLint samples = 0;  // of the multisample buffer, if there is one
  // What the platform can make of it, besides pbuffers: EGL_WINDOW_BIT, EGL_PIXMAP_BIT; and the
  // visual of windows.
  EGLint native_surfaces = 0;
  EGLint visual_id = 0, visual_type = EGL_NONE;
  EGLint max_swap_interval = 10;
};

inline constexpr EGLint kMaxPbuffer = 16384;

// What every platform has, for pbuffers alone, without numbers.
std::vector<Config> offscreen_configs();

// The value of a config attribute (table 3.1); false: no such attribute.
bool config_attrib(const Config& config, EGLint attribute, EGLint& value);

// eglChooseConfig's selection (3.4.1.1) and order (3.4.1.2) among configs; the EGL error, or
// EGL_SUCCESS. `is_pixmap` knows native pixmaps that can be drawn to.
EGLint choose_configs(std::span<const Config> configs, const EGLint* attrib_list,
                      const std::function<bool(EGLint)>& is_pixmap,
                      std::vector<const Config*>& out);

}  // namespace clearpipe::icd
