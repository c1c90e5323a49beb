// The immutable state a draw carries through the pipeline, in the pipeline's own words.
//
// api/derive_*.cpp builds these structs from OpenGL ES state; everything below api/ reads nothing
// else. Each struct is a plain value: a frame copies it once per change and keeps the copy until
// its tiles are merged, so no stage ever sees state move under it.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "pipeline/image.h"

namespace clearpipe::pipeline {

inline constexpr int kMaxTextureUnits = 8;
inline constexpr int kMaxLights = 8;
inline constexpr int kMaxClipPlanes = 8;
inline constexpr int kPaletteMatrices = 48;
inline constexpr int kVertexUnits = 4;

struct Vec4 {
  float x = 0, y = 0, z = 0, w = 0;
  bool operator==(const Vec4&) const = default;
};

// Column-major, as in the specification: m[4 * column + row].
struct Mat4 {
  std::array<float, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
};

enum class CompareFunc : uint8_t {
  kNever,
  kLess,
  kEqual,
  kLessEqual,
  kGreater,
  kNotEqual,
  kGreaterEqual,
  kAlways
};

// ---- Vertex state -------------------------------------------------------------------------------

// One light (2.12.1). Products with the material are formed by the derivation.
struct Light {
  bool enabled = false;
  bool positional = false;  // position.w != 0
  bool spot = false;        // spot cutoff != 180
  bool attenuated = false;  // any factor other than constant 1
  Vec4 ambient;             // light colours; the material multiplies them per vertex
  Vec4 diffuse;
  Vec4 specular;
  Vec4 position;        // eye space; for a directional light: the unit direction to it
  Vec4 half_vector;     // directional light: unit vector between it and (0,0,1)
  Vec4 spot_direction;  // eye space, unit
  float spot_exponent = 0;
  float spot_cutoff_cos = -1;
  float attenuation[3] = {1, 0, 0};  // constant, linear, quadratic
};

struct Material {
  Vec4 ambient, diffuse, specular, emission;
  float shininess = 0;
};

// OES_matrix_palette: one matrix after another, column-major as in Mat4.
struct MatrixPalette {
  std::array<float, 16 * kPaletteMatrices> matrix{};
  std::array<float, 9 * kPaletteMatrices> normal_matrix{};  // transposed inverses; with normals
};

// What every vertex needs comes first, and what only some states need behind it: copy_vertex_state
// leaves that out.
struct VertexState {
  Mat4 model_view_projection;  // projection * modelview, composed in float
  Mat4 model_view;
  std::array<float, 9> normal_matrix{1, 0, 0, 0, 1, 0, 0, 0, 1};  // column-major inverse transpose
  float rescale = 1;                                              // factor of RESCALE_NORMAL
  bool rescale_normal = false;
  bool normalize = false;
  bool lighting = false;
  bool two_sided = false;
  bool colour_material = false;  // ambient and diffuse follow the vertex colour
  bool fog = false;              // the fog coordinate |eye z| is needed per fragment (3.8)
  uint8_t texture_units = 0;     // bit u: unit u samples a texture, so its coordinates are needed
  uint8_t texture_matrix = 0;    // bit u: texture matrix of unit u is not the identity
  // Bit u: s, t and r of unit u are generated, as the reflection vector or the normal.
  uint8_t reflection_map = 0, normal_map = 0;
  uint8_t clip_planes = 0;  // bit i: user clip plane i is enabled (2.11)
  bool point_attenuated = false;
  // Points (3.3): derived size = clamp(size * attenuation), fade below the threshold.
  float point_size = 1, point_size_min = 0, point_size_max = 255, point_fade_threshold = 1;
  float point_attenuation[3] = {1, 0, 0};
  // Null: vertices are transformed by the matrices above, else by the palette and `projection`.
  // The palette is only borrowed until the state is set anew.
  const MatrixPalette* palette = nullptr;

