// See gles1_on_gl.h.
// SPDX-License-Identifier: MIT
#include "reference/gles1_on_gl.h"

#include "reference/desktop.h"

namespace clearpipe::reference {

Gl desktop;
DesktopOnly desktop_only;

namespace {

template <class Function>
void load(Function& function, void* (*find)(const char*), const char* name) {
  function = reinterpret_cast<Function>(find(name));
}

// Framebuffer objects are core commands of the desktop, with the same enumerants.
void load_framebuffer_objects(void* (*find)(const char*)) {
  load(desktop.IsRenderbufferOES, find, "glIsRenderbuffer");
  load(desktop.BindRenderbufferOES, find, "glBindRenderbuffer");
  load(desktop.DeleteRenderbuffersOES, find, "glDeleteRenderbuffers");
  load(desktop.GenRenderbuffersOES, find, "glGenRenderbuffers");
  load(desktop.RenderbufferStorageOES, find, "glRenderbufferStorage");
  load(desktop.GetRenderbufferParameterivOES, find, "glGetRenderbufferParameteriv");
  load(desktop.IsFramebufferOES, find, "glIsFramebuffer");
  load(desktop.BindFramebufferOES, find, "glBindFramebuffer");
  load(desktop.DeleteFramebuffersOES, find, "glDeleteFramebuffers");
  load(desktop.GenFramebuffersOES, find, "glGenFramebuffers");
  load(desktop.CheckFramebufferStatusOES, find, "glCheckFramebufferStatus");
  load(desktop.FramebufferRenderbufferOES, find, "glFramebufferRenderbuffer");
  load(desktop.FramebufferTexture2DOES, find, "glFramebufferTexture2D");
  load(desktop.GetFramebufferAttachmentParameterivOES, find,
       "glGetFramebufferAttachmentParameteriv");
  load(desktop.GenerateMipmapOES, find, "glGenerateMipmap");
}

// The commands whose float form takes doubles on the desktop.
void translate_doubles(Gl& gl) {
  gl.Frustumf = [](GLfloat l, GLfloat r, GLfloat b, GLfloat t, GLfloat n, GLfloat f) {
    desktop_only.Frustum(l, r, b, t, n, f);
  };
  gl.Orthof = [](GLfloat l, GLfloat r, GLfloat b, GLfloat t, GLfloat n, GLfloat f) {
    desktop_only.Ortho(l, r, b, t, n, f);
  };
  gl.ClipPlanef = [](GLenum plane, const GLfloat* equation) {
    const double wide[4] = {equation[0], equation[1], equation[2], equation[3]};
    desktop_only.ClipPlane(plane, wide);
  };
  gl.GetClipPlanef = [](GLenum plane, GLfloat* equation) {
    double wide[4] = {};
    desktop_only.GetClipPlane(plane, wide);
    for (int i = 0; i < 4; ++i) equation[i] = static_cast<float>(wide[i]);
  };
}

// Coordinates that ES generates together are three on the desktop (OES_texture_cube_map).
constexpr GLenum kTextureGenS = 0x0C60, kS = 0x2000;

void set_capability(decltype(Gl::Enable) set, GLenum capability) {
  if (capability != GL_TEXTURE_GEN_STR_OES) return set(capability);
  for (GLenum i = 0; i < 3; ++i) set(kTextureGenS + i);
}

void tex_gen(GLint mode) {
  for (GLenum i = 0; i < 3; ++i) desktop_only.TexGeni(kS + i, GL_TEXTURE_GEN_MODE_OES, mode);
}

void translate_generated_coordinates(Gl& gl) {
  gl.Enable = [](GLenum capability) { set_capability(desktop.Enable, capability); };
  gl.Disable = [](GLenum capability) { set_capability(desktop.Disable, capability); };
  gl.TexGeniOES = [](GLenum, GLenum, GLint mode) { tex_gen(mode); };
  gl.TexGenfOES = [](GLenum, GLenum, GLfloat mode) { tex_gen(static_cast<GLint>(mode)); };
  gl.TexGenxOES = [](GLenum, GLenum, GLfixed mode) { tex_gen(mode); };
}

// The format of an sRGB-encoded image is that of the data on the desktop, and writing to such
// images is a capability there (EXT_sRGB).
constexpr GLenum kFramebufferSrgb = 0x8DB9;

GLenum data_format(GLenum format) {
  return format == GL_SRGB_EXT ? GL_RGB : format == GL_SRGB_ALPHA_EXT ? GL_RGBA : format;
}

void translate_encoded_images(Gl& gl) {
  gl.TexImage2D = [](GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height,
                     GLint border, GLenum format, GLenum type, const void* pixels) {
    if (data_format(format) != format) desktop.Enable(kFramebufferSrgb);
    desktop.TexImage2D(target, level, internal, width, height, border, data_format(format), type,
                       pixels);
  };
  gl.TexSubImage2D = [](GLenum target, GLint level, GLint x, GLint y, GLsizei width, GLsizei height,
                        GLenum format, GLenum type, const void* pixels) {
    desktop.TexSubImage2D(target, level, x, y, width, height, data_format(format), type, pixels);
  };
}

}  // namespace

Gl gles1_on_gl(void* (*find)(const char* name)) {
  desktop = conformance::load_gl(find);
  load(desktop_only.Frustum, find, "glFrustum");
  load(desktop_only.Ortho, find, "glOrtho");
  load(desktop_only.ClipPlane, find, "glClipPlane");
  load(desktop_only.GetClipPlane, find, "glGetClipPlane");
  load(desktop_only.GetBufferSubData, find, "glGetBufferSubData");
  load(desktop_only.TexGeni, find, "glTexGeni");
  load(desktop.BlendFuncSeparateOES, find, "glBlendFuncSeparate");
  load(desktop.BlendEquationOES, find, "glBlendEquation");
  load(desktop.BlendEquationSeparateOES, find, "glBlendEquationSeparate");
  load_framebuffer_objects(find);
  Gl gl = desktop;
  translate_doubles(gl);
  translate_fixed(gl);
  translate_arrays(gl);
  translate_generated_coordinates(gl);
  translate_encoded_images(gl);
  return gl;
}

}  // namespace clearpipe::reference
