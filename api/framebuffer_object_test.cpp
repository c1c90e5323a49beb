// Framebuffer objects (OES_framebuffer_object): names, attachments, completeness, and what drawing
// to textures and renderbuffers leaves behind.
// SPDX-License-Identifier: MIT
#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

constexpr GLenum kFb = GL_FRAMEBUFFER_OES, kRb = GL_RENDERBUFFER_OES;
constexpr GLenum kColourPoint = GL_COLOR_ATTACHMENT0_OES, kDepthPoint = GL_DEPTH_ATTACHMENT_OES,
                 kStencilPoint = GL_STENCIL_ATTACHMENT_OES;

class FramebufferObjects : public CallTest {
 protected:
  static GLuint framebuffer() {
    GLuint name = 0;
    glGenFramebuffersOES(1, &name);
    glBindFramebufferOES(kFb, name);
    return name;
  }
  static GLuint renderbuffer(GLenum format, GLsizei size = kSize) {
    GLuint name = 0;
    glGenRenderbuffersOES(1, &name);
    glBindRenderbufferOES(kRb, name);
    glRenderbufferStorageOES(kRb, format, size, size);
    return name;
  }
  static GLuint attach_renderbuffer(GLenum point, GLenum format, GLsizei size = kSize) {
    const GLuint name = renderbuffer(format, size);
    glFramebufferRenderbufferOES(kFb, point, kRb, name);
    return name;
  }
  static void attach_texture(GLuint name, GLint level = 0) {
    glFramebufferTexture2DOES(kFb, kColourPoint, GL_TEXTURE_2D, name, level);
  }
  static GLenum status() { return glCheckFramebufferStatusOES(kFb); }
  static GLint get(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
  }
  static GLint attached(GLenum point, GLenum name) {
    GLint value = -1;
    glGetFramebufferAttachmentParameterivOES(kFb, point, name, &value);
    return value;
  }
  static void clear_to(float r, float g, float b, float a = 1) {
    glClearColor(r, g, b, a);
    glClear(GL_COLOR_BUFFER_BIT);
  }
};

