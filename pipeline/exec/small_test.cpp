// Batches of small primitives against shading each primitive by itself: the same bits in the tile,
// for random states, with primitives that overlap. Runs on the SIMD target that CLEARPIPE_SIMD
// selects.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <random>
#include <vector>

#include "pipeline/exec/frame_data.h"
#include "pipeline/fragment/own_tile.h"
#include "pipeline/fragment/small.h"
#include "pipeline/raster/coverage.h"

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
  if (random.below(3) == 0) return state;  // colours are written as they are
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
  explicit Program(const FragmentState& state = {},
                   FragmentCoverage coverage = FragmentCoverage::kCentre)
      : program_(make_fragment_program(state, {true, true}, coverage), destroy_fragment_program) {}
  const FragmentProgram* get() const { return program_.get(); }

 private:
  std::unique_ptr<FragmentProgram, void (*)(FragmentProgram*)> program_;
};

struct Mesh {
  Packet packet;  // of what follows
  std::vector<SmallPrimitive> small;
  std::vector<const float*> range_records;
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
      mesh.entries.push_back(kSmallEntry + static_cast<uint32_t>(mesh.small.size()));
    }
    mesh.small.push_back(p);
  }
  mesh.packet.ranges = {{0, 0, kPrimitives}, {1, 0, kPrimitives}};
  mesh.range_records = {mesh.records.data(), mesh.records.data()};
  mesh.packet.small = mesh.small;
  mesh.packet.records = mesh.range_records;
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

// A draw of a random state.
struct RandomDraw {
  FragmentState fragment;
  Program program;
  DrawState state;
  DrawList draws;

  explicit RandomDraw(Random& random, FragmentCoverage coverage = FragmentCoverage::kCentre)
      : fragment(random_fragment_state(random)), program(fragment, coverage) {
    state.program = program.get();
    SetupState& setup = state.setup;
    setup.coverage = coverage;
    setup.inputs = fragment_inputs(*state.program);
    setup.mirror_height = 400;
    VertexState vertex;
    vertex.texture_units = setup.inputs.texture_units;
    vertex.lighting = vertex.two_sided = random.coin();
    setup.layout = make_vertex_layout(vertex);
    setup.two_sided = vertex.two_sided;
    setup.raster.flat_shade = random.below(5) == 0;
    setup.raster.offset_fill = random.below(5) == 0;
    setup.raster.offset_factor = 0.5f;
    DrawRecord draw;
    draw.state = &state;
    draws.push_back(draw);
  }
};

OwnTile random_tile(Random& random) {
  OwnTile tile;
  tile.x = kTileX;
  tile.y = kTileY;
  tile.mirror_height = 400;
  for (uint32_t& pixel : tile.memory.colour) pixel = static_cast<uint32_t>(random.bits());
  for (uint32_t& value : tile.memory.depth_stencil) value = static_cast<uint32_t>(random.bits());
  return tile;
}

TEST(Small, BatchesGiveTheBitsOfSinglePrimitives) {
  int batched = 0;
  const auto shader = std::make_unique<SmallShader>();
  for (uint32_t seed = 0; seed < 150; ++seed) {
    Random random(seed);
    const RandomDraw draw(random);
    if (!draws_small(draw.draws[0])) continue;
    ++batched;
    const Mesh mesh = random_mesh(random, draw.state.setup.layout, random.coin());
    OwnTile tile = random_tile(random);
    OwnTile expected = tile;
    const OwnTile before = tile;
    for (const uint32_t entry : mesh.entries) {
      shade_one(draw.state, mesh.records.data(), mesh.packet.small[entry & ~kSmallEntry], expected);
    }
    // In two parts, as if they came from two packets.
    const std::span<const uint32_t> entries = mesh.entries;
    ASSERT_EQ(shader->add(draw.draws, mesh.packet, entries.first(30), tile), 30u);
    ASSERT_EQ(shader->add(draw.draws, mesh.packet, entries.subspan(30), tile), entries.size() - 30);
    shader->flush();
    ASSERT_TRUE(same(tile, expected)) << "seed " << seed;
    const FragmentState& state = draw.fragment;
    if (state.depth_write && state.depth_test && !state.alpha_test) {
      EXPECT_FALSE(same(tile, before)) << "seed " << seed;
    }
  }
  EXPECT_GT(batched, 100);
}

