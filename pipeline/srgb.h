// The sRGB encoding (EXT_sRGB): components of textures and surfaces that are encoded with it, from
// and to the linear colours of the fragment stages.
//
//   linear = s / 12.92                       s <= 0.04045
//            ((s + 0.055) / 1.055)^2.4       above
//
// The inverse encodes. Both are tables, made with operations that round alike everywhere. Alpha is
// never encoded. What 8 bits decode to encodes to the same 8 bits.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "pipeline/raster/samples.h"

namespace clearpipe::pipeline {

// The linear component of each encoded one, in units of 1 / kColourOne.
const int32_t* srgb_to_linear();

// The nearest encoded component of a linear one in those units; others than of [0, 1] are clamped.
uint32_t srgb_of(int linear);

// The same of a number.
uint32_t linear_to_srgb(float linear);

// The mean of a pixel's samples, taken of linear colours.
uint32_t mean_srgb(const uint32_t (&samples)[kSampleCount]);

}  // namespace clearpipe::pipeline
