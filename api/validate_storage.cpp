// Validators of immutable textures (EXT_texture_storage, APPLE_copy_texture_levels).
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "api/compressed_format.h"
#include "api/texture_storage.h"
#include "api/validate_image.h"

namespace clearpipe::api::validate {

namespace {

// Whether all levels have sizes that the format allows.
bool has_allowed_sizes(const CompressedFormat& format, GLsizei levels, GLsizei width,
                       GLsizei height) {
  for (GLsizei i = 0; i < levels; ++i) {
    if (compressed_size(format.family, std::max(width >> i, 1), std::max(height >> i, 1))) {
      return false;
    }
  }
  return true;
}

// Of two arguments in a row, names of textures.
Invalid immutable_texture(const Context& c, GLuint name, const TextureObject*& texture) {
  if (name == 0) return {GL_INVALID_VALUE, "{0} is no texture (APPLE_copy_texture_levels)"};
  texture = c.share->textures.find(name).get();
  return operation_unless(texture && texture->storage_levels > 0,
                          "{0} is no texture with immutable levels (APPLE_copy_texture_levels)");
}

}  // namespace

Invalid tex_storage(const Context& c, GLenum target, GLsizei levels, GLenum internal, GLsizei width,
                    GLsizei height) {
  if (const Invalid wrong = specified_target(target)) return wrong;
  if (storage_format(internal).base == 0) {
    return {GL_INVALID_ENUM, "{2} is no sized or compressed format (EXT_texture_storage)"};
  }
  if (levels < 1 || width < 1 || height < 1) {
    return {GL_INVALID_VALUE, "{1}, {3} or {4} is less than 1 (EXT_texture_storage)"};
  }
  const bool cube = target == GL_TEXTURE_CUBE_MAP_OES;
  const GLenum image = cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES : GL_TEXTURE_2D;
  if (const Invalid wrong = image_size(image, 0, width, height)) return wrong.from(3);
  const TextureObject& texture = *bound_texture(c, target);
  if (texture.name == 0) {
    return {GL_INVALID_OPERATION, "no named texture is bound to {0} (EXT_texture_storage)"};
  }
  if (const Invalid wrong = mutable_texture(texture)) return wrong;
  if (levels > longest_mipmap(std::max(width, height))) {
    return {GL_INVALID_OPERATION, "{1} is more than {3} and {4} have (EXT_texture_storage)"};
  }
  const CompressedFormat* format = compressed_format(internal);
  return operation_unless(!format || has_allowed_sizes(*format, levels, width, height),
                          "a level has a size that {2} does not allow (EXT_texture_storage)");
}

Invalid copy_texture_levels(const Context& c, GLuint destination, GLuint source, GLint base,
                            GLsizei count) {
  const TextureObject *to = nullptr, *from = nullptr;
  if (const Invalid wrong = immutable_texture(c, destination, to)) return wrong;
  if (const Invalid wrong = immutable_texture(c, source, from)) return wrong.from(1);
  if (base < 0 || base >= from->storage_levels) {
    return {GL_INVALID_VALUE, "{2} is no level of {1} (APPLE_copy_texture_levels)"};
  }
  if (count < 1 || count > from->storage_levels - base) {
    return {GL_INVALID_VALUE, "{1} has no {3} levels from {2} on (APPLE_copy_texture_levels)"};
  }
  if (to->target != from->target || to->level[0].internal != from->level[0].internal) {
    return {GL_INVALID_OPERATION,
            "{0} and {1} differ in their targets or formats (APPLE_copy_texture_levels)"};
  }
  return operation_unless(matching_level(*to, *from, base, count) >= 0,
                          "{0} has no levels of these sizes (APPLE_copy_texture_levels)");
}

}  // namespace clearpipe::api::validate
