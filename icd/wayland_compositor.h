// A compositor for tests, in a thread of the test: it keeps what clients commit, as a real one
// would show it, and tells of frames and released buffers as the test wants it to.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace clearpipe::icd {

struct Commit {
  int width = 0, height = 0;
  bool has_alpha = false;
  int dx = 0, dy = 0;
  std::vector<uint32_t> buffer;  // all that the buffer holds, 0xAARRGGBB, from the top
  std::vector<uint32_t> shown;   // what was shown before, and the damaged parts of the buffer
};

class TestCompositor {
 public:
  enum class Frames { kAtOnce, kEvery20Milliseconds, kNever };

  TestCompositor();
  ~TestCompositor();
  TestCompositor(const TestCompositor&) = delete;
  TestCompositor& operator=(const TestCompositor&) = delete;

  // A connection for wl_display_connect_to_fd().
  int connect();
  // The value of WAYLAND_DISPLAY, under XDG_RUNTIME_DIR.
  std::string add_socket();

  void set_frames(Frames frames);
  // So many buffers are read for longer than until the next one comes.
  void hold_buffers(size_t count);
  // Ends the connections of all clients.
  void disconnect_clients();

  size_t commits();
  Commit last();  // of a buffer

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace clearpipe::icd
