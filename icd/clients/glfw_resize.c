/* A program of GLFW in a window of OpenGL ES 1.1, resized while it draws. Every frame is a picture
 * of the window's size: rows of a triangle that covers the viewport, and below them a border of one
 * pixel, which show when the surface is larger or smaller than the window, or drawn with the
 * viewport of another frame.
 *
 * Fails unless the surface takes each size, each frame of that size is right to the last pixel, and
 * frames drawn while the window is being resized give no error.
 *
 * SPDX-License-Identifier: MIT */
#define GLFW_INCLUDE_NONE
#include <EGL/egl.h>
#include <GLES/gl.h>
#include <GLFW/glfw3.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { kWhiteRows = 3, kDiagonal = 20 };

static void die(const char* what) {
  const char* reason = NULL;
  glfwGetError(&reason);
  fprintf(stderr, "glfw_resize: %s: %s\n", what, reason ? reason : "");
  exit(1);
}

static void fill(int x, int y, int width, int height, float r, float g, float b) {
  glScissor(x, y, width, height);
  glClearColor(r, g, b, 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

/* A white triangle larger than the viewport, of which the upper rows stay; a green border around
 * blue; a red diagonal from the lower left. */
static void draw(int width, int height) {
  static const float kTriangle[] = {-3, -1, 3, -1, 0, 5};
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);
  glVertexPointer(2, GL_FLOAT, 0, kTriangle);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_SCISSOR_TEST);
  fill(0, 0, width, height - kWhiteRows, 0, 1, 0);
  fill(1, 1, width - 2, height - kWhiteRows - 2, 0, 0, 1);
  for (int i = 1; i < kDiagonal; ++i) fill(i, i, 1, 1, 1, 0, 0);
}

/* How many pixels are not what `draw` draws. */
static int wrong_pixels(int width, int height) {
  uint32_t* pixels = malloc((size_t)width * (size_t)height * sizeof *pixels);
  if (!pixels) die("memory");
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  int wrong = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int white = y >= height - kWhiteRows;
      const int border = x == 0 || y == 0 || x == width - 1 || y == height - kWhiteRows - 1;
      const int diagonal = x == y && x >= 1 && x < kDiagonal;
      const uint32_t expected = white      ? 0xffffffu
                                : border   ? 0x00ff00u
                                : diagonal ? 0x0000ffu
                                           : 0xff0000u;
      wrong += (pixels[y * width + x] & 0xffffffu) != expected;
    }
  }
  free(pixels);
  return wrong;
}

static EGLint surface_size(EGLint axis) {
  EGLint value = -1;
  eglQuerySurface(eglGetCurrentDisplay(), eglGetCurrentSurface(EGL_DRAW), axis, &value);
  return value;
}

int main(void) {
  static const int kSizes[][2] = {{320, 240}, {200, 300}, {641, 479},
                                  {64, 48},   {500, 33},  {320, 240}};
  enum { kCount = sizeof kSizes / sizeof *kSizes };
  if (!glfwInit()) die("glfwInit");
  glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 1);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
  glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
  GLFWwindow* window = glfwCreateWindow(kSizes[0][0], kSizes[0][1], "resize", NULL, NULL);
  if (!window) die("glfwCreateWindow");
  glfwMakeContextCurrent(window);
  glfwSwapInterval(0);
  printf("glfw_resize: %s, %s, %s\n", glfwGetVersionString(), (const char*)glGetString(GL_VERSION),
         (const char*)glGetString(GL_RENDERER));
  glEnableClientState(GL_VERTEX_ARRAY);

  int right_sizes = 0, frames = 0; /* with those while the size changed */
  for (int i = 0; i < kCount; ++i) {
    const int wanted_width = kSizes[i][0], wanted_height = kSizes[i][1];
    ++frames;
    int old_width = 0, old_height = 0;
    glfwGetFramebufferSize(window, &old_width, &old_height);
    draw(old_width, old_height);
    glfwSetWindowSize(window, wanted_width, wanted_height);
    glfwSwapBuffers(window); /* a frame of the old size in a window of the new one */
    const double begin = glfwGetTime();
    int settled = 0;
    while (!settled) {
      int width = 0, height = 0;
      glfwGetFramebufferSize(window, &width, &height);
      draw(width, height);
      const int matches = width == wanted_width && height == wanted_height &&
                          surface_size(EGL_WIDTH) == width && surface_size(EGL_HEIGHT) == height;
      /* Read before the swap, after which the buffer is undefined. */
      const int wrong = matches ? wrong_pixels(width, height) : 0;
      glfwSwapBuffers(window);
      glfwPollEvents();
      ++frames;
      settled = matches;
      if (matches && wrong == 0) ++right_sizes;
      if (matches && wrong != 0) {
        fprintf(stderr, "glfw_resize: %dx%d: %d pixels are wrong\n", width, height, wrong);
      }
      if (glfwGetTime() - begin > 20) die("the surface does not take the window's size");
    }
  }
  const GLenum error = glGetError();
  const EGLint egl_error = eglGetError();
  printf(
      "glfw_resize: %d of %d sizes are right to the last pixel; %d frames; errors 0x%04x, 0x%04x\n",
      right_sizes, (int)kCount, frames, error, egl_error);
  glfwDestroyWindow(window);
  glfwTerminate();
  return right_sizes == kCount && error == GL_NO_ERROR && egl_error == EGL_SUCCESS ? 0 : 1;
}
