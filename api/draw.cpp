// Drawing, clearing and reading pixels (2.8, 4.2.3, 4.3): commands for the pipeline built from
// vertex arrays and current values.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "api/draw.h"
#include "api/egl_image.h"
#include "api/exec.h"
#include "api/framebuffer.h"
#include "api/pixel_format.h"
#include "api/texture_target.h"
#include "pipeline/srgb.h"

namespace clearpipe::api {

namespace {

// A bound texture may have been changed here or through another context.
void notice_changed_textures(Context& c) {
  for (size_t u = 0; u < kTextureUnits; ++u) {
    if (!(c.dirty & kDirtyUnits) && !(c.textured >> u & 1)) continue;
    TextureObject* texture = enabled_texture(c.state.texture.unit[u]);
    if (!texture) continue;
    refresh(*texture);
    if (c.texture_version[u] != texture->version) c.dirty |= kDirtyTexture;
    if (c.framebuffer && samples_its_target(c, *texture)) {
      c.note_slow(Slow::kSamplesTarget);
      c.finish_frame();  // the draw samples what the level holds now
      c.dirty |= kDirtyUnits;
    }
  }
}

}  // namespace

void update_draw_state(Context& c) {
  update_targets(c);
  if (c.dirty & kDirtyUnits || c.textured != 0) notice_changed_textures(c);
  if (c.dirty & (kDirtyMatrix | kDirtyVertex | kDirtyTexCoord)) derive_vertex(c);
  if (c.dirty & kDirtyRaster) derive_raster(c);
  if (c.dirty & (kDirtyFragment | kDirtyUnits)) derive_fragment(c);
  c.dirty &= kDirtyArrays;
}

void note_texture_uses(Context& c) {
  note_drawn_image(c);
  for (size_t u = 0; c.textured >> u != 0; ++u) {
    if (c.fragment_state.unit[u].enabled) {
      note_uses(c, *enabled_texture(c.state.texture.unit[u]));
    }
  }
}

int64_t read_row_bytes(const Context& c, GLsizei width, GLenum format, GLenum type) {
  const int64_t alignment = c.state.misc.pack_alignment;
  const int64_t bytes = static_cast<int64_t>(read_bytes(format, type)) * width;
  return (bytes + alignment - 1) / alignment * alignment;
}

int64_t bytes_read(const Context& c, GLsizei width, GLsizei height, GLenum format, GLenum type) {
  if (width == 0 || height == 0) return 0;
  const int64_t row = read_row_bytes(c, width, format, type);
  if (row > INT64_MAX / height) return INT64_MAX;
  return row * (height - 1) + static_cast<int64_t>(read_bytes(format, type)) * width;
}

}  // namespace clearpipe::api

