// The lists of EGL extensions, from extensions.def.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace clearpipe::icd {

enum class Offered { client, platform, device, display, windows, pixmaps };

struct Extension {
  Offered where;
  std::string_view name;  // with a space after it
};

inline constexpr Extension kExtensions[] = {
#define EXTENSION(where, name) {Offered::where, "EGL_" #name " "},
#include "icd/extensions.def"
#undef EXTENSION
};

// The names of those that are offered there, each with a space after it, and a terminating null.
template <Offered... where>
inline constexpr auto kOffered = [] {
  constexpr auto wanted = [](Offered at) { return ((at == where) || ...); };
  constexpr size_t size = [=] {
    size_t sum = 1;
    for (const Extension& e : kExtensions) sum += wanted(e.where) ? e.name.size() : 0;
    return sum;
  }();
  std::array<char, size> list{};
  size_t at = 0;
  for (const Extension& e : kExtensions) {
    if (!wanted(e.where)) continue;
    for (const char c : e.name) list[at++] = c;
  }
  return list;
}();

}  // namespace clearpipe::icd
