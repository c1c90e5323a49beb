// SPDX-License-Identifier: MIT
//
// Meshes of small triangles: unlit, lit, skinned, cut by the near plane, from buffer objects and
// from client memory.
#include "bench/scene.h"
#include "bench/shapes.h"

#include <GLES/glext.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace bench {

namespace {

Mesh mesh;

double set_up_plate(const View& view) {
  int columns, rows;
  grid_of(view.amount, 4.0f / 3, &columns, &rows);
  mesh = wavy_plate(columns, rows);
  use_mesh(mesh);
  glEnable(GL_DEPTH_TEST);
  set_perspective(view.width, view.height, 45, 0.5f, 20);
  return mesh.triangles();
}

void pose(int number) {
  glClearColor(0.1f, 0.1f, 0.12f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glLoadIdentity();
  glTranslatef(0, 0, -2.7f);
  glRotatef(-25, 1, 0, 0);
  glRotatef(10 + 0.5f * float(number % 40), 0, 1, 0);
  glScalef(1.3f, 1, 1);
}

double set_up_unlit(const View& view) {
  glEnableClientState(GL_COLOR_ARRAY);
  return set_up_plate(view);
}

void plate(const View&, int number) {
  pose(number);
  draw_mesh(mesh);
}

// The first light is directional, the others stand around the plate, each of a colour of its own.
double set_up_lit(const View& view, int lights) {
  const GLfloat ambient[] = {0.1f, 0.1f, 0.1f, 1}, shine[] = {0.5f, 0.5f, 0.5f, 1};
  const GLfloat material[] = {0.8f, 0.8f, 0.75f, 1};
  glEnableClientState(GL_NORMAL_ARRAY);
  glEnable(GL_LIGHTING);
  glEnable(GL_NORMALIZE);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, material);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);
  for (int i = 0; i < lights; ++i) {
    const float angle = 0.785f * float(i), even = i % 2 == 0 ? 1.0f : 0.4f;
    const GLfloat position[] = {2 * std::cos(angle), 2 * std::sin(angle), i == 0 ? 1.0f : -1.5f,
                                i == 0 ? 0.0f : 1.0f};
    const GLfloat colour[] = {0.9f * even / float(lights) + 0.1f, 0.5f / float(lights) + 0.1f,
                              0.9f / even / float(lights), 1};
    const GLenum light = GLenum(GL_LIGHT0 + i);
    glEnable(light);
    glLightfv(light, GL_POSITION, position);
    glLightfv(light, GL_DIFFUSE, colour);
    glLightfv(light, GL_SPECULAR, colour);
  }
  return set_up_plate(view);
}

double set_up_two_lights(const View& view) { return set_up_lit(view, 2); }
double set_up_eight_lights(const View& view) { return set_up_lit(view, 8); }

// Four matrices bend the plate; a vertex has weights for two of them (GL_OES_matrix_palette).
constexpr int kBones = 4;
std::vector<GLubyte> bones;
std::vector<GLfloat> weights;
PFNGLMATRIXINDEXPOINTEROESPROC glMatrixIndexPointerOES;
PFNGLWEIGHTPOINTEROESPROC glWeightPointerOES;
PFNGLCURRENTPALETTEMATRIXOESPROC glCurrentPaletteMatrixOES;
PFNGLLOADPALETTEFROMMODELVIEWMATRIXOESPROC glLoadPaletteFromModelViewMatrixOES;

double set_up_skinned(const View& view) {
  const double triangles = set_up_unlit(view);
  find_function("glMatrixIndexPointerOES", glMatrixIndexPointerOES);
  find_function("glWeightPointerOES", glWeightPointerOES);
  find_function("glCurrentPaletteMatrixOES", glCurrentPaletteMatrixOES);
  find_function("glLoadPaletteFromModelViewMatrixOES", glLoadPaletteFromModelViewMatrixOES);
  bones.reserve(mesh.vertices.size() * 2);
  weights.reserve(mesh.vertices.size() * 2);
  for (const MeshVertex& vertex : mesh.vertices) {
    const float place = (vertex.position[0] + 1) / 2 * (kBones - 1);
    const int bone = std::min(int(place), kBones - 2);
    bones.insert(bones.end(), {GLubyte(bone), GLubyte(bone + 1)});
    weights.insert(weights.end(), {1 - (place - float(bone)), place - float(bone)});
  }
  GLuint buffers[2];
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(bones.size()), bones.data(), GL_STATIC_DRAW);
  glMatrixIndexPointerOES(2, GL_UNSIGNED_BYTE, 0, nullptr);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(weights.size() * sizeof(GLfloat)), weights.data(),
               GL_STATIC_DRAW);
  glWeightPointerOES(2, GL_FLOAT, 0, nullptr);
  glEnable(GL_MATRIX_PALETTE_OES);
  glEnableClientState(GL_MATRIX_INDEX_ARRAY_OES);
  glEnableClientState(GL_WEIGHT_ARRAY_OES);
  return triangles;
}