  Mat4 projection;     // with a palette
  Vec4 scene_ambient;  // light model ambient; with lighting, like what follows
  Material material;
  std::array<Light, kMaxLights> lights;
  std::array<Mat4, kMaxTextureUnits> texture_matrices;  // those of texture_matrix
  std::array<Vec4, kMaxClipPlanes> clip_plane;          // eye space; those of clip_planes
};

// Copies what the state uses; the rest of `to` is left as it is.
void copy_vertex_state(const VertexState& from, VertexState& to);

// ---- Raster state -------------------------------------------------------------------------------

enum class CullFace : uint8_t { kNone, kFront, kBack, kFrontAndBack };

struct Viewport {
  // Window = centre + scale * normalised device coordinate (2.10.1).
  float scale_x = 0, scale_y = 0, scale_z = 0.5f;
  float centre_x = 0, centre_y = 0, centre_z = 0.5f;

  bool operator==(const Viewport&) const = default;
};

struct Rect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // half-open
};

struct RasterState {
  Viewport viewport;
  Rect scissor;  // always set: the scissor box or the whole surface
  CullFace cull = CullFace::kNone;
  bool front_is_clockwise = false;
  bool flat_shade = false;  // the provoking vertex is the last of the primitive (2.13.7)
  bool offset_fill = false;
  float offset_factor = 0, offset_units = 0;
  float offset_clamp = 0;  // 0: not clamped
  float line_width = 1;
  bool line_smooth = false;
  bool point_smooth = false;
  bool point_sprite = false;
  uint8_t coord_replace = 0;  // bit u
  bool multisample = true;
};

// ---- Fragment state -----------------------------------------------------------------------------

enum class Wrap : uint8_t { kRepeat, kClampToEdge, kMirroredRepeat };
enum class Filter : uint8_t { kNearest, kLinear };
enum class MipFilter : uint8_t { kNone, kNearest, kLinear };

struct Sampler {
  Wrap wrap_s = Wrap::kRepeat, wrap_t = Wrap::kRepeat;
  Filter min = Filter::kNearest, mag = Filter::kLinear;
  MipFilter mip = MipFilter::kLinear;
  float lod_bias = 0;
  float max_anisotropy = 1;
  int base_level = 0;
  int max_level = 0;  // last level that exists

  bool operator==(const Sampler&) const = default;
};

// The texture environment (3.7.12) as the combiner it always is: the classic environments are
// expressed with these operations by the derivation, per base format.
enum class Combine : uint8_t {
  kReplace,
  kModulate,
  kAdd,
  kAddSigned,
  kInterpolate,
  kSubtract,
  kModulateAdd,  // Arg0 * Arg2 + Arg1
  kDot3Rgb,
  kDot3Rgba
};
// How many arguments a function has; those behind them are not looked at.
constexpr int argument_count(Combine function) {
  switch (function) {
    case Combine::kReplace:
      return 1;
    case Combine::kInterpolate:
    case Combine::kModulateAdd:
      return 3;
    default:
      return 2;
  }
}

enum class CombineSource : uint8_t {
  kTexture0,
  kTexture1,
  kTexture2,
  kTexture3,
  kTexture4,
  kTexture5,
  kTexture6,
  kTexture7,
  kConstant,
  kPrimaryColour,
  kPrevious
};
enum class CombineOperand : uint8_t { kColour, kOneMinusColour, kAlpha, kOneMinusAlpha };

struct CombineArgument {
  CombineSource source = CombineSource::kPrevious;
  CombineOperand operand = CombineOperand::kColour;

  bool operator==(const CombineArgument&) const = default;
};

struct Combiner {
  Combine rgb = Combine::kReplace;
  Combine alpha = Combine::kReplace;
  std::array<CombineArgument, 3> rgb_argument;
  std::array<CombineArgument, 3> alpha_argument;     // operand is kAlpha or kOneMinusAlpha
  uint8_t rgb_scale_log2 = 0, alpha_scale_log2 = 0;  // scale 1, 2 or 4

  bool operator==(const Combiner&) const = default;
};

