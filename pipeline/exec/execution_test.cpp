// Workers begin with the draws of a frame while more are recorded: the pixels must not tell.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <random>
#include <thread>
#include <vector>

#include "pipeline/exec/draw_list.h"
#include "pipeline/exec/frame_scene.h"
#include "pipeline/exec/pieces.h"

namespace clearpipe::pipeline {
namespace {

using namespace std::chrono_literals;

// Blended triangles, small and large, over one another, of ever changing states: each draw is seen
// by what the next ones make of its pixels. A clear of a part, now and then.
class ManyDraws {
 public:
  explicit ManyDraws(Scene& scene) : scene_(scene) {
    scene_.fragment.blend.enabled = true;
    scene_.fragment.blend.src_rgb = scene_.fragment.blend.src_alpha = BlendFactor::kSrcAlpha;
    scene_.fragment.blend.dst_rgb = scene_.fragment.blend.dst_alpha =
        BlendFactor::kOneMinusSrcAlpha;
  }

  void draw(int i) {
    if (i % 300 == 299) clear();
    scene_.fragment.depth_test = i % 3 == 0;
    scene_.fragment.depth_write = i % 2 == 0;
    scene_.vertex.model_view_projection.m[12] = number(-0.1f, 0.1f);
    const int triangles = i % 50 == 0 ? 40 : 1 + i % 3;
    std::vector<float> xyz;
    for (int t = 0; t < triangles; ++t) {
      const float size = i % 10 == 0 ? 0.8f : 0.08f;
      const float x = number(-1, 1), y = number(-1, 1);
      for (int k = 0; k < 3; ++k) {
        xyz.insert(xyz.end(),
                   {x + number(-size, size), y + number(-size, size), number(-0.9f, 0.9f)});
      }
    }
    scene_.draw(xyz, {number(0, 1), number(0, 1), number(0, 1), 0.7f});
  }

 private:
  float number(float least, float most) {
    return least + (most - least) * static_cast<float>(random_() >> 8) / float{1 << 24};
  }
  void clear() {
    ClearCommand clear;
    clear.rect = {20, 10, 100, 60};
    clear.colour = clear.depth = true;
    clear.colour_mask = 0xf;
    clear.colour_value = 0xff336699u;
    clear.depth_value = 0xffffffu;
    ASSERT_TRUE(scene_.frame.clear(clear));
  }

