// Makes the page of the records in a folder: conformance_report RECORDS PAGE.html
// Exits with 1 if a record is not good, 2 if there is none.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>
#include <filesystem>

#include "conformance/report/entry.h"
#include "conformance/report/page.h"

namespace {

using namespace clearpipe::conformance;

int run(const char* records, const char* path) {
  report::Page page;
  page.title = "clearpipe: scenes compared with Mesa";
  if (std::filesystem::is_directory(records)) page.entries = report::read_records(records);
  if (page.entries.empty()) {
    std::fprintf(stderr, "conformance_report: %s holds no records\n", records);
    return 2;
  }
  report::write_page(page, path);
  int bad = 0;
  for (const auto& entry : page.entries) bad += entry.at("good").get<bool>() ? 0 : 1;
  std::printf("%zu scenes, %d beyond their tolerance: %s\n", page.entries.size(), bad, path);
  return bad == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::fprintf(stderr, "usage: conformance_report RECORDS PAGE.html\n");
    return 2;
  }
  return run(argv[1], argv[2]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "conformance_report: %s\n", error.what());
  return 2;
}
