// Configs (3.4): what surfaces can be made of, how eglChooseConfig picks and sorts them.
// SPDX-License-Identifier: MIT
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <span>
#include <vector>

namespace clearpipe::icd {

struct Config {
  EGLint id = 0;
  EGLint red = 8, green = 8, blue = 8, alpha = 8;
  EGLint depth = 0, stencil = 0;
  EGLint samples = 0;  // of the multisample buffer, if there is one
};

inline constexpr EGLint kMaxPbuffer = 16384;

std::span<const Config> configs();

// The config of a handle, or null.
const Config* find_config(EGLConfig handle);

// The value of a config attribute (table 3.1); false: no such attribute.
bool config_attrib(const Config& config, EGLint attribute, EGLint& value);

// eglChooseConfig's selection (3.4.1.1) and order (3.4.1.2); the EGL error, or EGL_SUCCESS.
EGLint choose_configs(const EGLint* attrib_list, std::vector<const Config*>& out);

}  // namespace clearpipe::icd
