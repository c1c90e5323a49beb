// SPDX-License-Identifier: MIT
//
// What memory can do at most: bytes a second of memset, memcpy, and of adding to numbers in place,
// over blocks that no cache holds, on one thread and on as many as are asked for.
//
//   bandwidth [threads]        prints bandwidth: threads=N write_gb=... copy_gb=... update_gb=...
//
// Each figure is the median of several passes. A copied byte counts once, an updated one once.
#include <algorithm>
#include <barrier>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <thread>
#include <vector>

#include "bench/measure.h"

namespace {

constexpr size_t kBlock = size_t(64) << 20;  // of each thread
constexpr int kPasses = 7;

struct Block {
  std::vector<uint8_t> from, to;
};

void write(Block& block, int pass) { std::memset(block.to.data(), pass, kBlock); }

void copy(Block& block, int) { std::memcpy(block.to.data(), block.from.data(), kBlock); }

void update(Block& block, int) {
  auto* const words = reinterpret_cast<uint32_t*>(block.to.data());
  for (size_t i = 0; i < kBlock / sizeof(uint32_t); ++i) words[i] += 0x01010101u;
}

double gigabytes_a_second(int threads, void (*work)(Block&, int)) {
  std::vector<double> times;
  std::barrier meeting(threads);
  std::vector<std::thread> team;
  for (int t = 0; t < threads; ++t) {
    team.emplace_back([&, t] {
      Block block{std::vector<uint8_t>(kBlock, 1), std::vector<uint8_t>(kBlock, 2)};
      for (int pass = 0; pass < kPasses; ++pass) {
        meeting.arrive_and_wait();
        const double start = bench::now();
        work(block, pass);
        meeting.arrive_and_wait();
        if (t == 0) times.push_back(bench::now() - start);
      }
    });
  }
  for (std::thread& thread : team) thread.join();
  std::sort(times.begin(), times.end());
  return 1e-9 * double(kBlock) * threads / times[kPasses / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const int threads = argc > 1 ? std::max(1, std::atoi(argv[1])) : 1;
  std::printf("bandwidth: threads=%d write_gb=%.3f copy_gb=%.3f update_gb=%.3f\n", threads,
              gigabytes_a_second(threads, write), gigabytes_a_second(threads, copy),
              gigabytes_a_second(threads, update));
  return 0;
}
