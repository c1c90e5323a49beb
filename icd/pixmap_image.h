// EGLImages of native pixmaps (EGL_KHR_image_pixmap).
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "api/context.h"
#include "icd/platform.h"

namespace clearpipe::icd {

// The pixels of a pixmap, for as long as its display is there.
std::shared_ptr<api::NativeImage> make_pixmap_image(std::shared_ptr<NativeSurface> pixmap,
                                                    Size size);

}  // namespace clearpipe::icd
