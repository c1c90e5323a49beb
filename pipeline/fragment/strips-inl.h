// Strips: rows of the fused loop that are made of pieces of several rows, a vector each, where a
// primitive covers few pixels of a row, as sprites do.
//
//   tile    .. a0 a1 a2 a3 ..      strip   a0 a1 a2 a3 b0 b1 b2 b3 c0 c1 c2 c3
//           .. .. b0 b1 b2 b3
//           .. c0 c1 c2 c3 ..
//
// A piece begins wherever its row does. Samplers, environments and writers take a strip as they
// take a row, so that the bits are the same. SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_STRIPS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_STRIPS_INL_H_
#undef CLEARPIPE_FRAGMENT_STRIPS_INL_H_
#else
#define CLEARPIPE_FRAGMENT_STRIPS_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>

#include "pipeline/fragment/aligned-inl.h"
#include "pipeline/fragment/fused_unit-inl.h"
#include "pipeline/fragment/group-inl.h"
#include "pipeline/fragment/split_plane-inl.h"
#include "pipeline/fragment/write_row-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::fragment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

// The colours of pixels that have passed all tests, of a primitive without perspective and a
// program with FragmentProgram::fits_strips.
class Strips {
 public:
  // Whether strips are for the coverage: those of wider ones would save nothing.
  static bool fit(const Coverage& coverage) {
    constexpr int kWidest = 2 * kLanes;
    uint64_t columns = 0;
    for (int row = coverage.first_row; row < coverage.last_row; ++row) {
      columns |= coverage.rows[row];
    }
    return std::bit_width(columns) - std::countr_zero(columns) <= kWidest;
  }

  Strips(const FragmentProgram& program, const PrimitivePlanes& planes, Tile& tile)
      : p_(program),
        tile_(tile),
        flat_(planes.flat_colour),
        opaque_(program.colour_mask == 0xffffffffu && !program.blend.enabled &&
                !program.has_logic_op),
        truncation_(truncation_of(program.format)) {
    if (!opaque_) writer_ = row_writer(program);
    const TilePlaces places(tile, planes);
    for (int c = 0; c < 4; ++c) {
      if (flat_) {
        const VecI value = round_colour(TagF(), hn::Set(TagF(), planes.colour[c].value));
        primary_.channel[c] = narrow({value, value});
      } else {
        colour_[c].set(planes.colour[c], places);
      }
    }
    for (int u = 0; u < kStripUnits; ++u) {
      if ((program.inputs.texture_units >> u & 1) == 0) continue;
      unit_[count_++].start(program.unit[u], planes.texture[u], places);
    }
  }

  // A piece of each row after another, then the next pieces, so that those of a rectangle have
  // their columns in common. Two that may overlap are never in one strip.
  void run(const Coverage& coverage) {
    Coverage left = coverage;
    for (bool more = true; more;) {
      more = false;
      int pieces = 0;
      for (int row = left.first_row; row < left.last_row; ++row) {
        uint64_t& bits = left.rows[row];
        if (bits == 0) continue;
        // Whole vectors of the tile's row are read and written.
        const int column = std::min(std::countr_zero(bits), kTileWidth - kLanes);
        place(pieces++, row, column, bits >> column & kAllLanes);
        bits &= ~(kAllLanes << column);
        more = more || bits != 0;
        if (pieces == kPieces) {
          shade(pieces);
          pieces = 0;
        }
      }
      if (pieces != 0) shade(pieces);
    }
  }

 private:
  static constexpr int kLanes = kGroup / 2;
  static constexpr int kPieces = kTileWidth / kLanes;
  static constexpr uint64_t kAllLanes = (uint64_t{1} << kLanes) - 1;

  struct Unit {
    const UnitProgram* program;
    RowSampler sampler;
    bool q_is_one, is_aligned;
    SplitPlane s_plane, t_plane, q_plane;
    alignas(64) float s[kTileWidth], t[kTileWidth];
    RowPixels texels;
    Halves left;  // pieces that are not sampled yet
    AlignedSampler aligned;

    void start(const UnitProgram& unit, const Plane* planes, const TilePlaces& places) {
      program = &unit;
      sampler = row_sampler(unit.fused_min);
      s_plane.set(planes[0], places);
      t_plane.set(planes[1], places);
      const Plane& q = planes[3];
      q_is_one = q.value == 1 && q.dx == 0 && q.dy == 0;
      if (!q_is_one) q_plane.set(q, places);
      is_aligned = q_is_one && AlignedSampler::is_for(planes[0], planes[1]);
      if (is_aligned) aligned.start(unit.sample, s_plane, t_plane);
      left = 0;
    }

