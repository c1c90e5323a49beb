// The page: one HTML file with its style, its script, its data and its pictures in it.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace clearpipe::conformance::report {

struct Page {
  std::string title;
  std::string subject = "clearpipe", reference = "Mesa";  // the columns
  std::vector<std::string> messages;                      // above all entries
  nlohmann::json entries = nlohmann::json::array();       // of entry.h
};

// Throws std::runtime_error when the file cannot be written.
void write_page(const Page& page, const std::string& path);

}  // namespace clearpipe::conformance::report
