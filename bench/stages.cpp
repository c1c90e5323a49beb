// The stages alone, without the API: what a pixel costs in the fragment stages of kinds of state,
// and a vertex in the vertex stages. Programs of other kinds than these run the chain of stages,
// and CLEARPIPE_FUSED=0 shows what that costs; CLEARPIPE_SIMD picks the instructions.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/fragment/own_tile.h"
#include "pipeline/fragment/program.h"
#include "pipeline/simd.h"
#include "pipeline/vertex/vertex_stage.h"

namespace {

using namespace clearpipe::pipeline;

using ProgramPtr = std::unique_ptr<FragmentProgram, void (*)(FragmentProgram*)>;

// ---- Fragments: a whole tile -----------------------------------------------------------------

struct Kind {
  FragmentState state;
  PrimitivePlanes planes;
};

Kind flat() {
  Kind kind;
  kind.planes.flat_colour = true;
  for (Plane& c : kind.planes.colour) c = {kColourOne * 0.5f, 0, 0};
  kind.planes.depth = {0.5f, 0, 0};
  return kind;
}

Kind gouraud() {
  Kind kind = flat();
  kind.planes.flat_colour = false;
  for (Plane& c : kind.planes.colour) c = {0, kColourOne / 64.0f, 0};
  return kind;
}

Kind with_depth(Kind kind) {
  kind.state.depth_test = true;
  kind.state.depth_func = CompareFunc::kLessEqual;
  kind.planes.depth = {0.4f, 1e-4f, 1e-4f};
  return kind;
}

Kind with_stencil(Kind kind) {
  kind.state.stencil.enabled = true;
  kind.state.stencil.pass = StencilOp::kIncrementWrap;
  return kind;
}

Kind blended(Kind kind) {
  kind.state.blend.enabled = true;
  kind.state.blend.src_rgb = kind.state.blend.src_alpha = BlendFactor::kSrcAlpha;
  kind.state.blend.dst_rgb = kind.state.blend.dst_alpha = BlendFactor::kOneMinusSrcAlpha;
  return kind;
}

Kind with_fog_and_alpha_test(Kind kind) {
  kind.state.fog = FogMode::kLinear;
  kind.state.alpha_test = true;
  kind.state.alpha_func = CompareFunc::kGreater;
  kind.state.alpha_reference = 0.1f;
  kind.planes.fog = {0.2f, 0.01f, 0};
  return kind;
}

ImageRef image(int size) {
  std::mt19937 random(1);
  auto made = std::make_shared<Image>();
  for (; size > 0; size /= 2) {
    ImageLevel level{size, size, Texels(static_cast<size_t>(size) * static_cast<size_t>(size))};
    for (uint32_t& texel : level.texels) texel = static_cast<uint32_t>(random());
    made->levels.push_back(std::move(level));
  }
  return made;
}

// MODULATE on units 0 to `units` - 1, a texel for `1 / scale` pixels.
Kind textured(Kind kind, Filter filter, MipFilter mip, float scale, size_t units = 1) {
  const ImageRef shared = image(256);
  for (size_t u = 0; u < units; ++u) {
    TextureUnit& unit = kind.state.unit[u];
    unit.enabled = true;
    unit.image = shared;
    unit.sampler.min = unit.sampler.mag = filter;
    unit.sampler.mip = mip;
    unit.sampler.max_level = static_cast<int>(shared->levels.size()) - 1;
    unit.combiner.rgb = unit.combiner.alpha = Combine::kModulate;
    // MODULATE of table 3.16: the previous colour times the texture's.
    const auto texture = static_cast<CombineSource>(u);
    unit.combiner.rgb_argument[0] = {CombineSource::kPrevious, CombineOperand::kColour};
    unit.combiner.rgb_argument[1] = {texture, CombineOperand::kColour};
    unit.combiner.alpha_argument[0] = {CombineSource::kPrevious, CombineOperand::kAlpha};
    unit.combiner.alpha_argument[1] = {texture, CombineOperand::kAlpha};
    kind.planes.texture[u][0] = {0.1f, scale / 256, scale / 1024};
    kind.planes.texture[u][1] = {0.2f, -scale / 1024, scale / 256};
    kind.planes.texture[u][2] = {0, 0, 0};
    kind.planes.texture[u][3] = {1, 0, 0};
  }
  return kind;
}

void shade_tile(benchmark::State& run, const Kind& kind) {
  const auto tile = std::make_unique<OwnTile>();
  std::fill_n(tile->depth_stencil, kTilePixels, 0xffffff00u);  // far away
  Coverage coverage{};
  coverage.last_row = kTileHeight;
  for (uint64_t& row : coverage.rows) row = ~uint64_t{0};
  const ProgramPtr program(
      make_fragment_program(kind.state, {true, true}, FragmentCoverage::kCentre),
      destroy_fragment_program);
  for (auto _ : run) {
    shade(*program, kind.planes, coverage, *tile);
    benchmark::ClobberMemory();
  }
  run.counters["per pixel"] =
      benchmark::Counter(static_cast<double>(run.iterations()) * kTilePixels,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void add_fragment_stages() {
  constexpr MipFilter kNoMip = MipFilter::kNone, kMip = MipFilter::kLinear;
  const std::pair<const char*, Kind> kinds[] = {
      {"fragment/flat", flat()},
      {"fragment/flat, depth", with_depth(flat())},
      {"fragment/gouraud", gouraud()},
      {"fragment/gouraud, depth", with_depth(gouraud())},
      {"fragment/gouraud, depth, stencil", with_stencil(with_depth(gouraud()))},
      {"fragment/gouraud, blending", blended(gouraud())},
      {"fragment/gouraud, fog, alpha test", with_fog_and_alpha_test(gouraud())},
      {"fragment/nearest texture", textured(flat(), Filter::kNearest, kNoMip, 0.5f)},
      {"fragment/bilinear texture", textured(flat(), Filter::kLinear, kNoMip, 0.5f)},
      {"fragment/trilinear texture", textured(flat(), Filter::kLinear, kMip, 1.5f)},
      {"fragment/two bilinear textures", textured(gouraud(), Filter::kLinear, kNoMip, 0.5f, 2)},
      {"fragment/four bilinear textures", textured(gouraud(), Filter::kLinear, kNoMip, 0.5f, 4)},
      {"fragment/bilinear texture, depth, blending",
       blended(with_depth(textured(gouraud(), Filter::kLinear, kNoMip, 0.5f)))},
  };
  for (const auto& [name, kind] : kinds) {
    benchmark::RegisterBenchmark(name, [kind](benchmark::State& run) { shade_tile(run, kind); });
  }
}

// ---- Vertices: 4096 of them ------------------------------------------------------------------

constexpr size_t kVertices = 4096;

VertexState lit_by(int lights) {
  VertexState state;
  state.lighting = lights > 0;
  state.normalize = lights > 0;
  state.material.diffuse = state.material.specular = {0.5f, 0.5f, 0.5f, 1};
  state.material.shininess = 10;
  for (int i = 0; i < lights; ++i) {
    Light& light = state.lights[static_cast<size_t>(i)];
    light.enabled = true;
    light.positional = i % 2 == 1;
    light.diffuse = light.specular = {0.3f, 0.2f, 0.1f, 1};
    light.position = {0, 0.6f, 0.8f, light.positional ? 1.0f : 0.0f};
    light.half_vector = {0, 0.3162f, 0.9487f, 0};
  }
  return state;
}

void transform(benchmark::State& run, const VertexState& state) {
  std::mt19937 random(2);
  std::vector<float> positions(3 * kVertices);
  for (float& p : positions) p = static_cast<float>(random() >> 8) / 8388608.0f - 1;
  std::vector<uint32_t> elements(kVertices);
  for (size_t i = 0; i < kVertices; ++i) elements[i] = static_cast<uint32_t>(i);
  DrawCommand draw;
  draw.count = kVertices;
  for (const Attribute attribute : {Attribute::kPosition, Attribute::kNormal}) {
    AttributeSource& source = draw.attributes[static_cast<size_t>(attribute)];
    source.is_array = true;
    source.size = 3;
    source.stride = 3 * sizeof(float);
    source.pointer = reinterpret_cast<const std::byte*>(positions.data());
  }
  VertexJob job;
  job.draw = &draw;
  job.state = &state;
  job.viewport = {512, 384, 0.5f, 512, 384, 0.5f};
  job.layout = make_vertex_layout(state);
  job.elements = elements.data();
  job.count = kVertices;
  const size_t floats = kVertices * job.layout.stride;
  const std::unique_ptr<float[], void (*)(float*)> records(
      static_cast<float*>(std::aligned_alloc(64, floats * sizeof(float))),
      [](float* memory) { std::free(memory); });
  job.records = records.get();
  for (auto _ : run) {
    run_vertex_stages(job);
    benchmark::ClobberMemory();
  }
  run.counters["per vertex"] =
      benchmark::Counter(static_cast<double>(run.iterations()) * kVertices,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void add_vertex_stages() {
  for (const int lights : {0, 1, 2, 8}) {
    benchmark::RegisterBenchmark(
        ("vertex/" + std::to_string(lights) + " lights").c_str(),
        [state = lit_by(lights)](benchmark::State& run) { transform(run, state); });
  }
}

}  // namespace

int main(int argc, char** argv) {
  select_simd_target();
  benchmark::AddCustomContext("simd", simd_target_name());
  add_fragment_stages();
  add_vertex_stages();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
