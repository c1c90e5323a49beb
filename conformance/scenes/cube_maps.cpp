// Cube maps (OES_texture_cube_map): explicit directions, generated ones, filters, copies and
// framebuffer objects. All clamp to the edge: the reference does so whatever the wrap mode is.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <utility>

#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

namespace {

constexpr GLenum kFaces[] = {
    GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES, GL_TEXTURE_CUBE_MAP_NEGATIVE_X_OES,
    GL_TEXTURE_CUBE_MAP_POSITIVE_Y_OES, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y_OES,
    GL_TEXTURE_CUBE_MAP_POSITIVE_Z_OES, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z_OES};

void parameter(const Gl& gl, GLenum name, GLint value) {
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP_OES, name, value);
}

// Binds and enables a new cube map whose faces have a colour each, with noise and a gradient.
void cube_map(const Gl& gl, GLsizei size, GLint min, GLint mag) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP_OES, texture);
  parameter(gl, GL_TEXTURE_MIN_FILTER, min);
  parameter(gl, GL_TEXTURE_MAG_FILTER, mag);
  parameter(gl, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  parameter(gl, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  parameter(gl, GL_GENERATE_MIPMAP, min != GL_NEAREST && min != GL_LINEAR);
  Random random(200);
  for (unsigned face = 0; face < 6; ++face) {
    std::vector<uint8_t> texels;
    for (GLsizei i = 0; i < size * size; ++i) {
      const int x = i % size, y = i / size;
      texels.push_back(static_cast<uint8_t>((face & 1 ? 160 : 40) + random.byte() % 80));
      texels.push_back(static_cast<uint8_t>((face & 2 ? 110 : 20) + 90 * x / size));
      texels.push_back(static_cast<uint8_t>((face & 4 ? 130 : 10) + 120 * y / size));
      texels.push_back(255);
    }
    gl.TexImage2D(kFaces[face], 0, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  texels.data());
  }
  gl.Enable(GL_TEXTURE_CUBE_MAP_OES);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

// Directions over the whole sphere: longitude along x, latitude along y, in triangles so small that
// their straight lines matter little.
void draw_directions(const Gl& gl, float q = 1) {
  constexpr int kColumns = 24, kRows = 12;
  std::vector<float> positions, directions;
  const auto corner = [&](int column, int row) {
    const float u = static_cast<float>(column) / kColumns, v = static_cast<float>(row) / kRows;
    positions.insert(positions.end(), {6 + 244 * u, 6 + 244 * v});
    const float longitude = 6.2831853f * u + 0.13f, latitude = 3.0f * (v - 0.5f);
    directions.insert(directions.end(),
                      {std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                       std::cos(latitude) * std::sin(longitude), q});
  };
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
        corner(column + x, row + y);
      }
    }
  }
  gl.DisableClientState(GL_COLOR_ARRAY);
  gl.Color4f(1, 1, 1, 1);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
  gl.VertexPointer(2, GL_FLOAT, 0, positions.data());
  gl.TexCoordPointer(4, GL_FLOAT, 0, directions.data());
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(positions.size() / 2));
}

void directions(const Gl& gl, GLsizei size, GLint min, GLint mag) {
  cube_map(gl, size, min, mag);
  clear(gl);
  pixel_projection(gl);
  draw_directions(gl);
}

// A sphere in perspective, turned and moved aside, with generated coordinates.
void draw_generated(const Gl& gl, GLint mode) {
  gl.TexGeniOES(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, mode);
  gl.Enable(GL_TEXTURE_GEN_STR_OES);
  clear(gl);
  perspective(gl);
  gl.Enable(GL_CULL_FACE);
  gl.Translatef(0.3f, -0.2f, -2.6f);
  gl.Rotatef(35, 1, 2, 0.5f);
  draw(gl, GL_TRIANGLES, sphere(1.1f, 40, 20), kNormals);
}

}  // namespace

