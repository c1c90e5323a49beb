// What programs a process runs, and how many pixels each shades: CLEARPIPE_COUNT.
//
// With CLEARPIPE_COUNT=1 a table is printed on stderr when the library is unloaded; any other value
// names a file that the table is added to. Programs that differ in constants alone count as one.
// Pixels are those that primitives cover, whether tests discard them or not; a multisampled pixel
// counts once. Without it, nothing is counted.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "pipeline/fragment/program.h"

namespace clearpipe::pipeline {

// What ran a program over some pixels.
enum class UsageForm : uint8_t { kFused, kSmall, kChain, kSamples };
inline constexpr int kUsageForms = 4;

struct UsageEntry;

// Whether anything is counted: asked once.
bool counts_usage();

// Where the pixels of a program count; null when nothing is counted.
UsageEntry* usage_of(const FragmentProgram& program);

// Counts what shade(), or with several samples shade_samples(), is about to do.
void count_coverage(const FragmentProgram& program, const Coverage* coverage, int samples);
// Counts pixels that one form of a program shades.
void count_pixels(const FragmentProgram& program, UsageForm form, int pixels);

}  // namespace clearpipe::pipeline
