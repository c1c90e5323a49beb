// Rasterization state (3.3 to 3.5), vertex arrays and drawing (2.6 to 2.9).
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstring>

#include "conformance/random/generator.h"

namespace clearpipe::conformance::random {

namespace {

// A type's bytes of a number; the normalized types of colours map [0, 1] to their range.
void append(std::vector<uint8_t>& bytes, GLenum type, float value) {
  const auto put = [&](auto number) {
    const size_t at = bytes.size();
    bytes.resize(at + sizeof number);
    std::memcpy(bytes.data() + at, &number, sizeof number);
  };
  switch (type) {
    case GL_BYTE:
      return put(static_cast<int8_t>(std::lrint(value)));
    case GL_UNSIGNED_BYTE:
      return put(static_cast<uint8_t>(std::lrint(std::fmin(std::fmax(value, 0), 1) * 255)));
    case GL_SHORT:
      return put(static_cast<int16_t>(std::lrint(value)));
    case GL_FIXED:
      return put(fixed(value));
    default:
      return put(value);
  }
}

struct Source {
  Data data;            // empty: in a buffer object
  uint32_t offset = 0;  // into that
  GLsizei stride = 0;
};

// The memory of an array, tight or with gaps, the client's or a buffer object's.
Source place(Generator& g, GLint size, GLenum type, const std::vector<float>& values) {
  const bool varied = g.has(Group::arrays);
  Source source;
  std::vector<uint8_t> element, bytes;
  const size_t gap = varied && g.chance(0.4f) ? static_cast<size_t>(g.integer(0, 3)) * 4 : 0;
  const size_t lead = varied && g.chance(0.3f) ? static_cast<size_t>(g.integer(1, 5)) * 4 : 0;
  for (size_t i = 0; i < values.size(); i += static_cast<size_t>(size)) {
    element.clear();
    for (GLint c = 0; c < size; ++c) append(element, type, values[i + static_cast<size_t>(c)]);
    if (gap != 0) {
      element.resize((element.size() + 3) / 4 * 4 + gap);
      source.stride = static_cast<GLsizei>(element.size());
    }
    bytes.insert(bytes.end(), element.begin(), element.end());
  }
  if (!varied || g.chance(0.5f)) {
    if (varied) to::BindBuffer{g, GL_ARRAY_BUFFER, 0};
    source.data.bytes = std::move(bytes);
    return source;
  }
  bytes.insert(bytes.begin(), lead, 0xee);
  source.offset = static_cast<uint32_t>(lead);
  to::BindBuffer{g, GL_ARRAY_BUFFER, g.names++};
  const GLenum usage = g.one_of<GLenum>({GL_STATIC_DRAW, GL_DYNAMIC_DRAW});
  if (g.chance(0.3f)) {
    to::BufferData{g, GL_ARRAY_BUFFER, bytes.size() + 8, 0, usage};
    to::BufferSubData{g, GL_ARRAY_BUFFER, 0, bytes.size(), Data{bytes}};
  } else {
    to::BufferData{g, GL_ARRAY_BUFFER, bytes.size(), Data{bytes}, usage};
  }
  return source;
}

// Calls a ...Pointer command with the memory of an array.
template <class Command, class... Leading>
void point(Generator& g, const Source& source, Leading... leading) {
  if (source.data.bytes.empty()) {
    Command{g, leading..., source.stride, source.offset};
  } else {
    Command{g, leading..., source.stride, source.data};
  }
}

void set_positions(Generator& g, int count, GLenum type, GLint size) {
  const bool whole = type == GL_BYTE || type == GL_SHORT;  // scaled by draw_something
  // Mesa does not divide by w for the distance to a light (numerics.md).
  const bool lit = g.has(Group::lighting) || g.has(Group::two_sided);
  std::vector<float> values;
  for (int i = 0; i < count; ++i) {
    const float x = g.perspective ? g.uniform(-3, 3) : g.uniform(-20, 148);
    const float y = g.perspective ? g.uniform(-3, 3) : g.uniform(-20, 148);
    const float z = g.perspective ? g.uniform(-8, g.chance(0.1f) ? 0.5f : -1.3f)
                                  : g.uniform(-0.95f, 0.95f) * (g.chance(0.05f) ? 2.0f : 1.0f);
    const float w = lit ? 1.0f : g.uniform(0.7f, 1.5f);
    const float scale = whole ? 127.0f / (g.perspective ? 8.0f : 148.0f) : 1.0f;
    const float position[4] = {x * scale, y * scale, z * scale, w};
    for (GLint c = 0; c < size; ++c) {
      values.push_back(position[c] * (size == 4 && c < 3 && !whole ? w : 1.0f));
    }
  }
  point<to::VertexPointer>(g, place(g, size, type, values), size, type);
  to::EnableClientState{g, GL_VERTEX_ARRAY};
}

void set_attributes(Generator& g, int count) {
  const bool varied = g.has(Group::arrays);
  if (g.chance(0.85f)) {
    const GLenum type =
        varied ? g.one_of<GLenum>({GL_UNSIGNED_BYTE, GL_FLOAT, GL_FIXED}) : GL_UNSIGNED_BYTE;
    point<to::ColorPointer>(g, place(g, 4, type, g.several(count * 4, -0.1f, 1.1f)), 4, type);
    to::EnableClientState{g, GL_COLOR_ARRAY};
  } else {
    to::DisableClientState{g, GL_COLOR_ARRAY};
  }
  if (g.has(Group::lighting) || g.has(Group::two_sided)) {
    // Not GL_BYTE and GL_SHORT: by table 2.7 they are (2c + 1) / 255 and (2c + 1) / 65535, in Mesa
    // c / 127 and c / 32767 (reference/numerics.md).
    const GLenum type = varied ? g.one_of<GLenum>({GL_FLOAT, GL_FIXED}) : GL_FLOAT;
    std::vector<float> normals = g.several(count * 3, -1, 1);
    // Mostly towards the eye.
    for (size_t i = 2; i < normals.size(); i += 3) normals[i] += 0.7f;
    point<to::NormalPointer>(g, place(g, 3, type, normals), type);
    to::EnableClientState{g, GL_NORMAL_ARRAY};
  }
  for (int unit = 0; unit < g.units; ++unit) {
    const GLenum type = varied ? g.one_of<GLenum>({GL_FLOAT, GL_FIXED, GL_FLOAT}) : GL_FLOAT;
    const GLint size = g.has(Group::texture_matrix) ? g.integer(2, 4) : 2;
    std::vector<float> values = g.several(count * size, -1.3f, 2.3f);
    // Projective coordinates, far from a division by zero.
    if (size == 4) {
      for (size_t i = 3; i < values.size(); i += 4) values[i] = g.uniform(0.7f, 1.6f);
    }
    to::ClientActiveTexture{g, GL_TEXTURE0 + unit};
    point<to::TexCoordPointer>(g, place(g, size, type, values), size, type);
    to::EnableClientState{g, GL_TEXTURE_COORD_ARRAY};
  }
}

GLenum some_mode(Generator& g) {
  if (g.has(Group::points) || g.has(Group::sprites)) return GL_POINTS;
  if (g.has(Group::lines)) return g.one_of<GLenum>({GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP});
  if (g.has(Group::primitives)) return static_cast<GLenum>(g.integer(GL_POINTS, GL_TRIANGLE_FAN));
  return g.one_of<GLenum>({GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN});
}

void draw_indexed(Generator& g, GLenum mode, int vertices) {
  const int count = g.integer(1, vertices * 2);
  std::vector<uint8_t> bytes;
  const bool wide = g.chance(0.6f);
  for (int i = 0; i < count; ++i) {
    bytes.push_back(static_cast<uint8_t>(g.integer(0, vertices - 1)));
    if (wide) bytes.push_back(0);  // little endian; there are fewer than 256 vertices
  }
  const GLenum type = wide ? GL_UNSIGNED_SHORT : GL_UNSIGNED_BYTE;
  if (g.chance(0.5f)) {
    to::BindBuffer{g, GL_ELEMENT_ARRAY_BUFFER, 0};
    to::DrawElements{g, mode, count, type, Data{bytes}};
    return;
  }
  const uint32_t lead = static_cast<uint32_t>(g.integer(0, 3)) * 2;
  bytes.insert(bytes.begin(), lead, 0);
  to::BindBuffer{g, GL_ELEMENT_ARRAY_BUFFER, g.names++};
  to::BufferData{g, GL_ELEMENT_ARRAY_BUFFER, bytes.size(), Data{bytes}, GL_STATIC_DRAW};
  to::DrawElements{g, mode, count, type, lead};
}

}  // namespace

void set_rasterization(Generator& g) {
  if (g.has(Group::points) || g.has(Group::sprites) || g.has(Group::primitives)) {
    to::PointSize{g, g.uniform(0.6f, 24)};
    if (g.chance(0.3f)) {
      // The constant only: Mesa takes the eye's z for the distance (numerics.md).
      to::PointParameterfv{g, GL_POINT_DISTANCE_ATTENUATION, floats({g.uniform(0.2f, 2), 0, 0})};
      to::PointParameterf{g, GL_POINT_SIZE_MIN, g.uniform(1, 4)};
      to::PointParameterf{g, GL_POINT_SIZE_MAX, g.uniform(5, 40)};
    }
  }
  if (g.has(Group::sprites)) {
    to::Enable{g, GL_POINT_SPRITE_OES};
    to::TexEnvi{g, GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, g.chance(0.85f) ? 1 : 0};
  }
  if (g.has(Group::lines)) to::LineWidth{g, g.chance(0.5f) ? 1.0f : g.uniform(0.4f, 9)};
  if (g.has(Group::culling)) {
    to::Enable{g, GL_CULL_FACE};
    to::CullFace{g, g.one_of<GLenum>({GL_FRONT, GL_BACK, GL_BACK, GL_FRONT_AND_BACK})};
    to::FrontFace{g, g.one_of<GLenum>({GL_CW, GL_CCW})};
  }
  if (g.has(Group::polygon_offset)) {
    to::Enable{g, GL_POLYGON_OFFSET_FILL};
    to::PolygonOffset{g, g.uniform(-3, 3), g.uniform(-4000, 4000)};
  }
}

void draw_something(Generator& g) {
  const GLenum mode = some_mode(g);
  const int count = mode == GL_POINTS ? g.integer(1, 24) : g.integer(3, 21);
  const GLenum type =
      g.has(Group::arrays) ? g.one_of<GLenum>({GL_FLOAT, GL_FIXED, GL_SHORT, GL_BYTE}) : GL_FLOAT;
  // Whole numbers have no random fractions: the matrix has.
  const bool whole = type == GL_SHORT || type == GL_BYTE;
  if (whole) {
    to::MatrixMode{g, GL_MODELVIEW};
    to::PushMatrix{g};
    const float scale = (g.perspective ? 8.0f : 148.0f) / 127.0f;
    to::Rotatef{g, g.uniform(-20, 20), 0, 0, 1};
    to::Scalef{g, scale * g.uniform(0.9f, 1.1f), scale * g.uniform(0.9f, 1.1f), scale};
    // Normals grow as positions shrink, and a power of a long one is more than a float can hold.
    to::Enable{g, GL_NORMALIZE};
  }
  set_positions(g, count, type, whole ? g.integer(2, 3) : g.integer(3, 4));
  set_attributes(g, count);
  if (g.has(Group::points) && g.chance(0.5f)) {
    // One array of sizes for the first draw.
    to::BindBuffer{g, GL_ARRAY_BUFFER, 0};
    to::PointSizePointerOES{g, GL_FLOAT, 0, floats(g.several(count, 0.6f, 30))};
    to::EnableClientState{g, GL_POINT_SIZE_ARRAY_OES};
  }
  if (g.has(Group::arrays) && g.chance(0.5f)) {
    draw_indexed(g, mode, count);
  } else {
    const int first = g.chance(0.7f) ? 0 : g.integer(0, 2);
    to::DrawArrays{g, mode, first, count - first};
  }
  if (g.has(Group::points)) to::DisableClientState{g, GL_POINT_SIZE_ARRAY_OES};
  if (whole) to::PopMatrix{g};
}

void draw_over_all(Generator& g, float z) {
  to::BindBuffer{g, GL_ARRAY_BUFFER, 0};
  to::VertexPointer{g, 3, GL_FLOAT, 0, floats({-1.1f, -1.2f, z, 3.3f, -1.2f, z, -1.1f, 3.1f, z})};
  to::DrawArrays{g, GL_TRIANGLES, 0, 3};
}

}  // namespace clearpipe::conformance::random
