// A texture whose images are the colours of a surface (eglBindTexImage, 3.6 of EGL 1.5).
// SPDX-License-Identifier: MIT
#pragma once

#include "api/context_state.h"

namespace clearpipe::api {

// One binding of a surface to a texture, held by the texture.
struct SurfaceTexture {
  std::weak_ptr<ShareGroup> share;  // which has the texture, which has this
  std::weak_ptr<TextureObject> texture;
};

// The surface's images are gone, because the texture is specified otherwise.
void forget_surface(TextureObject& texture);

}  // namespace clearpipe::api
