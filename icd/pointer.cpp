// See pointer.h.
// SPDX-License-Identifier: MIT
#include "icd/pointer.h"

#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cstdint>

namespace clearpipe::icd {

bool is_readable(const void* pointer, size_t bytes) {
  const auto page = static_cast<uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto begin = reinterpret_cast<uintptr_t>(pointer);
  if (begin < page || begin + bytes < begin) return false;
  const uintptr_t first = begin / page * page;
  std::array<unsigned char, 8> resident;
  if ((begin + bytes - first + page - 1) / page > resident.size()) return false;
  // Fails where nothing is mapped.
  return mincore(reinterpret_cast<void*>(first), begin + bytes - first, resident.data()) == 0;
}

}  // namespace clearpipe::icd
