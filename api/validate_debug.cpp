// Validators of debug output (KHR_debug, chapter 5.5).
// SPDX-License-Identifier: MIT
#include <cstring>

#include "api/sync_objects.h"
#include "api/validate.h"

namespace clearpipe::api::validate {

namespace {

// The only objects that pointers name.
constexpr const char* kNoSync = "{0} is no sync object (KHR_debug, 5.5.8)";

bool is_source(GLenum source) {
  return source >= GL_DEBUG_SOURCE_API_KHR && source <= GL_DEBUG_SOURCE_OTHER_KHR;
}
Invalid applications_source(GLenum source) {
  return enum_unless(
      source == GL_DEBUG_SOURCE_APPLICATION_KHR || source == GL_DEBUG_SOURCE_THIRD_PARTY_KHR,
      "{0} is no source of an application's messages (KHR_debug, 5.5.5)");
}
bool is_inserted_type(GLenum type) {
  return (type >= GL_DEBUG_TYPE_ERROR_KHR && type <= GL_DEBUG_TYPE_OTHER_KHR) ||
         type == GL_DEBUG_TYPE_MARKER_KHR;
}
bool is_type(GLenum type) {
  return is_inserted_type(type) || type == GL_DEBUG_TYPE_PUSH_GROUP_KHR ||
         type == GL_DEBUG_TYPE_POP_GROUP_KHR;
}
Invalid severity_of(GLenum severity) {
  return enum_unless(
      (severity >= GL_DEBUG_SEVERITY_HIGH_KHR && severity <= GL_DEBUG_SEVERITY_LOW_KHR) ||
          severity == GL_DEBUG_SEVERITY_NOTIFICATION_KHR,
      "{0} is no severity (KHR_debug, table 5.5)");
}

bool is_shorter(GLsizei length, const char* text, size_t limit) {
  const size_t characters = length >= 0 ? static_cast<size_t>(length)
                            : text      ? std::strlen(text)
                                        : 0;
  return characters < limit;
}
// `text` follows its length.
Invalid message(GLsizei length, const char* text) {
  return value_unless(is_shorter(length, text, kMaxDebugMessageLength),
                      "{1} is not shorter than MAX_DEBUG_MESSAGE_LENGTH (KHR_debug, 5.5.5)");
}

// Table 5.1, and that there is an object of the name.
Invalid labelled(const Context& c, GLenum identifier, GLuint name) {
  const bool known = (identifier >= GL_BUFFER_KHR && identifier <= GL_PROGRAM_PIPELINE_KHR) ||
                     identifier == GL_SAMPLER_KHR || identifier == GL_VERTEX_ARRAY_KHR ||
                     identifier == GL_TEXTURE || identifier == GL_RENDERBUFFER_OES ||
                     identifier == GL_FRAMEBUFFER_OES;
  if (!known) return {GL_INVALID_ENUM, "{0} is no kind of object (KHR_debug, table 5.1)"};
  return value_unless(find_label(const_cast<Context&>(c), identifier, name) != nullptr,
                      "there is no object {1} of the kind {0} (KHR_debug, 5.5.8)");
}

}  // namespace

Invalid debug_message_control(const Context&, GLenum source, GLenum type, GLenum severity,
                              GLsizei count, const GLuint*, GLboolean) {
  if (source != GL_DONT_CARE && !is_source(source)) {
    return {GL_INVALID_ENUM, "{0} is no source of messages (KHR_debug, table 5.3)"};
  }
  if (type != GL_DONT_CARE && !is_type(type)) {
    return {GL_INVALID_ENUM, "{1} is no type of messages (KHR_debug, table 5.4)"};
  }
  if (severity != GL_DONT_CARE) {
    if (const Invalid wrong = severity_of(severity)) return wrong.from(2);
  }
  if (count < 0) return {GL_INVALID_VALUE, "{3} is negative (KHR_debug, 5.5.4)"};
  const bool one_kind = source != GL_DONT_CARE && type != GL_DONT_CARE && severity == GL_DONT_CARE;
  return operation_unless(count == 0 || one_kind,
                          "with identifiers, {0} and {1} must be given and {2} be DONT_CARE "
                          "(KHR_debug, 5.5.4)");
}

Invalid debug_message_insert(const Context& c, GLenum source, GLenum type, GLuint, GLenum severity,
                             GLsizei length, const char* text) {
  if (!c.debug.output) return {};  // discarded, whatever it is
  if (const Invalid wrong = applications_source(source)) return wrong;
  if (!is_inserted_type(type)) {
    return {GL_INVALID_ENUM, "{1} is no type of an application's messages (KHR_debug, 5.5.5)"};
  }
  if (const Invalid wrong = severity_of(severity)) return wrong.from(3);
  return message(length, text).from(4);
}

Invalid get_debug_message_log(const Context&, GLuint, GLsizei size, const GLenum*, const GLenum*,
                              const GLuint*, const GLenum*, const GLsizei*, const char* text) {
  return value_unless(size >= 0 || !text, "{1} is negative (KHR_debug, 6.1.15)");
}

Invalid push_debug_group(const Context& c, GLenum source, GLuint, GLsizei length,
                         const char* text) {
  if (const Invalid wrong = applications_source(source)) return wrong;
  if (const Invalid wrong = message(length, text)) return wrong.from(2);
  if (c.debug.groups.size() < kMaxDebugGroups) return {};
  return {GL_STACK_OVERFLOW, "there are MAX_DEBUG_GROUP_STACK_DEPTH groups (KHR_debug, 5.5.6)"};
}

Invalid pop_debug_group(const Context& c) {
  if (c.debug.groups.size() > 1) return {};
  return {GL_STACK_UNDERFLOW, "only the default debug group is left (KHR_debug, 5.5.6)"};
}

Invalid object_label(const Context& c, GLenum identifier, GLuint name, GLsizei length,
                     const char* label) {
  if (const Invalid wrong = labelled(c, identifier, name)) return wrong;
  return value_unless(!label || is_shorter(length, label, kMaxLabelLength),
                      "{3} is not shorter than MAX_LABEL_LENGTH (KHR_debug, 5.5.8)");
}

Invalid object_ptr_label(const Context& c, const void* sync, GLsizei length, const char* label) {
  if (!find_sync(*c.share, sync)) return {GL_INVALID_VALUE, kNoSync};
  return value_unless(!label || is_shorter(length, label, kMaxLabelLength),
                      "{2} is not shorter than MAX_LABEL_LENGTH (KHR_debug, 5.5.8)");
}

Invalid get_object_ptr_label(const Context& c, const void* sync, GLsizei size, const GLsizei*,
                             const char*) {
  if (!find_sync(*c.share, sync)) return {GL_INVALID_VALUE, kNoSync};
  return value_unless(size >= 0, "{1} is negative (KHR_debug, 6.1.16)");
}

// EXT_debug_label: its types, of which OpenGL ES 1.1 has six, and that there is such an object.
namespace {
Invalid labelled_ext(const Context& c, GLenum type, GLuint name) {
  const bool known = type == GL_TEXTURE || type == GL_FRAMEBUFFER_OES ||
                     type == GL_RENDERBUFFER_OES || type == GL_BUFFER_OBJECT_EXT ||
                     type == GL_VERTEX_ARRAY_OBJECT_EXT || type == GL_SYNC_OBJECT_APPLE;
  if (!known) return {GL_INVALID_ENUM, "{0} is no type of objects (EXT_debug_label)"};
  return operation_unless(find_label(const_cast<Context&>(c), type, name) != nullptr,
                          "{1} is no object of the type {0} (EXT_debug_label)");
}
}  // namespace

Invalid label_object(const Context& c, GLenum type, GLuint name, GLsizei length, const char*) {
  if (const Invalid wrong = labelled_ext(c, type, name)) return wrong;
  return value_unless(length >= 0, "{2} is negative (EXT_debug_label)");
}

Invalid get_label_ext(const Context& c, GLenum type, GLuint name, GLsizei size, const GLsizei*,
                      const char*) {
  if (const Invalid wrong = labelled_ext(c, type, name)) return wrong;
  return value_unless(size >= 0, "{2} is negative (EXT_debug_label)");
}

Invalid get_object_label(const Context& c, GLenum identifier, GLuint name, GLsizei size,
                         const GLsizei*, const char*) {
  if (const Invalid wrong = labelled(c, identifier, name)) return wrong;
  return value_unless(size >= 0, "{2} is negative (KHR_debug, 6.1.16)");
}

}  // namespace clearpipe::api::validate
