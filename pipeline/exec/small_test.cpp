// Batches of small primitives against shading each primitive by itself: the same bits in the tile,
// for random states, with primitives that overlap. Runs on the SIMD target that CLEARPIPE_SIMD
// selects.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <random>
#include <vector>

#include "pipeline/exec/frame_data.h"
#include "pipeline/fragment/own_tile.h"
#include "pipeline/fragment/small.h"

namespace clearpipe::pipeline {
namespace {

constexpr int kPrimitives = 120;
constexpr int kTileX = kTileWidth, kTileY = 3 * kTileHeight;

class Random {
 public:
  explicit Random(uint32_t seed) : engine_(seed) {}
  float real(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(engine_);
  }
  int below(int count) { return static_cast<int>(engine_() % static_cast<uint32_t>(count)); }
  bool coin() { return below(2) == 0; }
  uint64_t bits() { return uint64_t{engine_()} << 32 | engine_(); }

 private:
  std::mt19937 engine_;
};

ImageRef random_image(Random& random) {
  auto image = std::make_shared<Image>();
  image->levels.resize(kMaxLevels);
  for (int i = 0, size = 32; size > 0; ++i, size /= 2) {
    ImageLevel& level = image->levels[i];
    level.width = level.height = size;
    level.texels = Texels(static_cast<size_t>(size) * size);
    for (uint32_t& texel : level.texels) texel = static_cast<uint32_t>(random.bits());
  }
  return image;
}

void set_texture(Random& random, TextureUnit& unit, int number) {
  unit.enabled = true;
  unit.image = random_image(random);
  unit.sampler.min = unit.sampler.mag = random.coin() ? Filter::kLinear : Filter::kNearest;
  unit.sampler.mip = static_cast<MipFilter>(random.below(3));
  unit.sampler.max_level = unit.sampler.mip == MipFilter::kNone ? 0 : 5;
  unit.sampler.max_anisotropy = random.below(4) == 0 ? 4 : 1;
  unit.sampler.wrap_s = unit.sampler.wrap_t = random.coin() ? Wrap::kRepeat : Wrap::kClampToEdge;
  Combiner& combiner = unit.combiner;
  combiner.rgb = combiner.alpha = Combine::kModulate;
  const auto texture = static_cast<CombineSource>(number);
  combiner.rgb_argument[0] = {CombineSource::kPrevious, CombineOperand::kColour};
  combiner.rgb_argument[1] = {texture, CombineOperand::kColour};
  combiner.alpha_argument[0] = {CombineSource::kPrevious, CombineOperand::kAlpha};
  combiner.alpha_argument[1] = {texture, CombineOperand::kAlpha};
}

FragmentState random_fragment_state(Random& random) {
  FragmentState state;
  state.depth_test = random.coin();
  state.depth_write = random.coin();
  state.depth_func = random.coin() ? CompareFunc::kLess : CompareFunc::kGreaterEqual;
  if (random.below(3) == 0) {
    state.stencil.enabled = true;
    state.stencil.func = CompareFunc::kLessEqual;
    state.stencil.reference = 2;
    state.stencil.pass = StencilOp::kIncrement;
    state.stencil.depth_fail = StencilOp::kDecrementWrap;
  }
  if (random.coin()) {
    state.alpha_test = true;
    state.alpha_func = CompareFunc::kGreater;
    state.alpha_reference = 0.4f;
  }
  state.blend.enabled = random.coin();
  state.blend.src_rgb = state.blend.src_alpha = BlendFactor::kSrcAlpha;
  state.blend.dst_rgb = state.blend.dst_alpha = BlendFactor::kOneMinusSrcAlpha;
  state.fog = static_cast<FogMode>(random.below(4));
  state.fog_end = 3;
  state.fog_colour = {0.3f, 0.9f, 0.1f, 1};
  if (random.below(4) == 0) state.colour_mask = static_cast<uint8_t>(random.below(16));
  if (random.coin()) set_texture(random, state.unit[0], 0);
  if (random.coin()) set_texture(random, state.unit[1], 1);
  return state;
}

// A program of its own.
class Program {
 public:
  explicit Program(const FragmentState& state = {})
      : program_(make_fragment_program(state, {true, true}, FragmentCoverage::kCentre),
                 destroy_fragment_program) {}
  const FragmentProgram* get() const { return program_.get(); }

