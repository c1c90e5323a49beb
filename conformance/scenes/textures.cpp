// Textures (3.7): filters, wraps, formats, environments, units.
// SPDX-License-Identifier: MIT
#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

namespace {

void filtered_plate(const Gl& gl, GLenum min, GLenum mag, float repeat = 2) {
  noise_texture(gl, 32, 32, 80, true);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(min));
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(mag));
  textured_plate(gl, repeat);
}

void wrapped(const Gl& gl, GLenum s, GLenum t, GLenum filter) {
  noise_texture(gl, 16, 16, 81);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, static_cast<GLint>(s));
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, static_cast<GLint>(t));
  clear(gl);
  pixel_projection(gl);
  gl.Enable(GL_TEXTURE_2D);
  std::vector<Vertex> tilted = rectangle(8, 8, 248, 248, 0, -1.313f, -1.721f, 2.237f, 1.949f);
  tilted[2].x = tilted[4].x = 225;
  draw(gl, GL_TRIANGLES, tilted, kTexCoords);
}

// One plate each for the base formats of a type.
void formats(const Gl& gl, GLenum type, const std::vector<GLenum>& list) {
  clear(gl, 0.4f, 0.3f, 0.6f, 0.7f);
  pixel_projection(gl);
  gl.Enable(GL_TEXTURE_2D);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  float y = 4;
  for (const GLenum format : list) {
    Random random(format + type);
    std::vector<uint8_t> texels(19 * 11 * 4);
    for (uint8_t& byte : texels) byte = random.byte();
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), 16, 8, 0, format, type,
                  texels.data());
    gl.Color4f(0.9f, 0.7f, 0.8f, 0.6f);
    draw(gl, GL_TRIANGLES, rectangle(6.13f, y + 0.21f, 250.37f, y + 44.4f, 0), kTexCoords);
    y += 50;
  }
}

// An environment over every base format, with a coloured and half transparent triangle fan.
void environment(const Gl& gl, GLint mode) {
  constexpr GLenum kFormats[] = {GL_RGBA, GL_RGB, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA};
  constexpr size_t kSizes[] = {4, 3, 1, 1, 2};
  clear(gl, 0.4f, 0.3f, 0.6f, 0.7f);
  pixel_projection(gl);
  gl.Enable(GL_TEXTURE_2D);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode);
  const GLfloat colour[4] = {0.2f, 0.9f, 0.5f, 0.4f};
  gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, colour);
  for (size_t i = 0; i < 5; ++i) {
    Random random(static_cast<uint32_t>(i) + 90);
    std::vector<uint8_t> texels(16 * 16 * kSizes[i]);
    for (uint8_t& byte : texels) byte = random.byte();
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(kFormats[i]), 16, 16, 0, kFormats[i],
                  GL_UNSIGNED_BYTE, texels.data());
    const float y = 4 + 50 * static_cast<float>(i);
    std::vector<Vertex> plate = rectangle(6, y, 250, y + 46, 0, 0, 0, 2, 1);
    for (Vertex& v : plate) {
      v.r = v.x > 100 ? 230 : 20;
      v.g = v.y > y + 1 ? 200 : 60;
      v.b = 128;
      v.a = v.x > 100 ? 90 : 240;
    }
    draw(gl, GL_TRIANGLES, plate, kColoursArray | kTexCoords);
  }
}

void coordinates(const Gl& gl, GLenum unit, const std::vector<Vertex>& vertices) {
  gl.ClientActiveTexture(unit);
  gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
  gl.TexCoordPointer(2, GL_FLOAT, sizeof(Vertex), &vertices[0].s);
}

}  // namespace

SCENE(textures, nearest, kColours) { filtered_plate(gl, GL_NEAREST, GL_NEAREST); }
SCENE(textures, linear, kColours) { filtered_plate(gl, GL_LINEAR, GL_LINEAR); }
SCENE(textures, nearest_mipmap_nearest,
      except_at_borders("3.7.7: a coordinate on the border of two texels rounds either way")) {
  filtered_plate(gl, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST, 5);
}
SCENE(textures, linear_mipmap_nearest, kColours) {
  filtered_plate(gl, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, 5);
}
SCENE(textures, nearest_mipmap_linear,
      except_at_borders("3.7.7: a coordinate on the border of two texels rounds either way")) {
  filtered_plate(gl, GL_NEAREST_MIPMAP_LINEAR, GL_NEAREST, 5);
}
SCENE(textures, linear_mipmap_linear, kColours) {
  filtered_plate(gl, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, 5);
}
SCENE(textures, nearest_minified_linear_magnified, kColours) {
  filtered_plate(gl, GL_NEAREST, GL_LINEAR);
}

