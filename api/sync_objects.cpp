// See sync_objects.h. Validators and executors of APPLE_sync.
//
// A sync object is signaled when the frame it was made in has been executed. Only the context that
// made it can do that; when it asks, it does, with or without the bit that flushes, because nobody
// else would, and a program that polls comes to an end. Other contexts wait for it to flush.
// SPDX-License-Identifier: MIT
#include "api/sync_objects.h"

#include <algorithm>

#include "api/exec.h"
#include "api/validate.h"

namespace clearpipe::api {

namespace {

constexpr const char* kNoSync = "{0} is no sync object (APPLE_sync, 5.2.1)";

GLsync handle_of(GLuint name) { return reinterpret_cast<GLsync>(static_cast<uintptr_t>(name)); }

// For the calls that must not hold the lock when they wait.
SyncPtr find_and_lock(const Context& c, GLsync sync) {
  const std::lock_guard<std::mutex> lock(c.share->mutex);
  return find_sync(*c.share, sync);
}

}  // namespace

SyncPtr find_sync(const ShareGroup& share, const void* sync) {
  const auto value = reinterpret_cast<uintptr_t>(sync);
  const auto name = static_cast<GLuint>(value);
  return name == value ? share.syncs.find(name) : nullptr;
}

namespace validate {

Invalid fence_sync(const Context&, GLenum condition, GLbitfield flags) {
  if (condition != GL_SYNC_GPU_COMMANDS_COMPLETE_APPLE) {
    return {GL_INVALID_ENUM, "{0} is not SYNC_GPU_COMMANDS_COMPLETE_APPLE (APPLE_sync, 5.2)"};
  }
  return value_unless(flags == 0, "{1} is not 0 (APPLE_sync, 5.2)");
}

Invalid delete_sync(const Context& c, GLsync sync) {
  return value_unless(sync == nullptr || find_sync(*c.share, sync) != nullptr,
                      "{0} is neither 0 nor a sync object (APPLE_sync, 5.2)");
}

Invalid client_wait_sync(const Context& c, GLsync sync, GLbitfield flags) {
  if (!find_and_lock(c, sync)) return {GL_INVALID_VALUE, kNoSync};
  return value_unless((flags & ~GLbitfield{GL_SYNC_FLUSH_COMMANDS_BIT_APPLE}) == 0,
                      "{1} has bits other than SYNC_FLUSH_COMMANDS_BIT_APPLE (APPLE_sync, 5.2.1)");
}

Invalid wait_sync(const Context& c, GLsync sync, GLbitfield flags, GLuint64 timeout) {
  if (!find_and_lock(c, sync)) return {GL_INVALID_VALUE, kNoSync};
  if (flags != 0) return {GL_INVALID_VALUE, "{1} is not 0 (APPLE_sync, 5.2.1)"};
  return value_unless(timeout == GL_TIMEOUT_IGNORED_APPLE,
                      "{2} is not TIMEOUT_IGNORED_APPLE (APPLE_sync, 5.2.1)");
}

Invalid get_sync(const Context& c, GLsync sync, GLenum pname, GLsizei count, const GLsizei*,
                 const GLint*) {
  if (!find_sync(*c.share, sync)) return {GL_INVALID_VALUE, kNoSync};
  if (pname < GL_OBJECT_TYPE_APPLE || pname > GL_SYNC_FLAGS_APPLE) {
    return {GL_INVALID_ENUM, "{1} is no property of sync objects (APPLE_sync, 6.1.6)"};
  }
  return value_unless(count >= 0, "{2} is negative (APPLE_sync, 6.1.6)");
}

}  // namespace validate

namespace exec {

GLsync fence_sync(Context& c, GLenum, GLbitfield) {
  const GLuint name = c.share->syncs.generate();
  const SyncPtr sync = c.share->syncs.bind(name);
  sync->clock = c.clock;
  sync->frame = c.clock->now();
  return handle_of(name);
}

GLboolean is_sync(Context& c, GLsync sync) { return find_sync(*c.share, sync) != nullptr; }

// Whoever waits for it holds it.
void delete_sync(Context& c, GLsync sync) {
  c.share->syncs.erase(static_cast<GLuint>(reinterpret_cast<uintptr_t>(sync)));
}

// The one call of them that returns something other than zero when it is refused.
GLenum client_wait_sync(Context& c, GLsync handle, GLbitfield flags, GLuint64 timeout) {
  if (const Invalid wrong = validate::client_wait_sync(c, handle, flags)) {
    c.set_error(wrong);
    return GL_WAIT_FAILED_APPLE;
  }
  const SyncPtr sync = find_and_lock(c, handle);
  if (!sync) return GL_WAIT_FAILED_APPLE;  // deleted meanwhile
  if (sync->signaled()) return GL_ALREADY_SIGNALED_APPLE;
  if (sync->clock == c.clock || flags != 0) c.finish_frame(Slow::kWaits);
  return sync->clock->wait(sync->frame, timeout) ? GL_CONDITION_SATISFIED_APPLE
                                                 : GL_TIMEOUT_EXPIRED_APPLE;
}

// What this context draws is in order with its own frames, and waits here for those of others.
void wait_sync(Context& c, GLsync handle, GLbitfield, GLuint64) {
  const SyncPtr sync = find_and_lock(c, handle);
  if (sync && sync->clock != c.clock) sync->clock->wait(sync->frame, kMaxServerWait);
}

void get_sync(Context& c, GLsync handle, GLenum pname, GLsizei count, GLsizei* length,
              GLint* values) {
  const auto value = [&]() -> GLenum {
    switch (pname) {
      case GL_OBJECT_TYPE_APPLE:
        return GL_SYNC_FENCE_APPLE;
      case GL_SYNC_CONDITION_APPLE:
        return GL_SYNC_GPU_COMMANDS_COMPLETE_APPLE;
      case GL_SYNC_STATUS_APPLE:
        return find_sync(*c.share, handle)->signaled() ? GL_SIGNALED_APPLE : GL_UNSIGNALED_APPLE;
      default:
        return 0;  // SYNC_FLAGS_APPLE
    }
  };
  if (count > 0) *values = static_cast<GLint>(value());
  if (length) *length = std::min(count, 1);
}

}  // namespace exec

}  // namespace clearpipe::api
