// The texture units of a program in the fused loop (fused-inl.h).
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_FUSED_TEXTURES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_FUSED_TEXTURES_INL_H_
#undef CLEARPIPE_FRAGMENT_FUSED_TEXTURES_INL_H_
#else
#define CLEARPIPE_FRAGMENT_FUSED_TEXTURES_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "pipeline/fragment/fused_unit-inl.h"
#include "pipeline/fragment/group-inl.h"
#include "pipeline/fragment/split_plane-inl.h"
#include "pipeline/fragment/texenv-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

// The texture units of a program: all are sampled, then their environments follow one another
// (3.7.12, 3.7.13). Environments that are not simple go through the chain's, on a batch of a few
// rows.
class FusedTextures {
 public:
  void start(const FragmentProgram& program, const PrimitivePlanes& planes, const Tile& tile,
             const TilePlaces& places) {
    p_ = &program;
    count_ = 0;
    simple_ = true;
    for (int u = 0; u < kMaxTextureUnits; ++u) {
      if ((program.inputs.texture_units >> u & 1) == 0) continue;
      unit_[count_].start(program, planes, tile, places, u);
      number_[count_++] = u;
      simple_ = simple_ && program.unit[u].simple_environment;
    }
    if (simple_) return;
    uses_primary_ = false;
    for (int i = 0; i < count_; ++i) {
      const UnitProgram& unit = program.unit[number_[i]];
      uses_primary_ = uses_primary_ || reads_primary_colour(unit.combiner);
      environment_[i] = bind_environment(unit.combiner, unit.constant, batch_);
    }
  }

  bool are_simple() const { return simple_; }
  bool have_pixels() const {
    return std::all_of(unit_, unit_ + count_, [](const FusedUnit& u) { return u.has_pixels(); });
  }

  // Samples halves of a row; w is that of its pixels.
  HWY_INLINE void sample(int row, Halves halves, const float* w) {
    for (int i = 0; i < count_; ++i) unit_[i].sample(row, halves, w, batch_);
  }

  // As fragment::gives_texels(), of the only unit.
  bool gives_texels(const PrimitivePlanes& planes, uint32_t& texel_bits) const {
    return count_ == 1 && simple_ && unit_[0].has_pixels() &&
           fragment::HWY_NAMESPACE::gives_texels(p_->unit[number_[0]].combiner, planes, texel_bits);
  }
  HWY_INLINE Pair<VecU> texels(int group) const { return unit_[0].pixels(group); }

  // The simple environments of a group that is sampled.
  HWY_INLINE void apply(int group, Colour16& colour) const {
    for (int i = 0; i < count_; ++i) {
      apply_simple_environment(p_->unit[number_[i]].combiner, unit_[i].colour(group), colour);
    }
  }

  // Environments of any kind, of a strip of rows: first a sampled group of each row after another,
  // with its primary colours, goes to a place in the strip.
  HWY_INLINE void put(int place, int group, const Colour16& primary) {
    const Tag16 d;
    const auto put_colour = [&](const Colour16& colour, int16_t(*to)[kBatchSize]) HWY_ATTR {
      for (int c = 0; c < 4; ++c) hn::Store(colour.channel[c], d, to[c] + place * kGroup);
    };
    if (uses_primary_) put_colour(primary, batch_.primary);
    put_colour(primary, batch_.previous);
    for (int i = 0; i < count_; ++i) put_colour(unit_[i].colour(group), batch_.texture[number_[i]]);
  }
  HWY_NOINLINE void combine(int first_place, int end_place) {
    for (int i = 0; i < count_; ++i) {
      run_environment(environment_[i], first_place * kGroup, end_place * kGroup, batch_.previous);
    }
  }
  HWY_INLINE Colour16 result(int place) const {
    const Tag16 d;
    Colour16 colour;
    for (int c = 0; c < 4; ++c) {
      colour.channel[c] = hn::Load(d, batch_.previous[c] + place * kGroup);
    }
    return colour;
  }

 private:
  const FragmentProgram* p_;
  int count_;
  bool simple_;
  bool uses_primary_;  // an environment takes it other than as what was there before
  int number_[kMaxTextureUnits];
  FusedUnit unit_[kMaxTextureUnits];
  BoundEnvironment environment_[kMaxTextureUnits];
  FragmentBatch batch_;
};

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
