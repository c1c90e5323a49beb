// The fragment programs of a frame: one for each state that is drawn with, found again when the
// state comes back, as when blending is switched on and off between draws.
//
// A program keeps the images it samples, so programs end with the frame; their memory stays.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "pipeline/fragment/program.h"

namespace clearpipe::pipeline {

struct DrawState;

// The draw states made with the programs of a fragment state, in one generation of all other state
// (draw_state.h); by kind of primitive, null where there is none.
struct MadeDrawStates {
  uint64_t generation = 0;
  std::array<const DrawState*, 3> of_kind{};
};

// A fragment state with its programs, made when first drawn with.
class ProgramHolder {
 public:
  // Forgets what it held before.
  void assign(const FragmentState& state, const FragmentTarget& target);
  bool is_of(const FragmentState& state, const FragmentTarget& target) const {
    return state_ == state && target_ == target;
  }
  const FragmentProgram* program(FragmentCoverage coverage);
  MadeDrawStates& draw_states() { return draw_states_; }
  void release_images();

 private:
  struct Destroy {
    void operator()(FragmentProgram* program) const { destroy_fragment_program(program); }
  };

  FragmentState state_;
  FragmentTarget target_;
  std::array<std::unique_ptr<FragmentProgram, Destroy>, kFragmentCoverages> programs_;
  std::array<bool, kFragmentCoverages> made_{};
  MadeDrawStates draw_states_;
};

class ProgramTable {
 public:
  // The holder of a state. Throws std::bad_alloc.
  ProgramHolder& find(const FragmentState& state, const FragmentTarget& target);

  // So many states were asked for that the frame should end.
  bool is_full() const { return used_ >= kMaxStates; }

  // The frame is done.
  void reset();

 private:
  static constexpr size_t kMaxStates = 2048;
  static constexpr size_t kSlots = 2 * kMaxStates;  // a power of two

  std::vector<std::unique_ptr<ProgramHolder>> holders_;  // the first used_ are in use
  size_t used_ = 0;
  // By hash, linear probing: the number of a holder and 1, or 0. Empty until first used.
  std::vector<uint16_t> slots_;
  std::vector<uint16_t> taken_;  // the slots in use
};

}  // namespace clearpipe::pipeline
