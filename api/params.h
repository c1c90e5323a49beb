// The typed parameter vectors of the f, x, i and ub forms of a call, seen as one type.
//
// `Params` reads what an application passes, `Out` writes what a query returns, each with the
// conversions of 2.3, table 2.7 and 6.1.2. Enumerants pass through fixed-point calls unscaled.
// SPDX-License-Identifier: MIT
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <cmath>

#include "api/fixed.h"

namespace clearpipe::api {

class Params {
 public:
  explicit Params(const GLfloat* values, bool scalar = false)
      : values_(values), type_(GL_FLOAT), scalar_(scalar) {}
  static Params fixed(const GLfixed* values, bool scalar = false) {
    return {values, GL_FIXED, scalar};
  }
  static Params integer(const GLint* values, bool scalar = false) {
    return {values, kInteger, scalar};
  }

  bool scalar() const { return scalar_; }
  float number(int i = 0) const {
    if (type_ == GL_FLOAT) return static_cast<const GLfloat*>(values_)[i];
    const GLint raw = static_cast<const GLint*>(values_)[i];
    return type_ == GL_FIXED ? from_fixed(raw) : static_cast<float>(raw);
  }
  // The nearest integer, as wide as the type has it.
  GLint integer(int i = 0) const {
    return type_ == kInteger ? static_cast<const GLint*>(values_)[i]
                             : saturate_int(std::floor(static_cast<double>(number(i)) + 0.5));
  }
  // Colours given as integers are normalised (table 2.7).
  float colour(int i) const {
    if (type_ != kInteger) return number(i);
    return static_cast<float>((2.0 * static_cast<const GLint*>(values_)[i] + 1.0) / 4294967295.0);
  }
  GLenum enumerant(int i = 0) const {
    if (type_ == GL_FLOAT) {
      const float value = static_cast<const GLfloat*>(values_)[i];
      return value >= 0 && value < 4294967296.0f ? static_cast<GLenum>(value) : 0xffffffffu;
    }
    return static_cast<GLenum>(static_cast<const GLint*>(values_)[i]);
  }
  bool boolean() const {
    return type_ == GL_FLOAT ? *static_cast<const GLfloat*>(values_) != 0
                             : *static_cast<const GLint*>(values_) != 0;
  }

 private:
  static constexpr GLenum kInteger = 0x1404;
  Params(const void* values, GLenum type, bool scalar)
      : values_(values), type_(type), scalar_(scalar) {}
  const void* values_;
  GLenum type_;
  bool scalar_;
};

class Out {
 public:
  enum class Type { kBoolean, kInteger, kInteger64, kFixed, kFloat };
  explicit Out(GLboolean* values) : values_(values), type_(Type::kBoolean) {}
  explicit Out(GLfloat* values) : values_(values), type_(Type::kFloat) {}
  explicit Out(GLint64* values) : values_(values), type_(Type::kInteger64) {}
  static Out fixed(GLfixed* values) { return {values, Type::kFixed}; }
  static Out integer(GLint* values) { return {values, Type::kInteger}; }

  void number(int i, float value) const {
    switch (type_) {
      case Type::kBoolean:
        boolean_at(i) = value != 0;
        break;
      case Type::kInteger:
        int_at(i) = saturate_int(std::floor(static_cast<double>(value) + 0.5));
        break;
      case Type::kInteger64:
        int64_at(i) = saturate_int64(std::floor(static_cast<double>(value) + 0.5));
        break;
      case Type::kFixed:
        int_at(i) = to_fixed(value);
        break;
      case Type::kFloat:
        static_cast<GLfloat*>(values_)[i] = value;
        break;
    }
  }
  // Colours, normals, depth ranges and the depth clear value map linearly to the whole integer
  // range (6.1.2); the alpha reference is none of them.
  void colour(int i, float value) const {
    if (type_ == Type::kInteger) {
      int_at(i) = saturate_int((4294967295.0 * static_cast<double>(value) - 1.0) / 2.0);
    } else if (type_ == Type::kInteger64) {
      int64_at(i) =
          saturate_int64((18446744073709551615.0 * static_cast<double>(value) - 1.0) / 2.0);
    } else {
      number(i, value);
    }
  }
  void integer(int i, GLint value) const {
    switch (type_) {
      case Type::kBoolean:
        boolean_at(i) = value != 0;
        break;
      case Type::kInteger:
        int_at(i) = value;
        break;
      case Type::kInteger64:
        int64_at(i) = value;
        break;
      case Type::kFixed:
        int_at(i) = saturate_int(value * 65536.0);
        break;
      case Type::kFloat:
        static_cast<GLfloat*>(values_)[i] = static_cast<float>(value);
        break;
    }
  }
  void boolean(int i, bool value) const { integer(i, value ? 1 : 0); }
  void enumerant(int i, GLenum value) const {
    if (type_ == Type::kFixed) {
      int_at(i) = static_cast<GLint>(value);
    } else {
      integer(i, static_cast<GLint>(value));
    }
  }

 private:
  Out(void* values, Type type) : values_(values), type_(type) {}
  GLboolean& boolean_at(int i) const { return static_cast<GLboolean*>(values_)[i]; }
  GLint64& int64_at(int i) const { return static_cast<GLint64*>(values_)[i]; }
  GLint& int_at(int i) const { return static_cast<GLint*>(values_)[i]; }
  void* values_;
  Type type_;
};

}  // namespace clearpipe::api
