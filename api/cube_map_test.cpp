// Cube maps (OES_texture_cube_map): names and targets, images of faces, completeness, which texture
// a unit samples, generated coordinates, framebuffer objects.
// SPDX-License-Identifier: MIT
#include <array>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

constexpr GLenum kFirst = GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES;
constexpr GLenum kStr = GL_TEXTURE_GEN_STR_OES, kMode = GL_TEXTURE_GEN_MODE_OES;

class CubeMaps : public CallTest {
 protected:
  static uint32_t colour_of(unsigned face, unsigned level = 0) {
    return 0xff000000u | (40 * face + 10) | (60 * level + 5) << 8;
  }
  static void give_face(unsigned face, GLint level, GLsizei size, uint32_t colour,
                        GLint format = GL_RGBA) {
    glTexImage2D(kFirst + face, level, format, size, size, 0, static_cast<GLenum>(format),
                 GL_UNSIGNED_BYTE, texels(colour, size).data());
  }
  // Six faces of one colour each, bound and enabled.
  static GLuint cube_map(GLsizei size = 4, GLint min = GL_NEAREST) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(kCube, name);
    glTexParameteri(kCube, GL_TEXTURE_MIN_FILTER, min);
    for (unsigned face = 0; face < 6; ++face) give_face(face, 0, size, colour_of(face));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(kCube);
    return name;
  }
  // What a draw with one direction shows.
  static uint32_t towards(float s, float t, float r, float q = 1) {
    draw_in_direction(s, t, r, q);
    return pixel(5, 5);
  }
  static void draw_in_direction(float s, float t, float r, float q = 1) {
    static const float kQuad[] = {-1, -1, 1, -1, -1, 1, 1, 1};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, kQuad);
    glMultiTexCoord4f(GL_TEXTURE0, s, t, r, q);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  static GLint get(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
  }
};

TEST_F(CubeMaps, EachFaceIsFoundByItsDirection) {
  cube_map();
  const float kDirections[6][3] = {{2, 1, 1},  {-2, 1, 1}, {1, 2, -1},
                                   {1, -2, 1}, {1, -1, 2}, {-1, 1, -2}};
  for (unsigned face = 0; face < 6; ++face) {
    const float* v = kDirections[face];
    EXPECT_EQ(towards(v[0], v[1], v[2]), colour_of(face)) << face;
    EXPECT_EQ(towards(v[0] * 100, v[1] * 100, v[2] * 100), colour_of(face)) << face;
    // q only scales, and does not turn around.
    EXPECT_EQ(towards(v[0], v[1], v[2], -3), colour_of(face)) << face;
  }
  EXPECT_ERROR(GL_NO_ERROR);
}

