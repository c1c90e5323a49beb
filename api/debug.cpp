// See debug.h.
// SPDX-License-Identifier: MIT
#include "api/debug.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <utility>

#include "api/context_state.h"
#include "api/error_text.h"

namespace clearpipe::api {

namespace {

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

struct SlowText {
  GLenum severity;
  const char* text;
};
constexpr SlowText kSlowTexts[] = {
    {GL_DEBUG_SEVERITY_MEDIUM_KHR,
     "what was recorded so far is drawn now, and the call waits for it"},
    {GL_DEBUG_SEVERITY_MEDIUM_KHR,
     "draws that are not executed yet read what is changed: all of it is copied first"},
    {GL_DEBUG_SEVERITY_MEDIUM_KHR,
     "draws that are not executed yet read what is changed: they are executed first, and the call "
     "waits for them"},
    {GL_DEBUG_SEVERITY_MEDIUM_KHR,
     "a texture is sampled by the draw that draws to it: what was recorded so far is drawn now, "
     "and "
     "the texture is copied"},
    {GL_DEBUG_SEVERITY_LOW_KHR,
     "what was recorded for the former framebuffer is drawn now, and the call waits for it"},
    {GL_DEBUG_SEVERITY_LOW_KHR,
     "vertices in client memory are copied at each draw; those in buffer objects are not"},
};
static_assert(std::size(kSlowTexts) == static_cast<size_t>(Slow::kCount));

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

bool debug_to_stderr() noexcept {
  static const bool on = [] {
    const char* value = std::getenv("CLEARPIPE_DEBUG");
    return value && std::strcmp(value, "0") != 0 && *value != '\0';
  }();
  return on;
}

bool wants_messages(const Context& c) { return c.debug.output || debug_to_stderr(); }

void add_performance_messages(Context& c, const char* call) {
  for (GLuint i = 0; i < std::size(kSlowTexts); ++i) {
    const uint32_t bit = 1u << i;
    if (!(c.debug.slow & bit)) continue;
    std::string text = std::string(call) + ": " + kSlowTexts[i].text;
    if (debug_to_stderr() && !(c.debug.slow_told & bit)) {
      c.debug.slow_told |= bit;
      std::fprintf(stderr, "clearpipe: %s (said once)\n", text.c_str());
    }
    add_message(c, {GL_DEBUG_SOURCE_API_KHR, GL_DEBUG_TYPE_PERFORMANCE_KHR, i,
                    kSlowTexts[i].severity, std::move(text)});
  }
}

void add_error_message(Context& c, const CallText& call, const std::vector<Argument>& arguments) {
  std::string text = error_text(call, arguments, c.raised);
  if (debug_to_stderr()) std::fprintf(stderr, "clearpipe: %s\n", text.c_str());
  add_message(c, {GL_DEBUG_SOURCE_API_KHR, GL_DEBUG_TYPE_ERROR_KHR, c.raised.error,
                  GL_DEBUG_SEVERITY_HIGH_KHR, std::move(text)});
}

std::string* find_label(Context& c, GLenum identifier, GLuint name) {
  const auto label = [](const auto& object) { return object ? &object->label : nullptr; };
  switch (identifier) {
    case GL_BUFFER_KHR:
    case GL_BUFFER_OBJECT_EXT:
      return label(c.share->buffers.find(name));
    case GL_TEXTURE:
      return label(c.share->textures.find(name));
    case GL_RENDERBUFFER_OES:
      return label(c.share->renderbuffers.find(name));
    case GL_FRAMEBUFFER_OES:
      return label(c.share->framebuffers.find(name));
    case GL_VERTEX_ARRAY_KHR:
    case GL_VERTEX_ARRAY_OBJECT_EXT:
      return label(c.vertex_arrays.find(name));
    case GL_SYNC_OBJECT_APPLE:
      return label(c.share->syncs.find(name));
    default:
      return nullptr;  // kinds of objects that OpenGL ES 1.1 does not have
  }
}

}  // namespace clearpipe::api
