// See minimise.h.
// SPDX-License-Identifier: MIT
#include "conformance/random/minimise.h"

#include <algorithm>
#include <cstddef>

namespace clearpipe::conformance::random {

namespace {

// Without these the rest would fail for another reason: images read with rows of another length,
// projections in the model-view matrix, combiners that read units without a texture, long normals,
// the filters and the shininess of the initial state (reference/numerics.md).
bool must_stay(const Command& command) {
  switch (command.call) {
    case Call::PixelStorei:
    case Call::MatrixMode:
    case Call::ActiveTexture:
    case Call::TexParameteri:
    case Call::TexParameterx:
    case Call::Materialf:
      return true;
    case Call::Enable:
      return command.arguments[0] == GL_TEXTURE_2D || command.arguments[0] == GL_NORMALIZE;
    default:
      return false;
  }
}

Stream without(const Stream& stream, size_t first, size_t count) {
  Stream rest{stream.width, stream.height, {}};
  for (size_t i = 0; i < stream.commands.size(); ++i) {
    const bool inside = i >= first && i < first + count;
    if (!inside || must_stay(stream.commands[i])) rest.commands.push_back(stream.commands[i]);
  }
  return rest;
}

}  // namespace

Stream minimise(Stream stream, const std::function<bool(const Stream&)>& fails) {
  size_t run = std::max<size_t>(stream.commands.size() / 2, 1);
  while (true) {
    bool shorter = false;
    // From the end: what comes last is needed by nothing.
    for (size_t end = stream.commands.size(); end > 0;) {
      const size_t first = end - std::min(end, run);
      Stream rest = without(stream, first, end - first);
      if (rest.commands.size() < stream.commands.size() && reads_only_its_own(rest) &&
          fails(rest)) {
        stream = std::move(rest);
        shorter = true;
      }
      end = std::min(first, stream.commands.size());
    }
    if (run == 1 && !shorter) return stream;
    run = std::max<size_t>(run / 2, 1);
  }
}

}  // namespace clearpipe::conformance::random
