// See options.h.
// SPDX-License-Identifier: MIT
#include "tools/validate/options.h"

#include <getopt.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace clearpipe::validate {

namespace {

constexpr const char* kHelp =
    R"(clearpipe-validate [options] -- program arguments...

Runs an OpenGL ES 1 program, as it is, through libglvnd: on Mesa and on clearpipe. Compares the
frames that both draw, and writes a page that shows them. A frame ends at eglSwapBuffers; without a
window, at glFinish, glReadPixels or eglSwapBuffers after something has been drawn.

  --frames LIST         which frames are compared, from 1 (default 1,10,100); the program is ended
                        after the last
  --every N             every Nth frame instead, until the program ends
  --tolerance N         of a channel, in steps of 1/255 (default 2)
  --share PERCENT       of a frame's pixels that must be within it (default 99.5)
  --fixed-clock HZ      gives the program a clock that goes on by 1/HZ each frame
  --timeout SECONDS     ends a run that takes longer (default 120)
  --report FILE         where the page goes (default clearpipe-report.html)
  --json                prints the result for machines
  --manifest FILE       clearpipe's EGL vendor manifest (default: the installed or built one)
  --mesa-manifest FILE  Mesa's

Exit status: 0 when all frames are within tolerance, 1 when one is not, 2 when there is nothing to
compare: the program cannot be run, crashes, or draws no frame.
)";

[[noreturn]] void refuse(const std::string& what) {
  std::fprintf(stderr, "clearpipe-validate: %s; --help lists the options\n", what.c_str());
  std::exit(2);
}

double number(const char* flag, const char* text, double least) {
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  if (end == text || *end != '\0' || !(value >= least)) {
    refuse(std::string("--") + flag + " does not take " + text);
  }
  return value;
}

std::vector<int> list_of_frames(const char* text) {
  std::vector<int> frames;
  std::string rest = text;
  while (true) {
    const size_t comma = rest.find(',');
    frames.push_back(static_cast<int>(number("frames", rest.substr(0, comma).c_str(), 1)));
    if (comma == std::string::npos) break;
    rest = rest.substr(comma + 1);
  }
  std::sort(frames.begin(), frames.end());
  return frames;
}

}  // namespace

Options read_options(int argc, char** argv) {
  Options options;
  enum { kFrames = 1, kEvery, kTolerance, kShare, kClock, kTimeout, kReport, kJson, kManifest };
  enum { kMesaManifest = kManifest + 1, kHelpFlag };
  const option flags[] = {{"frames", required_argument, nullptr, kFrames},
                          {"every", required_argument, nullptr, kEvery},
                          {"tolerance", required_argument, nullptr, kTolerance},
                          {"share", required_argument, nullptr, kShare},
                          {"fixed-clock", required_argument, nullptr, kClock},
                          {"timeout", required_argument, nullptr, kTimeout},
                          {"report", required_argument, nullptr, kReport},
                          {"json", no_argument, nullptr, kJson},
                          {"manifest", required_argument, nullptr, kManifest},
                          {"mesa-manifest", required_argument, nullptr, kMesaManifest},
                          {"help", no_argument, nullptr, kHelpFlag},
                          {nullptr, 0, nullptr, 0}};
  // "+": what comes after the first word that is no option is the program's.
  for (int flag = 0; (flag = getopt_long(argc, argv, "+", flags, nullptr)) != -1;) {
    switch (flag) {
      case kFrames:
        options.frames = list_of_frames(optarg);
        break;
      case kEvery:
        options.every = static_cast<int>(number("every", optarg, 1));
        break;
      case kTolerance:
        options.tolerance = static_cast<int>(number("tolerance", optarg, 0));
        break;
      case kShare:
        options.share = number("share", optarg, 0);
        break;
      case kClock:
        options.clock = number("fixed-clock", optarg, 0.001);
        break;
      case kTimeout:
        options.timeout = static_cast<int>(number("timeout", optarg, 1));
        break;
      case kReport:
        options.report = optarg;
        break;
      case kJson:
        options.json = true;
        break;
      case kManifest:
        options.manifest = optarg;
        break;
      case kMesaManifest:
        options.mesa_manifest = optarg;
        break;
      case kHelpFlag:
        std::fputs(kHelp, stdout);
        std::exit(0);
      default:
        refuse("that is no option");
    }
  }
  options.program.assign(argv + optind, argv + argc);
  if (options.program.empty()) refuse("which program?");
  return options;
}

}  // namespace clearpipe::validate
