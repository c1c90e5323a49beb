// Shortening streams that fail.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "conformance/random/stream.h"

namespace clearpipe::conformance::random {

// Leaves out commands as long as the rest still fails. A stream that draws from memory it no longer
// has is never tried.
Stream minimise(Stream stream, const std::function<bool(const Stream&)>& fails);

}  // namespace clearpipe::conformance::random
