// The choice of the SIMD target: see simd.h.
//
// Highway's library would make it, and is needed for nothing else. But when it is loaded it
// measures the processor's timer, for benchmarks, which takes milliseconds: a third of the time to
// the first frame. So on x86 the functions that Highway's headers ask for are here; weak,
// as a program with the static library may have Highway's too.
// SPDX-License-Identifier: MIT
#include "pipeline/simd.h"

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <string_view>

#include <hwy/highway.h>

#if HWY_ARCH_X86
namespace hwy {

namespace {

std::atomic<int64_t> disabled_targets{0};

// The instructions that Highway uses on each target; the system must save the registers.
int64_t detect_targets() {
  __builtin_cpu_init();
  int64_t targets = HWY_SCALAR | HWY_EMU128;
  if (!__builtin_cpu_supports("ssse3")) return targets;
  targets |= HWY_SSSE3;
  if (!__builtin_cpu_supports("sse4.1") || !__builtin_cpu_supports("sse4.2") ||
      !__builtin_cpu_supports("pclmul") || !__builtin_cpu_supports("aes")) {
    return targets;
  }
  targets |= HWY_SSE4;
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma") ||
      !__builtin_cpu_supports("f16c") || !__builtin_cpu_supports("lzcnt") ||
      !__builtin_cpu_supports("bmi") || !__builtin_cpu_supports("bmi2")) {
    return targets;
  }
  targets |= HWY_AVX2;
  if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512vl") ||
      !__builtin_cpu_supports("avx512cd") || !__builtin_cpu_supports("avx512dq") ||
      !__builtin_cpu_supports("avx512bw")) {
    return targets;
  }
  return targets | HWY_AVX3;
}

}  // namespace

__attribute__((weak)) int64_t SupportedTargets() {
  static const int64_t supported = detect_targets();
  const int64_t targets = supported & ~disabled_targets.load();
  return targets != 0 ? targets : HWY_STATIC_TARGET;
}

__attribute__((weak)) void DisableTargets(int64_t targets) { disabled_targets = targets; }

__attribute__((weak)) ChosenTarget& GetChosenTarget() {
  static ChosenTarget chosen;
  return chosen;
}

}  // namespace hwy
#endif

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
