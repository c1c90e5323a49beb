// Where the files that the validator needs lie, beside it in a build folder or where it was
// installed to.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace clearpipe::validate {

// All throw std::runtime_error when there is none.
std::string capture_library();
std::string clearpipe_manifest();
std::string mesa_manifest();

}  // namespace clearpipe::validate
