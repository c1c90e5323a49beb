// A batch of fragments that come from many small primitives (setup/small.h).
//
// Primitives come in groups of as many as a vector has lanes: their planes are made together, one
// primitive in each lane (setup/lane_planes-inl.h), and their pixels make one list, so that vectors
// of fragments are full whatever the primitives cover; a fragment's plane is that of the lane that
// its primitive has. All that follows works on the fragments of the batch, whatever primitive they
// belong to, with the stages of the chain. Values and their order of arithmetic are those of the
// chain, so the bits are, too.
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

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "pipeline/fragment/small.h"
#include "pipeline/fragment/stages-inl.h"
#include "pipeline/setup/lane_planes-inl.h"
#include "pipeline/setup/small.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

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

  // What setup knows of the primitives that come next.
  void set_state(const SetupState& state) {
    if (state_ != nullptr && !makes_same_planes(*state_, state)) end_group();
    state_ = &state;
  }

  // Takes the pixels of a primitive whose vertex records stay where they are until flush().
  HWY_INLINE void add(PrimitiveKind kind, bool back_facing, float size, const float* const* vertex,
                      const SmallCoverage& coverage) {
    const int count = std::popcount(coverage.mask);
    if (batch_.count + listed_ + count > kRoom) flush();
    if (!note(coverage)) {
      flush();
      note(coverage);
    }
    if (group_.count == kLanes || kind != kind_) {
      end_group();
      kind_ = kind;
    }
    const int lane = group_.count++;
    for (int k = 0; k <= static_cast<int>(kind); ++k) {
      hwy::Prefetch(vertex[k] + vertex_record::kWindow);
      group_.vertex[k][lane] = vertex[k];
    }
    group_.colour_offset[lane] = back_facing && state_->two_sided
                                     ? state_->layout.back_colour_offset
                                     : vertex_record::kColour;
    group_.size[lane] = size;
    place_[lane] = coverage.row * kTileWidth + coverage.column;
    list_pixels(coverage.mask, count, lane);
    listed_ += count;
  }

  // Shades what was added.
  void flush() {
    end_group();
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
  using LanePlane = setup::HWY_NAMESPACE::LanePlane;
  using LanePlanes = setup::HWY_NAMESPACE::LanePlanes;
  using LanePrimitives = setup::HWY_NAMESPACE::LanePrimitives;
  static constexpr int kLanes = setup::HWY_NAMESPACE::kPlaneLanes;
  static constexpr int kRoom = kBatchSize - kLanes + 1;  // the last vector may be stored whole
  static constexpr int kListed = 4;                      // pixels that are listed at a time
  // Squares of a row, with one more at its end, and rows with one more above.
  static constexpr int kSquareStride = kTileWidth / kSmallSide + 1;
  static constexpr int kSquares = kSquareStride * (kTileHeight / kSmallSide + 1);

  // Whether primitives of two draws can be in one group. Their programs are the same.
  static bool makes_same_planes(const SetupState& a, const SetupState& b) {
    if (&a == &b) return true;
    const RasterState &s = a.raster, &t = b.raster;
    return std::equal(std::begin(a.layout.texture_offset), std::end(a.layout.texture_offset),
                      std::begin(b.layout.texture_offset)) &&
           a.mirror_height == b.mirror_height && s.flat_shade == t.flat_shade && !s.offset_fill &&
           !t.offset_fill && s.point_sprite == t.point_sprite && s.coord_replace == t.coord_replace;
  }

  // The planes of a lane's primitive, for the fragments of a vector.
  class FragmentPlanes {
   public:
    HWY_INLINE explicit FragmentPlanes(VecI lane)
        : float_index_(hn::IndicesFromVec(TagF(), lane)),
          whole_index_(hn::IndicesFromVec(TagI(), lane)) {}
    HWY_INLINE VecF operator()(VecF values) const {
      return hn::TableLookupLanes(values, float_index_);
    }
    HWY_INLINE VecI operator()(VecI values) const {
      return hn::TableLookupLanes(values, whole_index_);
    }
    HWY_INLINE LanePlane operator()(const LanePlane& plane) const {
      return {(*this)(plane.value), (*this)(plane.dx), (*this)(plane.dy)};
    }

   private:
    decltype(hn::IndicesFromVec(TagF(), VecI())) float_index_;
    decltype(hn::IndicesFromVec(TagI(), VecI())) whole_index_;
  };

  // Evaluates what depends on the primitives of the group: depth, colour, coordinates.
  void end_group() {
    if (group_.count == 0) return;
    group_.pad();
    LanePlanes planes;
    setup::HWY_NAMESPACE::make_lane_planes(*state_, kind_, group_, planes);
    const TagF d;
    const TagI di;
    const hn::Rebind<uint8_t, TagI> d8;
    static_assert(kTileWidth == 1 << 6 && kSmallSide == 1 << 3);
    const VecI places = hn::Load(di, place_);
    const VecF half = hn::Set(d, 0.5f);
    const VecF to_x = hn::Sub(half, planes.x_ref), to_y = hn::Sub(half, planes.y_ref);
    for (int i = 0; i < listed_; i += kLanes) {
      const FragmentPlanes of(hn::PromoteTo(di, hn::LoadU(d8, lane_ + i)));
      const VecI pixel = hn::PromoteTo(di, hn::LoadU(d8, pixel_ + i));
      const VecI in_row = hn::And(pixel, hn::Set(di, kSmallSide - 1));
      const VecI offset =
          hn::Add(of(places), hn::Add(hn::ShiftLeft<3>(hn::Sub(pixel, in_row)), in_row));
      const VecI column = hn::And(offset, hn::Set(di, kTileWidth - 1));
      const VecI row = hn::ShiftRight<6>(offset);
      const int at = batch_.count + i;
      hn::StoreU(offset, di, offset_ + at);
      // From whole numbers, as the chain has it.
      const VecF x = hn::Add(hn::ConvertTo(d, hn::Add(column, hn::Set(di, tile_.x))), of(to_x));
      const VecF y = hn::Add(hn::ConvertTo(d, hn::Add(row, hn::Set(di, tile_.y))), of(to_y));
      evaluate_varyings(planes, of, x, y, at);
      if (needs_lod_) {
        const VecI left = hn::AndNot(hn::Set(di, 1), hn::Add(column, hn::Set(di, tile_.x)));
        add_level_of_detail(planes, of, hn::Add(hn::ConvertTo(d, left), of(to_x)),
                            hn::Add(hn::ConvertTo(d, quad_rows(row)), of(to_y)), at);
      }
    }
    batch_.count += listed_;
    group_.count = listed_ = 0;
  }

  // quad_row() of rows of the tile.
  HWY_INLINE VecI quad_rows(VecI row) const {
    const TagI d;
    const VecI one = hn::Set(d, 1), y = hn::Add(row, hn::Set(d, tile_.y));
    if (tile_.mirror_height == 0) return hn::AndNot(one, y);
    const VecI last = hn::Set(d, tile_.mirror_height - 1);
    return hn::Sub(last, hn::AndNot(one, hn::Sub(last, y)));
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

  // Lists the set bits of the mask of the primitive in a lane, four at a time: most masks have no
  // more, and none of what it takes to list a few of them depends on their number.
  HWY_INLINE void list_pixels(uint64_t mask, int count, int lane) {
    static_assert(kListed == 4);
    const uint32_t lanes = static_cast<uint32_t>(lane) * 0x01010101u;
    for (int i = listed_; i < listed_ + count; i += kListed) {
      for (int j = 0; j < kListed; ++j) {
        pixel_[i + j] = static_cast<uint8_t>(std::countr_zero(mask));
        mask &= mask - 1;
      }
      std::memcpy(lane_ + i, &lanes, sizeof(lanes));
    }
  }

  HWY_INLINE void evaluate_varyings(const LanePlanes& planes, const FragmentPlanes& of, VecF x,
                                    VecF y, int at) {
    const TagF d;
    const FragmentInputs& inputs = program_.inputs;
    const auto value = [&](const LanePlane& plane)
                           HWY_ATTR { return evaluate(d, of(plane), x, y); };
    if (inputs.depth) hn::StoreU(value(planes.depth), d, depth_ + at);
    if (!inputs.colour) return;
    const VecF one = hn::Set(d, 1.0f);
    VecF w = one;
    if (planes.perspective) w = hn::Div(w, value(planes.inv_w));
    if (planes.flat_colour) {
      for (int c = 0; c < 4; ++c) hn::StoreU(of(planes.colour[c].value), d, colour_[c] + at);
    } else {
      VecF by = one;
      if (planes.perspective) {
        const VecI divided = of(hn::VecFromMask(TagI(), hn::RebindMask(TagI(), planes.divided)));
        by = hn::IfThenElse(hn::RebindMask(d, hn::MaskFromVec(divided)), w, one);
      }
      for (int c = 0; c < 4; ++c) {
        hn::StoreU(hn::Mul(value(planes.colour[c]), by), d, colour_[c] + at);
      }
    }
    if (inputs.fog) hn::StoreU(hn::Mul(value(planes.fog), w), d, fog_ + at);
    for (int unit = 0; unit < kSmallUnits; ++unit) {
      if ((inputs.texture_units >> unit & 1) == 0) continue;
      const auto& texture = planes.texture[unit];
      const VecF q = hn::Div(one, value(texture[3]));
      hn::StoreU(hn::Mul(value(texture[0]), q), d, coordinates_[unit].s + at);
      hn::StoreU(hn::Mul(value(texture[1]), q), d, coordinates_[unit].t + at);
    }
  }

  // Of fragments whose quads have their corners at (x, y).
  void add_level_of_detail(const LanePlanes& planes, const FragmentPlanes& of, VecF x, VecF y,
                           int at) {
    for (int unit = 0; unit < kSmallUnits; ++unit) {
      if ((program_.inputs.texture_units >> unit & 1) == 0) continue;
      const SampleState& sample = program_.unit[unit].sample;
      if (!sample.needs_lod) continue;
      const auto& texture = planes.texture[unit];
      const LanePlane own[4] = {of(texture[0]), of(texture[1]), {}, of(texture[3])};
      UnitCoordinates& to = coordinates_[unit];
      store_level_of_detail(
          TagF(), quad_footprint(TagF(), own, sample.levels[sample.first_level], tile_, x, y),
          sample, {to.lod, to.probes, to.along_s, to.along_t}, at);
    }
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
  // The group: its primitives, where their masks lie in the tile, and their pixels: bits of the
  // masks, and in which lane the primitive is. A few more are written behind the last.
  const SetupState* state_ = nullptr;
  PrimitiveKind kind_ = PrimitiveKind::kTriangle;
  LanePrimitives group_;
  alignas(64) int32_t place_[kLanes] = {};
  int listed_ = 0;
  alignas(64) uint8_t pixel_[kBatchSize + kListed] = {}, lane_[kBatchSize + kListed] = {};
  uint64_t pending_[kSquares] = {};         // the pixels in the batch or the group
  alignas(64) int32_t offset_[kBatchSize];  // index into the tile's planes
  alignas(64) float depth_[kBatchSize], fog_[kBatchSize], colour_[4][kBatchSize];
  UnitCoordinates coordinates_[kSmallUnits];
  FragmentBatch batch_;
};

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
