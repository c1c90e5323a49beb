// Multisampled frames against an oracle that keeps four samples a pixel in double precision and
// follows the sections one sample at a time, without tiles, batches or planes. ctest runs it on
// each SIMD target.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "pipeline/exec/frame_scene.h"
#include "pipeline/raster/tile.h"

namespace clearpipe::pipeline {
namespace {

struct Place {
  double x, y;
};

struct Corner : Place {
  double z;
};

struct Sample {
  std::array<double, 4> colour{};
  double depth = 0;
  int stencil = 0;
};

struct Pixel {
  std::array<Sample, kSampleCount> sample;
  bool doubtful = false;  // something was too close to call in floating point
};

// Inside, outside, or too close to say.
enum class Answer { kNo, kYes, kDoubtful };
using Region = std::function<Answer(const Place&)>;
using Depth = std::function<double(const Place&)>;

class Oracle {
 public:
  RasterState raster;
  FragmentState fragment;

  void clear(const ClearCommand& command) {
    for (int y = command.rect.y0; y < command.rect.y1; ++y) {
      for (int x = command.rect.x0; x < command.rect.x1; ++x) {
        for (Sample& sample : pixel(x, y).sample) {
          for (int c = 0; c < 4 && command.colour; ++c) {
            if ((command.colour_mask >> c & 1) == 0) continue;
            sample.colour[c] = (command.colour_value >> (8 * c) & 255) / 255.0;
          }
          if (command.depth) sample.depth = command.depth_value / 16777215.0;
          const int kept = ~command.stencil_mask & sample.stencil;
          if (command.stencil) {
            sample.stencil = kept | (command.stencil_value & command.stencil_mask);
          }
        }
      }
    }
  }

  // 3.2.1: the region decides at the samples, or at the centre for all of them.
  void draw(const Region& region, const Depth& depth, std::array<double, 4> colour) {
    for (int y = raster.scissor.y0; y < raster.scissor.y1; ++y) {
      for (int x = raster.scissor.x0; x < raster.scissor.x1; ++x) {
        for (int s = 0; s < kSampleCount; ++s) {
          Place place = {x + 0.5, y + 0.5};
          if (raster.multisample) {
            place.x += kSamplePlaces[s].x / 256.0;
            place.y += kSamplePlaces[s].y / 256.0;
          }
          const Answer answer = region(place);
          if (answer == Answer::kDoubtful) pixel(x, y).doubtful = true;
          if (answer == Answer::kYes && (!raster.multisample || keeps(s, colour[3]))) {
            fragment_of(pixel(x, y), s, std::clamp(depth(place), 0.0, 1.0), colour);
          }
        }
      }
    }
  }

  Pixel& pixel(int x, int y) { return pixels_[static_cast<size_t>(y * kWidth + x)]; }

 private:
  // 4.1.3, with the functions that the pipeline chose.
  bool keeps(int sample, double alpha) const {
    if (fragment.alpha_to_coverage && sample >= alpha * kSampleCount) return false;
    if (!fragment.sample_coverage) return true;
    const bool covered = sample + 1 <= double{fragment.sample_coverage_value} * kSampleCount;
    return covered != fragment.sample_coverage_invert;
  }

  // 4.1.5 to 4.1.7 for one sample: stencil counts what passes, depth by LESS, blending over.
  void fragment_of(Pixel& pixel, int s, double depth, std::array<double, 4> colour) {
    Sample& sample = pixel.sample[static_cast<size_t>(s)];
    if (fragment.alpha_to_one && raster.multisample) colour[3] = 1;
    if (fragment.stencil.enabled && fragment.stencil.func == CompareFunc::kEqual &&
        sample.stencil != fragment.stencil.reference) {
      return;
    }
    if (fragment.depth_test) {
      if (std::fabs(depth - sample.depth) < 4e-6) pixel.doubtful = true;
      if (depth >= sample.depth) return;
      if (fragment.depth_write) sample.depth = depth;
    }
    if (fragment.stencil.enabled) sample.stencil = std::min(sample.stencil + 1, 255);
    for (int c = 0; c < 4; ++c) {
      if ((fragment.colour_mask >> c & 1) == 0) continue;
      double& stored = sample.colour[static_cast<size_t>(c)];
      const double value = colour[static_cast<size_t>(c)];
      stored = fragment.blend.enabled ? value * colour[3] + stored * (1 - colour[3]) : value;
    }
  }