SCENE(textures, repeat_nearest, kColours) { wrapped(gl, GL_REPEAT, GL_REPEAT, GL_NEAREST); }
SCENE(textures, repeat_linear, kColours) { wrapped(gl, GL_REPEAT, GL_REPEAT, GL_LINEAR); }
SCENE(textures, clamp_nearest, kColours) {
  wrapped(gl, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE, GL_NEAREST);
}
SCENE(textures, clamp_linear, kColours) {
  wrapped(gl, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE, GL_LINEAR);
}
SCENE(textures, mixed_wraps, kColours) { wrapped(gl, GL_CLAMP_TO_EDGE, GL_REPEAT, GL_LINEAR); }
SCENE(textures, mirrored_repeat, kColours) {
  wrapped(gl, GL_MIRRORED_REPEAT_OES, GL_MIRRORED_REPEAT_OES, GL_LINEAR);
}

SCENE(textures, byte_formats, kColours) {
  formats(gl, GL_UNSIGNED_BYTE, {GL_RGBA, GL_RGB, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA});
}
SCENE(textures, packed_565, kColours) { formats(gl, GL_UNSIGNED_SHORT_5_6_5, {GL_RGB}); }
SCENE(textures, packed_4444, kColours) { formats(gl, GL_UNSIGNED_SHORT_4_4_4_4, {GL_RGBA}); }
SCENE(textures, packed_5551, kColours) { formats(gl, GL_UNSIGNED_SHORT_5_5_5_1, {GL_RGBA}); }

SCENE(textures, modulate, kColours) { environment(gl, GL_MODULATE); }
SCENE(textures, replace, kColours) { environment(gl, GL_REPLACE); }
SCENE(textures, decal, kColours) { environment(gl, GL_DECAL); }
SCENE(textures, blend, kColours) { environment(gl, GL_BLEND); }
SCENE(textures, add, kColours) { environment(gl, GL_ADD); }

SCENE(textures, two_units, kColours) {
  clear(gl);
  pixel_projection(gl);
  noise_texture(gl, 16, 16, 83);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.ActiveTexture(GL_TEXTURE1);
  noise_texture(gl, 64, 32, 84);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  gl.MatrixMode(GL_TEXTURE);
  gl.Scalef(1.5f, 0.7f, 1);
  gl.Rotatef(30, 0, 0, 1);
  const std::vector<Vertex> vertices = rectangle(5, 5, 250, 250);
  coordinates(gl, GL_TEXTURE1, vertices);
  coordinates(gl, GL_TEXTURE0, vertices);
  draw(gl, GL_TRIANGLES, vertices, kTexCoords);
}

SCENE(textures, combine_interpolate, kColours) {
  clear(gl);
  pixel_projection(gl);
  noise_texture(gl, 32, 32, 85);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_INTERPOLATE);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_PRIMARY_COLOR);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, GL_TEXTURE);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_RGB, GL_ONE_MINUS_SRC_COLOR);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_SRC_ALPHA);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_ADD_SIGNED);
  gl.TexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 2);
  std::vector<Vertex> vertices = rectangle(5, 5, 250, 250);
  vertices[1].g = vertices[2].b = vertices[4].b = 20;
  draw(gl, GL_TRIANGLES, vertices, kColoursArray | kTexCoords);
}

SCENE(textures, combine_dot3, kColours) {
  clear(gl);
  pixel_projection(gl);
  noise_texture(gl, 32, 32, 86);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_PRIMARY_COLOR);
  gl.Color4f(0.8f, 0.3f, 0.9f, 1);
  draw(gl, GL_TRIANGLES, rectangle(5, 5, 250, 250), kTexCoords);
}

SCENE(textures, sub_image, kColours) {
  clear(gl);
  pixel_projection(gl);
  noise_texture(gl, 32, 32, 87);
  gl.Enable(GL_TEXTURE_2D);
  draw(gl, GL_TRIANGLES, rectangle(0, 0, 128, 128), kTexCoords);
  Random random(88);
  std::vector<uint8_t> texels(10 * 14 * 4);
  for (uint8_t& byte : texels) byte = random.byte();
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 5, 9, 10, 14, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  draw(gl, GL_TRIANGLES, rectangle(128, 0, 256, 128), kTexCoords);
  gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 3, 2, 20, 30, 25, 21);
  draw(gl, GL_TRIANGLES, rectangle(0, 128, 128, 256), kTexCoords);
  gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 64, 64, 0);
  draw(gl, GL_TRIANGLES, rectangle(128, 128, 256, 256), kTexCoords);
}

SCENE(textures, point_sprites, kColours) {
  clear(gl);
  pixel_projection(gl);
  noise_texture(gl, 16, 16, 89);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  gl.Enable(GL_POINT_SPRITE_OES);
  gl.TexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, GL_TRUE);
  Random random(92);
  for (int i = 0; i < 40; ++i) {
    Vertex v;
    v.x = random.uniform(0, 256);
    v.y = random.uniform(0, 256);
    v.r = random.byte();
    v.g = random.byte();
    gl.PointSize(random.uniform(1, 40));
    draw(gl, GL_POINTS, {v});
  }
}

}  // namespace clearpipe::conformance
