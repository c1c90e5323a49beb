#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A script of PyOpenGL on EGL without a window system: OpenGL ES 1.1 through OpenGL.EGL and OpenGL.GLES1, with matrices, arrays from
Python lists, a texture, reading pixels back, and an error that must become an exception. Fails if a pixel is not what it must be."""
import ctypes
import os
import sys

os.environ["PYOPENGL_PLATFORM"] = "egl"
from OpenGL import EGL, GLES1, error  # noqa: E402  (the platform must be named first)

SIZE = 64


def vertices(*values):
    return (ctypes.c_float * len(values))(*values)


def text(name):
    return ctypes.string_at(GLES1.glGetString(name)).decode()


def make_current():
    """A context on a pbuffer; the display is the surfaceless one if $EGL_PLATFORM says so."""
    display = EGL.eglGetDisplay(EGL.EGL_DEFAULT_DISPLAY)
    major, minor = EGL.EGLint(), EGL.EGLint()
    EGL.eglInitialize(display, major, minor)
    wanted = (EGL.EGLint * 7)(EGL.EGL_SURFACE_TYPE, EGL.EGL_PBUFFER_BIT, EGL.EGL_RENDERABLE_TYPE, EGL.EGL_OPENGL_ES_BIT,
                              EGL.EGL_ALPHA_SIZE, 8, EGL.EGL_NONE)
    configs, count = (EGL.EGLConfig * 1)(), EGL.EGLint()
    EGL.eglChooseConfig(display, wanted, configs, 1, count)
    if count.value != 1:
        sys.exit("pyopengl: there is no config")
    size = (EGL.EGLint * 5)(EGL.EGL_WIDTH, SIZE, EGL.EGL_HEIGHT, SIZE, EGL.EGL_NONE)
    surface = EGL.eglCreatePbufferSurface(display, configs[0], size)
    EGL.eglBindAPI(EGL.EGL_OPENGL_ES_API)
    version = (EGL.EGLint * 3)(EGL.EGL_CONTEXT_CLIENT_VERSION, 1, EGL.EGL_NONE)
    context = EGL.eglCreateContext(display, configs[0], EGL.EGL_NO_CONTEXT, version)
    EGL.eglMakeCurrent(display, surface, surface, context)
    print(f"pyopengl: EGL {major.value}.{minor.value}, {text(GLES1.GL_VERSION)}, {text(GLES1.GL_RENDERER)}")
    return display


def pixel(x, y):
    data = (ctypes.c_ubyte * 4)()
    GLES1.glReadPixels(x, y, 1, 1, GLES1.GL_RGBA, GLES1.GL_UNSIGNED_BYTE, data)
    return tuple(data)


failures = []


def expect(what, actual, expected):
    if actual != expected:
        failures.append(f"{what}: {actual}, not {expected}")


display = make_current()
GLES1.glClearColor(0, 0, 1, 1)
GLES1.glClear(GLES1.GL_COLOR_BUFFER_BIT)
expect("cleared", pixel(5, 5), (0, 0, 255, 255))

# A triangle over the lower left half, in window coordinates.
GLES1.glMatrixMode(GLES1.GL_PROJECTION)
GLES1.glLoadIdentity()
GLES1.glOrthof(0, SIZE, 0, SIZE, -1, 1)
GLES1.glMatrixMode(GLES1.GL_MODELVIEW)
GLES1.glEnableClientState(GLES1.GL_VERTEX_ARRAY)
corners = vertices(0, 0, SIZE, 0, 0, SIZE)
GLES1.glVertexPointer(2, GLES1.GL_FLOAT, 0, corners)
GLES1.glColor4f(1, 0, 0, 1)
GLES1.glDrawArrays(GLES1.GL_TRIANGLES, 0, 3)
expect("inside the triangle", pixel(8, 8), (255, 0, 0, 255))
expect("outside of it", pixel(SIZE - 8, SIZE - 8), (0, 0, 255, 255))

# A texture of 2x2, over the whole surface.
texels = (ctypes.c_ubyte * 16)(255, 255, 0, 255, 0, 255, 0, 255, 0, 255, 255, 255, 255, 255, 255, 255)
names = (ctypes.c_uint * 1)()
GLES1.glGenTextures(1, names)
GLES1.glBindTexture(GLES1.GL_TEXTURE_2D, names[0])
for parameter in (GLES1.GL_TEXTURE_MIN_FILTER, GLES1.GL_TEXTURE_MAG_FILTER):
    GLES1.glTexParameterf(GLES1.GL_TEXTURE_2D, parameter, GLES1.GL_NEAREST)
GLES1.glTexImage2D(GLES1.GL_TEXTURE_2D, 0, GLES1.GL_RGBA, 2, 2, 0, GLES1.GL_RGBA, GLES1.GL_UNSIGNED_BYTE, texels)
GLES1.glTexEnvf(GLES1.GL_TEXTURE_ENV, GLES1.GL_TEXTURE_ENV_MODE, GLES1.GL_REPLACE)
GLES1.glEnable(GLES1.GL_TEXTURE_2D)
GLES1.glEnableClientState(GLES1.GL_TEXTURE_COORD_ARRAY)
square, coordinates = vertices(0, 0, SIZE, 0, 0, SIZE, SIZE, SIZE), vertices(0, 0, 1, 0, 0, 1, 1, 1)
GLES1.glVertexPointer(2, GLES1.GL_FLOAT, 0, square)
GLES1.glTexCoordPointer(2, GLES1.GL_FLOAT, 0, coordinates)
GLES1.glDrawArrays(GLES1.GL_TRIANGLE_STRIP, 0, 4)
for i, (x, y) in enumerate([(8, 8), (SIZE - 8, 8), (8, SIZE - 8), (SIZE - 8, SIZE - 8)]):
    expect(f"texel {i}", pixel(x, y), tuple(texels[4 * i:4 * i + 4]))

try:
    GLES1.glEnable(0x1234)
    failures.append("no exception for an error")
except error.GLError as raised:
    expect("the error", raised.err, GLES1.GL_INVALID_ENUM)

EGL.eglTerminate(display)
print("\n".join(f"pyopengl: {line}" for line in failures) or "pyopengl: all pixels are right")
sys.exit(1 if failures else 0)