// Draws with different programs, a few primitives of each in turns, cover each other: their batches
// go on side by side, but a pixel sees them in order.
TEST(Small, ProgramsInTurnsGiveTheBitsOfSinglePrimitives) {
  const auto shader = std::make_unique<SmallShader>();
  int seen = 0;
  for (uint32_t seed = 2000; seed < 2080; ++seed) {
    Random random(seed);
    std::vector<std::unique_ptr<RandomDraw>> draws;
    std::vector<Mesh> meshes;
    while (draws.size() < 3) {
      auto draw = std::make_unique<RandomDraw>(random);
      if (!draws_small(draw->draws[0])) continue;
      meshes.push_back(random_mesh(random, draw->state.setup.layout, random.coin()));
      draws.push_back(std::move(draw));
    }
    OwnTile tile = random_tile(random), expected = tile;
    std::array<size_t, 3> next{};
    for (int turn = 0; turn < 60; ++turn) {
      const auto i = static_cast<size_t>(random.below(3));
      const Mesh& mesh = meshes[i];
      const size_t count =
          std::min(static_cast<size_t>(1 + random.below(5)), mesh.entries.size() - next[i]);
      if (count == 0) continue;
      const auto entries = std::span<const uint32_t>(mesh.entries).subspan(next[i], count);
      next[i] += count;
      for (const uint32_t entry : entries) {
        shade_one(draws[i]->state, mesh.records.data(), mesh.packet.small[entry & ~kSmallEntry],
                  expected);
      }
      ASSERT_EQ(shader->add(draws[i]->draws, mesh.packet, entries, tile), count);
      ++seen;
    }
    shader->flush();
    ASSERT_TRUE(same(tile, expected)) << "seed " << seed;
  }
  EXPECT_GT(seen, 2000);
}

// A thin triangle or line through the tile, or a small box: anything but much of a row.
bool random_narrow(Random& random, const SetupState& state, float* records, PrimitiveRecord& out) {
  const int stride = state.layout.stride;
  const float x = kTileX + random.real(-20, kTileWidth + 20);
  const float y = kTileY + random.real(-20, kTileHeight + 20);
  const float dx = random.real(-60, 60), dy = random.real(-40, 40);
  const bool one_colour = random.coin(), one_w = random.coin();
  for (int k = 0; k < 3; ++k) {
    float* record = records + k * stride;
    for (int f = 0; f < stride; ++f) record[f] = random.real(0, 1);
    record[vertex_record::kWindow] = x + (k == 0 ? 0 : dx) + random.real(-3, 3);
    record[vertex_record::kWindow + 1] = 400 - (y + (k == 0 ? 0 : dy) + random.real(-3, 3));
    if (one_w) record[vertex_record::kWindow + 3] = k == 0 ? 0.7f : records[7];
    if (one_colour) std::copy_n(records + 12, 4, record + 12);
    record[vertex_record::kOutcode] = 0;
  }
  const float* v[3] = {records, records + stride, records + 2 * stride};
  return random.coin() ? setup_line(state, v[0], v[1], out)
                       : setup_triangle(state, v[0], v[1], v[2], out);
}

// Adds a narrow primitive to the shader, and draws it by itself in the tile that is expected; false
// when it covers nothing.
bool draw_both_ways(const DrawState& draw, const PrimitiveRecord& primitive, SmallShader& shader,
                    OwnTile& tile, OwnTile& expected) {
  Coverage coverage;
  if (!cover_tile(primitive, tile.x, tile.y, coverage)) return false;
  CoveredSquares squares;
  EXPECT_TRUE(cover_squares(primitive, tile.x, tile.y, squares));
  PrimitivePlanes planes;
  make_planes(draw.setup, primitive, planes);
  shade(*draw.program, planes, coverage, expected);
  shader.add(draw, primitive, squares, tile);
  return true;
}

