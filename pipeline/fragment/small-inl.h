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
// came before it, so the batch is shaded first. Where the last fragment replaces all before it,
// only a group may have no pixel twice. Colours that are written as they are need no batch where
// squares have many pixels (small_squares-inl.h).
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_SMALL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_SMALL_INL_H_
#undef CLEARPIPE_FRAGMENT_SMALL_INL_H_
#else
#define CLEARPIPE_FRAGMENT_SMALL_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>
#include <span>
#include <type_traits>

#include "pipeline/fragment/small.h"
#include "pipeline/fragment/small_group-inl.h"
#include "pipeline/fragment/small_pixels-inl.h"
#include "pipeline/fragment/small_squares-inl.h"
#include "pipeline/fragment/stages-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

class SmallBatch {
 public:
  // `alone`: until share(), nobody asks which pixels it has.
  SmallBatch(const FragmentProgram& program, Tile& tile, SmallScratch& scratch, bool alone)
      : program_(program),
        tile_(tile),
        depth_state_(depth_state(program)),
        replaces_(program.colour_mask == 0xffffffffu && !program.blend.enabled &&
                  !program.has_logic_op),
        in_order_(replaces_ && (program.early_depth || !program.uses_depth_stencil)),
        solid_(writes_primitive_colours(program)),
        alone_(alone),
        lane_of_(scratch.lane_of),
        depth_of_(scratch.depth_of),
        batch_(scratch.batch) {
    for (int unit = 0; unit < kSmallUnits; ++unit) {
      if ((program.inputs.texture_units >> unit & 1) == 0) continue;
      const UnitProgram& u = program.unit[unit];
      needs_lod_ |= u.sample.needs_lod;
      std::construct_at(&environment_[unit], bind_environment(u.combiner, u.constant, batch_));
    }
  }

  // What setup knows of the primitives that come next.
  void set_state(const SetupState& state) {
    if (state_ != nullptr && !makes_same_planes(*state_, state)) end_group();
    state_ = &state;
  }

  // Takes the pixels of a primitive whose vertex records stay where they are until flush(). Of each
  // square, before(Parts) is called first: SquareParts, or WholeSquare where they lie in such.
  template <class Parts, size_t kSquares, class Before>
  HWY_INLINE void add(PrimitiveKind kind, bool back_facing, float size, const float* const* vertex,
                      std::span<const SmallCoverage, kSquares> squares, const Before& before) {
    const int colour_offset = back_facing && state_->two_sided ? state_->layout.back_colour_offset
                                                               : vertex_record::kColour;
    if (group_.is_empty() || !group_.takes(kind)) {
      end_group();
      choose_form();
    }
    bool has_lane = false;
    const auto take_lane = [&] {
      if (!has_lane || group_.is_empty()) group_.add(kind, colour_offset, size, vertex);
      has_lane = true;
    };
    for (const SmallCoverage& coverage : squares) {
      const int count = std::popcount(coverage.mask);
      pixels_seen_ += count;
      ++squares_seen_;
      if (in_squares_) {
        if (squares_.is_full()) end_group();
        take_lane();
        if (!alone_) {
          const Parts parts(coverage);
          before(parts);
          pending_.note_any(parts);
        }
        squares_.list(coverage, group_.last_lane());
        continue;
      }
      const Parts parts(coverage);
      before(parts);
      if (count_ + group_.pixels() + count > kRoom) {
        end_group();
        if (count_ + count > kRoom) flush();
      }
      if (!pending_.note(parts)) {
        if (in_order_) {
          end_group();
        } else {
          flush();
        }
        pending_.note(parts);
      }
      take_lane();
      group_.list(coverage, count);
    }
  }

  // From here on has() is asked: what squares there are was not noted.
  void share() {
    if (alone_ && in_squares_) end_group();
    alone_ = false;
  }

  // Whether the batch has one of the pixels.
  template <class Parts>
  HWY_INLINE bool has(const Parts& parts) const {
    return pending_.has(parts) || (in_order_ && held_.has(parts));
  }

  // Shades what was added.
  void flush() {
    end_group();
    shade_batch();
    pending_.forget();
  }

