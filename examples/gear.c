// SPDX-License-Identifier: MIT
//
// Gears as triangles: an outline of teeth whose flanks are involutes, and rings and walls between
// circles. A mesh is kept in two buffer objects once it is complete.

#include "gear.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Vertex {
  float position[3];
  float normal[3];
} Vertex;

static void* grow(void* block, int* capacity, int needed, size_t item) {
  if (needed <= *capacity) return block;
  *capacity = needed * 2;
  block = realloc(block, (size_t)*capacity * item);
  if (!block) {
    fprintf(stderr, "gears: out of memory\n");
    exit(1);
  }
  return block;
}

static GLushort add_vertex(Mesh* mesh, float x, float y, float z, float nx, float ny, float nz) {
  mesh->vertices =
      grow(mesh->vertices, &mesh->vertex_capacity, mesh->vertex_count + 1, sizeof(Vertex));
  const Vertex vertex = {{x, y, z}, {nx, ny, nz}};
  mesh->vertices[mesh->vertex_count] = vertex;
  return (GLushort)mesh->vertex_count++;
}

// Two triangles over the corners a, b, c, d, which are given counter-clockwise as seen from
// outside.
static void add_quad(Mesh* mesh, GLushort a, GLushort b, GLushort c, GLushort d) {
  const GLushort corners[6] = {a, b, c, a, c, d};
  mesh->indices =
      grow(mesh->indices, &mesh->index_capacity, mesh->index_count + 6, sizeof(GLushort));
  memcpy(mesh->indices + mesh->index_count, corners, sizeof(corners));
  mesh->index_count += 6;
}

static void upload(Mesh* mesh) {
  glGenBuffers(2, mesh->buffers);
  glBindBuffer(GL_ARRAY_BUFFER, mesh->buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)((size_t)mesh->vertex_count * sizeof(Vertex)),
               mesh->vertices, GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh->buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)((size_t)mesh->index_count * sizeof(GLushort)),
               mesh->indices, GL_STATIC_DRAW);
  free(mesh->vertices);
  free(mesh->indices);
  mesh->vertices = NULL;
  mesh->indices = NULL;
}

void draw_gear(const Gear* gear) {
  const Mesh* mesh = &gear->mesh;
  glBindBuffer(GL_ARRAY_BUFFER, mesh->buffers[0]);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh->buffers[1]);
  glVertexPointer(3, GL_FLOAT, sizeof(Vertex), (const void*)offsetof(Vertex, position));
  glNormalPointer(GL_FLOAT, sizeof(Vertex), (const void*)offsetof(Vertex, normal));
  glDrawElements(GL_TRIANGLES, mesh->index_count, GL_UNSIGNED_SHORT, NULL);
}

// -----------------------------------------------------------------------------------------------
// A gear. Every length is in units of the module (pitch diameter / teeth), so that gears of one
// module mesh. The outline follows the involute of the base circle: seen from the centre, half the
// tooth's thickness at radius r is pi/(2 teeth) + inv(pressure) - inv(acos(base/r)), where inv(a) =
// tan(a) - a.

enum { kFlankSteps = 5, kTipSteps = 2, kRootSteps = 3 };

static const float kPressure = 20.0f * 3.14159265358979f / 180.0f;
static const float kModule = 0.4f;

static float pitch_radius(const Gear* gear) { return 0.5f * kModule * (float)gear->teeth; }

static float involute(float angle) { return tanf(angle) - angle; }

static float half_thickness(const Gear* gear, float radius) {
  const float base = pitch_radius(gear) * cosf(kPressure);
  const float at_pitch = 0.94f * kPi / (2.0f * (float)gear->teeth);  // 6% of backlash
  const float ratio = radius > base ? base / radius : 1.0f;
  return at_pitch + involute(kPressure) - involute(acosf(ratio));
}

typedef struct {
  float radius, angle;
  int corner;  // the outline has a sharp edge here
} OutlinePoint;

