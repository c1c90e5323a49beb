// Two pictures compared.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "conformance/implementation.h"
#include "conformance/scene.h"

namespace clearpipe::conformance {

// Shares of pixels, 0 to 1, whose channels all lie within a number of steps of 1/255.
struct Agreement {
  double equal = 0, within_1 = 0, near = 0, far = 0;
  int largest = 0;  // the largest difference of a channel
};

Agreement compare(const Image& image, const Image& reference, const Tolerance& tolerance);

bool holds(const Agreement& agreement, const Tolerance& tolerance);

// "equal 99.98%, within 1/255 100.00%, largest 1/255"
std::string describe(const Agreement& agreement);

}  // namespace clearpipe::conformance
