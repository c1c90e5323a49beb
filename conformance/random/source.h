// Streams as C++ source.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "conformance/random/stream.h"

namespace clearpipe::conformance::random {

// A file that registers the stream as a scene random.NAME: put it into conformance/scenes/.
std::string as_scene_file(const Stream& stream, const std::string& name);

}  // namespace clearpipe::conformance::random
