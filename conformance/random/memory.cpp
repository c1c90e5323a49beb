// Whether a stream reads only memory that it has: vertex arrays and indices, from the client or
// from buffer objects (2.8, 2.9). Shortened streams may not. Nor may they draw without vertices: of
// that the reference's specification, OpenGL's, says something else.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstring>
#include <map>

#include "conformance/random/stream.h"

namespace clearpipe::conformance::random {

namespace {

size_t size_of(GLenum type) {
  return type == GL_BYTE || type == GL_UNSIGNED_BYTE     ? 1
         : type == GL_SHORT || type == GL_UNSIGNED_SHORT ? 2
                                                         : 4;
}

// Draws of other modes are refused.
bool is_mode(GLenum mode) { return mode <= GL_TRIANGLE_FAN; }

struct Array {
  bool enabled = false, set = false;
  size_t element = 0, stride = 0;
  GLuint buffer = 0;  // 0: client memory
  size_t extent = 0;  // bytes of client memory
  size_t offset = 0;  // into the buffer
};

class Memory {
 public:
  // False if the command would read what is not there.
  bool take(const Command& command);

 private:
  Array* array_of(GLenum name) {
    switch (name) {
      case GL_VERTEX_ARRAY:
        return &vertex_;
      case GL_COLOR_ARRAY:
        return &colour_;
      case GL_NORMAL_ARRAY:
        return &normal_;
      case GL_POINT_SIZE_ARRAY_OES:
        return &point_size_;
      default:
        return &tex_coord_.at(unit_);
    }
  }

  bool point(Array& array, size_t components, GLenum type, size_t stride, const Command& command) {
    array.set = true;
    array.element = components * size_of(type);
    array.stride = stride != 0 ? stride : array.element;
    array.buffer = array_buffer_;
    array.extent = command.data.size();
    array.offset = command.arguments.back();
    return command.data.empty() == (array_buffer_ != 0);
  }

  size_t extent_of(const Array& array) const {
    if (array.buffer == 0) return array.extent;
    const auto found = sizes_.find(array.buffer);
    const size_t size = found == sizes_.end() ? 0 : found->second;
    return size - std::min(size, array.offset);
  }

  bool covers(const Array& array, size_t vertices) const {
    if (!array.enabled || vertices == 0) return true;
    return array.set && (vertices - 1) * array.stride + array.element <= extent_of(array);
  }

  bool covers_all(size_t vertices) const {
    return vertex_.enabled && covers(vertex_, vertices) && covers(colour_, vertices) &&
           covers(normal_, vertices) && covers(point_size_, vertices) &&
           std::all_of(tex_coord_.begin(), tex_coord_.end(),
                       [&](const Array& array) { return covers(array, vertices); });
  }

  bool draw_elements(const Command& command);

  Array vertex_, colour_, normal_, point_size_;
  std::array<Array, 8> tex_coord_;
  size_t unit_ = 0;
  GLuint array_buffer_ = 0, element_buffer_ = 0;
  std::map<GLuint, size_t> sizes_;
  std::map<GLuint, std::vector<uint8_t>> contents_;
};

bool Memory::draw_elements(const Command& command) {
  const GLsizei count = static_cast<GLsizei>(command.arguments[1]);
  const GLenum type = command.arguments[2];
  if (!is_mode(command.arguments[0]) || count <= 0) return true;
  if (type != GL_UNSIGNED_BYTE && type != GL_UNSIGNED_SHORT) return true;
  if (command.data.empty() != (element_buffer_ != 0)) return false;
  const std::vector<uint8_t>& bytes =
      element_buffer_ != 0 ? contents_[element_buffer_] : command.data;
  const size_t start = command.data.empty() ? command.arguments[3] : 0;
  const size_t size = size_of(type);
  if (start + static_cast<size_t>(count) * size > bytes.size()) return false;
  size_t highest = 0;
  for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
    uint16_t index = 0;  // little endian
    std::memcpy(&index, bytes.data() + start + i * size, size);
    highest = std::max<size_t>(highest, index);
  }
  return covers_all(highest + 1);
}

bool Memory::take(const Command& command) {
  const std::vector<uint32_t>& a = command.arguments;
  switch (command.call) {
    case Call::ClientActiveTexture:
      unit_ = a[0] - GL_TEXTURE0;
      return true;
    case Call::EnableClientState:
    case Call::DisableClientState:
      array_of(a[0])->enabled = command.call == Call::EnableClientState;
      return true;
    case Call::VertexPointer:
      return point(vertex_, a[0], a[1], a[2], command);
    case Call::ColorPointer:
      return point(colour_, a[0], a[1], a[2], command);
    case Call::TexCoordPointer:
      return point(tex_coord_[unit_], a[0], a[1], a[2], command);
    case Call::NormalPointer:
      return point(normal_, 3, a[0], a[1], command);
    case Call::PointSizePointerOES:
      return point(point_size_, 1, a[0], a[1], command);
    case Call::BindBuffer:
      (a[0] == GL_ARRAY_BUFFER ? array_buffer_ : element_buffer_) = a[1];
      return true;
    case Call::BufferData: {
      const GLuint buffer = a[0] == GL_ARRAY_BUFFER ? array_buffer_ : element_buffer_;
      sizes_[buffer] = a[1];
      contents_[buffer] = command.data;
      return true;
    }
    case Call::DrawArrays: {
      const GLint first = static_cast<GLint>(a[1]), count = static_cast<GLint>(a[2]);
      return !is_mode(a[0]) || count <= 0 || covers_all(static_cast<size_t>(first + count));
    }
    case Call::DrawElements:
      return draw_elements(command);
    default:
      return true;
  }
}

}  // namespace

bool reads_only_its_own(const Stream& stream) {
  Memory memory;
  return std::all_of(stream.commands.begin(), stream.commands.end(),
                     [&](const Command& command) { return memory.take(command); });
}

}  // namespace clearpipe::conformance::random
