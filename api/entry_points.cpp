// The C entry points and the lookup of their addresses, expanded from gles1.def and
// gles1_aliases.def.
//
// An entry point finds the current context, asks the validator, and executes. Without a current
// context it does nothing. No exception leaves it.
// SPDX-License-Identifier: MIT
#include <GLES/gl.h>
#include <GLES/glext.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <new>
#include <string_view>

#include "api/exec.h"
#include "api/validate.h"

namespace clearpipe::api {

namespace {

constexpr float unorm(GLubyte value) { return static_cast<float>(value) / 255.0f; }

// The groups of gles1.def, and whether their calls look into shared objects (objects.h).
struct Group {
  std::string_view name;
  bool locks;
};
constexpr Group kGroups[] = {
    {"texture", true},     {"buffer", true},    {"draw", true},    {"array", false},
    {"current", false},    {"fragment", false}, {"frame", false},  {"light", false},
    {"matrix", false},     {"query", false},    {"raster", false}, {"state", false},
    {"framebuffer", true}, {"label", true},     {"debug", false},  {"sync", true},
};
consteval bool locks(std::string_view group) {
  for (const Group& g : kGroups) {
    if (g.name == group) return g.locks;
  }
  throw "a group that is not in the list";
}

template <typename Type>
Type nothing() {
  return Type();
}

// At the end of a call, after the lock is gone: the messages of its error and of what made it slow,
// and all others.
template <typename Report>
class AtEnd {
 public:
  AtEnd(Context& context, const Report& report) : context_(context), report_(report) {
    context_.raised = {};
    context_.debug.slow = 0;
  }
  ~AtEnd() {
    if ((context_.raised || context_.debug.slow) && wants_messages(context_)) try {
        report_(context_);
      } catch (...) {
        // A message that finds no memory is lost.
      }
    if (!context_.debug.waiting.empty()) deliver_messages(context_);
  }
  AtEnd(const AtEnd&) = delete;
  AtEnd& operator=(const AtEnd&) = delete;

 private:
  Context& context_;
  const Report& report_;
};

template <typename... Arguments>
void report_call(Context& context, const CallText& call, const Arguments&... arguments) {
  if (context.raised) add_error_message(context, call, {make_argument(arguments)...});
  if (context.debug.slow) add_performance_messages(context, call.name);
}

template <typename Return, bool kLocks, typename Body, typename Report>
Return enter(const Body& body, const Report& report) noexcept {
  Context* context = current_context();
  if (!context) return Return();
  const AtEnd at_end(*context, report);
  try {
    if constexpr (kLocks) {
      const std::lock_guard<std::mutex> lock(context->share->mutex);
      return body(*context);
    } else {
      return body(*context);
    }
  } catch (...) {
    context->set_error(kOutOfMemory);
    return Return();
  }
}

}  // namespace

#define AFTER_CONTEXT(...) __VA_OPT__(, ) __VA_ARGS__
#define CALL(type, name, parameters, arguments, validator, executor, group, stages)        \
  extern "C" __attribute__((visibility("default"))) type GL_APIENTRY gl##name parameters { \
    const auto report = [&](Context& context) {                                            \
      report_call(context, {"gl" #name, #parameters, #arguments} AFTER_CONTEXT arguments); \
    };                                                                                     \
    const auto body = [&](Context& context) -> type {                                      \
      if (const Invalid wrong = validate::validator(context AFTER_CONTEXT arguments)) {    \
        context.set_error(wrong);                                                          \
        return nothing<type>();                                                            \
      }                                                                                    \
      return exec::executor(context AFTER_CONTEXT arguments);                              \
    };                                                                                     \
    return enter<type, locks(#group)>(body, report);                                       \
  }
#include "api/gles1.def"
#undef CALL

#define ALIAS(name, command) \
  extern "C"                 \
      __attribute__((visibility("default"), alias("gl" #command))) decltype(gl##command) gl##name;
#include "api/gles1_aliases.def"
#undef ALIAS

namespace {

constexpr const char* kNames[] = {
#define CALL(type, name, parameters, arguments, validator, executor, group, stages) "gl" #name,
#include "api/gles1.def"
#undef CALL
#define ALIAS(name, command) "gl" #name,
#include "api/gles1_aliases.def"
#undef ALIAS
};

const Proc kProcs[] = {
#define CALL(type, name, parameters, arguments, validator, executor, group, stages) \
  reinterpret_cast<Proc>(gl##name),
#include "api/gles1.def"
#undef CALL
#define ALIAS(name, command) reinterpret_cast<Proc>(gl##command),
#include "api/gles1_aliases.def"
#undef ALIAS
};

// A loader asks for some thousand names when a context is first current, so they are found by a
// table that the compiler makes: the place of a name is the first free one from its hash on.
constexpr size_t kSlots = 1024;
static_assert(2 * std::size(kNames) <= kSlots);

constexpr size_t slot_of(const char* name) {
  uint32_t hash = 2166136261u;
  for (; *name != '\0'; ++name) hash = (hash ^ static_cast<uint8_t>(*name)) * 16777619u;
  return (hash ^ hash >> 16) % kSlots;
}

constexpr auto kTable = [] {
  std::array<uint16_t, kSlots> table{};  // 1 + the number of a name; 0: free
  for (uint16_t i = 0; i < std::size(kNames); ++i) {
    size_t slot = slot_of(kNames[i]);
    while (table[slot] != 0) slot = (slot + 1) % kSlots;
    table[slot] = static_cast<uint16_t>(i + 1);
  }
  return table;
}();

}  // namespace

Proc proc_address(const char* name) noexcept {
  if (!name) return nullptr;
  for (size_t slot = slot_of(name); kTable[slot] != 0; slot = (slot + 1) % kSlots) {
    const size_t number = kTable[slot] - size_t{1};
    if (std::strcmp(kNames[number], name) == 0) return kProcs[number];
  }
  return nullptr;
}

}  // namespace clearpipe::api
