// What the calls that draw have in common.
// SPDX-License-Identifier: MIT
#pragma once

#include "api/context_state.h"

namespace clearpipe::api {

// Before a draw is recorded: targets, textures and derived state are those of now.
void update_draw_state(Context& context);

// Bytes of a row of pixels that are read (4.3.1), and of all rows: the last one is not padded.
int64_t read_row_bytes(const Context& context, GLsizei width, GLenum format, GLenum type);
int64_t bytes_read(const Context& context, GLsizei width, GLsizei height, GLenum format,
                   GLenum type);

// With a draw: the frame reads the textures that are sampled, and draws to the one attached.
void note_texture_uses(Context& context);

}  // namespace clearpipe::api