  std::vector<Pixel> pixels_ = std::vector<Pixel>(kWidth * kHeight);
};

// 3.5.1, 3.5.3 on corners that are multiples of 1/256: exact in double precision.
Region triangle_region(std::array<Corner, 3> corners) {
  const auto area = [](const Place& a, const Place& b, const Place& c) {
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  };
  if (area(corners[0], corners[1], corners[2]) < 0) std::swap(corners[1], corners[2]);
  return [=](const Place& p) {
    for (size_t i = 0; i < 3; ++i) {
      const Place &a = corners[i], &b = corners[(i + 1) % 3];
      const double value = area(a, b, p);
      const bool owned = a.y > b.y || (a.y == b.y && b.x > a.x);
      if (value < 0 || (value == 0 && !owned)) return Answer::kNo;
    }
    return Answer::kYes;
  };
}

Depth triangle_depth(const std::array<Corner, 3>& c) {
  const double area = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (c[1].y - c[0].y);
  return [=](const Place& p) {
    const double b =
        ((p.x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (p.y - c[0].y)) / area;
    const double d =
        ((c[1].x - c[0].x) * (p.y - c[0].y) - (p.x - c[0].x) * (c[1].y - c[0].y)) / area;
    return c[0].z + b * (c[1].z - c[0].z) + d * (c[2].z - c[0].z);
  };
}

// 3.3.3.
Region point_region(const Place& centre, double size, bool sprite) {
  return [=](const Place& p) {
    const double dx = std::fabs(p.x - centre.x), dy = std::fabs(p.y - centre.y);
    const double distance = sprite ? std::max(dx, dy) : std::hypot(dx, dy);
    if (std::fabs(distance - size / 2) < 1e-9) return Answer::kDoubtful;
    return distance < size / 2 ? Answer::kYes : Answer::kNo;
  };
}

// 3.4.4: the rectangle of 3.4.2. Its corners are snapped to 1/256 pixel.
Region line_region(const Corner& a, const Corner& b, double width) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  return [=](const Place& p) {
    const double along = ((p.x - a.x) * dx + (p.y - a.y) * dy) / length;
    const double across = std::fabs((p.y - a.y) * dx - (p.x - a.x) * dy) / length;
    const double margin = std::min({along, length - along, width / 2 - across});
    if (std::fabs(margin) < 1.0 / 128) return Answer::kDoubtful;
    return margin > 0 ? Answer::kYes : Answer::kNo;
  };
}

Depth line_depth(const Corner& a, const Corner& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return [=](const Place& p) {
    return a.z + ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy) * (b.z - a.z);
  };
}

class Drawing {
 public:
  Scene scene{kSampleCount};
  Oracle oracle;

  explicit Drawing(unsigned seed) : random_(seed) {}

  void clear_something(bool everything) {
    ClearCommand clear;
    clear.rect = everything ? Rect{0, 0, kWidth, kHeight} : box();
    clear.colour = everything || one_of(2) == 0;
    clear.depth = everything || one_of(2) == 0;
    clear.stencil = everything || one_of(2) == 0;
    clear.colour_value = static_cast<uint32_t>(random_());
    clear.depth_value = 0xc00000;
    clear.colour_mask = everything ? 15 : static_cast<uint8_t>(one_of(16));
    clear.stencil_mask = everything ? 255 : static_cast<uint8_t>(one_of(256));
    ASSERT_TRUE(scene.frame.clear(clear));
    oracle.clear(clear);
  }

