// The SIMD target in use: resolved once, the best the processor has.
//
// CLEARPIPE_SIMD=scalar|sse4|avx2|avx512 restricts it (for tests and for study); the pixels are the
// same on each. Include this before any Highway header.
// SPDX-License-Identifier: MIT
#pragma once

#ifndef HWY_WANT_SSE4
#define HWY_WANT_SSE4 1
#endif

namespace clearpipe::pipeline {

// Applies CLEARPIPE_SIMD; called once before the first kernel table is resolved.
void select_simd_target();

// The name of the target that kernels run on, e.g. "AVX2".
const char* simd_target_name();

}  // namespace clearpipe::pipeline
