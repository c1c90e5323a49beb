// Work in numbered pieces on all workers, which mostly have the same ones each time (shares.h).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <new>

#include "pipeline/exec/shares.h"
#include "pipeline/exec/workers.h"

namespace clearpipe::pipeline {

// Calls piece(i) for each i from 0 to count - 1 and returns when all are done. `piece` must not
// throw, nor call this.
template <class Piece>
void run_pieces(size_t count, const Piece& piece) {
  struct Work {
    Shares shares;
    const Piece* piece = nullptr;
  };
  static thread_local Work work;
  try {
    work.shares.divide(count, static_cast<size_t>(worker_count()));
  } catch (const std::bad_alloc&) {
    for (size_t i = 0; i < count; ++i) piece(i);
    return;
  }
  work.piece = &piece;
  run_on_workers(
      [](void* context, int worker) {
        Work& mine = *static_cast<Work*>(context);
        for (size_t i; mine.shares.take(static_cast<size_t>(worker), i);) (*mine.piece)(i);
      },
      &work);
}

}  // namespace clearpipe::pipeline
