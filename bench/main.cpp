// SPDX-License-Identifier: MIT
//
// Runs one scene of the bench on whichever implementation the loader picks, and prints what its
// frames took, on one line of name=value pairs. Every frame ends with glFinish, or if it is drawn
// into a window, by showing it.
//
//   scenes --list                       the scenes, one a line, fields parted by tabs
//   scenes --scene NAME [--size WxH]    runs one
//     --frames N | --seconds S          so many frames are measured, or for so long (0.5 s)
//     --amount N                        of triangles, draws, ... in a frame
//     --image file.png                  then draws frame 0 once more and writes it
//     --times                           prints the time of each frame as well, in ms
#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

#include "bench/context.h"
#include "bench/extras.h"
#include "bench/measure.h"
#include "bench/scene.h"
#include "bench/shapes.h"

namespace bench {
namespace {

// Of the library bench_allocations, when that is preloaded.
extern "C" {
[[gnu::weak]] long bench_allocations();
[[gnu::weak]] void bench_trace_allocations(int on);
}

// What the first frames do once, and what they wake, is not what a frame costs.
constexpr int kWarmUp = 3;

struct Options {
  std::string scene, image;
  int width = 1024, height = 768, frames = 0, amount = 0;
  double seconds = 0.5;
  bool list = false, times = false;
};

[[noreturn]] void usage() {
  std::fprintf(stderr,
               "usage: scenes --list | --scene NAME [--size WxH] [--frames N | --seconds S] "
               "[--amount N] [--image file.png] [--times]\n");
  std::exit(2);
}

Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (option == "--list") {
      options.list = true;
      continue;
    }
    if (option == "--times") {
      options.times = true;
      continue;
    }
    if (++i == argc) usage();
    char end = 0;
    bool good = true;
    if (option == "--scene") {
      options.scene = argv[i];
    } else if (option == "--image") {
      options.image = argv[i];
    } else if (option == "--size") {
      good = std::sscanf(argv[i], "%dx%d%c", &options.width, &options.height, &end) == 2 &&
             options.width > 0 && options.height > 0;
    } else if (option == "--frames") {
      good = std::sscanf(argv[i], "%d%c", &options.frames, &end) == 1 && options.frames > 0;
    } else if (option == "--amount") {
      good = std::sscanf(argv[i], "%d%c", &options.amount, &end) == 1 && options.amount > 0;
    } else if (option == "--seconds") {
      good = std::sscanf(argv[i], "%lf%c", &options.seconds, &end) == 1 && options.seconds > 0;
    } else {
      usage();
    }
    if (!good) usage();
  }
  if (options.list == !options.scene.empty()) usage();
  return options;
}

// Calls what it is given with each scene.
template <typename Function>
void for_each_scene(Function function) {
  for (const auto list :
       {fill_scenes(), fragment_scenes(), texture_scenes(), mesh_scenes(), draw_scenes(),
        point_and_line_scenes(), transfer_scenes(), model_scenes(), gears_scenes()}) {
    for (const Scene& scene : list) function(scene);
  }
}

const Scene* find_scene(const std::string& name) {
  const Scene* found = nullptr;
  for_each_scene([&](const Scene& scene) {
    if (name == scene.name) found = &scene;
  });
  return found;
}

void list_scenes() {
  for_each_scene([](const Scene& scene) {
    std::printf("%s\t%s\t%s\t%d\t%s\t%g\t%s\t%g\t%s\n", scene.name, scene.unit,
                scene.window ? "window" : "-", scene.amount,
                scene.extension ? scene.extension : "-", scene.bytes,
                scene.traffic ? scene.traffic : "-", scene.share, scene.what);
  });
}

const char* text(GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); }

