// Debug output (KHR_debug, chapter 5.5): messages, whom they go to, and which are wanted.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "api/khr_debug.h"
#include "api/params.h"

namespace clearpipe::api {

struct Context;

using DebugCallback = void(GL_APIENTRY*)(GLenum source, GLenum type, GLuint id, GLenum severity,
                                         GLsizei length, const char* message, const void* user);

struct DebugMessage {
  GLenum source = 0, type = 0;
  GLuint id = 0;
  GLenum severity = 0;
  std::string text;
};

// One DebugMessageControl: what it refers to (DONT_CARE: all), and whether that is wanted. The
// last that refers to a message decides.
struct DebugRule {
  GLenum source = GL_DONT_CARE, type = GL_DONT_CARE, severity = GL_DONT_CARE;
  std::vector<GLuint> ids;  // none: all
  bool enabled = true;
};

// A debug group inherits the rules of the one below it.
struct DebugGroup {
  GLenum source = 0;
  GLuint id = 0;
  std::string text;
  std::vector<DebugRule> rules;
};

// What makes a call slow that is not wrong, each the identifier of its performance message.
enum class Slow : GLuint {
  kWaits,          // the frame is drawn, and the call waits for it
  kCopies,         // data that an unfinished frame reads is copied before it is changed
  kFinishes,       // the frame is drawn because it reads data that is to be changed
  kSamplesTarget,  // a draw samples the image it draws to
  kChangesTarget,  // the frame is drawn because the next one goes to other images
  kClientArrays,   // vertices in client memory are copied
  kCount
};

struct DebugState {
  bool output = false;
  bool synchronous = false;  // messages always come before the call returns, on its thread
  DebugCallback callback = nullptr;
  const void* user_param = nullptr;
  std::deque<DebugMessage> log;
  std::vector<DebugGroup> groups = std::vector<DebugGroup>(1);  // the first is the default group
  std::vector<std::string> markers;                             // the groups of EXT_debug_marker
  bool delivering = false;            // what a callback causes by calls of its own is not reported
  std::vector<DebugMessage> waiting;  // made under the lock of the share group, not yet delivered
  uint32_t slow = 0;                  // by the call that is running, a bit each
  uint32_t slow_told = 0;             // on stderr, once each
};

// The object's label, or null: there is none of that name. Identifiers are those of KHR_debug and
// of EXT_debug_label.
std::string* find_label(Context& context, GLenum identifier, GLuint name);

// Takes a message to be delivered at the end of the call, if it is wanted.
void add_message(Context& context, DebugMessage message);

// Delivers what waits: to the callback, else to the log. Without the lock of the share group, since
// applications do what they like in a callback.
void deliver_messages(Context& context) noexcept;

// An argument of a call; nothing for what has no text.
using Argument =
    std::variant<std::monostate, long long, unsigned long long, double, const void*, Params>;
template <typename T>
Argument make_argument(const T& value) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<double>(value);
  } else if constexpr (std::is_integral_v<T> && std::is_signed_v<T>) {
    return static_cast<long long>(value);
  } else if constexpr (std::is_integral_v<T>) {
    return static_cast<unsigned long long>(value);
  } else if constexpr (std::is_convertible_v<T, const void*>) {
    return static_cast<const void*>(value);
  } else if constexpr (std::is_same_v<T, Params>) {
    return value;
  } else {
    return std::monostate();
  }
}

// A call as gles1.def writes it: its parameters with their types, and the arguments its validator
// gets, both in parentheses.
struct CallText {
  const char *name, *parameters, *arguments;
};

// Whether anyone listens to messages of the implementation.
bool wants_messages(const Context& context);

// Makes the messages of what made a call slow.
void add_performance_messages(Context& context, const char* call);

// Makes the message of the error that a call has generated, which says what is wrong with what.
void add_error_message(Context& context, const CallText& call,
                       const std::vector<Argument>& arguments);

}  // namespace clearpipe::api
