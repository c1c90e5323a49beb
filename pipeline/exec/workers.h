// The worker threads of the process: one task at a time is run by all of them and by the thread
// that asks for it.
//
// CLEARPIPE_THREADS sets how many threads work on a task, the asking one included (default: the
// number of processors the process may use). Threads start with the first task that can use them.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>

namespace clearpipe::pipeline {

// Called with the number of the working thread, in [0, worker_count()).
using WorkerTask = void (*)(void* context, int worker);

// How many threads work on a task.
int worker_count();

// Runs task(context, worker) on the calling thread and on every worker that wakes up before that
// has returned; returns when all have. When another task is running, the caller works alone, as
// worker 0.
void run_on_workers(WorkerTask task, void* context);

// Lets the workers run task(context, worker), of numbers above 0, while the caller does something
// else; where they are busy, or there are none, nobody does. Then finish_on_workers() with the same
// must follow: it runs the task as worker 0 and returns when all others have returned.
void start_on_workers(WorkerTask task, void* context);
void finish_on_workers(WorkerTask task, void* context);

// Waits until `value`, which is notified when it is so, has become `wanted`: what that takes is
// being worked on by threads that run.
void wait_until(std::atomic<uint32_t>& value, uint32_t wanted);

}  // namespace clearpipe::pipeline
