// Vertex arrays of the types that only ES knows (2.8, table 2.4): GL_FIXED everywhere, GL_BYTE
// positions and texture coordinates, and the array of point sizes. All arrays are shadowed here;
// what the desktop cannot fetch is converted to floats when something is drawn.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <numeric>
#include <vector>

#include "reference/desktop.h"
#include "reference/gles1_on_gl.h"

namespace clearpipe::reference {

namespace {

constexpr int kUnits = 8;

struct Array {
  bool enabled = false;
  GLint size = 4;
  GLenum type = GL_FLOAT;
  GLsizei stride = 0;
  const void* pointer = nullptr;
  GLuint buffer = 0;
};

struct Arrays {
  Array vertex, normal, color, point_size;
  std::array<Array, kUnits> texcoord;
  int client_unit = 0;
  GLuint array_buffer = 0, element_buffer = 0;
};

Arrays arrays;

size_t size_of(GLenum type) {
  switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
      return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
      return 2;
    default:
      return 4;
  }
}

// The bytes of a buffer object, or the client's memory; `storage` keeps the former.
const std::byte* bytes_of(GLenum target, GLuint buffer, const void* pointer,
                          std::vector<std::byte>& storage) {
  if (buffer == 0) return static_cast<const std::byte*>(pointer);
  GLint size = 0;
  desktop.BindBuffer(target, buffer);
  desktop.GetBufferParameteriv(target, GL_BUFFER_SIZE, &size);
  storage.resize(static_cast<size_t>(size));
  desktop_only.GetBufferSubData(target, 0, size, storage.data());
  desktop.BindBuffer(target,
                     target == GL_ARRAY_BUFFER ? arrays.array_buffer : arrays.element_buffer);
  return storage.data() + reinterpret_cast<uintptr_t>(pointer);
}

float component(const std::byte* at, GLenum type) {
  const auto read = [&](auto value) {
    std::memcpy(&value, at, sizeof value);
    return value;
  };
  switch (type) {
    case GL_BYTE:
      return read(int8_t());
    case GL_SHORT:
      return read(int16_t());
    case GL_FIXED:
      return from_fixed(read(GLfixed()));
    default:
      return read(0.0f);
  }
}

// The first `count` vertices of an array as floats.
std::vector<float> as_floats(const Array& array, size_t count) {
  std::vector<std::byte> storage;
  const std::byte* bytes = bytes_of(GL_ARRAY_BUFFER, array.buffer, array.pointer, storage);
  const size_t size = static_cast<size_t>(array.size);
  const size_t stride =
      array.stride != 0 ? static_cast<size_t>(array.stride) : size * size_of(array.type);
  std::vector<float> result(count * size);
  for (size_t i = 0; i < count; ++i) {
    for (size_t c = 0; c < size; ++c) {
      result[i * size + c] = component(bytes + i * stride + c * size_of(array.type), array.type);
    }
  }
  return result;
}

std::vector<GLuint> indices_of(GLsizei count, GLenum type, const void* pointer) {
  std::vector<std::byte> storage;
  const std::byte* bytes =
      bytes_of(GL_ELEMENT_ARRAY_BUFFER, arrays.element_buffer, pointer, storage);
  std::vector<GLuint> result(static_cast<size_t>(count));
  for (size_t i = 0; i < result.size(); ++i) {
    GLuint index = 0;
    std::memcpy(&index, bytes + i * size_of(type), size_of(type));  // little endian, as Mesa's
    result[i] = index;
  }
  return result;
}

bool desktop_lacks(const Array& array, bool bytes_are_known) {
  if (!array.enabled) return false;
  return array.type == GL_FIXED || (array.type == GL_BYTE && !bytes_are_known);
}

bool anything_to_convert() {
  return desktop_lacks(arrays.vertex, false) || desktop_lacks(arrays.normal, true) ||
         desktop_lacks(arrays.color, true) ||
         std::any_of(arrays.texcoord.begin(), arrays.texcoord.end(),
                     [](const Array& array) { return desktop_lacks(array, false); });
}

// Gives the desktop floats for the arrays it cannot fetch while it lives.
class Converted {
 public:
  explicit Converted(size_t vertices) {
    if (!anything_to_convert()) return;
    desktop.BindBuffer(GL_ARRAY_BUFFER, 0);
    if (desktop_lacks(arrays.vertex, false)) {
      desktop.VertexPointer(arrays.vertex.size, GL_FLOAT, 0, keep(arrays.vertex, vertices));
    }
    if (desktop_lacks(arrays.normal, true)) {
      desktop.NormalPointer(GL_FLOAT, 0, keep(arrays.normal, vertices));
    }
    if (desktop_lacks(arrays.color, true)) {
      desktop.ColorPointer(arrays.color.size, GL_FLOAT, 0, keep(arrays.color, vertices));
    }
    for (int unit = 0; unit < kUnits; ++unit) {
      const Array& array = arrays.texcoord[unit];
      if (!desktop_lacks(array, false)) continue;
      desktop.ClientActiveTexture(GL_TEXTURE0 + unit);
      desktop.TexCoordPointer(array.size, GL_FLOAT, 0, keep(array, vertices));
    }
    desktop.ClientActiveTexture(GL_TEXTURE0 + arrays.client_unit);
    desktop.BindBuffer(GL_ARRAY_BUFFER, arrays.array_buffer);
  }

