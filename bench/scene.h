// SPDX-License-Identifier: MIT
//
// A scene of the bench: an ordinary OpenGL ES 1 program cut in two, what is done once and what a
// frame does. It knows no implementation. A process runs one scene, so scenes keep what they need
// in variables of their files.
//
// The picture of a frame depends on its number alone, so that pictures of two implementations can
// be held against each other; where a frame must find what the one before left, frame 0 does not.
#pragma once

#include <EGL/egl.h>
#include <GLES/gl.h>

#include <span>

namespace bench {

struct View {
  int width = 0, height = 0;
  int amount = 0;  // of triangles, draws, ... in a frame; what the scene says unless told otherwise
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLSurface surface = EGL_NO_SURFACE;

  double pixels() const { return double(width) * height; }
};

struct Scene {
  const char* name;  // group_what
  const char* what;  // in words
  const char* unit;  // what set_up() counts
  int amount;        // of triangles, draws, ... in a frame; 0: the scene's work is the pixels alone
  double (*set_up)(const View&);  // gives how many units of work a frame holds
  void (*frame)(const View&, int number);

  const char* extension = nullptr;  // of OpenGL ES, without which the scene cannot be
  bool window = false;              // is drawn into a window, and a frame ends by showing it
  int square = 0;                   // its surface is of this size, whatever is asked for
  double bytes = 0;                 // that have to move through memory for one unit, if that is
                                    // what the scene is about; read and written ones count once
  const char* traffic = nullptr;    // and how: "write" as memset, "copy" as memcpy, "update" as
                                    // adding to numbers in place
  double share = 0.999;             // of the pixels that must be within 2/255 of the reference
};

// One list a file of scenes/.
std::span<const Scene> fill_scenes();
std::span<const Scene> fragment_scenes();
std::span<const Scene> texture_scenes();
std::span<const Scene> mesh_scenes();
std::span<const Scene> draw_scenes();
std::span<const Scene> point_and_line_scenes();
std::span<const Scene> transfer_scenes();
std::span<const Scene> model_scenes();
std::span<const Scene> gears_scenes();

}  // namespace bench
