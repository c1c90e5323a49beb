// What validators of texture images, compressed ones and others, share.
// SPDX-License-Identifier: MIT
#pragma once

#include "api/compressed_format.h"
#include "api/texture_target.h"
#include "api/validate.h"

namespace clearpipe::api::validate {

// The target of an image, the first argument (3.7.1).
Invalid image_target(GLenum target);

// The image of the bound texture; the level must be one.
const TextureLevel& image_of(const Context&, GLenum target, GLint level);

// The texture's images may be replaced (EXT_texture_storage); its target is the first argument.
Invalid mutable_texture(const TextureObject& texture);

// The level of an image, the second argument (3.7.1).
Invalid image_level(GLint level);

// Its width, height and border, three arguments in a row (3.7.1). Sizes need not be powers of two
// (OES_texture_npot); the faces of a cube map are squares.
Invalid image_size(GLenum target, GLint level, GLsizei width, GLsizei height);
Invalid image_border(GLint border);

// A part of an image lies inside of it (3.7.2): the third and the fourth argument, and two that
// stand together at another place.
Invalid rectangle_in_level(const TextureLevel& level, GLint x, GLint y, GLsizei width,
                           GLsizei height, int size_at);

// Whether compressed images of that family may have that size: width and height are the fourth and
// fifth argument, the format is the third.
Invalid compressed_size(const CompressedFamily& family, GLsizei width, GLsizei height);

}  // namespace clearpipe::api::validate
