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
      : program_(program),
        tile_(tile),
        depth_state_(depth_state(program)),
        replaces_(program.colour_mask == 0xffffffffu && !program.blend.enabled &&
                  !program.has_logic_op) {
    batch_.count = 0;
    for (int unit = 0; unit < kSmallUnits; ++unit) {
      if ((program.inputs.texture_units >> unit & 1) == 0) continue;
      needs_lod_ |= program.unit[unit].sample.needs_lod;
    }
  }

  // Takes the pixels of one primitive. Its planes are only read during the call.
  HWY_INLINE void add(const SmallPlanes& planes, const SmallCoverage& coverage) {
    const int count = std::popcount(coverage.mask);
    constexpr int kRoom = kBatchSize - static_cast<int>(hn::MaxLanes(TagF())) + 1;
    if (batch_.count + count > kRoom) flush();
    if (!note(coverage)) {
      flush();
      note(coverage);
    }
    list_pixels(coverage.mask);
    add_vector(planes, coverage, 0);
    if (count > kLanes) add_rest(planes, coverage, count);
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
    std::fill_n(pending_, kSquares, uint64_t{0});
  }

 private:
  using TagF = hn::ScalableTag<float>;
  using TagI = hn::RebindToSigned<TagF>;
  using VecF = hn::Vec<TagF>;
  using VecI = hn::Vec<TagI>;
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(TagF()));
  // Squares of a row, with one more at its end, and rows with one more above.
  static constexpr int kSquareStride = kTileWidth / kSmallSide + 1;
  static constexpr int kSquares = kSquareStride * (kTileHeight / kSmallSide + 1);

  // A vector of the listed pixels from `first` on.
  HWY_INLINE void add_vector(const SmallPlanes& planes, const SmallCoverage& coverage, int first) {
    const TagF d;
    const TagI di;
    const hn::Rebind<uint8_t, TagI> d8;
    static_assert(kTileWidth == 1 << 6 && kSmallSide == 1 << 3);
    const VecI place = hn::PromoteTo(di, hn::LoadU(d8, places_ + first));
    const VecI column = hn::Add(hn::And(place, hn::Set(di, 7)), hn::Set(di, coverage.column));
    const VecI row = hn::Add(hn::ShiftRight<3>(place), hn::Set(di, coverage.row));
    const int at = batch_.count + first;
    hn::StoreU(hn::Add(hn::ShiftLeft<6>(row), column), di, offset_ + at);
    // From whole numbers, as the chain has it.
    const VecF x = hn::Add(hn::ConvertTo(d, hn::Add(column, hn::Set(di, tile_.x))),
                           hn::Set(d, 0.5f - planes.x_ref));
    const VecF y = hn::Add(hn::ConvertTo(d, hn::Add(row, hn::Set(di, tile_.y))),
                           hn::Set(d, 0.5f - planes.y_ref));
    evaluate_varyings(planes, x, y, at);
  }

  // All but the first vector, apart, so that it keeps no register from the first.
  HWY_NOINLINE void add_rest(const SmallPlanes& planes, const SmallCoverage& coverage, int count) {
    for (int i = kLanes; i < count; i += kLanes) add_vector(planes, coverage, i);
  }

  // Notes the pixels of a primitive; false, and nothing is noted, when one is in the batch already.
  // pending_ has the tile in squares of 8x8 as masks have them; the mask lies across four of them.
  HWY_INLINE bool note(const SmallCoverage& coverage) {
    constexpr uint64_t kEachRow = 0x0101010101010101u;
    const int dx = coverage.column % kSmallSide, dy = coverage.row % kSmallSide;
    const uint64_t mask = coverage.mask;
    const uint64_t right_columns = kEachRow * (0xffu >> (kSmallSide - dx));
    const uint64_t left = mask << dx & ~right_columns;
    const uint64_t right = mask >> (kSmallSide - dx) & right_columns;
    uint64_t* square =
        pending_ + coverage.row / kSmallSide * kSquareStride + coverage.column / kSmallSide;
    // Rows that move on to the next square: all 64 bits when dy is 0, so in two steps.
    const auto above = [dy](uint64_t m) { return m >> (56 - kSmallSide * dy) >> kSmallSide; };
    const uint64_t parts[4] = {left << kSmallSide * dy, right << kSmallSide * dy, above(left),
                               above(right)};
    uint64_t* const place[4] = {square, square + 1, square + kSquareStride,
                                square + kSquareStride + 1};
    uint64_t common = 0;
    for (int i = 0; i < 4; ++i) common |= *place[i] & parts[i];
    if (common != 0) return false;
    for (int i = 0; i < 4; ++i) *place[i] |= parts[i];
    return true;
  }

  // The places of the mask's set bits into places_. Where a row's begin is the number of bits in
  // the rows before it.
  HWY_INLINE void list_pixels(uint64_t mask) {
    constexpr uint64_t kEachRow = 0x0101010101010101u;
    uint64_t begin = mask - (mask >> 1 & 0x5555555555555555u);
    begin = (begin & 0x3333333333333333u) + (begin >> 2 & 0x3333333333333333u);
    begin = ((begin + (begin >> 4)) & 0x0f0f0f0f0f0f0f0fu) * kEachRow << 8;
    for (uint64_t rows = mask, row = 0; rows != 0; rows >>= 32, begin >>= 32, row += 4) {
      for (int j = 0; j < 4; ++j) {
        const uint64_t places =
            kBitPlaces[rows >> 8 * j & 0xff] + (row + j) * kSmallSide * kEachRow;
        std::memcpy(places_ + (begin >> 8 * j & 0xff), &places, sizeof(places));
      }
    }
  }

  HWY_INLINE void evaluate_varyings(const SmallPlanes& planes, VecF x, VecF y, int at) {
    const TagF d;
    const FragmentInputs& inputs = program_.inputs;
    if (inputs.depth) hn::StoreU(value(planes.window, kDepthPlane, x, y), d, depth_ + at);
    if (!inputs.colour) return;
    VecF w = hn::Set(d, 1.0f);
    if (planes.perspective) w = hn::Div(w, value(planes.window, kInverseWPlane, x, y));
    const bool divided = planes.perspective && !planes.flat_colour;
    for (int c = 0; c < 4; ++c) {
      VecF colour = value(planes.colour, c, x, y);
      if (divided) colour = hn::Mul(colour, w);
      hn::StoreU(colour, d, colour_[c] + at);
    }
    if (inputs.fog) {
      VecF coordinate = value(planes.fog_group, kFogPlane, x, y);
      if (planes.perspective) coordinate = hn::Mul(coordinate, w);
      hn::StoreU(coordinate, d, fog_ + at);
    }
    for (int unit = 0; unit < kSmallUnits; ++unit) {
      if ((inputs.texture_units >> unit & 1) == 0) continue;
      const SmallPlanes::Four& texture = planes.texture[unit];
      const VecF q = hn::Div(hn::Set(d, 1.0f), value(texture, 3, x, y));
      hn::StoreU(hn::Mul(value(texture, 0, x, y), q), d, coordinates_[unit].s + at);
      hn::StoreU(hn::Mul(value(texture, 1, x, y), q), d, coordinates_[unit].t + at);
    }
  }

  // `evaluate` of one plane of four.
  static HWY_INLINE VecF value(const SmallPlanes::Four& four, int i, VecF x, VecF y) {
    return evaluate(TagF(), four.plane(i), x, y);
  }

  // Of the fragments that are being added; their offsets are noted already.
  void add_level_of_detail(const SmallPlanes& planes, int count) {
    const int at = batch_.count;
    PrimitivePlanes reference;
    reference.x_ref = planes.x_ref;
    reference.y_ref = planes.y_ref;
    // The batch's own arrays are free until a unit samples.
    batch_.count = count;
    for (int i = 0; i < count; ++i) batch_.offset[i] = static_cast<uint16_t>(offset_[at + i]);
    for (int unit = 0; unit < kSmallUnits; ++unit) {
      if ((program_.inputs.texture_units >> unit & 1) == 0) continue;
      const SampleState& sample = program_.unit[unit].sample;
      if (!sample.needs_lod) continue;
      Plane texture[4];
      for (int i = 0; i < 4; ++i) texture[i] = planes.texture[unit].plane(i);
      level_of_detail(reference, texture, sample, tile_, batch_);
      UnitCoordinates& to = coordinates_[unit];
      std::copy_n(batch_.lod, count, to.lod + at);
      if (sample.sampler.max_anisotropy > 1) {
        std::copy_n(batch_.probes, count, to.probes + at);
        std::copy_n(batch_.along_s, count, to.along_s + at);
        std::copy_n(batch_.along_t, count, to.along_t + at);
      }
    }
    batch_.count = at;
  }

  // Stages work on whole vectors: the places behind the last fragment are dead.
  void pad() {
    padded_ = std::min((batch_.count + 63) / 64 * 64, kBatchSize);
    std::fill_n(batch_.live, batch_.count, int16_t{-1});
    std::fill(batch_.live + batch_.count, batch_.live + padded_, int16_t{0});
  }

  // The dead places get what the first fragment has.
  void copy_padded(const float* from, float* to) const {
    std::copy_n(from, batch_.count, to);
    std::fill(to + batch_.count, to + padded_, from[0]);
  }

  // Calls f for each fragment.
  template <class F>
  HWY_INLINE void for_each_fragment(const F& f) const {
    const int count = batch_.count;
    int i = 0;
    for (; i + 4 <= count; i += 4) {
      f(i);
      f(i + 1);
      f(i + 2);
      f(i + 3);
    }
    for (; i < count; ++i) f(i);
  }

  void gather(const uint32_t* HWY_RESTRICT plane, uint32_t* HWY_RESTRICT values) const {
    for_each_fragment([=, this](int i) { values[i] = plane[offset_[i]]; });
  }
  void scatter(const uint32_t* HWY_RESTRICT values, uint32_t* HWY_RESTRICT plane) const {
    for_each_fragment([=, this](int i) { plane[offset_[i]] = values[i]; });
  }
  // Of the fragments that live. The others go where nobody looks, so that there is no branch.
  void scatter_live(const uint32_t* values, uint32_t* plane) const {
    uint32_t nowhere;
    for_each_fragment([&, values, plane](int i) {
      uint32_t* to = batch_.live[i] != 0 ? plane + offset_[i] : &nowhere;
      *to = values[i];
    });
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
    if (writes && !replaces_) gather(tile_.colour, batch_.stored_colour);
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
    if (replaces_) {
      scatter_live(batch_.colour, tile_.colour);
    } else if (writes) {
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
    copy_padded(from.s, batch_.s);
    copy_padded(from.t, batch_.t);
    if (u.sample.needs_lod) {
      copy_padded(from.lod, batch_.lod);
      if (u.sample.sampler.max_anisotropy > 1) {
        copy_padded(from.probes, batch_.probes);
        copy_padded(from.along_s, batch_.along_s);
        copy_padded(from.along_t, batch_.along_t);
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
  const bool replaces_;  // what lives replaces the whole pixel
  bool needs_lod_ = false;
  int padded_ = 0;
  alignas(8) uint8_t places_[kSmallSide * kSmallSide + 64];  // a vector may be read at the last
  uint64_t pending_[kSquares] = {};                          // the pixels in the batch
  alignas(64) int32_t offset_[kBatchSize];                   // index into the tile's planes
  alignas(64) float depth_[kBatchSize], fog_[kBatchSize], colour_[4][kBatchSize];
  UnitCoordinates coordinates_[kSmallUnits];
  FragmentBatch batch_;
};

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