// A line leaves the diamond it starts in, and not the one it ends in (3.4.1): from the centre of a
// pixel it draws that pixel, and not the pixel at whose centre it ends; upside down too.
TEST_F(FramebufferObjects, LinesStartWithTheirFirstPixel) {
  glOrthof(0, kSize, 0, kSize, -1, 1);
  glEnableClientState(GL_VERTEX_ARRAY);
  for (const bool object : {false, true}) {
    if (object) {
      framebuffer();
      attach_renderbuffer(kColourPoint, GL_RGBA8_OES);
    }
    for (int dy = -4; dy <= 4; ++dy) {
      for (int dx = -4; dx <= 4; ++dx) {
        if (dx == 0 && dy == 0) continue;
        const float ends[] = {8.5f, 8.5f, 8.5f + static_cast<float>(dx),
                              8.5f + static_cast<float>(dy)};
        glVertexPointer(2, GL_FLOAT, 0, ends);
        clear_to(0, 0, 0);
        glDrawArrays(GL_LINES, 0, 2);
        EXPECT_EQ(pixel(8, 8), kWhite) << object << ": " << dx << ", " << dy;
        EXPECT_NE(pixel(8 + dx, 8 + dy), kWhite) << object << ": " << dx << ", " << dy;
      }
    }
  }
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(FramebufferObjects, NamesLiveFromFirstBindToDeletion) {
  GLuint names[2] = {};
  glGenFramebuffersOES(2, names);
  EXPECT_FALSE(glIsFramebufferOES(names[0]));
  glBindFramebufferOES(kFb, names[0]);
  EXPECT_TRUE(glIsFramebufferOES(names[0]));
  EXPECT_EQ(get(GL_FRAMEBUFFER_BINDING_OES), static_cast<GLint>(names[0]));
  glDeleteFramebuffersOES(2, names);
  EXPECT_FALSE(glIsFramebufferOES(names[0]));
  EXPECT_EQ(get(GL_FRAMEBUFFER_BINDING_OES), 0);

  const GLuint buffer = renderbuffer(GL_RGBA8_OES);
  EXPECT_TRUE(glIsRenderbufferOES(buffer));
  EXPECT_EQ(get(GL_RENDERBUFFER_BINDING_OES), static_cast<GLint>(buffer));
  glDeleteRenderbuffersOES(1, &buffer);
  EXPECT_FALSE(glIsRenderbufferOES(buffer));
  EXPECT_EQ(get(GL_RENDERBUFFER_BINDING_OES), 0);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(FramebufferObjects, Errors) {
  GLint value = 7;
  glBindFramebufferOES(kRb, 0);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glBindRenderbufferOES(kFb, 0);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glGenFramebuffersOES(-1, nullptr);
  EXPECT_ERROR(GL_INVALID_VALUE);
  EXPECT_EQ(glCheckFramebufferStatusOES(kRb), 0u);
  EXPECT_ERROR(GL_INVALID_ENUM);
  // Nothing is bound.
  glRenderbufferStorageOES(kRb, GL_RGBA8_OES, 1, 1);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  glGetRenderbufferParameterivOES(kRb, GL_RENDERBUFFER_WIDTH_OES, &value);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  attach_texture(0);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  glGetFramebufferAttachmentParameterivOES(kFb, kColourPoint,
                                           GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES, &value);
  EXPECT_ERROR(GL_INVALID_OPERATION);

  const GLuint buffer = renderbuffer(GL_RGBA8_OES), texture = one_colour_texture(kRed);
  framebuffer();
  glRenderbufferStorageOES(kRb, GL_RGBA, 1, 1);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glRenderbufferStorageOES(kRb, GL_RGBA8_OES, get(GL_MAX_RENDERBUFFER_SIZE_OES) + 1, 1);
  EXPECT_ERROR(GL_INVALID_VALUE);
  glRenderbufferStorageOES(kRb, GL_RGBA8_OES, 1, -1);
  EXPECT_ERROR(GL_INVALID_VALUE);
  glGetRenderbufferParameterivOES(kRb, GL_TEXTURE_2D, &value);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glFramebufferRenderbufferOES(kFb, kColourPoint, GL_TEXTURE_2D, buffer);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glFramebufferRenderbufferOES(kFb, kColourPoint + 1, kRb, buffer);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glFramebufferRenderbufferOES(kFb, kColourPoint, kRb, buffer + 100);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  glFramebufferTexture2DOES(kFb, kColourPoint, GL_TEXTURE, texture, 0);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glFramebufferTexture2DOES(kFb, kColourPoint, GL_TEXTURE_2D, texture + 100, 0);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  attach_texture(texture, 15);
  EXPECT_ERROR(GL_INVALID_VALUE);
  glGetFramebufferAttachmentParameterivOES(kFb, kColourPoint,
                                           GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME_OES, &value);
  EXPECT_ERROR(GL_INVALID_ENUM);  // nothing is attached
  glGenerateMipmapOES(GL_TEXTURE);
  EXPECT_ERROR(GL_INVALID_ENUM);
  EXPECT_EQ(value, 7);
  EXPECT_EQ(attached(kColourPoint, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES), GL_NONE_OES);
  glGetRenderbufferParameterivOES(kRb, GL_RENDERBUFFER_WIDTH_OES, &value);
  EXPECT_EQ(value, kSize);
}

TEST_F(FramebufferObjects, Completeness) {
  framebuffer();
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT_OES));
  const GLuint texture = one_colour_texture(kRed, kSize);
  attach_texture(texture, 1);  // a level that is not there
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT_OES));
  attach_texture(texture);
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE_OES));
  attach_renderbuffer(kDepthPoint, GL_DEPTH_COMPONENT16_OES, kSize / 2);
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_INCOMPLETE_DIMENSIONS_OES));
  glRenderbufferStorageOES(kRb, GL_DEPTH_COMPONENT24_OES, kSize, kSize);
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE_OES));
  glRenderbufferStorageOES(kRb, GL_STENCIL_INDEX8_OES, kSize, kSize);  // at the point of depth
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT_OES));
  attach_renderbuffer(kDepthPoint, GL_DEPTH_COMPONENT32_OES);
  attach_renderbuffer(kStencilPoint, GL_STENCIL_INDEX4_OES);
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_UNSUPPORTED_OES));
  attach_renderbuffer(kStencilPoint, GL_DEPTH24_STENCIL8_OES);
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_UNSUPPORTED_OES));
  attach_renderbuffer(kDepthPoint, GL_DEPTH24_STENCIL8_OES);
  glFramebufferRenderbufferOES(kFb, kStencilPoint, kRb,
                               static_cast<GLuint>(get(GL_RENDERBUFFER_BINDING_OES)));
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE_OES));
  EXPECT_EQ(get(GL_DEPTH_BITS), 24);
  EXPECT_EQ(get(GL_STENCIL_BITS), 8);
  for (const GLenum format : {GL_LUMINANCE, GL_ALPHA, GL_LUMINANCE_ALPHA}) {
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), kSize, kSize, 0, format,
                 GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT_OES)) << format;
  }
  // Nothing is drawn to or read from what is not complete.
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  draw_quad();
  EXPECT_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  pixel(0, 0);
  EXPECT_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  EXPECT_EQ(get(GL_RED_BITS), 0);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 1, 1, 0);
  EXPECT_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
}

