// Prototypes of every call, for tests: the system's headers lack those of KHR_debug.
// SPDX-License-Identifier: MIT
#pragma once

#define GL_GLEXT_PROTOTYPES 1
#include <GLES/gl.h>
#include <GLES/glext.h>

#include "api/khr_debug.h"
#include "api/raster_tokens.h"

#define CALL(type, name, parameters, ...) extern "C" type GL_APIENTRY gl##name parameters;
#include "api/gles1.def"
#undef CALL
