// See saved.h. A file is three sequences and the picture's size, each with its length before it,
// as they lie in memory: it is read where it was written.
// SPDX-License-Identifier: MIT
#include "conformance/random/saved.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace clearpipe::conformance::random {

namespace {

std::string path_of(const std::string& folder, uint32_t seed) {
  return folder + "/" + std::to_string(seed);
}

template <class T>
void put(std::ofstream& file, const std::vector<T>& values) {
  const size_t count = values.size();
  file.write(reinterpret_cast<const char*>(&count), sizeof count);
  file.write(reinterpret_cast<const char*>(values.data()),
             static_cast<std::streamsize>(count * sizeof(T)));
}

template <class T>
std::vector<T> get(std::ifstream& file) {
  size_t count = 0;
  file.read(reinterpret_cast<char*>(&count), sizeof count);
  if (!file || count > (size_t{1} << 28)) return {};
  std::vector<T> values(count);
  file.read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(count * sizeof(T)));
  return values;
}

}  // namespace

void save(const Outcome& outcome, const std::string& folder, uint32_t seed) {
  std::filesystem::create_directories(folder);
  std::ofstream file(path_of(folder, seed), std::ios::binary);
  put(file, std::vector<int>{outcome.image.width, outcome.image.height});
  put(file, outcome.image.pixels);
  put(file, outcome.errors);
  put(file, outcome.values);
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path_of(folder, seed));
}

Outcome load(const std::string& folder, uint32_t seed) {
  std::ifstream file(path_of(folder, seed), std::ios::binary);
  const std::vector<int> size = get<int>(file);
  if (size.size() != 2) throw std::runtime_error("cannot read " + path_of(folder, seed));
  Outcome outcome;
  outcome.image = {size[0], size[1], get<uint8_t>(file)};
  outcome.errors = get<GLenum>(file);
  outcome.values = get<float>(file);
  if (!file) throw std::runtime_error(path_of(folder, seed) + " is cut short");
  return outcome;
}

}  // namespace clearpipe::conformance::random