  Scene& scene_;
  std::minstd_rand random_{5};
};

std::vector<uint32_t> pixels_of(const Scene& scene) {
  std::vector<uint32_t> pixels(kWidth * kHeight);
  read_rectangle(*scene.target.colour, 0, 0, kWidth, kHeight, pixels.data(), 4 * kWidth);
  return pixels;
}

// What comes of so many draws when the frame is finished after every `finish_each` of them, so
// that none is begun with.
std::vector<uint32_t> one_by_one(int draws, int finish_each) {
  Scene scene;
  ManyDraws many(scene);
  for (int i = 0; i < draws; ++i) {
    many.draw(i);
    if (i % finish_each == finish_each - 1) scene.frame.finish();
  }
  scene.frame.finish();
  return pixels_of(scene);
}

constexpr int kDraws = 4000;

TEST(Execution, BeginsWhileDrawsAreRecorded) {
  const std::vector<uint32_t> expected = one_by_one(kDraws, 10);
  Scene scene;
  ManyDraws many(scene);
  for (int frame = 0; frame < 3; ++frame) {
    for (int i = 0; i < kDraws; ++i) many.draw(i);
    EXPECT_FALSE(scene.frame.empty());
    scene.frame.finish();
    EXPECT_TRUE(scene.frame.empty());
    if (frame == 0) {
      ASSERT_EQ(pixels_of(scene), expected);
    }
  }
}

// Slowly, so that each time all that was begun with is done.
TEST(Execution, BeginsAgainAndAgain) {
  const std::vector<uint32_t> expected = one_by_one(kDraws, 10);
  Scene scene;
  ManyDraws many(scene);
  for (int i = 0; i < kDraws; ++i) {
    if (i % 100 == 0) std::this_thread::sleep_for(2ms);
    many.draw(i);
  }
  scene.frame.finish();
  EXPECT_EQ(pixels_of(scene), expected);
}

TEST(Execution, FramesOfTwoThreadsShareTheWorkers) {
  const std::vector<uint32_t> expected = one_by_one(kDraws, 10);
  std::vector<uint32_t> pixels[3];
  std::vector<std::thread> threads;
  for (std::vector<uint32_t>& result : pixels) {
    threads.emplace_back([&result] {
      Scene scene;
      ManyDraws many(scene);
      for (int i = 0; i < kDraws; ++i) many.draw(i);
      scene.frame.finish();
      result = pixels_of(scene);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<uint32_t>& result : pixels) EXPECT_EQ(result, expected);
}

TEST(Execution, AFrameMayEndUnfinished) {
  for (int i = 0; i < 20; ++i) {
    Scene scene;
    ManyDraws many(scene);
    for (int d = 0; d < 1000; ++d) many.draw(d);
  }
}

// A child has the memory of a frame that workers of its parent were busy with.
TEST(Execution, GoesOnInAChild) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "ThreadSanitizer refuses threads in a child of a process that has some";
#endif
  const std::vector<uint32_t> expected = one_by_one(kDraws, 10);
  for (int at = 600; at < 700; at += 20) {
    Scene scene;
    ManyDraws many(scene);
    for (int i = 0; i < at; ++i) many.draw(i);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    for (int i = at; i < kDraws; ++i) many.draw(i);
    scene.frame.finish();
    const bool right = pixels_of(scene) == expected;
    if (child == 0) _exit(right ? 0 : 1);
    EXPECT_TRUE(right) << at;
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0) << at;
  }
}

// What is started is done by the workers alone, or by the caller at the end, or by both.
TEST(Workers, DoWhatIsStarted) {
  struct Work {
    std::atomic<int> left{1000}, done{0};
    static void task(void* context, int) {
      auto& work = *static_cast<Work*>(context);
      while (work.left.fetch_sub(1) > 0) ++work.done;
    }
  };
  for (int i = 0; i < 200; ++i) {
    Work first, second;
    start_on_workers(&Work::task, &first);
    run_on_workers(&Work::task, &second);  // another task, while the workers are busy or not
    EXPECT_EQ(second.done, 1000);
    if (i % 10 == 0) std::this_thread::sleep_for(1ms);
    finish_on_workers(&Work::task, &first);
    EXPECT_EQ(first.done, 1000);
  }
}

// Of several threads at once, which take turns with the workers.
TEST(Workers, DoEachPieceOnce) {
  const auto run = [] {
    for (size_t count = 0; count < 300; ++count) {
      std::vector<std::atomic<int>> done(count);
      run_pieces(count, [&done](size_t i) { ++done[i]; });
      for (size_t i = 0; i < count; ++i) ASSERT_EQ(done[i], 1) << i << " of " << count;
    }
  };
  std::thread other(run);
  run();
  other.join();
}

TEST(DrawList, KeepsItsDrawsInPlace) {
  DrawList list;
  std::vector<const DrawRecord*> places;
  for (uint32_t i = 0; i < DrawList::kMaxDraws; ++i) {
    DrawRecord draw;
    draw.first = i;
    list.push_back(draw);
    places.push_back(&list.back());
  }
  ASSERT_EQ(list.size(), DrawList::kMaxDraws);
  for (uint32_t i = 0; i < list.size(); ++i) {
    ASSERT_EQ(&list[i], places[i]);
    ASSERT_EQ(list[i].first, i);
  }
  list.clear();
  EXPECT_TRUE(list.empty());
}

}  // namespace
}  // namespace clearpipe::pipeline
