// SPDX-License-Identifier: MIT
//
// Three meshing spur gears, lit, in OpenGL ES 1.1. The program is written against the Khronos
// headers and the system's libEGL and libGLESv1_CM alone, so that it shows whichever implementation
// the loader picks. It draws into a pbuffer, turns the gears by a fixed angle each frame, prints
// the frame rate on one line and can write its last frame as a PNG file.
//
//   gears [--frames N] [--size WxH] [--output file.png]

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES/gl.h>
#include <math.h>
#include <png.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static const float kPi = 3.14159265358979f;

// -----------------------------------------------------------------------------------------------
// A mesh: interleaved positions and normals, triangles by index, kept in two buffer objects once it
// is complete.

typedef struct {
  float position[3];
  float normal[3];
} Vertex;

typedef struct {
  Vertex* vertices;
  GLushort* indices;
  int vertex_count, vertex_capacity;
  int index_count, index_capacity;
  GLuint buffers[2];
} Mesh;

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

static void draw(const Mesh* mesh) {
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

static void build_gear(Gear* gear) {
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
static void mesh_with(Gear* driven, const Gear* driver, float direction) {
  const float distance = pitch_radius(driver) + pitch_radius(driven);
  const float driver_teeth = (float)driver->teeth / (2.0f * kPi);
  const float driven_teeth = (float)driven->teeth / (2.0f * kPi);
  driven->x = driver->x + distance * cosf(direction);
  driven->y = driver->y + distance * sinf(direction);
  driven->speed = -driver->speed * (float)driver->teeth / (float)driven->teeth;
  driven->phase =
      direction + kPi - (0.5f - (direction - driver->phase) * driver_teeth) / driven_teeth;
}

// -----------------------------------------------------------------------------------------------
// The scene.

static Gear gears[3] = {
    {.teeth = 24,
     .width = 1.2f,
     .web_width = 0.5f,
     .bore = 0.9f,
     .hub = 1.7f,
     .colour = {0.80f, 0.10f, 0.06f, 1.0f},
     .x = -2.6f,
     .y = -1.6f,
     .speed = 1.0f},
    {.teeth = 12,
     .width = 2.0f,
     .web_width = 1.4f,
     .bore = 0.45f,
     .hub = 0.85f,
     .colour = {0.05f, 0.65f, 0.16f, 1.0f}},
    {.teeth = 16,
     .width = 0.9f,
     .web_width = 0.4f,
     .bore = 1.1f,
     .hub = 1.5f,
     .colour = {0.12f, 0.25f, 0.90f, 1.0f}},
};

static void set_up_scene(int width, int height) {
  static const float light_position[4] = {-14.0f, 13.0f, -26.0f, 1.0f};
  static const float ambient[4] = {0.22f, 0.22f, 0.24f, 1.0f};
  static const float diffuse[4] = {0.95f, 0.95f, 0.92f, 1.0f};
  static const float white[4] = {1.0f, 1.0f, 1.0f, 1.0f};
  mesh_with(&gears[1], &gears[0], -15.0f * kPi / 180.0f);
  mesh_with(&gears[2], &gears[0], 52.0f * kPi / 180.0f);
  for (int i = 0; i < 3; ++i) build_gear(&gears[i]);

  const float aspect = (float)height / (float)width;
  const float half = aspect < 0.75f ? 0.75f / aspect : 1.0f;  // the gears fit a frame of 4:3
  glViewport(0, 0, width, height);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustumf(-half, half, -half * aspect, half * aspect, 5.0f, 80.0f);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glLightfv(GL_LIGHT0, GL_POSITION, light_position);
  glLightfv(GL_LIGHT0, GL_AMBIENT, ambient);
  glLightfv(GL_LIGHT0, GL_DIFFUSE, diffuse);
  glLightfv(GL_LIGHT0, GL_SPECULAR, white);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  glClearColor(0.09f, 0.10f, 0.12f, 1.0f);
}

static void draw_frame(int frame) {
  static const float shine[4] = {0.55f, 0.55f, 0.55f, 1.0f};
  const float turned = 1.5f * (float)frame;  // degrees of gear 0
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glPushMatrix();
  glTranslatef(0.2f, -0.5f, -56.0f);
  glRotatef(22.0f, 1.0f, 0.0f, 0.0f);
  glRotatef(28.0f, 0.0f, 1.0f, 0.0f);
  for (int i = 0; i < 3; ++i) {
    const Gear* gear = &gears[i];
    glPushMatrix();
    glTranslatef(gear->x, gear->y, 0.0f);
    glRotatef(gear->phase * 180.0f / kPi + gear->speed * turned, 0.0f, 0.0f, 1.0f);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, gear->colour);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 18.0f);
    draw(&gear->mesh);
    glPopMatrix();
  }
  glPopMatrix();
}

