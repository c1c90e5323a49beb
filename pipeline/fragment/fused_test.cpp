// The fused loop against the chain: the same bits in colour and depth/stencil for random states,
// planes and coverages.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string_view>

#include "pipeline/fragment/chain.h"
#include "pipeline/fragment/own_tile.h"
#include "pipeline/fragment/program.h"
#include "pipeline/simd.h"

namespace clearpipe::pipeline {
namespace {

class Fused : public ::testing::TestWithParam<int> {
 protected:
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  bool chance(int in) { return below(in) == 0; }
  float number(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }
  template <class E>
  E any(int count) {
    return static_cast<E>(below(count));
  }

  ImageRef image() {
    // Powers of two and others, down to one texel.
    static constexpr int kSizes[] = {1, 2, 3, 5, 8, 16, 30, 64, 100};
    return image(kSizes[below(9)], kSizes[below(9)]);
  }

  ImageRef image(int width, int height) {
    auto made = std::make_shared<Image>();
    for (bool last = false; !last;) {
      last = width == 1 && height == 1;
      ImageLevel level{width, height, Texels(static_cast<size_t>(width) * size_t(height))};
      for (uint32_t& texel : level.texels) texel = static_cast<uint32_t>(random_());
      made->levels.push_back(std::move(level));
      width = std::max(width / 2, 1);
      height = std::max(height / 2, 1);
    }
    return made;
  }

  CombineArgument argument(bool alpha, uint8_t enabled) {
    CombineArgument a;
    do {
      a.source = any<CombineSource>(11);
    } while (static_cast<int>(a.source) < 8 && (enabled >> static_cast<int>(a.source) & 1) == 0);
    a.operand = alpha ? (chance(2) ? CombineOperand::kAlpha : CombineOperand::kOneMinusAlpha)
                      : any<CombineOperand>(4);
    return a;
  }

  void combiner(int unit, uint8_t enabled, Combiner& c) {
    const auto texture = static_cast<CombineSource>(unit);
    if (chance(2)) {  // MODULATE or REPLACE
      c.rgb = chance(2) ? Combine::kModulate : Combine::kReplace;
      c.alpha = chance(2) ? Combine::kModulate : Combine::kReplace;
      c.rgb_argument[c.rgb == Combine::kModulate] = {texture, CombineOperand::kColour};
      c.alpha_argument[c.alpha == Combine::kModulate] = {texture, CombineOperand::kAlpha};
      if (c.alpha == Combine::kModulate) c.alpha_argument[0].operand = CombineOperand::kAlpha;
      return;
    }
    c.rgb = any<Combine>(9);
    c.alpha = any<Combine>(7);
    for (CombineArgument& a : c.rgb_argument) a = argument(false, enabled);
    for (CombineArgument& a : c.alpha_argument) a = argument(true, enabled);
    c.rgb_scale_log2 = static_cast<uint8_t>(below(3));
    c.alpha_scale_log2 = static_cast<uint8_t>(below(3));
  }

  void texture_units(FragmentState& state) {
    const uint8_t enabled = static_cast<uint8_t>(chance(3) ? 0 : chance(2) ? 1 : below(16));
    for (int u = 0; u < 4; ++u) {
      if ((enabled >> u & 1) == 0) continue;
      TextureUnit& unit = state.unit[static_cast<size_t>(u)];
      unit.enabled = true;
      unit.image = image();
      unit.sampler.wrap_s = any<Wrap>(chance(4) ? 3 : 2);
      unit.sampler.wrap_t = any<Wrap>(chance(4) ? 3 : 2);
      unit.sampler.min = any<Filter>(2);
      unit.sampler.mag = any<Filter>(2);
      unit.sampler.mip = any<MipFilter>(3);
      unit.sampler.max_level = static_cast<int>(unit.image->levels.size()) - 1;
      unit.sampler.lod_bias = chance(3) ? number(-2, 2) : 0.0f;
      unit.sampler.max_anisotropy = chance(6) ? 4.0f : 1.0f;
      unit.constant = {number(0, 1), number(0, 1), number(0, 1), number(0, 1)};
      combiner(u, enabled, unit.combiner);
    }
  }

