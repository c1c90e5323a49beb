// Validators of debug output (KHR_debug).
// SPDX-License-Identifier: MIT
#include <cstring>

#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {

bool is_source(GLenum source) {  // table 5.3
  return source >= GL_DEBUG_SOURCE_API_KHR && source <= GL_DEBUG_SOURCE_OTHER_KHR;
}
bool is_applications(GLenum source) {
  return source == GL_DEBUG_SOURCE_APPLICATION_KHR || source == GL_DEBUG_SOURCE_THIRD_PARTY_KHR;
}
bool is_inserted_type(GLenum type) {
  return (type >= GL_DEBUG_TYPE_ERROR_KHR && type <= GL_DEBUG_TYPE_OTHER_KHR) ||
         type == GL_DEBUG_TYPE_MARKER_KHR;
}
bool is_type(GLenum type) {  // table 5.4
  return is_inserted_type(type) || type == GL_DEBUG_TYPE_PUSH_GROUP_KHR ||
         type == GL_DEBUG_TYPE_POP_GROUP_KHR;
}
bool is_severity(GLenum severity) {  // table 5.5
  return (severity >= GL_DEBUG_SEVERITY_HIGH_KHR && severity <= GL_DEBUG_SEVERITY_LOW_KHR) ||
         severity == GL_DEBUG_SEVERITY_NOTIFICATION_KHR;
}

bool is_shorter(GLsizei length, const char* text, size_t limit) {
  const size_t characters = length >= 0 ? static_cast<size_t>(length)
                            : text      ? std::strlen(text)
                                        : 0;
  return characters < limit;
}

// Table 5.1, and that there is an object of the name.
GLenum labelled(const Context& c, GLenum identifier, GLuint name) {
  const bool known = (identifier >= GL_BUFFER_KHR && identifier <= GL_PROGRAM_PIPELINE_KHR) ||
                     identifier == GL_SAMPLER_KHR || identifier == GL_VERTEX_ARRAY_KHR ||
                     identifier == GL_TEXTURE || identifier == GL_RENDERBUFFER_OES ||
                     identifier == GL_FRAMEBUFFER_OES;
  if (!known) return GL_INVALID_ENUM;
  return find_label(const_cast<Context&>(c), identifier, name) ? GL_NO_ERROR : GL_INVALID_VALUE;
}

}  // namespace

GLenum debug_message_control(const Context&, GLenum source, GLenum type, GLenum severity,
                             GLsizei count, const GLuint*, GLboolean) {
  if ((source != GL_DONT_CARE && !is_source(source)) || (type != GL_DONT_CARE && !is_type(type)) ||
      (severity != GL_DONT_CARE && !is_severity(severity))) {
    return GL_INVALID_ENUM;
  }
  if (count < 0) return GL_INVALID_VALUE;
  const bool one_kind = source != GL_DONT_CARE && type != GL_DONT_CARE && severity == GL_DONT_CARE;
  return count == 0 || one_kind ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

GLenum debug_message_insert(const Context& c, GLenum source, GLenum type, GLuint, GLenum severity,
                            GLsizei length, const char* text) {
  if (!c.debug.output) return GL_NO_ERROR;  // discarded, whatever it is
  if (!is_applications(source) || !is_inserted_type(type) || !is_severity(severity)) {
    return GL_INVALID_ENUM;
  }
  return is_shorter(length, text, kMaxDebugMessageLength) ? GL_NO_ERROR : GL_INVALID_VALUE;
}

GLenum get_debug_message_log(const Context&, GLuint, GLsizei size, const GLenum*, const GLenum*,
                             const GLuint*, const GLenum*, const GLsizei*, const char* text) {
  return size < 0 && text ? GL_INVALID_VALUE : GL_NO_ERROR;
}

GLenum push_debug_group(const Context& c, GLenum source, GLuint, GLsizei length, const char* text) {
  if (!is_applications(source)) return GL_INVALID_ENUM;
  if (!is_shorter(length, text, kMaxDebugMessageLength)) return GL_INVALID_VALUE;
  return c.debug.groups.size() < kMaxDebugGroups ? GL_NO_ERROR : GL_STACK_OVERFLOW;
}

GLenum pop_debug_group(const Context& c) {
  return c.debug.groups.size() > 1 ? GL_NO_ERROR : GL_STACK_UNDERFLOW;
}

GLenum object_label(const Context& c, GLenum identifier, GLuint name, GLsizei length,
                    const char* label) {
  if (const GLenum error = labelled(c, identifier, name)) return error;
  return !label || is_shorter(length, label, kMaxLabelLength) ? GL_NO_ERROR : GL_INVALID_VALUE;
}

GLenum get_object_label(const Context& c, GLenum identifier, GLuint name, GLsizei size,
                        const GLsizei*, const char*) {
  if (const GLenum error = labelled(c, identifier, name)) return error;
  return size < 0 ? GL_INVALID_VALUE : GL_NO_ERROR;
}

}  // namespace clearpipe::api::validate