// The outline of one tooth, from the middle of a root to just before the middle of the next;
// returns the number of points.
static int tooth_outline(const Gear* gear, int tooth, OutlinePoint* out) {
  const float pitch_angle = 2.0f * kPi / (float)gear->teeth;
  const float centre = (float)tooth * pitch_angle;
  const float tip = pitch_radius(gear) + 0.9f * kModule;
  const float root = pitch_radius(gear) - 1.15f * kModule;
  const float root_half = half_thickness(gear, root);
  const float tip_half = half_thickness(gear, tip);
  int n = 0;
  for (int i = 0; i < kRootSteps; ++i) {
    const float from = -0.5f * pitch_angle, t = (float)i / kRootSteps;
    out[n++] = (OutlinePoint){root, centre + from + (-root_half - from) * t, 0};
  }
  for (int i = 0; i < kFlankSteps; ++i) {
    const float radius = root + (tip - root) * (float)i / kFlankSteps;
    out[n++] = (OutlinePoint){radius, centre - half_thickness(gear, radius), i == 0};
  }
  for (int i = 0; i <= kTipSteps; ++i) {
    const float angle = -tip_half + 2.0f * tip_half * (float)i / kTipSteps;
    out[n++] = (OutlinePoint){tip, centre + angle, i == 0 || i == kTipSteps};
  }
  for (int i = 1; i <= kFlankSteps; ++i) {
    const float radius = tip + (root - tip) * (float)i / kFlankSteps;
    out[n++] = (OutlinePoint){radius, centre + half_thickness(gear, radius), i == kFlankSteps};
  }
  for (int i = 1; i < kRootSteps; ++i) {
    const float to = 0.5f * pitch_angle, t = (float)i / kRootSteps;
    out[n++] = (OutlinePoint){root, centre + root_half + (to - root_half) * t, 0};
  }
  return n;
}

// A ring in the plane z, between a circle and either a second circle or the outline (outer_radius
// 0); side is the z of its normal.
static void add_ring(Mesh* mesh, const OutlinePoint* outline, int count, float inner_radius,
                     float outer_radius, float z, float side) {
  GLushort previous[2] = {0, 0};
  for (int i = 0; i <= count; ++i) {
    const OutlinePoint* p = &outline[i % count];
    const float outer = outer_radius > 0.0f ? outer_radius : p->radius;
    const float c = cosf(p->angle), s = sinf(p->angle);
    const GLushort in = add_vertex(mesh, inner_radius * c, inner_radius * s, z, 0, 0, side);
    const GLushort far = add_vertex(mesh, outer * c, outer * s, z, 0, 0, side);
    if (i > 0 && side > 0) add_quad(mesh, previous[0], previous[1], far, in);
    if (i > 0 && side < 0) add_quad(mesh, previous[0], in, far, previous[1]);
    previous[0] = in;
    previous[1] = far;
  }
}

// A wall of a circle from z0 up to z1 with smooth normals, facing away from the axle (facing 1) or
// towards it (facing -1).
static void add_tube(Mesh* mesh, const OutlinePoint* outline, int count, float radius, float z0,
                     float z1, float facing) {
  GLushort previous[2] = {0, 0};
  for (int i = 0; i <= count; ++i) {
    const float c = cosf(outline[i % count].angle), s = sinf(outline[i % count].angle);
    const GLushort low = add_vertex(mesh, radius * c, radius * s, z0, facing * c, facing * s, 0);
    const GLushort high = add_vertex(mesh, radius * c, radius * s, z1, facing * c, facing * s, 0);
    if (i > 0 && facing > 0) add_quad(mesh, previous[0], low, high, previous[1]);
    if (i > 0 && facing < 0) add_quad(mesh, previous[0], previous[1], high, low);
    previous[0] = low;
    previous[1] = high;
  }
}

