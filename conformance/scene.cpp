// The registry of scenes.
// SPDX-License-Identifier: MIT
#include "conformance/scene.h"

namespace clearpipe::conformance {

std::vector<Scene>& scenes() {
  static std::vector<Scene> list;
  return list;
}

}  // namespace clearpipe::conformance
