// Displays, and the threads that use them: see display.h.
// SPDX-License-Identifier: MIT
#include "icd/display.h"

#include <algorithm>
#include <atomic>
#include <cstdint>

namespace clearpipe::icd {

namespace {

template <class Object>
Object* find_living(const std::vector<std::unique_ptr<Object>>& objects, const void* handle) {
  const auto found = std::find_if(objects.begin(), objects.end(), [&](const auto& object) {
    return object->handle == handle && !object->destroyed;
  });
  return found == objects.end() ? nullptr : found->get();
}

template <class Object>
void erase_dead(std::vector<std::unique_ptr<Object>>& objects) {
  std::erase_if(objects, [](const auto& object) { return object->destroyed && !object->current; });
}

std::vector<std::unique_ptr<Display>>& all_displays() {
  static auto* list = new std::vector<std::unique_ptr<Display>>;
  return *list;
}

}  // namespace

const std::vector<std::unique_ptr<Display>>& displays() { return all_displays(); }

std::mutex& egl_mutex() {
  static auto* mutex = new std::mutex;
  return *mutex;
}

void* Object::next_handle() {
  static std::atomic<uintptr_t> last{0};
  return reinterpret_cast<void*>(++last);
}

const Config* Display::config(EGLConfig handle) const {
  const auto found = std::find_if(configs.begin(), configs.end(),
                                  [handle](const Config& config) { return &config == handle; });
  return found == configs.end() ? nullptr : &*found;
}

Surface* Display::surface(EGLSurface handle) { return find_living(surfaces, handle); }
Context* Display::context(EGLContext handle) { return find_living(contexts, handle); }

std::shared_ptr<Sync> Display::sync(EGLSync handle) const {
  const auto found = std::find_if(syncs.begin(), syncs.end(),
                                  [&](const auto& sync) { return sync->handle == handle; });
  return found == syncs.end() ? nullptr : *found;
}

bool Display::has_image(EGLImage handle) const {
  return std::any_of(images.begin(), images.end(),
                     [&](const auto& image) { return image->handle == handle; });
}

void Display::sweep() {
  erase_dead(contexts);
  erase_dead(surfaces);
}

Display* find_display(EGLDisplay handle) {
  for (const auto& display : displays()) {
    if (display.get() == handle) return display.get();
  }
  return nullptr;
}

EGLDeviceEXT the_device() {
  static char device;  // an address that no other vendor has
  return &device;
}

Display* get_display(const Origin& origin) {
  for (const auto& display : displays()) {
    if (display->origin == origin) return display.get();
  }
  all_displays().push_back(std::make_unique<Display>(origin));
  return all_displays().back().get();
}

Context* find_context(EGLContext handle) {
  for (const auto& display : displays()) {
    if (Context* context = display->context(handle); context != nullptr) return context;
  }
  return nullptr;
}

void finish_current(const Thread& thread) {
  if (thread.context != nullptr) api::finish(thread.context->context);
}

void bind_targets(Context& context) {
  const pipeline::Target none;
  api::set_targets(context.context, context.draw != nullptr ? context.draw->target : none,
                   context.read != nullptr ? context.read->target : none);
}

void release_current(Thread& thread) {
  if (thread.context == nullptr) return;
  api::make_current(nullptr, {}, {});
  Context& context = *thread.context;
  context.current = false;
  if (context.draw != nullptr) context.draw->current = false;
  if (context.read != nullptr) context.read->current = false;
  context.draw = context.read = nullptr;
  thread.context = nullptr;
  Display* display = thread.display;
  thread.display = nullptr;
  display->sweep();
}

Thread::~Thread() {
  finish_current(*this);
  const std::lock_guard<std::mutex> lock(egl_mutex());
  release_current(*this);
}

Thread& this_thread() {
  static thread_local Thread thread;
  return thread;
}

}  // namespace clearpipe::icd
