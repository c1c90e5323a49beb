// The state of a context: one struct per state table of chapter 6, members in the table's order
// with their initial values. Setters change it and mark what must be derived again.
// SPDX-License-Identifier: MIT
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <array>
#include <vector>

#include "api/limits.h"
#include "api/objects.h"
#include "pipeline/state.h"

namespace clearpipe::api {

using pipeline::Mat4;
using pipeline::Vec4;

// Table 6.3: current values.
struct CurrentState {
  Vec4 colour{1, 1, 1, 1};
  std::array<Vec4, kTextureUnits> tex_coord = [] {
    std::array<Vec4, kTextureUnits> initial;
    initial.fill({0, 0, 0, 1});
    return initial;
  }();
  Vec4 normal{0, 0, 1, 0};
};

// Tables 6.4 and 6.5: one vertex array.
struct ArrayState {
  bool enabled = false;
  GLint size = 4;
  GLenum type = GL_FLOAT;
  GLsizei stride = 0;
  const void* pointer = nullptr;
  BufferPtr buffer;
};

// What a vertex array object holds (OES_vertex_array_object).
struct VertexArrayState {
  ArrayState vertex, colour;
  ArrayState normal{false, 3, GL_FLOAT, 0, nullptr, nullptr};
  ArrayState point_size{false, 1, GL_FLOAT, 0, nullptr, nullptr};
  std::array<ArrayState, kTextureUnits> tex_coord;
  // OES_matrix_palette
  ArrayState matrix_index{false, 0, GL_UNSIGNED_BYTE, 0, nullptr, nullptr};
  ArrayState weight{false, 0, GL_FLOAT, 0, nullptr, nullptr};
  BufferPtr element_array_buffer;
};

// The state of the bound vertex array object is here, not in the object.
struct ArraysState : VertexArrayState {
  GLint client_active_texture = 0;
  BufferPtr array_buffer;
  GLuint vertex_array = 0;
};

// Calls visit with each vertex array.
template <typename Arrays, typename Visit>
void visit_arrays(Arrays& a, const Visit& visit) {
  for (auto* array : {&a.vertex, &a.normal, &a.colour, &a.point_size, &a.matrix_index, &a.weight}) {
    visit(*array);
  }
  for (auto& array : a.tex_coord) visit(array);
}

// Table 6.7: transformation state.
struct MatrixStack {
  explicit MatrixStack(int depth) : limit(depth), stack(1) {}
  int limit;
  std::vector<Mat4> stack;
  Mat4& top() { return stack.back(); }
  const Mat4& top() const { return stack.back(); }
};

struct TransformState {
  MatrixStack modelview{kModelviewStackDepth};
  MatrixStack projection{kProjectionStackDepth};
  std::vector<MatrixStack> texture =
      std::vector<MatrixStack>(kTextureUnits, MatrixStack(kTextureStackDepth));
  GLint viewport[4] = {0, 0, 0, 0};
  float depth_range[2] = {0, 1};
  GLenum matrix_mode = GL_MODELVIEW;
  bool normalize = false;
  bool rescale_normal = false;
  std::array<bool, kClipPlanes> clip_plane_enabled{};
  std::array<Vec4, kClipPlanes> clip_plane{};  // eye space
  // OES_matrix_palette: matrices without stacks, which are stacks of one.
  std::vector<MatrixStack> palette = std::vector<MatrixStack>(kPaletteMatrices, MatrixStack(1));
  GLuint current_palette_matrix = 0;
  bool matrix_palette = false;
};

// Table 6.8: colouring.
struct FogState {
  Vec4 colour{0, 0, 0, 0};
  float density = 1, start = 0, end = 1;
  GLenum mode = GL_EXP;
  bool enabled = false;
};

// Table 6.10: one light.
struct LightState {
  Vec4 ambient{0, 0, 0, 1}, diffuse{0, 0, 0, 1}, specular{0, 0, 0, 1};
  Vec4 position{0, 0, 1, 0};         // eye space
  Vec4 spot_direction{0, 0, -1, 0};  // eye space
  float spot_exponent = 0, spot_cutoff = 180;
  float attenuation[3] = {1, 0, 0};
  bool enabled = false;
};

// Tables 6.8 (the shade model) and 6.9: lighting.
struct LightingState {
  GLenum shade_model = GL_SMOOTH;
  bool enabled = false;
  bool colour_material = false;
  Vec4 ambient{0.2f, 0.2f, 0.2f, 1}, diffuse{0.8f, 0.8f, 0.8f, 1};
  Vec4 specular{0, 0, 0, 1}, emission{0, 0, 0, 1};
  float shininess = 0;
  Vec4 model_ambient{0.2f, 0.2f, 0.2f, 1};
  bool two_sided = false;
  std::array<LightState, kLights> light = [] {
    std::array<LightState, kLights> initial;
    initial[0].diffuse = initial[0].specular = {1, 1, 1, 1};
    return initial;
  }();
};

// Table 6.11: rasterization.
struct RasterizationState {
  float point_size = 1;
  bool point_smooth = false;
  float point_size_min = 0, point_size_max = kMaxPointSize, point_fade_threshold = 1;
  float point_attenuation[3] = {1, 0, 0};
  bool point_sprite = false;
  float line_width = 1;
  bool line_smooth = false;
  bool cull_face = false;
  GLenum cull_mode = GL_BACK, front_face = GL_CCW;
  float offset_factor = 0, offset_units = 0;
  float offset_clamp = 0;  // EXT_polygon_offset_clamp
  bool offset_fill = false;
};

// Table 6.12: multisampling.
struct MultisampleState {
  bool enabled = true, alpha_to_coverage = false, alpha_to_one = false, coverage = false;
  float coverage_value = 1;
  bool coverage_invert = false;
};

// Tables 6.13 and 6.15: binding and texture environment of one unit; cube maps and generated
// coordinates are those of OES_texture_cube_map.
struct TextureUnitState {
  bool enabled = false, cube_enabled = false, external_enabled = false;
  TexturePtr texture, cube_texture, external_texture;
  bool gen_str = false;
  GLenum gen_mode = GL_REFLECTION_MAP_OES;
  GLenum env_mode = GL_MODULATE;
  Vec4 env_colour{0, 0, 0, 0};
  GLenum combine_rgb = GL_MODULATE, combine_alpha = GL_MODULATE;
  GLenum src_rgb[3] = {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT};
  GLenum src_alpha[3] = {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT};
  GLenum operand_rgb[3] = {GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA};
  GLenum operand_alpha[3] = {GL_SRC_ALPHA, GL_SRC_ALPHA, GL_SRC_ALPHA};
  float rgb_scale = 1, alpha_scale = 1;
  bool coord_replace = false;
  float lod_bias = 0;  // EXT_texture_lod_bias, as set
};

struct TextureState {
  GLint active = 0;
  std::array<TextureUnitState, kTextureUnits> unit;
};

// Table 6.16: pixel operations.
struct PixelState {
  bool scissor_test = false;
  GLint scissor[4] = {0, 0, 0, 0};
  bool alpha_test = false;
  GLenum alpha_func = GL_ALWAYS;
  float alpha_reference = 0;
  bool stencil_test = false;
  GLenum stencil_func = GL_ALWAYS;
  GLint stencil_reference = 0;
  GLuint stencil_value_mask = 0xffffffffu;
  GLenum stencil_fail = GL_KEEP, stencil_depth_fail = GL_KEEP, stencil_pass = GL_KEEP;
  bool depth_test = false;
  GLenum depth_func = GL_LESS;
  bool blend = false;
  GLenum src_rgb = GL_ONE, dst_rgb = GL_ZERO, src_alpha = GL_ONE, dst_alpha = GL_ZERO;
  GLenum equation_rgb = GL_FUNC_ADD_OES, equation_alpha = GL_FUNC_ADD_OES;
  bool dither = true;
  bool logic_op_enabled = false;
  GLenum logic_op = GL_COPY;
};

// Table 6.17: framebuffer control.
struct FramebufferState {
  bool colour_mask[4] = {true, true, true, true};
  bool depth_mask = true;
  GLuint stencil_mask = 0xffffffffu;
  Vec4 clear_colour{0, 0, 0, 0};
  float clear_depth = 1;
  GLint clear_stencil = 0;
};

// Tables 6.18 and 6.19: pixels and hints.
struct MiscState {
  GLint unpack_alignment = 4, pack_alignment = 4;
  GLenum perspective_hint = GL_DONT_CARE, point_hint = GL_DONT_CARE, line_hint = GL_DONT_CARE,
         fog_hint = GL_DONT_CARE, mipmap_hint = GL_DONT_CARE;
};

struct State {
  CurrentState current;
  ArraysState arrays;
  TransformState transform;
  FogState fog;
  LightingState lighting;
  RasterizationState raster;
  MultisampleState multisample;
  TextureState texture;
  PixelState pixel;
  FramebufferState framebuffer;
  MiscState misc;
};

// What must be derived again before the next draw.
enum Dirty : uint32_t {
  kDirtyMatrix = 1,    // modelview, projection, palette
  kDirtyVertex = 2,    // lighting, clip planes, points
  kDirtyTexCoord = 4,  // texture matrices, generated coordinates
  kDirtyRaster = 8,
  kDirtyFragment = 16,                           // fog and the per-fragment operations
  kDirtyUnits = 32,                              // textures, samplers, texture environments
  kDirtyArrays = 64,                             // vertex arrays
  kDirtyTexture = kDirtyTexCoord | kDirtyUnits,  // which textures are enabled
  kDirtyAll = 127
};

}  // namespace clearpipe::api