  FragmentState state() {
    FragmentState s;
    texture_units(s);
    s.fog = chance(3) ? any<FogMode>(4) : FogMode::kNone;
    s.fog_colour = {number(0, 1), number(0, 1), number(0, 1), 1};
    s.alpha_test = chance(4);
    s.alpha_func = any<CompareFunc>(8);
    s.alpha_reference = number(0, 1);
    s.depth_test = chance(2);
    s.depth_write = !chance(4);
    s.depth_func = any<CompareFunc>(8);
    s.stencil.enabled = chance(4);
    s.stencil.func = any<CompareFunc>(8);
    s.stencil.reference = static_cast<uint8_t>(below(256));
    s.stencil.value_mask = static_cast<uint8_t>(below(256));
    s.stencil.write_mask = static_cast<uint8_t>(below(256));
    s.stencil.fail = any<StencilOp>(8);
    s.stencil.depth_fail = any<StencilOp>(8);
    s.stencil.pass = any<StencilOp>(8);
    s.blend.enabled = chance(2);
    s.blend.src_rgb = any<BlendFactor>(11);
    s.blend.dst_rgb = any<BlendFactor>(11);
    s.blend.src_alpha = any<BlendFactor>(11);
    s.blend.dst_alpha = any<BlendFactor>(11);
    s.blend.rgb = any<BlendEquation>(5);
    s.blend.alpha = any<BlendEquation>(5);
    s.logic_op_enabled = chance(6);
    s.logic_op = any<LogicOp>(16);
    s.colour_mask = static_cast<uint8_t>(chance(4) ? below(16) : 15);
    return s;
  }

  // One that is shaded in strips where coverage is narrow (strips-inl.h).
  FragmentState simple_state() {
    FragmentState s = state();
    s.fog = FogMode::kNone;
    s.alpha_test = false;
    const int enabled = 1 + below(3);
    for (int u = 0; u < kMaxTextureUnits; ++u) {
      TextureUnit& unit = s.unit[static_cast<size_t>(u)];
      unit = {};
      if ((enabled >> u & 1) == 0) continue;
      unit.enabled = true;
      unit.image = image();
      unit.sampler.wrap_s = any<Wrap>(2);
      unit.sampler.wrap_t = any<Wrap>(2);
      unit.sampler.min = unit.sampler.mag = any<Filter>(2);
      unit.sampler.mip = MipFilter::kNone;
      do {
        unit.combiner = {};
        combiner(u, static_cast<uint8_t>(enabled), unit.combiner);
      } while (unit.combiner.rgb != Combine::kModulate && unit.combiner.rgb != Combine::kReplace);
    }
    return s;
  }

  Plane plane(float value, float step) {
    return {number(-value, value), number(-step, step), number(-step, step)};
  }

  PrimitivePlanes planes() {
    PrimitivePlanes p;
    p.x_ref = number(0, 100);
    p.y_ref = number(0, 100);
    p.perspective = chance(2);
    p.flat_colour = chance(3);
    p.depth = plane(0.5f, 0.01f);
    p.inv_w = {number(1, 2), number(-0.004f, 0.004f), number(-0.004f, 0.004f)};
    p.fog = plane(1, 0.02f);
    for (Plane& c : p.colour) {
      c = p.flat_colour ? Plane{number(0, kColourOne), 0, 0} : plane(9000, 200);
    }
    const float step = chance(3) ? 0.2f : 0.02f;
    for (auto& unit : p.texture) {
      for (Plane& c : unit) c = plane(2, step);
      if (chance(5)) unit[0] = plane(chance(2) ? 1e30f : 4e6f, 1e4f);
      unit[3] = chance(2) ? Plane{1, 0, 0} : p.perspective ? p.inv_w : plane(3, 0.02f);
    }
    return p;
  }

  void compare(const FragmentProgram& program, const PrimitivePlanes& p, const Coverage& coverage) {
    auto fused = std::make_unique<OwnTile>();
    fused->x = 64 * below(4);
    fused->y = 32 * below(4);
    fused->mirror_height = chance(2) ? 200 : 0;
    for (int i = 0; i < kTilePixels; ++i) {
      fused->colour[i] = static_cast<uint32_t>(random_());
      fused->depth_stencil[i] = static_cast<uint32_t>(random_());
    }
    auto chain = std::make_unique<OwnTile>(*fused);
    shade(program, p, coverage, *fused);
    run_chain(program, p, coverage, *chain);
    for (int i = 0; i < kTilePixels; ++i) {
      ASSERT_EQ(fused->colour[i], chain->colour[i]) << "pixel " << i % 64 << ", " << i / 64;
      ASSERT_EQ(fused->depth_stencil[i], chain->depth_stencil[i])
          << "pixel " << i % 64 << ", " << i / 64;
    }
  }

  uint64_t noise() { return random_() | static_cast<uint64_t>(random_()) << 32; }

