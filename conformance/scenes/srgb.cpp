// Images whose colours are sRGB-encoded (EXT_sRGB): sampled, and drawn to.
// SPDX-License-Identifier: MIT
#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

namespace {

// Random texels over all levels, a part of the base replaced.
void encoded_texture(const Gl& gl, GLenum format, GLsizei size, GLint filter) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
                   filter == GL_NEAREST ? GL_NEAREST : GL_LINEAR);
  Random random(format);
  const auto pixels = [&](GLsizei width) {
    std::vector<uint8_t> data(static_cast<size_t>(4 * width * width));
    for (uint8_t& byte : data) byte = random.byte();
    return data;
  };
  for (GLint level = 0; size >> level > 0; ++level) {
    gl.TexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(format), size >> level, size >> level, 0,
                  format, GL_UNSIGNED_BYTE, pixels(size >> level).data());
  }
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 2, 3, 4, 4, format, GL_UNSIGNED_BYTE, pixels(4).data());
  gl.Enable(GL_TEXTURE_2D);
}

// Every texel many pixels wide.
void plain(const Gl& gl, GLenum format, GLint filter, GLint wrap = GL_REPEAT) {
  encoded_texture(gl, format, 16, filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  clear(gl, 0.4f, 0.3f, 0.6f, 0.7f);
  pixel_projection(gl);
  draw(gl, GL_TRIANGLES, rectangle(3.2f, 5.1f, 251.7f, 249.4f, 0, -0.3f, 0.1f, 1.1f, 0.9f),
       kTexCoords);
}

// A framebuffer object over an encoded texture as large as the window.
void draw_to_encoded(const Gl& gl, GLenum format) {
  GLuint texture = 0, framebuffer = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), 256, 256, 0, format, GL_UNSIGNED_BYTE,
                nullptr);
  gl.GenFramebuffersOES(1, &framebuffer);
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, framebuffer);
  gl.FramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, texture,
                             0);
  clear(gl, 0.2f, 0.05f, 0.6f, 0.4f);
  pixel_projection(gl);
}

// The texture, texel for pixel, in the window.
void show(const Gl& gl) {
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  gl.Disable(GL_BLEND);
  clear(gl, 0.3f, 0.2f, 0.1f);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  draw(gl, GL_TRIANGLES, rectangle(0, 0, 256, 256), kTexCoords);
}

std::vector<Vertex> triangles(uint32_t seed, int count) {
  Random random(seed);
  std::vector<Vertex> vertices(static_cast<size_t>(3 * count));
  for (Vertex& v : vertices) {
    v.x = random.uniform(-40, 296);
    v.y = random.uniform(-40, 296);
    v.r = random.byte();
    v.g = random.byte();
    v.b = random.byte();
    v.a = random.byte();
  }
  return vertices;
}

// What was drawn to is decoded to be shown: one step of an encoded component is up to 2.3/255 then.
constexpr Tolerance kShown = {3, 0.999, 8, 1.0,
                              "a step of an encoded component shows as up to 3/255"};
constexpr Tolerance kBlended = {
    5, 0.999, 8, 1.0, "Mesa decodes what is stored by a polynomial, to within half a step"};

}  // namespace

SCENE(srgb, nearest, kColours) { plain(gl, GL_SRGB_ALPHA_EXT, GL_NEAREST); }
SCENE(srgb, linear, kColours) { plain(gl, GL_SRGB_ALPHA_EXT, GL_LINEAR); }
SCENE(srgb, without_alpha, kColours) { plain(gl, GL_SRGB_EXT, GL_LINEAR); }
SCENE(srgb, clamped, kColours) { plain(gl, GL_SRGB_EXT, GL_LINEAR, GL_CLAMP_TO_EDGE); }

SCENE(srgb, mipmaps, kColours) {
  encoded_texture(gl, GL_SRGB_ALPHA_EXT, 64, GL_LINEAR_MIPMAP_LINEAR);
  textured_plate(gl, 2);
}

// Beside an image that is not encoded, combined with it.
SCENE(srgb, one_of_two_units, kColours) {
  encoded_texture(gl, GL_SRGB_ALPHA_EXT, 8, GL_LINEAR);
  gl.ActiveTexture(GL_TEXTURE1);
  noise_texture(gl, 8, 8, 150);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
  clear(gl);
  pixel_projection(gl);
  gl.MultiTexCoord4f(GL_TEXTURE1, 0.3f, 0.6f, 0, 1);
  draw(gl, GL_TRIANGLES, rectangle(0, 0, 256, 256), kTexCoords);
}

SCENE(srgb, drawn_to, kShown) {
  draw_to_encoded(gl, GL_SRGB_ALPHA_EXT);
  draw(gl, GL_TRIANGLES, triangles(151, 12));
  show(gl);
}

SCENE(srgb, drawn_to_without_alpha, kShown) {
  draw_to_encoded(gl, GL_SRGB_EXT);
  gl.ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
  draw(gl, GL_TRIANGLES, triangles(152, 12));
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  show(gl);
}

SCENE(srgb, blended, kBlended) {
  draw_to_encoded(gl, GL_SRGB_ALPHA_EXT);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  draw(gl, GL_TRIANGLES, triangles(153, 12));
  gl.BlendFunc(GL_DST_COLOR, GL_ONE_MINUS_DST_ALPHA);
  draw(gl, GL_TRIANGLES, triangles(154, 3));
  show(gl);
}

}  // namespace clearpipe::conformance
