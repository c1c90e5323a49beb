// X servers that die: one of the test's own, killed while programs use it. The EGL error, no crash,
// no leak, and every other display goes on.
// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <xcb/xcb.h>

#include <chrono>
#include <thread>

#include "icd/egl_test.h"

namespace clearpipe::icd {
namespace {

class X11ServerTest : public testing::Test {
 protected:
  void SetUp() override {
    if (const char* display = std::getenv("DISPLAY")) before_ = display;
  }
  void TearDown() override {
    kill_server();
    setenv("DISPLAY", before_.c_str(), 1);
  }

  // On the first display number that is free.
  void start_server() {
    kill_server();
    int display_pipe[2];
    ASSERT_EQ(pipe(display_pipe), 0);
    server_ = fork();
    ASSERT_GE(server_, 0);
    if (server_ == 0) {
      dup2(display_pipe[1], 3);
      const int nowhere = open("/dev/null", O_WRONLY);
      dup2(nowhere, 1);
      dup2(nowhere, 2);
      unsetenv("LD_PRELOAD");
      unsetenv("LD_LIBRARY_PATH");
      execlp("Xvfb", "Xvfb", "-displayfd", "3", "-nolisten", "tcp", "-screen", "0", "320x240x24",
             nullptr);
      _exit(127);
    }
    close(display_pipe[1]);
    char number[16] = {};
    ssize_t length = 0;
    for (ssize_t got = 1; got > 0 && std::strchr(number, '\n') == nullptr && length < 15;) {
      got = read(display_pipe[0], number + length, static_cast<size_t>(15 - length));
      length += got > 0 ? got : 0;
    }
    close(display_pipe[0]);
    ASSERT_NE(std::strchr(number, '\n'), nullptr) << "Xvfb did not start";
    name_ = ':';
    name_.append(number, std::strcspn(number, "\n"));
  }
  void kill_server() {
    if (server_ <= 0) return;
    kill(server_, SIGKILL);
    waitpid(server_, nullptr, 0);
    server_ = -1;
  }

  // A window of the program's own connection, and the display of that.
  struct Client {
    xcb_connection_t* connection = nullptr;
    xcb_window_t window = 0;
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLConfig config = nullptr;
    EGLSurface surface = EGL_NO_SURFACE;
    EGLContext context = EGL_NO_CONTEXT;
  };
  void open_client(Client& c, bool own_connection) {
    ASSERT_FALSE(HasFatalFailure());
    c.connection = xcb_connect(name_.c_str(), nullptr);
    ASSERT_EQ(xcb_connection_has_error(c.connection), 0);
    const xcb_screen_t* screen = xcb_setup_roots_iterator(xcb_get_setup(c.connection)).data;
    c.window = xcb_generate_id(c.connection);
    xcb_create_window(c.connection, XCB_COPY_FROM_PARENT, c.window, screen->root, 0, 0, 32, 32, 0,
                      XCB_WINDOW_CLASS_INPUT_OUTPUT, screen->root_visual, 0, nullptr);
    xcb_map_window(c.connection, c.window);
    std::free(xcb_get_input_focus_reply(c.connection, xcb_get_input_focus(c.connection), nullptr));
    setenv("DISPLAY", name_.c_str(), 1);
    void* const native = own_connection ? c.connection : EGL_DEFAULT_DISPLAY;
    c.display = eglGetPlatformDisplay(EGL_PLATFORM_XCB_EXT, native, nullptr);
    ASSERT_TRUE(eglInitialize(c.display, nullptr, nullptr));
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_NATIVE_VISUAL_ID,
                             static_cast<EGLint>(screen->root_visual), EGL_NONE};
    EGLint count = 0;
    ASSERT_TRUE(eglChooseConfig(c.display, wanted, &c.config, 1, &count));
    ASSERT_EQ(count, 1);
    c.surface = eglCreatePlatformWindowSurface(c.display, c.config, &c.window, nullptr);
    c.context = eglCreateContext(c.display, c.config, EGL_NO_CONTEXT, nullptr);
    ASSERT_TRUE(eglMakeCurrent(c.display, c.surface, c.surface, c.context));
  }
  static void close_client(const Client& c) {
    EXPECT_EGL_OK(eglReleaseThread());
    EXPECT_EGL_OK(eglTerminate(c.display));
    xcb_disconnect(c.connection);
  }
  // Draws and shows frames until that fails, as it must before long.
  static void draw_until_refused(const Client& c) {
    const auto begin = std::chrono::steady_clock::now();
    while (eglSwapBuffers(c.display, c.surface)) {
      EXPECT_EQ(clear_and_read(0, 1, 0, 1), 0xff00ff00u);
      ASSERT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
    }
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
  }

