// SPDX-License-Identifier: MIT
//
// What few runs need - a window, pictures - lies in the library bench_extras, which is
// opened when it is first needed: loading X11 and PNG would take a third of the time that the
// first frame of a process takes without them.
#pragma once

#include "bench/picture.h"

extern "C" {
#include "examples/window.h"
}

namespace bench {

// As connect_x11, read_png and write_png; all end the process with a message when there is no
// library.
AppWindow* open_x11(int width, int height);
Picture load_png(const std::string& path);
void save_png(const Picture& picture, const std::string& path);

}  // namespace bench
