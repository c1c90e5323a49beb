// Copies of client arrays, of few elements and of many: the values, and no byte behind the last.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/client_copy.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

namespace clearpipe::pipeline {
namespace {

AttributeSource source_of(const std::byte* memory, ComponentType type, uint8_t size,
                          uint32_t stride) {
  AttributeSource source;
  source.is_array = true;
  source.type = type;
  source.size = size;
  source.stride = stride;
  source.pointer = memory;
  return source;
}

TEST(ClientCopies, AreCompactAndComplete) {
  constexpr size_t kStride = 20;
  for (const uint32_t count : {1u, 5000u, 100001u}) {
    constexpr uint32_t kFirst = 3;
    // As large as the elements, so that a sanitizer sees what is read behind the last.
    const size_t bytes = (kFirst + count - 1) * kStride + 16;
    const auto memory = std::make_unique<std::byte[]>(bytes);
    for (size_t i = 0; i < bytes; ++i) memory[i] = static_cast<std::byte>(i * 7 + i / 251);
    AttributeSource position = source_of(memory.get(), ComponentType::kFloat, 3, kStride);
    AttributeSource colour = source_of(memory.get() + 12, ComponentType::kUnsignedByte, 3, kStride);
    AttributeSource packed = source_of(memory.get(), ComponentType::kUnsignedByte, 4, 4);
    Arena arena;
    ClientCopies copies;
    copies.start(kFirst, kFirst + count - 1);
    copies.add(position, arena);
    copies.add(colour, arena);
    copies.add(packed, arena);
    copies.run();
    EXPECT_EQ(position.stride, 12u);
    EXPECT_EQ(colour.stride, 4u);
    EXPECT_EQ(colour.max_index, count - 1);
    for (size_t i = 0; i < count; ++i) {
      const std::byte* const from = memory.get() + (kFirst + i) * kStride;
      ASSERT_EQ(std::memcmp(position.pointer + i * 12, from, 12), 0) << count << " " << i;
      ASSERT_EQ(std::memcmp(colour.pointer + i * 4, from + 12, 3), 0) << count << " " << i;
    }
    EXPECT_EQ(std::memcmp(packed.pointer, memory.get() + size_t{kFirst} * 4, size_t{count} * 4), 0);
  }
}

}  // namespace
}  // namespace clearpipe::pipeline