TEST_F(FramebufferObjects, FormatsOfRenderbuffers) {
  struct Row {
    GLenum format;
    GLint rgb, alpha, depth, stencil;  // `rgb` as three digits
  };
  const Row rows[] = {{GL_RGB565_OES, 565, 0, 0, 0},
                      {GL_RGBA4_OES, 444, 4, 0, 0},
                      {GL_RGB5_A1_OES, 555, 1, 0, 0},
                      {GL_RGB8_OES, 888, 0, 0, 0},
                      {GL_RGBA8_OES, 888, 8, 0, 0},
                      {GL_DEPTH_COMPONENT16_OES, 0, 0, 16, 0},
                      {GL_DEPTH_COMPONENT24_OES, 0, 0, 24, 0},
                      {GL_DEPTH_COMPONENT32_OES, 0, 0, 24, 0},
                      {GL_STENCIL_INDEX1_OES, 0, 0, 0, 8},
                      {GL_STENCIL_INDEX8_OES, 0, 0, 0, 8},
                      {GL_DEPTH24_STENCIL8_OES, 0, 0, 24, 8}};
  for (const Row& row : rows) {
    renderbuffer(row.format);
    const auto parameter = [](GLenum name) {
      GLint value = -1;
      glGetRenderbufferParameterivOES(kRb, name, &value);
      return value;
    };
    EXPECT_EQ(parameter(GL_RENDERBUFFER_INTERNAL_FORMAT_OES), static_cast<GLint>(row.format));
    EXPECT_EQ(parameter(GL_RENDERBUFFER_HEIGHT_OES), kSize);
    EXPECT_EQ(parameter(GL_RENDERBUFFER_RED_SIZE_OES) * 100 +
                  parameter(GL_RENDERBUFFER_GREEN_SIZE_OES) * 10 +
                  parameter(GL_RENDERBUFFER_BLUE_SIZE_OES),
              row.rgb)
        << row.format;
    EXPECT_EQ(parameter(GL_RENDERBUFFER_ALPHA_SIZE_OES), row.alpha) << row.format;
    EXPECT_EQ(parameter(GL_RENDERBUFFER_DEPTH_SIZE_OES), row.depth) << row.format;
    EXPECT_EQ(parameter(GL_RENDERBUFFER_STENCIL_SIZE_OES), row.stencil) << row.format;
  }
  EXPECT_ERROR(GL_NO_ERROR);
}