 private:
  const float* keep(const Array& array, size_t vertices) {
    floats_.push_back(as_floats(array, vertices));
    desktop.BindBuffer(GL_ARRAY_BUFFER, 0);  // reading a buffer object has bound another
    return floats_.back().data();
  }

  std::vector<std::vector<float>> floats_;
};

// The desktop has one size for all points: they are drawn one by one, and its size is put back.
void draw_sized_points(const std::vector<float>& sizes, const std::vector<GLuint>& vertices) {
  float size = 1;
  desktop.GetFloatv(GL_POINT_SIZE, &size);
  for (const GLuint vertex : vertices) {
    desktop.PointSize(std::max(sizes[vertex], 0.001f));
    desktop.DrawArrays(GL_POINTS, static_cast<GLint>(vertex), 1);
  }
  desktop.PointSize(size);
}

void draw_arrays(GLenum mode, GLint first, GLsizei count) {
  if (first < 0 || count <= 0) {  // refused, or nothing to draw
    desktop.DrawArrays(mode, first, count);
    return;
  }
  const size_t end = static_cast<size_t>(first) + static_cast<size_t>(count);
  const Converted converted(end);
  if (mode != GL_POINTS || !arrays.point_size.enabled) {
    desktop.DrawArrays(mode, first, count);
    return;
  }
  std::vector<GLuint> vertices(static_cast<size_t>(count));
  std::iota(vertices.begin(), vertices.end(), static_cast<GLuint>(first));
  draw_sized_points(as_floats(arrays.point_size, end), vertices);
}

void draw_elements(GLenum mode, GLsizei count, GLenum type, const void* pointer) {
  const bool known = type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT;
  if (!known || count <= 0 ||
      (!anything_to_convert() && !(mode == GL_POINTS && arrays.point_size.enabled))) {
    desktop.DrawElements(mode, count, type, pointer);
    return;
  }
  const std::vector<GLuint> indices = indices_of(count, type, pointer);
  const size_t vertices = *std::max_element(indices.begin(), indices.end()) + size_t{1};
  const Converted converted(vertices);
  if (mode != GL_POINTS || !arrays.point_size.enabled) {
    desktop.DrawElements(mode, count, type, pointer);
    return;
  }
  draw_sized_points(as_floats(arrays.point_size, vertices), indices);
}

void note(Array& array, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  array.size = size;
  array.type = type;
  array.stride = stride;
  array.pointer = pointer;
  array.buffer = arrays.array_buffer;
}

Array* find_array(GLenum which) {
  switch (which) {
    case GL_VERTEX_ARRAY:
      return &arrays.vertex;
    case GL_NORMAL_ARRAY:
      return &arrays.normal;
    case GL_COLOR_ARRAY:
      return &arrays.color;
    case GL_TEXTURE_COORD_ARRAY:
      return &arrays.texcoord[arrays.client_unit];
    case GL_POINT_SIZE_ARRAY_OES:
      return &arrays.point_size;
    default:
      return nullptr;
  }
}

void set_enabled(GLenum which, bool enabled) {
  if (Array* array = find_array(which)) array->enabled = enabled;
  if (which == GL_POINT_SIZE_ARRAY_OES) return;
  (enabled ? desktop.EnableClientState : desktop.DisableClientState)(which);
}

}  // namespace

void forget_arrays() { arrays = {}; }

void translate_arrays(Gl& gl) {
  gl.ClientActiveTexture = [](GLenum unit) {
    arrays.client_unit = static_cast<int>(unit - GL_TEXTURE0);
    desktop.ClientActiveTexture(unit);
  };
  gl.EnableClientState = [](GLenum which) { set_enabled(which, true); };
  gl.DisableClientState = [](GLenum which) { set_enabled(which, false); };
  gl.BindBuffer = [](GLenum target, GLuint buffer) {
    (target == GL_ARRAY_BUFFER ? arrays.array_buffer : arrays.element_buffer) = buffer;
    desktop.BindBuffer(target, buffer);
  };
  gl.VertexPointer = [](GLint size, GLenum type, GLsizei stride, const void* pointer) {
    note(arrays.vertex, size, type, stride, pointer);
    if (type == GL_FLOAT || type == GL_SHORT) desktop.VertexPointer(size, type, stride, pointer);
  };
  gl.TexCoordPointer = [](GLint size, GLenum type, GLsizei stride, const void* pointer) {
    note(arrays.texcoord[arrays.client_unit], size, type, stride, pointer);
    if (type == GL_FLOAT || type == GL_SHORT) desktop.TexCoordPointer(size, type, stride, pointer);
  };
  gl.NormalPointer = [](GLenum type, GLsizei stride, const void* pointer) {
    note(arrays.normal, 3, type, stride, pointer);
    if (type != GL_FIXED) desktop.NormalPointer(type, stride, pointer);
  };
  gl.ColorPointer = [](GLint size, GLenum type, GLsizei stride, const void* pointer) {
    note(arrays.color, size, type, stride, pointer);
    if (type != GL_FIXED) desktop.ColorPointer(size, type, stride, pointer);
  };
  gl.PointSizePointerOES = [](GLenum type, GLsizei stride, const void* pointer) {
    note(arrays.point_size, 1, type, stride, pointer);
  };
  gl.DrawArrays = draw_arrays;
  gl.DrawElements = draw_elements;
}

}  // namespace clearpipe::reference
