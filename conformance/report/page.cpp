// See page.h. The parts of the page are the files page.html, style.css, view.js and compare.js of
// this folder, which the build puts into page_parts.
// SPDX-License-Identifier: MIT
#include "conformance/report/page.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "conformance/report/page_parts.h"

namespace clearpipe::conformance::report {

namespace {

// The text with each occurrence of `what` replaced.
std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) {
    text.replace(at, what.size(), by);
  }
  return text;
}

}  // namespace

void write_page(const Page& page, const std::string& path) {
  const nlohmann::json data = {{"title", page.title},
                               {"subject", page.subject},
                               {"reference", page.reference},
                               {"messages", page.messages},
                               {"entries", page.entries}};
  // Inside a script element nothing may look like its end; what is not UTF-8 is replaced.
  const std::string text =
      replaced(data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), "</", "<\\/");
  std::string html(parts::kPage);
  html = replaced(std::move(html), "/* style */", parts::kStyle);
  html = replaced(std::move(html), "/* script */",
                  std::string(parts::kCompare) + std::string(parts::kView));
  html = replaced(std::move(html), "/* data */", text);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder);
  std::ofstream file(path);
  file << html;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path);
}

}  // namespace clearpipe::conformance::report
