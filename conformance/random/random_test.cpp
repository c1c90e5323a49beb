// Random streams of commands on clearpipe and on the reference, compared: pictures, errors, and
// values asked for. A seed fails when more than 1% of its pixels differ by more than 8/255, or any
// error or value does; all together fail when less than 99.5% of the pixels are within 1/255.
// Prints one line for each group of features (groups.def).
//
//   --seeds A-B       which seeds, both included (default 0-1999); one number is one seed
//   --group NAME      only the seeds that have this group
//   --limit PERCENT   of a seed's pixels that may be beyond 8/255 (default 1)
//   --no-minimise     do not shorten the streams of failing seeds
//   --subject NAME    what is compared: clearpipe (default), Mesa's llvmpipe or softpipe, or gles:
//                     Mesa's own OpenGL ES 1.1 through EGL, on llvmpipe
//   --save FOLDER     writes what the subject drew, and compares with nothing
//   --against FOLDER  compares with what was saved there, not with a reference in this process
//
// A failing seed leaves its pictures in CLEARPIPE_OUTPUT (default random/ under the current
// folder), and, shortened, as the file of a scene. GoogleTest's flags and its shards
// (GTEST_TOTAL_SHARDS, GTEST_SHARD_INDEX) work on blocks of 32 seeds.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

#include "conformance/pictures.h"
#include "conformance/random/disagreement.h"
#include "conformance/random/generate.h"
#include "conformance/random/minimise.h"
#include "conformance/random/options.h"
#include "conformance/random/saved.h"
#include "conformance/random/source.h"
#include "conformance/random/statistics.h"
#include "conformance/through_egl.h"
#include "reference/osmesa_runner.h"

namespace clearpipe::conformance::random {

namespace {

Options options;
Statistics statistics;

Implementation& subject() {
  static const std::unique_ptr<Implementation> implementation =
      options.subject == "clearpipe" ? open_through_egl()
      : options.subject == "gles"    ? open_mesa_through_egl(0)
                                     : reference::open_osmesa(options.subject.c_str());
  return *implementation;
}

// What the subject must call itself.
std::string renderer() { return options.subject == "gles" ? "llvmpipe" : options.subject; }

Implementation& reference() {
  static const auto implementation = reference::open_osmesa();
  return *implementation;
}

// A logical operation makes a wholly other colour of one that was rounded the other way, for the
// whole of a flat triangle (reference/numerics.md, "The floor").
double limit_of(uint32_t seed) {
  constexpr double kLogicOpLimit = 5;
  const bool logic_op = groups_of(seed)[static_cast<size_t>(Group::logic_op)];
  return logic_op ? std::max(options.limit, kLogicOpLimit) : options.limit;
}

// Shortens the stream while it still fails, and writes what is left with its pictures.
std::string write_shortened(uint32_t seed) {
  const auto fails = [seed](const Stream& stream) {
    return !judge(replay(stream, subject()), replay(stream, reference()), limit_of(seed))
                .complaint.empty();
  };
  const Stream stream = minimise(generate(seed), fails);
  const std::string name = "seed_" + std::to_string(seed);
  const std::string picture =
      write_pictures(replay(stream, subject()).image, replay(stream, reference()).image,
                     options.output, name + "-shortened");
  std::ofstream file(options.output + "/" + name + ".cpp");
  file << as_scene_file(stream, name);
  return std::to_string(stream.commands.size()) + " commands are left of it: " + options.output +
         "/" + name + ".cpp, " + picture;
}

std::string list_of(const Groups& groups) {
  std::string list;
  for (size_t i = 0; i < kGroups; ++i) {
    if (!groups[i]) continue;
    if (!list.empty()) list += ' ';
    list += name_of(static_cast<Group>(i));
  }
  return list;
}

void run_seed(uint32_t seed) {
  const Stream stream = generate(seed);
  ASSERT_TRUE(reads_only_its_own(stream)) << "seed " << seed;
  const Outcome outcome = replay(stream, subject());
  ASSERT_NE(subject().name().find(renderer()), std::string::npos)
      << "the loader gave " << subject().name();
  if (!options.save.empty()) return save(outcome, options.save, seed);
  const bool live = options.against.empty();
  const Outcome expected = live ? replay(stream, reference()) : load(options.against, seed);
  ASSERT_EQ(outcome.image.pixels.size(), expected.image.pixels.size());

  const Verdict verdict = judge(outcome, expected, limit_of(seed));
  statistics.add(seed, verdict.agreement);
  if (verdict.complaint.empty()) return;
  const std::string picture =
      write_pictures(outcome.image, expected.image, options.output, "seed_" + std::to_string(seed));
  ADD_FAILURE() << "seed " << seed << " (" << list_of(groups_of(seed)) << "): " << verdict.complaint
                << "see " << picture;
  if (live && options.minimise) std::printf("%s\n", write_shortened(seed).c_str());
}

// A block of seeds is one test.
class Seeds : public testing::Test {
 public:
  Seeds(uint32_t first, uint32_t last) : first_(first), last_(last) {}
  void TestBody() override {
    for (uint32_t seed = first_; seed <= last_ && seed >= first_; ++seed) {
      const Groups groups = groups_of(seed);
      bool wanted = options.group.empty();
      for (size_t i = 0; i < kGroups; ++i) {
        wanted = wanted || (groups[i] && options.group == name_of(static_cast<Group>(i)));
      }
      if (wanted) run_seed(seed);
    }
  }

 private:
  uint32_t first_, last_;
};

constexpr uint32_t kBlock = 32;

void register_blocks() {
  for (uint32_t first = options.first; first <= options.last;) {
    const uint32_t last = first + std::min(kBlock - 1, options.last - first);
    testing::RegisterTest("Random", ("seeds_" + std::to_string(first)).c_str(), nullptr, nullptr,
                          __FILE__, __LINE__,
                          [first, last]() -> testing::Test* { return new Seeds(first, last); });
    if (last == options.last) break;
    first = last + 1;
  }
}

}  // namespace

int run(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  options = read_options(argc, argv);
  register_blocks();
  const int status = RUN_ALL_TESTS();
  statistics.print();
  constexpr double kLeastWithin1 = 0.995;
  if (statistics.within_1() < kLeastWithin1) {
    std::printf("too few pixels are within 1/255\n");
    return 1;
  }
  return status;
}

}  // namespace clearpipe::conformance::random

int main(int argc, char** argv) { return clearpipe::conformance::random::run(argc, argv); }
