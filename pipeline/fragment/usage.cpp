// The counter of programs: see usage.h.
// SPDX-License-Identifier: MIT
#include "pipeline/fragment/usage.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "pipeline/fragment/chain.h"

namespace clearpipe::pipeline {

struct UsageEntry {
  std::array<std::atomic<uint64_t>, kUsageForms> pixels{};
};

namespace {

constexpr const char* kStageNames[] = {
#define FRAGMENT_STAGE(name) #name,
#include "pipeline/fragment/stages.def"
#undef FRAGMENT_STAGE
};
constexpr const char* kFormNames[kUsageForms] = {"fused", "small", "chain", "samples"};

const char* name_of(Filter filter) { return filter == Filter::kLinear ? "linear" : "nearest"; }

const char* name_of(Wrap wrap) {
  switch (wrap) {
    case Wrap::kRepeat:
      return "repeat";
    case Wrap::kClampToEdge:
      return "clamp";
    case Wrap::kMirroredRepeat:
      break;
  }
  return "mirror";
}

// "linear/nearest mipmap_linear repeat clamp": min and mag filter, mipmaps, wrap of s and t.
std::string describe(const SampleState& sample) {
  const Sampler& sampler = sample.sampler;
  std::string text = name_of(sampler.min);
  if (sampler.mag != sampler.min) text += std::string("/") + name_of(sampler.mag);
  if (sampler.mip != MipFilter::kNone) {
    text += sampler.mip == MipFilter::kLinear ? " mipmap_linear" : " mipmap_nearest";
  }
  if (sampler.max_anisotropy > 1) text += " anisotropic";
  text += std::string(" ") + name_of(sampler.wrap_s);
  if (sampler.wrap_t != sampler.wrap_s) text += std::string("x") + name_of(sampler.wrap_t);
  if (sample.is_cube()) text += " cube";
  return text;
}

// The stages in order; textures with their samplers.
std::string describe(const FragmentProgram& program) {
  std::string text = program.early_depth ? "early_depth" : "";
  for (int i = 0; i < program.step_count; ++i) {
    const ChainStep& step = program.steps[i];
    if (!text.empty()) text += ", ";
    text += kStageNames[static_cast<int>(step.stage)];
    if (step.stage == FragmentStage::sample_texture) {
      text += std::to_string(step.unit) + " (" + describe(program.unit[step.unit].sample) + ")";
    } else if (step.stage == FragmentStage::texture_environment) {
      text += std::to_string(step.unit);
    }
  }
  return text;
}

// Lives until the library is unloaded, and then prints.
class Table {
 public:
  explicit Table(const char* where) : where_(where) {}
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;
  ~Table() { print(); }

  UsageEntry* find(const FragmentProgram& program) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return &entries_[describe(program)];
  }

 private:
  struct Line {
    uint64_t pixels;
    int form;
    const std::string* key;
  };

  void print() const {
    std::vector<Line> lines;
    uint64_t all = 0, of_form[kUsageForms] = {};
    for (const auto& [key, entry] : entries_) {
      for (int form = 0; form < kUsageForms; ++form) {
        const uint64_t pixels = entry.pixels[static_cast<size_t>(form)].load();
        if (pixels != 0) lines.push_back({pixels, form, &key});
        of_form[form] += pixels;
        all += pixels;
      }
    }
    std::sort(lines.begin(), lines.end(),
              [](const Line& a, const Line& b) { return a.pixels > b.pixels; });
    const bool to_file = std::strcmp(where_, "1") != 0;
    FILE* const file = to_file ? std::fopen(where_, "a") : stderr;
    if (file == nullptr) return;
    // One write a process: several may add to one file.
    std::string text;
    char number[64];
    const auto add = [&](uint64_t pixels, int form) {
      const double share = all != 0 ? 100.0 * static_cast<double>(pixels) / double(all) : 0;
      std::snprintf(number, sizeof number, "usage: %llu pixels %6.2f%% %s",
                    static_cast<unsigned long long>(pixels), share, kFormNames[form]);
      text += number;
    };
    for (const Line& line : lines) {
      add(line.pixels, line.form);
      text += ": " + *line.key + "\n";
    }
    for (int form = 0; form < kUsageForms; ++form) {
      add(of_form[form], form);
      text += " in all\n";
    }
    std::fwrite(text.data(), 1, text.size(), file);
    if (to_file) std::fclose(file);
  }

  const char* where_;
  std::mutex mutex_;
  std::map<std::string, UsageEntry> entries_;
};

const char* where() {
  static const char* const value = std::getenv("CLEARPIPE_COUNT");
  return value;
}

}  // namespace

bool counts_usage() {
  static const bool counts = where() != nullptr && *where() != 0 && std::strcmp(where(), "0") != 0;
  return counts;
}

UsageEntry* usage_of(const FragmentProgram& program) {
  if (!counts_usage()) return nullptr;
  static Table table(where());
  return table.find(program);
}

void count_pixels(const FragmentProgram& program, UsageForm form, int pixels) {
  if (program.usage == nullptr) return;
  program.usage->pixels[static_cast<size_t>(form)].fetch_add(static_cast<uint64_t>(pixels),
                                                             std::memory_order_relaxed);
}

void count_coverage(const FragmentProgram& program, const Coverage* coverage, int samples) {
  int pixels = 0;
  for (int row = 0; row < kTileHeight; ++row) {
    uint64_t any = 0;
    for (int s = 0; s < samples; ++s) {
      const Coverage& sample = coverage[s];
      if (row >= sample.first_row && row < sample.last_row) any |= sample.rows[row];
    }
    pixels += std::popcount(any);
  }
  const UsageForm form = samples > 1                ? UsageForm::kSamples
                         : program.fused != nullptr ? UsageForm::kFused
                                                    : UsageForm::kChain;
  count_pixels(program, form, pixels);
}

}  // namespace clearpipe::pipeline