  void draw_something() {
    choose_state();
    const Vec4 colour = {channel(), channel(), channel(), channel()};
    const std::array<double, 4> expected = {colour.x, colour.y, colour.z, colour.w};
    switch (scene.raster.multisample ? one_of(6) : 5) {
      case 0: {
        const Corner at = corner();
        const int size = 1 + one_of(one_of(2) == 0 ? 4 : 60);
        scene.raster.point_sprite = one_of(2) == 0;
        scene.vertex.point_size = static_cast<float>(size);
        scene.draw(positions({at}), colour, Primitive::kPoints);
        oracle.draw(
            point_region(at, size, scene.raster.point_sprite), [=](const Place&) { return at.z; },
            expected);
        break;
      }
      case 1: {
        const Corner a = corner(), b = corner();
        const int width = 1 + one_of(9);
        scene.raster.line_width = static_cast<float>(width);
        scene.draw(positions({a, b}), colour, Primitive::kLines);
        oracle.draw(line_region(a, b, width), line_depth(a, b), expected);
        break;
      }
      default: {
        const std::array<Corner, 3> corners = {corner(), corner(), corner()};
        scene.draw(positions({corners[0], corners[1], corners[2]}), colour);
        oracle.draw(triangle_region(corners), triangle_depth(corners), expected);
        break;
      }
    }
  }

  int one_of(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

 private:
  float channel() { return static_cast<float>(one_of(256)) / 255; }
  Rect box() {
    const int x = one_of(kWidth), y = one_of(kHeight);
    return {x, y, x + 1 + one_of(kWidth - x), y + 1 + one_of(kHeight - y)};
  }
  // Inside the view, where clipping moves nothing.
  Corner corner() {
    Corner corner;
    corner.x = one_of(kWidth * 256) / 256.0;
    corner.y = one_of(kHeight * 256) / 256.0;
    corner.z = one_of(1 << 20) / double{1 << 20};
    return corner;
  }
  static std::vector<float> positions(const std::vector<Corner>& corners) {
    std::vector<float> xyz;
    for (const Corner& c : corners) {
      xyz.push_back(static_cast<float>(c.x * 2 / kWidth - 1));
      xyz.push_back(static_cast<float>(c.y * 2 / kHeight - 1));
      xyz.push_back(static_cast<float>(c.z * 2 - 1));
    }
    return xyz;
  }

  void choose_state() {
    RasterState& raster = scene.raster;
    raster.multisample = one_of(5) != 0;
    raster.scissor = one_of(4) == 0 ? box() : Rect{0, 0, kWidth, kHeight};
    FragmentState& f = scene.fragment;
    f = {};
    f.depth_test = one_of(3) != 0;
    f.depth_write = one_of(4) != 0;
    f.stencil.enabled = one_of(2) == 0;
    f.stencil.func = one_of(3) == 0 ? CompareFunc::kEqual : CompareFunc::kAlways;
    f.stencil.reference = static_cast<uint8_t>(one_of(3));
    f.stencil.pass = StencilOp::kIncrement;
    f.blend.enabled = one_of(3) == 0;
    f.blend.src_rgb = f.blend.src_alpha = BlendFactor::kSrcAlpha;
    f.blend.dst_rgb = f.blend.dst_alpha = BlendFactor::kOneMinusSrcAlpha;
    f.alpha_to_coverage = one_of(4) == 0;
    f.alpha_to_one = one_of(4) == 0;
    f.sample_coverage = one_of(4) == 0;
    f.sample_coverage_value = static_cast<float>(one_of(5)) / 4;
    f.sample_coverage_invert = one_of(2) == 0;
    if (one_of(5) == 0) f.colour_mask = static_cast<uint8_t>(one_of(16));
    oracle.raster = raster;
    oracle.fragment = f;
  }

  std::mt19937 random_;
};

// What the target holds for a sample, written down or stored.
uint32_t stored_sample(const ColourBuffer& buffer, int x, int y, int sample) {
  const UniformTiles& uniform = buffer.samples->uniform;
  const size_t place =
      sample * tile_count(kWidth, kHeight) * kTilePixels + place_in_tiles(kWidth, x, y);
  const size_t tile = place / kTilePixels;
  return uniform.is_uniform(tile) ? uniform.value[tile] : buffer.samples->values[place];
}

TEST(MultisampledFrame, EqualsTheOracle) {
  int doubtful = 0, mixed = 0, total = 0;
  for (unsigned round = 0; round < 80; ++round) {
    Drawing drawing(round);
    drawing.clear_something(true);
    for (int i = 0; i < 25; ++i) {
      if (drawing.one_of(8) == 0) drawing.clear_something(false);
      drawing.draw_something();
      if (drawing.one_of(10) == 0) drawing.scene.frame.finish();
    }
    drawing.scene.frame.finish();
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const Pixel& pixel = drawing.oracle.pixel(x, y);
        ++total;
        if (pixel.doubtful) {
          ++doubtful;
          continue;
        }
        const uint32_t found = drawing.scene.pixel(x, y);
        if (stored_sample(*drawing.scene.target.colour, x, y, 0) != found) ++mixed;
        for (int c = 0; c < 4; ++c) {
          double mean = 0;
          for (int s = 0; s < kSampleCount; ++s) {
            const uint32_t stored = stored_sample(*drawing.scene.target.colour, x, y, s);
            const double expected = pixel.sample[static_cast<size_t>(s)].colour[c] * 255;
            // Blending rounds to 8 bits each time.
            ASSERT_NEAR(stored >> (8 * c) & 255, expected, 2.5)
                << round << ": " << x << "," << y << " sample " << s << " component " << c;
            mean += (stored >> (8 * c) & 255) / double{kSampleCount};
          }
          ASSERT_EQ(found >> (8 * c) & 255, std::floor(mean + 0.5)) << x << "," << y;
        }
      }
    }
  }
  EXPECT_LT(doubtful, total / 10);
  EXPECT_GT(mixed, total / 20);
}