  std::string name_;

 private:
  std::string before_;  // the display that other tests use
  pid_t server_ = -1;
};

TEST_F(X11ServerTest, KilledBetweenFrames) {
  for (const bool own_connection : {true, false}) {
    start_server();
    Client client;
    open_client(client, own_connection);
    if (HasFatalFailure()) return;
    EXPECT_EGL_OK(eglSwapBuffers(client.display, client.surface));
    kill_server();
    draw_until_refused(client);
    // Drawing goes on; windows and pixmaps cannot be had, pbuffers can.
    EXPECT_EQ(clear_and_read(0, 0, 1, 1), 0xffff0000u);
    EGLint width = 0;
    EXPECT_EGL_OK(eglQuerySurface(client.display, client.surface, EGL_WIDTH, &width));
    EXPECT_EQ(width, 32);
    xcb_window_t other = client.window + 1;
    EXPECT_EGL_FAIL(eglCreatePlatformWindowSurface(client.display, client.config, &other, nullptr),
                    EGL_NO_SURFACE, EGL_BAD_NATIVE_WINDOW);
    xcb_pixmap_t pixmap = client.window + 2;
    EXPECT_EGL_FAIL(eglCreatePlatformPixmapSurface(client.display, client.config, &pixmap, nullptr),
                    EGL_NO_SURFACE, EGL_BAD_NATIVE_PIXMAP);
    EXPECT_EGL_FAIL(eglCopyBuffers(client.display, client.surface, pixmap), EGL_FALSE,
                    EGL_BAD_NATIVE_PIXMAP);
    close_client(client);
    EXPECT_EGL_FAIL(eglInitialize(client.display, nullptr, nullptr), EGL_FALSE,
                    EGL_NOT_INITIALIZED);
  }
}

// At any moment of a frame, also while the swap interval is waited for.
TEST_F(X11ServerTest, KilledWhileDrawing) {
  for (const EGLint interval : {0, 1}) {
    start_server();
    Client client;
    open_client(client, true);
    if (HasFatalFailure()) return;
    EXPECT_TRUE(eglSwapInterval(client.display, interval));
    std::thread killer([this] {
      std::this_thread::sleep_for(std::chrono::milliseconds(40));
      kill_server();
    });
    draw_until_refused(client);
    killer.join();
    close_client(client);
  }
}

// Another display of the process has no part in it.
TEST_F(X11ServerTest, OthersGoOn) {
  start_server();
  Client client;
  open_client(client, true);
  if (HasFatalFailure()) return;
  const EGLDisplay surfaceless = surfaceless_display();
  ASSERT_TRUE(eglInitialize(surfaceless, nullptr, nullptr));
  kill_server();
  draw_until_refused(client);
  EGLConfig config = nullptr;
  EGLint count = 0;
  ASSERT_TRUE(eglGetConfigs(surfaceless, &config, 1, &count));
  const EGLint size[] = {EGL_WIDTH, 4, EGL_HEIGHT, 4, EGL_NONE};
  const EGLSurface pbuffer = eglCreatePbufferSurface(surfaceless, config, size);
  const EGLContext context = eglCreateContext(surfaceless, config, EGL_NO_CONTEXT, nullptr);
  ASSERT_TRUE(eglMakeCurrent(surfaceless, pbuffer, pbuffer, context));
  EXPECT_EQ(clear_and_read(1, 0, 0, 1), 0xff0000ffu);
  close_client(client);
  EXPECT_EGL_OK(eglTerminate(surfaceless));
}

}  // namespace
}  // namespace clearpipe::icd
