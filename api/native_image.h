// EGLImages of pixels that the window system keeps (EGL_KHR_image_pixmap): see context.h. They are
// copies of each other. What the window system has is taken over when someone says that it drew
// there; what contexts draw to siblings is handed over when they finish or flush.
//
// Both sides may only tell what changed by looking: `known` is what they last agreed on.
// SPDX-License-Identifier: MIT
#pragma once

#include "api/egl_image.h"

namespace clearpipe::api {

EglImagePtr make_native_image(std::shared_ptr<NativeImage> native);

// The context draws or samples with the image: it looks for changes when it finishes.
void note_native_image(Context& context, const EglImagePtr& image);

// Takes over what the window system has by now. Memory that a frame may read is replaced, so that
// siblings see the new one at their next use.
void load_native_image(EglImage& image);

}  // namespace clearpipe::api
