// Clipping: see clip.h.
// SPDX-License-Identifier: MIT
#include "pipeline/clip/clip.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "pipeline/raster/edge.h"

namespace clearpipe::pipeline {

namespace {

// A clip plane as a signed distance, linear in clip space: inside is >= 0.
struct ClipPlane {
  int axis = 0;
  float sign = 1;  // +1: coordinate >= limit * w; -1: coordinate <= limit * w
  float limit = -1;
  int record_offset = -1;  // >= 0: the distance stands in the record (user planes)

  float distance(const float* record) const {
    if (record_offset >= 0) {
      return record[record_offset];
    }
    const float* clip = record + vertex_record::kClip;
    return sign * (clip[axis] - limit * clip[3]);
  }
};

// In the reference's order, so that the corners come out as its corners do.
int collect_planes(const ClipState& state, uint32_t planes, ClipPlane* out) {
  int count = 0;
  const auto add = [&](uint32_t outcode, int axis, float sign, float limit) {
    if ((planes & outcode) != 0) out[count++] = {axis, sign, limit, -1};
  };
  add(kOutcodeRight, 0, -1, 1);
  add(kOutcodeLeft, 0, 1, -1);
  add(kOutcodeTop, 1, -1, 1);
  add(kOutcodeBottom, 1, 1, -1);
  add(kOutcodeNear, 2, 1, -1);
  add(kOutcodeFar, 2, -1, 1);
  for (int i = 0; i < kMaxClipPlanes; ++i) {
    if ((planes & (kOutcodeUser << i)) != 0 && state.layout.clip_distance_offset != 0) {
      out[count++] = {0, 1, 0, state.layout.clip_distance_offset + i};
    }
  }
  add(kOutcodeGuard, 0, 1, state.guard.x_min);
  add(kOutcodeGuard, 0, -1, state.guard.x_max);
  add(kOutcodeGuard, 1, 1, state.guard.y_min);
  add(kOutcodeGuard, 1, -1, state.guard.y_max);
  return count;
}

float* new_vertex(const ClipState& state, Arena& arena) {
  return static_cast<float*>(arena.allocate(state.layout.stride * sizeof(float)));
}

// The point where the edge between `p` and `q` meets the plane, found from the vertex nearer to it,
// from the inner one when both are as near. Two triangles that share an edge get the same point,
// because the choice does not depend on the triangle.
const float* intersect(const ClipState& state, const float* p, const float* q, float p_distance,
                       float q_distance, Arena& arena) {
  const float p_away = std::fabs(p_distance), q_away = std::fabs(q_distance);
  if (q_away < p_away || (q_away == p_away && q_distance >= 0)) {
    std::swap(p, q);
    std::swap(p_distance, q_distance);
  }
  const float t = -p_distance / (q_distance - p_distance);
  float* __restrict vertex = new_vertex(state, arena);
  const int stride = state.layout.stride;
  for (int first = 0; first < stride; first += 4) {
    for (int i = first; i < first + 4; ++i) vertex[i] = p[i] + t * (q[i] - p[i]);
  }
  std::memset(vertex + vertex_record::kOutcode, 0, sizeof(float));
  project_vertex(vertex, state.viewport);
  return vertex;
}

// One pass of the method. The polygon is walked from its first corner, which stays first if it is
// inside.
int clip_against(const ClipState& state, const ClipPlane& plane, const float* const* in, int count,
                 Arena& arena, const float** out) {
  int kept = 0;
  float distance = plane.distance(in[0]);
  for (int i = 0; i < count; ++i) {
    const float* current = in[i];
    const float* next = in[i + 1 == count ? 0 : i + 1];
    const float next_distance = plane.distance(next);
    if (!std::isfinite(distance) || !std::isfinite(next_distance)) {
      return 0;
    }
    if (distance >= 0) {
      out[kept++] = current;
    }
    if ((distance >= 0) != (next_distance >= 0)) {
      out[kept++] = intersect(state, current, next, distance, next_distance, arena);
    }
    distance = next_distance;
  }
  return kept;
}

// Whether the window coordinates can be snapped: not behind the eye, within the guard band.
bool projects_well(const float* record) {
  const float* window = record + vertex_record::kWindow;
  return window[0] >= kGuardMin && window[0] <= kGuardMax && window[1] >= kGuardMin &&
         window[1] <= kGuardMax && std::isfinite(window[2]) && std::isfinite(window[3]);
}

void copy_colours(const ClipState& state, const float* from, float* to) {
  std::copy_n(from + vertex_record::kColour, 4, to + vertex_record::kColour);
  if (const int back = state.layout.back_colour_offset; back != 0) {
    std::copy_n(from + back, 4, to + back);
  }
}

}  // namespace

GuardBand make_guard_band(const Viewport& viewport) {
  // A little inside the range, so that rounding of the projected vertex stays within it.
  constexpr float kMargin = 16;
  const auto limits = [](float centre, float scale, float& low, float& high) {
    const float magnitude = std::max(std::fabs(scale), 1e-3f);
    const float below = std::max(centre - (kGuardMin + kMargin), 0.0f) / magnitude;
    const float above = std::max((kGuardMax - kMargin) - centre, 0.0f) / magnitude;
    low = scale >= 0 ? -below : -above;
    high = scale >= 0 ? above : below;
  };
  GuardBand guard;
  limits(viewport.centre_x, viewport.scale_x, guard.x_min, guard.x_max);
  limits(viewport.centre_y, viewport.scale_y, guard.y_min, guard.y_max);
  return guard;
}

int clip_triangle(const ClipState& state, const float* const v[3], uint32_t planes, Arena& arena,
                  const float** out) {
  ClipPlane list[kMaxPlanes];
  const int plane_count = collect_planes(state, planes, list);
  const float* buffers[2][kMaxClippedCorners + 1];
  std::copy_n(v, 3, buffers[0]);
  int count = 3;
  int current = 0;
  for (int i = 0; i < plane_count && count >= 3; ++i) {
    count = clip_against(state, list[i], buffers[current], count, arena, buffers[1 - current]);
    current = 1 - current;
  }
  if (count < 3) {
    return 0;
  }
  for (int i = 0; i < count; ++i) {
    const float* corner = buffers[current][i];
    if (!projects_well(corner)) {
      return 0;
    }
    if (state.flat_shade && corner != v[2]) {
      float* copy = new_vertex(state, arena);
      std::copy_n(corner, state.layout.stride, copy);
      copy_colours(state, v[2], copy);
      corner = copy;
    }
    out[i] = corner;
  }
  return count;
}

bool clip_line(const ClipState& state, const float* v[2], uint32_t planes, Arena& arena) {
  ClipPlane list[kMaxPlanes];
  const int plane_count = collect_planes(state, planes, list);
  const float* provoking = v[1];
  for (int i = 0; i < plane_count; ++i) {
    const float d0 = list[i].distance(v[0]);
    const float d1 = list[i].distance(v[1]);
    if (!std::isfinite(d0) || !std::isfinite(d1) || (d0 < 0 && d1 < 0)) {
      return false;
    }
    if (d0 < 0) {
      v[0] = intersect(state, v[0], v[1], d0, d1, arena);
    } else if (d1 < 0) {
      v[1] = intersect(state, v[0], v[1], d0, d1, arena);
    }
  }
  if (!projects_well(v[0]) || !projects_well(v[1])) {
    return false;
  }
  if (state.flat_shade && v[1] != provoking) {
    float* copy = new_vertex(state, arena);
    std::copy_n(v[1], state.layout.stride, copy);
    copy_colours(state, provoking, copy);
    v[1] = copy;
  }
  return true;
}

}  // namespace clearpipe::pipeline