 private:
  std::unique_ptr<FragmentProgram, void (*)(FragmentProgram*)> program_;
};

struct Mesh {
  Packet packet;
  std::vector<float> records;
  std::vector<uint32_t> entries;
};

// Primitives in the tile and across its borders. `w_changes`: perspective is one of a primitive
// here and there, or of all.
Mesh random_mesh(Random& random, const VertexLayout& layout, bool w_changes) {
  Mesh mesh;
  mesh.records.resize(size_t{3} * kPrimitives * layout.stride);
  for (int i = 0; i < kPrimitives; ++i) {
    SmallPrimitive p{};
    const float* first = &mesh.records[size_t{3} * i * layout.stride];
    p.x = static_cast<int16_t>(kTileX - 7 + random.below(kTileWidth + 7));
    p.y = static_cast<int16_t>(kTileY - 7 + random.below(kTileHeight + 7));
    p.mask = random.bits() & random.bits();
    if (random.below(3) == 0) p.mask &= random.bits() & random.bits();
    p.kind = static_cast<PrimitiveKind>(random.below(5) == 0 ? random.below(2) : 2);
    p.size = p.kind == PrimitiveKind::kPoint ? 5.0f : (random.coin() ? 1.0f : -1.0f);
    p.back_facing = random.coin();
    const bool one_colour = random.below(3) == 0, one_w = !w_changes || random.coin();
    for (int k = 0; k < 3; ++k) {
      float* record = &mesh.records[(size_t{3} * i + k) * layout.stride];
      p.vertex[k] = static_cast<uint32_t>(3 * i + k);
      for (int f = 0; f < layout.stride; ++f) record[f] = random.real(0, 1);
      record[vertex_record::kWindow] = p.x + random.real(0, 8);
      record[vertex_record::kWindow + 1] = 400 - (p.y + random.real(0, 8));
      if (one_w) record[vertex_record::kWindow + 3] = k == 0 ? 0.7f : first[7];
      if (one_colour) std::copy_n(first + 12, 4, record + 12);
      record[vertex_record::kOutcode] = 0;
    }
    // As the lists of tiles have it: what has no pixel in the tile is not named.
    if (small_coverage(p.mask, p.x, p.y, kTileX, kTileY).mask != 0) {
      mesh.entries.push_back(kSmallEntry + static_cast<uint32_t>(mesh.packet.small.size()));
    }
    mesh.packet.small.push_back(p);
  }
  mesh.packet.ranges = {{0, 0, kPrimitives}, {1, 0, kPrimitives}};
  mesh.packet.records = {mesh.records.data(), mesh.records.data()};
  return mesh;
}

// The planes of a small primitive as those of one that is not.
PrimitivePlanes planes_of(const DrawState& draw, const float* records,
                          const SmallPrimitive& primitive) {
  PrimitiveRecord record;
  for (int k = 0; k < 3; ++k) {
    record.vertex[k] = records + primitive.vertex[k] * draw.setup.layout.stride;
  }
  record.kind = primitive.kind;
  record.size = primitive.size;
  record.back_facing = primitive.back_facing;
  PrimitivePlanes planes;
  make_planes(draw.setup, record, planes);
  return planes;
}

void shade_one(const DrawState& draw, const float* records, const SmallPrimitive& primitive,
               Tile& tile) {
  const SmallCoverage small =
      small_coverage(primitive.mask, primitive.x, primitive.y, tile.x, tile.y);
  Coverage coverage{};
  for (int j = 0; j < kSmallSide && small.row + j < kTileHeight; ++j) {
    coverage.rows[small.row + j] = (small.mask >> (8 * j) & 0xff) << small.column;
  }
  coverage.last_row = kTileHeight;
  shade(*draw.program, planes_of(draw, records, primitive), coverage, tile);
}

bool same(const OwnTile& a, const OwnTile& b) {
  return std::memcmp(a.memory.colour, b.memory.colour, sizeof(a.memory.colour)) == 0 &&
         std::memcmp(a.memory.depth_stencil, b.memory.depth_stencil,
                     sizeof(a.memory.depth_stencil)) == 0;
}

TEST(Small, BatchesGiveTheBitsOfSinglePrimitives) {
  int batched = 0;
  const auto shader = std::make_unique<SmallShader>();
  for (uint32_t seed = 0; seed < 150; ++seed) {
    Random random(seed);
    const FragmentState state = random_fragment_state(random);
    const Program program(state);
    DrawState draw;
    draw.program = program.get();
    draw.setup.inputs = fragment_inputs(*draw.program);
    draw.setup.mirror_height = 400;
    VertexState vertex;
    vertex.texture_units = draw.setup.inputs.texture_units;
    vertex.lighting = vertex.two_sided = random.coin();
    draw.setup.layout = make_vertex_layout(vertex);
    draw.setup.two_sided = vertex.two_sided;
    draw.setup.raster.flat_shade = random.below(5) == 0;
    draw.setup.raster.offset_fill = random.below(5) == 0;
    draw.setup.raster.offset_factor = 0.5f;
    std::vector<DrawRecord> draws(1);
    draws[0].state = &draw;
    if (!draws_small(draws[0])) continue;
    ++batched;
    const Mesh mesh = random_mesh(random, draw.setup.layout, random.coin());
    OwnTile tile;
    tile.x = kTileX;
    tile.y = kTileY;
    tile.mirror_height = 400;
    for (uint32_t& pixel : tile.memory.colour) pixel = static_cast<uint32_t>(random.bits());
    for (uint32_t& value : tile.memory.depth_stencil) value = static_cast<uint32_t>(random.bits());
    OwnTile expected = tile;
    const OwnTile before = tile;
    for (const uint32_t entry : mesh.entries) {
      shade_one(draw, mesh.records.data(), mesh.packet.small[entry & ~kSmallEntry], expected);
    }
    // In two parts, as if they came from two packets.
    const std::span<const uint32_t> entries = mesh.entries;
    ASSERT_EQ(shader->add(draws, mesh.packet, entries.first(30), tile), 30u);
    ASSERT_EQ(shader->add(draws, mesh.packet, entries.subspan(30), tile), entries.size() - 30);
    shader->flush();
    ASSERT_TRUE(same(tile, expected)) << "seed " << seed;
    if (state.depth_write && state.depth_test && !state.alpha_test) {
      EXPECT_FALSE(same(tile, before)) << "seed " << seed;
    }
  }
  EXPECT_GT(batched, 100);
}

// What is taken at once ends where a primitive is not small, or of a draw with another program.
TEST(Small, TakesOneProgramAtATime) {
  const Program program, other;
  DrawState states[2];
  std::vector<DrawRecord> draws(2);
  for (int i = 0; i < 2; ++i) {
    states[i].program = program.get();
    states[i].setup.inputs = fragment_inputs(*program.get());
    states[i].setup.layout = make_vertex_layout({});
    draws[i].state = &states[i];
  }
  Random random(1);
  Mesh mesh = random_mesh(random, states[0].setup.layout, false);
  mesh.packet.small[mesh.entries[7] & ~kSmallEntry].range = 1;
  OwnTile tile;
  tile.x = kTileX;
  tile.y = kTileY;
  const auto shader = std::make_unique<SmallShader>();
  EXPECT_EQ(shader->add(draws, mesh.packet, mesh.entries, tile), mesh.entries.size());
  states[1].program = other.get();
  EXPECT_EQ(shader->add(draws, mesh.packet, mesh.entries, tile), 7u);
  mesh.entries[4] &= ~kSmallEntry;
  EXPECT_EQ(shader->add(draws, mesh.packet, mesh.entries, tile), 4u);
}

}  // namespace
}  // namespace clearpipe::pipeline
