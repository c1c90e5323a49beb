// SPDX-License-Identifier: MIT
//
// Models and pictures of the Debian package glmark2-data, read at run time. Its models are text: a
// letter or two and numbers on each line, v positions, vn normals, vt texture coordinates, vc
// colours, f three corners from 1, i one corner from 0. A vertex has the same number in all lists.
#pragma once

#include <GLES/gl.h>

#include <string>
#include <vector>

namespace bench {

struct Model {
  std::vector<GLfloat> positions, normals, coordinates, colours;  // 3, 3, 2, 3 numbers a vertex
  std::vector<GLuint> indices;

  size_t vertices() const { return positions.size() / 3; }
};

// A file of the package's folder models/. Normals that it does not have are made from its faces.
Model read_model(const std::string& name);

// Makes a texture with mipmaps of a PNG file of the package's folder textures/, binds it to the
// active unit and enables that.
void use_picture(const std::string& name);

}  // namespace bench
