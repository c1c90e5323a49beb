// See pictures.h.
// SPDX-License-Identifier: MIT
#include "conformance/pictures.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/strutil.h>

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace clearpipe::conformance {

namespace {

namespace oiio = OIIO;
using oiio::ImageBufAlgo::channels;

oiio::ImageBuf upright(const oiio::ImageBuf& picture) {
  return oiio::ImageBufAlgo::flip(channels(picture, 3, {}));
}

void write(const oiio::ImageBuf& picture, const std::string& path) {
  const oiio::ImageBuf result = upright(picture);
  if (!result.write(path, oiio::TypeDesc::UINT8)) {
    std::fprintf(stderr, "%s: %s\n", path.c_str(), result.geterror().c_str());
  }
}

}  // namespace

oiio::ImageBuf wrap(const Image& image) {
  const oiio::ImageSpec spec(image.width, image.height, 4, oiio::TypeDesc::UINT8);
  return oiio::ImageBuf(spec, const_cast<uint8_t*>(image.pixels.data()));
}

oiio::ImageBuf amplified_difference(const Image& a, const Image& b) {
  const oiio::ImageBuf difference = oiio::ImageBufAlgo::mul(
      oiio::ImageBufAlgo::absdiff(wrap(a), wrap(b)), static_cast<float>(kAmplification));
  return oiio::ImageBufAlgo::max(channels(difference, 3, {}), channels(difference, 3, {3, 3, 3}));
}

std::string data_uri(const oiio::ImageBuf& picture) {
  std::vector<unsigned char> file;
  oiio::Filesystem::IOVecOutput memory(file);
  oiio::ImageBuf result = upright(picture);
  result.set_write_ioproxy(&memory);
  if (!result.write("picture.png", oiio::TypeDesc::UINT8)) {
    throw std::runtime_error("cannot write a picture: " + result.geterror());
  }
  const oiio::string_view bytes(reinterpret_cast<const char*>(file.data()), file.size());
  return "data:image/png;base64," + oiio::Strutil::base64_encode(bytes);
}

std::string write_pictures(const Image& image, const Image& reference, const std::string& folder,
                           const std::string& name) {
  std::filesystem::create_directories(folder);
  const std::string stem = folder + "/" + name;
  write(wrap(image), stem + ".png");
  write(wrap(reference), stem + "-reference.png");
  write(amplified_difference(image, reference), stem + "-difference.png");
  return stem + ".png";
}

}  // namespace clearpipe::conformance
