// The choice of the SIMD target: see simd.h.
// SPDX-License-Identifier: MIT
#include "pipeline/simd.h"

#include <cstdlib>
#include <mutex>
#include <string_view>

#include <hwy/highway.h>

namespace clearpipe::pipeline {

namespace {

// The targets better than the one named, which are then not used.
int64_t better_than(std::string_view name) {
  constexpr int64_t kAvx512 = HWY_AVX3 | HWY_AVX3_DL;
  if (name == "scalar") return kAvx512 | HWY_AVX2 | HWY_SSE4 | HWY_SSSE3 | HWY_NEON;
  if (name == "sse4") return kAvx512 | HWY_AVX2;
  if (name == "avx2") return kAvx512;
  return 0;
}

int64_t best_target;

}  // namespace

void select_simd_target() {
  static std::once_flag once;
  std::call_once(once, [] {
    if (const char* name = std::getenv("CLEARPIPE_SIMD")) {
      hwy::DisableTargets(better_than(name));
    }
    // Asking leaves all targets chosen, disabled ones too.
    const int64_t targets = hwy::SupportedTargets();
    hwy::GetChosenTarget().Update(targets);
    best_target = targets & HWY_TARGETS;
    best_target &= -best_target;
  });
}

const char* simd_target_name() {
  select_simd_target();
  return hwy::TargetName(best_target);
}

}  // namespace clearpipe::pipeline
