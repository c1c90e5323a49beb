// See state_table.h.
// SPDX-License-Identifier: MIT
#include "api/state_table.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "api/debug.h"
#include "api/error_text.h"

namespace clearpipe::api {

namespace {

GLenum buffer_target(GLenum i) { return i == 0 ? GL_ARRAY_BUFFER : GL_ELEMENT_ARRAY_BUFFER; }
GLenum texture_target(GLenum i) { return i == 0 ? GL_TEXTURE_2D : GL_TEXTURE_CUBE_MAP_OES; }
GLenum attachment_point(GLenum i) {
  return i == 0   ? GL_COLOR_ATTACHMENT0_OES
         : i == 1 ? GL_DEPTH_ATTACHMENT_OES
                  : GL_STENCIL_ATTACHMENT_OES;
}

// A name of objects that tests use for nothing else.
constexpr GLuint kOwnName = 900;

GLuint renderbuffer() {
  glBindRenderbufferOES(GL_RENDERBUFFER_OES, kOwnName);
  glBindRenderbufferOES(GL_RENDERBUFFER_OES, 0);
  return kOwnName;
}
// One pixel of a format whose component has a size; nothing of the initial one if it has none.
void storage(const Given& v, GLenum format) {
  const GLsizei size = v.b(0);
  glRenderbufferStorageOES(GL_RENDERBUFFER_OES, size ? format : GL_RGBA4_OES, size, size);
}
// COLOR_MATERIAL has left the current colour in it.
void default_material() {
  const GLfloat ambient[] = {0.2f, 0.2f, 0.2f, 1}, diffuse[] = {0.8f, 0.8f, 0.8f, 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, ambient);
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
}

GLint saturated(double value) {
  constexpr double kLow = std::numeric_limits<GLint>::min(),
                   kHigh = std::numeric_limits<GLint>::max();
  return static_cast<GLint>(std::clamp(value, kLow, kHigh));
}

GLuint bound(GLenum binding) {
  GLint name = 0;
  glGetIntegerv(binding, &name);
  return static_cast<GLuint>(name);
}

}  // namespace

GLint as_integer(Kind kind, double value) {
  return saturated(kind == Kind::kColour ? (4294967295.0 * value - 1) / 2 : std::round(value));
}

GLfixed as_fixed(Kind kind, double value) {
  return saturated(kind == Kind::kEnumerant ? value : std::floor(value * 65536 + 0.5));
}

Given::Given(Kind kind, const std::vector<double>& values) {
  for (size_t k = 0; k < values.size(); ++k) {
    float_[k] = static_cast<GLfloat>(values[k]);
    fixed_[k] = as_fixed(kind, values[k]);
    integer_[k] = as_integer(kind, values[k]);
  }
}

const std::vector<StateRow>& state_rows() {
  static const std::vector<StateRow> kRows = {
#define LIST(...) \
  { __VA_ARGS__ }
#define BITS(value)                                                                              \
  (std::bit_cast<GLint>(GLfloat{value}), 0, 0, 0, 0, std::bit_cast<GLint>(GLfloat{value}), 0, 0, \
   0, 0, std::bit_cast<GLint>(GLfloat{value}), 0, 0, 0, 0, std::bit_cast<GLint>(GLfloat{value}))
#define SET(...) [](const Given& v, [[maybe_unused]] GLenum i) { __VA_ARGS__; }
#define STATE(table, query, name, kind, initial, other, ...) \
  {table, Query::query, name, Kind::kind, LIST initial, LIST other, {__VA_ARGS__}},
#include "api/state_table.def"
#undef STATE
#undef SET
#undef BITS
#undef LIST
  };
  return kRows;
}

std::string StateRow::text() const {
  const char* known = enumerant_name(name);
  return known ? known : std::to_string(name);
}

Instances instances(Query query) {
  switch (query) {
    case Query::kGetOfUnit:
    case Query::kGetOfClientUnit:
    case Query::kPointerOfClientUnit:
    case Query::kTexEnv:
    case Query::kPointSpriteEnv:
    case Query::kFilterControl:
    case Query::kTexGen:
    case Query::kGetNumbered:
    case Query::kClipPlane:
    case Query::kLight:
      return {0, 8};
    case Query::kLights1To7:
      return {1, 8};
    case Query::kBuffer:
    case Query::kMaterial:
    case Query::kTexParameter:
      return {0, 2};
    case Query::kAttachment:
      return {0, 3};
    default:
      return {0, 1};
  }
}

Selected::Selected(Query query, GLenum i) {
  switch (query) {
    case Query::kGetOfUnit:
    case Query::kTexEnv:
    case Query::kPointSpriteEnv:
    case Query::kFilterControl:
    case Query::kTexGen:
      former_ = bound(GL_ACTIVE_TEXTURE);
      glActiveTexture(GL_TEXTURE0 + i);
      restore_ = [](GLuint unit) { glActiveTexture(unit); };
      break;
    case Query::kGetOfClientUnit:
    case Query::kPointerOfClientUnit:
      former_ = bound(GL_CLIENT_ACTIVE_TEXTURE);
      glClientActiveTexture(GL_TEXTURE0 + i);
      restore_ = [](GLuint unit) { glClientActiveTexture(unit); };
      break;
    case Query::kBuffer:  // the one that is bound, if any
      if (bound(i == 0 ? GL_ARRAY_BUFFER_BINDING : GL_ELEMENT_ARRAY_BUFFER_BINDING) == 0) {
        glBindBuffer(buffer_target(i), kOwnName + i);
        former_ = buffer_target(i);
        restore_ = [](GLuint target) { glBindBuffer(target, 0); };
      }
      break;
    case Query::kRenderbuffer:
      if (bound(GL_RENDERBUFFER_BINDING_OES) == 0) {
        glBindRenderbufferOES(GL_RENDERBUFFER_OES, kOwnName + 1);
        restore_ = [](GLuint) { glBindRenderbufferOES(GL_RENDERBUFFER_OES, 0); };
      }
      break;
    case Query::kAttachment:
      if (bound(GL_FRAMEBUFFER_BINDING_OES) == 0) {
        glBindFramebufferOES(GL_FRAMEBUFFER_OES, kOwnName);
        restore_ = [](GLuint) { glBindFramebufferOES(GL_FRAMEBUFFER_OES, 0); };
      }
      break;
    default:
      break;
  }
}

Selected::~Selected() {
  if (restore_) restore_(former_);
}

Answers ask(const StateRow& row, GLenum i) {
  Answers a;
  a.boolean.fill(Answers::kUntouched);
  a.integer.fill(Answers::kUntouched);
  a.fixed.fill(Answers::kUntouched);
  a.number.fill(Answers::kUntouched);
  const Selected selected(row.query, i);
  switch (row.query) {
    case Query::kGet:
    case Query::kGetOfUnit:
    case Query::kGetOfClientUnit:
    case Query::kGetNumbered: {
      const GLenum name = row.name + (row.query == Query::kGetNumbered ? i : 0);
      a.has_boolean = a.has_integer = a.has_fixed = a.has_float = true;
      glGetBooleanv(name, a.boolean.data());
      glGetIntegerv(name, a.integer.data());
      glGetFixedv(name, a.fixed.data());
      glGetFloatv(name, a.number.data());
      break;
    }
    case Query::kPointer:
    case Query::kPointerOfClientUnit: {
      void* pointer = nullptr;
      glGetPointerv(row.name, &pointer);
      a.integer[0] = static_cast<GLint>(reinterpret_cast<intptr_t>(pointer));
      a.has_integer = true;
      break;
    }
    case Query::kBuffer:
      a.has_integer = true;
      glGetBufferParameteriv(buffer_target(i), row.name, a.integer.data());
      break;
    case Query::kClipPlane:
      a.has_fixed = a.has_float = true;
      glGetClipPlanex(row.name + i, a.fixed.data());
      glGetClipPlanef(row.name + i, a.number.data());
      break;
    case Query::kLight:
    case Query::kLight0:
    case Query::kLights1To7:
      a.has_fixed = a.has_float = true;
      glGetLightxv(GL_LIGHT0 + i, row.name, a.fixed.data());
      glGetLightfv(GL_LIGHT0 + i, row.name, a.number.data());
      break;
    case Query::kMaterial: {
      const GLenum face = i == 0 ? GL_FRONT : GL_BACK;
      a.has_fixed = a.has_float = true;
      glGetMaterialxv(face, row.name, a.fixed.data());
      glGetMaterialfv(face, row.name, a.number.data());
      break;
    }
    case Query::kTexEnv:
    case Query::kPointSpriteEnv:
    case Query::kFilterControl: {
      const GLenum target = row.query == Query::kTexEnv           ? GL_TEXTURE_ENV
                            : row.query == Query::kPointSpriteEnv ? GL_POINT_SPRITE_OES
                                                                  : GL_TEXTURE_FILTER_CONTROL_EXT;
      a.has_integer = a.has_fixed = a.has_float = true;
      glGetTexEnviv(target, row.name, a.integer.data());
      glGetTexEnvxv(target, row.name, a.fixed.data());
      glGetTexEnvfv(target, row.name, a.number.data());
      break;
    }
    case Query::kTexGen:
      a.has_integer = a.has_fixed = a.has_float = true;
      glGetTexGenivOES(GL_TEXTURE_GEN_STR_OES, row.name, a.integer.data());
      glGetTexGenxvOES(GL_TEXTURE_GEN_STR_OES, row.name, a.fixed.data());
      glGetTexGenfvOES(GL_TEXTURE_GEN_STR_OES, row.name, a.number.data());
      break;
    case Query::kTexParameter:
      a.has_integer = a.has_fixed = a.has_float = true;
      glGetTexParameteriv(texture_target(i), row.name, a.integer.data());
      glGetTexParameterxv(texture_target(i), row.name, a.fixed.data());
      glGetTexParameterfv(texture_target(i), row.name, a.number.data());
      break;
    case Query::kRenderbuffer:
      a.has_integer = true;
      glGetRenderbufferParameterivOES(GL_RENDERBUFFER_OES, row.name, a.integer.data());
      break;
    case Query::kAttachment:
      a.has_integer = true;
      glGetFramebufferAttachmentParameterivOES(GL_FRAMEBUFFER_OES, attachment_point(i), row.name,
                                               a.integer.data());
      break;
  }
  return a;
}

std::vector<Answers> ask_all() {
  std::vector<Answers> all;
  for (const StateRow& row : state_rows()) {
    const Instances of = instances(row.query);
    for (GLenum i = of.first; i < of.end; ++i) all.push_back(ask(row, i));
  }
  return all;
}

}  // namespace clearpipe::api
