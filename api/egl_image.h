// EGLImages from within api/: memory that textures and renderbuffers of any context share
// (EGL_KHR_image_base, OES_EGL_image). All that share it, the source and the targets, are siblings.
//
// A sibling holds the shared memory itself, as a level of a texture or the colour of a
// renderbuffer, so that sampling and drawing know nothing of images. Memory that an unfinished
// frame reads is never written in place (frame_uses.h); the copy that replaces it is noted here,
// and the other siblings take it over before they are next drawn with, drawn to, read or changed.
//
// Share groups lock each other out no more than this needs: an image has a lock of its own, to be
// taken after that of a share group.
// SPDX-License-Identifier: MIT
#pragma once

#include "api/context.h"
#include "api/context_state.h"

namespace clearpipe::api {

struct EglImage {
  int width = 0, height = 0;
  GLenum internal = 0, format = 0;  // of a texture level; 0 for depth and stencil
  // A renderbuffer's depth and stencil. It is never replaced.
  std::shared_ptr<pipeline::DepthStencilBuffer> depth_stencil;
  GLenum renderbuffer_internal = 0;  // 0: nothing to draw to can be made of it

  std::mutex mutex;  // guards the rest
  std::shared_ptr<uint32_t[]> memory;
  std::shared_ptr<NativeImage> native;  // whose pixels these are copies of; never replaced
  std::vector<uint32_t> known;          // what it had when last looked at (native_image.h)
  FrameUses uses;                       // of memory, by frames that draw with or to any sibling
};

// The image of a handle that eglCreateImage returned, until eglDestroyImage; or null.
EglImagePtr find_egl_image(const void* handle);

// Takes over what other siblings have replaced.
void refresh(TextureObject& texture);
void refresh(RenderbufferObject& renderbuffer);

// The frame being recorded reads or draws to the object.
void note_uses(Context& context, TextureObject& texture);
void note_uses(Context& context, RenderbufferObject& renderbuffer);

// Whether texels of the texture may be written in place: see context_state.h.
bool may_write_in_place(Context& context, const TextureObject& texture, size_t bytes);

// What pending frames use of the texture, through it or through siblings.
bool is_pending(const TextureObject& texture);

// Replaces the texels of one level or of all by others of the same sizes, which no frame reads;
// siblings will see them.
void replace_texels(TextureObject& texture, size_t level, pipeline::Texels texels);
void replace_image(TextureObject& texture, std::shared_ptr<pipeline::Image> image);

// A copy of the texture's images, except for the texels of the levels from `first` to before `end`.
// Levels that are siblings stay so.
std::shared_ptr<pipeline::Image> copy_image(const TextureObject& texture, size_t first, size_t end);

// The texture's images by themselves, none of them a sibling: they are respecified.
void orphan(TextureObject& texture);

}  // namespace clearpipe::api