 private:
  using TagF = hn::ScalableTag<float>;
  using TagI = hn::RebindToSigned<TagF>;
  using VecF = hn::Vec<TagF>;
  using VecI = hn::Vec<TagI>;
  using LanePlane = setup::HWY_NAMESPACE::LanePlane;
  using LanePlanes = setup::HWY_NAMESPACE::LanePlanes;
  static constexpr int kLanes = SmallGroup::kLanes;
  static constexpr int kRoom = kBatchSize - kLanes + 1;  // the last vector may be stored whole

  // Where a vector of fragments is: columns and rows of the tile, and relative to the reference of
  // their primitives, from whole numbers, as the chain has it.
  struct Places {
    VecI column, row;
    VecF x, y;
  };
  HWY_INLINE Places places_of(VecI offset, VecF to_x, VecF to_y) const {
    const TagF d;
    const TagI di;
    static_assert(kTileWidth == 1 << 6);
    const VecI column = hn::And(offset, hn::Set(di, kTileWidth - 1));
    const VecI row = hn::ShiftRight<6>(offset);
    return {column, row, hn::Add(hn::ConvertTo(d, hn::Add(column, hn::Set(di, tile_.x))), to_x),
            hn::Add(hn::ConvertTo(d, hn::Add(row, hn::Set(di, tile_.y))), to_y)};
  }

  // The group's fragments become the batch's: what depends on their primitives is evaluated. Where
  // depth is tested before anything else, only those that pass do.
  void end_group() {
    if (group_.is_empty()) return;
    LanePlanes planes;
    group_.make_planes(*state_, planes);
    if (in_squares_) {
      squares_.shade(program_, planes, tile_);
      squares_.clear();
      group_.clear();
      if (!alone_) pending_.forget();
      return;
    }
    for (int unit = 0; unit < kSmallUnits; ++unit) {
      if ((program_.inputs.texture_units >> unit & 1) == 0) continue;
      q_is_inv_w_[unit] = setup::HWY_NAMESPACE::is_inv_w(planes, planes.texture[unit][3]);
    }
    const TagF d;
    const TagI di;
    const VecF half = hn::Set(d, 0.5f);
    const VecF to_x = hn::Sub(half, planes.x_ref), to_y = hn::Sub(half, planes.y_ref);
    const int count = program_.early_depth ? list_what_passes(planes, to_x, to_y) : list_all();
    SmoothShape<VecF> shapes;
    if (program_.antialiased) {
      shapes = smooth_shape(group_.kind() == PrimitiveKind::kPoint, planes.half_width, planes.dx,
                            planes.dy);
    }
    for (int i = 0; i < count; i += kLanes) {
      const int at = count_ + i;
      const FragmentPlanes of(hn::Load(di, lane_of_ + i));
      const Places p = places_of(hn::LoadU(di, offset_ + at), of(to_x), of(to_y));
      if (program_.antialiased) {
        hn::StoreU(covered_share(d, shape_of_fragments(shapes, of), p.x, p.y),
                   hn::Rebind<int16_t, TagF>(), coverage_ + at);
      }
      evaluate_varyings(planes, of, p.x, p.y, at);
      if (needs_lod_) {
        const VecI left = hn::AndNot(hn::Set(di, 1), hn::Add(p.column, hn::Set(di, tile_.x)));
        add_level_of_detail(planes, of, hn::Add(hn::ConvertTo(d, left), of(to_x)),
                            hn::Add(hn::ConvertTo(d, quad_rows(tile_, p.row)), of(to_y)), at);
      }
    }
    count_ += count;
    group_.clear();
    if (in_order_) {
      held_.note(pending_);
      pending_.forget();
    }
  }

  // Before a group begins: whether it is one of squares. Those with few pixels cost less as lists
  // of them, so it depends on the group before, as a rule one of the same mesh.
  void choose_form() {
    constexpr int kDense = 8;
    const bool dense = solid_ && pixels_seen_ >= kDense * squares_seen_;
    pixels_seen_ = squares_seen_ = 0;
    if (dense && !in_squares_) shade_batch();
    in_squares_ = dense;
  }

