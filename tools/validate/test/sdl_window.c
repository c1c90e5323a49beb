// A program of SDL2 with a window of OpenGL ES 1.1, which turns a triangle by SDL's clock.
// SPDX-License-Identifier: MIT
#include <SDL2/SDL.h>
#include <SDL2/SDL_opengles.h>
#include <stdio.h>

static int fail(const char* what) {
  fprintf(stderr, "sdl_window: %s: %s\n", what, SDL_GetError());
  return 1;
}

int main(void) {
  // The one way to EGL that SDL has on X11.
  SDL_SetHint(SDL_HINT_VIDEO_X11_FORCE_EGL, "1");
  if (SDL_Init(SDL_INIT_VIDEO) != 0) return fail("SDL_Init");
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 1);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 1);
  SDL_Window* window = SDL_CreateWindow("triangle", 0, 0, 160, 120, SDL_WINDOW_OPENGL);
  if (!window) return fail("SDL_CreateWindow");
  SDL_GLContext context = SDL_GL_CreateContext(window);
  if (!context) return fail("SDL_GL_CreateContext");

  void (*clear_color)(GLfloat, GLfloat, GLfloat, GLfloat) = SDL_GL_GetProcAddress("glClearColor");
  void (*clear)(GLbitfield) = SDL_GL_GetProcAddress("glClear");
  void (*load_identity)(void) = SDL_GL_GetProcAddress("glLoadIdentity");
  void (*rotate)(GLfloat, GLfloat, GLfloat, GLfloat) = SDL_GL_GetProcAddress("glRotatef");
  void (*enable)(GLenum) = SDL_GL_GetProcAddress("glEnableClientState");
  void (*vertices)(GLint, GLenum, GLsizei, const void*) = SDL_GL_GetProcAddress("glVertexPointer");
  void (*colours)(GLint, GLenum, GLsizei, const void*) = SDL_GL_GetProcAddress("glColorPointer");
  void (*draw)(GLenum, GLint, GLsizei) = SDL_GL_GetProcAddress("glDrawArrays");

  static const GLfloat kCorners[] = {0, 0.9f, -0.8f, -0.6f, 0.8f, -0.6f};
  static const GLubyte kColours[] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255};
  for (int frame = 0; frame < 1000; ++frame) {
    SDL_Event event;
    while (SDL_PollEvent(&event)) {
      if (event.type == SDL_QUIT) return 0;
    }
    clear_color(0.1f, 0.1f, 0.15f, 1);
    clear(GL_COLOR_BUFFER_BIT);
    load_identity();
    rotate((GLfloat)SDL_GetTicks() * 0.5f, 0, 0, 1);
    enable(GL_VERTEX_ARRAY);
    enable(GL_COLOR_ARRAY);
    vertices(2, GL_FLOAT, 0, kCorners);
    colours(4, GL_UNSIGNED_BYTE, 0, kColours);
    draw(GL_TRIANGLES, 0, 3);
    SDL_GL_SwapWindow(window);
    SDL_Delay(3);
  }
  return 0;
}
