// A draw as a frame holds it. SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "pipeline/clip/clip.h"
#include "pipeline/command.h"
#include "pipeline/fragment/program.h"
#include "pipeline/setup/primitive.h"

namespace clearpipe::pipeline {

// What a draw needs besides its vertices; draws share it until state changes.
struct DrawState {
  // The same number: the vertex states differ in their matrices alone, and vertices of the draws
  // can come out of one vertex job.
  uint32_t vertex_group = 0;
  const FragmentProgram* program = nullptr;
  FragmentOutputs outputs;
  bool may_draw_dots = false;  // see dots.h
  bool draws_strokes = false;  // see strokes.h
  bool shades_points = false;  // points larger than small primitives need no batch
  SetupState setup;
  ClipState clip;
};

// A recorded draw. All it points to is good until the frame is done.
struct DrawRecord {
  const DrawState* state = nullptr;
  const VertexState* vertex = nullptr;  // by itself: matrices often change alone
  // Where attributes come from, perhaps together with those of other draws; of what else a command
  // says only whether it draws points is of interest here.
  const DrawCommand* sources = nullptr;
  Primitive primitive = Primitive::kTriangles;
  IndexType index_type = IndexType::kNone;
  uint32_t first = 0, count = 0;
  const std::byte* indices = nullptr;
  uint32_t index_base = 0;  // subtracted from every element index: arrays were copied
  // Of large indexed draws (shared_vertices.h): the vertex records of the elements from
  // `first_shared` on. Else null, and packets make their own.
  const float* shared = nullptr;
  uint32_t first_shared = 0;
};

}  // namespace clearpipe::pipeline
