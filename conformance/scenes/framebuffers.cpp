// Framebuffer objects (OES_framebuffer_object): scenes drawn to a texture, then shown.
// SPDX-License-Identifier: MIT
#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

namespace {

// A framebuffer object with a texture of that size, and with depth and stencil if wanted.
GLuint bind_texture_target(const Gl& gl, GLint format, GLsizei size, bool planes, GLint level = 0) {
  GLuint texture = 0, framebuffer = 0, renderbuffer = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  for (GLint i = 0; i <= level; ++i) {
    gl.TexImage2D(GL_TEXTURE_2D, i, format, size >> i, size >> i, 0, static_cast<GLenum>(format),
                  GL_UNSIGNED_BYTE, nullptr);
  }
  gl.GenFramebuffersOES(1, &framebuffer);
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, framebuffer);
  gl.FramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, texture,
                             level);
  if (planes) {
    gl.GenRenderbuffersOES(1, &renderbuffer);
    gl.BindRenderbufferOES(GL_RENDERBUFFER_OES, renderbuffer);
    gl.RenderbufferStorageOES(GL_RENDERBUFFER_OES, GL_DEPTH24_STENCIL8_OES, size, size);
    for (const GLenum point : {GL_DEPTH_ATTACHMENT_OES, GL_STENCIL_ATTACHMENT_OES}) {
      gl.FramebufferRenderbufferOES(GL_FRAMEBUFFER_OES, point, GL_RENDERBUFFER_OES, renderbuffer);
    }
  }
  gl.Viewport(0, 0, size >> level, size >> level);
  return texture;
}

// The bound texture, texel for pixel, in the window.
void show(const Gl& gl) {
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  gl.Viewport(0, 0, 256, 256);
  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_STENCIL_TEST);
  gl.Disable(GL_CULL_FACE);
  clear(gl, 0.3f, 0.2f, 0.1f);
  pixel_projection(gl);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  draw(gl, GL_TRIANGLES, rectangle(0, 0, 256, 256), kTexCoords);
}

std::vector<Vertex> random_vertices(uint32_t seed, int count) {
  Random random(seed);
  std::vector<Vertex> vertices;
  for (int i = 0; i < count; ++i) {
    Vertex v;
    v.x = random.uniform(-40, 296);
    v.y = random.uniform(-40, 296);
    v.z = random.uniform(-0.9f, 0.9f);
    v.r = random.byte();
    v.g = random.byte();
    v.b = random.byte();
    v.a = 255;
    vertices.push_back(v);
  }
  return vertices;
}

}  // namespace

// y counts upwards from the first: every edge must fall as the reference's does.
SCENE(framebuffers, coverage_of_triangles, kExact) {
  bind_texture_target(gl, GL_RGBA, 256, false);
  clear(gl);
  pixel_projection(gl);
  std::vector<Vertex> vertices = random_vertices(120, 240);
  for (size_t i = 0; i < vertices.size(); i += 3) {
    const std::vector<Vertex> triangle(vertices.begin() + static_cast<ptrdiff_t>(i),
                                       vertices.begin() + static_cast<ptrdiff_t>(i + 3));
    gl.Color4ub(triangle[0].r, triangle[0].g, triangle[0].b, 255);
    draw(gl, GL_TRIANGLES, triangle, 0);
  }
  show(gl);
}

SCENE(framebuffers, lines_and_points, kExact) {
  bind_texture_target(gl, GL_RGB, 256, false);
  clear(gl);
  pixel_projection(gl);
  const std::vector<Vertex> vertices = random_vertices(121, 80);
  for (size_t i = 0; i + 1 < vertices.size(); i += 2) {
    gl.Color4ub(vertices[i].r, vertices[i].g, vertices[i].b, 255);
    gl.LineWidth(static_cast<float>(1 + i % 5));
    gl.PointSize(static_cast<float>(1 + i % 7));
    draw(gl, GL_LINES, {vertices[i], vertices[i + 1]}, 0);
    draw(gl, GL_POINTS, {vertices[i]}, 0);
  }
  show(gl);
}

SCENE(framebuffers, depth_stencil_and_culling, kColours) {
  bind_texture_target(gl, GL_RGBA, 256, true);
  clear(gl);
  pixel_projection(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilFunc(GL_ALWAYS, 0, 0xff);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  gl.Enable(GL_CULL_FACE);
  draw(gl, GL_TRIANGLES, random_vertices(122, 90), kColoursArray);
  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_CULL_FACE);
  gl.StencilFunc(GL_EQUAL, 2, 0xff);
  gl.Color4f(1, 1, 1, 1);
  draw(gl, GL_TRIANGLES, rectangle(0, 0, 256, 256), 0);
  show(gl);
}

SCENE(framebuffers, point_sprites, kColours) {
  noise_texture(gl, 16, 16, 123);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  GLint noise = 0;
  gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &noise);
  const GLuint target = bind_texture_target(gl, GL_RGBA, 256, false);
  clear(gl);
  pixel_projection(gl);
  gl.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(noise));
  gl.Enable(GL_TEXTURE_2D);
  gl.Enable(GL_POINT_SPRITE_OES);
  gl.TexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, GL_TRUE);
  gl.PointSize(27);
  draw(gl, GL_POINTS, random_vertices(124, 40), kColoursArray);
  gl.Disable(GL_POINT_SPRITE_OES);
  gl.BindTexture(GL_TEXTURE_2D, target);
  show(gl);
}

// A level drawn to, the others generated or uploaded, and all seen in perspective.
SCENE(framebuffers, levels, kColours) {
  bind_texture_target(gl, GL_RGBA, 64, false);
  clear(gl, 0.2f, 0.5f, 0.9f);
  pixel_projection(gl);
  draw(gl, GL_TRIANGLES, random_vertices(125, 60), kColoursArray);
  gl.GenerateMipmapOES(GL_TEXTURE_2D);
  GLint texture = 0;
  gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
  gl.FramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D,
                             static_cast<GLuint>(texture), 2);
  clear(gl, 0.9f, 0.2f, 0.1f);
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  gl.Viewport(0, 0, 256, 256);
  clear(gl);
  perspective(gl);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.Translatef(0, -0.6f, -1.2f);
  gl.Rotatef(-72, 1, 0, 0);
  draw(gl, GL_TRIANGLES, rectangle(-2.2f, -1, 2.2f, 12, 0, 0, 0, 2, 6), kTexCoords);
}

// CopyTexImage2D from a framebuffer object.
SCENE(framebuffers, copies, kColours) {
  bind_texture_target(gl, GL_RGBA, 256, false);
  clear(gl, 0.1f, 0.4f, 0.3f);
  pixel_projection(gl);
  draw(gl, GL_TRIANGLES, random_vertices(126, 30), kColoursArray);
  GLuint copy = 0;
  gl.GenTextures(1, &copy);
  gl.BindTexture(GL_TEXTURE_2D, copy);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 32, 128, 128, 0);
  gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 10, 20, 0, 0, 40, 30);
  show(gl);
}

}  // namespace clearpipe::conformance
