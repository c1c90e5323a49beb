// What validators of texture images, compressed ones and others, share.
// SPDX-License-Identifier: MIT
#pragma once

#include "api/validate.h"

namespace clearpipe::api::validate {

// The level of an image, the second argument (3.7.1).
Invalid image_level(GLint level);

// Its width, height and border, three arguments in a row (3.7.1). Sizes need not be powers of two
// (OES_texture_npot).
Invalid image_size(GLint level, GLsizei width, GLsizei height);
Invalid image_border(GLint border);

// A part of an image lies inside of it (3.7.2): the third and the fourth argument, and two that
// stand together at another place.
Invalid rectangle_in_level(const TextureLevel& level, GLint x, GLint y, GLsizei width,
                           GLsizei height, int size_at);

}  // namespace clearpipe::api::validate
