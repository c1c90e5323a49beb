// Vertex fetch against table 2.7 and section 2.8, at odd addresses and at the end of the buffer.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <vector>

#include "pipeline/exec/vertex_stream.h"
#include "pipeline/vertex/vertex_test_kernels.h"

namespace clearpipe::pipeline {
namespace {

template <typename T>
T read(const std::byte* address) {
  T value;
  std::memcpy(&value, address, sizeof(T));
  return value;
}

double expected_component(const AttributeSource& source, const std::byte* address) {
  switch (source.type) {
    case ComponentType::kByte: {
      const double c = read<int8_t>(address);
      return source.normalized ? (2 * c + 1) / 255 : c;
    }
    case ComponentType::kUnsignedByte: {
      const double c = read<uint8_t>(address);
      return source.normalized ? c / 255 : c;
    }
    case ComponentType::kShort: {
      const double c = read<int16_t>(address);
      return source.normalized ? (2 * c + 1) / 65535 : c;
    }
    case ComponentType::kFixed:
      return read<int32_t>(address) / 65536.0;
    case ComponentType::kFloat:
      return read<float>(address);
  }
  return 0;
}

TEST(VertexFetch, EveryTypeSizeAndNormalisation) {
  constexpr size_t kElements = 91;
  std::mt19937 random(21);
  for (ComponentType type : {ComponentType::kByte, ComponentType::kUnsignedByte,
                             ComponentType::kShort, ComponentType::kFixed, ComponentType::kFloat}) {
    for (int size = 1; size <= 4; ++size) {
      for (int variant = 0; variant < 4; ++variant) {
        AttributeSource source;
        source.is_array = true;
        source.type = type;
        source.size = static_cast<uint8_t>(size);
        source.normalized = (variant & 1) != 0;
        const uint32_t packed = static_cast<uint32_t>(size) * component_bytes(type);
        source.stride = (variant & 2) != 0 ? packed + 3 : packed;
        source.max_index = kElements - 1;
        source.constant = {7, 7, 7, 7};
        // Exactly as long as its last element needs, starting at an odd address.
        const size_t bytes = 1 + source.stride * (kElements - 1) + packed;
        const auto store = std::make_unique<std::byte[]>(bytes);
        for (size_t i = 0; i < bytes; ++i) store[i] = static_cast<std::byte>(random() & 0x3f);
        source.pointer = store.get() + 1;
        uint32_t elements[kVertexBatch];
        for (uint32_t& e : elements) e = random() % kElements;
        elements[0] = kElements - 1;
        elements[1] = kElements;
        elements[2] = 0xffffffffu;

        for_each_target([&](const VertexTestKernels& kernels, const char* name) {
          const auto batch = std::make_unique<VertexBatch>();
          Lane* out = batch->attribute[0];
          kernels.fetch(source, elements, 61, out);
          for (size_t i = 0; i < 61; ++i) {
            const size_t e = std::min<size_t>(elements[i], kElements - 1);
            for (int c = 0; c < 4; ++c) {
              float expected = c == 3 ? 1.0f : 0.0f;
              if (c < size) {
                expected = static_cast<float>(expected_component(
                    source, source.pointer + e * source.stride +
                                static_cast<uint32_t>(c) * component_bytes(type)));
              }
              ASSERT_EQ(out[c][i], expected)
                  << name << " type " << static_cast<int>(type) << " size " << size << " variant "
                  << variant << " element " << e << " component " << c;
            }
          }
        });
      }
    }
  }
}

TEST(VertexFetch, ExtremesOfTheIntegerTypes) {
  const int8_t bytes[4] = {127, -128, 0, -1};
  const int32_t fixed[4] = {0x7fffffff, static_cast<int32_t>(0x80000000u), 65536, -1};
  const uint32_t elements[1] = {0};
  for_each_target([&](const VertexTestKernels& kernels, const char* name) {
    const auto batch = std::make_unique<VertexBatch>();
    Lane* out = batch->attribute[0];
    AttributeSource source;
    source.is_array = true;
    source.stride = 4;
    source.normalized = true;
    source.type = ComponentType::kByte;
    source.pointer = reinterpret_cast<const std::byte*>(bytes);
    kernels.fetch(source, elements, 1, out);
    EXPECT_EQ(out[0][0], 1.0f) << name;
    EXPECT_EQ(out[1][0], -1.0f) << name;
    EXPECT_EQ(out[2][0], 1.0f / 255) << name;
    EXPECT_EQ(out[3][0], -1.0f / 255) << name;
    source.type = ComponentType::kFixed;
    source.pointer = reinterpret_cast<const std::byte*>(fixed);
    kernels.fetch(source, elements, 1, out);
    EXPECT_EQ(out[0][0], 32768.0f) << name;
    EXPECT_EQ(out[1][0], -32768.0f) << name;
    EXPECT_EQ(out[2][0], 1.0f) << name;
    EXPECT_EQ(out[3][0], -1.0f / 65536) << name;
  });
}

TEST(VertexFetch, ConstantsFillTheLanes) {
  AttributeSource source;
  source.constant = {1, 2, 3, 4};
  for_each_target([&](const VertexTestKernels& kernels, const char* name) {
    const auto batch = std::make_unique<VertexBatch>();
    Lane* out = batch->attribute[0];
    kernels.fetch(source, nullptr, 0, out);
    for (int c = 0; c < 4; ++c) {
      for (float value : out[c]) ASSERT_EQ(value, static_cast<float>(c + 1)) << name;
    }
  });
}

}  // namespace
}  // namespace clearpipe::pipeline
