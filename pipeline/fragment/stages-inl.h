// The stages of stages.def as functions of one form, so that a chain can call them one after
// another.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_STAGES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_STAGES_INL_H_
#undef CLEARPIPE_FRAGMENT_STAGES_INL_H_
#else
#define CLEARPIPE_FRAGMENT_STAGES_INL_H_
#endif

#include <hwy/highway.h>

#include "pipeline/fragment/alpha_test-inl.h"
#include "pipeline/fragment/antialias-inl.h"
#include "pipeline/fragment/chain.h"
#include "pipeline/fragment/cube-inl.h"
#include "pipeline/fragment/depth_stencil-inl.h"
#include "pipeline/fragment/fog-inl.h"
#include "pipeline/fragment/interpolate-inl.h"
#include "pipeline/fragment/multisample-inl.h"
#include "pipeline/fragment/texcoord-inl.h"
#include "pipeline/fragment/texenv-inl.h"
#include "pipeline/fragment/write-inl.h"
#include "pipeline/fragment/write_srgb.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct StageContext {
  const FragmentProgram& program;
  const PrimitivePlanes& planes;
  const Tile& tile;  // of a multisampled target, that of any sample: only its place matters
};

namespace stage {

inline void smooth_coverage(const StageContext& context, FragmentBatch& batch, int) {
  fragment::HWY_NAMESPACE::smooth_coverage(context.planes.region, batch);
}

inline void interpolate_w(const StageContext& context, FragmentBatch& batch, int) {
  if (context.planes.perspective) fragment::HWY_NAMESPACE::interpolate_w(context.planes, batch);
}

inline void test_depth_stencil(const StageContext& context, FragmentBatch& batch, int) {
  const FragmentProgram& p = context.program;
  depth_stencil_stage(context.planes.depth, p.stencil, depth_state(p), batch, batch.live);
}

inline void interpolate_colour(const StageContext& context, FragmentBatch& batch, int) {
  fragment::HWY_NAMESPACE::interpolate_colour(context.planes, batch);
}

inline void sample_texture(const StageContext& context, FragmentBatch& batch, int unit) {
  const UnitProgram& u = context.program.unit[unit];
  const Plane* planes = context.planes.texture[unit];
  if (u.sample.is_cube()) {
    cube_coordinates(context.planes, planes, u.sample, context.tile, batch);
  } else {
    texture_coordinates(planes, batch);
    if (u.sample.needs_lod) {
      level_of_detail(context.planes, planes, u.sample, context.tile, batch);
    }
  }
  u.sample_function(u.sample, batch, unit);
}

inline void texture_environment(const StageContext& context, FragmentBatch& batch, int unit) {
  const UnitProgram& u = context.program.unit[unit];
  fragment::HWY_NAMESPACE::texture_environment(u.combiner, u.constant, batch);
}

inline void fog(const StageContext& context, FragmentBatch& batch, int) {
  apply_fog(context.planes, fog_constants(context.program), batch);
}

inline void apply_coverage(const StageContext&, FragmentBatch& batch, int) {
  fragment::HWY_NAMESPACE::apply_coverage(batch);
}

inline void fade_point(const StageContext& context, FragmentBatch& batch, int) {
  fragment::HWY_NAMESPACE::fade_point(context.planes.point_fade, batch);
}

inline void alpha_to_coverage(const StageContext&, FragmentBatch& batch, int) {
  fragment::HWY_NAMESPACE::alpha_to_coverage(batch);
}

inline void alpha_to_one(const StageContext&, FragmentBatch& batch, int) {
  fragment::HWY_NAMESPACE::alpha_to_one(batch);
}

inline void alpha_test(const StageContext& context, FragmentBatch& batch, int) {
  fragment::HWY_NAMESPACE::alpha_test(context.program.alpha_func, context.program.alpha_reference,
                                      batch);
}

inline void pack_colour(const StageContext&, FragmentBatch& batch, int) {
  fragment::HWY_NAMESPACE::pack_colour(batch.previous, batch.count, batch.colour);
}

inline void blend(const StageContext& context, FragmentBatch& batch, int) {
  blend_stage(context.program.blend, batch);
}

inline void pack_srgb(const StageContext&, FragmentBatch& batch, int) {
  pipeline::pack_srgb(batch);
}

inline void blend_srgb(const StageContext& context, FragmentBatch& batch, int) {
  pipeline::blend_srgb(context.program.blend, batch);
}

inline void logic_op(const StageContext& context, FragmentBatch& batch, int) {
  logic_op_stage(context.program.logic_op, batch);
}

inline void truncate(const StageContext& context, FragmentBatch& batch, int) {
  truncate_stage(context.program.format, batch);
}

}  // namespace stage

inline void run_stage(const StageContext& context, const ChainStep& step, FragmentBatch& batch) {
  using StageFunction = void (*)(const StageContext&, FragmentBatch&, int);
  static constexpr StageFunction kStages[] = {
#define FRAGMENT_STAGE(name) &stage::name,
#include "pipeline/fragment/stages.def"
#undef FRAGMENT_STAGE
  };
  kStages[static_cast<int>(step.stage)](context, batch, step.unit);
}

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
