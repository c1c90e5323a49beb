// See debug.h.
// SPDX-License-Identifier: MIT
#include "api/debug.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "api/context_state.h"

namespace clearpipe::api {

namespace {

// CLEARPIPE_DEBUG=1: errors go to stderr as well.
bool to_stderr() {
  static const bool on = [] {
    const char* value = std::getenv("CLEARPIPE_DEBUG");
    return value && std::strcmp(value, "0") != 0 && *value != '\0';
  }();
  return on;
}

// Notifications and the like are wanted at first; messages of low severity are not (table 5.5).
bool is_wanted(const DebugGroup& group, const DebugMessage& m) {
  bool wanted = m.severity != GL_DEBUG_SEVERITY_LOW_KHR;
  const auto refers = [](GLenum rule, GLenum value) {
    return rule == GL_DONT_CARE || rule == value;
  };
  for (const DebugRule& rule : group.rules) {
    const bool id =
        rule.ids.empty() || std::find(rule.ids.begin(), rule.ids.end(), m.id) != rule.ids.end();
    if (id && refers(rule.source, m.source) && refers(rule.type, m.type) &&
        refers(rule.severity, m.severity)) {
      wanted = rule.enabled;
    }
  }
  return wanted;
}

struct ErrorText {
  const char *name, *meaning;
};
ErrorText error_text(GLenum error) {  // table 2.3
  switch (error) {
    case GL_INVALID_ENUM:
      return {"GL_INVALID_ENUM", "an enumerant is none that the call accepts"};
    case GL_INVALID_VALUE:
      return {"GL_INVALID_VALUE", "a number is out of range"};
    case GL_INVALID_OPERATION:
      return {"GL_INVALID_OPERATION", "not allowed in the current state"};
    case GL_STACK_OVERFLOW:
      return {"GL_STACK_OVERFLOW", "the stack is full"};
    case GL_STACK_UNDERFLOW:
      return {"GL_STACK_UNDERFLOW", "the stack has nothing to pop"};
    case GL_INVALID_FRAMEBUFFER_OPERATION_OES:
      return {"GL_INVALID_FRAMEBUFFER_OPERATION_OES", "the framebuffer is not complete"};
    default:
      return {"GL_OUT_OF_MEMORY", "memory does not suffice"};
  }
}

// The first of a list of names and expressions, which is cut off it.
std::string_view next_name(std::string_view& names) {
  int depth = 0;
  size_t end = 0;
  for (; end < names.size() && (depth > 0 || names[end] != ','); ++end) {
    depth += names[end] == '(' ? 1 : names[end] == ')' ? -1 : 0;
  }
  const std::string_view name = names.substr(0, end);
  names.remove_prefix(std::min(end + 2, names.size()));
  return name;
}

}  // namespace

void add_message(Context& c, DebugMessage message) {
  if (!c.debug.output || c.debug.delivering || !is_wanted(c.debug.groups.back(), message)) return;
  c.debug.waiting.push_back(std::move(message));
}

void deliver_messages(Context& c) noexcept try {
  if (c.debug.delivering) return;
  c.debug.delivering = true;
  for (DebugMessage& m : std::exchange(c.debug.waiting, {})) {
    if (c.debug.callback) {
      c.debug.callback(m.source, m.type, m.id, m.severity, static_cast<GLsizei>(m.text.size()),
                       m.text.c_str(), c.debug.user_param);
    } else if (c.debug.log.size() < kMaxDebugLoggedMessages) {
      c.debug.log.push_back(std::move(m));
    }
  }
  c.debug.delivering = false;
} catch (...) {
  c.debug.delivering = false;  // a message that finds no memory is lost
}

bool wants_errors(const Context& c) { return c.debug.output || to_stderr(); }

void add_error_message(Context& c, const char* call, std::string_view names,
                       const std::vector<std::string>& values, GLenum error) {
  const ErrorText& what = error_text(error);
  names.remove_prefix(1);  // the list stands in parentheses
  names.remove_suffix(1);
  std::string text = std::string(what.name) + " in " + call + "(";
  for (size_t i = 0; i < values.size(); ++i) {
    const std::string_view name = next_name(names);
    if (i != 0) text += ", ";
    text.append(name);
    if (values[i] != "...") text += " = " + values[i];
  }
  text += std::string("): ") + what.meaning;
  if (to_stderr()) std::fprintf(stderr, "clearpipe: %s\n", text.c_str());
  add_message(c, {GL_DEBUG_SOURCE_API_KHR, GL_DEBUG_TYPE_ERROR_KHR, error,
                  GL_DEBUG_SEVERITY_HIGH_KHR, std::move(text)});
}

std::string signed_text(long long value) { return std::to_string(value); }

std::string unsigned_text(unsigned long long value) {
  if (value < 0x100) return std::to_string(value);
  char text[24];
  std::snprintf(text, sizeof text, "0x%04llX", value);  // an enumerant, most likely
  return text;
}

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string pointer_text(const void* value) {
  if (!value) return "null";
  char text[32];
  std::snprintf(text, sizeof text, "%p", value);
  return text;
}

std::string* find_label(Context& c, GLenum identifier, GLuint name) {
  const auto label = [](const auto& object) { return object ? &object->label : nullptr; };
  switch (identifier) {
    case GL_BUFFER_KHR:
      return label(c.share->buffers.find(name));
    case GL_TEXTURE:
      return label(c.share->textures.find(name));
    case GL_RENDERBUFFER_OES:
      return label(c.share->renderbuffers.find(name));
    case GL_FRAMEBUFFER_OES:
      return label(c.share->framebuffers.find(name));
    case GL_VERTEX_ARRAY_KHR:
      return label(c.vertex_arrays.find(name));
    default:
      return nullptr;  // kinds of objects that OpenGL ES 1.1 does not have
  }
}

}  // namespace clearpipe::api