  std::mt19937 random_{static_cast<unsigned>(GetParam())};
};

using Program = std::unique_ptr<FragmentProgram, void (*)(FragmentProgram*)>;

Program make_program(const FragmentState& state, const FragmentTarget& target) {
  return {make_fragment_program(state, target, FragmentCoverage::kCentre),
          destroy_fragment_program};
}

TEST_P(Fused, GivesTheBitsOfTheChain) {
  const FragmentState s = state();
  FragmentTarget target = {true, true};
  if (chance(3)) target.format = any<ColourFormat>(4);
  if (chance(3)) target.depth_bits = 16;
  const Program program = make_program(s, target);
  const bool one_lane = std::string_view(simd_target_name()) == "SCALAR";
  ASSERT_EQ(program->fused == nullptr, one_lane);
  for (int round = 0; round < 3; ++round) {
    const PrimitivePlanes p = planes();
    Coverage coverage{};
    coverage.first_row = below(8);
    coverage.last_row = coverage.first_row + 1 + below(kTileHeight - coverage.first_row);
    for (uint64_t& row : coverage.rows) {
      const uint64_t some = noise();
      row = chance(2) ? ~uint64_t{0} : chance(2) ? some : some & 0xffff0000u;
    }
    compare(*program, p, coverage);
  }
}

// Narrow coverage, rectangles of it or any pixels; textures that are not turned, or are.
TEST_P(Fused, GivesTheBitsOfTheChainInStrips) {
  const FragmentState s = simple_state();  // which keeps the textures
  FragmentTarget target = {true, true};
  if (chance(3)) target.format = any<ColourFormat>(4);
  const Program program = make_program(s, target);
  for (int round = 0; round < 3; ++round) {
    PrimitivePlanes p = planes();
    p.perspective = chance(8);
    for (auto& unit : p.texture) {
      if (!chance(6)) unit[0].dy = 0;
      if (!chance(6)) unit[1].dx = 0;
      if (!chance(6)) unit[3] = {1, 0, 0};
    }
    Coverage coverage{};
    coverage.first_row = below(20);
    coverage.last_row = coverage.first_row + 1 + below(kTileHeight - coverage.first_row);
    const int width = 1 + below(chance(4) ? 64 : 33), column = below(65 - width);
    const uint64_t columns = ~uint64_t{0} >> (64 - width) << column;
    const bool rectangle = chance(2);
    for (int row = coverage.first_row; row < coverage.last_row; ++row) {
      coverage.rows[row] = rectangle ? columns : columns & (noise() | noise());
    }
    compare(*program, p, coverage);
  }
}

// Bilinear textures that repeat, a little turned, magnified or minified at most twice, over whole
// rows: their texels lie close together, but for those on both sides of an edge (whole_row-inl.h).
TEST_P(Fused, GivesTheBitsOfTheChainInWholeRows) {
  FragmentState s = simple_state();
  for (TextureUnit& unit : s.unit) {
    if (!unit.enabled) continue;
    unit.image = image(1 << (3 + below(6)), 1 << below(9));
    unit.sampler.wrap_s = unit.sampler.wrap_t = Wrap::kRepeat;
    unit.sampler.min = unit.sampler.mag = Filter::kLinear;
  }
  const Program program = make_program(s, {true, true});
  for (int round = 0; round < 3; ++round) {
    PrimitivePlanes p = planes();
    p.perspective = false;
    for (int u = 0; u < kMaxTextureUnits; ++u) {
      if (!s.unit[static_cast<size_t>(u)].enabled) continue;
      const ImageLevel& level = s.unit[static_cast<size_t>(u)].image->levels[0];
      const auto texels = [&](int size, float most) {
        return number(-most, most) / static_cast<float>(size);
      };
      // Near the origin, or so far that fixed point ends.
      const float reach = chance(4) ? 60000.0f : chance(3) ? 8300.0f : 300.0f;
      p.texture[u][0] = {texels(level.width, reach), texels(level.width, chance(2) ? 1.0f : 2.3f),
                         texels(level.width, 1)};
      p.texture[u][1] = {texels(level.height, reach), texels(level.height, 0.1f),
                         texels(level.height, 1)};
      p.texture[u][3] = {1, 0, 0};
    }
    Coverage coverage{};
    coverage.last_row = kTileHeight;
    for (uint64_t& row : coverage.rows) row = chance(4) ? noise() : ~uint64_t{0};
    compare(*program, p, coverage);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Fused, ::testing::Range(0, 2000));

}  // namespace
}  // namespace clearpipe::pipeline
