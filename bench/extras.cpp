// SPDX-License-Identifier: MIT
//
// See extras.h. The library stands beside the program.
#include "bench/extras.h"

#include <dlfcn.h>

#include "bench/shapes.h"

namespace bench {
namespace {

template <typename Function>
Function* find(const char* name) {
  static void* const library = dlopen("libbench_extras.so", RTLD_NOW);
  void* const found = library ? dlsym(library, name) : nullptr;
  if (!found) fail("opening libbench_extras.so");
  return reinterpret_cast<Function*>(found);
}

}  // namespace

AppWindow* open_x11(int width, int height) {
  return find<decltype(connect_x11)>("connect_x11")(width, height);
}

Picture load_png(const std::string& path) {
  Picture picture;
  find<void(const std::string&, Picture&)>("bench_read_png")(path, picture);
  return picture;
}

void save_png(const Picture& picture, const std::string& path) {
  find<void(const Picture&, const std::string&)>("bench_write_png")(picture, path);
}

}  // namespace bench
