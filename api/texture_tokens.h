// The enumerants of texture extensions that the system's GLES/glext.h lacks, because it lists them
// for later versions of OpenGL ES only.
// SPDX-License-Identifier: MIT
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

// ANGLE_texture_compression_dxt3, ANGLE_texture_compression_dxt5
#ifndef GL_COMPRESSED_RGBA_S3TC_DXT3_ANGLE
#define GL_COMPRESSED_RGBA_S3TC_DXT3_ANGLE 0x83F2
#define GL_COMPRESSED_RGBA_S3TC_DXT5_ANGLE 0x83F3
#endif
