// SPDX-License-Identifier: MIT
//
// See model.h.
#include "bench/model.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "bench/extras.h"
#include "bench/shapes.h"

namespace bench {

namespace {

const std::string kFolder = "/usr/share/glmark2/";

// What is left of a line, word by word; streams take most of a start with a large model.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  std::string_view next() {
    while (!rest_.empty() && is_space(rest_[0])) rest_.remove_prefix(1);
    size_t length = 0;
    while (length < rest_.size() && !is_space(rest_[length])) ++length;
    const std::string_view word = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return word;
  }

  // False where there is no number left.
  template <class T>
  bool next(T& number) {
    const std::string_view word = next();
    return std::from_chars(word.data(), word.data() + word.size(), number).ec == std::errc();
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

  std::string_view rest_;
};

// The text of a file, where the system has it: reading it would cost a copy and memory for that.
class MappedFile {
 public:
  explicit MappedFile(const std::string& path) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat status {};
    if (file < 0 || fstat(file, &status) != 0) fail("opening a model of the package glmark2-data");
    size_ = size_t(status.st_size);
    memory_ = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE | MAP_POPULATE, file, 0);
    close(file);
    if (memory_ == MAP_FAILED) fail("reading a model");
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  ~MappedFile() { munmap(memory_, size_); }

  std::string_view text() const { return {static_cast<const char*>(memory_), size_}; }

 private:
  void* memory_ = nullptr;
  size_t size_ = 0;
};

void add_numbers(Words& line, int count, std::vector<GLfloat>& list) {
  GLfloat value = 0;
  for (int i = 0; i < count && line.next(value); ++i) list.push_back(value);
}

// Each vertex gets the sum of its faces' normals, which are as long as the faces are large.
void make_normals(Model& model) {
  model.normals.assign(model.positions.size(), 0);
  for (size_t i = 0; i + 2 < model.indices.size(); i += 3) {
    const GLfloat* p[3];
    for (size_t k = 0; k < 3; ++k) p[k] = &model.positions[3 * model.indices[i + k]];
    const GLfloat a[] = {p[1][0] - p[0][0], p[1][1] - p[0][1], p[1][2] - p[0][2]};
    const GLfloat b[] = {p[2][0] - p[0][0], p[2][1] - p[0][1], p[2][2] - p[0][2]};
    for (size_t k = 0; k < 3; ++k) {
      GLfloat* const normal = &model.normals[3 * model.indices[i + k]];
      for (size_t axis = 0; axis < 3; ++axis) {
        const size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
        normal[axis] += a[next] * b[last] - a[last] * b[next];
      }
    }
  }
  for (size_t v = 0; v < model.normals.size(); v += 3) {
    GLfloat* const n = &model.normals[v];
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int axis = 0; axis < 3 && length > 0; ++axis) n[axis] /= length;
  }
}

}  // namespace

Model read_model(const std::string& name) {
  const MappedFile file(kFolder + "models/" + name);
  const std::string_view text = file.text();
  Model model;
  // A vertex takes some thirty characters or more.
  for (std::vector<GLfloat>* const list : {&model.positions, &model.normals}) {
    list->reserve(text.size() / 20);
  }
  model.indices.reserve(text.size() / 10);
  for (size_t start = 0; start < text.size();) {
    const size_t end = std::min(text.find('\n', start), text.size());
    Words line(text.substr(start, end - start));
    start = end + 1;
    const std::string_view kind = line.next();
    if (kind == "v") add_numbers(line, 3, model.positions);
    if (kind == "vn") add_numbers(line, 3, model.normals);
    if (kind == "vt") add_numbers(line, 2, model.coordinates);
    if (kind == "vc") add_numbers(line, 3, model.colours);
    GLuint corner = 0;
    while ((kind == "f" || kind == "i") && line.next(corner)) {
      model.indices.push_back(kind == "f" ? corner - 1 : corner);
    }
  }
  for (const GLuint index : model.indices) {
    if (index >= model.vertices()) fail("reading a model: a corner without a position");
  }
  if (model.normals.size() != model.positions.size()) make_normals(model);
  return model;
}

void use_picture(const std::string& name) {
  const Picture picture = load_png(kFolder + "textures/" + name);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, picture.width, picture.height, 0, GL_RGBA,
               GL_UNSIGNED_BYTE, picture.pixels.data());
  glEnable(GL_TEXTURE_2D);
}

}  // namespace bench
