// The worker threads: see workers.h.
//
// A task opens places for workers. Workers look for places; those that find one take part, and the
// caller, when it has nothing more to do, closes the places that are left and waits for the workers
// that took one: nobody waits for a thread that has yet to wake up. Whoever waits looks again for a
// few microseconds before it sleeps, since waking a thread takes longer than many a frame.
//
// The pool is never destroyed: its threads sleep until the process ends, and a process that forks
// starts new ones in the child when it first needs them.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/workers.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <chrono>
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

constexpr std::chrono::microseconds kPatience{20};

// Looks until `ready` or for a short time; whether it became so.
template <typename Ready>
bool look_for(const Ready& ready) {
  constexpr int kLooks = 64;
  const auto end = std::chrono::steady_clock::now() + kPatience;
  do {
    for (int i = 0; i < kLooks; ++i) {
      if (ready()) return true;
    }
    std::this_thread::yield();  // to whom the thread that is waited for may have to give way
  } while (std::chrono::steady_clock::now() < end);
  return ready();
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
    const bool idle = is_idle();
    if (idle) open(task, context);
    task(context, 0);
    if (idle) close();
  }

  void start(WorkerTask task, void* context) {
    if (count_ == 1 || !mutex_.try_lock()) return;
    std::lock_guard<std::mutex> lock(mutex_, std::adopt_lock);
    if (is_idle()) open(task, context);
  }

  void finish(WorkerTask task, void* context) {
    task(context, 0);
    // Workers that have another context by now have left this one.
    if (context_.load(std::memory_order_relaxed) != context) return;
    std::lock_guard<std::mutex> lock(mutex_);
    if (context_.load(std::memory_order_relaxed) == context) close();
  }

  void leave() {
    std::lock_guard<std::mutex> lock(mutex_);
    close();
  }

 private:
  // places_ holds the places that are open above those that are taken.
  static constexpr uint32_t kOpen = 1u << 16, kTakenMask = kOpen - 1;

  bool is_idle() const { return places_.load(std::memory_order_acquire) == 0; }

  // Under the lock, when the workers are idle.
  void open(WorkerTask task, void* context) {
    start_threads();
    task_ = task;
    context_.store(context, std::memory_order_relaxed);
    places_.store(static_cast<uint32_t>(started_) * kOpen, std::memory_order_release);
    generation_.fetch_add(1, std::memory_order_release);
    generation_.notify_all();
  }

  // Closes the places that are left and waits for the workers that took one.
  void close() {
    uint32_t places = places_.fetch_and(kTakenMask, std::memory_order_acq_rel) & kTakenMask;
    const auto all_left = [&] {
      places = places_.load(std::memory_order_acquire);
      return places == 0;
    };
    while (places != 0 && !look_for(all_left)) places_.wait(places, std::memory_order_acquire);
  }

  // Starts the threads that are missing. When the system refuses, fewer work.
  void start_threads() {
    if (refused_ || started_ == count_ - 1) {
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

  bool take_place() {
    uint32_t places = places_.load(std::memory_order_relaxed);
    while (places >= kOpen) {
      if (places_.compare_exchange_weak(places, places - kOpen + 1, std::memory_order_acq_rel)) {
        return true;
      }
    }
    return false;
  }

  void work(int worker, uint32_t seen) {
    const auto announced = [&] { return generation_.load(std::memory_order_acquire) != seen; };
    for (;;) {
      if (!look_for(announced)) generation_.wait(seen, std::memory_order_acquire);
      seen = generation_.load(std::memory_order_acquire);
      if (!take_place()) continue;
      task_(context_.load(std::memory_order_relaxed), worker);
      if (places_.fetch_sub(1, std::memory_order_acq_rel) == 1) places_.notify_one();
    }
  }

  const int count_;
  int started_ = 0;
  bool refused_ = false;
  std::mutex mutex_;
  WorkerTask task_ = nullptr;
  std::atomic<void*> context_{nullptr};
  std::atomic<uint32_t> generation_{0};
  std::atomic<uint32_t> places_{0};
};

std::atomic<Pool*> the_pool{nullptr};

// A child has no workers that could finish what they have begun with.
void leave_pool_before_fork() {
  if (Pool* existing = the_pool.load(std::memory_order_acquire)) existing->leave();
}

void forget_pool_in_child() { the_pool.store(nullptr); }

Pool& pool() {
  Pool* existing = the_pool.load(std::memory_order_acquire);
  if (existing == nullptr) {
    static std::mutex creation;
    static std::once_flag registered;
    std::lock_guard<std::mutex> lock(creation);
    existing = the_pool.load(std::memory_order_acquire);
    if (existing == nullptr) {
      std::call_once(registered,
                     [] { pthread_atfork(leave_pool_before_fork, nullptr, forget_pool_in_child); });
      existing = new Pool;  // lives until the process ends
      the_pool.store(existing, std::memory_order_release);
    }
  }
  return *existing;
}

}  // namespace

int worker_count() { return pool().count(); }

void run_on_workers(WorkerTask task, void* context) { pool().run(task, context); }

void start_on_workers(WorkerTask task, void* context) { pool().start(task, context); }

void finish_on_workers(WorkerTask task, void* context) { pool().finish(task, context); }

void wait_until(std::atomic<uint32_t>& value, uint32_t wanted) {
  uint32_t now = value.load(std::memory_order_acquire);
  const auto arrived = [&] {
    now = value.load(std::memory_order_acquire);
    return now == wanted;
  };
  while (now != wanted && !look_for(arrived)) value.wait(now, std::memory_order_acquire);
}

}  // namespace clearpipe::pipeline
