// What waits for a batch of small primitives (small-inl.h): a group of primitives with the list of
// their pixels, and which pixels are in the batch.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_FRAGMENT_SMALL_GROUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_FRAGMENT_SMALL_GROUP_INL_H_
#undef CLEARPIPE_FRAGMENT_SMALL_GROUP_INL_H_
#else
#define CLEARPIPE_FRAGMENT_SMALL_GROUP_INL_H_
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

#include "pipeline/fragment/batch.h"
#include "pipeline/setup/lane_planes-inl.h"
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

// Where in a tile's planes the pixels of a square lie, from its first one.
inline constexpr int kSquarePixels = kSmallSide * kSmallSide;
alignas(64) inline constexpr std::array<uint16_t, kSquarePixels> kSquareOffsets = [] {
  std::array<uint16_t, kSquarePixels> offsets{};
  for (int i = 0; i < kSquarePixels; ++i) {
    offsets[i] = static_cast<uint16_t>(i / kSmallSide * kTileWidth + i % kSmallSide);
  }
  return offsets;
}();

// What each fragment of a vector has of values that differ by the lane of its primitive.
class FragmentPlanes {
 public:
  using TagF = hn::ScalableTag<float>;
  using TagI = hn::RebindToSigned<TagF>;
  using LanePlane = setup::HWY_NAMESPACE::LanePlane;

  HWY_INLINE explicit FragmentPlanes(hn::Vec<TagI> lane)
      : float_index_(hn::IndicesFromVec(TagF(), lane)),
        whole_index_(hn::IndicesFromVec(TagI(), lane)) {}
  HWY_INLINE hn::Vec<TagF> operator()(hn::Vec<TagF> values) const {
    return hn::TableLookupLanes(values, float_index_);
  }
  HWY_INLINE hn::Vec<TagI> operator()(hn::Vec<TagI> values) const {
    return hn::TableLookupLanes(values, whole_index_);
  }
  HWY_INLINE LanePlane operator()(const LanePlane& plane) const {
    return {(*this)(plane.value), (*this)(plane.dx), (*this)(plane.dy)};
  }

 private:
  decltype(hn::IndicesFromVec(TagF(), hn::Vec<TagI>())) float_index_;
  decltype(hn::IndicesFromVec(TagI(), hn::Vec<TagI>())) whole_index_;
};

// Puts the lanes of a mask in front, in order; those behind them are anything. Vectors of up to 8
// lanes do it by a table: Highway's Compress copies one for each call of theirs.
class LanesInFront {
 public:
  using TagI = hn::ScalableTag<int32_t>;
  using VecI = hn::Vec<TagI>;

  HWY_INLINE explicit LanesInFront(hn::Mask<TagI> mask) : mask_(mask) {
    if constexpr (!kCompresses) {
      uint8_t bits[8] = {};
      hn::StoreMaskBits(TagI(), mask, bits);
      const auto* places = reinterpret_cast<const uint8_t*>(&kBitPlaces[bits[0]]);
      place_ = hn::PromoteTo(TagI(), hn::LoadU(hn::Rebind<uint8_t, TagI>(), places));
    }
  }
  HWY_INLINE VecI operator()(VecI v) const {
    if constexpr (kCompresses) {
      return hn::Compress(v, mask_);
    } else {
      return hn::TableLookupLanes(v, hn::IndicesFromVec(TagI(), place_));
    }
  }
  HWY_INLINE int count() const { return static_cast<int>(hn::CountTrue(TagI(), mask_)); }

 private:
  static constexpr bool kCompresses = hn::MaxLanes(TagI()) > 8;

  hn::Mask<TagI> mask_;
  VecI place_;
};

// Whether primitives of two draws can be in one group. Their programs are the same.
inline bool makes_same_planes(const SetupState& a, const SetupState& b) {
  if (&a == &b) return true;
  const RasterState &s = a.raster, &t = b.raster;
  return std::equal(std::begin(a.layout.texture_offset), std::end(a.layout.texture_offset),
                    std::begin(b.layout.texture_offset)) &&
         a.mirror_height == b.mirror_height && s.flat_shade == t.flat_shade && !s.offset_fill &&
         !t.offset_fill && s.point_sprite == t.point_sprite && s.coord_replace == t.coord_replace;
}

