// See error_cases.h.
// SPDX-License-Identifier: MIT
#include "api/error_cases.h"

#include <regex>
#include <vector>

namespace clearpipe::api {

void ErrorTest::expect_refused(std::span<const ErrorCase> cases) {
  cases_ += cases.size();
  const std::vector<Answers> before = ask_all();
  for (const ErrorCase& c : cases) {
    c.call();
    EXPECT_EQ(glGetError(), c.error) << c.text;
    EXPECT_TRUE(ask_all() == before) << c.text;
    // "GL_... in gl...(...): which argument breaks which rule (section)"
    static const std::regex kRule(R"(GL_\w+ in gl\w+\(.*\): [^{}]+ \([^{}]+\))");
    EXPECT_TRUE(std::regex_match(message_, kRule)) << c.text << ": " << message_;
    message_.clear();
    EXPECT_ERROR(GL_NO_ERROR) << c.text;
  }
}

}  // namespace clearpipe::api
