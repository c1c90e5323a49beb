// See wayland_compositor.h.
// SPDX-License-Identifier: MIT
#include "icd/wayland_compositor.h"

#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>
#include <wayland-server.h>

#include <algorithm>
#include <deque>
#include <future>
#include <mutex>
#include <thread>
#include <utility>

namespace clearpipe::icd {

namespace {

struct Part {
  int x, y, width, height;
};

struct Surface {
  void* state = nullptr;
  wl_resource* buffer = nullptr;
  bool attached = false;
  int dx = 0, dy = 0;
  std::vector<Part> damage;
  std::vector<wl_resource*> callbacks;
};

// A buffer that is read, which its client may destroy nevertheless.
struct HeldBuffer {
  wl_listener destroyed{};  // first, so that its address is this object's
  wl_resource* buffer = nullptr;
  explicit HeldBuffer(wl_resource* held) : buffer(held) {
    destroyed.notify = [](wl_listener* listener, void*) {
      reinterpret_cast<HeldBuffer*>(listener)->buffer = nullptr;
    };
    wl_resource_add_destroy_listener(buffer, &destroyed);
  }
  ~HeldBuffer() {
    if (buffer != nullptr) wl_list_remove(&destroyed.link);
  }
  HeldBuffer(const HeldBuffer&) = delete;
  HeldBuffer& operator=(const HeldBuffer&) = delete;
};

void destroy_resource(wl_client*, wl_resource* resource) { wl_resource_destroy(resource); }

}  // namespace

// Everything but the queue of tasks and the results belongs to the compositor's thread.
struct TestCompositor::State {
  wl_display* display = nullptr;
  wl_event_source* timer = nullptr;
  wl_event_source* waking = nullptr;
  int wake = -1;
  std::thread thread;
  bool running = true;

  std::mutex mutex;
  std::deque<std::function<void()>> tasks;
  size_t commits = 0;
  Commit last;

  Frames frames = Frames::kAtOnce;
  size_t hold = 0;
  std::deque<std::unique_ptr<HeldBuffer>> held;
  std::vector<wl_resource*> waiting;  // callbacks of frames to come

  // Runs in the compositor's thread; returns when it has run.
  void run(const std::function<void()>& task) {
    std::promise<void> done;
    {
      const std::lock_guard<std::mutex> lock(mutex);
      tasks.push_back([&] {
        task();
        done.set_value();
      });
    }
    eventfd_write(wake, 1);
    done.get_future().wait();
  }

  static int run_tasks(int fd, uint32_t, void* data) {
    auto* state = static_cast<State*>(data);
    eventfd_t count = 0;
    eventfd_read(fd, &count);
    for (;;) {
      std::function<void()> task;
      {
        const std::lock_guard<std::mutex> lock(state->mutex);
        if (state->tasks.empty()) return 0;
        task = std::move(state->tasks.front());
        state->tasks.pop_front();
      }
      task();
    }
  }

  static int tick(void* data) {
    auto* state = static_cast<State*>(data);
    if (state->frames == Frames::kEvery20Milliseconds) state->send_frames();
    wl_event_source_timer_update(state->timer, 20);
    return 0;
  }

  void send_frames() {
    for (wl_resource* callback : std::exchange(waiting, {})) {
      wl_callback_send_done(callback, 0);
      wl_resource_destroy(callback);
    }
  }

  static void forget_callback(wl_resource* callback) {
    auto* state = static_cast<State*>(wl_resource_get_user_data(callback));
    std::erase(state->waiting, callback);
  }

  void release(wl_resource* buffer) {
    held.push_back(std::make_unique<HeldBuffer>(buffer));
    while (held.size() > hold) {
      if (held.front()->buffer != nullptr) wl_buffer_send_release(held.front()->buffer);
      held.pop_front();
    }
  }

  void take(Surface& surface) {
    wl_shm_buffer* shm = wl_shm_buffer_get(surface.buffer);
    Commit commit;
    commit.width = wl_shm_buffer_get_width(shm);
    commit.height = wl_shm_buffer_get_height(shm);
    commit.has_alpha = wl_shm_buffer_get_format(shm) == WL_SHM_FORMAT_ARGB8888;
    commit.dx = surface.dx;
    commit.dy = surface.dy;
    commit.is_rgb565 = wl_shm_buffer_get_format(shm) == WL_SHM_FORMAT_RGB565;
    wl_shm_buffer_begin_access(shm);
    const auto* rows = static_cast<const std::byte*>(wl_shm_buffer_get_data(shm));
    for (int y = 0; y < commit.height; ++y, rows += wl_shm_buffer_get_stride(shm)) {
      for (int x = 0; x < commit.width; ++x) commit.buffer.push_back(commit.pixel(rows, x));
    }
    wl_shm_buffer_end_access(shm);
    {
      const std::lock_guard<std::mutex> lock(mutex);
      const bool same = last.width == commit.width && last.height == commit.height;
      commit.shown = same ? last.shown : std::vector<uint32_t>(commit.buffer.size());
    }
    for (const Part& part : surface.damage) {
      const int right = std::min<int64_t>(int64_t{part.x} + part.width, commit.width);
      const int bottom = std::min<int64_t>(int64_t{part.y} + part.height, commit.height);
      for (int y = std::max(part.y, 0); y < bottom; ++y) {
        for (int x = std::max(part.x, 0); x < right; ++x) {
          const size_t i = static_cast<size_t>(y * commit.width + x);
          commit.shown[i] = commit.buffer[i];
        }
      }
    }
    const std::lock_guard<std::mutex> lock(mutex);
    last = std::move(commit);
    ++commits;
  }

