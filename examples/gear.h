// SPDX-License-Identifier: MIT
//
// A spur gear of the gears example: its shape as triangles in buffer objects, and where it stands.
#ifndef EXAMPLES_GEAR_H
#define EXAMPLES_GEAR_H

#include <GLES/gl.h>

static const float kPi = 3.14159265358979f;

// Interleaved positions and normals, triangles by index.
struct Vertex;
typedef struct {
  struct Vertex* vertices;
  GLushort* indices;
  int vertex_count, vertex_capacity;
  int index_count, index_capacity;
  GLuint buffers[2];
} Mesh;

typedef struct {
  int teeth;
  float width;      // of the rim and the hub
  float web_width;  // of the disc between them
  float bore, hub;  // radii
  float colour[4];
  float x, y;   // the axle
  float phase;  // radians by which the first tooth is turned from +x, for gear 0's angle 0
  float speed;  // turns for each turn of gear 0
  Mesh mesh;
} Gear;

// Makes the mesh of a gear whose teeth, widths and radii are given. A context must be current.
void build_gear(Gear* gear);
// Puts the driven gear beside the driver, in this direction from it, so that their teeth mesh.
void mesh_with(Gear* driven, const Gear* driver, float direction);
// With arrays of vertices and normals enabled.
void draw_gear(const Gear* gear);

#endif
