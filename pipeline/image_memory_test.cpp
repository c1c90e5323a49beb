// Memory that images leave serves images of the same size, and nothing of theirs is seen in it.
// SPDX-License-Identifier: MIT
#include "pipeline/image_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "pipeline/image.h"

namespace clearpipe::pipeline {
namespace {

constexpr size_t kSize = size_t{1} << 20;

TEST(ImageMemory, ServesTheNextImageOfItsSize) {
  forget_free_images();
  void* const first = allocate_image(kSize);
  free_image(first, kSize);
  void* const other = allocate_image(kSize + 4096);
  EXPECT_NE(other, first);
  void* const second = allocate_image(kSize);
  EXPECT_EQ(second, first);
  void* const third = allocate_image(kSize);
  EXPECT_NE(third, first);
  free_image(other, kSize + 4096);
  free_image(second, kSize);
  free_image(third, kSize);
  forget_free_images();
}

// More than is kept goes, the oldest first.
TEST(ImageMemory, KeepsALimitedNumber) {
  forget_free_images();
  std::vector<void*> blocks(20);
  for (void*& block : blocks) block = allocate_image(kSize);
  for (void* const block : blocks) free_image(block, kSize);
  void* const latest = allocate_image(kSize);
  EXPECT_EQ(latest, blocks.back());
  free_image(latest, kSize);
  forget_free_images();
}

TEST(ImageMemory, ShowsNothingOfTheImageBefore) {
  forget_free_images();
  const uint32_t* memory;
  {
    Texels texels = Texels::for_overwrite(kSize);
    std::fill(texels.begin(), texels.end(), 0xdeadbeefu);
    memory = texels.data();
  }
  const Texels empty(kSize);
  EXPECT_EQ(empty.data(), memory);
  EXPECT_TRUE(std::all_of(empty.begin(), empty.end(), [](uint32_t texel) { return texel == 0; }));
  const Texels opaque(kSize, 0xff000000u);
  EXPECT_TRUE(std::all_of(opaque.begin(), opaque.end(),
                          [](uint32_t texel) { return texel == 0xff000000u; }));
  const Texels copy(opaque);
  EXPECT_TRUE(std::equal(copy.begin(), copy.end(), opaque.begin()));
  forget_free_images();
}

}  // namespace
}  // namespace clearpipe::pipeline
