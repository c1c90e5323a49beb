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
  // Whether strips are for the coverage of a primitive. Those of wide ones save something where no
  // texture is turned.
  static bool fit(const FragmentProgram& program, const PrimitivePlanes& planes,
                  const Coverage& coverage) {
    constexpr int kWidest = 2 * kLanes;
    if (planes.perspective) return false;
    if (are_aligned(program, planes)) return true;
    const uint64_t columns = columns_of(coverage);
    return std::bit_width(columns) - std::countr_zero(columns) <= kWidest;
  }

  Strips(const FragmentProgram& program, const PrimitivePlanes& planes, Tile& tile)
      : p_(program),
        tile_(tile),
        flat_(planes.flat_colour),
        opaque_(program.colour_mask == 0xffffffffu && !program.blend.enabled &&
                !program.has_logic_op),
        aligned_(are_aligned(program, planes)),
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
    for_each_unit(
        program, [&](int u) { unit_[count_++].start(program.unit[u], planes.texture[u], places); });
    gives_texels_ = count_ == 1 && gives_texels(unit_[0].program->combiner, planes, texel_bits_);
  }

  // A piece of each row after another, then the next pieces, so that two that may overlap are never
  // in one strip. Where no texture is turned pieces have their columns in common.
  void run(const Coverage& coverage) {
    Coverage left = coverage;
    for (uint64_t columns = columns_of(left); columns != 0;) {
      uint64_t columns_left = 0;
      int pieces = 0;
      for (int row = left.first_row; row < left.last_row; ++row) {
        uint64_t& bits = left.rows[row];
        // Whole vectors of the tile's row are read and written.
        const int column =
            std::min(std::countr_zero(aligned_ ? columns : bits), kTileWidth - kLanes);
        const uint64_t taken = bits >> column & kAllLanes;
        bits &= ~(kAllLanes << column);
        columns_left |= bits;
        if (taken == 0) continue;
        place(pieces++, row, column, taken, aligned_ ? columns >> column & kAllLanes : taken);
        if (pieces == kPieces) {
          shade(pieces);
          pieces = 0;
        }
      }
      if (pieces != 0) shade(pieces);
      columns = columns_left;
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

    void start(const UnitProgram& unit, const Plane (&planes)[4], const TilePlaces& places) {
      program = &unit;
      sampler = row_sampler(unit.fused_min);
      s_plane.set(planes[0], places);
      t_plane.set(planes[1], places);
      const Plane& q = planes[3];
      q_is_one = q.value == 1 && q.dx == 0 && q.dy == 0;
      if (!q_is_one) q_plane.set(q, places);
      is_aligned = AlignedSampler::is_for(planes);
      if (is_aligned) aligned.start(unit.sample, s_plane, t_plane);
      left = 0;
    }

    HWY_INLINE void place(int piece, int row, int column, uint64_t sampled) {
      const TagF d;
      if (is_aligned && aligned.set_columns(column, sampled)) {
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

  // The columns that have pixels.
  static uint64_t columns_of(const Coverage& coverage) {
    uint64_t columns = 0;
    for (int row = coverage.first_row; row < coverage.last_row; ++row) {
      columns |= coverage.rows[row];
    }
    return columns;
  }

  template <class F>
  static HWY_INLINE void for_each_unit(const FragmentProgram& program, const F& function) {
    for (int u = 0; u < kStripUnits; ++u) {
      if ((program.inputs.texture_units >> u & 1) != 0) function(u);
    }
  }

  // Whether no texture is turned.
  static bool are_aligned(const FragmentProgram& program, const PrimitivePlanes& planes) {
    bool aligned = true;
    for_each_unit(program,
                  [&](int u) { aligned = aligned && AlignedSampler::is_for(planes.texture[u]); });
    return aligned;
  }

  // A piece of a row: what is stored there, and where it is. `sampled` are those of its pixels
  // that some piece of these columns has.
  HWY_INLINE void place(int piece, int row, int column, uint64_t bits, uint64_t sampled) {
    const TagU d;
    if (piece == 0) covered_ = 0;
    covered_ |= bits << (piece * kLanes);
    row_of_[piece] = row;
    column_of_[piece] = column;
    for (int i = 0; i < count_; ++i) unit_[i].place(piece, row, column, sampled);
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
      gives_texels_ ? put_texels(group) : put_colours(group);
    }
    if (!opaque_) writer_(p_, row_, covered_, pixels_);
    for (int i = 0; i < pieces; ++i) {
      hn::StoreU(hn::Load(d, pixels_ + i * kLanes), d,
                 tile_.colour + row_of_[i] * kTileWidth + column_of_[i]);
    }
  }

  HWY_INLINE void put_texels(int group) {
    const VecU bits = hn::Set(TagU(), texel_bits_);
    Pair<VecU> pixels = unit_[0].texels.load(group);
    pixels = {hn::Or(pixels.lower, bits), hn::Or(pixels.upper, bits)};
    if (opaque_) {
      replace(pixels, group);
    } else {
      Colour16 colour;
      unpack_pixels(pixels, colour.channel);
      row_.store(colour, group);
    }
  }

  HWY_INLINE void put_colours(int group) {
    Colour16 colour = primary_;
    if (!flat_) {
      for (int c = 0; c < 4; ++c) {
        colour.channel[c] = narrow({rounded(c, 2 * group), rounded(c, 2 * group + 1)});
      }
    }
    for (int i = 0; i < count_; ++i) unit_[i].apply(group, colour);
    for (Vec16& channel : colour.channel) channel = to_unorm8(Tag16(), channel);
    if (opaque_) {
      replace(pack_pixels(colour.channel), group);
    } else {
      row_.store(colour, group);
    }
  }

  // On a surface of fewer bits by what it holds of pixels (4.1.8).
  HWY_INLINE void replace(Pair<VecU> pixels, int group) {
    const TagU d;
    if (p_.format != ColourFormat::kRgba8) {
      pixels = {truncate_colour(d, truncation_, pixels.lower),
                truncate_colour(d, truncation_, pixels.upper)};
    }
    store_live(pixels, live_mask(group_bits(covered_, group)), pixels_ + group * kGroup);
  }

  const FragmentProgram& p_;
  Tile& tile_;
  const bool flat_;
  const bool opaque_;   // every fragment replaces the whole pixel
  const bool aligned_;  // no texture is turned
  const Truncation truncation_;
  RowWriter writer_ = nullptr;  // where pixels are not replaced
  Colour16 primary_{};          // if flat_
  SplitPlane colour_[4];        // else
  int count_ = 0;
  Unit unit_[kStripUnits];
  bool gives_texels_;  // the colours are texels, with these bits set
  uint32_t texel_bits_ = 0;
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
