// Validators of framebuffer and renderbuffer objects (OES_framebuffer_object; sections are those of
// EXT_framebuffer_object).
// SPDX-License-Identifier: MIT
#include "api/framebuffer.h"
#include "api/pixel_format.h"
#include "api/renderbuffer_format.h"
#include "api/validate_image.h"

namespace clearpipe::api::validate {

namespace {

Invalid attachment_name(GLenum name) {
  return enum_unless(name == GL_COLOR_ATTACHMENT0_OES || name == GL_DEPTH_ATTACHMENT_OES ||
                         name == GL_STENCIL_ATTACHMENT_OES,
                     "{0} is no attachment point (OES_framebuffer_object, 4.4.2)");
}

// 4.4.2: target and attachment, and that a framebuffer object is bound.
Invalid attachment(const Context& c, GLenum target, GLenum name) {
  if (const Invalid wrong = framebuffer_target(c, target)) return wrong;
  if (const Invalid wrong = attachment_name(name)) return wrong.from(1);
  return operation_unless(c.framebuffer != nullptr,
                          "the window-system framebuffer has no attachments: no framebuffer "
                          "object is bound (OES_framebuffer_object, 4.4.2)");
}

Invalid sample_count(GLsizei samples) {
  return value_unless(samples >= 0 && samples <= kMaxSamples,
                      "{0} is not in [0, MAX_SAMPLES_EXT] (EXT_multisampled_render_to_texture, "
                      "4.4.3)");
}

Invalid no_renderbuffer(const Context& c) {
  return operation_unless(c.renderbuffer != nullptr,
                          "no renderbuffer is bound (OES_framebuffer_object, 4.4.2.1)");
}

}  // namespace

Invalid framebuffer_target(const Context&, GLenum target) {
  return enum_unless(target == GL_FRAMEBUFFER_OES,
                     "{0} is not FRAMEBUFFER_OES (OES_framebuffer_object, 4.4.1)");
}
Invalid framebuffer_target(const Context& c, GLenum target, GLuint) {
  return framebuffer_target(c, target);
}

Invalid renderbuffer_target(const Context&, GLenum target, GLuint) {
  return enum_unless(target == GL_RENDERBUFFER_OES,
                     "{0} is not RENDERBUFFER_OES (OES_framebuffer_object, 4.4.2.1)");
}

Invalid renderbuffer_storage(const Context& c, GLenum target, GLenum internal, GLsizei width,
                             GLsizei height) {
  if (const Invalid wrong = renderbuffer_target(c, target, 0)) return wrong;
  if (!renderbuffer_format(internal)) {
    return {GL_INVALID_ENUM, "{1} is no format of renderbuffers (OES_framebuffer_object, 4.4.2.1)"};
  }
  const auto fits = [](GLsizei size) { return size >= 0 && size <= kMaxRenderbufferSize; };
  if (!fits(width) || !fits(height)) {
    return {GL_INVALID_VALUE,
            "{2} or {3} is not in [0, MAX_RENDERBUFFER_SIZE] (OES_framebuffer_object, 4.4.2.1)"};
  }
  return no_renderbuffer(c);
}

Invalid renderbuffer_storage_multisample(const Context& c, GLenum target, GLsizei samples,
                                         GLenum internal, GLsizei width, GLsizei height) {
  if (const Invalid wrong = renderbuffer_target(c, target, 0)) return wrong;
  if (const Invalid wrong = sample_count(samples)) return wrong.from(1);
  return renderbuffer_storage(c, target, internal, width, height).from(1);
}

Invalid get_renderbuffer_parameter(const Context& c, GLenum target, GLenum pname, const GLint*) {
  if (const Invalid wrong = renderbuffer_target(c, target, 0)) return wrong;
  const bool known =
      (pname >= GL_RENDERBUFFER_WIDTH_OES && pname <= GL_RENDERBUFFER_INTERNAL_FORMAT_OES) ||
      (pname >= GL_RENDERBUFFER_RED_SIZE_OES && pname <= GL_RENDERBUFFER_STENCIL_SIZE_OES) ||
      pname == GL_RENDERBUFFER_SAMPLES_EXT;
  if (!known) {
    return {GL_INVALID_ENUM,
            "{1} is no parameter of renderbuffers (OES_framebuffer_object, 6.1.3)"};
  }
  return no_renderbuffer(c);
}

Invalid framebuffer_renderbuffer(const Context& c, GLenum target, GLenum point,
                                 GLenum renderbuffer_target, GLuint name) {
  if (const Invalid wrong = attachment(c, target, point)) return wrong;
  if (const Invalid wrong = validate::renderbuffer_target(c, renderbuffer_target, 0)) {
    return wrong.from(2);
  }
  return operation_unless(name == 0 || c.share->renderbuffers.find(name),
                          "{3} is no renderbuffer (OES_framebuffer_object, 4.4.2.2)");
}

// Every level may be attached (OES_fbo_render_mipmap).
Invalid framebuffer_texture(const Context& c, GLenum target, GLenum point, GLenum texture_target,
                            GLuint name, GLint level) {
  if (const Invalid wrong = attachment(c, target, point)) return wrong;
  if (name == 0) return {};
  if (const Invalid wrong = image_target(texture_target)) return wrong.from(2);
  const TexturePtr texture = c.share->textures.find(name);
  const GLenum whole = is_cube_face(texture_target) ? GL_TEXTURE_CUBE_MAP_OES : texture_target;
  if (!texture || texture->target != whole) {
    return {GL_INVALID_OPERATION,
            "{3} is no texture with such an image (OES_framebuffer_object, 4.4.2.3)"};
  }
  return value_unless(level >= 0 && level < kTextureLevels,
                      "{4} is no level of a texture (OES_framebuffer_object, 4.4.2.3)");
}

Invalid framebuffer_texture_multisample(const Context& c, GLenum target, GLenum point,
                                        GLenum texture_target, GLuint name, GLint level,
                                        GLsizei samples) {
  if (const Invalid wrong = framebuffer_texture(c, target, point, texture_target, name, level)) {
    return wrong;
  }
  if (point != GL_COLOR_ATTACHMENT0_OES) {
    return {GL_INVALID_ENUM,
            "{1} is not COLOR_ATTACHMENT0 (EXT_multisampled_render_to_texture, 4.4.3)"};
  }
  return sample_count(samples).from(5);
}

// 6.1.3: what does not apply to the kind of attachment cannot be asked for.
Invalid get_framebuffer_attachment_parameter(const Context& c, GLenum target, GLenum point,
                                             GLenum pname, const GLint*) {
  if (const Invalid wrong = attachment(c, target, point)) return wrong;
  const Attachment& a = *attachment_point(*c.framebuffer, point);
  switch (pname) {
    case GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES:
      return {};
    case GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME_OES:
    case GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING_EXT:
      return enum_unless(a.renderbuffer || a.texture,
                         "{2} does not apply: nothing is attached (OES_framebuffer_object, 6.1.3)");
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL_OES:
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_SAMPLES_EXT:
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE_OES:
      return enum_unless(
          a.texture != nullptr,
          "{2} does not apply: no texture is attached (OES_framebuffer_object, 6.1.3)");
    default:
      return {GL_INVALID_ENUM,
              "{2} is no parameter of attachments (OES_framebuffer_object, 6.1.3)"};
  }
}

Invalid discard_framebuffer(const Context& c, GLenum target, GLsizei n, const GLenum* attachments) {
  if (const Invalid wrong = framebuffer_target(c, target)) return wrong;
  if (n < 0) return {GL_INVALID_VALUE, "{1} is negative (EXT_discard_framebuffer)"};
  for (GLsizei i = 0; i < n; ++i) {
    const GLenum a = attachments[i];
    if (c.framebuffer ? static_cast<bool>(attachment_name(a))
                      : a != GL_COLOR_EXT && a != GL_DEPTH_EXT && a != GL_STENCIL_EXT) {
      return {GL_INVALID_ENUM,
              "{2} has a name that is no attachment of the framebuffer (EXT_discard_framebuffer)"};
    }
  }
  return {};
}

Invalid generate_mipmap(const Context& c, GLenum target) {
  if (const Invalid wrong = specified_target(target)) return wrong;
  const TextureObject& texture = *bound_texture(c, target);
  if (target == GL_TEXTURE_CUBE_MAP_OES && !is_cube_complete(texture)) {
    return {GL_INVALID_OPERATION,
            "the faces do not make a complete cube (OES_framebuffer_object, 3.8.8)"};
  }
  const GLenum internal = texture.level[0].internal;
  if (is_srgb(internal)) {
    return {GL_INVALID_OPERATION, "the colours of the texture are sRGB-encoded (EXT_sRGB, 3.7.11)"};
  }
  return operation_unless(
      internal == 0 || base_format(internal) != 0,
      "the base level is a compressed image (OES_compressed_paletted_texture, 3.7.7)");
}

}  // namespace clearpipe::api::validate
