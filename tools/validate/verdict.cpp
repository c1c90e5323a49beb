// See verdict.h.
// SPDX-License-Identifier: MIT
#include "tools/validate/verdict.h"

#include <algorithm>
#include <set>

#include "conformance/report/entry.h"

namespace clearpipe::validate {

namespace {

using conformance::Image;

// A page of all frames of a film would be too large to open.
constexpr size_t kMostEntries = 60;

std::string frames_text(int count) {
  return std::to_string(count) + (count == 1 ? " frame" : " frames");
}

// How a run without a picture came to that.
std::string explain_nothing(const std::string& name, const Run& run) {
  std::string text = name + ": no frame was drawn; the program " + run.ending + ". ";
  if (!run.finished) {
    text += "It stopped before its first frame.";
  } else if (run.frames > 0) {
    text = name + ": the program drew " + frames_text(run.frames) + " and " + run.ending +
           ", before the first that was asked for (--frames, --every).";
  } else {
    text +=
        "It never called eglSwapBuffers, and, without a window, neither glFinish nor glReadPixels "
        "after drawing; or it does not use EGL with OpenGL ES.";
  }
  if (!run.output.empty()) text += " It printed last: " + run.output;
  return text;
}

void explain_ending(const std::string& name, const Run& run, Verdict& verdict) {
  if (!run.error.empty()) verdict.messages.push_back(name + ": " + run.error);
  if (run.files.empty()) {
    verdict.messages.push_back(explain_nothing(name, run));
  } else if (!run.finished) {
    verdict.messages.push_back(name + ": the program " + run.ending + " after " +
                               frames_text(run.frames) +
                               (run.output.empty() ? "" : ". It printed last: " + run.output));
  }
  for (const auto& [texture, frame] : run.undefined) {
    verdict.messages.push_back(
        name + ": frame " + std::to_string(frame) + " uses texture " + std::to_string(texture) +
        ", whose size was given by glTexImage2D, but whose contents never were: they are "
        "undefined (3.7.1), and pictures that show them need not agree");
  }
  if (!run.version.empty() && run.version.find("OpenGL ES-C") != 0) {
    verdict.messages.push_back(name + ": the program draws with " + run.version +
                               "; clearpipe implements OpenGL ES 1.1");
  }
  if (run.samples > 0) {
    verdict.messages.push_back(
        name + ": the buffers have " + std::to_string(run.samples) +
        " samples a pixel; Mesa reads one of them where the specification has their mean (4.1.10), "
        "so edges differ");
  }
}

Frame compare_frame(const Options& options, int number, const Image& image, const Image& expected) {
  const conformance::Tolerance tolerance = tolerance_of(options);
  Frame frame{number, image.width, image.height, false, {}, {}};
  if (image.width != expected.width || image.height != expected.height) {
    frame.complaint = "clearpipe drew " + std::to_string(image.width) + "x" +
                      std::to_string(image.height) + " pixels, Mesa " +
                      std::to_string(expected.width) + "x" + std::to_string(expected.height);
    return frame;
  }
  frame.agreement = compare(image, expected, tolerance);
  frame.good = holds(frame.agreement, tolerance);
  return frame;
}

conformance::report::Entry entry_of(const Options& options, const Frame& frame, const Run& mesa) {
  conformance::report::Entry entry;
  entry.chapter = "Frames";
  entry.name = "frame " + std::to_string(frame.number);
  entry.reference_name = mesa.renderer;
  entry.tolerance = tolerance_of(options);
  entry.agreement = frame.agreement;
  return entry;
}

// The worst frames, in their order.
std::set<int> frames_to_show(std::vector<Frame> frames) {
  std::stable_sort(frames.begin(), frames.end(), [](const Frame& a, const Frame& b) {
    return a.good != b.good ? b.good : a.agreement.near < b.agreement.near;
  });
  std::set<int> numbers;
  for (const Frame& frame : frames) {
    if (numbers.size() < kMostEntries) numbers.insert(frame.number);
  }
  return numbers;
}

void add_entries(const Options& options, const Run& clearpipe, const Run& mesa, Verdict& verdict) {
  const std::set<int> shown = frames_to_show(verdict.frames);
  for (const Frame& frame : verdict.frames) {
    if (shown.count(frame.number) == 0) continue;
    conformance::report::Entry entry = entry_of(options, frame, mesa);
    if (frame.complaint.empty()) {
      entry.subject = read_frame(clearpipe.files.at(frame.number));
      entry.reference = read_frame(mesa.files.at(frame.number));
      verdict.entries.push_back(as_json(entry));
    } else {
      verdict.entries.push_back(as_json_without_pictures(entry, frame.complaint));
    }
  }
  if (shown.size() < verdict.frames.size()) {
    verdict.messages.push_back("the " + std::to_string(shown.size()) + " worst of " +
                               frames_text(static_cast<int>(verdict.frames.size())) + " are shown");
  }
}

}  // namespace

conformance::Tolerance tolerance_of(const Options& options) {
  const double share = options.share / 100;
  return {options.tolerance, share, options.tolerance, share, nullptr};
}

Verdict judge(const Options& options, const Run& clearpipe, const Run& mesa) {
  Verdict verdict;
  explain_ending("Mesa", mesa, verdict);
  explain_ending("clearpipe", clearpipe, verdict);
  for (const auto& [number, path] : clearpipe.files) {
    const auto expected = mesa.files.find(number);
    if (expected == mesa.files.end()) continue;
    verdict.frames.push_back(
        compare_frame(options, number, read_frame(path), read_frame(expected->second)));
  }
  add_entries(options, clearpipe, mesa, verdict);
  if (clearpipe.finished && mesa.finished && clearpipe.files.size() != mesa.files.size()) {
    verdict.messages.push_back("the program drew " + frames_text(mesa.frames) + " on Mesa and " +
                               std::to_string(clearpipe.frames) + " on clearpipe");
    verdict.status = 1;
  }
  for (const Frame& frame : verdict.frames) {
    if (!frame.good) verdict.status = 1;
  }
  // A program may run until it is ended; one that crashes has not been compared.
  const auto crashed = [](const Run& run) {
    return run.files.empty() || run.ending.find("signal") != std::string::npos;
  };
  if (verdict.frames.empty() || crashed(mesa) || crashed(clearpipe)) verdict.status = 2;
  return verdict;
}

void judge_repeat(const Options& options, const Run& mesa, const Run& again, Verdict& verdict) {
  std::string differing;
  for (const auto& [number, path] : mesa.files) {
    const auto other = again.files.find(number);
    if (other == again.files.end()) continue;
    if (compare_frame(options, number, read_frame(other->second), read_frame(path)).good) continue;
    if (!differing.empty()) differing += ", ";
    differing += std::to_string(number);
  }
  if (differing.empty()) return;
  verdict.messages.push_back(
      "two runs on Mesa differ too (frame " + differing +
      "): the program's pictures depend on the time, on chance, or on memory that it has not set" +
      (options.clock > 0 ? "" : "; --fixed-clock HZ makes its time steady"));
}

}  // namespace clearpipe::validate
