// SPDX-License-Identifier: MIT
//
// See extras.h. The library stands beside the program.
#include "bench/extras.h"

#include <dlfcn.h>

#include <filesystem>

#include "bench/shapes.h"

namespace bench {
namespace {

// By its path: a sanitizer's dlopen does not look where the program's own would.
void* open_library() {
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  return dlopen((program.parent_path() / "libbench_extras.so").c_str(), RTLD_NOW);
}

template <typename Function>
Function* find(const char* name) {
  static void* const library = open_library();
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