struct TextureUnit {
  bool enabled = false;  // a complete texture is enabled on this unit
  bool cube = false;     // a cube map: (s, t, r) is a direction
  bool srgb = false;     // the image's colours are sRGB-encoded
  ImageRef image;        // all its levels
  Sampler sampler;
  Combiner combiner;
  Vec4 constant;  // TEXTURE_ENV_COLOR, clamped

  bool operator==(const TextureUnit&) const = default;
};

enum class StencilOp : uint8_t {
  kKeep,
  kZero,
  kReplace,
  kIncrement,
  kDecrement,
  kInvert,
  kIncrementWrap,
  kDecrementWrap
};

struct StencilState {
  bool enabled = false;
  CompareFunc func = CompareFunc::kAlways;
  uint8_t reference = 0, value_mask = 0xff, write_mask = 0xff;
  StencilOp fail = StencilOp::kKeep, depth_fail = StencilOp::kKeep, pass = StencilOp::kKeep;

  bool operator==(const StencilState&) const = default;
};

enum class BlendFactor : uint8_t {
  kZero,
  kOne,
  kSrcColour,
  kOneMinusSrcColour,
  kDstColour,
  kOneMinusDstColour,
  kSrcAlpha,
  kOneMinusSrcAlpha,
  kDstAlpha,
  kOneMinusDstAlpha,
  kSrcAlphaSaturate
};
enum class BlendEquation : uint8_t { kAdd, kSubtract, kReverseSubtract, kMin, kMax };

struct BlendState {
  bool enabled = false;
  BlendFactor src_rgb = BlendFactor::kOne, dst_rgb = BlendFactor::kZero;
  BlendFactor src_alpha = BlendFactor::kOne, dst_alpha = BlendFactor::kZero;
  BlendEquation rgb = BlendEquation::kAdd, alpha = BlendEquation::kAdd;

  bool operator==(const BlendState&) const = default;
};

// The sixteen logical operations in the order of their truth tables (4.1.9); bit 0 of the value is
// the result for s=1,d=1; bit 1 for s=1,d=0; bit 2 for s=0,d=1; bit 3 for s=0,d=0.
enum class LogicOp : uint8_t {
  kClear,
  kAnd,
  kAndReverse,
  kCopy,
  kAndInverted,
  kNoop,
  kXor,
  kOr,
  kNor,
  kEquiv,
  kInvert,
  kOrReverse,
  kCopyInverted,
  kOrInverted,
  kNand,
  kSet
};

enum class FogMode : uint8_t { kNone, kLinear, kExp, kExp2 };

// What fragments go through after texturing.
struct FragmentOperations {
  FogMode fog = FogMode::kNone;
  float fog_density = 1, fog_start = 0, fog_end = 1;
  Vec4 fog_colour;
  bool alpha_test = false;
  CompareFunc alpha_func = CompareFunc::kAlways;
  float alpha_reference = 0;  // clamped to [0,1]
  StencilState stencil;
  bool depth_test = false;  // false also when the surface has no depth buffer
  bool depth_write = true;  // takes effect only with depth_test (4.1.5)
  CompareFunc depth_func = CompareFunc::kLess;
  BlendState blend;
  bool logic_op_enabled = false;
  LogicOp logic_op = LogicOp::kCopy;
  uint8_t colour_mask = 0xf;  // bits R=1 G=2 B=4 A=8
  // Of multisampled fragments (4.1.3).
  bool alpha_to_coverage = false, alpha_to_one = false;
  bool sample_coverage = false, sample_coverage_invert = false;
  float sample_coverage_value = 1;

  bool operator==(const FragmentOperations&) const = default;
};

struct FragmentState : FragmentOperations {
  std::array<TextureUnit, kMaxTextureUnits> unit;

  // What units that are not enabled hold does not matter.
  bool operator==(const FragmentState& other) const;
};

// Copies what the state uses; a unit of `to` that is not enabled then holds no image.
void copy_fragment_state(const FragmentState& from, FragmentState& to);

}  // namespace clearpipe::pipeline
