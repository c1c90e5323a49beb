// EGL commands on sync objects (3.8.1), and the forms that EGL_KHR_fence_sync,
// EGL_KHR_reusable_sync and EGL_KHR_wait_sync have of them.
// SPDX-License-Identifier: MIT
#include <memory>
#include <new>

#include "icd/entry.h"

namespace clearpipe::icd::entry {

namespace {

// `bad_type`: what EGL 1.5 and the extensions call a type that is not supported.
template <class Attribute>
EGLSync create_sync(EGLDisplay dpy, EGLenum type, const Attribute* attrib_list,
                    EGLint bad_type) noexcept try {
  const Thread& thread = this_thread();
  if (type == EGL_SYNC_FENCE) finish_current(thread);
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_NO_SYNC;
  if (type != EGL_SYNC_FENCE && type != EGL_SYNC_REUSABLE_KHR) return fail(bad_type, EGL_NO_SYNC);
  if (attrib_list != nullptr && *attrib_list != EGL_NONE) {
    return fail(EGL_BAD_ATTRIBUTE, EGL_NO_SYNC);
  }
  if (type == EGL_SYNC_FENCE && (thread.context == nullptr || thread.display != display)) {
    return fail(EGL_BAD_MATCH, EGL_NO_SYNC);
  }
  display->syncs.push_back(
      std::make_shared<Sync>(Object::next_handle(), type, type == EGL_SYNC_FENCE));
  return succeed<EGLSync>(display->syncs.back()->handle);
} catch (const std::bad_alloc&) {
  return fail(EGL_BAD_ALLOC, EGL_NO_SYNC);
}

// Table 3.9.
template <class Value>
EGLBoolean get_attrib(EGLDisplay dpy, EGLSync handle, EGLint attribute, Value* value) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  const std::shared_ptr<Sync> sync = display->sync(handle);
  if (sync == nullptr || value == nullptr) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  switch (attribute) {
    case EGL_SYNC_TYPE:
      *value = static_cast<Value>(sync->type);
      break;
    case EGL_SYNC_STATUS:
      *value = sync->signaled() ? EGL_SIGNALED : EGL_UNSIGNALED;
      break;
    case EGL_SYNC_CONDITION:
      if (sync->type != EGL_SYNC_FENCE) return fail(EGL_BAD_MATCH, EGL_FALSE);
      *value = EGL_SYNC_PRIOR_COMMANDS_COMPLETE;
      break;
    default:
      return fail(EGL_BAD_ATTRIBUTE, EGL_FALSE);
  }
  return succeed(EGL_TRUE);
}

}  // namespace

EGLSync CreateSync(EGLDisplay dpy, EGLenum type, const EGLAttrib* attrib_list) noexcept {
  return create_sync(dpy, type, attrib_list, EGL_BAD_PARAMETER);
}

EGLSyncKHR CreateSyncKHR(EGLDisplay dpy, EGLenum type, const EGLint* attrib_list) noexcept {
  return create_sync(dpy, type, attrib_list, EGL_BAD_ATTRIBUTE);
}

EGLBoolean DestroySync(EGLDisplay dpy, EGLSync handle) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  const std::shared_ptr<Sync> sync = display->sync(handle);
  if (sync == nullptr) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  sync->signal();  // who waits is woken (EGL_KHR_reusable_sync)
  std::erase(display->syncs, sync);
  display->labels.erase(handle);
  return succeed(EGL_TRUE);
}

EGLBoolean DestroySyncKHR(EGLDisplay dpy, EGLSyncKHR sync) noexcept {
  return DestroySync(dpy, sync);
}

EGLint ClientWaitSync(EGLDisplay dpy, EGLSync handle, EGLint flags, EGLTime timeout) noexcept {
  if ((flags & EGL_SYNC_FLUSH_COMMANDS_BIT) != 0) finish_current(this_thread());
  std::unique_lock<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  const std::shared_ptr<Sync> sync = display->sync(handle);
  if (sync == nullptr) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  return succeed(sync->wait(lock, timeout) ? EGL_CONDITION_SATISFIED : EGL_TIMEOUT_EXPIRED);
}

EGLint ClientWaitSyncKHR(EGLDisplay dpy, EGLSyncKHR sync, EGLint flags,
                         EGLTimeKHR timeout) noexcept {
  return ClientWaitSync(dpy, sync, flags, timeout);
}

EGLBoolean WaitSync(EGLDisplay dpy, EGLSync handle, EGLint flags) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  const std::shared_ptr<Sync> sync = display->sync(handle);
  if (sync == nullptr || flags != 0) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  if (this_thread().context == nullptr) return fail(EGL_BAD_MATCH, EGL_FALSE);
  // A fence is signaled already, so its effects precede all that follows. Commands that wait for
  // an unsignaled sync are not supported: they run on threads that must not block on the client.
  if (!sync->signaled()) return fail(EGL_BAD_MATCH, EGL_FALSE);
  return succeed(EGL_TRUE);
}

EGLint WaitSyncKHR(EGLDisplay dpy, EGLSyncKHR sync, EGLint flags) noexcept {
  return static_cast<EGLint>(WaitSync(dpy, sync, flags));
}

EGLBoolean SignalSyncKHR(EGLDisplay dpy, EGLSyncKHR handle, EGLenum mode) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  const std::shared_ptr<Sync> sync = display->sync(handle);
  if (sync == nullptr) return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  if (sync->type != EGL_SYNC_REUSABLE_KHR) return fail(EGL_BAD_MATCH, EGL_FALSE);
  if (mode == EGL_SIGNALED) {
    sync->signal();
  } else if (mode == EGL_UNSIGNALED) {
    sync->unsignal();
  } else {
    return fail(EGL_BAD_PARAMETER, EGL_FALSE);
  }
  return succeed(EGL_TRUE);
}

EGLBoolean GetSyncAttrib(EGLDisplay dpy, EGLSync sync, EGLint attribute,
                         EGLAttrib* value) noexcept {
  return get_attrib(dpy, sync, attribute, value);
}

EGLBoolean GetSyncAttribKHR(EGLDisplay dpy, EGLSyncKHR sync, EGLint attribute,
                            EGLint* value) noexcept {
  return get_attrib(dpy, sync, attribute, value);
}

}  // namespace clearpipe::icd::entry
