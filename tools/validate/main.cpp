// clearpipe-validate: runs a program on Mesa and on clearpipe, compares the frames, and writes the
// page that shows them. options.cpp has the help.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <stdexcept>

#include "conformance/report/page.h"
#include "tools/validate/options.h"
#include "tools/validate/places.h"
#include "tools/validate/run.h"
#include "tools/validate/verdict.h"

namespace clearpipe::validate {

namespace {

// Frames lie here until they are compared.
class Folder {
 public:
  Folder() {
    std::string name = std::filesystem::temp_directory_path() / "clearpipe-validate-XXXXXX";
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string command_line(const Options& options) {
  std::string text;
  for (const std::string& word : options.program) {
    if (!text.empty()) text += ' ';
    text += word;
  }
  return text;
}

nlohmann::json summary(const Run& run) {
  return {{"renderer", run.renderer}, {"frames", run.frames}, {"ending", run.ending}};
}

void print_json(const Options& options, const Verdict& verdict, const Run& clearpipe,
                const Run& mesa) {
  nlohmann::json frames = nlohmann::json::array();
  for (const Frame& frame : verdict.frames) {
    frames.push_back({{"frame", frame.number},
                      {"width", frame.width},
                      {"height", frame.height},
                      {"within_tolerance", frame.good},
                      {"equal", frame.agreement.equal},
                      {"within_1", frame.agreement.within_1},
                      {"within_n", frame.agreement.near},
                      {"largest", frame.agreement.largest},
                      {"complaint", frame.complaint}});
  }
  const nlohmann::json result = {{"program", options.program},
                                 {"status", verdict.status},
                                 {"tolerance", options.tolerance},
                                 {"share", options.share},
                                 {"frames", frames},
                                 {"messages", verdict.messages},
                                 {"clearpipe", summary(clearpipe)},
                                 {"mesa", summary(mesa)},
                                 {"report", options.report}};
  // What a program prints need not be UTF-8.
  std::puts(result.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
}

void print(const Options& options, const Verdict& verdict) {
  for (const Frame& frame : verdict.frames) {
    std::printf(
        "frame %d: %s%s\n", frame.number,
        frame.complaint.empty() ? describe(frame.agreement).c_str() : frame.complaint.c_str(),
        frame.good ? "" : "; beyond tolerance");
  }
  for (const std::string& message : verdict.messages) std::printf("%s\n", message.c_str());
  std::printf("report: %s\n", options.report.c_str());
}

int validate(const Options& options) {
  const Implementation clearpipe = {
      "clearpipe", options.manifest.empty() ? clearpipe_manifest() : options.manifest, false};
  const Implementation mesa = {
      "Mesa", options.mesa_manifest.empty() ? mesa_manifest() : options.mesa_manifest, true};
  const Folder folder;
  const Run expected = run(options, mesa, folder.path() + "/mesa");
  const Run result = run(options, clearpipe, folder.path() + "/clearpipe");
  if (!result.renderer.empty() && result.renderer.find("clearpipe") == std::string::npos) {
    throw std::runtime_error("the loader gave " + result.renderer + " in clearpipe's place");
  }
  Verdict verdict = judge(options, result, expected);
  if (verdict.status == 1) {
    const Run again = run(options, {"Mesa again", mesa.manifest, true}, folder.path() + "/again");
    judge_repeat(options, expected, again, verdict);
  }

  conformance::report::Page page;
  page.title = "clearpipe-validate: " + command_line(options);
  page.messages = verdict.messages;
  page.entries = verdict.entries;
  write_page(page, options.report);
  if (options.json) {
    print_json(options, verdict, result, expected);
  } else {
    print(options, verdict);
  }
  return verdict.status;
}

}  // namespace

}  // namespace clearpipe::validate

int main(int argc, char** argv) try {
  return clearpipe::validate::validate(clearpipe::validate::read_options(argc, argv));
} catch (const std::exception& error) {
  std::fprintf(stderr, "clearpipe-validate: %s\n", error.what());
  return 2;
}