void skinned(const View&, int number) {
  pose(number);
  for (int bone = 0; bone < kBones; ++bone) {
    glPushMatrix();
    glRotatef(12.0f * float(bone) * std::sin(0.1f * float(number) + 1), 1, 0, 0);
    glMatrixMode(GL_MATRIX_PALETTE_OES);
    glCurrentPaletteMatrixOES(GLuint(bone));
    glLoadPaletteFromModelViewMatrixOES();
    glMatrixMode(GL_MODELVIEW);
    glPopMatrix();
  }
  draw_mesh(mesh);
}

// The eye is inside a tube, half of which is behind it.
double set_up_tube(const View& view) {
  int around, along;
  grid_of(view.amount, 1, &around, &along);
  mesh = tube(around, along);
  use_mesh(mesh);
  glEnableClientState(GL_COLOR_ARRAY);
  glEnable(GL_DEPTH_TEST);
  set_perspective(view.width, view.height, 70, 0.02f, 10);
  return mesh.triangles();
}

void in_the_tube(const View&, int number) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glLoadIdentity();
  glRotatef(20 + 0.5f * float(number % 40), 0.3f, 1, 0);
  draw_mesh(mesh);
}

// Staves of the tube, from behind the eye to its far end: every triangle crosses the near plane.
double set_up_staves(const View& view) {
  set_up_tube(view);
  mesh = tube(view.amount / 2, 1);
  use_mesh(mesh);
  return mesh.triangles();
}

// Triangles without indices, from memory that the implementation may not keep.
std::vector<MeshVertex> unshared;

double set_up_client_memory(const View& view) {
  const double triangles = set_up_unlit(view);
  unshared.reserve(mesh.indices.size());
  for (const GLuint index : mesh.indices) unshared.push_back(mesh.vertices[index]);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  glVertexPointer(3, GL_FLOAT, sizeof(MeshVertex), unshared.data()->position);
  glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(MeshVertex), unshared.data()->colour);
  return triangles;
}

void from_client_memory(const View&, int number) {
  pose(number);
  glDrawArrays(GL_TRIANGLES, 0, GLsizei(unshared.size()));
}

constexpr int kTriangles = 200000;

constexpr Scene scene(const char* name, const char* what, int triangles,
                      double (*set_up)(const View&), void (*frame)(const View&, int) = plate,
                      const char* extension = nullptr) {
  // Where triangles are as small as pixels, what Mesa computes a bit differently shows, highlights
  // most of all.
  return {.name = name,
          .what = what,
          .unit = "triangle",
          .amount = triangles,
          .set_up = set_up,
          .frame = frame,
          .extension = extension,
          .share = 0.95};
}

constexpr std::array kScenes = {
    scene("mesh_unlit", "200,000 triangles with colours", kTriangles, set_up_unlit),
    scene("mesh_two_lights", "the same, lit by 2 lights", kTriangles, set_up_two_lights),
    scene("mesh_eight_lights", "the same, lit by 8 lights", kTriangles, set_up_eight_lights),
    scene("mesh_skinned", "the same, bent by 4 matrices", kTriangles, set_up_skinned, skinned,
          "GL_OES_matrix_palette"),
    scene("mesh_half_behind", "200,000 triangles around the eye", kTriangles, set_up_tube,
          in_the_tube),
    scene("mesh_near_plane", "20,000 triangles that the near plane cuts", 20000, set_up_staves,
          in_the_tube),
    scene("mesh_client_memory", "50,000 triangles without indices, from client memory", 50000,
          set_up_client_memory, from_client_memory),
};

}  // namespace

std::span<const Scene> mesh_scenes() { return kScenes; }

}  // namespace bench