// A renderbuffer holds the bits it says: colours are truncated, clear colours rounded.
TEST_F(FramebufferObjects, RenderbuffersOfFewerBits) {
  struct Row {
    GLenum format;
    uint32_t drawn, cleared;
  };
  // Of 127, 126, 125 and 124 of 255.
  const Row rows[] = {{GL_RGB565_OES, 0xff7b7d7bu, 0xff7b7d7bu},
                      {GL_RGBA4_OES, 0x77777777u, 0x77777777u},
                      {GL_RGB5_A1_OES, 0x007b7b7bu, 0x007b7b7bu},
                      {GL_RGBA8_OES, 0x7c7d7e7fu, 0x7c7d7e7fu}};
  for (const Row& row : rows) {
    framebuffer();
    attach_renderbuffer(kColourPoint, row.format);
    glClearColor(127 / 255.0f, 126 / 255.0f, 125 / 255.0f, 124 / 255.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(pixel(3, 3), row.cleared) << std::hex << row.format;
    clear_to(0, 0, 0);
    glColor4f(127 / 255.0f, 126 / 255.0f, 125 / 255.0f, 124 / 255.0f);
    draw_quad();
    EXPECT_EQ(pixel(3, 3), row.drawn) << std::hex << row.format;
    EXPECT_EQ(get(GL_BLUE_BITS), row.format == GL_RGBA8_OES   ? 8
                                 : row.format == GL_RGBA4_OES ? 4
                                                              : 5);
  }
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(FramebufferObjects, WhatIsDrawnToATextureIsSampledNext) {
  const GLuint texture = one_colour_texture(kRed, kSize);
  framebuffer();
  attach_texture(texture);
  glDisable(GL_TEXTURE_2D);
  clear_to(0, 0, 1);
  glColor4f(0, 1, 0, 1);
  draw_half(1);
  glBindFramebufferOES(kFb, 0);
  glEnable(GL_TEXTURE_2D);
  glViewport(0, 0, kSize, kSize);
  draw_quad();
  EXPECT_EQ(left(), kBlue);
  EXPECT_EQ(right(), kGreen);
  EXPECT_ERROR(GL_NO_ERROR);
}

// Each call sees what was drawn before it, and is seen by what is drawn after.
TEST_F(FramebufferObjects, CallsOnTheTextureThatIsDrawnToKeepTheirOrder) {
  const GLuint texture = one_colour_texture(kRed, kSize);
  framebuffer();
  attach_texture(texture);
  glDisable(GL_TEXTURE_2D);
  clear_to(0, 0, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kSize / 2, kSize, GL_RGBA, GL_UNSIGNED_BYTE,
                  texels(kWhite, kSize).data());
  EXPECT_EQ(left(), kWhite);
  EXPECT_EQ(right(), kBlue);
  clear_to(0, 1, 0);
  fill_texture(kRed, kSize);  // new storage
  EXPECT_EQ(left(), kRed);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, kSize / 2, kSize);
  clear_to(0, 0, 1);
  glDisable(GL_SCISSOR_TEST);
  EXPECT_EQ(left(), kBlue);
  EXPECT_EQ(right(), kRed);
  glScissor(0, 0, kSize, kSize);
  clear_to(0, 1, 0);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 4, 4);
  fill_texture(kBlue, 2 * kSize);  // grows under the framebuffer
  clear_to(1, 1, 1);
  EXPECT_EQ(pixel(2 * kSize - 1, 2 * kSize - 1), kWhite);
  fill_texture(kBlue, 1);
  clear_to(1, 0, 0);
  EXPECT_EQ(pixel(0, 0), kRed);
  EXPECT_ERROR(GL_NO_ERROR);
}

// The draw samples what the level held before it.
TEST_F(FramebufferObjects, ATextureThatIsItsOwnTarget) {
  const uint32_t row[2] = {kRed, kBlue};
  const GLuint texture = one_colour_texture(kRed);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, row);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  framebuffer();
  attach_texture(texture);
  glViewport(0, 0, 2, 1);
  glMatrixMode(GL_TEXTURE);
  glTranslatef(0.5f, 0, 0);
  for (int i = 0; i < 3; ++i) {  // exchanges the texels
    draw_quad();
    EXPECT_EQ(pixel(0, 0), row[(i + 1) % 2]);
    EXPECT_EQ(pixel(1, 0), row[i % 2]);
  }
  draw_quad();
  draw_quad();  // twice in a frame
  EXPECT_EQ(pixel(0, 0), kBlue);
}

