// Validators of framebuffer and renderbuffer objects (OES_framebuffer_object; sections are those of
// EXT_framebuffer_object).
// SPDX-License-Identifier: MIT
#include "api/framebuffer.h"
#include "api/pixel_format.h"
#include "api/renderbuffer_format.h"
#include "api/texture_target.h"
#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {

GLenum enum_if(bool good) { return good ? GL_NO_ERROR : GL_INVALID_ENUM; }

bool is_attachment_point(GLenum name) {
  return name == GL_COLOR_ATTACHMENT0_OES || name == GL_DEPTH_ATTACHMENT_OES ||
         name == GL_STENCIL_ATTACHMENT_OES;
}

// 4.4.2: target and attachment, and that a framebuffer object is bound.
GLenum attachment(const Context& c, GLenum target, GLenum name) {
  if (target != GL_FRAMEBUFFER_OES || !is_attachment_point(name)) return GL_INVALID_ENUM;
  return c.framebuffer ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

}  // namespace

GLenum framebuffer_target(const Context&, GLenum target) {
  return enum_if(target == GL_FRAMEBUFFER_OES);
}
GLenum framebuffer_target(const Context& c, GLenum target, GLuint) {
  return framebuffer_target(c, target);
}

GLenum renderbuffer_target(const Context&, GLenum target, GLuint) {
  return enum_if(target == GL_RENDERBUFFER_OES);
}

GLenum renderbuffer_storage(const Context& c, GLenum target, GLenum internal, GLsizei width,
                            GLsizei height) {
  if (target != GL_RENDERBUFFER_OES || !renderbuffer_format(internal)) return GL_INVALID_ENUM;
  if (width < 0 || height < 0 || width > kMaxRenderbufferSize || height > kMaxRenderbufferSize) {
    return GL_INVALID_VALUE;
  }
  return c.renderbuffer ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

GLenum get_renderbuffer_parameter(const Context& c, GLenum target, GLenum pname, const GLint*) {
  const bool known =
      (pname >= GL_RENDERBUFFER_WIDTH_OES && pname <= GL_RENDERBUFFER_INTERNAL_FORMAT_OES) ||
      (pname >= GL_RENDERBUFFER_RED_SIZE_OES && pname <= GL_RENDERBUFFER_STENCIL_SIZE_OES);
  if (target != GL_RENDERBUFFER_OES || !known) return GL_INVALID_ENUM;
  return c.renderbuffer ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

GLenum framebuffer_renderbuffer(const Context& c, GLenum target, GLenum point,
                                GLenum renderbuffer_target, GLuint name) {
  if (const GLenum error = attachment(c, target, point)) return error;
  if (renderbuffer_target != GL_RENDERBUFFER_OES) return GL_INVALID_ENUM;
  return name == 0 || c.share->renderbuffers.find(name) ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

// Every level may be attached (OES_fbo_render_mipmap).
GLenum framebuffer_texture(const Context& c, GLenum target, GLenum point, GLenum texture_target,
                           GLuint name, GLint level) {
  if (const GLenum error = attachment(c, target, point)) return error;
  if (name == 0) return GL_NO_ERROR;
  if (!is_image_target(texture_target)) return GL_INVALID_ENUM;
  const TexturePtr texture = c.share->textures.find(name);
  const bool fits =
      texture && (texture->target == GL_TEXTURE_2D) == (texture_target == GL_TEXTURE_2D);
  if (!fits) return GL_INVALID_OPERATION;
  return level >= 0 && level < kTextureLevels ? GL_NO_ERROR : GL_INVALID_VALUE;
}

// 6.1.3: what does not apply to the kind of attachment cannot be asked for.
GLenum get_framebuffer_attachment_parameter(const Context& c, GLenum target, GLenum point,
                                            GLenum pname, const GLint*) {
  if (const GLenum error = attachment(c, target, point)) return error;
  const Attachment& a = *attachment_point(*c.framebuffer, point);
  switch (pname) {
    case GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES:
      return GL_NO_ERROR;
    case GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME_OES:
      return enum_if(a.renderbuffer || a.texture);
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL_OES:
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE_OES:
      return enum_if(a.texture != nullptr);
    default:
      return GL_INVALID_ENUM;
  }
}

GLenum discard_framebuffer(const Context& c, GLenum target, GLsizei n, const GLenum* attachments) {
  if (target != GL_FRAMEBUFFER_OES) return GL_INVALID_ENUM;
  if (n < 0) return GL_INVALID_VALUE;
  for (GLsizei i = 0; i < n; ++i) {
    const GLenum a = attachments[i];
    const bool known = c.framebuffer
                           ? is_attachment_point(a)
                           : a == GL_COLOR_EXT || a == GL_DEPTH_EXT || a == GL_STENCIL_EXT;
    if (!known) return GL_INVALID_ENUM;
  }
  return GL_NO_ERROR;
}

GLenum generate_mipmap(const Context& c, GLenum target) {
  if (!is_texture_target(target)) return GL_INVALID_ENUM;
  const TextureObject& texture = *bound_texture(c, target);
  const bool cube = target == GL_TEXTURE_CUBE_MAP_OES;
  if (cube && !is_cube_complete(texture)) return GL_INVALID_OPERATION;
  const GLenum internal = texture.level[0].internal;
  // Not from compressed images.
  return internal == 0 || base_format(internal) != 0 ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

}  // namespace clearpipe::api::validate
