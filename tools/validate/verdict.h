// What the runs of a program say together: which frames agree, and what a person should know.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "conformance/compare.h"
#include "tools/validate/run.h"

namespace clearpipe::validate {

struct Frame {
  int number;
  int width, height;
  bool good;
  conformance::Agreement agreement;
  std::string complaint;  // why there is nothing to compare
};

struct Verdict {
  int status = 0;  // of clearpipe-validate
  std::vector<Frame> frames;
  std::vector<std::string> messages;
  nlohmann::json entries = nlohmann::json::array();  // of the page
};

conformance::Tolerance tolerance_of(const Options& options);

// Compares the captured frames, and explains how the runs ended.
Verdict judge(const Options& options, const Run& clearpipe, const Run& mesa);

// Adds what a second run on Mesa shows: whether Mesa agrees with itself.
void judge_repeat(const Options& options, const Run& mesa, const Run& again, Verdict& verdict);

}  // namespace clearpipe::validate
