// The targets of textures: of a texture as a whole (3.7.5, 3.7.11), and of its images (3.7.1),
// which are six for a cube map (OES_texture_cube_map). An external texture has none but that of an
// EGLImage (OES_EGL_image_external). SPDX-License-Identifier: MIT
#pragma once

#include "api/context_state.h"

namespace clearpipe::api {

inline bool is_texture_target(GLenum target) {
  return target == GL_TEXTURE_2D || target == GL_TEXTURE_CUBE_MAP_OES ||
         target == GL_TEXTURE_EXTERNAL_OES;
}

inline bool is_cube_face(GLenum target) {
  return target >= GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES &&
         target <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z_OES;
}

inline bool is_image_target(GLenum target) {
  return target == GL_TEXTURE_2D || is_cube_face(target);
}

// The place of an image in TextureObject::level and in its pipeline image.
inline size_t image_index(GLenum image_target, GLint level) {
  const size_t face =
      is_cube_face(image_target) ? image_target - GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES : 0;
  return face * kTextureLevels + static_cast<size_t>(level);
}

// The texture bound to a target in the active unit.
inline const TexturePtr& bound_texture(const Context& c, GLenum target) {
  const TextureUnitState& unit = c.active_unit();
  return target == GL_TEXTURE_2D             ? unit.texture
         : target == GL_TEXTURE_EXTERNAL_OES ? unit.external_texture
                                             : unit.cube_texture;
}

// The texture that a unit samples if it is complete: an external one goes first, then a cube map.
// Null: texturing is disabled.
inline TextureObject* enabled_texture(const TextureUnitState& unit) {
  return unit.external_enabled ? unit.external_texture.get()
         : unit.cube_enabled   ? unit.cube_texture.get()
         : unit.enabled        ? unit.texture.get()
                               : nullptr;
}

}  // namespace clearpipe::api
