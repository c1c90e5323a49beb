// Which unfinished frames still read an object's data: a texture's image or a buffer's data store.
//
// A frame samples texels and fetches vertices when it is executed, which may be long after the draw
// and on other threads. So data that an unfinished frame reads is never written in place; it is
// copied first, or the frame is finished. A context counts the frames it has finished on a clock of
// its own; an object notes, per context, the frame that last drew with it.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "api/frame_clock.h"

namespace clearpipe::api {

// Used under the lock of the share group. The clocks alone move outside of it: reading one
// makes everything the finished frame read happen before what the reader writes.
class FrameUses {
 public:
  // The frame being recorded on `clock` reads the data.
  void note(const FrameClock& clock) {
    const uint64_t frame = clock->now();
    for (Use& use : uses_) {
      if (use.clock == clock) {
        use.frame = frame;
        return;
      }
    }
    uses_.erase(std::remove_if(uses_.begin(), uses_.end(), is_over), uses_.end());
    uses_.push_back({clock, frame});
  }

  bool pending() const { return !std::all_of(uses_.begin(), uses_.end(), is_over); }

  // Whether a frame of another context than that of `own` is unfinished.
  bool pending_elsewhere(const FrameClock& own) const {
    return std::any_of(uses_.begin(), uses_.end(),
                       [&own](const Use& use) { return use.clock != own && !is_over(use); });
  }

  // The data was replaced: no frame knows the new one.
  void clear() { uses_.clear(); }

 private:
  struct Use {
    FrameClock clock;
    uint64_t frame = 0;
  };
  static bool is_over(const Use& use) { return use.clock->is_over(use.frame); }
  std::vector<Use> uses_;
};

}  // namespace clearpipe::api
