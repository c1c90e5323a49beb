// The rows of state_table.def, for tests: how a variable is asked for, and what is asked, given and
// expected in each type (2.3, 6.1.2).
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "api/prototypes.h"

namespace clearpipe::api {

// How values convert (6.1.2).
enum class Kind { kNumber, kColour, kInteger, kEnumerant, kBoolean };

// The command that asks for a variable, and how many of it there are.
enum class Query {
  kGet,                  // GetBooleanv, GetIntegerv, GetFixedv, GetFloatv
  kGetOfUnit,            // the same, of each ACTIVE_TEXTURE
  kGetOfClientUnit,      // the same, of each CLIENT_ACTIVE_TEXTURE
  kGetNumbered,          // the same, of eight names in a row
  kPointer,              // GetPointerv
  kPointerOfClientUnit,  // the same, of each CLIENT_ACTIVE_TEXTURE
  kBuffer,               // GetBufferParameteriv, of each target
  kClipPlane,            // GetClipPlane
  kLight,                // GetLight
  kLight0,
  kLights1To7,
  kMaterial,        // GetMaterial, of each face
  kTexEnv,          // GetTexEnv, of each ACTIVE_TEXTURE
  kPointSpriteEnv,  // the same, with the target POINT_SPRITE_OES
  kFilterControl,   // the same, with the target TEXTURE_FILTER_CONTROL_EXT
  kTexGen,          // GetTexGen, of each ACTIVE_TEXTURE
  kTexParameter,    // GetTexParameter, of each target
  kRenderbuffer,    // GetRenderbufferParameterivOES
  kAttachment,      // GetFramebufferAttachmentParameterivOES, of each attachment point
};

GLint as_integer(Kind kind, double value);
GLfixed as_fixed(Kind kind, double value);

// Values in the types of a call that sets them.
class Given {
 public:
  Given(Kind kind, const std::vector<double>& values);
  GLfloat f(size_t k) const { return float_[k]; }
  GLfixed x(size_t k) const { return fixed_[k]; }
  GLint i(size_t k) const { return integer_[k]; }
  GLuint u(size_t k) const { return static_cast<GLuint>(integer_[k]); }
  GLenum e(size_t k) const { return static_cast<GLenum>(integer_[k]); }
  GLubyte ub(size_t k) const { return static_cast<GLubyte>(float_[k] * 255 + 0.5f); }
  GLboolean b(size_t k) const { return integer_[k] != 0; }
  const GLfloat* fv() const { return float_.data(); }
  const GLfixed* xv() const { return fixed_.data(); }
  const GLint* iv() const { return integer_.data(); }
  const GLfloat* bits() const { return reinterpret_cast<const GLfloat*>(integer_.data()); }
  const void* pointer() const { return reinterpret_cast<const void*>(intptr_t{integer_[0]}); }

 private:
  std::array<GLfloat, 20> float_{};
  std::array<GLfixed, 20> fixed_{};
  std::array<GLint, 20> integer_{};
};

struct StateRow {
  const char* table;
  Query query;
  GLenum name;
  Kind kind;
  std::vector<double> initial, other;
  using Setter = void (*)(const Given& v, GLenum i);
  std::vector<Setter> setters;
  std::string text() const;  // the name
};
const std::vector<StateRow>& state_rows();

// The numbers of the lights, planes, units or targets a query is asked of: [first, end).
struct Instances {
  GLenum first, end;
};
Instances instances(Query query);

// While it lives, the unit, buffer, renderbuffer or framebuffer of that number is selected.
class Selected {
 public:
  Selected(Query query, GLenum instance);
  ~Selected();
  Selected(const Selected&) = delete;
  Selected& operator=(const Selected&) = delete;

 private:
  void (*restore_)(GLuint) = nullptr;
  GLuint former_ = 0;
};

// What the queries of a row write, in each type that there is a query for; more room than any of
// them needs, which they must leave alone.
struct Answers {
  static constexpr size_t kRoom = 20;
  static constexpr int kUntouched = 77;
  bool has_boolean = false, has_integer = false, has_fixed = false, has_float = false;
  std::array<GLboolean, kRoom> boolean;
  std::array<GLint, kRoom> integer;
  std::array<GLfixed, kRoom> fixed;
  std::array<GLfloat, kRoom> number;
  friend bool operator==(const Answers&, const Answers&) = default;
};
Answers ask(const StateRow& row, GLenum instance);

// All rows and instances, in their order.
std::vector<Answers> ask_all();

}  // namespace clearpipe::api