  // The places and lanes of all that is listed; returns how many.
  HWY_INLINE int list_all() {
    const TagI d;
    const int count = group_.pixels();
    for (int i = 0; i < count; i += kLanes) {
      hn::Store(group_.lanes(i), d, lane_of_ + i);
      hn::StoreU(group_.offsets(i), d, offset_ + count_ + i);
    }
    return count;
  }

  // The same of what passes the depth test, which is done at once: a group has a pixel once.
  HWY_INLINE int list_what_passes(const LanePlanes& planes, VecF to_x, VecF to_y) {
    const DepthState& depth = depth_state_;
    const auto list = [&](auto func) HWY_ATTR {
      return list_what_passes(KnownDepthState<func(), false>{depth.write, depth.most}, planes, to_x,
                              to_y);
    };
    switch (depth.func) {
      case CompareFunc::kLess:
        return list(std::integral_constant<CompareFunc, CompareFunc::kLess>());
      case CompareFunc::kLessEqual:
        return list(std::integral_constant<CompareFunc, CompareFunc::kLessEqual>());
      default:
        return list_what_passes(depth_state_, planes, to_x, to_y);
    }
  }
  template <class State>
  HWY_INLINE int list_what_passes(const State& depth, const LanePlanes& planes, VecF to_x,
                                  VecF to_y) {
    const TagF d;
    const TagI di;
    const auto* stored = reinterpret_cast<const int32_t*>(tile_.depth_stencil);
    int32_t* const kept = offset_ + count_;
    int count = 0;
    for (int i = 0; i < group_.pixels(); i += kLanes) {
      const auto listed = hn::FirstN(di, static_cast<size_t>(group_.pixels() - i));
      const VecI lane = group_.lanes(i);
      const FragmentPlanes of(lane);
      const VecI offset = hn::IfThenElseZero(listed, group_.offsets(i));
      const Places p = places_of(offset, of(to_x), of(to_y));
      const VecF z = evaluate(d, of(planes.depth), p.x, p.y);
      VecI packed = hn::GatherIndex(di, stored, offset);
      const auto passes = depth_stencil_test(di, NoStencilState(), depth, listed,
                                             to_depth_value(d, depth, z), packed);
      const LanesInFront in_front(passes);
      hn::StoreU(in_front(offset), di, kept + count);
      hn::StoreU(in_front(lane), di, lane_of_ + count);
      hn::StoreU(in_front(packed), di, depth_of_ + count);
      count += in_front.count();
    }
    if (depth.write) {
      scatter_pixels(reinterpret_cast<const uint32_t*>(depth_of_), kept, count,
                     tile_.depth_stencil);
    }
    return count;
  }

