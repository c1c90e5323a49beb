// The end of a fragment on a surface whose colours are sRGB-encoded (EXT_sRGB, 4.1.6).
// SPDX-License-Identifier: MIT
#pragma once

#include "pipeline/fragment/batch.h"
#include "pipeline/state.h"

namespace clearpipe::pipeline {

// The final colour as packed RGBA8 with an encoded colour, of a whole batch.
void pack_srgb(FragmentBatch& batch);

// The same after blending with what is stored, decoded (4.1.7).
void blend_srgb(const BlendState& state, FragmentBatch& batch);

}  // namespace clearpipe::pipeline
