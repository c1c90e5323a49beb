// See error_text.h. "GL_INVALID_ENUM in glBlendFunc(sfactor = GL_ADD, dfactor = 1): sfactor GL_ADD
// is no factor of the source (4.1.7, table 4.1)".
// SPDX-License-Identifier: MIT
#include "api/error_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <string_view>

namespace clearpipe::api {

namespace {

const char* error_name(GLenum error) {  // table 2.3
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_STACK_OVERFLOW:
      return "GL_STACK_OVERFLOW";
    case GL_STACK_UNDERFLOW:
      return "GL_STACK_UNDERFLOW";
    case GL_INVALID_FRAMEBUFFER_OPERATION_OES:
      return "GL_INVALID_FRAMEBUFFER_OPERATION_OES";
    default:
      return "GL_OUT_OF_MEMORY";
  }
}

std::string hexadecimal(unsigned long long value) {
  char text[24];
  std::snprintf(text, sizeof text, "0x%04llX", value);
  return text;
}

std::string enumerant_text(unsigned long long value) {
  if (value < 0x100) return std::to_string(value);
  const char* name = enumerant_name(value);
  return name ? name : hexadecimal(value);
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

// The first of the parameters of a vector form, or the one of the others: an enumerant, if a value
// so large is one.
std::string first_of(const Params& p) {
  const char* name = enumerant_name(p.enumerant());
  return name ? name : number(static_cast<double>(p.number()));
}

// An argument with the name and the type of the parameter it comes from.
struct NamedArgument {
  std::string_view name;
  bool is_enum = false, is_bitfield = false;
  Argument value;
};

// Nothing for what is better not said. What a vector points to is looked at only where the
// validator has done so.
std::string value_text(const NamedArgument& a, bool at_fault) {
  if (const auto* i = std::get_if<long long>(&a.value)) {
    return a.is_enum && *i >= 0 ? enumerant_text(static_cast<unsigned long long>(*i))
                                : std::to_string(*i);
  }
  if (const auto* u = std::get_if<unsigned long long>(&a.value)) {
    return a.is_enum ? enumerant_text(*u) : a.is_bitfield ? hexadecimal(*u) : std::to_string(*u);
  }
  if (const auto* d = std::get_if<double>(&a.value)) return number(*d);
  if (const auto* pointer = std::get_if<const void*>(&a.value)) {
    return *pointer ? std::string() : "null";
  }
  const auto* p = std::get_if<Params>(&a.value);
  return p && (p->scalar() || at_fault) ? first_of(*p) : std::string();
}

// The first of a list of expressions, which is cut off it.
std::string_view next_expression(std::string_view& list) {
  int depth = 0;
  size_t end = 0;
  for (; end < list.size() && (depth > 0 || list[end] != ','); ++end) {
    depth += list[end] == '(' ? 1 : list[end] == ')' ? -1 : 0;
  }
  const std::string_view expression = list.substr(0, end);
  list.remove_prefix(std::min(end + 2, list.size()));
  return expression;
}

// The parameter that an expression converts: x of from_fixed(x) and of Params(&x, true).
std::string_view converted(std::string_view expression) {
  const size_t open = expression.rfind('(');
  if (open == std::string_view::npos) return expression;
  expression.remove_prefix(open + 1 + (expression[open + 1] == '&' ? 1 : 0));
  return expression.substr(0, expression.find_first_of(",)"));
}

bool has_type(std::string_view parameters, std::string_view type, std::string_view name) {
  const std::string declared = std::string(type) + " " + std::string(name);
  const size_t at = parameters.find(declared);
  return at != std::string_view::npos && at + declared.size() < parameters.size() &&
         (parameters[at + declared.size()] == ',' || parameters[at + declared.size()] == ')');
}

std::vector<NamedArgument> with_names(const CallText& call, const std::vector<Argument>& values) {
  std::vector<NamedArgument> named;
  std::string_view list = call.arguments;
  list.remove_prefix(1);
  list.remove_suffix(1);
  for (const Argument& value : values) {
    const std::string_view name = converted(next_expression(list));
    // TexImage2D's is an enumerant of the type GLint.
    const bool is_enum = has_type(call.parameters, "GLenum", name) || name == "internalformat";
    named.push_back({name, is_enum, has_type(call.parameters, "GLbitfield", name), value});
  }
  return named;
}

std::string argument_list(const std::vector<NamedArgument>& arguments) {
  std::string text;
  std::string_view last;
  for (const NamedArgument& a : arguments) {
    // Neither what is no parameter of the call nor the same one again.
    if (a.name == "true" || a.name == "false" || a.name == last) continue;
    if (!last.empty()) text += ", ";
    last = a.name;
    text.append(a.name);
    if (const std::string value = value_text(a, false); !value.empty()) text += " = " + value;
  }
  return text;
}

std::string rule_text(const Invalid& wrong, const std::vector<NamedArgument>& arguments) {
  std::string text;
  for (const char* c = wrong.rule; *c; ++c) {
    const size_t position = static_cast<size_t>(wrong.first + c[1] - '0');
    if (*c != '{' || position >= arguments.size()) {
      text += *c;
      continue;
    }
    const NamedArgument& a = arguments[position];
    text.append(a.name);
    if (const std::string value = value_text(a, true); !value.empty()) text += " " + value;
    c += 2;
  }
  return text;
}

}  // namespace

const char* enumerant_name(unsigned long long value) {
  struct Named {
    unsigned value;
    const char* name;
  };
  static constexpr Named kNames[] = {
#define ENUM(value, name) {value, #name},
#include "api/enum_names.def"
#undef ENUM
  };
  const Named* found =
      std::lower_bound(std::begin(kNames), std::end(kNames), value,
                       [](const Named& named, unsigned long long v) { return named.value < v; });
  return found != std::end(kNames) && found->value == value ? found->name : nullptr;
}

std::string error_text(const CallText& call, const std::vector<Argument>& arguments,
                       const Invalid& wrong) {
  const std::vector<NamedArgument> named = with_names(call, arguments);
  return std::string(error_name(wrong.error)) + " in " + call.name + "(" + argument_list(named) +
         "): " + rule_text(wrong, named);
}

}  // namespace clearpipe::api
