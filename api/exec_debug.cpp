// Debug output (KHR_debug), labels (EXT_debug_label), and markers (EXT_debug_marker), which are
// messages of the application.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>

#include "api/exec.h"
#include "api/sync_objects.h"

namespace clearpipe::api::exec {

namespace {

// A negative length: up to the null.
std::string text_of(GLsizei length, const char* text) {
  if (!text) return {};
  return length < 0 ? std::string(text) : std::string(text, static_cast<size_t>(length));
}

// Of a marker, and of EXT_debug_label, a length of zero means that too.
std::string marker_text(GLsizei length, const char* marker) {
  return text_of(length <= 0 ? -1 : length, marker);
}

}  // namespace

void debug_message_control(Context& c, GLenum source, GLenum type, GLenum severity, GLsizei count,
                           const GLuint* ids, GLboolean enabled) {
  DebugRule rule{source, type, severity, {ids, ids + (ids ? count : 0)}, enabled != 0};
  std::vector<DebugRule>& rules = c.debug.groups.back().rules;
  // What refers to the same messages has no say any more.
  const bool all = source == GL_DONT_CARE && type == GL_DONT_CARE && severity == GL_DONT_CARE;
  rules.erase(std::remove_if(rules.begin(), rules.end(),
                             [&](const DebugRule& old) {
                               return all || (old.source == source && old.type == type &&
                                              old.severity == severity && old.ids == rule.ids);
                             }),
              rules.end());
  rules.push_back(std::move(rule));
}

void debug_message_insert(Context& c, GLenum source, GLenum type, GLuint id, GLenum severity,
                          GLsizei length, const char* text) {
  if (c.debug.output) add_message(c, {source, type, id, severity, text_of(length, text)});
}

void debug_message_callback(Context& c, DebugCallback callback, const void* user_param) {
  c.debug.callback = callback;
  c.debug.user_param = user_param;
}

GLuint get_debug_message_log(Context& c, GLuint count, GLsizei size, GLenum* sources, GLenum* types,
                             GLuint* ids, GLenum* severities, GLsizei* lengths, char* text) {
  size_t room = static_cast<size_t>(std::max(size, 0));
  GLuint fetched = 0;
  for (; fetched < count && !c.debug.log.empty(); ++fetched) {
    const DebugMessage& m = c.debug.log.front();
    const size_t bytes = m.text.size() + 1;
    if (text) {
      if (bytes > room) break;
      std::memcpy(text, m.text.c_str(), bytes);
      text += bytes;
      room -= bytes;
    }
    if (sources) sources[fetched] = m.source;
    if (types) types[fetched] = m.type;
    if (ids) ids[fetched] = m.id;
    if (severities) severities[fetched] = m.severity;
    if (lengths) lengths[fetched] = static_cast<GLsizei>(bytes);
    c.debug.log.pop_front();
  }
  return fetched;
}

void push_debug_group(Context& c, GLenum source, GLuint id, GLsizei length, const char* text) {
  DebugGroup group{source, id, text_of(length, text), c.debug.groups.back().rules};
  add_message(c, {source, GL_DEBUG_TYPE_PUSH_GROUP_KHR, id, GL_DEBUG_SEVERITY_NOTIFICATION_KHR,
                  group.text});
  c.debug.groups.push_back(std::move(group));
}

void pop_debug_group(Context& c) {
  const DebugGroup group = std::move(c.debug.groups.back());
  c.debug.groups.pop_back();
  add_message(c, {group.source, GL_DEBUG_TYPE_POP_GROUP_KHR, group.id,
                  GL_DEBUG_SEVERITY_NOTIFICATION_KHR, group.text});
}

namespace {
// As much of a label as `size` characters hold with the zero at its end; its length without it.
void put_text(const std::string& text, GLsizei size, GLsizei* length, char* label) {
  size_t characters = text.size();
  if (label) {
    characters = size == 0 ? 0 : std::min(characters, static_cast<size_t>(size) - 1);
    if (size > 0) {
      std::memcpy(label, text.data(), characters);
      label[characters] = '\0';
    }
  }
  if (length) *length = static_cast<GLsizei>(characters);
}
}  // namespace

void object_label(Context& c, GLenum identifier, GLuint name, GLsizei length, const char* label) {
  *find_label(c, identifier, name) = text_of(length, label);
}

void get_object_label(Context& c, GLenum identifier, GLuint name, GLsizei size, GLsizei* length,
                      char* label) {
  put_text(*find_label(c, identifier, name), size, length, label);
}

void object_ptr_label(Context& c, const void* sync, GLsizei length, const char* label) {
  find_sync(*c.share, sync)->label = text_of(length, label);
}

void get_object_ptr_label(Context& c, const void* sync, GLsizei size, GLsizei* length,
                          char* label) {
  put_text(find_sync(*c.share, sync)->label, size, length, label);
}

void label_object(Context& c, GLenum type, GLuint name, GLsizei length, const char* label) {
  *find_label(c, type, name) = marker_text(length, label);
}

// Markers and their groups show in debug output as those of KHR_debug do; their stack is their own.
void insert_event_marker(Context& c, GLsizei length, const char* marker) {
  add_message(c, {GL_DEBUG_SOURCE_APPLICATION_KHR, GL_DEBUG_TYPE_MARKER_KHR, 0,
                  GL_DEBUG_SEVERITY_NOTIFICATION_KHR, marker_text(length, marker)});
}

void push_group_marker(Context& c, GLsizei length, const char* marker) {
  std::string text = marker_text(length, marker);
  add_message(c, {GL_DEBUG_SOURCE_APPLICATION_KHR, GL_DEBUG_TYPE_PUSH_GROUP_KHR, 0,
                  GL_DEBUG_SEVERITY_NOTIFICATION_KHR, text});
  c.debug.markers.push_back(std::move(text));
}

void pop_group_marker(Context& c) {
  if (c.debug.markers.empty()) return;
  add_message(c, {GL_DEBUG_SOURCE_APPLICATION_KHR, GL_DEBUG_TYPE_POP_GROUP_KHR, 0,
                  GL_DEBUG_SEVERITY_NOTIFICATION_KHR, std::move(c.debug.markers.back())});
  c.debug.markers.pop_back();
}

}  // namespace clearpipe::api::exec
