// The words of an error: the call with its arguments, and the rule that one of them breaks.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "api/debug.h"
#include "api/invalid.h"

namespace clearpipe::api {

// The name of an enumerant, or null: it has none, or shares its value with others (enum_names.def).
const char* enumerant_name(unsigned long long value);

std::string error_text(const CallText& call, const std::vector<Argument>& arguments,
                       const Invalid& wrong);

}  // namespace clearpipe::api
