// What the calls that draw have in common.
// SPDX-License-Identifier: MIT
#pragma once

#include "api/context_state.h"

namespace clearpipe::api {

// Before a draw is recorded: targets, textures and derived state are those of now.
void update_draw_state(Context& context);

// With a draw: the frame reads the textures that are sampled, and draws to the one attached.
void note_texture_uses(Context& context);

}  // namespace clearpipe::api
