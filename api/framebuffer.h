// Framebuffer objects (OES_framebuffer_object): whether they are complete, and what the pipeline
// draws to when one is bound. To be used under the lock of the share group.
// SPDX-License-Identifier: MIT
#pragma once

#include "api/context_state.h"
#include "api/invalid.h"

namespace clearpipe::api {

// What CheckFramebufferStatusOES returns for the bound framebuffer.
GLenum framebuffer_status(const Context& context);

// What is wrong for a command that draws or reads pixels (4.4.4.2 of EXT_framebuffer_object).
Invalid drawn_framebuffer(const Context& context);
Invalid read_framebuffer(const Context& context);

// The images to draw to and to read from: those of the bound framebuffer object, as they are now,
// none if it is not complete; else the surfaces.
pipeline::Target draw_target(const Context& context);
pipeline::Target read_target(const Context& context);

// Whether pixels of the target are also read as they are held (OES_read_format).
bool is_rgb565(const pipeline::Target& target);

// Makes them the context's targets. What was recorded for others is executed.
void update_targets(Context& context);
void use_targets(Context& context, const pipeline::Target& draw, const pipeline::Target& read);

// With each command that draws: the frame keeps the texture or the EGLImage it draws to from being
// changed in place.
void note_drawn_image(Context& context);

// Before the texture's images are read or changed outside of a frame: executes what this context
// has recorded that draws to one of them.
void finish_drawing_to(Context& context, const TextureObject& texture);

// Forgets the samples of the texture that is attached: each is then what the texture holds
// (EXT_multisampled_render_to_texture). What was recorded must have been executed.
void discard_samples(FramebufferObject& framebuffer);

// Whether drawing with the texture would read the level that is drawn to.
bool samples_its_target(const Context& context, const TextureObject& texture);

// The attachment point of that name, or null.
Attachment* attachment_point(FramebufferObject& framebuffer, GLenum name);

// Removes an object that is deleted from the bound framebuffer object (4.4.2.2, 4.4.2.3).
void detach(Context& context, const TexturePtr& texture);
void detach(Context& context, const RenderbufferPtr& renderbuffer);

}  // namespace clearpipe::api
