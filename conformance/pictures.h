// Pictures for people: as files and inside pages, by OpenImageIO.
// SPDX-License-Identifier: MIT
#pragma once

#include <OpenImageIO/imagebuf.h>

#include <string>

#include "conformance/implementation.h"

namespace clearpipe::conformance {

// How many times differences are amplified in their picture.
inline constexpr int kAmplification = 32;

// The pixels as they are, for OpenImageIO; they must outlive it.
OIIO::ImageBuf wrap(const Image& image);

// The absolute difference of two pictures of one size, amplified; a difference of alpha shows as
// grey.
OIIO::ImageBuf amplified_difference(const Image& a, const Image& b);

// A picture as a PNG file, the top row first, without alpha: PNG would store colour unassociated
// from it, and a viewer shows opaque pictures best. As a data URI (RFC 2397) it fits into a page.
std::string data_uri(const OIIO::ImageBuf& picture);

// Writes FOLDER/NAME.png, NAME-reference.png and NAME-difference.png; returns the first path.
std::string write_pictures(const Image& image, const Image& reference, const std::string& folder,
                           const std::string& name);

}  // namespace clearpipe::conformance
