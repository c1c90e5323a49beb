// SPDX-License-Identifier: MIT
//
// Small measurements of single kinds of work, in OpenGL ES 1.1 and EGL alone, so that the same
// program measures whichever implementation the loader picks: the fill of a whole surface with
// different fragment state, small triangles, and small draws with and without changes of state
// between them. Every frame ends with glFinish. Each case runs for a fifth of a second after a
// warm-up, and prints one line, `draws: case="..." value=... unit="..."`, where more is slower.

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES/gl.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <vector>

namespace {

constexpr int kWidth = 1920;
constexpr int kHeight = 1080;
constexpr int kGrid = 128;  // small triangles: 2 * kGrid^2 of them
constexpr int kDrawsPerFrame = 500;

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "draws: %s failed\n", what);
  std::exit(1);
}

EGLDisplay open_display() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  EGLDisplay display = EGL_NO_DISPLAY;
  if (extensions && std::strstr(extensions, "EGL_MESA_platform_surfaceless")) {
    display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  }
  if (display == EGL_NO_DISPLAY) display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) fail("eglInitialize");
  return display;
}

void open_surface(EGLDisplay display) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
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
  const EGLint size[] = {EGL_WIDTH, kWidth, EGL_HEIGHT, kHeight, EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1) fail("eglChooseConfig");
  eglBindAPI(EGL_OPENGL_ES_API);
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  EGLSurface surface = eglCreatePbufferSurface(display, config, size);
  if (!eglMakeCurrent(display, surface, surface, context)) fail("eglMakeCurrent");
}

// Runs frames for a fifth of a second and prints the time of one unit of work, of which a frame
// holds `units`.
void measure(const char* name, double units, const char* unit, double scale,
             const std::function<void()>& frame) {
  using Clock = std::chrono::steady_clock;
  for (int i = 0; i < 3; ++i) {
    frame();
    glFinish();
  }
  const Clock::time_point start = Clock::now();
  double seconds = 0;
  int frames = 0;
  while (seconds < 0.2) {
    frame();
    glFinish();
    ++frames;
    seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
  if (glGetError() != GL_NO_ERROR) fail(name);
  std::printf("draws: case=\"%s\" value=%.4f unit=\"%s\"\n", name,
              scale * seconds / (frames * units), unit);
}

// A texture of 256 x 256 with noise in it, filtered bilinearly.
GLuint make_texture(unsigned seed) {
  constexpr int kSize = 256;
  std::vector<unsigned char> texels(kSize * kSize * 4);
  for (unsigned char& texel : texels) {
    seed = seed * 1664525u + 1013904223u;
    texel = static_cast<unsigned char>(seed >> 24);
  }
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texels.data());
  return name;
}

void measure_fill() {
  static const GLfloat corners[] = {-1, -1, 0.5f, 1, -1, 0.5f, -1, 1, 0.5f, 1, 1, 0.5f};
  static const GLubyte colours[] = {255, 40, 40,  255, 40,  255, 40, 200,
                                    40,  40, 255, 150, 250, 250, 30, 100};
  // About two texels for three pixels, turned a little, so that no row of texels falls on a row of
  // pixels.
  static const GLfloat coordinates[] = {0, 0, 5, 0.3f, -0.3f, 3, 4.7f, 3.3f};
  const double pixels = double(kWidth) * kHeight;
  const auto quad = [] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 4); };

  glVertexPointer(3, GL_FLOAT, 0, corners);
  glColorPointer(4, GL_UNSIGNED_BYTE, 0, colours);
  glEnableClientState(GL_VERTEX_ARRAY);
  measure("clear", pixels, "ns/pixel", 1e9,
          [] { glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); });
  measure("fill, flat", pixels, "ns/pixel", 1e9, quad);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_DEPTH_TEST);
  measure("fill, flat, depth", pixels, "ns/pixel", 1e9, quad);
  glEnableClientState(GL_COLOR_ARRAY);
  measure("fill, gouraud, depth", pixels, "ns/pixel", 1e9, quad);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  measure("fill, gouraud, depth, blending", pixels, "ns/pixel", 1e9, quad);
  glDisable(GL_BLEND);

  for (GLuint unit = 0; unit < 2; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glClientActiveTexture(GL_TEXTURE0 + unit);
    make_texture(unit + 1);
    glEnable(GL_TEXTURE_2D);
    glTexCoordPointer(2, GL_FLOAT, 0, coordinates);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    measure(unit == 0 ? "fill, bilinear, gouraud, depth" : "fill, two textures, gouraud, depth",
            pixels, "ns/pixel", 1e9, quad);
  }
  for (GLuint unit = 0; unit < 2; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glClientActiveTexture(GL_TEXTURE0 + unit);
    glDisable(GL_TEXTURE_2D);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  }
  glDisableClientState(GL_COLOR_ARRAY);
}

// A grid of triangles over half of the surface, lit by one light, each some 30 pixels large.
void measure_small_triangles() {
  std::vector<GLfloat> positions;
  std::vector<GLushort> indices;
  for (int y = 0; y <= kGrid; ++y) {
    for (int x = 0; x <= kGrid; ++x) {
      positions.insert(positions.end(),
                       {1.4f * float(x) / kGrid - 0.7f, 1.4f * float(y) / kGrid - 0.7f, 0.0f});
    }
  }
  for (int y = 0; y < kGrid; ++y) {
    for (int x = 0; x < kGrid; ++x) {
      const int corner = y * (kGrid + 1) + x;
      for (int step : {0, 1, kGrid + 1, 1, kGrid + 2, kGrid + 1})
        indices.push_back(GLushort(corner + step));
    }
  }
  GLuint buffers[2];
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(positions.size() * sizeof(GLfloat)), positions.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(GLushort)),
               indices.data(), GL_STATIC_DRAW);
  glVertexPointer(3, GL_FLOAT, 0, nullptr);
  const auto grid = [&indices] {
    glDrawElements(GL_TRIANGLES, GLsizei(indices.size()), GL_UNSIGNED_SHORT, nullptr);
  };
  measure("small triangles, depth", 2.0 * kGrid * kGrid, "ns/triangle", 1e9, grid);
  glNormal3f(0, 0, 1);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  measure("small triangles, depth, one light", 2.0 * kGrid * kGrid, "ns/triangle", 1e9, grid);
  glDisable(GL_LIGHTING);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

// Many draws of one small triangle: what a call costs.
void measure_small_draws() {
  static const GLfloat corners[] = {0, 0, 0, 0.01f, 0, 0, 0, 0.01f, 0};
  glVertexPointer(3, GL_FLOAT, 0, corners);
  measure("small draws", kDrawsPerFrame, "us/draw", 1e6, [] {
    for (int i = 0; i < kDrawsPerFrame; ++i) glDrawArrays(GL_TRIANGLES, 0, 3);
  });
  measure("small draws, blending flips", kDrawsPerFrame, "us/draw", 1e6, [] {
    for (int i = 0; i < kDrawsPerFrame; ++i) {
      i % 2 == 0 ? glEnable(GL_BLEND) : glDisable(GL_BLEND);
      glDrawArrays(GL_TRIANGLES, 0, 3);
    }
  });
  glDisable(GL_BLEND);
}

}  // namespace

int main() {
  EGLDisplay display = open_display();
  open_surface(display);
  glViewport(0, 0, kWidth, kHeight);
  std::printf("draws: renderer=\"%s\"\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
  measure_fill();
  measure_small_triangles();
  measure_small_draws();
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglTerminate(display);
  return 0;
}
