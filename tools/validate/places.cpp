// See places.h.
// SPDX-License-Identifier: MIT
#include "tools/validate/places.h"

#include <filesystem>
#include <initializer_list>
#include <stdexcept>

namespace clearpipe::validate {

namespace {

namespace fs = std::filesystem;

// The first that exists, from the folder of this program.
std::string find(const char* what, const char* option, std::initializer_list<const char*> places) {
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  for (const char* place : places) {
    const fs::path path = (folder / place).lexically_normal();
    if (fs::exists(path)) return path;
  }
  throw std::runtime_error(std::string("there is no ") + what + option);
}

}  // namespace

std::string capture_library() {
  return find("libclearpipe_capture.so beside this program or in its library folder", "",
              {"libclearpipe_capture.so", "../" CLEARPIPE_LIBRARY_FOLDER "/libclearpipe_capture.so",
               "../" CLEARPIPE_LIBRARY_FOLDER "/clearpipe/libclearpipe_capture.so"});
}

std::string clearpipe_manifest() {
  return find("EGL vendor manifest of clearpipe", "; --manifest names it",
              {"../icd/clearpipe_icd.json", "../share/glvnd/egl_vendor.d/60_clearpipe.json",
               "../share/clearpipe/clearpipe_icd.json"});
}

std::string mesa_manifest() {
  return find("EGL vendor manifest of Mesa", "; --mesa-manifest names it",
              {"/usr/share/glvnd/egl_vendor.d/50_mesa.json"});
}

}  // namespace clearpipe::validate
