// A batch of fragments that come from many small primitives (setup/small.h).
//
// What depends on the primitive - depth, colour, coordinates - is evaluated when it is added, over
// the list of its covered pixels; all that follows works on full vectors of fragments, whatever
// primitive they belong to, with the stages of the chain. Values and their order of arithmetic are
// those of the chain, so the bits are, too.
//
// A pixel may stand in the batch only once: a primitive that covers one again has to wait for what
// came before it, so the batch is shaded first.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_SMALL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_SMALL_INL_H_
#undef CLEARPIPE_FRAGMENT_SMALL_INL_H_
#else
#define CLEARPIPE_FRAGMENT_SMALL_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "pipeline/fragment/small.h"
#include "pipeline/fragment/stages-inl.h"
#include "pipeline/setup/small.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The places of the set bits of a byte, one after another, a byte each.
inline constexpr std::array<uint64_t, 256> kBitPlaces = [] {
  std::array<uint64_t, 256> places{};
  for (int byte = 0; byte < 256; ++byte) {
    int at = 0;
    for (int bit = 0; bit < 8; ++bit) {
      if ((byte >> bit & 1) != 0) places[byte] |= static_cast<uint64_t>(bit) << (8 * at++);
    }
  }
  return places;
}();

class SmallBatch {
 public:
  SmallBatch(const FragmentProgram& program, Tile& tile)
      : program_(program), tile_(tile), depth_state_(depth_state(program)) {
    batch_.count = 0;
    for (int unit = 0; unit < kSmallUnits; ++unit) {
      if ((program.inputs.texture_units >> unit & 1) == 0) continue;
      needs_lod_ |= program.unit[unit].sample.needs_lod;
    }
  }

  // Takes the pixels of one primitive. Its planes are only read during the call.
  HWY_INLINE void add(const PrimitivePlanes& planes, const SmallCoverage& coverage) {
    const int count = std::popcount(coverage.mask);
    constexpr int kRoom = kBatchSize - static_cast<int>(hn::MaxLanes(TagF())) + 1;
    if (batch_.count + count > kRoom || overlaps(coverage)) flush();
    note(coverage);
    list_pixels(coverage.mask);
    const TagF d;
    const TagI di;
    const hn::Rebind<uint8_t, TagI> d8;
    const VecF to_x = hn::Set(d, 0.5f - planes.x_ref), to_y = hn::Set(d, 0.5f - planes.y_ref);
    for (int i = 0; i < count; i += kLanes) {
      const VecI place = hn::PromoteTo(di, hn::LoadU(d8, places_ + i));
      const VecI column = hn::Add(hn::And(place, hn::Set(di, 7)), hn::Set(di, coverage.column));
      const VecI row = hn::Add(hn::ShiftRight<3>(place), hn::Set(di, coverage.row));
      const int at = batch_.count + i;
      hn::StoreU(hn::Add(hn::ShiftLeft<6>(row), column), di, offset_ + at);
      static_assert(kTileWidth == 1 << 6);
      const VecF x = hn::Add(hn::ConvertTo(d, hn::Add(column, hn::Set(di, tile_.x))), to_x);
      const VecF y = hn::Add(hn::ConvertTo(d, hn::Add(row, hn::Set(di, tile_.y))), to_y);
      evaluate_varyings(planes, x, y, at);
    }
    if (needs_lod_) add_level_of_detail(planes, count);
    batch_.count += count;
  }

  // Shades what was added.
  void flush() {
    if (batch_.count == 0) return;
    pad();
    bool any = true;
    if (program_.early_depth) any = test();
    if (any && program_.step_count != 0) shade();
    batch_.count = 0;
    std::fill_n(pending_, kTileHeight, uint64_t{0});
  }

