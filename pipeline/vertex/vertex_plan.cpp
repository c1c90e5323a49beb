// Which stages a vertex job needs (2.10 to 2.12, 3.3, 3.8).
// SPDX-License-Identifier: MIT
#include "pipeline/vertex/vertex_batch.h"

namespace clearpipe::pipeline {

namespace {

constexpr uint32_t bit(Attribute attribute) { return 1u << static_cast<uint32_t>(attribute); }

bool any_positional_light(const VertexState& state) {
  for (const Light& light : state.lights) {
    if (light.enabled && (light.positional || light.spot)) {
      return true;
    }
  }
  return false;
}

bool needs_normal(const VertexState& state) {
  return state.lighting || (state.reflection_map | state.normal_map) != 0;
}

}  // namespace

uint32_t vertex_attributes(const VertexState& state) {
  uint32_t attributes = bit(Attribute::kPosition);
  if (state.palette != nullptr) {
    attributes |= bit(Attribute::kMatrixIndex) | bit(Attribute::kWeight);
  }
  if (needs_normal(state)) {
    attributes |= bit(Attribute::kNormal);
  }
  if (!state.lighting || state.colour_material) {
    attributes |= bit(Attribute::kColour);
  }
  return attributes | static_cast<uint32_t>(state.texture_units)
                          << static_cast<uint32_t>(Attribute::kTexCoord0);
}

VertexPlan make_vertex_plan(const DrawCommand& draw, const VertexState& state) {
  VertexPlan plan;
  plan.points = draw.primitive == Primitive::kPoints;
  plan.normal = needs_normal(state);
  plan.eye_position = state.palette != nullptr || state.clip_planes != 0 ||
                      state.reflection_map != 0 || (plan.points && state.point_attenuated) ||
                      (state.lighting && any_positional_light(state));
  plan.eye_z = state.fog && !plan.eye_position;

  plan.attributes = vertex_attributes(state);
  const auto& size = draw.attributes[static_cast<size_t>(Attribute::kPointSize)];
  if (plan.points && size.is_array) {
    plan.attributes |= bit(Attribute::kPointSize);
  }
  return plan;
}

}  // namespace clearpipe::pipeline
