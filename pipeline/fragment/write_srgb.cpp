// See write_srgb.h. Blending is done one component at a time, in floating point: surfaces with an
// encoded colour are rare.
// SPDX-License-Identifier: MIT
#include "pipeline/fragment/write_srgb.h"

#include <algorithm>

#include "pipeline/srgb.h"

namespace clearpipe::pipeline {

namespace {

constexpr float kOne = kColourOne;

// What is stored of a colour in fixed point.
uint32_t packed(int r, int g, int b, int a) {
  const int alpha = (std::clamp<int>(a, 0, kColourOne) * 255 + kColourOne / 2) / kColourOne;
  return srgb_of(r) | srgb_of(g) << 8 | srgb_of(b) << 16 | static_cast<uint32_t>(alpha) << 24;
}

// A fragment's colour or a stored one, in [0, 1].
struct Colour {
  float component[4];
};

// Table 4.1, of one component.
float factor(BlendFactor f, size_t c, const Colour& source, const Colour& destination) {
  const float s = source.component[c], sa = source.component[3];
  const float d = destination.component[c], da = destination.component[3];
  switch (f) {
    case BlendFactor::kZero:
      return 0;
    case BlendFactor::kOne:
      return 1;
    case BlendFactor::kSrcColour:
      return s;
    case BlendFactor::kOneMinusSrcColour:
      return 1 - s;
    case BlendFactor::kDstColour:
      return d;
    case BlendFactor::kOneMinusDstColour:
      return 1 - d;
    case BlendFactor::kSrcAlpha:
      return sa;
    case BlendFactor::kOneMinusSrcAlpha:
      return 1 - sa;
    case BlendFactor::kDstAlpha:
      return da;
    case BlendFactor::kOneMinusDstAlpha:
      return 1 - da;
    case BlendFactor::kSrcAlphaSaturate:
      return c == 3 ? 1.0f : std::min(sa, 1 - da);
  }
  return 0;
}

float blended(BlendEquation equation, float s, float s_factor, float d, float d_factor) {
  switch (equation) {
    case BlendEquation::kAdd:
      return s * s_factor + d * d_factor;
    case BlendEquation::kSubtract:
      return s * s_factor - d * d_factor;
    case BlendEquation::kReverseSubtract:
      return d * d_factor - s * s_factor;
    case BlendEquation::kMin:
      return std::min(s, d);
    case BlendEquation::kMax:
      return std::max(s, d);
  }
  return 0;
}

int to_fixed(float v) { return static_cast<int>(std::clamp(v, 0.0f, 1.0f) * kOne + 0.5f); }

Colour source_of(const FragmentBatch& batch, int i) {
  Colour colour;
  for (int c = 0; c < 4; ++c) {
    const int v = std::clamp<int>(batch.previous[c][i], 0, kColourOne);
    colour.component[c] = static_cast<float>(v) / kOne;
  }
  return colour;
}

Colour linear_colour(uint32_t stored) {
  Colour colour;
  for (int c = 0; c < 3; ++c) {
    colour.component[c] = static_cast<float>(srgb_to_linear()[stored >> 8 * c & 255]) / kOne;
  }
  colour.component[3] = static_cast<float>(stored >> 24) / 255.0f;
  return colour;
}

}  // namespace

void pack_srgb(FragmentBatch& batch) {
  const auto& c = batch.previous;
  for (int i = 0; i < batch.count; ++i) {
    batch.colour[i] = packed(c[0][i], c[1][i], c[2][i], c[3][i]);
  }
}

void blend_srgb(const BlendState& state, FragmentBatch& batch) {
  for (int i = 0; i < batch.count; ++i) {
    const Colour source = source_of(batch, i), destination = linear_colour(batch.stored_colour[i]);
    int result[4];
    for (size_t c = 0; c < 4; ++c) {
      const bool alpha = c == 3;
      const float s_factor =
          factor(alpha ? state.src_alpha : state.src_rgb, c, source, destination);
      const float d_factor =
          factor(alpha ? state.dst_alpha : state.dst_rgb, c, source, destination);
      result[c] = to_fixed(blended(alpha ? state.alpha : state.rgb, source.component[c], s_factor,
                                   destination.component[c], d_factor));
    }
    batch.colour[i] = packed(result[0], result[1], result[2], result[3]);
  }
}

}  // namespace clearpipe::pipeline
