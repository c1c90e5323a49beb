// SPDX-License-Identifier: MIT
//
// See picture.h. libpng's simplified interface.
#include "bench/picture.h"

#include <png.h>

#include <cstdio>
#include <cstdlib>

namespace bench {

namespace {

[[noreturn]] void give_up(const png_image& image, const std::string& path) {
  std::fprintf(stderr, "%s: %s\n", path.c_str(), image.message);
  std::exit(1);
}

png_image new_image() {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  return image;
}

}  // namespace

Picture read_png(const std::string& path) {
  png_image image = new_image();
  if (!png_image_begin_read_from_file(&image, path.c_str())) give_up(image, path);
  image.format = PNG_FORMAT_RGBA;
  Picture picture{int(image.width), int(image.height), {}};
  picture.pixels.resize(PNG_IMAGE_SIZE(image));
  if (!png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr)) {
    give_up(image, path);
  }
  return picture;
}

void write_png(const Picture& picture, const std::string& path) {
  png_image image = new_image();
  image.width = png_uint_32(picture.width);
  image.height = png_uint_32(picture.height);
  image.format = PNG_FORMAT_RGBA;
  // Most of the bench's pictures are noise, which compression only takes time for.
  image.flags = PNG_IMAGE_FLAG_FAST;
  if (!png_image_write_to_file(&image, path.c_str(), 0, picture.pixels.data(), 0, nullptr)) {
    give_up(image, path);
  }
}

}  // namespace bench
