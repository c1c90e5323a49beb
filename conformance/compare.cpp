// See compare.h.
// SPDX-License-Identifier: MIT
#include "conformance/compare.h"

#include <OpenImageIO/imagebufalgo.h>

#include <cmath>
#include <cstdio>

#include "conformance/pictures.h"

namespace clearpipe::conformance {

namespace {

namespace oiio = OIIO;

// The share of pixels with no channel further apart than `steps`/255.
double share_within(const oiio::ImageBuf& a, const oiio::ImageBuf& b, int steps, double* largest) {
  const float limit = (static_cast<float>(steps) + 0.5f) / 255.0f;
  const auto result = oiio::ImageBufAlgo::compare(a, b, limit, limit);
  if (largest != nullptr) *largest = result.maxerror;
  const double pixels = static_cast<double>(a.spec().image_pixels());
  return 1.0 - static_cast<double>(result.nfail) / pixels;
}

}  // namespace

Agreement compare(const Image& image, const Image& reference, const Tolerance& tolerance) {
  const oiio::ImageBuf a = wrap(image), b = wrap(reference);
  Agreement agreement;
  double largest = 0;
  agreement.equal = share_within(a, b, 0, &largest);
  agreement.within_1 = share_within(a, b, 1, nullptr);
  agreement.near = share_within(a, b, tolerance.near, nullptr);
  agreement.far = share_within(a, b, tolerance.far, nullptr);
  agreement.largest = static_cast<int>(std::lround(largest * 255.0));
  return agreement;
}

bool holds(const Agreement& agreement, const Tolerance& tolerance) {
  return agreement.near >= tolerance.near_share && agreement.far >= tolerance.far_share;
}

std::string describe(const Agreement& agreement) {
  // Rounded down: 100% means all.
  const auto percent = [](double share) { return std::floor(share * 1e4) / 1e2; };
  char text[128];
  std::snprintf(text, sizeof text, "equal %6.2f%%, within 1/255 %6.2f%%, largest %d/255",
                percent(agreement.equal), percent(agreement.within_1), agreement.largest);
  return text;
}

}  // namespace clearpipe::conformance
