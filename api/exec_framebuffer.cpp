// Framebuffer and renderbuffer objects (OES_framebuffer_object; sections are those of
// EXT_framebuffer_object).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <new>

#include "api/exec.h"
#include "api/framebuffer.h"
#include "api/pixel_format.h"
#include "api/renderbuffer_format.h"
#include "api/texture_target.h"

namespace clearpipe::api::exec {

namespace {

void attach(Context& c, GLenum point, const Attachment& attachment) {
  // What was drawn to the former image is in it before anyone looks.
  c.finish_frame(Slow::kChangesTarget);
  *attachment_point(*c.framebuffer, point) = attachment;
}

// EXT_multisampled_render_to_texture, 4.4.3: the next number that is supported.
int supported_samples(GLsizei samples) { return samples > 0 ? kMaxSamples : 0; }

// Whether the attached colours are sRGB-encoded (EXT_sRGB, 6.1.13).
bool is_encoded(const Attachment& a) {
  return a.renderbuffer ? renderbuffer_format(a.renderbuffer->internal).srgb
                        : is_srgb(a.texture->level[a.image].internal);
}

}  // namespace

GLboolean is_renderbuffer(Context& c, GLuint name) {
  return c.share->renderbuffers.find(name) != nullptr;
}

void bind_renderbuffer(Context& c, GLenum, GLuint name) {
  c.renderbuffer = name == 0 ? nullptr : c.share->renderbuffers.bind(name);
}

void gen_renderbuffers(Context& c, GLsizei n, GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) names[i] = c.share->renderbuffers.generate();
}

void delete_renderbuffers(Context& c, GLsizei n, const GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) {
    const RenderbufferPtr renderbuffer = c.share->renderbuffers.find(names[i]);
    detach(c, renderbuffer);
    if (c.renderbuffer == renderbuffer) c.renderbuffer = nullptr;
    c.share->renderbuffers.erase(names[i]);
  }
}

void renderbuffer_storage(Context& c, GLenum target, GLenum internal, GLsizei width,
                          GLsizei height) {
  renderbuffer_storage_multisample(c, target, 0, internal, width, height);
}

void renderbuffer_storage_multisample(Context& c, GLenum, GLsizei samples, GLenum internal,
                                      GLsizei width, GLsizei height) {
  const int kept = supported_samples(samples);
  const RenderbufferFormat format = renderbuffer_format(internal);
  std::shared_ptr<pipeline::ColourBuffer> colour;
  std::shared_ptr<pipeline::DepthStencilBuffer> depth_stencil;
  if (width > 0 && height > 0) {
    const int planes = std::max(kept, 1);
    if (format.colour) {
      colour = pipeline::make_colour_buffer(width, height, format.alpha, planes);
      if (colour) {
        colour->srgb = format.srgb;
        colour->format = format.format;
      }
    } else {
      depth_stencil =
          pipeline::make_depth_stencil_buffer(width, height, format.depth, format.stencil, planes);
      if (depth_stencil) depth_stencil->depth_bits = format.depth_bits;
    }
    if (!colour && !depth_stencil) throw std::bad_alloc();
  }
  RenderbufferObject& r = *c.renderbuffer;
  r.width = width;
  r.height = height;
  r.samples = kept;
  r.internal = internal;
  r.colour = std::move(colour);
  r.depth_stencil = std::move(depth_stencil);
  r.sibling = nullptr;
}