TEST_F(FramebufferObjects, LevelsAreDrawnToAndGenerated) {
  const GLuint texture = one_colour_texture(kRed, 4);
  glGenerateMipmapOES(GL_TEXTURE_2D);
  framebuffer();
  attach_texture(texture, 1);
  EXPECT_EQ(attached(kColourPoint, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL_OES), 1);
  clear_to(0, 1, 0);
  EXPECT_EQ(pixel(1, 1), kGreen);
  glBindFramebufferOES(kFb, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  const auto drawn = [](GLsizei size) {
    glViewport(0, 0, size, size);
    draw_quad();
    return pixel(0, 0);
  };
  EXPECT_EQ(drawn(4), kRed);
  EXPECT_EQ(drawn(2), kGreen);
  EXPECT_EQ(drawn(1), kRed);
  const GLuint other = framebuffer();
  attach_texture(texture);
  clear_to(0, 0, 1);
  glGenerateMipmapOES(GL_TEXTURE_2D);
  glDeleteFramebuffersOES(1, &other);
  EXPECT_EQ(drawn(2), kBlue);
  EXPECT_EQ(drawn(1), kBlue);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(FramebufferObjects, DepthAndStencilOfRenderbuffers) {
  framebuffer();
  attach_renderbuffer(kColourPoint, GL_RGB565_OES);
  const GLuint packed = attach_renderbuffer(kDepthPoint, GL_DEPTH24_STENCIL8_OES);
  EXPECT_EQ(get(GL_STENCIL_BITS), 0);  // not attached as such
  glFramebufferRenderbufferOES(kFb, kStencilPoint, kRb, packed);
  glClearStencil(5);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  EXPECT_EQ(pixel(3, 3), 0xff000000u);  // no alpha: it reads as one
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, 5, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  glColor4f(1, 0, 0, 1);
  draw_quad();
  EXPECT_EQ(pixel(3, 3), kRed);
  glColor4f(0, 1, 0, 1);
  draw_quad();  // neither passes again
  EXPECT_EQ(pixel(3, 3), kRed);
  glStencilFunc(GL_EQUAL, 6, 0xff);
  glDepthFunc(GL_EQUAL);
  draw_quad();
  EXPECT_EQ(pixel(3, 3), kGreen);
  glFramebufferRenderbufferOES(kFb, kDepthPoint, kRb, 0);
  glDepthFunc(GL_NEVER);  // no depth buffer: passes
  glDisable(GL_STENCIL_TEST);
  glColor4f(0, 0, 1, 1);
  draw_quad();
  EXPECT_EQ(pixel(3, 3), kBlue);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(FramebufferObjects, WithoutColourThereIsNothingToRead) {
  framebuffer();
  attach_renderbuffer(kDepthPoint, GL_DEPTH_COMPONENT16_OES);
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE_OES));
  draw_quad();
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  EXPECT_ERROR(GL_NO_ERROR);
  pixel(0, 0);
  EXPECT_ERROR(GL_INVALID_OPERATION);
}

TEST_F(FramebufferObjects, DeletionDetachesFromTheBoundOneOnly) {
  const GLuint first = framebuffer();
  const GLuint texture = one_colour_texture(kRed, kSize);
  attach_texture(texture);
  clear_to(0, 1, 0);
  framebuffer();
  const GLuint buffer = attach_renderbuffer(kColourPoint, GL_RGBA8_OES);
  glDeleteTextures(1, &texture);
  glDeleteRenderbuffersOES(1, &buffer);
  EXPECT_EQ(attached(kColourPoint, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES), GL_NONE_OES);
  glBindFramebufferOES(kFb, first);
  EXPECT_EQ(attached(kColourPoint, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES), GL_TEXTURE);
  EXPECT_EQ(attached(kColourPoint, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME_OES),
            static_cast<GLint>(texture));
  EXPECT_EQ(pixel(1, 1), kGreen);
  attach_texture(0);
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT_OES));
  EXPECT_ERROR(GL_NO_ERROR);
}

// What one context draws to a texture, another one that shares it samples; storage that goes while
// a frame still draws to it is kept for that frame.
TEST_F(FramebufferObjects, SharedBetweenContexts) {
  Context* other = create_context(context_);
  const pipeline::Target other_target = make_target(kSize, kSize);
  const GLuint texture = one_colour_texture(kRed, kSize);
  const GLuint name = framebuffer();
  attach_texture(texture);
  clear_to(0, 1, 0);
  glFinish();
  make_current(other, other_target, other_target);
  EXPECT_TRUE(glIsFramebufferOES(name));
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glEnable(GL_TEXTURE_2D);
  draw_quad();
  EXPECT_EQ(pixel(8, 8), kGreen);
  fill_texture(kBlue, 4);  // another size
  make_current(context_, target_, target_);
  EXPECT_EQ(pixel(3, 3), kBlue);
  clear_to(1, 0, 0);
  EXPECT_EQ(pixel(3, 3), kRed);
  EXPECT_ERROR(GL_NO_ERROR);
  destroy_context(other);
}

// OES_surfaceless_context.
TEST_F(FramebufferObjects, WithoutASurfaceOnlyFramebufferObjectsAreDrawnTo) {
  make_current(context_, {}, {});
  EXPECT_EQ(status(), static_cast<GLenum>(GL_FRAMEBUFFER_UNDEFINED_OES));
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  draw_quad();
  EXPECT_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  pixel(0, 0);
  EXPECT_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  framebuffer();
  attach_renderbuffer(kColourPoint, GL_RGBA8_OES);
  clear_to(0, 1, 0);
  EXPECT_EQ(pixel(0, 0), kGreen);
  EXPECT_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace clearpipe::api
