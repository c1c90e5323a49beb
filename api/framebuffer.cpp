// See framebuffer.h. Sections are those of EXT_framebuffer_object, which OES_framebuffer_object
// refers to.
// SPDX-License-Identifier: MIT
#include "api/framebuffer.h"

#include <algorithm>
#include <new>

#include "api/egl_image.h"
#include "api/pixel_format.h"

namespace clearpipe::api {

namespace {

// The image of an attachment: its size, and what it may be used as.
struct AttachedImage {
  bool present = false;
  int width = 0, height = 0;
  bool colour = false, depth = false, stencil = false;
  int samples = 0;
};

AttachedImage image_of(const Attachment& a) {
  AttachedImage image;
  if (a.renderbuffer) {
    const RenderbufferObject& r = *a.renderbuffer;
    image = {true, r.width, r.height, r.colour != nullptr, false, false, r.samples};
    image.depth = r.depth_stencil && r.depth_stencil->has_depth;
    image.stencil = r.depth_stencil && r.depth_stencil->has_stencil;
  } else if (a.texture) {
    const TextureLevel& level = a.texture->level[a.image];
    // RGB and RGBA of any size are colour-renderable; compressed images are not.
    const bool colour =
        base_format(level.internal) != 0 && (level.format == GL_RGB || level.format == GL_RGBA);
    image = {true, level.width, level.height, colour, false, false, a.samples};
  }
  return image;
}

// 4.4.4.1: framebuffer attachment completeness.
bool is_attachment_complete(const AttachedImage& image, bool fits) {
  return !image.present || (image.width > 0 && image.height > 0 && fits);
}

// 4.4.4.2: framebuffer completeness. Depth and stencil must be one image.
GLenum status_of(const FramebufferObject& f) {
  const AttachedImage colour = image_of(f.colour), depth = image_of(f.depth),
                      stencil = image_of(f.stencil);
  if (!is_attachment_complete(colour, colour.colour) ||
      !is_attachment_complete(depth, depth.depth) ||
      !is_attachment_complete(stencil, stencil.stencil)) {
    return GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT_OES;
  }
  const AttachedImage* first = nullptr;
  for (const AttachedImage* image : {&colour, &depth, &stencil}) {
    if (!image->present) continue;
    if (!first) first = image;
    if (image->width != first->width || image->height != first->height) {
      return GL_FRAMEBUFFER_INCOMPLETE_DIMENSIONS_OES;
    }
  }
  if (!first) return GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT_OES;
  for (const AttachedImage* image : {&colour, &depth, &stencil}) {
    if (image->present && image->samples != first->samples) {
      return GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE_EXT;
    }
  }
  if (depth.present && stencil.present && f.depth.renderbuffer != f.stencil.renderbuffer) {
    return GL_FRAMEBUFFER_UNSUPPORTED_OES;
  }
  return GL_FRAMEBUFFER_COMPLETE_OES;
}

// Whether two buffers are the same view of the same memory.
bool same(const std::shared_ptr<uint32_t[]>& a, const std::shared_ptr<uint32_t[]>& b) {
  return a == b && !a.owner_before(b) && !b.owner_before(a);
}
bool same(const pipeline::ColourBuffer* a, const pipeline::ColourBuffer* b) {
  if (a == b || !a || !b) return a == b;
  return same(a->pixels, b->pixels) && a->width == b->width && a->height == b->height &&
         a->has_alpha == b->has_alpha && a->srgb == b->srgb && a->format == b->format &&
         a->uniform == b->uniform && a->samples == b->samples;
}
bool same(const pipeline::DepthStencilBuffer* a, const pipeline::DepthStencilBuffer* b) {
  if (a == b || !a || !b) return a == b;
  return same(a->values, b->values) && a->width == b->width && a->height == b->height &&
         a->depth_bits == b->depth_bits && a->has_depth == b->has_depth &&
         a->has_stencil == b->has_stencil;
}

// The buffer as it was last time, if it is still the same.
template <typename Buffer>
std::shared_ptr<Buffer> kept(std::shared_ptr<Buffer>& last, const Buffer& now) {
  if (!same(last.get(), &now)) last = std::make_shared<Buffer>(now);
  return last;
}

// A level of a texture as a buffer to draw to: the same memory.
pipeline::ColourBuffer buffer_of(TextureObject& texture, size_t index) {
  refresh(texture);
  const pipeline::ImageLevel& from = texture.image->levels[index];
  pipeline::ColourBuffer buffer;
  buffer.width = from.width;
  buffer.height = from.height;
  buffer.pixels = from.texels.memory();
  buffer.has_alpha = texture.level[index].format == GL_RGBA;
  buffer.srgb = is_srgb(texture.level[index].internal);
  return buffer;
}

// The same of an attachment, with its implicit multisample buffer: a new one if the level has other
// memory than before (EXT_multisampled_render_to_texture).
std::shared_ptr<pipeline::ColourBuffer> buffer_of(Attachment& a) {
  pipeline::ColourBuffer buffer = buffer_of(*a.texture, a.image);
  if (a.samples == 0) return kept(a.colour_buffer, buffer);
  const size_t tiles = pipeline::tile_count(buffer.width, buffer.height);
  if (!a.sample_buffer || a.sample_buffer->discarded.size() != tiles ||
      a.sampled.lock() != buffer.pixels) {
    a.sample_buffer = pipeline::make_sample_buffer(buffer.width, buffer.height);
    if (!a.sample_buffer) throw std::bad_alloc();
    a.sampled = buffer.pixels;
  }
  buffer.samples = a.sample_buffer;
  return kept(a.colour_buffer, buffer);
}

// A renderbuffer's depth and stencil as far as they are attached: the same memory.
std::shared_ptr<pipeline::DepthStencilBuffer> buffer_of(FramebufferObject& f) {
  Attachment& a = f.depth.renderbuffer ? f.depth : f.stencil;
  if (!a.renderbuffer) return nullptr;
  const pipeline::DepthStencilBuffer& from = *a.renderbuffer->depth_stencil;
  pipeline::DepthStencilBuffer buffer = from;
  buffer.has_depth = f.depth.renderbuffer != nullptr;
  buffer.has_stencil = f.stencil.renderbuffer != nullptr;
  buffer.partial_view =
      buffer.has_depth != from.has_depth || buffer.has_stencil != from.has_stencil;
  return kept(a.depth_stencil_buffer, buffer);
}

// Of a complete framebuffer object.
pipeline::Target target_of(FramebufferObject& f) {
  pipeline::Target target;
  target.mirrored = false;
  if (f.colour.renderbuffer) {
    refresh(*f.colour.renderbuffer);
    target.colour = f.colour.renderbuffer->colour;
  } else if (f.colour.texture) {
    target.colour = buffer_of(f.colour);
  }
  target.depth_stencil = buffer_of(f);
  target.width = target.colour ? target.colour->width : target.depth_stencil->width;
  target.height = target.colour ? target.colour->height : target.depth_stencil->height;
  return target;
}

bool same(const pipeline::Target& a, const pipeline::Target& b) {
  return same(a.colour.get(), b.colour.get()) &&
         same(a.depth_stencil.get(), b.depth_stencil.get()) && a.width == b.width &&
         a.height == b.height && a.mirrored == b.mirrored;
}

constexpr Invalid kNoSurface{GL_INVALID_FRAMEBUFFER_OPERATION_OES,
                             "the context is current without a surface "
                             "(OES_surfaceless_context)"};

// Whether the target is one of the first levels of the texture, or of one of its faces: itself, or
// through an EGLImage.
bool draws_to(const Context& c, const TextureObject& texture, size_t levels) {
  if (!c.draw.colour) return false;
  const auto& images = texture.image->levels;
  const auto found = std::find_if(images.begin(), images.end(), [&c](const auto& level) {
    return level.texels.memory() == c.draw.colour->pixels;
  });
  return found != images.end() &&
         static_cast<size_t>(found - images.begin()) % kTextureLevels < levels;
}

}  // namespace

GLenum framebuffer_status(const Context& c) {
  if (c.framebuffer) return status_of(*c.framebuffer);
  return c.surface_draw.colour || c.surface_draw.depth_stencil ? GL_FRAMEBUFFER_COMPLETE_OES
                                                               : GL_FRAMEBUFFER_UNDEFINED_OES;
}

Invalid drawn_framebuffer(const Context& c) {
  const auto incomplete = [](const char* rule) {
    return Invalid(GL_INVALID_FRAMEBUFFER_OPERATION_OES, rule);
  };
  switch (framebuffer_status(c)) {
    case GL_FRAMEBUFFER_COMPLETE_OES:
      return {};
    case GL_FRAMEBUFFER_UNDEFINED_OES:
      return kNoSurface;
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT_OES:
      return incomplete(
          "an image attached to the framebuffer object has no size, or a format that cannot be "
          "drawn to there (OES_framebuffer_object, 4.4.4.1)");
    case GL_FRAMEBUFFER_INCOMPLETE_DIMENSIONS_OES:
      return incomplete(
          "the images attached to the framebuffer object differ in size (OES_framebuffer_object, "
          "4.4.4.2)");
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT_OES:
      return incomplete(
          "nothing is attached to the framebuffer object (OES_framebuffer_object, 4.4.4.2)");
    case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE_EXT:
      return incomplete(
          "the images attached to the framebuffer object differ in their samples "
          "(EXT_multisampled_render_to_texture, 4.4.5)");
    default:
      return incomplete(
          "depth and stencil of the framebuffer object are different images, which is not "
          "supported (OES_framebuffer_object, 4.4.4.2)");
  }
}

Invalid read_framebuffer(const Context& c) {
  if (!c.framebuffer) return c.surface_read.colour ? Invalid() : kNoSurface;
  if (const Invalid wrong = drawn_framebuffer(c)) return wrong;
  return operation_unless(image_of(c.framebuffer->colour).present,
                          "the framebuffer object has no colour image to read (4.3.1)");
}

pipeline::Target draw_target(const Context& c) {
  if (!c.framebuffer) return c.surface_draw;
  return status_of(*c.framebuffer) == GL_FRAMEBUFFER_COMPLETE_OES ? target_of(*c.framebuffer)
                                                                  : pipeline::Target();
}

pipeline::Target read_target(const Context& c) {
  return c.framebuffer ? draw_target(c) : c.surface_read;
}

bool is_rgb565(const pipeline::Target& target) {
  return target.colour && target.colour->format == pipeline::ColourFormat::kRgb565;
}

void use_targets(Context& c, const pipeline::Target& draw, const pipeline::Target& read) {
  c.finish_frame(Slow::kChangesTarget);
  c.frame.set_target(draw);
  c.draw = draw;
  c.read = read;
  c.dirty = kDirtyAll;
}

void update_targets(Context& c) {
  if (!c.framebuffer) {
    begin_frame(&c);
    if (!same(c.surface_draw, c.draw)) use_targets(c, c.surface_draw, c.surface_read);
    return;
  }
  const pipeline::Target draw = draw_target(c);
  if (!same(draw, c.draw)) use_targets(c, draw, read_target(c));
}

void note_drawn_image(Context& c) {
  if (!c.framebuffer) {
    c.surface_drawn = true;
    return;
  }
  const Attachment& colour = c.framebuffer->colour;
  if (colour.texture) note_uses(c, *colour.texture);
  if (colour.renderbuffer) note_uses(c, *colour.renderbuffer);
}

void finish_drawing_to(Context& c, const TextureObject& texture) {
  if (!draws_to(c, texture, kTextureLevels)) return;
  c.finish_frame(Slow::kFinishes);
  if (c.framebuffer) discard_samples(*c.framebuffer);
}

void discard_samples(FramebufferObject& framebuffer) {
  if (const auto& samples = framebuffer.colour.sample_buffer) {
    std::fill(samples->discarded.begin(), samples->discarded.end(), uint8_t{1});
  }
}

bool samples_its_target(const Context& c, const TextureObject& texture) {
  return draws_to(c, texture, is_mipmap_filter(texture.min_filter) ? kTextureLevels : 1);
}

Attachment* attachment_point(FramebufferObject& framebuffer, GLenum name) {
  switch (name) {
    case GL_COLOR_ATTACHMENT0_OES:
      return &framebuffer.colour;
    case GL_DEPTH_ATTACHMENT_OES:
      return &framebuffer.depth;
    case GL_STENCIL_ATTACHMENT_OES:
      return &framebuffer.stencil;
    default:
      return nullptr;
  }
}

void detach(Context& c, const TexturePtr& texture) {
  if (!c.framebuffer || !texture) return;
  FramebufferObject& f = *c.framebuffer;
  for (Attachment* a : {&f.colour, &f.depth, &f.stencil}) {
    if (a->texture != texture) continue;
    c.finish_frame(Slow::kChangesTarget);
    *a = {};
  }
}

void detach(Context& c, const RenderbufferPtr& renderbuffer) {
  if (!c.framebuffer || !renderbuffer) return;
  FramebufferObject& f = *c.framebuffer;
  for (Attachment* a : {&f.colour, &f.depth, &f.stencil}) {
    if (a->renderbuffer != renderbuffer) continue;
    c.finish_frame(Slow::kChangesTarget);
    *a = {};
  }
}

}  // namespace clearpipe::api
