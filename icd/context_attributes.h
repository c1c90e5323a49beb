// What a context may be asked for when it is created (3.7.1), beyond the config.
// SPDX-License-Identifier: MIT
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "api/context.h"

namespace clearpipe::icd {

struct ContextAttributes {
  EGLint major = 1, minor = 0;
  bool debug = false;
  bool robust_access = false;
  bool no_error = false;
  EGLint reset_notification = EGL_NO_RESET_NOTIFICATION;
};

// Reads the list; the EGL error of what is wrong with it, or EGL_SUCCESS.
EGLint parse_context_attributes(const EGLint* list, ContextAttributes& out);

// What of them the context itself knows.
api::ContextFlags context_flags(const ContextAttributes& attributes);

// Whether contexts of these attributes may share objects (3.7.1).
bool may_share(const ContextAttributes& a, const ContextAttributes& b);

}  // namespace clearpipe::icd