// Five steps from outside to inside.
TEST(MultisampledFrame, AnEdgeHasTheSharesOfItsSamples) {
  Scene scene(kSampleCount);
  ClearCommand clear;
  clear.rect = {0, 0, kWidth, kHeight};
  clear.colour = true;
  clear.colour_value = 0xff000000;
  ASSERT_TRUE(scene.frame.clear(clear));
  // The edge x = 10 + y * 23 / 70 grows by 23/70 of a pixel a row.
  const auto x = [](double at) { return static_cast<float>(at * 2 / kWidth - 1); };
  scene.draw({-1, -1, 0, x(10), -1, 0, x(33), 1, 0, -1, -1, 0, x(33), 1, 0, -1, 1, 0},
             {1, 1, 1, 1});
  scene.frame.finish();
  int steps[5] = {};
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      int covered = 0;
      for (const SamplePlace& place : kSamplePlaces) {
        const double y = row + 0.5 + place.y / 256.0;
        if (column + 0.5 + place.x / 256.0 < 10 + y * 23 / 70) ++covered;
      }
      const uint32_t expected[5] = {0, 64, 128, 191, 255};
      ASSERT_EQ(scene.pixel(column, row), 0xff000000u | expected[covered] * 0x10101u)
          << column << "," << row;
      ++steps[covered];
    }
  }
  for (const int count : steps) EXPECT_GT(count, 0);
}

// A point below the threshold is drawn as large as it, and fades (3.3, equations 3.1 and 3.2).
TEST(MultisampledFrame, SmallPointsFadeInsteadOfShrinking) {
  Scene scene(kSampleCount);
  scene.vertex.point_size = 4;
  scene.vertex.point_fade_threshold = 8;
  scene.draw({0, 0, 0}, {1, 1, 1, 1}, Primitive::kPoints);
  scene.frame.finish();
  EXPECT_EQ(scene.pixel(kWidth / 2, kHeight / 2), 0x40ffffffu);
  EXPECT_EQ(scene.pixel(kWidth / 2 + 3, kHeight / 2), 0x40ffffffu);
  EXPECT_EQ(scene.pixel(kWidth / 2 + 5, kHeight / 2), 0u);
}

}  // namespace
}  // namespace clearpipe::pipeline