namespace clearpipe::api::exec {

namespace {

using pipeline::AttributeSource;
using pipeline::ComponentType;

ComponentType component_type(GLenum type) {
  switch (type) {
    case GL_BYTE:
      return ComponentType::kByte;
    case GL_UNSIGNED_BYTE:
      return ComponentType::kUnsignedByte;
    case GL_SHORT:
      return ComponentType::kShort;
    case GL_FIXED:
      return ComponentType::kFixed;
    default:
      return ComponentType::kFloat;
  }
}

uint32_t component_bytes(GLenum type) {
  return type == GL_BYTE || type == GL_UNSIGNED_BYTE ? 1 : type == GL_SHORT ? 2 : 4;
}

// False when the array has no element to read.
bool bind_array(const ArrayState& array, bool normalized, AttributeSource& source) {
  const uint32_t bytes = component_bytes(array.type) * static_cast<uint32_t>(array.size);
  source.is_array = true;
  source.type = component_type(array.type);
  source.size = static_cast<uint8_t>(array.size);
  source.normalized = normalized && array.type != GL_FLOAT && array.type != GL_FIXED;
  source.stride = array.stride != 0 ? static_cast<uint32_t>(array.stride) : bytes;
  source.max_index = 0xffffffffu;
  source.buffer = nullptr;
  if (!array.buffer) {
    source.pointer = static_cast<const std::byte*>(array.pointer);
    return source.pointer != nullptr;
  }
  const size_t offset = reinterpret_cast<uintptr_t>(array.pointer);
  const size_t size = array.buffer->data->size();
  if (offset > size || size - offset < bytes) return false;
  source.buffer = &array.buffer->data;
  source.pointer = array.buffer->data->data() + offset;
  source.max_index =
      static_cast<uint32_t>(std::min<size_t>((size - offset - bytes) / source.stride, 0xfffffffeu));
  return true;
}

// OES_matrix_palette: nothing is drawn without both.
bool bind_palette_arrays(const ArraysState& a, pipeline::DrawCommand& command) {
  using pipeline::Attribute;
  const auto bind = [&command](Attribute attribute, const ArrayState& array) {
    return array.enabled && array.size > 0 &&
           bind_array(array, false, command.attributes[static_cast<size_t>(attribute)]);
  };
  return bind(Attribute::kMatrixIndex, a.matrix_index) && bind(Attribute::kWeight, a.weight);
}

// False when an array that is needed has no element.
bool bind_arrays(const Context& c, pipeline::DrawCommand& command) {
  const ArraysState& a = c.state.arrays;
  for (AttributeSource& source : command.attributes) source.is_array = false;
  auto bind = [&command](size_t slot, const ArrayState& array, bool normalized) {
    return !array.enabled || bind_array(array, normalized, command.attributes[slot]);
  };
  if (!a.vertex.enabled) return false;
  if (!bind(0, a.vertex, false) || !bind(1, a.normal, true) || !bind(2, a.colour, true) ||
      !bind(3, a.point_size, false)) {
    return false;
  }
  if (c.state.transform.matrix_palette && !bind_palette_arrays(a, command)) return false;
  for (size_t u = 0; u < kTextureUnits; ++u) {
    if (!bind(4 + u, a.tex_coord[u], false)) {
      // An array nobody samples with does not matter.
      if (c.vertex_state.texture_units >> u & 1) return false;
      command.attributes[4 + u].is_array = false;
    }
  }
  return true;
}

// Binds the arrays anew when one of them, or the store of a buffer object, is another.
void update_arrays(Context& c) {
  if (!(c.dirty & kDirtyArrays) && c.buffers_version == c.share->buffers_version) return;
  c.array_buffers.clear();
  visit_arrays(c.state.arrays, [&c](const ArrayState& array) {
    if (array.enabled && array.buffer) c.array_buffers.push_back(array.buffer.get());
  });
  c.arrays_drawable = bind_arrays(c, c.draw_command);
  const auto& attributes = c.draw_command.attributes;
  c.client_arrays = std::any_of(attributes.begin(), attributes.end(), [](const AttributeSource& s) {
    return s.is_array && s.buffer == nullptr;
  });
  c.buffers_version = c.share->buffers_version;
  c.dirty &= ~static_cast<uint32_t>(kDirtyArrays);
}

// The current values (2.7), for attributes without an array.
void take_current_values(const Context& c, pipeline::DrawCommand& command) {
  const CurrentState& current = c.state.current;
  command.attributes[0].constant = {0, 0, 0, 1};
  command.attributes[1].constant = current.normal;
  command.attributes[2].constant = current.colour;
  command.attributes[3].constant = {c.state.raster.point_size, 0, 0, 1};
  for (size_t u = 0; u < kTextureUnits; ++u) {
    command.attributes[4 + u].constant = current.tex_coord[u];
  }
}

// What the draw reads when the frame is executed.
void note_uses(Context& c, const pipeline::DrawCommand& command) {
  note_texture_uses(c);
  for (BufferObject* buffer : c.array_buffers) buffer->uses.note(c.clock);
  if (command.index_buffer) c.state.arrays.element_array_buffer->uses.note(c.clock);
}

void record(Context& c, pipeline::DrawCommand& command, GLenum mode) {
  static_assert(GL_POINTS == 0 && GL_TRIANGLE_FAN == 6);
  command.primitive = static_cast<pipeline::Primitive>(mode);
  update_arrays(c);
  if (!c.arrays_drawable) return;
  take_current_values(c, command);
  if (c.client_arrays) c.note_slow(Slow::kClientArrays);
  note_uses(c, command);
  if (!c.frame.draw(command)) c.set_error(kOutOfMemory);
}

// A clear colour as the buffer keeps it. Rounds as the reference does, to even: 0.3 is 76, 0.9 is
// 230.
uint32_t clear_value(const pipeline::ColourBuffer& buffer, const Vec4& colour) {
  const float component[4] = {colour.x, colour.y, colour.z, buffer.has_alpha ? colour.w : 1.0f};
  uint32_t value = 0;
  for (size_t c = 0; c < 4; ++c) {
    value |= (buffer.srgb && c < 3 ? pipeline::linear_to_srgb(component[c])
                                   : pipeline::round_component(buffer.format, c, component[c]))
             << (8 * c);
  }
  return value;
}

// The same of depth. What fragments have of 32 bits is a product with 2^32 (depth_stencil-inl.h).
uint32_t clear_value(const pipeline::DepthStencilBuffer& buffer, double depth) {
  if (buffer.depth_bits == 32) {
    return static_cast<uint32_t>(std::min(depth * 4294967296.0 + 0.5, 4294967295.0));
  }
  return static_cast<uint32_t>(depth * ((1 << buffer.depth_bits) - 1) + 0.5);
}

}  // namespace

void draw_arrays(Context& c, GLenum mode, GLint first, GLsizei count) {
  if (count == 0) return;
  update_draw_state(c);
  pipeline::DrawCommand& command = c.draw_command;
  command.first = static_cast<uint32_t>(first);
  command.count = static_cast<uint32_t>(count);
  command.index_type = pipeline::IndexType::kNone;
  command.indices = nullptr;
  command.index_buffer = nullptr;
  record(c, command, mode);
}

void draw_elements(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices) {
  if (count == 0) return;
  update_draw_state(c);
  pipeline::DrawCommand& command = c.draw_command;
  command.first = 0;
  command.count = static_cast<uint32_t>(count);
  command.index_type = type == GL_UNSIGNED_BYTE    ? pipeline::IndexType::kUnsignedByte
                       : type == GL_UNSIGNED_SHORT ? pipeline::IndexType::kUnsignedShort
                                                   : pipeline::IndexType::kUnsignedInt;
  if (const BufferPtr& buffer = c.state.arrays.element_array_buffer) {
    command.index_buffer = &buffer->data;
    command.indices = buffer->data->data() + reinterpret_cast<uintptr_t>(indices);
  } else {
    command.index_buffer = nullptr;
    command.indices = static_cast<const std::byte*>(indices);
    if (!indices) return;
  }
  record(c, command, mode);
}

void multi_draw_arrays(Context& c, GLenum mode, const GLint* first, const GLsizei* count,
                       GLsizei n) {
  for (GLsizei i = 0; i < n; ++i) {
    if (count[i] > 0) draw_arrays(c, mode, first[i], count[i]);
  }
}

void multi_draw_elements(Context& c, GLenum mode, const GLsizei* count, GLenum type,
                         const void* const* indices, GLsizei n) {
  for (GLsizei i = 0; i < n; ++i) {
    if (count[i] > 0) draw_elements(c, mode, count[i], type, indices[i]);
  }
}

void clear(Context& c, GLbitfield mask) {
  update_targets(c);
  if (c.dirty & kDirtyRaster) {
    derive_raster(c);
    c.dirty &= ~static_cast<uint32_t>(kDirtyRaster);
  }
  const FramebufferState& fb = c.state.framebuffer;
  pipeline::ClearCommand command;
  command.rect = c.raster_state.scissor;
  if (command.rect.x0 >= command.rect.x1 || command.rect.y0 >= command.rect.y1) return;
  const auto& planes = c.draw.depth_stencil;
  command.colour = (mask & GL_COLOR_BUFFER_BIT) && c.draw.colour;
  command.depth = (mask & GL_DEPTH_BUFFER_BIT) && fb.depth_mask && planes && planes->has_depth;
  command.stencil = (mask & GL_STENCIL_BUFFER_BIT) && planes && planes->has_stencil;
  if (command.colour) command.colour_value = clear_value(*c.draw.colour, fb.clear_colour);
  command.colour_mask = 0;
  for (unsigned i = 0; i < 4; ++i) {
    if (fb.colour_mask[i]) {
      command.colour_mask = static_cast<uint8_t>(command.colour_mask | 1u << i);
    }
  }
  if (planes) command.depth_value = clear_value(*planes, static_cast<double>(fb.clear_depth));
  command.stencil_value = static_cast<uint8_t>(fb.clear_stencil);
  command.stencil_mask = static_cast<uint8_t>(fb.stencil_mask);
  if (!command.colour && !command.depth && !command.stencil) return;
  note_drawn_image(c);
  if (!c.frame.clear(command)) c.set_error(kOutOfMemory);
}

void read_n_pixels(Context& c, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                   GLenum type, GLsizei, void* data) {
  read_pixels(c, x, y, width, height, format, type, data);
}

void read_pixels(Context& c, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                 GLenum type, void* pixels) {
  c.finish_frame(Slow::kWaits);
  update_targets(c);
  const pipeline::ColourBuffer& from = *c.read.colour;
  const int64_t bytes = static_cast<int64_t>(read_bytes(format, type));
  const int64_t row_bytes = read_row_bytes(c, width, format, type);
  const int64_t x0 = std::max<int64_t>(x, 0),
                x1 = std::min<int64_t>(static_cast<int64_t>(x) + width, from.width);
  if (x0 >= x1) return;
  const int count = static_cast<int>(x1 - x0);
  const int64_t y0 = std::max<int64_t>(y, 0),
                y1 = std::min<int64_t>(static_cast<int64_t>(y) + height, from.height);
  // Pixels outside of the surface are undefined: they are left alone (4.3.1).
  std::byte* to = static_cast<std::byte*>(pixels) + (y0 - y) * row_bytes + (x0 - x) * bytes;
  if (y0 >= y1) return;
  if (format == GL_RGBA) {
    pipeline::read_rectangle(from, static_cast<int>(x0), static_cast<int>(y0), count,
                             static_cast<int>(y1 - y0), to, static_cast<size_t>(row_bytes));
    return;
  }
  std::vector<uint32_t> rgba(static_cast<size_t>(count));
  for (int64_t row = y0; row < y1; ++row, to += row_bytes) {
    pipeline::read_pixels(from, static_cast<int>(x0), static_cast<int>(row), count, rgba.data());
    std::byte* out = to;
    for (const uint32_t pixel : rgba) {
      const uint32_t packed = pack_read(pixel, type);
      std::memcpy(out, &packed, static_cast<size_t>(bytes));
      out += bytes;
    }
  }
}

}  // namespace clearpipe::api::exec
