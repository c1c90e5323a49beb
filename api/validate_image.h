// What validators of texture images, compressed ones and others, share.
// SPDX-License-Identifier: MIT
#pragma once

#include "api/texture_target.h"
#include "api/validate.h"

namespace clearpipe::api::validate {

// The level of an image and its size (3.7.1). Sizes need not be powers of two (OES_texture_npot);
// the faces of a cube map are squares.
GLenum level_and_size(GLenum target, GLint level, GLsizei width, GLsizei height, GLint border);

// The image of the bound texture; the level must be one.
const TextureLevel& image_of(const Context&, GLenum target, GLint level);

// A part of an image lies inside of it (3.7.2).
GLenum rectangle_in_level(const TextureLevel& level, GLint x, GLint y, GLsizei width,
                          GLsizei height);

}  // namespace clearpipe::api::validate