// The unit normal of the outline's segment from point i to the next, pointing away from the gear.
static void segment_normal(const OutlinePoint* outline, int count, int i, float normal[2]) {
  const OutlinePoint* a = &outline[i % count];
  const OutlinePoint* b = &outline[(i + 1) % count];
  const float dx = b->radius * cosf(b->angle) - a->radius * cosf(a->angle);
  const float dy = b->radius * sinf(b->angle) - a->radius * sinf(a->angle);
  const float length = sqrtf(dx * dx + dy * dy);
  normal[0] = dy / length;
  normal[1] = -dx / length;
}

// The toothed wall: normals are shared along a flank, a tip or a root, and split where the outline
// has a corner.
static void add_teeth(Mesh* mesh, const OutlinePoint* outline, int count, float z0, float z1) {
  for (int i = 0; i < count; ++i) {
    float here[2], neighbour[2];
    GLushort corner[2][2];
    segment_normal(outline, count, i, here);
    for (int end = 0; end < 2; ++end) {
      const OutlinePoint* p = &outline[(i + end) % count];
      float nx = here[0], ny = here[1];
      if (!p->corner) {
        segment_normal(outline, count, end ? i + 1 : i + count - 1, neighbour);
        nx += neighbour[0];
        ny += neighbour[1];
        const float length = sqrtf(nx * nx + ny * ny);
        nx /= length;
        ny /= length;
      }
      const float x = p->radius * cosf(p->angle), y = p->radius * sinf(p->angle);
      corner[end][0] = add_vertex(mesh, x, y, z0, nx, ny, 0);
      corner[end][1] = add_vertex(mesh, x, y, z1, nx, ny, 0);
    }
    add_quad(mesh, corner[0][0], corner[1][0], corner[1][1], corner[0][1]);
  }
}

void build_gear(Gear* gear) {
  enum { kPerTooth = 2 * kRootSteps + 2 * kFlankSteps + kTipSteps };
  OutlinePoint* outline = malloc(sizeof(OutlinePoint) * kPerTooth * (size_t)gear->teeth);
  if (!outline) {
    fprintf(stderr, "gears: out of memory\n");
    exit(1);
  }
  int count = 0;
  for (int tooth = 0; tooth < gear->teeth; ++tooth) {
    count += tooth_outline(gear, tooth, outline + count);
  }
  const float rim = pitch_radius(gear) - 2.1f * kModule;
  const float face = 0.5f * gear->width, web = 0.5f * gear->web_width;
  for (float side = 1.0f; side >= -1.0f; side -= 2.0f) {
    add_ring(&gear->mesh, outline, count, rim, 0.0f, side * face, side);
    add_ring(&gear->mesh, outline, count, gear->hub, rim, side * web, side);
    add_ring(&gear->mesh, outline, count, gear->bore, gear->hub, side * face, side);
    const float low = side > 0 ? web : -face, high = side > 0 ? face : -web;
    add_tube(&gear->mesh, outline, count, rim, low, high, -1.0f);
    add_tube(&gear->mesh, outline, count, gear->hub, low, high, 1.0f);
  }
  add_tube(&gear->mesh, outline, count, gear->bore, -face, face, -1.0f);
  add_teeth(&gear->mesh, outline, count, -face, face);
  free(outline);
  upload(&gear->mesh);
}

// Puts the axle of `driven` so that its pitch circle touches the driver's in the given direction,
// and turns it so that a tooth of one meets a gap of the other there: counted in teeth, the two
// positions at the contact add up to one half.
void mesh_with(Gear* driven, const Gear* driver, float direction) {
  const float distance = pitch_radius(driver) + pitch_radius(driven);
  const float driver_teeth = (float)driver->teeth / (2.0f * kPi);
  const float driven_teeth = (float)driven->teeth / (2.0f * kPi);
  driven->x = driver->x + distance * cosf(direction);
  driven->y = driver->y + distance * sinf(direction);
  driven->speed = -driver->speed * (float)driver->teeth / (float)driven->teeth;
  driven->phase =
      direction + kPi - (0.5f - (direction - driver->phase) * driver_teeth) / driven_teeth;
}