  static Surface& surface_of(wl_resource* resource) {
    return *static_cast<Surface*>(wl_resource_get_user_data(resource));
  }
  static void attach(wl_client*, wl_resource* resource, wl_resource* buffer, int32_t x, int32_t y) {
    Surface& surface = surface_of(resource);
    surface.buffer = buffer;
    surface.attached = true;
    surface.dx = x;
    surface.dy = y;
  }
  static void damage(wl_client*, wl_resource* resource, int32_t x, int32_t y, int32_t width,
                     int32_t height) {
    surface_of(resource).damage.push_back({x, y, width, height});
  }
  static void frame(wl_client* client, wl_resource* resource, uint32_t id) {
    Surface& surface = surface_of(resource);
    wl_resource* callback = wl_resource_create(client, &wl_callback_interface, 1, id);
    wl_resource_set_implementation(callback, nullptr, surface.state, forget_callback);
    surface.callbacks.push_back(callback);
  }
  static void ignore_region(wl_client*, wl_resource*, wl_resource*) {}
  static void ignore_number(wl_client*, wl_resource*, int32_t) {}
  static void commit(wl_client*, wl_resource* resource) {
    Surface& surface = surface_of(resource);
    auto* state = static_cast<State*>(surface.state);
    if (surface.attached && surface.buffer != nullptr) {
      state->take(surface);
      state->release(surface.buffer);
    }
    surface.attached = false;
    surface.damage.clear();
    for (wl_resource* callback : surface.callbacks) state->waiting.push_back(callback);
    surface.callbacks.clear();
    if (state->frames == Frames::kAtOnce) state->send_frames();
  }
  static void destroy_surface(wl_resource* resource) {
    delete static_cast<Surface*>(wl_resource_get_user_data(resource));
  }
  static void create_surface(wl_client* client, wl_resource* compositor, uint32_t id) {
    static constexpr struct wl_surface_interface kSurface = {
        destroy_resource, attach,        damage,        frame,  ignore_region, ignore_region,
        commit,           ignore_number, ignore_number, damage, nullptr};
    auto* surface = new Surface;
    surface->state = wl_resource_get_user_data(compositor);
    wl_resource* resource =
        wl_resource_create(client, &wl_surface_interface, wl_resource_get_version(compositor), id);
    wl_resource_set_implementation(resource, &kSurface, surface, destroy_surface);
  }
  static void create_region(wl_client* client, wl_resource*, uint32_t id) {
    static constexpr struct wl_region_interface kRegion = {
        destroy_resource, [](wl_client*, wl_resource*, int32_t, int32_t, int32_t, int32_t) {},
        [](wl_client*, wl_resource*, int32_t, int32_t, int32_t, int32_t) {}};
    wl_resource* resource = wl_resource_create(client, &wl_region_interface, 1, id);
    wl_resource_set_implementation(resource, &kRegion, nullptr, nullptr);
  }
  static void bind_compositor(wl_client* client, void* data, uint32_t version, uint32_t id) {
    static constexpr struct wl_compositor_interface kCompositor = {create_surface, create_region};
    wl_resource* resource =
        wl_resource_create(client, &wl_compositor_interface, static_cast<int>(version), id);
    wl_resource_set_implementation(resource, &kCompositor, data, nullptr);
  }
};

TestCompositor::TestCompositor() : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.display = wl_display_create();
  s.wake = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  wl_display_init_shm(s.display);
  wl_display_add_shm_format(s.display, WL_SHM_FORMAT_RGB565);
  wl_global_create(s.display, &wl_compositor_interface, 4, &s, State::bind_compositor);
  wl_event_loop* loop = wl_display_get_event_loop(s.display);
  s.waking = wl_event_loop_add_fd(loop, s.wake, WL_EVENT_READABLE, State::run_tasks, &s);
  s.timer = wl_event_loop_add_timer(loop, State::tick, &s);
  wl_event_source_timer_update(s.timer, 20);
  s.thread = std::thread([&s] { wl_display_run(s.display); });
}

TestCompositor::~TestCompositor() {
  State& s = *state_;
  s.run([&s] {
    wl_display_destroy_clients(s.display);
    wl_display_terminate(s.display);
  });
  s.thread.join();
  wl_event_source_remove(s.timer);
  wl_event_source_remove(s.waking);
  wl_display_destroy(s.display);
  close(s.wake);
}

int TestCompositor::connect() {
  int ends[2] = {-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return -1;
  state_->run([&] { wl_client_create(state_->display, ends[0]); });
  return ends[1];
}

std::string TestCompositor::add_socket() {
  std::string name;
  state_->run([&] {
    const char* added = wl_display_add_socket_auto(state_->display);
    name = added != nullptr ? added : "";
  });
  return name;
}

void TestCompositor::set_frames(Frames frames) {
  state_->run([&] {
    state_->frames = frames;
    if (frames == Frames::kAtOnce) state_->send_frames();
  });
}

void TestCompositor::hold_buffers(size_t count) {
  state_->run([&] { state_->hold = count; });
}

void TestCompositor::disconnect_clients() {
  state_->run([&] { wl_display_destroy_clients(state_->display); });
}

size_t TestCompositor::commits() {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return state_->commits;
}

Commit TestCompositor::last() {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return state_->last;
}

}  // namespace clearpipe::icd
