// Taking a draw's vertex and index data into the frame.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/command.h"
#include "pipeline/exec/arena.h"
#include "pipeline/exec/client_copy.h"
#include "pipeline/exec/frame_data.h"
#include "pipeline/exec/vertex_stream.h"

namespace clearpipe::pipeline {

class ArrayRecorder {
 public:
  // Sets everything in `draw` but its state, all of it good until the frame is done. The vertices
  // of a small draw go to a stream. Of others, what lies in client memory is copied into the arena,
  // compactly and only the elements and attributes (a bit each) that are used; buffer objects are
  // held by reference. Throws std::bad_alloc.
  void record(const DrawCommand& command, uint32_t attributes, Arena& arena, DrawRecord& draw);

  // Workers begin with what is recorded.
  void leave_room() { streams_.leave_room(); }

  // The frame is done.
  void reset() {
    streams_.reset();
    buffers_.clear();
  }

 private:
  void hold(const BufferRef& buffer);
  bool record_small(const DrawCommand& command, uint32_t attributes, Arena& arena,
                    DrawRecord& draw);

  VertexStreams streams_;
  ClientCopies copies_;
  std::vector<BufferRef> buffers_;
};

}  // namespace clearpipe::pipeline