// Towards -z s' runs against s, and t' against t; a part of that face is another colour.
TEST_F(CubeMaps, PartsOfFaces) {
  cube_map(4);
  glTexSubImage2D(kFirst + 5, 0, 1, 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &kGreen);
  // The texel's centre: s' = 3/8, t' = 5/8; sc/|ma| = -1/4, tc/|ma| = 1/4.
  EXPECT_EQ(towards(0.25f, -0.25f, -1), kGreen);
  EXPECT_EQ(towards(-0.25f, -0.25f, -1), colour_of(5));
  EXPECT_EQ(towards(0.25f, 0.25f, -1), colour_of(5));
  glClearColor(0, 0, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glCopyTexSubImage2D(kFirst + 5, 0, 1, 2, 0, 0, 1, 1);
  EXPECT_EQ(towards(0.25f, -0.25f, -1), kBlue);
  glClear(GL_COLOR_BUFFER_BIT);
  glCopyTexImage2D(kFirst + 3, 0, GL_RGBA, 0, 0, 4, 4, 0);
  EXPECT_EQ(towards(0, -1, 0), kBlue);
  EXPECT_EQ(towards(0, 1, 0), colour_of(2));
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(CubeMaps, Completeness) {
  glColor4f(1, 1, 1, 1);
  cube_map(4);
  const std::array<void (*)(), 4> kSpoilers = {
      [] { give_face(4, 0, 2, kRed); },
      [] { give_face(4, 0, 4, kRed, GL_RGB); },
      [] { give_face(4, 0, 0, kRed); },
      [] {
        for (unsigned face = 0; face < 6; ++face) give_face(face, 0, 0, 0);
      },
  };
  for (const auto spoil : kSpoilers) {
    cube_map(4);
    EXPECT_EQ(towards(1, 0, 0), colour_of(0));
    spoil();
    EXPECT_EQ(towards(1, 0, 0), kWhite);
  }
  // Mipmaps: all levels of all faces.
  cube_map(4, GL_NEAREST_MIPMAP_NEAREST);
  EXPECT_EQ(towards(1, 0, 0), kWhite);
  for (unsigned face = 0; face < 6; ++face) {
    give_face(face, 1, 2, colour_of(face, 1));
    EXPECT_EQ(towards(1, 0, 0), kWhite);
    give_face(face, 2, 1, colour_of(face, 2));
    EXPECT_EQ(towards(1, 0, 0), face == 5 ? colour_of(0) : kWhite);
  }
  give_face(3, 2, 1, 0, GL_RGB);
  EXPECT_EQ(towards(1, 0, 0), kWhite);
  glTexParameteri(kCube, GL_TEXTURE_MAX_LEVEL_APPLE, 1);
  EXPECT_EQ(towards(1, 0, 0), colour_of(0));
  EXPECT_ERROR(GL_NO_ERROR);
}

// A cube map goes before the 2D texture of the unit, also when it is not complete.
TEST_F(CubeMaps, GoBeforeTwoDimensionalTextures) {
  glColor4f(1, 1, 1, 1);
  one_colour_texture(kRed);
  EXPECT_EQ(towards(1, 0, 0), kRed);
  cube_map();
  EXPECT_EQ(towards(1, 0, 0), colour_of(0));
  give_face(1, 0, 2, kRed);
  EXPECT_EQ(towards(1, 0, 0), kWhite);
  glDisable(kCube);
  EXPECT_EQ(towards(1, 0, 0), kRed);
  glDisable(GL_TEXTURE_2D);
  EXPECT_EQ(towards(1, 0, 0), kWhite);
  EXPECT_FALSE(glIsEnabled(kCube));
  glEnable(kCube);
  EXPECT_TRUE(glIsEnabled(kCube));
  EXPECT_EQ(get(kCube), 1);
}

// REPEAT takes the texel at the other edge of the same face (3.7.6).
TEST_F(CubeMaps, WrapModesHoldOnEachFace) {
  cube_map(2);
  glTexParameteri(kCube, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  const uint32_t face[4] = {kRed, kRed, kBlue, kBlue};
  glTexImage2D(kFirst, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, face);
  // t' near 0, where tc is -1, and t is 1.
  const uint32_t repeated = towards(1, 0.999f, 0);
  EXPECT_NEAR(repeated & 255, 128, 2);
  EXPECT_NEAR(repeated >> 16 & 255, 128, 2);
  glTexParameteri(kCube, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  EXPECT_EQ(towards(1, 0.999f, 0), kRed);
}

TEST_F(CubeMaps, NamesKeepTheirTarget) {
  GLuint name = 0;
  glGenTextures(1, &name);
  EXPECT_FALSE(glIsTexture(name));
  glBindTexture(kCube, name);
  EXPECT_TRUE(glIsTexture(name));
  EXPECT_EQ(get(GL_TEXTURE_BINDING_CUBE_MAP_OES), static_cast<GLint>(name));
  EXPECT_EQ(get(GL_TEXTURE_BINDING_2D), 0);
  glBindTexture(GL_TEXTURE_2D, name);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  EXPECT_EQ(get(GL_TEXTURE_BINDING_2D), 0);
  const GLuint flat = one_colour_texture(kRed);
  glBindTexture(kCube, flat);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  EXPECT_EQ(get(GL_TEXTURE_BINDING_CUBE_MAP_OES), static_cast<GLint>(name));
  // A face is not a texture.
  glBindTexture(kFirst, 77);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glTexParameteri(kFirst, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glDeleteTextures(1, &name);
  EXPECT_EQ(get(GL_TEXTURE_BINDING_CUBE_MAP_OES), 0);
  EXPECT_ERROR(GL_NO_ERROR);
  // Each unit has its own binding, and each target its parameters.
  glTexParameteri(kCube, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  GLint filter = 0;
  glGetTexParameteriv(kCube, GL_TEXTURE_MIN_FILTER, &filter);
  EXPECT_EQ(filter, GL_LINEAR);
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, &filter);
  EXPECT_EQ(filter, GL_NEAREST);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(kCube, 99);
  glActiveTexture(GL_TEXTURE0);
  EXPECT_EQ(get(GL_TEXTURE_BINDING_CUBE_MAP_OES), 0);
}

TEST_F(CubeMaps, CompressedFaces) {
  cube_map();
  // One colour: index 0 of a palette of 16.
  std::array<uint8_t, 48 + 8> data{};
  for (unsigned face = 0; face < 6; ++face) {
    data[0] = static_cast<uint8_t>(20 * face + 30);
    glCompressedTexImage2D(kFirst + face, 0, GL_PALETTE4_RGB8_OES, 4, 4, 0,
                           static_cast<GLsizei>(data.size()), data.data());
  }
  EXPECT_ERROR(GL_NO_ERROR);
  EXPECT_EQ(towards(0, 0, -1), 0xff000000u + 130);
  EXPECT_EQ(towards(0, 1, 0), 0xff000000u + 70);
}

TEST_F(CubeMaps, MipmapsAreGenerated) {
  glColor4f(1, 1, 1, 1);
  cube_map(4, GL_NEAREST_MIPMAP_NEAREST);
  EXPECT_EQ(towards(1, 0, 0), kWhite);
  glGenerateMipmapOES(kFirst);
  EXPECT_ERROR(GL_INVALID_ENUM);
  glGenerateMipmapOES(kCube);
  EXPECT_ERROR(GL_NO_ERROR);
  EXPECT_EQ(towards(1, 0, 0), colour_of(0));
  EXPECT_EQ(towards(0, 0, -1), colour_of(5));
  give_face(2, 0, 2, kRed);
  glGenerateMipmapOES(kCube);
  EXPECT_ERROR(GL_INVALID_OPERATION);

  cube_map(4, GL_NEAREST_MIPMAP_NEAREST);
  glTexParameteri(kCube, GL_GENERATE_MIPMAP, GL_TRUE);
  for (unsigned face = 0; face < 6; ++face) give_face(face, 0, 4, colour_of(face));
  EXPECT_EQ(towards(0, 1, 0), colour_of(2));
  glTexSubImage2D(kFirst + 2, 0, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, texels(kRed, 4).data());
  // The whole face in one pixel: its last level.
  glViewport(5, 5, 1, 1);
  const float quad[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  const float corners[] = {-9, 10, -9, 9, 10, -9, -9, 10, 9, 9, 10, 9};
  glVertexPointer(2, GL_FLOAT, 0, quad);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(3, GL_FLOAT, 0, corners);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_EQ(pixel(5, 5), kRed);
  EXPECT_ERROR(GL_NO_ERROR);
}

// A face drawn to while the texture is sampled elsewhere, then looked at.
TEST_F(CubeMaps, FacesAreDrawnTo) {
  const GLuint name = cube_map(kSize);
  GLuint framebuffer = 0;
  glGenFramebuffersOES(1, &framebuffer);
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, framebuffer);
  const auto attach = [name](GLenum target, GLint level) {
    glFramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, target, name, level);
    return glGetError();
  };
  const auto attached = [](GLenum pname) {
    GLint value = -1;
    glGetFramebufferAttachmentParameterivOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, pname,
                                             &value);
    return value;
  };
  EXPECT_EQ(attach(GL_TEXTURE_2D, 0), GLenum{GL_INVALID_OPERATION});
  EXPECT_EQ(attach(kCube, 0), GLenum{GL_INVALID_ENUM});
  EXPECT_EQ(attach(kFirst + 3, 15), GLenum{GL_INVALID_VALUE});
  EXPECT_EQ(attach(kFirst + 3, 0), GLenum{GL_NO_ERROR});
  EXPECT_EQ(attached(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES), GL_TEXTURE);
  EXPECT_EQ(attached(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME_OES), static_cast<GLint>(name));
  EXPECT_EQ(attached(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE_OES),
            static_cast<GLint>(kFirst + 3));
  EXPECT_EQ(glCheckFramebufferStatusOES(GL_FRAMEBUFFER_OES),
            static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE_OES));
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(pixel(3, 3), kGreen);
  EXPECT_EQ(attach(kFirst + 4, 0), GLenum{GL_NO_ERROR});
  glClearColor(0, 0, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  // Drawing with what is drawn to: what it held before, the face itself too.
  EXPECT_EQ(towards(0, 0, 1), kBlue);
  EXPECT_EQ(towards(0, -1, 0), kGreen);
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  EXPECT_EQ(towards(0, 0, 1), kGreen);
  EXPECT_EQ(towards(0, -1, 0), kGreen);
  EXPECT_EQ(towards(0, 1, 0), colour_of(2));

  const GLuint flat = one_colour_texture(kRed);
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, framebuffer);
  glFramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, kFirst, flat, 0);
  EXPECT_ERROR(GL_INVALID_OPERATION);
  glFramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, flat, 0);
  EXPECT_EQ(attached(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE_OES), 0);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(CubeMaps, PendingDrawsKeepTheirTexels) {
  cube_map();
  glViewport(0, 0, kSize / 2, kSize);
  draw_in_direction(1, 0, 0);
  give_face(0, 0, 4, kGreen);
  glViewport(kSize / 2, 0, kSize / 2, kSize);
  draw_in_direction(1, 0, 0);
  EXPECT_EQ(left(), colour_of(0));
  EXPECT_EQ(right(), kGreen);
}

// Normals and reflections towards every face.
TEST_F(CubeMaps, GeneratedCoordinates) {
  cube_map();
  glEnable(kStr);
  EXPECT_TRUE(glIsEnabled(kStr));
  glTexGeniOES(kStr, kMode, GL_NORMAL_MAP_OES);
  glNormal3f(0.1f, 0, -1);
  EXPECT_EQ(towards(1, 0, 0), colour_of(5));
  glMatrixMode(GL_MODELVIEW);
  glPushMatrix();
  glRotatef(90, 0, 0, 1);
  glNormal3f(-1, 0, 0);
  EXPECT_EQ(towards(1, 0, 0), colour_of(3));
  glPopMatrix();
  // Then the texture matrix.
  glMatrixMode(GL_TEXTURE);
  glRotatef(90, 0, 1, 0);
  glNormal3f(1, 0, 0);
  EXPECT_EQ(towards(0, 1, 0), colour_of(5));
  glLoadIdentity();

  // The eye looks along -z at a mirror that faces it, and one that is turned to show the right.
  glTexGenfOES(kStr, kMode, GL_REFLECTION_MAP_OES);
  glMatrixMode(GL_PROJECTION);
  glFrustumf(-0.01f, 0.01f, -0.01f, 0.01f, 1, 10);
  glMatrixMode(GL_MODELVIEW);
  glTranslatef(0, 0, -2);
  glScalef(0.02f, 0.02f, 0.02f);
  glEnable(GL_NORMALIZE);
  glNormal3f(0, 0, 1);
  EXPECT_EQ(towards(0, 1, 0), colour_of(4));
  glNormal3f(1, 0, 1);
  EXPECT_EQ(towards(0, 1, 0), colour_of(0));
  glNormal3f(0, -1, 1);
  EXPECT_EQ(towards(0, 1, 0), colour_of(3));
  // Seen from the side, the view goes on.
  glNormal3f(0, 1, 0);
  EXPECT_EQ(towards(0, 1, 0), colour_of(5));
  glDisable(kStr);
  EXPECT_EQ(towards(0, 1, 0), colour_of(2));
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(CubeMaps, ModesOfGeneration) {
  GLint mode = 0;
  GLfloat number = 0;
  GLfixed fixed = 0;
  glGetTexGenivOES(kStr, kMode, &mode);
  EXPECT_EQ(mode, GL_REFLECTION_MAP_OES);
  const GLint normal = GL_NORMAL_MAP_OES, reflection = GL_REFLECTION_MAP_OES;
  const GLfloat normal_number = GL_NORMAL_MAP_OES;
  glTexGenivOES(kStr, kMode, &normal);
  glGetTexGenfvOES(kStr, kMode, &number);
  EXPECT_EQ(number, static_cast<GLfloat>(GL_NORMAL_MAP_OES));
  glTexGenxOES(kStr, kMode, reflection);
  glGetTexGenxvOES(kStr, kMode, &fixed);
  EXPECT_EQ(fixed, reflection);
  glTexGenfvOES(kStr, kMode, &normal_number);
  glGetTexGenxvOES(kStr, kMode, &fixed);
  EXPECT_EQ(fixed, normal);
  glTexGenxvOES(kStr, kMode, &reflection);
  glGetTexGenivOES(kStr, kMode, &mode);
  EXPECT_EQ(mode, reflection);
  EXPECT_ERROR(GL_NO_ERROR);
  // Each unit has its own.
  glTexGeniOES(kStr, kMode, GL_NORMAL_MAP_OES);
  glEnable(kStr);
  glActiveTexture(GL_TEXTURE3);
  glGetTexGenivOES(kStr, kMode, &mode);
  EXPECT_EQ(mode, reflection);
  EXPECT_FALSE(glIsEnabled(kStr));
  EXPECT_EQ(get(kStr), 0);
}

}  // namespace
}  // namespace clearpipe::api
