// The SIMD target in use: resolved once, the best the processor has.
//
// CLEARPIPE_SIMD=scalar|sse4|avx2|avx512 restricts it (for tests and for study); the pixels are the
// same on each. Include this before any Highway header.
// SPDX-License-Identifier: MIT
#pragma once

// Scalar code, SSE4, AVX2 and AVX-512 on x86; on other processors what Highway knows of them. The
// instructions that AVX3_DL has beyond AVX3 are none that pixels need. A build may omit further
// ones (CMakeLists.txt, of sanitizers).
#ifndef CLEARPIPE_OMITTED_TARGETS
#define CLEARPIPE_OMITTED_TARGETS 0
#endif
#define HWY_COMPILE_ALL_ATTAINABLE
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | CLEARPIPE_OMITTED_TARGETS)

namespace clearpipe::pipeline {

// Applies CLEARPIPE_SIMD; called once before the first kernel table is resolved.
void select_simd_target();

// The name of the target that kernels run on, e.g. "AVX2".
const char* simd_target_name();

}  // namespace clearpipe::pipeline
