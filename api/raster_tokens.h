// The enumerants of rasterization that the system's GLES/glext.h lacks, because it lists them for
// later versions of OpenGL ES only.
// SPDX-License-Identifier: MIT
#pragma once

// EXT_polygon_offset_clamp
#ifndef GL_POLYGON_OFFSET_CLAMP_EXT
#define GL_POLYGON_OFFSET_CLAMP_EXT 0x8E1B
#endif
