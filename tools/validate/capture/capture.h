// The library that clearpipe-validate preloads into a program: it notes when frames end, writes the
// wanted ones into a folder, and can give the program a steady clock. It changes nothing else.
//
// Its settings come by the environment:
//   CLEARPIPE_CAPTURE_FOLDER   where frames and the log go; without it the library does nothing
//   CLEARPIPE_CAPTURE_FRAMES   "1,10,100": the program is ended after the last; or "every N"
//   CLEARPIPE_CAPTURE_CLOCK    "HZ TIME STEADY": the clocks begin at these seconds, and go on by
//   1/HZ a frame
//
// FOLDER/frame-N holds "WIDTH HEIGHT\n" and RGBA rows, the lowest first. FOLDER/log holds lines
// that tools/validate/run.cpp reads: "renderer TEXT", "version TEXT", "samples N", "frame N",
// "undefined FRAME TEXTURE", "done".
// SPDX-License-Identifier: MIT
#pragma once

#include <stdbool.h>
#include <stdint.h>

// The function of that name behind the hooks; null if there is none. For functions of EGL and GL.
void* capture_real(const char* name);

// dlsym itself, without hooks.
void* capture_dlsym(void* handle, const char* name);

// A line of the log.
__attribute__((format(printf, 1, 2))) void capture_log(const char* format, ...);

// Something has been drawn into the current surface, or it has been cleared.
void capture_drawn(void);
void capture_cleared(void);

// The frame that the current thread draws ends, before its buffers are swapped.
void capture_swap(void);

// The program waits for its drawing or reads it: the end of a frame for surfaces without buffers to
// swap, if something has been drawn.
void capture_finish(void);

// Textures whose level 0 has been given no contents are undefined (3.7.1); a draw that uses one is
// noted once for each.
void capture_texture_undefined(void);  // the bound one's size is given, its contents are not
void capture_texture_defined(void);    // the bound one's contents are given
void capture_texture_forget(uint32_t name);
void capture_check_textures(int frame);  // before something is drawn

// The steady clock goes on by one frame.
void capture_clock_advance(void);

// While the hooks call EGL, time is the real one: implementations wait for the screen.
extern _Thread_local int capture_inside;
