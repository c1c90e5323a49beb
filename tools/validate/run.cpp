// See run.h.
// SPDX-License-Identifier: MIT
#include "tools/validate/run.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "tools/validate/places.h"

namespace clearpipe::validate {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

std::string wanted_frames(const Options& options) {
  if (options.every > 0) return "every " + std::to_string(options.every);
  std::string list;
  for (const int frame : options.frames) {
    if (!list.empty()) list += ',';
    list += std::to_string(frame);
  }
  return list;
}

void set_environment(const Options& options, const Implementation& implementation,
                     const std::string& folder) {
  setenv("__EGL_VENDOR_LIBRARY_FILENAMES", implementation.manifest.c_str(), 1);
  unsetenv("__EGL_VENDOR_LIBRARY_DIRS");
  if (implementation.mesa) {
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  }
  std::string preload = capture_library();
  if (const char* others = std::getenv("LD_PRELOAD")) preload += std::string(":") + others;
  setenv("LD_PRELOAD", preload.c_str(), 1);
  setenv("CLEARPIPE_CAPTURE_FOLDER", folder.c_str(), 1);
  setenv("CLEARPIPE_CAPTURE_FRAMES", wanted_frames(options).c_str(), 1);
  if (options.clock > 0) {
    // The same on every run, and not after the real one: who waits for a time is not kept.
    static const auto time = std::chrono::system_clock::now().time_since_epoch() / 1s;
    static const auto steady = Clock::now().time_since_epoch() / 1s;
    std::ostringstream text;
    text << options.clock << ' ' << time << ' ' << steady;
    setenv("CLEARPIPE_CAPTURE_CLOCK", text.str().c_str(), 1);
  }
}

// In a process group of its own, so that what it has started ends with it.
pid_t start(const Options& options, const Implementation& implementation,
            const std::string& folder) {
  std::vector<char*> arguments;
  for (const std::string& word : options.program) {
    arguments.push_back(const_cast<char*>(word.c_str()));
  }
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error(std::string("cannot fork: ") + std::strerror(errno));
  if (child > 0) return child;
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  const int output = open((folder + "/output").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  set_environment(options, implementation, folder);
  execvp(arguments[0], arguments.data());
  std::fprintf(stderr, "%s: %s\n", arguments[0], std::strerror(errno));
  _exit(127);
}

void read_log(const std::string& folder, Run& run) {
  std::ifstream file(folder + "/log");
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string what, rest;
    words >> what;
    std::getline(words >> std::ws, rest);
    int first = 0, second = 0;
    std::sscanf(rest.c_str(), "%d %d", &first, &second);
    if (what == "renderer") run.renderer = rest;
    if (what == "version") run.version = rest;
    if (what == "samples") run.samples = first;
    if (what == "frame") run.frames = first;
    if (what == "undefined") run.undefined.emplace(second, first);
    if (what == "error") run.error = rest;
    if (what == "done") run.finished = true;
  }
}

// One line, again and again on a terminal; every few seconds elsewhere.
class Progress {
 public:
  explicit Progress(std::string name) : name_(std::move(name)), next_(Clock::now() + period_) {}
  ~Progress() {
    if (shown_ && terminal_) std::fprintf(stderr, "\r\033[K");
  }
  void show(const std::string& folder) {
    if (Clock::now() < next_) return;
    next_ = Clock::now() + period_;
    shown_ = true;
    Run so_far;
    read_log(folder, so_far);
    std::fprintf(stderr, terminal_ ? "\r\033[K%s: frame %d" : "%s: frame %d\n", name_.c_str(),
                 so_far.frames);
    std::fflush(stderr);
  }

 private:
  std::string name_;
  bool terminal_ = isatty(STDERR_FILENO) == 1;
  bool shown_ = false;
  std::chrono::milliseconds period_ = terminal_ ? 500ms : 5000ms;
  Clock::time_point next_;
};

std::string last_lines(const std::string& path) {
  std::ifstream file(path);
  std::string text(std::istreambuf_iterator<char>(file), {});
  constexpr size_t kMost = 500;
  if (text.size() > kMost) text.replace(0, text.size() - kMost, "...");
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

std::string describe_ending(int status) {
  if (WIFSIGNALED(status)) {
    return "was killed by signal " + std::to_string(WTERMSIG(status)) + " (" +
           strsignal(WTERMSIG(status)) + ")";
  }
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

// Waits for its end, or ends it.
void wait_for(pid_t child, const Options& options, const std::string& folder, Progress& progress,
              Run& result) {
  const auto end = Clock::now() + std::chrono::seconds(options.timeout);
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (Clock::now() > end) {
      kill(-child, SIGKILL);
      waitpid(child, &status, 0);
      result.ending = "was ended after " + std::to_string(options.timeout) + " seconds";
      return;
    }
    progress.show(folder);
    std::this_thread::sleep_for(5ms);
  }
  kill(-child, SIGKILL);
  result.ending = describe_ending(status);
  result.finished = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127 &&
      !std::filesystem::exists(folder + "/log")) {
    throw std::runtime_error("cannot run " + last_lines(folder + "/output"));
  }
}

}  // namespace

Run run(const Options& options, const Implementation& implementation, const std::string& folder) {
  std::filesystem::create_directories(folder);
  Run result;
  Progress progress(implementation.name);
  wait_for(start(options, implementation, folder), options, folder, progress, result);
  read_log(folder, result);
  result.output = last_lines(folder + "/output");
  for (const auto& item : std::filesystem::directory_iterator(folder)) {
    int number = 0;
    if (std::sscanf(item.path().filename().c_str(), "frame-%d", &number) == 1) {
      result.files[number] = item.path();
    }
  }
  return result;
}

conformance::Image read_frame(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  conformance::Image image;
  file >> image.width >> image.height;
  file.get();
  if (!file || image.width < 1 || image.height < 1) throw std::runtime_error(path + " is broken");
  image.pixels.resize(static_cast<size_t>(image.width) * static_cast<size_t>(image.height) * 4);
  file.read(reinterpret_cast<char*>(image.pixels.data()),
            static_cast<std::streamsize>(image.pixels.size()));
  if (!file) throw std::runtime_error(path + " is cut short");
  return image;
}

}  // namespace clearpipe::validate