// -----------------------------------------------------------------------------------------------
// EGL, the clock, the PNG file.

static void fail(const char* what) {
  fprintf(stderr, "gears: %s failed (EGL error 0x%04x)\n", what, (unsigned)eglGetError());
  exit(1);
}

// A display without any window system where the implementation offers one, else the default
// display.
static EGLDisplay open_display(void) {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  EGLDisplay display = EGL_NO_DISPLAY;
  if (extensions && strstr(extensions, "EGL_MESA_platform_surfaceless")) {
    display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  }
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL)) {
    display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL)) fail("eglInitialize");
  }
  return display;
}

static EGLSurface open_pbuffer(EGLDisplay display, int width, int height) {
  static const EGLint config_attributes[] = {EGL_SURFACE_TYPE,
                                             EGL_PBUFFER_BIT,
                                             EGL_RENDERABLE_TYPE,
                                             EGL_OPENGL_ES_BIT,
                                             EGL_RED_SIZE,
                                             8,
                                             EGL_GREEN_SIZE,
                                             8,
                                             EGL_BLUE_SIZE,
                                             8,
                                             EGL_ALPHA_SIZE,
                                             8,
                                             EGL_DEPTH_SIZE,
                                             24,
                                             EGL_NONE};
  static const EGLint context_attributes[] = {EGL_CONTEXT_CLIENT_VERSION, 1, EGL_NONE};
  const EGLint surface_attributes[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  if (!eglChooseConfig(display, config_attributes, &config, 1, &count) || count < 1) {
    fail("eglChooseConfig");
  }
  if (!eglBindAPI(EGL_OPENGL_ES_API)) fail("eglBindAPI");
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, context_attributes);
  if (context == EGL_NO_CONTEXT) fail("eglCreateContext");
  EGLSurface surface = eglCreatePbufferSurface(display, config, surface_attributes);
  if (surface == EGL_NO_SURFACE) fail("eglCreatePbufferSurface");
  if (!eglMakeCurrent(display, surface, surface, context)) fail("eglMakeCurrent");
  return surface;
}

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void write_png(const char* path, int width, int height) {
  unsigned char* pixels = malloc((size_t)width * (size_t)height * 4);
  png_image image;
  memset(&image, 0, sizeof(image));
  image.version = PNG_IMAGE_VERSION;
  image.width = (png_uint_32)width;
  image.height = (png_uint_32)height;
  image.format = PNG_FORMAT_RGBA;
  if (!pixels) {
    fprintf(stderr, "gears: out of memory\n");
    exit(1);
  }
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  // The rows come bottom first: a negative stride turns them over.
  if (!png_image_write_to_file(&image, path, 0, pixels, -width * 4, NULL)) {
    fprintf(stderr, "gears: %s: %s\n", path, image.message);
    exit(1);
  }
  free(pixels);
}

static void usage(void) {
  fprintf(stderr, "usage: gears [--frames N] [--size WxH] [--output file.png]\n");
  exit(2);
}

int main(int argc, char** argv) {
  int frames = 300, width = 800, height = 600;
  const char* output = NULL;
  for (int i = 1; i < argc; i += 2) {
    char end = 0;
    if (i + 1 == argc) usage();
    if (!strcmp(argv[i], "--frames")) {
      if (sscanf(argv[i + 1], "%d%c", &frames, &end) != 1 || frames < 1) usage();
    } else if (!strcmp(argv[i], "--size")) {
      if (sscanf(argv[i + 1], "%dx%d%c", &width, &height, &end) != 2) usage();
      if (width < 1 || height < 1 || width > 16384 || height > 16384) usage();
    } else if (!strcmp(argv[i], "--output")) {
      output = argv[i + 1];
    } else {
      usage();
    }
  }

  EGLDisplay display = open_display();
  EGLSurface surface = open_pbuffer(display, width, height);
  set_up_scene(width, height);

  // The first frame may carry work that is done once, so it is timed by itself.
  const double start = now();
  draw_frame(0);
  glFinish();
  const double first = now();
  for (int frame = 1; frame < frames; ++frame) {
    eglSwapBuffers(display, surface);
    draw_frame(frame);
    glFinish();
  }
  const double seconds = frames > 1 ? now() - first : first - start;
  const double fps = (frames > 1 ? frames - 1 : 1) / seconds;

  if (output) write_png(output, width, height);
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR) {
    fprintf(stderr, "gears: OpenGL ES error 0x%04x\n", error);
    return 1;
  }
  printf("gears: fps=%.1f frames=%d size=%dx%d first_frame_ms=%.2f renderer=\"%s\"\n", fps, frames,
         width, height, 1e3 * (first - start), (const char*)glGetString(GL_RENDERER));
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglTerminate(display);
  return 0;
}
