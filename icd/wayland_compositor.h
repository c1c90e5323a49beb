// A compositor for tests, in a thread of the test: it keeps what clients commit, as a real one
// would show it, and tells of frames and released buffers as the test wants it to.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace clearpipe::icd {

struct Commit {
  int width = 0, height = 0;
  bool has_alpha = false, is_rgb565 = false;
  int dx = 0, dy = 0;
  std::vector<uint32_t> buffer;  // all that the buffer holds, 0xAARRGGBB, from the top
  std::vector<uint32_t> shown;   // what was shown before, and the damaged parts of the buffer

  // A pixel of a row of the buffer as it lies in memory.
  uint32_t pixel(const std::byte* row, int x) const {
    uint32_t value = 0;
    const size_t bytes = is_rgb565 ? 2 : 4;
    std::memcpy(&value, row + static_cast<size_t>(x) * bytes, bytes);
    if (!is_rgb565) return value;
    const uint32_t r = value >> 11, g = value >> 5 & 63, b = value & 31;
    return 0xff000000u | r * 255 / 31 << 16 | g * 255 / 63 << 8 | b * 255 / 31;
  }
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