  HWY_INLINE void evaluate_varyings(const LanePlanes& planes, const FragmentPlanes& of, VecF x,
                                    VecF y, int at) {
    const TagF d;
    const FragmentInputs& inputs = program_.inputs;
    const auto value = [&](const LanePlane& plane)
                           HWY_ATTR { return evaluate(d, of(plane), x, y); };
    if (inputs.depth && !program_.early_depth) hn::StoreU(value(planes.depth), d, depth_ + at);
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
      const VecF q = q_is_inv_w_[unit] ? w : hn::Div(one, value(texture[3]));
      hn::StoreU(hn::Mul(value(texture[0]), q), d, coordinates_[unit].s + at);
      hn::StoreU(hn::Mul(value(texture[1]), q), d, coordinates_[unit].t + at);
    }
  }

  // Of fragments whose quads have their corners at (x, y).
  void add_level_of_detail(const LanePlanes& planes, const FragmentPlanes& of, VecF x, VecF y,
                           int at) {
    const TagF d;
    const VecF one = hn::Set(d, 1.0f);
    QuadReciprocals<VecF> w{one, one, one};
    if (planes.perspective) w = quad_reciprocals(d, of(planes.inv_w), tile_, x, y);
    for (int unit = 0; unit < kSmallUnits; ++unit) {
      if ((program_.inputs.texture_units >> unit & 1) == 0) continue;
      const SampleState& sample = program_.unit[unit].sample;
      if (!sample.needs_lod) continue;
      const auto& texture = planes.texture[unit];
      const LanePlane own[4] = {of(texture[0]), of(texture[1]), {}, of(texture[3])};
      UnitCoordinates& to = coordinates_[unit];
      const SampleLevel& level = sample.levels[sample.first_level];
      const Footprint<VecF> footprint = q_is_inv_w_[unit]
                                            ? quad_footprint(d, own, level, tile_, x, y, w)
                                            : quad_footprint(d, own, level, tile_, x, y);
      store_level_of_detail(d, footprint, sample, {to.lod, to.probes, to.along_s, to.along_t}, at);
    }
  }

  void shade_batch() {
    if (count_ != 0 && program_.step_count != 0) {
      batch_.count = count_;
      pad();
      shade();
    }
    held_.forget();
    count_ = 0;
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

  // The depth and stencil tests (4.1.5, 4.1.6) on the tile's values; false when no fragment lives.
  bool test() {
    const TagF df;
    const TagI d;
    const hn::Rebind<int16_t, TagI> d16;
    gather_pixels(tile_.depth_stencil, offset_, batch_.count, batch_.stored_depth_stencil);
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
      scatter_pixels(batch_.stored_depth_stencil, offset_, batch_.count, tile_.depth_stencil);
    }
    return !hn::AllTrue(d, hn::Eq(any, hn::Zero(d)));
  }

  void shade() {
    const bool writes = program_.colour_mask != 0;
    if (writes && !replaces_) {
      gather_pixels(tile_.colour, offset_, batch_.count, batch_.stored_colour);
    }
    static const PrimitivePlanes kNoPlanes;
    const StageContext context{program_, kNoPlanes, tile_};
    for (int i = 0; i < program_.step_count; ++i) {
      const ChainStep& step = program_.steps[i];
      switch (step.stage) {
        case FragmentStage::interpolate_w:
          break;
        case FragmentStage::smooth_coverage:
          std::copy_n(coverage_, batch_.count, batch_.coverage);
          drop_uncovered(batch_);
          break;
        case FragmentStage::test_depth_stencil:
          if (!test()) return;
          break;
        case FragmentStage::interpolate_colour:
          round_colours(colour_, program_.inputs.texture_units != 0, batch_);
          break;
        case FragmentStage::sample_texture:
          sample(step.unit);
          break;
        case FragmentStage::texture_environment:
          run_environment(environment_[step.unit], 0, batch_.count, batch_.previous);
          break;
        case FragmentStage::fog:
          mix_with_fog();
          break;
        default:
          run_stage(context, step, batch_);
      }
    }
    if (replaces_) {
      scatter_live_pixels(batch_.colour, offset_, batch_.live, batch_.count, tile_.colour);
    } else if (writes) {
      mask_stage(program_.colour_mask, batch_, batch_.live);
      scatter_pixels(batch_.colour, offset_, batch_.count, tile_.colour);
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
  // And the last that has passed all tests stays: a pixel may be in the batch more than once, but
  // not in a group.
  const bool in_order_;
  const bool solid_;  // the colours of primitives are those of their pixels
  bool alone_;
  bool needs_lod_ = false;
  bool q_is_inv_w_[kSmallUnits] = {};  // of the group, whose w is 1 without perspective
  int count_ = 0, padded_ = 0;         // fragments
  const SetupState* state_ = nullptr;
  SmallGroup group_;
  bool in_squares_ = false;                 // the group is one of squares_
  int pixels_seen_ = 0, squares_seen_ = 0;  // since the form was chosen
  SmallSquares squares_;
  PendingPixels pending_;  // those of the batch and the group; if in_order_, of the group alone
  PendingPixels held_;     // and of the batch
  alignas(64) int32_t offset_[kBatchSize];  // index into the tile's planes
  alignas(64) int16_t coverage_[kBatchSize];
  alignas(64) float depth_[kBatchSize], fog_[kBatchSize], colour_[4][kBatchSize];
  UnitCoordinates coordinates_[kSmallUnits];
  BoundEnvironment environment_[kSmallUnits];
  int32_t *const lane_of_, *const depth_of_;  // of the scratch memory
  FragmentBatch& batch_;                      // while it is shaded
};

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
