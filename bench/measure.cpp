// SPDX-License-Identifier: MIT
//
// See measure.h.
#include "bench/measure.h"

#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <string>

namespace bench {

Usage usage_so_far() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return {seconds(usage.ru_utime), seconds(usage.ru_stime)};
}

long peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    long value = 0;
    if (word == "VmHWM:" && status >> value) return value;
  }
  return 0;
}

double now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

void note_process_start(char** arguments) {
  if (std::getenv("BENCH_NOTE_START") == nullptr) return;
  unsetenv("BENCH_NOTE_START");
  setenv("BENCH_START", std::to_string(now()).c_str(), 1);
  execv("/proc/self/exe", arguments);
  std::perror("scenes: starting anew");
  std::exit(1);
}

double process_start() {
  static const double first = now();
  const char* told = std::getenv("BENCH_START");
  return told ? std::strtod(told, nullptr) : first;
}

double Times::median() const {
  std::vector<double> sorted = frames;
  std::sort(sorted.begin(), sorted.end());
  const size_t middle = sorted.size() / 2;
  return sorted.size() % 2 != 0 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

double Times::worst() const { return *std::max_element(frames.begin(), frames.end()); }

double Times::total() const { return std::accumulate(frames.begin(), frames.end(), 0.0); }

Times measure(const std::function<void(int)>& frame, int count, double seconds) {
  Times times;
  times.frames.reserve(size_t(count > 0 ? count : 1 << 16));
  const Usage before = usage_so_far();
  const double start = now();
  double last = start;
  for (int i = 0; count > 0 ? i < count : i < 5 || last - start < seconds; ++i) {
    frame(i);
    const double time = now();
    times.frames.push_back(time - last);
    last = time;
  }
  const Usage after = usage_so_far();
  times.used = {after.user - before.user, after.system - before.system};
  return times;
}

}  // namespace bench
