// The order of the vertex stages, compiled once per SIMD target (2.8 to 2.12).
//
// fetch -> transform or skin -> clip tests -> viewport -> normals, texture coordinates -> colour ->
// points, fog -> records, a batch at a time.
// SPDX-License-Identifier: MIT
#include "pipeline/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/vertex/vertex_stage.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/vertex/fetch-inl.h"
#include "pipeline/vertex/lighting-inl.h"
#include "pipeline/vertex/math-inl.h"
#include "pipeline/vertex/palette-inl.h"
#include "pipeline/vertex/point-inl.h"
#include "pipeline/vertex/project-inl.h"
#include "pipeline/vertex/record-inl.h"
#include "pipeline/vertex/texcoord-inl.h"
#include "pipeline/vertex/texgen-inl.h"
#include "pipeline/vertex/transform-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::vertex::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// What holds for all batches of a job: constant attributes and outputs nobody computes. Of a job
// smaller than a batch, the lanes that are in use, in whole vectors.
void prepare_batch(const VertexJob& job, const VertexPlan& plan, VertexBatch& batch) {
  const size_t whole = hn::Lanes(hn::ScalableTag<float>());
  const size_t count = std::min(kVertexBatch, (job.count + whole - 1) / whole * whole);
  for (int a = 0; a < kAttributeCount; ++a) {
    if ((plan.attributes >> a & 1) != 0) {
      fill_constant_lanes(job.draw->attributes[a], batch.attribute[a], count);
    }
  }
  std::fill_n(batch.point_size, count, 1.0f);
  std::fill_n(batch.point_alpha, count, 1.0f);
  std::fill_n(batch.fog, count, 0.0f);
  if (plan.points && (plan.attributes >> static_cast<int>(Attribute::kPointSize) & 1) == 0) {
    std::fill_n(batch.attribute[static_cast<int>(Attribute::kPointSize)][0], count,
                job.state->point_size);
  }
  if (job.layout.clip_distance_offset != 0) {
    for (Lane& lane : batch.clip_distance) {
      std::fill_n(lane, count, 0.0f);
    }
  }
}

// The stages that take matrices, of `count` vertices from `first` on.
void transform_run(const VertexState& state, const VertexPlan& plan, size_t first, size_t count,
                   VertexBatch& batch) {
  const Lane* position = batch.attribute[static_cast<int>(Attribute::kPosition)];
  transform_position(state.model_view_projection, position, count, batch.clip, first);
  if (plan.eye_position) {
    transform_position(state.model_view, position, count, batch.eye, first);
  } else if (plan.eye_z) {
    transform_row(state.model_view, 2, position, count, batch.eye[2], first);
  }
  if (plan.normal) {
    const Lane* normal = batch.attribute[static_cast<int>(Attribute::kNormal)];
    transform_normal(state, normal, count, batch.normal, first);
  }
}

// Runs of vertices with the same matrices, from batch to batch.
class Runs {
 public:
  explicit Runs(const VertexRun* runs) : run_(runs), left_(runs->count) {}

  // Calls each(matrices, first, count) for the runs of the next `count` vertices.
  template <typename Each>
  void next(size_t count, const Each& each) {
    for (size_t first = 0; first < count;) {
      const size_t part = std::min<size_t>(left_, count - first);
      each(*run_->matrices, first, part);
      first += part;
      left_ -= static_cast<uint32_t>(part);
      // There is no run behind the last one, which ends with the job.
      if (left_ == 0 && first < count) left_ = (++run_)->count;
    }
    ended_ = left_ == 0;
  }
  // Before a batch that is not the first.
  void advance() {
    if (ended_) left_ = (++run_)->count;
  }

 private:
  const VertexRun* run_;
  uint32_t left_;
  bool ended_ = false;
};

void run_batch(const VertexJob& job, const VertexPlan& plan, size_t first, size_t count,
               VertexBatch& batch, Runs* runs) {
  const VertexState& state = *job.state;
  const auto attribute = [&batch](Attribute a) { return batch.attribute[static_cast<int>(a)]; };

  for (int a = 0; a < kAttributeCount; ++a) {
    const AttributeSource& source = job.draw->attributes[a];
    if ((plan.attributes >> a & 1) != 0 && reads_array(source)) {
      fetch_array(source, job.elements + first, count, batch.attribute[a]);
    }
  }

  const Lane* position = attribute(Attribute::kPosition);
  const PaletteInputs skin = palette_inputs(*job.draw, batch);
  if (state.palette != nullptr) {
    skin_position(*state.palette, skin, position, count, batch.eye);
    transform_position(state.projection, batch.eye, count, batch.clip);
  } else if (runs != nullptr) {
    runs->next(count, [&](const VertexState& matrices, size_t start, size_t part) {
      transform_run(matrices, plan, start, part, batch);
    });
  } else {
    transform_run(state, plan, 0, count, batch);
  }
  test_clip_volume(batch.clip, job.guard, count, batch.outcode);
  project_to_window(batch.clip, job.viewport, count, batch.window);

  if (state.clip_planes != 0) {
    test_user_planes(state, batch.eye, count, batch.clip_distance, batch.outcode);
  }

  if (plan.normal && state.palette != nullptr) {
    skin_normal(state, skin, attribute(Attribute::kNormal), count, batch.normal);
  }
  if (state.reflection_map != 0) {
    reflection_vector(batch.eye, batch.normal, count, batch.reflection);
  }
  transform_texture_coordinates(state, batch, count);

  const Lane* current = attribute(Attribute::kColour);
  if (state.lighting) {
    light_vertices(state, batch.eye, batch.normal, current, count, batch.colour, batch.back_colour);
  } else {
    clamp_colour(current, count, batch.colour);
  }

  if (state.fog) {
    fog_coordinate(batch.eye[2], count, batch.fog);
  }
  if (plan.points) {
    derive_point_size(state, attribute(Attribute::kPointSize)[0], batch.eye, count,
                      batch.point_size, batch.point_alpha);
  }
  store_records(state, job.layout, batch, count, job.records + first * job.layout.stride);
}

void run(const VertexJob& job, const VertexPlan& plan) {
  VertexBatch batch;
  prepare_batch(job, plan, batch);
  if (job.runs == nullptr) {
    for (size_t first = 0; first < job.count; first += kVertexBatch) {
      run_batch(job, plan, first, std::min(kVertexBatch, job.count - first), batch, nullptr);
    }
    return;
  }
  // A run may begin in any lane, and ends with a whole vector, for which there is room.
  const size_t part = kVertexBatch - hn::Lanes(hn::ScalableTag<float>());
  Runs runs(job.runs);
  for (size_t first = 0; first < job.count; first += part) {
    if (first != 0) runs.advance();
    run_batch(job, plan, first, std::min(part, job.count - first), batch, &runs);
  }
}

const VertexKernels* kernels() {
  static constexpr VertexKernels kKernels = {&run};
  return &kKernels;
}

}  // namespace clearpipe::pipeline::vertex::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clearpipe::pipeline {

namespace vertex {
HWY_EXPORT(kernels);
}  // namespace vertex

const VertexKernels& current_vertex_kernels() {
  using namespace vertex;
  return *HWY_DYNAMIC_DISPATCH(kernels)();
}

void run_vertex_stages(const VertexJob& job) {
  static const VertexKernels& resolved = []() -> const VertexKernels& {
    select_simd_target();
    return current_vertex_kernels();
  }();
  resolved.run(job, make_vertex_plan(*job.draw, *job.state));
}

}  // namespace clearpipe::pipeline
#endif  // HWY_ONCE
