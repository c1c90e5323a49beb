// The SHA-256 of what clearpipe draws: of the picture of every scene, and of what random streams
// draw, report and answer. The bits are the same on every processor, for every number of threads
// and in both forms of the fragment stages; so are these lines, `NAME SHA-256` each.
//
//   --scenes        every scene
//   --seeds A-B     random streams, both ends included
//   --write FILE    writes the lines
//   --expect FILE   prints the names whose lines differ from the file's, and fails if there are any
// SPDX-License-Identifier: MIT
#include <getopt.h>
#include <openssl/evp.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "conformance/random/generate.h"
#include "conformance/random/stream.h"
#include "conformance/scene.h"
#include "conformance/through_egl.h"

namespace clearpipe::conformance {

namespace {

using Digests = std::map<std::string, std::string>;

class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr);
  }

  template <class T>
  Sha256& add(const std::vector<T>& values) {
    EVP_DigestUpdate(context_.get(), values.data(), values.size() * sizeof(T));
    return *this;
  }

  std::string hexadecimal() {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned int size = 0;
    EVP_DigestFinal_ex(context_.get(), digest, &size);
    std::string text;
    for (unsigned int i = 0; i < size; ++i) {
      char byte[3];
      std::snprintf(byte, sizeof byte, "%02x", digest[i]);
      text += byte;
    }
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context_;
};

// The implementation for buffers of so many samples; one is open at a time in no order.
Implementation& subject(int samples) {
  static std::map<int, std::unique_ptr<Implementation>> open;
  std::unique_ptr<Implementation>& implementation = open[samples];
  if (!implementation) implementation = open_through_egl(samples);
  return *implementation;
}

void require_clearpipe() {
  const std::string name = subject(0).name();
  if (name.find("clearpipe") == std::string::npos) {
    throw std::runtime_error("the loader gave " + name);
  }
}

void add_scenes(Digests& digests) {
  for (const Scene& scene : scenes()) {
    Implementation& implementation = subject(scene.samples);
    const Gl& gl = implementation.begin(scene.width, scene.height);
    scene.draw(gl);
    const Image image = read_image(gl, scene.width, scene.height);
    implementation.end();
    digests[std::string(scene.topic) + "." + scene.name] = Sha256().add(image.pixels).hexadecimal();
  }
}

void add_seeds(unsigned first, unsigned last, Digests& digests) {
  for (unsigned seed = first; seed <= last; ++seed) {
    const random::Outcome outcome = random::replay(random::generate(seed), subject(0));
    digests["seed_" + std::to_string(seed)] =
        Sha256().add(outcome.image.pixels).add(outcome.errors).add(outcome.values).hexadecimal();
  }
}

Digests read_file(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + " cannot be read");
  Digests digests;
  for (std::string name, digest; file >> name >> digest;) digests[name] = digest;
  return digests;
}

void write_file(const Digests& digests, const std::string& path) {
  std::ofstream file(path);
  for (const auto& [name, digest] : digests) file << name << ' ' << digest << '\n';
  if (!file.flush()) throw std::runtime_error(path + " cannot be written");
}

// How many lines are not in both, printed one by one.
int count_differences(const Digests& digests, const Digests& expected) {
  int count = 0;
  const auto report = [&count](const std::string& name, const char* what) {
    std::printf("%s %s\n", what, name.c_str());
    ++count;
  };
  for (const auto& [name, digest] : digests) {
    const auto found = expected.find(name);
    if (found == expected.end()) {
      report(name, "new");
    } else if (found->second != digest) {
      report(name, "moved");
    }
  }
  for (const auto& [name, digest] : expected) {
    if (!digests.contains(name)) report(name, "gone");
  }
  return count;
}

int run(int argc, char** argv) {
  static const option options[] = {{"scenes", no_argument, nullptr, 's'},
                                   {"seeds", required_argument, nullptr, 'r'},
                                   {"write", required_argument, nullptr, 'w'},
                                   {"expect", required_argument, nullptr, 'e'},
                                   {}};
  Digests digests;
  std::string write, expect;
  unsigned first = 0, last = 0;
  for (int flag = 0; (flag = getopt_long(argc, argv, "", options, nullptr)) != -1;) {
    switch (flag) {
      case 's':
        add_scenes(digests);
        break;
      case 'r':
        if (std::sscanf(optarg, "%u-%u", &first, &last) != 2 || last < first) {
          throw std::runtime_error("--seeds takes FIRST-LAST");
        }
        add_seeds(first, last, digests);
        break;
      case 'w':
        write = optarg;
        break;
      case 'e':
        expect = optarg;
        break;
      default:
        throw std::runtime_error("digests.cpp lists the flags");
    }
  }
  if (digests.empty()) throw std::runtime_error("nothing was asked for");
  require_clearpipe();
  if (!write.empty()) write_file(digests, write);
  if (expect.empty()) return EXIT_SUCCESS;
  const int differences = count_differences(digests, read_file(expect));
  std::printf("%d of %zu differ\n", differences, digests.size());
  return differences == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

}  // namespace clearpipe::conformance

int main(int argc, char** argv) try {
  return clearpipe::conformance::run(argc, argv);
} catch (const std::exception& error) {
  std::fprintf(stderr, "digests: %s\n", error.what());
  return EXIT_FAILURE;
}
