// The levels of textures as they change (3.7.1 to 3.7.4, 3.7.7): replaced by new ones or written in
// part, with the mipmaps that are generated from them, and never under a frame that samples them.
//
// New levels are made whole before the texture gets them, so that a call for which memory does not
// suffice changes nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "api/egl_image.h"
#include "api/framebuffer.h"

namespace clearpipe::api {

using Levels = std::vector<pipeline::ImageLevel>;

// A level with texels of zero, and of one where the base format has no alpha.
pipeline::ImageLevel make_level(int width, int height, GLenum format = GL_RGBA);

// What generated levels are derived up to: q, for a base level of that size (3.7.7).
int last_generated_level(const TextureObject& texture, const pipeline::ImageLevel& base);

// Gives the texture new levels from `first` on, as an application specifies them: it shares nothing
// any more. They are moved from, unless memory does not suffice: then nothing changes.
void install_levels(Context& context, TextureObject& texture, size_t first,
                    std::span<pipeline::ImageLevel> levels, GLenum internal, GLenum format);

// As above, with levels that are generated. A mipmap that was complete keeps its structure, and so
// what it shares (issues 4 and 5 of EGL_KHR_gl_image). Finish drawing to the texture before.
void regenerate_levels(TextureObject& texture, size_t first,
                       std::span<pipeline::ImageLevel> levels);

// Appends the levels that follow from the base level, which is there, up to a last one (3.7.7,
// automatic mipmap generation).
void add_mipmaps(Levels& levels, int last);

// Replaces one image (texture_target.h), and those that follow from it.
void replace_level(Context& context, TextureObject& texture, size_t image, pipeline::ImageLevel to,
                   GLenum internal, GLenum format);

// Whether the levels above the base follow from a change of this image.
bool generates_mipmap(const TextureObject& texture, size_t image, GLenum internal);

// Makes the texture's texels its own, to be written where they are: no frame reads them.
void make_writable(Context& context, TextureObject& texture);

// Changes texels of one image, and the levels that follow from it.
template <typename Change>
void change_level(Context& c, TextureObject& texture, size_t image, const Change& change) {
  if (generates_mipmap(texture, image, texture.level[image].internal)) {
    refresh(texture);
    finish_drawing_to(c, texture);
    Levels levels;
    levels.push_back(texture.image->levels[image]);
    change(levels[0]);
    add_mipmaps(levels, last_generated_level(texture, levels[0]));
    regenerate_levels(texture, image, levels);
    return;
  }
  make_writable(c, texture);
  change(texture.image->levels[image]);
}

}  // namespace clearpipe::api
