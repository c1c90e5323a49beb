// One comparison as the report shows it. Its JSON form, with the pictures as data URIs in it, is
// written by whatever has compared, often several processes, and read when the page is made.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "conformance/compare.h"

namespace clearpipe::conformance::report {

// A second implementation that should draw what the reference draws.
struct Second {
  std::string name;       // empty: there is none
  std::string complaint;  // why there is no picture, if there is none
  std::string cause;      // of its difference from the reference, if it is known
  Image image;
  Agreement with_reference, with_subject;
};

struct Entry {
  std::string chapter, section;  // the page's headings
  std::string name;
  std::string note;  // what else a reader should know
  std::string reference_name;
  Image subject, reference;
  Tolerance tolerance;
  Agreement agreement;
  Second second;
};

nlohmann::json as_json(const Entry& entry);

// What stands in place of an entry that could not be compared, with the reason.
nlohmann::json as_json_without_pictures(const Entry& entry, const std::string& complaint);

// Writes FOLDER/NAME.json; throws std::runtime_error when it cannot.
void write_record(const nlohmann::json& record, const std::string& folder);

// All records of a folder, by chapter, section and name.
nlohmann::json read_records(const std::string& folder);

}  // namespace clearpipe::conformance::report
