// The fixed-point commands (2.3): every number given in 16.16. The reference is Mesa's OpenGL
// ES 1.1, which has them; arrays are given in floating point here, see second_reference.def.
// SPDX-License-Identifier: MIT
#include <array>

#include "conformance/scenes/draw.h"

namespace clearpipe::conformance {

namespace {

constexpr GLfixed fixed(double value) { return static_cast<GLfixed>(value * 65536); }

void perspective_in_fixed_point(const Gl& gl) {
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Frustumx(fixed(-0.57), fixed(0.57), fixed(-0.57), fixed(0.57), fixed(1), fixed(50));
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
}

}  // namespace

// Matrices, colours, line widths, point sizes, depth ranges and offsets.
ES_SCENE(fixed_point, geometry, kColours) {
  gl.ClearColorx(fixed(0.1), fixed(0.2), fixed(0.15), fixed(1));
  gl.ClearDepthx(fixed(0.9));
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Orthox(0, fixed(256), 0, fixed(256), fixed(-100), fixed(100));
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.DepthRangex(fixed(0.1), fixed(0.8));
  gl.Translatex(fixed(128), fixed(128), 0);
  for (int i = 0; i < 6; ++i) {
    gl.Rotatex(fixed(37.5), 0, 0, fixed(1));
    gl.Scalex(fixed(0.9), fixed(0.95), fixed(1));
    gl.PolygonOffsetx(fixed(-0.5), fixed(i));
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    gl.Color4x(fixed(0.15 * i), fixed(1 - 0.15 * i), fixed(0.5), fixed(1));
    draw(gl, GL_TRIANGLES, rectangle(10, 10, 120, 50), kPositions);
  }
  const std::array<GLfixed, 16> matrix = {
      fixed(1),     0,           0, 0,       0, fixed(1), 0, 0, 0, 0, fixed(1), 0,
      fixed(16.25), fixed(20.5), 0, fixed(1)};
  gl.LoadMatrixx(matrix.data());
  gl.MultMatrixx(matrix.data());
  gl.LineWidthx(fixed(3));
  gl.Color4x(fixed(1), fixed(1), fixed(0.25), fixed(1));
  draw(gl, GL_LINES, rectangle(3, 4, 190, 31), kPositions);
  gl.PointSizex(fixed(5));
  draw(gl, GL_POINTS, rectangle(20.3f, 150.4f, 200.6f, 170.7f), kPositions);
}

// Lights, materials and fog. Colours stay in [0, 1]: there the references agree.
ES_SCENE(fixed_point, lighting, kColours) {
  clear(gl);
  perspective_in_fixed_point(gl);
  const std::array<GLfixed, 4> position = {fixed(2), fixed(3), fixed(1), fixed(1)},
                               diffuse = {fixed(0.5), fixed(0.375), fixed(0.25), fixed(1)},
                               ambient = {fixed(0.125), fixed(0.125), fixed(0.25), fixed(1)},
                               fog = {fixed(0.25), fixed(0.5), fixed(0.75), fixed(1)};
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_RESCALE_NORMAL);
  gl.Lightxv(GL_LIGHT0, GL_POSITION, position.data());
  gl.Lightxv(GL_LIGHT0, GL_DIFFUSE, diffuse.data());
  gl.Lightx(GL_LIGHT0, GL_LINEAR_ATTENUATION, fixed(0.0625));
  gl.LightModelxv(GL_LIGHT_MODEL_AMBIENT, ambient.data());
  gl.Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse.data());
  gl.Materialx(GL_FRONT_AND_BACK, GL_SHININESS, fixed(8));
  gl.Enable(GL_FOG);
  gl.Fogx(GL_FOG_MODE, GL_LINEAR);
  gl.Fogx(GL_FOG_START, fixed(2));
  gl.Fogx(GL_FOG_END, fixed(9));
  gl.Fogxv(GL_FOG_COLOR, fog.data());
  gl.Translatex(0, 0, fixed(-5));
  gl.Rotatex(fixed(30), fixed(1), fixed(0.5), 0);
  gl.Scalex(fixed(1.5), fixed(1.5), fixed(1.5));
  draw(gl, GL_TRIANGLES, sphere(1.2f, 24, 16), kNormals);
}

// Texture parameters and environments, the alpha test and user clip planes.
ES_SCENE(fixed_point, textures, kColours) {
  clear(gl);
  pixel_projection(gl);
  noise_texture(gl, 16, 16, 210);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  const std::array<GLfixed, 4> colour = {fixed(0.75), fixed(0.25), fixed(0.5), fixed(0.5)};
  gl.TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_BLEND);
  gl.TexEnvxv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, colour.data());
  gl.MatrixMode(GL_TEXTURE);
  gl.Scalex(fixed(1.5), fixed(1.25), fixed(1));
  gl.MatrixMode(GL_MODELVIEW);
  gl.MultiTexCoord4x(GL_TEXTURE0, fixed(0.25), fixed(0.5), 0, fixed(1));
  draw(gl, GL_TRIANGLES, rectangle(2, 2, 60, 60), kPositions);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFuncx(GL_GREATER, fixed(0.3));
  gl.Color4x(fixed(0.5), fixed(0.875), fixed(1), fixed(1));
  draw(gl, GL_TRIANGLES, rectangle(64.3f, 6.2f, 250.1f, 250.4f), kTexCoords);
}

}  // namespace clearpipe::conformance
