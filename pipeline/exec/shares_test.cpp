// Shares of work: every piece is taken once, and by its own worker where that comes for it.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/shares.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace clearpipe::pipeline {
namespace {

std::vector<size_t> all_for(Shares& shares, size_t worker) {
  std::vector<size_t> taken;
  for (size_t piece = 0; shares.take(worker, piece);) taken.push_back(piece);
  return taken;
}

TEST(Shares, OwnFromTheFrontThenOthersFromTheBack) {
  Shares shares;
  shares.divide(7, 2);
  size_t piece = 0;
  ASSERT_TRUE(shares.take(1, piece));
  EXPECT_EQ(piece, 3u);
  EXPECT_EQ(all_for(shares, 0), (std::vector<size_t>{0, 1, 2, 6, 5, 4}));
  EXPECT_FALSE(shares.take(1, piece));
}

TEST(Shares, FewerPiecesThanWorkers) {
  Shares shares;
  shares.divide(2, 5);
  EXPECT_EQ(all_for(shares, 4).size(), 2u);
  shares.divide(0, 5);
  EXPECT_TRUE(all_for(shares, 0).empty());
}

TEST(Shares, EveryPieceOnceAmongThreads) {
  constexpr size_t kPieces = 50000, kWorkers = 4;
  Shares shares;
  for (int round = 0; round < 5; ++round) {
    shares.divide(kPieces, kWorkers);
    std::vector<std::vector<size_t>> taken(kWorkers);
    std::vector<std::thread> threads;
    for (size_t w = 0; w < kWorkers; ++w) {
      threads.emplace_back([&, w] { taken[w] = all_for(shares, w); });
    }
    for (std::thread& thread : threads) thread.join();
    std::vector<int> times(kPieces, 0);
    for (const auto& pieces : taken) {
      for (const size_t piece : pieces) ++times[piece];
    }
    EXPECT_EQ(times, std::vector<int>(kPieces, 1));
  }
}

}  // namespace
}  // namespace clearpipe::pipeline
