// Texture objects, their parameters, the texture environment (3.7.5, 3.7.11, 3.7.12), and generated
// texture coordinates.
// SPDX-License-Identifier: MIT
#include "api/exec.h"
#include "api/framebuffer.h"
#include "api/texture_target.h"

namespace clearpipe::api::exec {

void active_texture(Context& c, GLenum texture) {
  c.state.texture.active = static_cast<GLint>(texture - GL_TEXTURE0);
}

void bind_texture(Context& c, GLenum target, GLuint name) {
  TextureUnitState& unit = c.active_unit();
  TexturePtr& bound = target == GL_TEXTURE_2D             ? unit.texture
                      : target == GL_TEXTURE_EXTERNAL_OES ? unit.external_texture
                                                          : unit.cube_texture;
  const TexturePtr& texture = name != 0                           ? c.share->textures.bind(name)
                              : target == GL_TEXTURE_2D           ? c.default_texture
                              : target == GL_TEXTURE_EXTERNAL_OES ? c.default_external_texture
                                                                  : c.default_cube_texture;
  texture->set_target(target);
  set_state(c, bound, texture, kDirtyTexture);
}

void gen_textures(Context& c, GLsizei n, GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) names[i] = c.share->textures.generate();
}

void delete_textures(Context& c, GLsizei n, const GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) {
    if (names[i] == 0) continue;
    const TexturePtr texture = c.share->textures.find(names[i]);
    for (TextureUnitState& unit : c.state.texture.unit) {
      if (unit.texture == texture) unit.texture = c.default_texture;
      if (unit.cube_texture == texture) unit.cube_texture = c.default_cube_texture;
      if (unit.external_texture == texture) unit.external_texture = c.default_external_texture;
    }
    detach(c, texture);
    c.share->textures.erase(names[i]);
  }
  c.dirty |= kDirtyTexture;
}

GLboolean is_texture(Context& c, GLuint name) { return c.share->textures.find(name) != nullptr; }

void tex_parameter(Context& c, GLenum target, GLenum pname, const Params& p) {
  TextureObject& texture = *bound_texture(c, target);
  switch (pname) {
    case GL_TEXTURE_MIN_FILTER:
      texture.min_filter = p.enumerant();
      break;
    case GL_TEXTURE_MAG_FILTER:
      texture.mag_filter = p.enumerant();
      break;
    case GL_TEXTURE_WRAP_S:
      texture.wrap_s = p.enumerant();
      break;
    case GL_TEXTURE_WRAP_T:
      texture.wrap_t = p.enumerant();
      break;
    case GL_TEXTURE_MAX_LEVEL_APPLE:
      texture.max_level = p.integer();
      break;
    case GL_TEXTURE_MAX_ANISOTROPY_EXT:
      texture.max_anisotropy = p.number();
      break;
    case GL_TEXTURE_CROP_RECT_OES:
      for (int i = 0; i < 4; ++i) texture.crop_rect[i] = p.integer(i);
      break;
    default:
      texture.generate_mipmap = p.boolean();
      break;
  }
  ++texture.version;
}

void tex_env(Context& c, GLenum target, GLenum pname, const Params& p) {
  TextureUnitState& unit = c.active_unit();
  if (target == GL_POINT_SPRITE_OES) {
    c.dirty |= kDirtyRaster;
    unit.coord_replace = p.boolean();
    return;
  }
  const auto set = [&c](auto& to, const auto& value) { set_state(c, to, value, kDirtyUnits); };
  if (target == GL_TEXTURE_FILTER_CONTROL_EXT) {
    set(unit.lod_bias, p.number());
    return;
  }
  switch (pname) {
    case GL_TEXTURE_ENV_MODE:
      set(unit.env_mode, p.enumerant());
      break;
    case GL_TEXTURE_ENV_COLOR:
      set(unit.env_colour, pipeline::Vec4{clamp01(p.colour(0)), clamp01(p.colour(1)),
                                          clamp01(p.colour(2)), clamp01(p.colour(3))});
      break;
    case GL_COMBINE_RGB:
      set(unit.combine_rgb, p.enumerant());
      break;
    case GL_COMBINE_ALPHA:
      set(unit.combine_alpha, p.enumerant());
      break;
    case GL_SRC0_RGB:
    case GL_SRC1_RGB:
    case GL_SRC2_RGB:
      set(unit.src_rgb[pname - GL_SRC0_RGB], p.enumerant());
      break;
    case GL_SRC0_ALPHA:
    case GL_SRC1_ALPHA:
    case GL_SRC2_ALPHA:
      set(unit.src_alpha[pname - GL_SRC0_ALPHA], p.enumerant());
      break;
    case GL_OPERAND0_RGB:
    case GL_OPERAND1_RGB:
    case GL_OPERAND2_RGB:
      set(unit.operand_rgb[pname - GL_OPERAND0_RGB], p.enumerant());
      break;
    case GL_OPERAND0_ALPHA:
    case GL_OPERAND1_ALPHA:
    case GL_OPERAND2_ALPHA:
      set(unit.operand_alpha[pname - GL_OPERAND0_ALPHA], p.enumerant());
      break;
    case GL_RGB_SCALE:
      set(unit.rgb_scale, p.number());
      break;
    default:
      set(unit.alpha_scale, p.number());
      break;
  }
}

// OES_texture_cube_map: the only coordinates that are generated are s, t and r together.
void tex_gen(Context& c, GLenum, GLenum, const Params& p) {
  c.active_unit().gen_mode = p.enumerant();
  c.dirty |= kDirtyTexCoord;
}

}  // namespace clearpipe::api::exec
