// What draws take of the current state: see draw_state.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/draw_state.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>

#include "pipeline/exec/dots.h"
#include "pipeline/exec/strokes.h"

namespace clearpipe::pipeline {

namespace {

Rect intersect(const Rect& a, const Rect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

// Whether vertices of both states go through the same stages, and take all but their matrices from
// the same values. When in doubt, no: the bytes between members may differ.
bool differ_in_matrices_alone(const VertexState& a, const VertexState& b) {
  constexpr size_t kFlags = offsetof(VertexState, rescale_normal);
  constexpr size_t kProjection = offsetof(VertexState, projection);
  constexpr size_t kLighting = offsetof(VertexState, scene_ambient);
  constexpr size_t kLights = offsetof(VertexState, lights);
  const auto same = [&](size_t begin, size_t end) {
    return std::memcmp(reinterpret_cast<const std::byte*>(&a) + begin,
                       reinterpret_cast<const std::byte*>(&b) + begin, end - begin) == 0;
  };
  if (!same(kFlags, kProjection) || a.palette != nullptr) return false;
  if (a.texture_matrix != 0 || a.clip_planes != 0) return false;
  if (!a.lighting) return true;
  if (!same(kLighting, kLights)) return false;
  for (size_t i = 0; i < a.lights.size(); ++i) {
    const size_t light = kLights + i * sizeof(Light);
    if (a.lights[i].enabled != b.lights[i].enabled) return false;
    if (a.lights[i].enabled && !same(light, light + sizeof(Light))) return false;
  }
  return true;
}

}  // namespace

void CurrentState::forget_vertices() {
  recorded_ = nullptr;
  new_group_ = true;
  forget_draws();
}

void CurrentState::set_target(const Target& target) {
  target_ = target;
  program_ = nullptr;
  forget_vertices();
}

void CurrentState::set_vertex_state(const VertexState& state) {
  if (!differ_in_matrices_alone(state, vertex_)) forget_vertices();
  copy_vertex_state(state, vertex_);
  recorded_ = nullptr;
}

void CurrentState::set_raster_state(const RasterState& state) {
  const bool same_viewport = raster_.viewport == state.viewport;
  raster_ = state;
  same_viewport ? forget_draws() : forget_vertices();
}

void CurrentState::set_fragment_state(const FragmentState& state) {
  copy_fragment_state(state, fragment_);
  program_ = nullptr;
  known_.fill(false);
}

void CurrentState::reset() {
  programs_.reset();
  program_ = nullptr;
  forget_vertices();
}

ProgramHolder& CurrentState::program() {
  if (program_ == nullptr) {
    FragmentTarget to;
    if (target_.depth_stencil) {
      to.has_depth = target_.depth_stencil->has_depth;
      to.has_stencil = target_.depth_stencil->has_stencil;
      to.depth_bits = target_.depth_stencil->depth_bits;
    }
    to.multisampled = target_.samples() > 1;
    to.srgb = target_.colour && target_.colour->srgb;
    if (target_.colour) to.format = target_.colour->format;
    const uint8_t mask = fragment_.colour_mask;
    if (target_.colour && !target_.colour->has_alpha) {
      fragment_.colour_mask = mask & 0x7;
      // With alpha, which is 255 already, programs replace whole pixels. Textured ones, which are
      // never solid, gain nothing by it.
      const bool textured = std::any_of(fragment_.unit.begin(), fragment_.unit.end(),
                                        [](const TextureUnit& unit) { return unit.enabled; });
      if (fragment_.colour_mask == 0x7 && to.format == ColourFormat::kRgba8 && !to.srgb &&
          !textured) {
        fragment_.colour_mask = 0xf;
        to.format = ColourFormat::kRgb8;
      }
    }
    if (!target_.colour) fragment_.colour_mask = 0;
    program_ = &programs_.find(fragment_, to);
    fragment_.colour_mask = mask;
  }
  return *program_;
}

// 3.2.1: multisample rasterization; 3.3, 3.4: antialiasing of points and lines, which sprites
// ignore.
FragmentCoverage CurrentState::coverage_of(Primitive primitive) const {
  const bool point = kind_of(primitive) == 0, line = kind_of(primitive) == 1;
  if (raster_.multisample && target_.samples() > 1) {
    return point ? FragmentCoverage::kMultisamplePoint : FragmentCoverage::kMultisample;
  }
  const bool smooth =
      (point && raster_.point_smooth && !raster_.point_sprite) || (line && raster_.line_smooth);
  return smooth ? FragmentCoverage::kSmooth : FragmentCoverage::kCentre;
}

// Window y of window-system surfaces is computed as Mesa does, counting from the top; setup mirrors
// the snapped value (docs/architecture.md, "Mesa's coverage").
Viewport CurrentState::viewport() const {
  Viewport viewport = raster_.viewport;
  if (!target_.mirrored) {
    return viewport;
  }
  viewport.scale_y = -viewport.scale_y;
  viewport.centre_y = static_cast<float>(target_.height) - viewport.centre_y;
  return viewport;
}

void CurrentState::record_vertices(Arena& arena) {
  // Matrices may change with each draw: what nobody looks at in a plain state takes no room.
  const bool plain = vertex_.palette == nullptr && !vertex_.lighting &&
                     vertex_.texture_matrix == 0 && vertex_.clip_planes == 0;
  const size_t bytes = plain ? offsetof(VertexState, projection) : sizeof(VertexState);
  auto* state = static_cast<VertexState*>(arena.allocate(bytes));
  copy_vertex_state(vertex_, *state);
  if (const MatrixPalette* palette = state->palette) {
    state->palette = new (arena.allocate(sizeof(MatrixPalette))) MatrixPalette(*palette);
  }
  recorded_ = state;
  if (!new_group_) return;
  new_group_ = false;
  ++vertex_group_;
  attributes_ = vertex_attributes(vertex_);
  clip_.layout = make_vertex_layout(vertex_);
  const Viewport now = viewport();
  if (!(clip_.viewport == now)) {
    clip_.viewport = now;
    clip_.guard = make_guard_band(now);
  }
}

const DrawState* CurrentState::find(Primitive primitive, Arena& arena) {
  MadeDrawStates& made = program().draw_states();
  if (made.generation != generation_) made = {generation_, {}};
  const DrawState*& state = made.of_kind[kind_of(primitive)];
  if (state == nullptr) state = make(primitive, arena);
  return state;
}

const DrawState* CurrentState::make(Primitive primitive, Arena& arena) {
  const Rect bounds = intersect(raster_.scissor, {0, 0, target_.width, target_.height});
  vertices(arena);
  if (bounds.x0 >= bounds.x1 || bounds.y0 >= bounds.y1) return nullptr;
  const FragmentCoverage coverage = coverage_of(primitive);
  auto* draw = new (arena.allocate(sizeof(DrawState))) DrawState;
  draw->program = program().program(coverage);
  draw->outputs = fragment_outputs(*draw->program);
  draw->vertex_group = vertex_group_;
  draw->clip = clip_;
  draw->clip.flat_shade = raster_.flat_shade;
  SetupState& setup = draw->setup;
  setup.raster = raster_;
  setup.layout = clip_.layout;
  setup.bounds = bounds;
  setup.coverage = coverage;
  setup.point_fade_threshold = vertex_.point_fade_threshold;
  setup.inputs = fragment_inputs(*draw->program);
  setup.inputs.texture_units &= setup.layout.texture_units;
  if (target_.depth_stencil) setup.depth_bits = target_.depth_stencil->depth_bits;
  setup.mirror_height = target_.mirrored ? target_.height : 0;
  setup.two_sided = setup.layout.back_colour_offset != 0;
  draw->shades_points = primitive == Primitive::kPoints && coverage == FragmentCoverage::kCentre &&
                        shades_strips(*draw->program);
  draw->draws_strokes =
      kind_of(primitive) == kind_of(Primitive::kLines) && pipeline::draws_strokes(*draw);
  draw->may_draw_dots = primitive == Primitive::kPoints && may_draw_dots(*draw, vertex_);
  return draw;
}

}  // namespace clearpipe::pipeline
