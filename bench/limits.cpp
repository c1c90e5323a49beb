// SPDX-License-Identifier: MIT
//
// What the machine can do at most, on as many threads as are asked for: bytes a second of memset,
// memcpy, and of adding to numbers in place, over blocks that no cache holds; and operations a
// second of arithmetic that needs no memory, which tells how much of a processor a thread has.
//
//   limits [threads]   prints limits: threads=N write_gb=... copy_gb=... update_gb=...
//   arithmetic_g=...
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

// Independent chains, as many as keep the units busy whose results take some cycles.
constexpr int kChains = 32, kSteps = 2000000;

void calculate(Block& block, int pass) {
  float values[kChains];
  for (int i = 0; i < kChains; ++i) values[i] = float(i + pass);
  for (int step = 0; step < kSteps; ++step) {
    for (float& value : values) value = value * 0.999f + 0.5f;
  }
  std::memcpy(block.to.data(), values, sizeof(values));
}

// In thousand millions a second; `amount` is what a pass of one thread does.
double rate(int threads, double amount, void (*work)(Block&, int)) {
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
  return 1e-9 * amount * threads / times[kPasses / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const int threads = argc > 1 ? std::max(1, std::atoi(argv[1])) : 1;
  std::printf("limits: threads=%d write_gb=%.3f copy_gb=%.3f update_gb=%.3f arithmetic_g=%.3f\n",
              threads, rate(threads, kBlock, write), rate(threads, kBlock, copy),
              rate(threads, kBlock, update), rate(threads, 2.0 * kChains * kSteps, calculate));
  return 0;
}