// Narrow primitives among small ones, as back.cpp adds them, against each by itself.
TEST(Small, NarrowPrimitivesGiveTheBitsOfSingleOnes) {
  const auto shader = std::make_unique<SmallShader>();
  int narrow = 0;
  for (uint32_t seed = 1000; seed < 1120; ++seed) {
    Random random(seed);
    RandomDraw random_draw(random);
    DrawState& draw = random_draw.state;
    if (!draws_small(random_draw.draws[0])) continue;
    draw.setup.bounds = {0, 0, kTileX + kTileWidth - random.below(9), kTileY + kTileHeight};
    draw.setup.raster.line_width = static_cast<float>(1 + random.below(6));
    const Mesh mesh = random_mesh(random, draw.setup.layout, random.coin());
    OwnTile tile = random_tile(random), expected = tile;
    std::vector<std::vector<float>> records;  // a batch may read them until it is shaded
    for (const uint32_t entry : mesh.entries) {
      shade_one(draw, mesh.records.data(), mesh.packet.small[entry & ~kSmallEntry], expected);
      ASSERT_EQ(shader->add(random_draw.draws, mesh.packet, {&entry, 1}, tile), 1u);
      PrimitiveRecord primitive;
      records.emplace_back(size_t{3} * draw.setup.layout.stride);
      if (random_narrow(random, draw.setup, records.back().data(), primitive) &&
          draw_both_ways(draw, primitive, *shader, tile, expected)) {
        ++narrow;
      }
    }
    shader->flush();
    ASSERT_TRUE(same(tile, expected)) << "seed " << seed;
  }
  EXPECT_GT(narrow, 5000);
}

// An antialiased point or line that touches the tile, or nearly.
bool random_smooth(Random& random, const SetupState& state, float* records, PrimitiveRecord& out) {
  const int stride = state.layout.stride;
  const float x = kTileX + random.real(-4, kTileWidth + 4);
  const float y = kTileY + random.real(-4, kTileHeight + 4);
  const float dx = random.real(-60, 60), dy = random.below(5) == 0 ? 0 : random.real(-40, 40);
  for (int k = 0; k < 2; ++k) {
    float* record = records + k * stride;
    for (int f = 0; f < stride; ++f) record[f] = random.real(0, 1);
    record[vertex_record::kWindow] = x + (k == 0 ? 0 : dx);
    record[vertex_record::kWindow + 1] = 400 - (y + (k == 0 ? 0 : dy));
    record[vertex_record::kPointSize] = random.real(0.5f, 18);
    record[vertex_record::kOutcode] = 0;
  }
  return random.coin() ? setup_line(state, records, records + stride, out)
                       : setup_point(state, records, out);
}

// Antialiased points and lines, many at once, against each by itself.
TEST(Small, AntialiasedPrimitivesGiveTheBitsOfSingleOnes) {
  const auto shader = std::make_unique<SmallShader>();
  int points = 0, lines = 0;
  for (uint32_t seed = 3000; seed < 3100; ++seed) {
    Random random(seed);
    RandomDraw random_draw(random, FragmentCoverage::kSmooth);
    DrawState& draw = random_draw.state;
    if (!draws_narrow(random_draw.draws[0])) continue;
    ASSERT_FALSE(draws_small(random_draw.draws[0]));
    draw.setup.bounds = {0, 0, kTileX + kTileWidth - random.below(9), kTileY + kTileHeight};
    draw.setup.raster.line_width = random.real(0.5f, 7);
    OwnTile tile = random_tile(random), expected = tile;
    std::vector<std::vector<float>> records;
    for (int i = 0; i < 120; ++i) {
      PrimitiveRecord primitive;
      records.emplace_back(size_t{2} * draw.setup.layout.stride);
      if (random_smooth(random, draw.setup, records.back().data(), primitive) &&
          draw_both_ways(draw, primitive, *shader, tile, expected)) {
        ++(primitive.kind == PrimitiveKind::kPoint ? points : lines);
      }
    }
    shader->flush();
    ASSERT_TRUE(same(tile, expected)) << "seed " << seed;
  }
  EXPECT_GT(points, 2000);
  EXPECT_GT(lines, 2000);
}

// What is taken at once ends where a primitive is not small, or of a draw with another program.
TEST(Small, TakesOneProgramAtATime) {
  const Program program, other;
  DrawState states[2];
  DrawList draws;
  for (int i = 0; i < 2; ++i) {
    states[i].program = program.get();
    states[i].setup.inputs = fragment_inputs(*program.get());
    states[i].setup.layout = make_vertex_layout({});
    DrawRecord draw;
    draw.state = &states[i];
    draws.push_back(draw);
  }
  Random random(1);
  Mesh mesh = random_mesh(random, states[0].setup.layout, false);
  mesh.small[mesh.entries[7] & ~kSmallEntry].range = 1;
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