SCENE(cube_maps, nearest,
      except_at_borders(
          "3.8.10: a direction on the border of two texels or faces rounds either way")) {
  directions(gl, 16, GL_NEAREST, GL_NEAREST);
}
SCENE(cube_maps, linear, kColours) { directions(gl, 16, GL_LINEAR, GL_LINEAR); }
SCENE(cube_maps, linear_odd_size, kColours) { directions(gl, 23, GL_LINEAR, GL_LINEAR); }
SCENE(cube_maps, minified_only,
      (Tolerance{
          2, 0.99, 8, 0.995,
          "3.7.8: without mipmaps the reference decides for four pixels at once whether they "
          "are magnified"})) {
  directions(gl, 64, GL_LINEAR, GL_NEAREST);
}
SCENE(cube_maps, linear_mipmap_nearest, kColours) {
  directions(gl, 128, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR);
}
SCENE(cube_maps, linear_mipmap_linear, kColours) {
  directions(gl, 128, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
}

SCENE(cube_maps, reflection_map, kColours) {
  cube_map(gl, 64, GL_LINEAR, GL_LINEAR);
  draw_generated(gl, GL_REFLECTION_MAP_OES);
}
SCENE(cube_maps, reflection_map_with_mipmaps, kColours) {
  cube_map(gl, 128, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  draw_generated(gl, GL_REFLECTION_MAP_OES);
}
SCENE(cube_maps, normal_map, kColours) {
  cube_map(gl, 64, GL_LINEAR, GL_LINEAR);
  draw_generated(gl, GL_NORMAL_MAP_OES);
}

// The normals' lengths do not matter for the direction, but rescaling and normalising do for what
// is reflected.
SCENE(cube_maps, scaled_and_normalised, kColours) {
  cube_map(gl, 64, GL_LINEAR, GL_LINEAR);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Enable(GL_NORMALIZE);
  gl.TexGeniOES(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, GL_REFLECTION_MAP_OES);
  gl.Enable(GL_TEXTURE_GEN_STR_OES);
  clear(gl);
  perspective(gl);
  gl.Translatef(0, 0, -2.6f);
  gl.Scalef(1.6f, 0.7f, 0.9f);
  draw(gl, GL_TRIANGLES, sphere(0.8f, 40, 20), kNormals);
}

// Lit, turned by the texture matrix, modulated.
SCENE(cube_maps, lit_and_turned, kColours) {
  cube_map(gl, 64, GL_LINEAR, GL_LINEAR);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.MatrixMode(GL_TEXTURE);
  gl.Rotatef(70, 0.2f, 1, -0.4f);
  draw_generated(gl, GL_REFLECTION_MAP_OES);
}

// A cube map goes before the 2D texture of its unit; the other unit has a 2D texture.
SCENE(cube_maps, two_units,
      except_at_borders("3.8.10: a direction on the border of two faces rounds either way")) {
  noise_texture(gl, 32, 32, 201);
  gl.Enable(GL_TEXTURE_2D);
  cube_map(gl, 32, GL_LINEAR, GL_LINEAR);
  gl.ActiveTexture(GL_TEXTURE1);
  noise_texture(gl, 16, 16, 202);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
  std::vector<Vertex> vertices = sphere(1.1f, 40, 20);
  gl.ClientActiveTexture(GL_TEXTURE1);
  gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
  gl.TexCoordPointer(2, GL_FLOAT, sizeof(Vertex), &vertices[0].s);
  gl.ClientActiveTexture(GL_TEXTURE0);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.Enable(GL_CULL_FACE);
  gl.TexGeniOES(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, GL_NORMAL_MAP_OES);
  gl.Enable(GL_TEXTURE_GEN_STR_OES);
  clear(gl);
  perspective(gl);
  gl.Translatef(0, 0, -2.6f);
  gl.Rotatef(20, 1, 2, 3);
  draw(gl, GL_TRIANGLES, vertices, kNormals);
}

// Faces copied from the surface, and drawn to with a framebuffer object; mipmaps made by hand.
SCENE(cube_maps, copied_and_drawn_to, kColours) {
  cube_map(gl, 32, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  parameter(gl, GL_GENERATE_MIPMAP, GL_FALSE);
  gl.Disable(GL_TEXTURE_CUBE_MAP_OES);
  clear(gl, 0.2f, 0.8f, 0.3f);
  pixel_projection(gl);
  draw(gl, GL_TRIANGLES, coloured(rectangle(4, 10, 40, 20), 200, 30, 90));
  gl.CopyTexSubImage2D(kFaces[2], 0, 5, 3, 0, 0, 20, 24);
  gl.CopyTexImage2D(kFaces[5], 0, GL_RGBA, 1, 2, 32, 32, 0);
  GLint texture = 0;
  GLuint framebuffer = 0;
  gl.GetIntegerv(GL_TEXTURE_BINDING_CUBE_MAP_OES, &texture);
  gl.GenFramebuffersOES(1, &framebuffer);
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, framebuffer);
  for (const GLenum face : {kFaces[0], kFaces[3]}) {
    gl.FramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, face,
                               static_cast<GLuint>(texture), 0);
    gl.Viewport(0, 0, 32, 32);
    clear(gl, 0.1f, 0.2f, face == kFaces[0] ? 0.9f : 0.4f);
    pixel_projection(gl, 32, 32);
    draw(gl, GL_TRIANGLES, coloured(rectangle(3, 4, 20, 29), 250, 180, 40));
  }
  gl.BindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
  gl.Viewport(0, 0, 256, 256);
  gl.GenerateMipmapOES(GL_TEXTURE_CUBE_MAP_OES);
  gl.Enable(GL_TEXTURE_CUBE_MAP_OES);
  clear(gl);
  pixel_projection(gl);
  draw_directions(gl);
}

}  // namespace clearpipe::conformance