 private:
  using TagF = hn::ScalableTag<float>;
  using TagI = hn::RebindToSigned<TagF>;
  using VecF = hn::Vec<TagF>;
  using VecI = hn::Vec<TagI>;
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(TagF()));

  HWY_INLINE bool overlaps(const SmallCoverage& coverage) const {
    uint64_t common = 0;
    int row = coverage.row;
    for (uint64_t mask = coverage.mask; mask != 0; mask >>= kSmallSide, ++row) {
      common |= pending_[row] & (mask & 0xff) << coverage.column;
    }
    return common != 0;
  }

  HWY_INLINE void note(const SmallCoverage& coverage) {
    int row = coverage.row;
    for (uint64_t mask = coverage.mask; mask != 0; mask >>= kSmallSide, ++row) {
      pending_[row] |= (mask & 0xff) << coverage.column;
    }
  }

  // The places of the mask's set bits into places_.
  HWY_INLINE void list_pixels(uint64_t mask) {
    uint8_t* out = places_;
    for (uint64_t first = 0; mask != 0; mask >>= kSmallSide, first += 0x0808080808080808u) {
      const uint64_t places = kBitPlaces[mask & 0xff] + first;
      std::memcpy(out, &places, sizeof(places));
      out += std::popcount(mask & 0xff);
    }
  }

  HWY_INLINE void evaluate_varyings(const PrimitivePlanes& planes, VecF x, VecF y, int at) {
    const TagF d;
    const FragmentInputs& inputs = program_.inputs;
    if (inputs.depth) hn::StoreU(evaluate(d, planes.depth, x, y), d, depth_ + at);
    if (!inputs.colour) return;
    VecF w = hn::Set(d, 1.0f);
    if (planes.perspective) w = hn::Div(w, evaluate(d, planes.inv_w, x, y));
    const bool divided = planes.perspective && !planes.flat_colour;
    for (int c = 0; c < 4; ++c) {
      VecF value = evaluate(d, planes.colour[c], x, y);
      if (divided) value = hn::Mul(value, w);
      hn::StoreU(value, d, colour_[c] + at);
    }
    if (inputs.fog) {
      VecF value = evaluate(d, planes.fog, x, y);
      if (planes.perspective) value = hn::Mul(value, w);
      hn::StoreU(value, d, fog_ + at);
    }
    for (int unit = 0; unit < kSmallUnits; ++unit) {
      if ((inputs.texture_units >> unit & 1) == 0) continue;
      VecF s, t;
      coordinate_at(d, planes.texture[unit], x, y, s, t);
      hn::StoreU(s, d, coordinates_[unit].s + at);
      hn::StoreU(t, d, coordinates_[unit].t + at);
    }
  }

  // Of the fragments that are being added; their offsets are noted already.
  void add_level_of_detail(const PrimitivePlanes& planes, int count) {
    const int at = batch_.count;
    lod_batch_.count = count;
    for (int i = 0; i < count; ++i) {
      lod_batch_.offset[i] = static_cast<uint16_t>(offset_[at + i]);
    }
    for (int unit = 0; unit < kSmallUnits; ++unit) {
      if ((program_.inputs.texture_units >> unit & 1) == 0) continue;
      const SampleState& sample = program_.unit[unit].sample;
      if (!sample.needs_lod) continue;
      level_of_detail(planes, planes.texture[unit], sample, tile_, lod_batch_);
      UnitCoordinates& to = coordinates_[unit];
      std::copy_n(lod_batch_.lod, count, to.lod + at);
      if (sample.sampler.max_anisotropy > 1) {
        std::copy_n(lod_batch_.probes, count, to.probes + at);
        std::copy_n(lod_batch_.along_s, count, to.along_s + at);
        std::copy_n(lod_batch_.along_t, count, to.along_t + at);
      }
    }
  }

  // Stages work on whole vectors: the places behind the last fragment are dead, and what they hold
  // was a fragment's.
  void pad() {
    const int end = std::min((batch_.count + 63) / 64 * 64, kBatchSize);
    std::fill_n(batch_.live, batch_.count, int16_t{-1});
    std::fill(batch_.live + batch_.count, batch_.live + end, int16_t{0});
    std::fill(offset_ + batch_.count, offset_ + end, offset_[0]);
  }

  void gather(const uint32_t* plane, uint32_t* values) const {
    for (int i = 0; i < batch_.count; ++i) values[i] = plane[offset_[i]];
  }
  void scatter(const uint32_t* values, uint32_t* plane) const {
    for (int i = 0; i < batch_.count; ++i) plane[offset_[i]] = values[i];
  }

  // The depth and stencil tests (4.1.5, 4.1.6) on the tile's values; false when no fragment lives.
  bool test() {
    const TagF df;
    const TagI d;
    const hn::Rebind<int16_t, TagI> d16;
    gather(tile_.depth_stencil, batch_.stored_depth_stencil);
    auto* stored = reinterpret_cast<int32_t*>(batch_.stored_depth_stencil);
    const StencilState& stencil = program_.stencil;
    VecI any = hn::Zero(d);
    for (int i = 0; i < batch_.count; i += kLanes) {
      const auto live = hn::Ne(hn::PromoteTo(d, hn::Load(d16, batch_.live + i)), hn::Zero(d));
      const VecI depth = depth_state_.test
                             ? to_depth_value(df, depth_state_, hn::Load(df, depth_ + i))
                             : hn::Zero(d);
      VecI packed = hn::Load(d, stored + i);
      const auto passes = depth_stencil_test(d, stencil, depth_state_, live, depth, packed);
      const VecI lives = hn::VecFromMask(d, passes);
      any = hn::Or(any, lives);
      hn::Store(packed, d, stored + i);
      hn::Store(hn::DemoteTo(d16, lives), d16, batch_.live + i);
    }
    if (depth_state_.write || stencil.enabled) {
      scatter(batch_.stored_depth_stencil, tile_.depth_stencil);
    }
    return !hn::AllTrue(d, hn::Eq(any, hn::Zero(d)));
  }

  void shade() {
    const bool writes = program_.colour_mask != 0;
    if (writes) gather(tile_.colour, batch_.stored_colour);
    static const PrimitivePlanes kNoPlanes;
    const StageContext context{program_, kNoPlanes, tile_};
    for (int i = 0; i < program_.step_count; ++i) {
      const ChainStep& step = program_.steps[i];
      switch (step.stage) {
        case FragmentStage::interpolate_w:
          break;
        case FragmentStage::test_depth_stencil:
          if (!test()) return;
          break;
        case FragmentStage::interpolate_colour:
          round_colours();
          break;
        case FragmentStage::sample_texture:
          sample(step.unit);
          break;
        case FragmentStage::fog:
          mix_with_fog();
          break;
        default:
          run_stage(context, step, batch_);
      }
    }
    if (writes) {
      mask_stage(program_.colour_mask, batch_, batch_.live);
      scatter(batch_.colour, tile_.colour);
    }
  }

  void round_colours() {
    const TagF d;
    const hn::Rebind<int16_t, TagF> d16;
    const bool textured = program_.inputs.texture_units != 0;
    for (int c = 0; c < 4; ++c) {
      for (int i = 0; i < batch_.count; i += kLanes) {
        const auto colour = hn::DemoteTo(d16, round_colour(d, hn::Load(d, colour_[c] + i)));
        hn::Store(colour, d16, batch_.previous[c] + i);
        if (textured) hn::Store(colour, d16, batch_.primary[c] + i);
      }
    }
  }

  void sample(int unit) {
    const UnitProgram& u = program_.unit[unit];
    const UnitCoordinates& from = coordinates_[unit];
    std::copy_n(from.s, kBatchSize, batch_.s);
    std::copy_n(from.t, kBatchSize, batch_.t);
    if (u.sample.needs_lod) {
      std::copy_n(from.lod, kBatchSize, batch_.lod);
      if (u.sample.sampler.max_anisotropy > 1) {
        std::copy_n(from.probes, kBatchSize, batch_.probes);
        std::copy_n(from.along_s, kBatchSize, batch_.along_s);
        std::copy_n(from.along_t, kBatchSize, batch_.along_t);
      }
    }
    u.sample_function(u.sample, batch_, unit);
  }

  void mix_with_fog() {
    const TagF d;
    const hn::Rebind<int16_t, TagF> d16;
    const FogConstants constants = fog_constants(program_);
    for (int i = 0; i < batch_.count; i += kLanes) {
      const auto f = to_colour(d16, d, fog_factor(d, constants, hn::Load(d, fog_ + i)));
      for (int c = 0; c < 3; ++c) {
        const auto colour = hn::Load(d16, batch_.previous[c] + i);
        hn::Store(mix_fog(d16, f, constants.colour[c], colour), d16, batch_.previous[c] + i);
      }
    }
  }

  // Of a texture unit, as FragmentBatch has them.
  struct UnitCoordinates {
    alignas(64) float s[kBatchSize], t[kBatchSize], lod[kBatchSize];
    alignas(64) float along_s[kBatchSize], along_t[kBatchSize], probes[kBatchSize];
  };

  const FragmentProgram& program_;
  Tile& tile_;
  const NarrowDepthState depth_state_;
  bool needs_lod_ = false;
  alignas(8) uint8_t places_[kSmallSide * kSmallSide + 64];  // a vector may be read at the last
  uint64_t pending_[kTileHeight] = {};                       // the pixels in the batch, by row
  alignas(64) int32_t offset_[kBatchSize];                   // index into the tile's planes
  alignas(64) float depth_[kBatchSize] = {}, fog_[kBatchSize] = {}, colour_[4][kBatchSize] = {};
  UnitCoordinates coordinates_[kSmallUnits] = {};
  FragmentBatch batch_, lod_batch_;
};

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