// Primitives of one kind, one in each lane, and their pixels: indices into a tile's planes, and in
// which lane the primitive is.
class SmallGroup {
 public:
  using TagI = hn::ScalableTag<int32_t>;
  using VecI = hn::Vec<TagI>;
  static constexpr int kLanes = setup::HWY_NAMESPACE::kPlaneLanes;

  // Whether there is a lane for another primitive, of that kind.
  bool takes(PrimitiveKind kind) const {
    return is_empty() || (primitives_.count != kLanes && kind == kind_);
  }

  HWY_INLINE void add(PrimitiveKind kind, int colour_offset, float size,
                      const float* const* vertex) {
    kind_ = kind;
    const int lane = primitives_.count++;
    for (int k = 0; k <= static_cast<int>(kind); ++k) {
      hwy::Prefetch(vertex[k] + vertex_record::kWindow);
      primitives_.vertex[k][lane] = vertex[k];
    }
    primitives_.colour_offset[lane] = colour_offset;
    primitives_.size[lane] = size;
  }

  // Lists pixels of the primitive that was added last: the mask has so many bits.
  HWY_INLINE void list(const SmallCoverage& coverage, int count) {
    const int lane = primitives_.count - 1, place = coverage.row * kTileWidth + coverage.column;
    constexpr int kFew = kCompresses ? 4 : 12;
    if (count == kSquarePixels) {
      list_square(place, lane);
    } else if (kCompresses && count > kFew) {
      list_vectors(coverage.mask, place, lane);
    } else if (count > kFew) {
      list_rows(coverage.mask, place, lane);
    } else {
      list_few(coverage.mask, count, place, lane);
    }
    listed_ += count;
  }

  void clear() { primitives_.count = listed_ = 0; }

  void make_planes(const SetupState& state, setup::HWY_NAMESPACE::LanePlanes& planes) {
    primitives_.pad();
    setup::HWY_NAMESPACE::make_lane_planes(state, kind_, primitives_, planes);
  }

  bool is_empty() const { return primitives_.count == 0; }
  int last_lane() const { return primitives_.count - 1; }
  PrimitiveKind kind() const { return kind_; }
  int pixels() const { return listed_; }

  // Of a vector of listed pixels: their primitives' lanes, and their indices into a tile's planes.
  // Behind the last pixel they are any.
  HWY_INLINE VecI lanes(int first) const {
    const TagI d;
    return hn::And(hn::PromoteTo(d, hn::LoadU(hn::Rebind<uint8_t, TagI>(), lane_ + first)),
                   hn::Set(d, kLanes - 1));
  }
  HWY_INLINE VecI offsets(int first) const {
    const TagI d;
    return hn::And(hn::PromoteTo(d, hn::LoadU(hn::Rebind<uint16_t, TagI>(), offset_ + first)),
                   hn::Set(d, kTilePixels - 1));
  }

 private:
  // Whether a vector's lanes can be put in front by an instruction, and how many pixels are written
  // at a time, at most.
  static constexpr bool kCompresses = hn::MaxLanes(TagI()) == 16;
  static constexpr int kListed = kCompresses ? 16 : 8;

  // Lists the set bits of a mask, four at a time: most masks have no more, and none of what it
  // takes to list a few of them depends on their number.
  HWY_INLINE void list_few(uint64_t mask, int count, int place, int lane) {
    constexpr uint64_t kEach = 0x0001000100010001u;
    const uint32_t lanes = static_cast<uint32_t>(lane) * 0x01010101u;
    const uint64_t places = static_cast<uint64_t>(place) * kEach;
    static_assert(kTileWidth == kSmallSide * 8);
    for (int i = listed_; i < listed_ + count; i += 4) {
      uint64_t pixels = 0;  // of the square, 16 bits each
      for (int j = 0; j < 4; ++j) {
        // With a bit that stops the search, there is no branch.
        const int pixel = std::countr_zero(mask | uint64_t{1} << 63);
        pixels |= static_cast<uint64_t>(pixel) << (16 * j);
        mask &= mask - 1;
      }
      pixels += places + (pixels & 0x38 * kEach) * 7;
      std::memcpy(offset_ + i, &pixels, sizeof(pixels));
      std::memcpy(lane_ + i, &lanes, sizeof(lanes));
    }
  }

