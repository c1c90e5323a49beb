// SPDX-License-Identifier: MIT
//
// See model.h.
#include "bench/model.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
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
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r"), rest_.size()));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r"));
    rest_.remove_prefix(word.size());
    return word;
  }

  // False where there is no number left.
  template <class T>
  bool next(T& number) {
    const std::string_view word = next();
    return std::from_chars(word.data(), word.data() + word.size(), number).ec == std::errc();
  }

 private:
  std::string_view rest_;
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
  std::ifstream file(kFolder + "models/" + name);
  if (!file) fail("opening a model of the package glmark2-data");
  Model model;
  for (std::string text; std::getline(file, text);) {
    Words line(text);
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
