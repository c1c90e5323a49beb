// See source.h. Parameters are written by the types that the list of calls gives them: enums by
// name, floats so that they are read back exactly, memory as an array of what it holds.
// SPDX-License-Identifier: MIT
#include "conformance/random/source.h"

#include <bit>
#include <cstdio>
#include <cstring>
#include <sstream>

namespace clearpipe::conformance::random {

namespace {

struct Signature {
  const char* name;
  const char* parameters;  // "(GLenum mode, GLint first, GLsizei count)"
};

constexpr Signature kSignatures[] = {
#define CALL(type, name, parameters, ...) {#name, #parameters},
#include "api/gles1.def"
#undef CALL
};

struct Enum {
  GLenum value;
  const char* name;
};

constexpr Enum kEnums[] = {
#define ENUM(name) {name, #name},
#include "conformance/random/enums.def"
#undef ENUM
};

constexpr const char* kModes[] = {"GL_POINTS",      "GL_LINES",     "GL_LINE_LOOP",
                                  "GL_LINE_STRIP",  "GL_TRIANGLES", "GL_TRIANGLE_STRIP",
                                  "GL_TRIANGLE_FAN"};

const char* name_of_enum(GLenum value) {
  for (const Enum& e : kEnums) {
    if (e.value == value) return e.name;
  }
  return nullptr;
}

std::string number(float value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", static_cast<double>(value));
  if (std::strpbrk(text, ".e") == nullptr) std::strcat(text, ".0");
  return std::string(text) + "f";
}

struct Parameter {
  std::string type, name;
};

std::vector<Parameter> parameters_of(Call call) {
  std::string text = kSignatures[static_cast<size_t>(call)].parameters;
  text = text.substr(1, text.size() - 2);
  std::vector<Parameter> parameters;
  std::stringstream list(text);
  for (std::string one; std::getline(list, one, ',');) {
    const size_t space = one.rfind(' ');
    const size_t start = one.find_first_not_of(' ');
    parameters.push_back({one.substr(start, space - start), one.substr(space + 1)});
  }
  return parameters;
}

std::string scalar(const Command& command, const Parameter& parameter, uint32_t bits) {
  if (parameter.type == "GLfloat") return number(std::bit_cast<float>(bits));
  const bool mode = command.call == Call::DrawArrays || command.call == Call::DrawElements;
  if (mode && parameter.name == "mode" && bits <= GL_TRIANGLE_FAN) return kModes[bits];
  const bool may_be_enum =
      parameter.type == "GLenum" || parameter.name == "param" || parameter.name == "internalformat";
  if (may_be_enum && bits > 1) {
    if (const char* name = name_of_enum(bits)) return name;
  }
  if (parameter.type == "GLbitfield" || parameter.type == "GLuint") return std::to_string(bits);
  return std::to_string(static_cast<int32_t>(bits));
}

// The type of what a pointer points to: the parameter's own, or the one that `type` names.
std::string element_type(const Command& command, const std::vector<Parameter>& parameters) {
  for (size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& parameter = parameters[i];
    if (parameter.type == "const GLfloat*") return "GLfloat";
    if (parameter.type == "const GLfixed*") return "GLfixed";
    if (parameter.name != "type") continue;
    switch (command.arguments[i]) {
      case GL_FLOAT:
        return "GLfloat";
      case GL_FIXED:
        return "GLfixed";
      case GL_SHORT:
        return "GLshort";
      case GL_UNSIGNED_SHORT:
        return "GLushort";
      case GL_BYTE:
        return "GLbyte";
      default:
        return "GLubyte";
    }
  }
  return "GLubyte";
}

template <class T>
std::string elements(const std::vector<uint8_t>& bytes) {
  std::string text;
  for (size_t at = 0; at + sizeof(T) <= bytes.size(); at += sizeof(T)) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    if (!text.empty()) text += ", ";
    if constexpr (std::is_same_v<T, float>) {
      text += number(value);
    } else {
      text += std::to_string(value);
    }
  }
  return text;
}

std::string array_of(const std::string& type, const std::vector<uint8_t>& bytes) {
  if (type == "GLfloat") return elements<float>(bytes);
  if (type == "GLfixed") return elements<int32_t>(bytes);
  if (type == "GLshort") return elements<int16_t>(bytes);
  if (type == "GLushort") return elements<uint16_t>(bytes);
  if (type == "GLbyte") return elements<int8_t>(bytes);
  return elements<uint8_t>(bytes);
}

bool is_question(Call call) {
  return call == Call::GetError || call == Call::GetFloatv || call == Call::ReadPixels;
}

}  // namespace

std::string as_scene_file(const Stream& stream, const std::string& name) {
  std::string text =
      "// A shortened random stream.\n"
      "// SPDX-License-Identifier: MIT\n"
      "#include \"conformance/scene.h\"\n\n"
      "namespace clearpipe::conformance {\n\n"
      "SCENE(random, " +
      name + ", kColours) {\n  gl.Viewport(0, 0, " + std::to_string(stream.width) + ", " +
      std::to_string(stream.height) + ");\n";
  int arrays = 0;
  for (const Command& command : stream.commands) {
    const std::vector<Parameter> parameters = parameters_of(command.call);
    std::string line = std::string(is_question(command.call) ? "  // gl." : "  gl.") +
                       kSignatures[static_cast<size_t>(command.call)].name + "(";
    for (size_t i = 0; i < command.arguments.size(); ++i) {
      if (i != 0) line += ", ";
      if (parameters[i].type.back() != '*') {
        line += scalar(command, parameters[i], command.arguments[i]);
      } else if (!command.data.empty()) {
        const std::string type = element_type(command, parameters);
        const std::string array = "data_" + std::to_string(++arrays);
        text += "  static const " + type + " " + array + "[] = {" + array_of(type, command.data) +
                "};\n";
        line += array;
      } else if (command.arguments[i] == 0) {
        line += "nullptr";
      } else {
        line += "reinterpret_cast<const void*>(" + std::to_string(command.arguments[i]) + ")";
      }
    }
    text += line + ");\n";
  }
  return text + "}\n\n}  // namespace clearpipe::conformance\n";
}

}  // namespace clearpipe::conformance::random