void get_renderbuffer_parameter(Context& c, GLenum, GLenum pname, GLint* params) {
  const RenderbufferObject& r = *c.renderbuffer;
  // Before there is storage, there are no components (table 8.nnn).
  const RenderbufferFormat format =
      r.colour || r.depth_stencil ? renderbuffer_format(r.internal) : RenderbufferFormat();
  const std::array<int, 4> bits = pipeline::component_bits(format.format);
  switch (pname) {
    case GL_RENDERBUFFER_WIDTH_OES:
      *params = r.width;
      break;
    case GL_RENDERBUFFER_HEIGHT_OES:
      *params = r.height;
      break;
    case GL_RENDERBUFFER_INTERNAL_FORMAT_OES:
      *params = static_cast<GLint>(r.internal);
      break;
    case GL_RENDERBUFFER_SAMPLES_EXT:
      *params = r.samples;
      break;
    case GL_RENDERBUFFER_ALPHA_SIZE_OES:
      *params = format.alpha ? bits[3] : 0;
      break;
    case GL_RENDERBUFFER_DEPTH_SIZE_OES:
      *params = format.depth ? format.depth_bits : 0;
      break;
    case GL_RENDERBUFFER_STENCIL_SIZE_OES:
      *params = format.stencil ? 8 : 0;
      break;
    default:  // GL_RENDERBUFFER_RED_SIZE_OES and the two after it
      *params = format.colour ? bits[pname - GL_RENDERBUFFER_RED_SIZE_OES] : 0;
      break;
  }
}

GLboolean is_framebuffer(Context& c, GLuint name) {
  return c.share->framebuffers.find(name) != nullptr;
}

void bind_framebuffer(Context& c, GLenum, GLuint name) {
  c.framebuffer = name == 0 ? nullptr : c.share->framebuffers.bind(name);
  use_targets(c, draw_target(c), read_target(c));
  if (c.framebuffer) discard_samples(*c.framebuffer);
}

void gen_framebuffers(Context& c, GLsizei n, GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) names[i] = c.share->framebuffers.generate();
}

void delete_framebuffers(Context& c, GLsizei n, const GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) {
    const FramebufferPtr framebuffer = c.share->framebuffers.find(names[i]);
    c.share->framebuffers.erase(names[i]);
    if (framebuffer && c.framebuffer == framebuffer) bind_framebuffer(c, GL_FRAMEBUFFER_OES, 0);
  }
}

GLenum check_framebuffer_status(Context& c, GLenum) { return framebuffer_status(c); }

void framebuffer_renderbuffer(Context& c, GLenum, GLenum point, GLenum, GLuint name) {
  Attachment attachment;
  attachment.renderbuffer = c.share->renderbuffers.find(name);
  attach(c, point, attachment);
}

void framebuffer_texture(Context& c, GLenum, GLenum point, GLenum target, GLuint name,
                         GLint level) {
  Attachment attachment;
  attachment.texture = c.share->textures.find(name);
  if (attachment.texture) {
    attachment.level = level;
    attachment.face = is_cube_face(target) ? target : 0;
    attachment.image = image_index(target, level);
  }
  attach(c, point, attachment);
}

void framebuffer_texture_multisample(Context& c, GLenum target, GLenum point, GLenum texture_target,
                                     GLuint name, GLint level, GLsizei samples) {
  framebuffer_texture(c, target, point, texture_target, name, level);
  Attachment& attachment = *attachment_point(*c.framebuffer, point);
  if (attachment.texture) attachment.samples = supported_samples(samples);
}

void get_framebuffer_attachment_parameter(Context& c, GLenum, GLenum point, GLenum pname,
                                          GLint* params) {
  const Attachment& a = *attachment_point(*c.framebuffer, point);
  switch (pname) {
    case GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES:
      *params = a.renderbuffer ? GL_RENDERBUFFER_OES : a.texture ? GL_TEXTURE : GL_NONE_OES;
      break;
    case GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME_OES:
      *params = static_cast<GLint>(a.renderbuffer ? a.renderbuffer->name : a.texture->name);
      break;
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL_OES:
      *params = a.level;
      break;
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_SAMPLES_EXT:
      *params = a.samples;
      break;
    case GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING_EXT:
      *params = is_encoded(a) ? GL_SRGB_EXT : GL_LINEAR;
      break;
    default:
      *params = static_cast<GLint>(a.face);
      break;
  }
}

// The contents become undefined: they may as well stay (EXT_discard_framebuffer). Tiles are not
// stored before a frame is executed, and nothing says that nothing will be drawn after this.
void discard_framebuffer(Context&, GLenum, GLsizei, const GLenum*) {}

}  // namespace clearpipe::api::exec
