// The fixed-point commands (2.1.2, 2.3) on the float ones.
// SPDX-License-Identifier: MIT
#include <array>

#include "reference/desktop.h"

namespace clearpipe::reference {

namespace {

using Vector = std::array<float, 16>;

Vector vector_from_fixed(const GLfixed* values, int count) {
  Vector result{};
  for (int i = 0; i < count; ++i) result[i] = from_fixed(values[i]);
  return result;
}

// A parameter that names an enum or a boolean is its value in every form (2.3).
bool is_enum(GLenum pname) {
  switch (pname) {
    case GL_FOG_MODE:
    case GL_LIGHT_MODEL_TWO_SIDE:
    case GL_TEXTURE_ENV_MODE:
    case GL_COMBINE_RGB:
    case GL_COMBINE_ALPHA:
    case GL_SRC0_RGB:
    case GL_SRC1_RGB:
    case GL_SRC2_RGB:
    case GL_SRC0_ALPHA:
    case GL_SRC1_ALPHA:
    case GL_SRC2_ALPHA:
    case GL_OPERAND0_RGB:
    case GL_OPERAND1_RGB:
    case GL_OPERAND2_RGB:
    case GL_OPERAND0_ALPHA:
    case GL_OPERAND1_ALPHA:
    case GL_OPERAND2_ALPHA:
    case GL_COORD_REPLACE_OES:
    case GL_TEXTURE_MIN_FILTER:
    case GL_TEXTURE_MAG_FILTER:
    case GL_TEXTURE_WRAP_S:
    case GL_TEXTURE_WRAP_T:
    case GL_GENERATE_MIPMAP:
      return true;
    default:
      return false;
  }
}

int count_of(GLenum pname) {
  switch (pname) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
    case GL_EMISSION:
    case GL_AMBIENT_AND_DIFFUSE:
    case GL_POSITION:
    case GL_LIGHT_MODEL_AMBIENT:
    case GL_FOG_COLOR:
    case GL_TEXTURE_ENV_COLOR:
      return 4;
    case GL_SPOT_DIRECTION:
    case GL_POINT_DISTANCE_ATTENUATION:
      return 3;
    default:
      return 1;
  }
}

float parameter(GLenum pname, GLfixed value) {
  return is_enum(pname) ? static_cast<float>(value) : from_fixed(value);
}

Vector parameters(GLenum pname, const GLfixed* values) {
  if (is_enum(pname)) return {static_cast<float>(values[0])};
  return vector_from_fixed(values, count_of(pname));
}

void translate_matrices(Gl& gl) {
  gl.LoadMatrixx = [](const GLfixed* m) { desktop.LoadMatrixf(vector_from_fixed(m, 16).data()); };
  gl.MultMatrixx = [](const GLfixed* m) { desktop.MultMatrixf(vector_from_fixed(m, 16).data()); };
  gl.Rotatex = [](GLfixed angle, GLfixed x, GLfixed y, GLfixed z) {
    desktop.Rotatef(from_fixed(angle), from_fixed(x), from_fixed(y), from_fixed(z));
  };
  gl.Scalex = [](GLfixed x, GLfixed y, GLfixed z) {
    desktop.Scalef(from_fixed(x), from_fixed(y), from_fixed(z));
  };
  gl.Translatex = [](GLfixed x, GLfixed y, GLfixed z) {
    desktop.Translatef(from_fixed(x), from_fixed(y), from_fixed(z));
  };
  gl.Frustumx = [](GLfixed l, GLfixed r, GLfixed b, GLfixed t, GLfixed n, GLfixed f) {
    desktop_only.Frustum(from_fixed(l), from_fixed(r), from_fixed(b), from_fixed(t), from_fixed(n),
                         from_fixed(f));
  };
  gl.Orthox = [](GLfixed l, GLfixed r, GLfixed b, GLfixed t, GLfixed n, GLfixed f) {
    desktop_only.Ortho(from_fixed(l), from_fixed(r), from_fixed(b), from_fixed(t), from_fixed(n),
                       from_fixed(f));
  };
  gl.ClipPlanex = [](GLenum plane, const GLfixed* equation) {
    double wide[4];
    for (int i = 0; i < 4; ++i) wide[i] = from_fixed(equation[i]);
    desktop_only.ClipPlane(plane, wide);
  };
  gl.DepthRangex = [](GLfixed n, GLfixed f) { desktop.DepthRangef(from_fixed(n), from_fixed(f)); };
}

void translate_scalars(Gl& gl) {
  gl.Color4x = [](GLfixed r, GLfixed g, GLfixed b, GLfixed a) {
    desktop.Color4f(from_fixed(r), from_fixed(g), from_fixed(b), from_fixed(a));
  };
  gl.Normal3x = [](GLfixed x, GLfixed y, GLfixed z) {
    desktop.Normal3f(from_fixed(x), from_fixed(y), from_fixed(z));
  };
  gl.MultiTexCoord4x = [](GLenum unit, GLfixed s, GLfixed t, GLfixed r, GLfixed q) {
    desktop.MultiTexCoord4f(unit, from_fixed(s), from_fixed(t), from_fixed(r), from_fixed(q));
  };
  gl.PointSizex = [](GLfixed size) { desktop.PointSize(from_fixed(size)); };
  gl.LineWidthx = [](GLfixed width) { desktop.LineWidth(from_fixed(width)); };
  gl.PolygonOffsetx = [](GLfixed factor, GLfixed units) {
    desktop.PolygonOffset(from_fixed(factor), from_fixed(units));
  };
  gl.SampleCoveragex = [](GLclampx value, GLboolean invert) {
    desktop.SampleCoverage(from_fixed(value), invert);
  };
  gl.AlphaFuncx = [](GLenum func, GLfixed ref) { desktop.AlphaFunc(func, from_fixed(ref)); };
  gl.ClearColorx = [](GLfixed r, GLfixed g, GLfixed b, GLfixed a) {
    desktop.ClearColor(from_fixed(r), from_fixed(g), from_fixed(b), from_fixed(a));
  };
  gl.ClearDepthx = [](GLfixed depth) { desktop.ClearDepthf(from_fixed(depth)); };
}

void translate_parameters(Gl& gl) {
  gl.Fogx = [](GLenum pname, GLfixed v) { desktop.Fogf(pname, parameter(pname, v)); };
  gl.Fogxv = [](GLenum pname, const GLfixed* v) {
    desktop.Fogfv(pname, parameters(pname, v).data());
  };
  gl.LightModelx = [](GLenum pname, GLfixed v) { desktop.LightModelf(pname, parameter(pname, v)); };
  gl.LightModelxv = [](GLenum pname, const GLfixed* v) {
    desktop.LightModelfv(pname, parameters(pname, v).data());
  };
  gl.Lightx = [](GLenum light, GLenum pname, GLfixed v) {
    desktop.Lightf(light, pname, parameter(pname, v));
  };
  gl.Lightxv = [](GLenum light, GLenum pname, const GLfixed* v) {
    desktop.Lightfv(light, pname, parameters(pname, v).data());
  };
  gl.Materialx = [](GLenum face, GLenum pname, GLfixed v) {
    desktop.Materialf(face, pname, parameter(pname, v));
  };
  gl.Materialxv = [](GLenum face, GLenum pname, const GLfixed* v) {
    desktop.Materialfv(face, pname, parameters(pname, v).data());
  };
  gl.PointParameterx = [](GLenum pname, GLfixed v) {
    desktop.PointParameterf(pname, parameter(pname, v));
  };
  gl.PointParameterxv = [](GLenum pname, const GLfixed* v) {
    desktop.PointParameterfv(pname, parameters(pname, v).data());
  };
  gl.TexParameterx = [](GLenum target, GLenum pname, GLfixed v) {
    desktop.TexParameterf(target, pname, parameter(pname, v));
  };
  gl.TexParameterxv = [](GLenum target, GLenum pname, const GLfixed* v) {
    desktop.TexParameterfv(target, pname, parameters(pname, v).data());
  };
  gl.TexEnvx = [](GLenum target, GLenum pname, GLfixed v) {
    desktop.TexEnvf(target, pname, parameter(pname, v));
  };
  gl.TexEnvxv = [](GLenum target, GLenum pname, const GLfixed* v) {
    desktop.TexEnvfv(target, pname, parameters(pname, v).data());
  };
}

// A scene draws and asks nothing in fixed point: these are not offered.
void leave_out_queries(Gl& gl) {
  gl.GetFixedv = nullptr;
  gl.GetClipPlanex = nullptr;
  gl.GetLightxv = nullptr;
  gl.GetMaterialxv = nullptr;
  gl.GetTexEnvxv = nullptr;
  gl.GetTexParameterxv = nullptr;
  gl.QueryMatrixxOES = nullptr;
}

}  // namespace

void translate_fixed(Gl& gl) {
  translate_matrices(gl);
  translate_scalars(gl);
  translate_parameters(gl);
  leave_out_queries(gl);
}

}  // namespace clearpipe::reference
