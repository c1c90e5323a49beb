// A frame: the commands recorded since the last flush, and the machinery that executes them.
//
// api/ records into it from the context's thread; `finish` runs the two phases on all cores (front:
// vertex, clip, setup, bin; back: raster, fragment, merge per tile) and returns when every pixel is
// in the surfaces. The workers may begin with that while draws are recorded. Memory is kept between
// frames: a steady frame allocates nothing. SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "pipeline/command.h"
#include "pipeline/surface.h"

namespace clearpipe::pipeline {

class Frame {
 public:
  Frame();
  ~Frame();
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

  // Commands after this go to `target`. Pending commands for another target are finished first.
  void set_target(const Target& target);

  // State for the following draws. Copied; call only when it changed.
  void set_vertex_state(const VertexState& state);
  void set_raster_state(const RasterState& state);
  void set_fragment_state(const FragmentState& state);

  // Records a draw; false when memory does not suffice. Client memory is read before return.
  bool draw(const DrawCommand& command);
  bool clear(const ClearCommand& command);

  // Executes everything recorded; the surfaces then hold the result.
  void finish();

  // Whether nothing waits for finish().
  bool empty() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clearpipe::pipeline
