// The worker threads: see workers.h.
//
// A task is announced by a generation counter on which sleeping workers wait, and ends when the
// count of busy workers falls to zero. The pool is never destroyed: its threads sleep until the
// process ends, and a process that forks starts new ones in the child when it first needs them.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/workers.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <system_error>
#include <thread>

namespace clearpipe::pipeline {
namespace {

constexpr int kMaxWorkers = 256;

int configured_count() {
  if (const char* text = std::getenv("CLEARPIPE_THREADS")) {
    const long value = std::strtol(text, nullptr, 10);
    if (value >= 1) {
      return static_cast<int>(std::min<long>(value, kMaxWorkers));
    }
  }
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof(set), &set) == 0) {
    return std::clamp(CPU_COUNT(&set), 1, kMaxWorkers);
  }
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMaxWorkers);
}

class Pool {
 public:
  Pool() : count_(configured_count()) {}

  int count() const { return count_; }

  void run(WorkerTask task, void* context) {
    if (count_ == 1 || !mutex_.try_lock()) {
      task(context, 0);
      return;
    }
    std::lock_guard<std::mutex> lock(mutex_, std::adopt_lock);
    start();
    task_ = task;
    context_ = context;
    busy_.store(started_, std::memory_order_relaxed);
    generation_.fetch_add(1, std::memory_order_release);
    generation_.notify_all();
    task(context, 0);
    for (int busy = busy_.load(std::memory_order_acquire); busy != 0;
         busy = busy_.load(std::memory_order_acquire)) {
      busy_.wait(busy, std::memory_order_acquire);
    }
  }

 private:
  // Starts the threads that are missing. When the system refuses, fewer work.
  void start() {
    if (refused_) {
      return;
    }
    // Application signal handlers must not run on a worker.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    while (started_ < count_ - 1) {
      try {
        std::thread(&Pool::work, this, started_ + 1, generation_.load()).detach();
        ++started_;
      } catch (const std::system_error&) {
        refused_ = true;
        break;
      }
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }

  void work(int worker, uint32_t seen) {
    for (;;) {
      generation_.wait(seen, std::memory_order_acquire);
      seen = generation_.load(std::memory_order_acquire);
      task_(context_, worker);
      if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) {
        busy_.notify_one();
      }
    }
  }

  const int count_;
  int started_ = 0;
  bool refused_ = false;
  std::mutex mutex_;
  WorkerTask task_ = nullptr;
  void* context_ = nullptr;
  std::atomic<uint32_t> generation_{0};
  std::atomic<int> busy_{0};
};

std::atomic<Pool*> the_pool{nullptr};

void forget_pool_in_child() { the_pool.store(nullptr); }

Pool& pool() {
  Pool* existing = the_pool.load(std::memory_order_acquire);
  if (existing == nullptr) {
    static std::mutex creation;
    static std::once_flag registered;
    std::lock_guard<std::mutex> lock(creation);
    existing = the_pool.load(std::memory_order_acquire);
    if (existing == nullptr) {
      std::call_once(registered, [] { pthread_atfork(nullptr, nullptr, forget_pool_in_child); });
      existing = new Pool;  // lives until the process ends
      the_pool.store(existing, std::memory_order_release);
    }
  }
  return *existing;
}

}  // namespace

int worker_count() { return pool().count(); }

void run_on_workers(WorkerTask task, void* context) { pool().run(task, context); }

}  // namespace clearpipe::pipeline
