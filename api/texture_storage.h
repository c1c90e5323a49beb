// What immutable textures are made of (EXT_texture_storage, APPLE_copy_texture_levels).
// SPDX-License-Identifier: MIT
#pragma once

#include "api/objects.h"

namespace clearpipe::api {

// The internal format of levels whose storage is asked for in a format, and their base format.
struct StorageFormat {
  GLenum internal = 0, base = 0;  // 0: storage has no such format
};
StorageFormat storage_format(GLenum internal);

// The level of an immutable texture from which on `count` of its levels have the sizes of those of
// another from `base` on; -1 if there is none.
int matching_level(const TextureObject& to, const TextureObject& from, int base, int count);

}  // namespace clearpipe::api
