// EGLImages: see egl_image.h for what siblings are, and context.h for what icd/ does with images.
// SPDX-License-Identifier: MIT
#include "api/egl_image.h"

#include <algorithm>
#include <map>

#include "api/framebuffer.h"
#include "api/native_image.h"
#include "api/pixel_format.h"
#include "api/renderbuffer_format.h"
#include "api/texture_target.h"
#include "api/validate_image.h"

namespace clearpipe::api {

namespace {

using ImageLock = std::lock_guard<std::mutex>;

// Images that eglCreateImage returned, of all displays. Its lock is the last one taken.
struct ImageTable {
  std::mutex mutex;
  std::map<const void*, EglImagePtr> images;
};
ImageTable& table() {
  static auto* const images = new ImageTable;
  return *images;
}

pipeline::ImageLevel same_texels(const pipeline::ImageLevel& level) {
  return {level.width, level.height, {level.texels.memory(), level.texels.size()}};
}

void replace_memory(const EglImagePtr& sibling, const pipeline::Texels& texels) {
  if (!sibling) return;
  const ImageLock lock(sibling->mutex);
  sibling->memory = texels.memory();
  sibling->uses.clear();
}

// Whether someone else still shares the memory, or can come to.
bool is_shared(const EglImagePtr& sibling) { return sibling && sibling.use_count() > 1; }

// What a renderbuffer over the image would be made of.
GLenum renderbuffer_format_of(GLenum internal, GLenum format) {
  if (base_format(internal) == 0) return 0;  // compressed
  if (is_srgb(internal)) return internal == GL_SRGB_ALPHA_EXT ? GL_SRGB8_ALPHA8_EXT : 0;
  return format == GL_RGBA ? GL_RGBA8_OES : format == GL_RGB ? GL_RGB8_OES : 0;
}

GLenum image_target_of(ImageSource source) {
  if (source == ImageSource::kTexture2D) return GL_TEXTURE_2D;
  return GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + static_cast<GLenum>(source) -
         static_cast<GLenum>(ImageSource::kCubePositiveX);
}

// Of one image (3.9 of EGL 1.5): it is there, and either the texture is complete or has no other
// level. All faces of a cube map count.
ImageError check_level(const TextureObject& texture, GLenum image, GLint level) {
  if (level < 0 || level >= kTextureLevels) return ImageError::kBadMatch;
  if (!is_complete(texture)) {
    bool bases = true, others = false;
    for (size_t i = 0; i < texture.level.size(); ++i) {
      const bool specified = texture.level[i].width > 0;
      const bool counts = texture.target == GL_TEXTURE_CUBE_MAP_OES || i < kTextureLevels;
      if (i % kTextureLevels != 0) {
        others = others || specified;
      } else if (counts) {
        bases = bases && specified;
      }
    }
    if (level != 0 || others || !bases) return ImageError::kBadParameter;
  }
  return texture.level[image_index(image, level)].width > 0 ? ImageError::kNone
                                                            : ImageError::kBadMatch;
}

ImageError share_texture(const Context& c, GLenum image, GLuint name, GLint level,
                         EglImagePtr& out) {
  const TexturePtr texture = c.share->textures.find(name);
  const GLenum target = is_cube_face(image) ? GL_TEXTURE_CUBE_MAP_OES : GL_TEXTURE_2D;
  if (!texture || texture->target != target) return ImageError::kBadParameter;
  if (const ImageError error = check_level(*texture, image, level); error != ImageError::kNone) {
    return error;
  }
  const size_t index = image_index(image, level);
  TextureLevel& from = texture->level[index];
  if (is_shared(from.sibling) || texture->surface) return ImageError::kBadAccess;
  refresh(*texture);
  out = std::make_shared<EglImage>();
  out->width = from.width;
  out->height = from.height;
  out->internal = from.internal;
  out->format = from.format;
  out->renderbuffer_internal = renderbuffer_format_of(from.internal, from.format);
  out->memory = texture->image->levels[index].texels.memory();
  out->uses = texture->uses;
  from.sibling = out;
  texture->has_siblings = true;
  return ImageError::kNone;
}

ImageError share_renderbuffer(const Context& c, GLuint name, EglImagePtr& out) {
  const RenderbufferPtr renderbuffer = c.share->renderbuffers.find(name);
  if (!renderbuffer || (!renderbuffer->colour && !renderbuffer->depth_stencil)) {
    return ImageError::kBadParameter;
  }
  if (renderbuffer->samples != 0) return ImageError::kBadParameter;
  if (is_shared(renderbuffer->sibling)) return ImageError::kBadAccess;
  refresh(*renderbuffer);
  out = std::make_shared<EglImage>();
  out->width = renderbuffer->width;
  out->height = renderbuffer->height;
  out->renderbuffer_internal = renderbuffer->internal;
  out->depth_stencil = renderbuffer->depth_stencil;
  if (renderbuffer->colour) {
    auto rows = std::make_shared<pipeline::ColourBuffer>(*renderbuffer->colour);
    if (!pipeline::lay_out_in_rows(*rows)) return ImageError::kBadAlloc;
    out->format = rows->has_alpha ? GL_RGBA : GL_RGB;
    out->internal = rows->srgb ? GL_SRGB_ALPHA_EXT : out->format;
    out->memory = rows->pixels;
    renderbuffer->colour = std::move(rows);
  }
  renderbuffer->sibling = out;
  return ImageError::kNone;
}

}  // namespace

ImageError create_egl_image(Context* context, ImageSource source, unsigned name, int level,
                            const void* handle) noexcept try {
  const std::lock_guard<std::mutex> lock(context->share->mutex);
  EglImagePtr image;
  const ImageError error =
      source == ImageSource::kRenderbuffer
          ? share_renderbuffer(*context, name, image)
          : share_texture(*context, image_target_of(source), name, level, image);
  if (error != ImageError::kNone) return error;
  const ImageLock table_lock(table().mutex);
  table().images[handle] = std::move(image);
  return ImageError::kNone;
} catch (...) {
  return ImageError::kBadAlloc;
}

ImageError create_egl_image(std::shared_ptr<NativeImage> native, const void* handle) noexcept try {
  EglImagePtr image = make_native_image(std::move(native));
  const ImageLock lock(table().mutex);
  table().images[handle] = std::move(image);
  return ImageError::kNone;
} catch (...) {
  return ImageError::kBadAlloc;
}

void destroy_egl_image(const void* handle) noexcept {
  EglImagePtr image;  // goes when the lock is gone
  const ImageLock lock(table().mutex);
  const auto found = table().images.find(handle);
  if (found == table().images.end()) return;
  image = std::move(found->second);
  table().images.erase(found);
}

EglImagePtr find_egl_image(const void* handle) {
  const ImageLock lock(table().mutex);
  const auto found = table().images.find(handle);
  return found == table().images.end() ? nullptr : found->second;
}

void refresh(TextureObject& texture) {
  if (!texture.has_siblings) return;
  std::shared_ptr<pipeline::Image> image;
  for (size_t i = 0; i < texture.image->levels.size(); ++i) {
    const EglImagePtr& sibling = texture.level[i].sibling;
    if (!sibling) continue;
    const ImageLock lock(sibling->mutex);
    if (sibling->memory == texture.image->levels[i].texels.memory()) continue;
    if (!image) {
      image = std::make_shared<pipeline::Image>();
      for (const pipeline::ImageLevel& from : texture.image->levels) {
        image->levels.push_back(same_texels(from));
      }
    }
    pipeline::Texels& texels = image->levels[i].texels;
    texels = pipeline::Texels(sibling->memory, texels.size());
  }
  if (!image) return;
  texture.image = std::move(image);
  ++texture.version;
}

void refresh(RenderbufferObject& renderbuffer) {
  if (!renderbuffer.sibling || !renderbuffer.colour) return;
  const ImageLock lock(renderbuffer.sibling->mutex);
  if (renderbuffer.sibling->memory == renderbuffer.colour->pixels) return;
  auto colour = std::make_shared<pipeline::ColourBuffer>(*renderbuffer.colour);
  colour->pixels = renderbuffer.sibling->memory;
  renderbuffer.colour = std::move(colour);
}

void note_uses(Context& c, TextureObject& texture) {
  texture.uses.note(c.clock);
  if (!texture.has_siblings) return;
  for (const TextureLevel& level : texture.level) {
    if (!level.sibling) continue;
    note_native_image(c, level.sibling);
    const ImageLock lock(level.sibling->mutex);
    level.sibling->uses.note(c.clock);
  }
}

void note_uses(Context& c, RenderbufferObject& renderbuffer) {
  if (!renderbuffer.sibling) return;
  note_native_image(c, renderbuffer.sibling);
  const ImageLock lock(renderbuffer.sibling->mutex);
  renderbuffer.sibling->uses.note(c.clock);
}

bool is_pending(const TextureObject& texture) {
  if (texture.uses.pending()) return true;
  if (!texture.has_siblings) return false;
  return std::any_of(texture.level.begin(), texture.level.end(), [](const TextureLevel& level) {
    if (!level.sibling) return false;
    const ImageLock lock(level.sibling->mutex);
    return level.sibling->uses.pending();
  });
}

bool may_write_in_place(Context& c, const TextureObject& texture, size_t bytes) {
  if (texture.has_siblings) {
    for (const TextureLevel& level : texture.level) note_native_image(c, level.sibling);
  }
  if (!may_write_in_place(c, texture.uses, bytes)) return false;
  if (!texture.has_siblings) return true;
  for (const TextureLevel& level : texture.level) {
    if (!level.sibling) continue;
    FrameUses uses;
    {
      const ImageLock lock(level.sibling->mutex);
      uses = level.sibling->uses;
    }
    if (!may_write_in_place(c, uses, bytes)) return false;
  }
  return true;
}

void replace_texels(TextureObject& texture, size_t level, pipeline::Texels texels) {
  replace_memory(texture.level[level].sibling, texels);
  texture.image->levels[level].texels = std::move(texels);
}

void replace_image(TextureObject& texture, std::shared_ptr<pipeline::Image> image) {
  for (size_t i = 0; i < image->levels.size(); ++i) {
    replace_memory(texture.level[i].sibling, image->levels[i].texels);
  }
  texture.image = std::move(image);
  texture.uses.clear();
  ++texture.version;
}

std::shared_ptr<pipeline::Image> copy_image(const TextureObject& texture, size_t first,
                                            size_t end) {
  auto image = std::make_shared<pipeline::Image>();
  for (size_t i = 0; i < texture.image->levels.size(); ++i) {
    const pipeline::ImageLevel& from = texture.image->levels[i];
    const bool skip = i >= first && i < end;
    if (skip) {
      image->levels.push_back({from.width, from.height, {}});
    } else {
      image->levels.push_back(texture.level[i].sibling ? same_texels(from) : from);
    }
  }
  return image;
}

void orphan(TextureObject& texture) {
  if (!texture.has_siblings) return;
  refresh(texture);
  auto image = std::make_shared<pipeline::Image>(*texture.image);
  for (TextureLevel& level : texture.level) level.sibling = nullptr;
  texture.has_siblings = false;
  replace_image(texture, std::move(image));
}

namespace {

constexpr Invalid kNoImage{GL_INVALID_VALUE,
                           "{1} is no image of eglCreateImage (OES_EGL_image, 3.8.2)"};

}  // namespace

namespace exec {

void egl_image_target_texture(Context& c, GLenum target, const void* handle) {
  const EglImagePtr image = find_egl_image(handle);
  if (!image) return c.set_error(kNoImage);
  load_native_image(*image);
  TextureObject& texture = *bound_texture(c, target);
  finish_drawing_to(c, texture);
  auto levels = std::make_shared<pipeline::Image>();
  levels->levels.resize(1);
  {
    const ImageLock lock(image->mutex);
    const size_t texels = static_cast<size_t>(image->width) * static_cast<size_t>(image->height);
    levels->levels[0] = {image->width, image->height, {image->memory, texels}};
  }
  texture.image = std::move(levels);
  texture.uses.clear();
  texture.surface = nullptr;
  texture.level.fill({});
  texture.level[0] = {image->width, image->height, image->internal, image->format, image};
  texture.has_siblings = true;
  ++texture.version;
}

void egl_image_target_renderbuffer(Context& c, GLenum, const void* handle) {
  const EglImagePtr image = find_egl_image(handle);
  if (!image) return c.set_error(kNoImage);
  load_native_image(*image);
  std::shared_ptr<pipeline::ColourBuffer> colour;
  if (!image->depth_stencil) {
    const ImageLock lock(image->mutex);
    colour = std::make_shared<pipeline::ColourBuffer>();
    colour->width = image->width;
    colour->height = image->height;
    colour->pixels = image->memory;
    colour->has_alpha = image->format == GL_RGBA;
    colour->srgb = is_srgb(image->internal);
    colour->format = renderbuffer_format(image->renderbuffer_internal).format;
  }
  RenderbufferObject& r = *c.renderbuffer;
  r.width = image->width;
  r.height = image->height;
  r.samples = 0;
  r.internal = image->renderbuffer_internal;
  r.colour = std::move(colour);
  r.depth_stencil = image->depth_stencil;
  r.sibling = image;
}

}  // namespace exec

namespace validate {

Invalid egl_image_target_texture(const Context& c, GLenum target, const void* handle) {
  if (target != GL_TEXTURE_2D && target != GL_TEXTURE_EXTERNAL_OES) {
    return {GL_INVALID_ENUM,
            "{0} is neither TEXTURE_2D nor TEXTURE_EXTERNAL_OES (OES_EGL_image, 3.8.2)"};
  }
  const EglImagePtr image = find_egl_image(handle);
  if (!image) return kNoImage;
  if (image->format == 0) {
    return {GL_INVALID_OPERATION,
            "{1} is of depth or stencil, which is no texture (OES_EGL_image, 3.8.2)"};
  }
  return mutable_texture(*bound_texture(c, target));
}

Invalid egl_image_target_renderbuffer(const Context& c, GLenum target, const void* handle) {
  if (target != GL_RENDERBUFFER_OES) {
    return {GL_INVALID_ENUM, "{0} is not RENDERBUFFER_OES (OES_EGL_image, 4.4.2.1)"};
  }
  const EglImagePtr image = find_egl_image(handle);
  if (!image) return kNoImage;
  if (!c.renderbuffer) {
    return {GL_INVALID_OPERATION, "no renderbuffer is bound (OES_EGL_image, 4.4.2.1)"};
  }
  if (image->renderbuffer_internal == 0) {
    return {GL_INVALID_OPERATION,
            "{1} is of a format that cannot be drawn to (OES_EGL_image, 4.4.2.1)"};
  }
  return {};
}

}  // namespace validate

}  // namespace clearpipe::api