  // The same of a mask that is full.
  HWY_INLINE void list_square(int place, int lane) {
    const hn::CappedTag<uint16_t, kSquarePixels> d;
    const hn::CappedTag<uint8_t, kSquarePixels> d8;
    for (int i = 0; i < kSquarePixels; i += static_cast<int>(hn::MaxLanes(d))) {
      const auto in_square = hn::Load(d, kSquareOffsets.data() + i);
      hn::StoreU(hn::Add(hn::Set(d, static_cast<uint16_t>(place)), in_square), d,
                 offset_ + listed_ + i);
    }
    for (int i = 0; i < kSquarePixels; i += static_cast<int>(hn::MaxLanes(d8))) {
      hn::StoreU(hn::Set(d8, static_cast<uint8_t>(lane)), d8, lane_ + listed_ + i);
    }
  }

  // Two rows of any mask at a time, without branches.
  HWY_INLINE void list_vectors(uint64_t mask, int place, int lane) {
    const hn::CappedTag<int32_t, kListed> d;
    const hn::Rebind<uint16_t, decltype(d)> d16;
    const hn::Rebind<uint8_t, decltype(d)> d8;
    const auto first = hn::Set(d16, static_cast<uint16_t>(place));
    const auto lanes = hn::Set(d8, static_cast<uint8_t>(lane));
    int at = listed_;
    for (int i = 0; i < kSquarePixels; i += kListed) {
      const auto in_square = hn::PromoteTo(d, hn::Load(d16, kSquareOffsets.data() + i));
      const uint64_t bits = mask >> i;
      uint8_t bytes[8];
      std::memcpy(bytes, &bits, sizeof(bits));
      const auto pixels = hn::Compress(in_square, hn::LoadMaskBits(d, bytes));
      hn::StoreU(hn::Add(hn::DemoteTo(d16, pixels), first), d16, offset_ + at);
      hn::StoreU(lanes, d8, lane_ + at);
      at += std::popcount(bits & ((1u << kListed) - 1));
    }
  }

  // The same a row at a time, for masks of many pixels.
  HWY_NOINLINE void list_rows(uint64_t mask, int place, int lane) {
    const hn::CappedTag<uint16_t, kListed> d;
    const hn::Rebind<uint8_t, decltype(d)> d8;
    const uint64_t lanes = static_cast<uint64_t>(lane) * 0x0101010101010101u;
    int at = listed_;
    for (int row = 0; row < kSmallSide; ++row, mask >>= kSmallSide, place += kTileWidth) {
      const auto* places = reinterpret_cast<const uint8_t*>(&kBitPlaces[mask & 0xff]);
      const auto first = hn::Set(d, static_cast<uint16_t>(place));
      for (int i = 0; i < kListed; i += static_cast<int>(hn::MaxLanes(d))) {
        const auto column = hn::PromoteTo(d, hn::LoadU(d8, places + i));
        hn::StoreU(hn::Add(first, column), d, offset_ + at + i);
      }
      std::memcpy(lane_ + at, &lanes, sizeof(lanes));
      at += std::popcount(mask & 0xff);
    }
  }

  PrimitiveKind kind_ = PrimitiveKind::kTriangle;
  setup::HWY_NAMESPACE::LanePrimitives primitives_;
  int listed_ = 0;
  // A few more are written behind the last.
  alignas(64) uint16_t offset_[kBatchSize + kListed];
  alignas(64) uint8_t lane_[kBatchSize + kListed];
};

// A mask of pixels in squares of 8x8 of a tile, across four of which it may lie.
struct SquareParts {
  // Squares of a row, with one more at its end, and rows with one more above.
  static constexpr int kStride = kTileWidth / kSmallSide + 1;
  static constexpr int kSquares = kStride * (kTileHeight / kSmallSide + 1);

  int first;         // the square that the mask begins in
  uint64_t bits[4];  // of that square, the next, and those above the two
  static constexpr int kPlace[4] = {0, 1, kStride, kStride + 1};

