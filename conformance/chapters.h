// Where the specification (OpenGL ES 1.1.12) treats the topics of the scenes.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace clearpipe::conformance {

struct Chapter {
  std::string_view title;    // of the chapter, with its number
  std::string_view section;  // of the topic
};

// A topic that the list does not have is an empty chapter.
Chapter chapter_of(std::string_view topic);

}  // namespace clearpipe::conformance