void write_image(const View& view, const std::string& path) {
  Picture below{view.width, view.height, {}}, picture = below;
  const size_t row = size_t(view.width) * 4;
  below.pixels.resize(row * size_t(view.height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, view.width, view.height, GL_RGBA, GL_UNSIGNED_BYTE, below.pixels.data());
  for (size_t y = size_t(view.height); y-- > 0;) {  // its rows come from the bottom
    picture.pixels.insert(picture.pixels.end(), below.pixels.begin() + ptrdiff_t(y * row),
                          below.pixels.begin() + ptrdiff_t((y + 1) * row));
  }
  save_png(picture, path);
}

// What the GNU allocator does by itself once a program has freed something large, as most have when
// they have loaded what they draw. Before that, large memory that an implementation asks for in
// each frame comes from the system each time, page by page, which takes longer than the frame.
void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
}

int run(const Options& options) {
  const double start = process_start();
  const Scene* const scene = find_scene(options.scene);
  if (!scene) {
    std::fprintf(stderr, "scenes: there is no scene %s; see scenes --list\n",
                 options.scene.c_str());
    return 2;
  }
  View view;
  view.width = options.width;
  view.height = options.height;
  if (scene->square > 0) view.width = view.height = scene->square;
  view.amount = options.amount > 0 ? options.amount : scene->amount;
  open_context(view, scene->window);
  if (scene->extension && !std::strstr(text(GL_EXTENSIONS), scene->extension)) {
    std::printf("scenes: scene=%s missing=%s renderer=\"%s\"\n", scene->name, scene->extension,
                text(GL_RENDERER));
    return 3;
  }
  const auto frame = [&](int number) {
    scene->frame(view, number);
    if (scene->window && !eglSwapBuffers(view.display, view.surface)) fail("eglSwapBuffers");
    glFinish();
  };
  const double ready = now();
  keep_freed_memory();
  const double units = scene->set_up(view);
  frame(0);
  const double first = now();
  for (int i = 1; i < kWarmUp; ++i) frame(i);
  const Times times = measure([&](int i) { frame(kWarmUp + i); }, options.frames, options.seconds);
  const long memory = peak_memory();
  long allocations = -1;
  if (bench_allocations != nullptr) {
    // Of a frame that is like those before in everything. Which worker does what differs, so one
    // may still meet more work than it ever did: the least of some frames is what is steady.
    for (int i = 0; i < 10; ++i) {
      const long before = bench_allocations();
      bench_trace_allocations(i >= 4);
      frame(0);
      const long asked = bench_allocations() - before;
      allocations = i == 4 ? asked : std::min(allocations, asked);
    }
    bench_trace_allocations(0);
  }

  if (!options.image.empty()) {
    scene->frame(view, 0);
    write_image(view, options.image);
  }
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    std::fprintf(stderr, "scenes: %s: OpenGL ES error 0x%04x\n", scene->name, error);
    return 1;
  }
  const double frames = double(times.frames.size());
  std::printf(
      "scenes: scene=%s size=%dx%d amount=%d frames=%.0f median_ms=%.4f mean_ms=%.4f "
      "worst_ms=%.4f user_ms=%.4f sys_ms=%.4f first_ms=%.3f open_ms=%.3f units=%.0f unit=%s "
      "peak_kib=%ld allocations=%ld renderer=\"%s\"\n",
      scene->name, view.width, view.height, view.amount, frames, 1e3 * times.median(),
      1e3 * times.total() / frames, 1e3 * times.worst(), 1e3 * times.used.user / frames,
      1e3 * times.used.system / frames, 1e3 * (first - start), 1e3 * (ready - start), units,
      scene->unit, memory, allocations, text(GL_RENDERER));
  if (options.times) {
    std::printf("times:");
    for (const double time : times.frames) std::printf(" %.4f", 1e3 * time);
    std::printf("\n");
  }
  close_context(view);
  return 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::note_process_start(argv);
  const bench::Options options = bench::parse(argc, argv);
  if (options.list) {
    bench::list_scenes();
    return 0;
  }
  return bench::run(options);
}