  HWY_INLINE explicit SquareParts(const SmallCoverage& coverage)
      : first(coverage.row / kSmallSide * kStride + coverage.column / kSmallSide) {
    constexpr uint64_t kEachRow = 0x0101010101010101u;
    const int dx = coverage.column % kSmallSide, dy = coverage.row % kSmallSide;
    const uint64_t mask = coverage.mask;
    const uint64_t right_columns = kEachRow * (0xffu >> (kSmallSide - dx));
    const uint64_t left = mask << dx & ~right_columns;
    const uint64_t right = mask >> (kSmallSide - dx) & right_columns;
    // Rows that move on to the next square: all 64 bits when dy is 0, so in two steps.
    const auto above = [dy](uint64_t m) { return m >> (56 - kSmallSide * dy) >> kSmallSide; };
    bits[0] = left << kSmallSide * dy;
    bits[1] = right << kSmallSide * dy;
    bits[2] = above(left);
    bits[3] = above(right);
  }
};

// The same of a mask that lies in one square, as those of narrow primitives do.
struct WholeSquare {
  int first;
  uint64_t bits;

  HWY_INLINE explicit WholeSquare(const SmallCoverage& coverage)
      : first(coverage.row / kSmallSide * SquareParts::kStride + coverage.column / kSmallSide),
        bits(coverage.mask) {}
};

// Pixels of a tile that something is about to be done to, in squares of 8x8 as masks have them.
class PendingPixels {
 public:
  HWY_INLINE PendingPixels() { forget(); }

  // Notes the pixels of a mask; false, and nothing is noted, when one is there already.
  HWY_INLINE bool note(const SquareParts& parts) {
    if (has(parts)) return false;
    note_any(parts);
    return true;
  }
  HWY_INLINE bool note(const WholeSquare& whole) {
    if (has(whole)) return false;
    note_any(whole);
    return true;
  }

  // The same whether one is there or not.
  HWY_INLINE void note_any(const SquareParts& parts) {
    uint64_t* const square = square_ + parts.first;
    for (int i = 0; i < 4; ++i) square[SquareParts::kPlace[i]] |= parts.bits[i];
  }
  HWY_INLINE void note_any(const WholeSquare& whole) { square_[whole.first] |= whole.bits; }

  // Notes what the other has, too.
  HWY_INLINE void note(const PendingPixels& other) {
    note_vectors(other, std::make_index_sequence<kWholeVectors / kStep>());
  }

  // Whether one of the pixels is noted.
  HWY_INLINE bool has(const SquareParts& parts) const {
    const uint64_t* const square = square_ + parts.first;
    uint64_t common = 0;
    for (int i = 0; i < 4; ++i) common |= square[SquareParts::kPlace[i]] & parts.bits[i];
    return common != 0;
  }

  HWY_INLINE bool has(const WholeSquare& whole) const {
    return (square_[whole.first] & whole.bits) != 0;
  }

  void forget() { forget_vectors(std::make_index_sequence<kWholeVectors / kStep>()); }

 private:
  static constexpr int kWholeVectors = (SquareParts::kSquares + 7) / 8 * 8;
  using TagSquares = hn::ScalableTag<uint64_t>;
  static constexpr int kStep = static_cast<int>(hn::MaxLanes(TagSquares()));
  static_assert(kWholeVectors % kStep == 0);

  // No loops, which compilers make slow string instructions of.
  template <size_t... i>
  HWY_INLINE void forget_vectors(std::index_sequence<i...>) {
    const TagSquares d;
    (hn::Store(hn::Zero(d), d, square_ + i * kStep), ...);
  }
  template <size_t... i>
  HWY_INLINE void note_vectors(const PendingPixels& other, std::index_sequence<i...>) {
    const TagSquares d;
    const auto both = [&](size_t at) HWY_ATTR {
      return hn::Or(hn::Load(d, square_ + at), hn::Load(d, other.square_ + at));
    };
    (hn::Store(both(i * kStep), d, square_ + i * kStep), ...);
  }

  alignas(64) uint64_t square_[kWholeVectors];
};

// What batches need while something is done to them, so that one is enough for all.
struct SmallScratch {
  FragmentBatch batch;
  // Of the fragments that a group leaves: their lanes, and what the depth test makes of the tile.
  alignas(64) int32_t lane_of[kBatchSize + SmallGroup::kLanes];
  alignas(64) int32_t depth_of[kBatchSize + SmallGroup::kLanes];
};

}  // namespace clearpipe::pipeline::fragment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