    HWY_INLINE void place(int piece, int row, int column, uint64_t bits) {
      const TagF d;
      if (is_aligned && aligned.set_columns(column, bits)) {
        hn::Store(aligned.sample(row), TagU(), texels.pixel + piece * kLanes);
        return;
      }
      left |= Halves{1} << piece;
      VecF ss = s_plane.at(row, column), tt = t_plane.at(row, column);
      if (!q_is_one) {  // a division by one changes nothing
        const VecF reciprocal_q = hn::Div(hn::Set(d, 1.0f), q_plane.at(row, column));
        ss = hn::Mul(ss, reciprocal_q);
        tt = hn::Mul(tt, reciprocal_q);
      }
      hn::Store(ss, d, s + piece * kLanes);
      hn::Store(tt, d, t + piece * kLanes);
    }

    HWY_INLINE void sample() {
      if (left == 0) return;
      const SampleState& state = program->sample;
      sampler(state.levels[state.first_level], s, t, left, texels);
      left = 0;
    }

    HWY_INLINE void apply(int group, Colour16& colour) const {
      Colour16 texture;
      unpack_pixels(texels.load(group), texture.channel);
      for (Vec16& channel : texture.channel) channel = from_unorm8(Tag16(), channel);
      apply_simple_environment(program->combiner, texture, colour);
    }
  };

  // A piece of a row: what is stored there, and where it is.
  HWY_INLINE void place(int piece, int row, int column, uint64_t bits) {
    const TagU d;
    if (piece == 0) covered_ = 0;
    covered_ |= bits << (piece * kLanes);
    row_of_[piece] = row;
    column_of_[piece] = column;
    for (int i = 0; i < count_; ++i) unit_[i].place(piece, row, column, bits);
    hn::Store(hn::LoadU(d, tile_.colour + row * kTileWidth + column), d, pixels_ + piece * kLanes);
  }

  HWY_INLINE VecI rounded(int c, int piece) const {
    return round_colour(TagF(), colour_[c].at(row_of_[piece], column_of_[piece]));
  }

  void shade(int pieces) {
    const TagU d;
    if (pieces % 2 != 0) {  // groups are whole
      row_of_[pieces] = row_of_[pieces - 1];
      column_of_[pieces] = column_of_[pieces - 1];
    }
    for (int i = 0; i < count_; ++i) unit_[i].sample();
    for (int group = 0; 2 * group < pieces; ++group) {
      Colour16 colour;
      for (int c = 0; c < 4; ++c) {
        colour.channel[c] = flat_ ? primary_.channel[c]
                                  : narrow({rounded(c, 2 * group), rounded(c, 2 * group + 1)});
      }
      for (int i = 0; i < count_; ++i) unit_[i].apply(group, colour);
      for (Vec16& channel : colour.channel) channel = to_unorm8(Tag16(), channel);
      if (opaque_) {
        store_live(keep(pack_pixels(colour.channel)), live_mask(group_bits(covered_, group)),
                   pixels_ + group * kGroup);
      } else {
        row_.store(colour, group);
      }
    }
    if (!opaque_) writer_(p_, row_, covered_, pixels_);
    for (int i = 0; i < pieces; ++i) {
      hn::StoreU(hn::Load(d, pixels_ + i * kLanes), d,
                 tile_.colour + row_of_[i] * kTileWidth + column_of_[i]);
    }
  }

  // On a surface of fewer bits what it holds of pixels (4.1.8).
  HWY_INLINE Pair<VecU> keep(const Pair<VecU>& pixels) const {
    if (p_.format == ColourFormat::kRgba8) return pixels;
    const TagU d;
    return {truncate_colour(d, truncation_, pixels.lower),
            truncate_colour(d, truncation_, pixels.upper)};
  }

  const FragmentProgram& p_;
  Tile& tile_;
  const bool flat_;
  const bool opaque_;  // every fragment replaces the whole pixel
  const Truncation truncation_;
  RowWriter writer_ = nullptr;  // where it does not
  Colour16 primary_;            // if flat_
  SplitPlane colour_[4];
  int count_ = 0;
  Unit unit_[kStripUnits];
  // Of the strip: which pixels are covered, and where in the tile its pieces are.
  uint64_t covered_ = 0;
  int row_of_[kPieces], column_of_[kPieces];
  alignas(64) uint32_t pixels_[kTileWidth];
  RowColours row_;  // 8-bit values, for the writer
};

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
