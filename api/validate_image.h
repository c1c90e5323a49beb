// What validators of texture images, compressed ones and others, share.
// SPDX-License-Identifier: MIT
#pragma once

#include "api/validate.h"

namespace clearpipe::api::validate {

// The level of an image and its size (3.7.1). Sizes need not be powers of two (OES_texture_npot).
GLenum level_and_size(GLint level, GLsizei width, GLsizei height, GLint border);

// A part of an image lies inside of it (3.7.2).
GLenum rectangle_in_level(const TextureLevel& level, GLint x, GLint y, GLsizei width,
                          GLsizei height);

}  // namespace clearpipe::api::validate
