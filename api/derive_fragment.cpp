// Fragment state from GL state: samplers, texture environments as combiners, fog, and the
// per-fragment operations (3.7, 3.8, 4.1).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "api/context_state.h"
#include "api/framebuffer.h"
#include "api/pixel_format.h"
#include "api/texture_target.h"

namespace clearpipe::api {

namespace {

using pipeline::BlendEquation;
using pipeline::BlendFactor;
using pipeline::Combine;
using pipeline::CombineArgument;
using pipeline::CombineOperand;
using pipeline::Combiner;
using pipeline::CombineSource;
using pipeline::Filter;
using pipeline::MipFilter;
using pipeline::StencilOp;
using pipeline::Wrap;

pipeline::CompareFunc compare(GLenum func) {
  return static_cast<pipeline::CompareFunc>(func - GL_NEVER);
}

Wrap wrap(GLenum mode) {
  return mode == GL_CLAMP_TO_EDGE         ? Wrap::kClampToEdge
         : mode == GL_MIRRORED_REPEAT_OES ? Wrap::kMirroredRepeat
                                          : Wrap::kRepeat;
}

pipeline::Sampler derive_sampler(const TextureObject& texture, float lod_bias) {
  pipeline::Sampler s;
  s.lod_bias = std::clamp(lod_bias, -kMaxTextureLodBias, kMaxTextureLodBias);
  // A footprint may reach over the edge of a cube map's face: those are sampled once.
  s.max_anisotropy = texture.target == GL_TEXTURE_CUBE_MAP_OES
                         ? 1
                         : std::min(texture.max_anisotropy, kMaxAnisotropy);
  s.wrap_s = wrap(texture.wrap_s);
  s.wrap_t = wrap(texture.wrap_t);
  s.mag = texture.mag_filter == GL_LINEAR ? Filter::kLinear : Filter::kNearest;
  const GLenum min = texture.min_filter;
  s.min = min == GL_LINEAR || min == GL_LINEAR_MIPMAP_NEAREST || min == GL_LINEAR_MIPMAP_LINEAR
              ? Filter::kLinear
              : Filter::kNearest;
  if (!is_mipmap_filter(min)) {
    s.mip = MipFilter::kNone;
    return s;
  }
  s.mip = min == GL_NEAREST_MIPMAP_NEAREST || min == GL_LINEAR_MIPMAP_NEAREST ? MipFilter::kNearest
                                                                              : MipFilter::kLinear;
  s.max_level = last_mipmap_level(texture);
  return s;
}

Combine combine(GLenum mode) {
  switch (mode) {
    case GL_REPLACE:
      return Combine::kReplace;
    case GL_MODULATE:
      return Combine::kModulate;
    case GL_ADD:
      return Combine::kAdd;
    case GL_ADD_SIGNED:
      return Combine::kAddSigned;
    case GL_INTERPOLATE:
      return Combine::kInterpolate;
    case GL_SUBTRACT:
      return Combine::kSubtract;
    case GL_DOT3_RGB:
      return Combine::kDot3Rgb;
    default:
      return Combine::kDot3Rgba;
  }
}

CombineSource at_unit(size_t unit) { return static_cast<CombineSource>(unit); }

CombineArgument argument(GLenum source, GLenum operand, size_t unit) {
  CombineArgument a;
  switch (source) {
    case GL_TEXTURE:
      a.source = at_unit(unit);
      break;
    case GL_CONSTANT:
      a.source = CombineSource::kConstant;
      break;
    case GL_PRIMARY_COLOR:
      a.source = CombineSource::kPrimaryColour;
      break;
    case GL_PREVIOUS:
      a.source = CombineSource::kPrevious;
      break;
    default:
      a.source = at_unit(source - GL_TEXTURE0);
      break;
  }
  a.operand = operand == GL_SRC_COLOR             ? CombineOperand::kColour
              : operand == GL_ONE_MINUS_SRC_COLOR ? CombineOperand::kOneMinusColour
              : operand == GL_SRC_ALPHA           ? CombineOperand::kAlpha
                                                  : CombineOperand::kOneMinusAlpha;
  return a;
}

uint8_t scale_log2(float scale) { return scale == 4 ? 2 : scale == 2 ? 1 : 0; }

Combiner derive_combine(const TextureUnitState& s, size_t unit) {
  Combiner c;
  c.rgb = combine(s.combine_rgb);
  c.alpha = combine(s.combine_alpha);
  for (size_t i = 0; i < 3; ++i) {
    c.rgb_argument[i] = argument(s.src_rgb[i], s.operand_rgb[i], unit);
    c.alpha_argument[i] = argument(s.src_alpha[i], s.operand_alpha[i], unit);
  }
  c.rgb_scale_log2 = scale_log2(s.rgb_scale);
  c.alpha_scale_log2 = scale_log2(s.alpha_scale);
  return c;
}

// Whether every unit whose texture the combiner uses samples one; else it is as if texture blending
// were disabled for the combiner's unit (OES_texture_env_crossbar).
bool has_its_textures(const Combiner& combiner,
                      const std::array<pipeline::TextureUnit, kTextureUnits>& units) {
  const auto has = [&units](const std::array<CombineArgument, 3>& arguments, int count) {
    return std::all_of(arguments.begin(), arguments.begin() + count, [&](CombineArgument a) {
      const size_t unit = static_cast<size_t>(a.source);
      return unit >= kTextureUnits || units[unit].enabled;
    });
  };
  return has(combiner.rgb_argument, argument_count(combiner.rgb)) &&
         (combiner.rgb == Combine::kDot3Rgba ||
          has(combiner.alpha_argument, argument_count(combiner.alpha)));
}

Combiner previous_colour() {
  Combiner c;
  c.rgb_argument.fill({CombineSource::kPrevious, CombineOperand::kColour});
  c.alpha_argument.fill({CombineSource::kPrevious, CombineOperand::kAlpha});
  return c;
}

// The environments of tables 3.15 and 3.16. A component the texture's base format lacks leaves the
// previous value, except for BLEND and ADD of alpha formats, which the tables spell out.
Combiner derive_classic(GLenum mode, GLenum format, size_t unit) {
  const CombineArgument texture{at_unit(unit), CombineOperand::kColour};
  const CombineArgument texture_alpha{at_unit(unit), CombineOperand::kAlpha};
  const CombineArgument previous{CombineSource::kPrevious, CombineOperand::kColour};
  const CombineArgument previous_alpha{CombineSource::kPrevious, CombineOperand::kAlpha};
  const CombineArgument constant{CombineSource::kConstant, CombineOperand::kColour};
  const bool has_colour = format != GL_ALPHA;
  const bool has_alpha = format == GL_ALPHA || format == GL_LUMINANCE_ALPHA || format == GL_RGBA;

  Combiner c = previous_colour();
  if (mode == GL_DECAL) {
    // Cp (1 - At) + Ct At; the alpha is the previous one. Without alpha, Ct. Undefined for others.
    if (format == GL_RGBA) {
      c.rgb = Combine::kInterpolate;
      c.rgb_argument = {texture, previous, texture_alpha};
    } else if (format == GL_RGB) {
      c.rgb_argument[0] = texture;
    }
    return c;
  }
  if (has_colour) {
    switch (mode) {
      case GL_REPLACE:
        c.rgb_argument[0] = texture;
        break;
      case GL_MODULATE:
        c.rgb = Combine::kModulate;
        c.rgb_argument = {previous, texture, previous};
        break;
      case GL_BLEND:  // Cp (1 - Ct) + Cc Ct
        c.rgb = Combine::kInterpolate;
        c.rgb_argument = {constant, previous, texture};
        break;
      default:
        c.rgb = Combine::kAdd;
        c.rgb_argument = {previous, texture, previous};
        break;
    }
  }
  if (has_alpha) {
    if (mode == GL_REPLACE) {
      c.alpha_argument[0] = texture_alpha;
    } else {
      c.alpha = Combine::kModulate;
      c.alpha_argument = {previous_alpha, texture_alpha, previous_alpha};
    }
  }
  return c;
}

// The environments of IMG_texture_env_enhanced_fixed_function. Components that the base format
// lacks are 0 in colours and 1 in alpha here (table 3.14), which is what most of its table comes
// to.
Combiner derive_img(GLenum mode, GLenum format, size_t unit) {
  const CombineArgument texture{at_unit(unit), CombineOperand::kColour};
  const CombineArgument texture_alpha{at_unit(unit), CombineOperand::kAlpha};
  const CombineArgument previous{CombineSource::kPrevious, CombineOperand::kColour};
  const CombineArgument previous_alpha{CombineSource::kPrevious, CombineOperand::kAlpha};
  const CombineArgument constant_alpha{CombineSource::kConstant, CombineOperand::kAlpha};
  Combiner c = previous_colour();
  switch (mode) {
    case GL_MODULATE_COLOR_IMG:  // Cf Cs; the alpha is the texture's
      if (format != GL_ALPHA) {
        c.rgb = Combine::kModulate;
        c.rgb_argument = {previous, texture, previous};
      }
      if (format != GL_LUMINANCE && format != GL_RGB) c.alpha_argument[0] = texture_alpha;
      return c;
    case GL_RECIP_ADD_SIGNED_ALPHA_IMG:  // the colour is kept; (1 - As) + Af - 1/2
      c.alpha = Combine::kAddSigned;
      c.alpha_argument = {CombineArgument{at_unit(unit), CombineOperand::kOneMinusAlpha},
                          previous_alpha, previous_alpha};
      return c;
    case GL_TEXTURE_ALPHA_MODULATE_IMG:  // As Cs, As
      c.rgb_argument = {texture, texture_alpha, texture};
      c.alpha_argument[0] = texture_alpha;
      break;
    case GL_FACTOR_ALPHA_MODULATE_IMG:  // Ac Cs, Ac
      c.rgb_argument = {texture, constant_alpha, texture};
      c.alpha_argument[0] = constant_alpha;
      break;
    case GL_FRAGMENT_ALPHA_MODULATE_IMG:  // Af Cs, Af
      c.rgb_argument = {texture, previous_alpha, texture};
      break;
    case GL_ADD_BLEND_IMG:  // Cf + (1 - Af) Cs, Af As
      c.rgb = Combine::kModulateAdd;
      c.rgb_argument = {texture, previous,
                        CombineArgument{CombineSource::kPrevious, CombineOperand::kOneMinusAlpha}};
      c.alpha = Combine::kModulate;
      c.alpha_argument = {previous_alpha, texture_alpha, previous_alpha};
      return c;
    default:  // DOT3_RGBA_IMG
      c.rgb = Combine::kDot3Rgba;
      c.rgb_argument = {previous, texture, previous};
      return c;
  }
  c.rgb = Combine::kModulate;
  return c;
}

bool is_img(GLenum mode) {
  return (mode >= GL_MODULATE_COLOR_IMG && mode <= GL_ADD_BLEND_IMG) || mode == GL_DOT3_RGBA_IMG;
}

Combiner derive_environment(const TextureUnitState& s, GLenum format, size_t unit) {
  if (s.env_mode == GL_COMBINE) return derive_combine(s, unit);
  return is_img(s.env_mode) ? derive_img(s.env_mode, format, unit)
                            : derive_classic(s.env_mode, format, unit);
}

StencilOp stencil_op(GLenum op) {
  switch (op) {
    case GL_ZERO:
      return StencilOp::kZero;
    case GL_REPLACE:
      return StencilOp::kReplace;
    case GL_INCR:
      return StencilOp::kIncrement;
    case GL_DECR:
      return StencilOp::kDecrement;
    case GL_INVERT:
      return StencilOp::kInvert;
    case GL_INCR_WRAP_OES:
      return StencilOp::kIncrementWrap;
    case GL_DECR_WRAP_OES:
      return StencilOp::kDecrementWrap;
    default:
      return StencilOp::kKeep;
  }
}

BlendFactor blend_factor(GLenum factor) {
  switch (factor) {
    case GL_ZERO:
      return BlendFactor::kZero;
    case GL_ONE:
      return BlendFactor::kOne;
    case GL_SRC_COLOR:
      return BlendFactor::kSrcColour;
    case GL_ONE_MINUS_SRC_COLOR:
      return BlendFactor::kOneMinusSrcColour;
    case GL_DST_COLOR:
      return BlendFactor::kDstColour;
    case GL_ONE_MINUS_DST_COLOR:
      return BlendFactor::kOneMinusDstColour;
    case GL_SRC_ALPHA:
      return BlendFactor::kSrcAlpha;
    case GL_ONE_MINUS_SRC_ALPHA:
      return BlendFactor::kOneMinusSrcAlpha;
    case GL_DST_ALPHA:
      return BlendFactor::kDstAlpha;
    case GL_ONE_MINUS_DST_ALPHA:
      return BlendFactor::kOneMinusDstAlpha;
    default:
      return BlendFactor::kSrcAlphaSaturate;
  }
}

BlendEquation blend_equation(GLenum equation) {
  switch (equation) {
    case GL_FUNC_ADD_OES:
      return BlendEquation::kAdd;
    case GL_FUNC_SUBTRACT_OES:
      return BlendEquation::kSubtract;
    case GL_FUNC_REVERSE_SUBTRACT_OES:
      return BlendEquation::kReverseSubtract;
    case GL_MIN_EXT:
      return BlendEquation::kMin;
    default:
      return BlendEquation::kMax;
  }
}

void derive_operations(const Context& context, pipeline::FragmentOperations& f) {
  const FogState& fog = context.state.fog;
  f.fog = !fog.enabled            ? pipeline::FogMode::kNone
          : fog.mode == GL_LINEAR ? pipeline::FogMode::kLinear
          : fog.mode == GL_EXP    ? pipeline::FogMode::kExp
                                  : pipeline::FogMode::kExp2;
  f.fog_density = fog.density;
  f.fog_start = fog.start;
  f.fog_end = fog.end;
  f.fog_colour = fog.colour;
  const MultisampleState& multisample = context.state.multisample;
  f.alpha_to_coverage = multisample.alpha_to_coverage;
  f.alpha_to_one = multisample.alpha_to_one;
  f.sample_coverage = multisample.coverage;
  f.sample_coverage_value = multisample.coverage_value;
  f.sample_coverage_invert = multisample.coverage_invert;

  const PixelState& p = context.state.pixel;
  const FramebufferState& fb = context.state.framebuffer;
  const auto& planes = context.draw.depth_stencil;
  f.alpha_test = p.alpha_test;
  f.alpha_func = compare(p.alpha_func);
  f.alpha_reference = p.alpha_reference;
  f.stencil.enabled = p.stencil_test && planes && planes->has_stencil;
  f.stencil.func = compare(p.stencil_func);
  f.stencil.reference = static_cast<uint8_t>(std::clamp(p.stencil_reference, 0, 255));
  f.stencil.value_mask = static_cast<uint8_t>(p.stencil_value_mask);
  f.stencil.write_mask = static_cast<uint8_t>(fb.stencil_mask);
  f.stencil.fail = stencil_op(p.stencil_fail);
  f.stencil.depth_fail = stencil_op(p.stencil_depth_fail);
  f.stencil.pass = stencil_op(p.stencil_pass);
  f.depth_test = p.depth_test && planes && planes->has_depth;
  f.depth_write = fb.depth_mask;
  f.depth_func = compare(p.depth_func);
  // Blending is off while the logical operation is on (4.1.9).
  f.blend.enabled = p.blend && !p.logic_op_enabled;
  f.blend.src_rgb = blend_factor(p.src_rgb);
  f.blend.dst_rgb = blend_factor(p.dst_rgb);
  f.blend.src_alpha = blend_factor(p.src_alpha);
  f.blend.dst_alpha = blend_factor(p.dst_alpha);
  f.blend.rgb = blend_equation(p.equation_rgb);
  f.blend.alpha = blend_equation(p.equation_alpha);
  f.logic_op_enabled = p.logic_op_enabled;
  f.logic_op = static_cast<pipeline::LogicOp>(p.logic_op - GL_CLEAR);
  f.colour_mask = 0;
  for (unsigned i = 0; i < 4; ++i) {
    if (fb.colour_mask[i]) f.colour_mask = static_cast<uint8_t>(f.colour_mask | 1u << i);
  }
}

// What an external texture without an EGLImage is sampled as (OES_EGL_image_external, 3.7.14).
const pipeline::ImageRef& no_image() {
  static const pipeline::ImageRef image = [] {
    auto black = std::make_shared<pipeline::Image>();
    black->levels.push_back({1, 1, {0xff000000u}});
    return black;
  }();
  return image;
}

void derive_units(Context& context, std::array<pipeline::TextureUnit, kTextureUnits>& units) {
  const State& s = context.state;
  context.textured = 0;
  for (size_t u = 0; u < kTextureUnits; ++u) {
    const TextureObject* texture = enabled_texture(s.texture.unit[u]);
    pipeline::TextureUnit& unit = units[u];
    unit.enabled = texture && is_complete(*texture);
    context.texture_version[u] = texture ? texture->version : 0;
    if (texture) context.textured |= 1u << u;
    if (!unit.enabled && unit.image) unit = {};
  }
  for (size_t u = 0; context.textured >> u != 0; ++u) {
    const TextureUnitState& from = s.texture.unit[u];
    pipeline::TextureUnit& unit = units[u];
    if (!unit.enabled) continue;
    const TextureObject& texture = *enabled_texture(from);
    unit.cube = texture.target == GL_TEXTURE_CUBE_MAP_OES;
    unit.srgb = is_srgb(texture.level[0].internal);
    const bool absent = texture.level[0].width == 0;  // of an external texture
    unit.image = absent ? no_image() : texture.image;
    if (context.framebuffer && samples_its_target(context, texture)) {
      unit.image = std::make_shared<pipeline::Image>(*unit.image);
    }
    unit.sampler = derive_sampler(texture, from.lod_bias);
    unit.combiner = derive_environment(from, absent ? GL_RGBA : texture.level[0].format, u);
    if (!has_its_textures(unit.combiner, units)) unit.combiner = previous_colour();
    unit.constant = from.env_colour;
  }
}

}  // namespace

void derive_fragment(Context& context) {
  pipeline::FragmentState& f = context.fragment_state;
  if (context.dirty & kDirtyUnits) derive_units(context, f.unit);
  if (context.dirty & kDirtyFragment) derive_operations(context, f);
  context.frame.set_fragment_state(f);
}

}  // namespace clearpipe::api
