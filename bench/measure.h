// SPDX-License-Identifier: MIT
//
// The times of frames, and what else a process has used.
#pragma once

#include <functional>
#include <vector>

namespace bench {

struct Usage {
  double user = 0, system = 0;  // seconds of all threads
};
Usage usage_so_far();

// The most memory that the process has had at once, in KiB. Read from the process's own status:
// ru_maxrss of a child still counts the parent that it was forked from.
long peak_memory();

// Seconds of the monotonic clock.
double now();

// With BENCH_NOTE_START in the environment the program takes the time and executes itself anew:
// what starts a process - a Python program, which copies itself first - takes as long as a first
// frame.
void note_process_start(char** arguments);
// That moment, or of the first call.
double process_start();

struct Times {
  std::vector<double> frames;  // seconds, in order
  Usage used;                  // by all of them

  double median() const;
  double worst() const;
  double total() const;
};

// Calls frame(0), frame(1), ... `count` times, or if that is 0 for so many seconds, 5 times at
// least.
Times measure(const std::function<void(int)>& frame, int count, double seconds);

}  // namespace bench
