// Queries: state by name from queries.def, and the state of lights, materials, textures and buffers
// (6.1).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <initializer_list>
#include <span>

#include "api/compressed_format.h"
#include "api/exec.h"
#include "api/framebuffer.h"
#include "api/raster_tokens.h"
#include "api/texture_target.h"
#include "api/validate.h"

namespace clearpipe::api {

namespace {

void put_number(const Out& out, std::initializer_list<float> values) {
  int i = 0;
  for (const float v : values) out.number(i++, v);
}
void put_colour(const Out& out, std::initializer_list<float> values) {
  int i = 0;
  for (const float v : values) out.colour(i++, v);
}
void put_integer(const Out& out, std::initializer_list<GLint> values) {
  int i = 0;
  for (const GLint v : values) out.integer(i++, v);
}
void put_enumerant(const Out& out, std::initializer_list<GLenum> values) {
  int i = 0;
  for (const GLenum v : values) out.enumerant(i++, v);
}
void put_enumerants(const Out& out, std::span<const GLenum> values) {
  int i = 0;
  for (const GLenum v : values) out.enumerant(i++, v);
}
void put_boolean(const Out& out, std::initializer_list<bool> values) {
  int i = 0;
  for (const bool v : values) out.boolean(i++, v);
}
void put_vec4(const Out& out, const Vec4& v) { put_colour(out, {v.x, v.y, v.z, v.w}); }

GLint colour_bits(const pipeline::Target& target, size_t component) {
  if (!target.colour || (component == 3 && !target.colour->has_alpha)) return 0;
  return pipeline::component_bits(target.colour->format)[component];
}

const Mat4* matrix_of(const State& s, size_t active, GLenum pname) {
  switch (pname) {
    case GL_MODELVIEW_MATRIX:
    case GL_MODELVIEW_MATRIX_FLOAT_AS_INT_BITS_OES:
      return &s.transform.modelview.top();
    case GL_PROJECTION_MATRIX:
    case GL_PROJECTION_MATRIX_FLOAT_AS_INT_BITS_OES:
      return &s.transform.projection.top();
    case GL_TEXTURE_MATRIX:
    case GL_TEXTURE_MATRIX_FLOAT_AS_INT_BITS_OES:
      return &s.transform.texture[active].top();
    default:
      return nullptr;
  }
}

// The array that a name of GetPointerv belongs to; 0 if it is none.
GLenum array_of_pointer(GLenum pname) {
  switch (pname) {
    case GL_VERTEX_ARRAY_POINTER:
      return GL_VERTEX_ARRAY;
    case GL_NORMAL_ARRAY_POINTER:
      return GL_NORMAL_ARRAY;
    case GL_COLOR_ARRAY_POINTER:
      return GL_COLOR_ARRAY;
    case GL_TEXTURE_COORD_ARRAY_POINTER:
      return GL_TEXTURE_COORD_ARRAY;
    case GL_POINT_SIZE_ARRAY_POINTER_OES:
      return GL_POINT_SIZE_ARRAY_OES;
    case GL_MATRIX_INDEX_ARRAY_POINTER_OES:
      return GL_MATRIX_INDEX_ARRAY_OES;
    case GL_WEIGHT_ARRAY_POINTER_OES:
      return GL_WEIGHT_ARRAY_OES;
    default:
      return 0;
  }
}

// Writes the value of `pname`; false if there is none. `out` may be null, to ask only.
bool query(const Context& c, GLenum pname, const Out* out) {
  const State& s = c.state;
  const size_t active = static_cast<size_t>(s.texture.active);
  const size_t client = static_cast<size_t>(s.arrays.client_active_texture);
  const auto draw = [&c] { return draw_target(c); };
  if (const Mat4* matrix = matrix_of(s, active, pname)) {
    const bool bits = pname >= GL_MODELVIEW_MATRIX_FLOAT_AS_INT_BITS_OES;
    for (int i = 0; out && i < 16; ++i) {
      const float value = matrix->m[static_cast<size_t>(i)];
      if (bits) {
        out->integer(i, std::bit_cast<GLint>(value));
      } else {
        out->number(i, value);
      }
    }
    return true;
  }
  switch (pname) {
#define QUERY(name, kind, ...)                \
  case name:                                  \
    if (out) put_##kind(*out, {__VA_ARGS__}); \
    return true;
#include "api/queries.def"
#undef QUERY
    default:
      return false;
  }
}

}  // namespace

namespace validate {

Invalid get(const Context& c, GLenum pname, const Out&) {
  return enum_unless(query(c, pname, nullptr) || !is_enabled(c, pname),
                     "{0} is no state that GetBooleanv and its like return (6.1.1, 6.2)");
}

Invalid get_string(const Context&, GLenum name) {
  return enum_unless(
      name == GL_VENDOR || name == GL_RENDERER || name == GL_VERSION || name == GL_EXTENSIONS,
      "{0} is no string (6.1.5)");
}

Invalid get_pointer(const Context&, GLenum pname, void**) {
  return enum_unless(array_of_pointer(pname) != 0 || pname == GL_DEBUG_CALLBACK_FUNCTION_KHR ||
                         pname == GL_DEBUG_CALLBACK_USER_PARAM_KHR,
                     "{0} is no pointer (6.1.5)");
}

Invalid get_light(const Context&, GLenum light, GLenum pname, const Out&) {
  if (light < GL_LIGHT0 || light >= GL_LIGHT0 + kLights) {
    return {GL_INVALID_ENUM, "{0} is none of LIGHT0 to LIGHT7 (6.1.3)"};
  }
  return enum_unless(pname == GL_AMBIENT || pname == GL_DIFFUSE || pname == GL_SPECULAR ||
                         (pname >= GL_POSITION && pname <= GL_QUADRATIC_ATTENUATION),
                     "{1} is no parameter of a light (6.1.3, table 6.10)");
}

Invalid get_material(const Context&, GLenum face, GLenum pname, const Out&) {
  if (face != GL_FRONT && face != GL_BACK) {
    return {GL_INVALID_ENUM, "{0} is neither FRONT nor BACK (6.1.3)"};
  }
  return enum_unless(pname == GL_AMBIENT || pname == GL_DIFFUSE || pname == GL_SPECULAR ||
                         pname == GL_EMISSION || pname == GL_SHININESS,
                     "{1} is no single parameter of a material (6.1.3, table 6.9)");
}

Invalid get_tex_env(const Context& c, GLenum target, GLenum pname, const Out&) {
  // The names that can be set are those that can be asked for; 1 is valid for none but the scales.
  const GLfloat probe_mode[4] = {GL_REPLACE}, probe_source[4] = {GL_PREVIOUS},
                probe_operand[4] = {GL_SRC_ALPHA}, probe_scale[4] = {1};
  Invalid wrong;
  for (const GLfloat* probe : {probe_mode, probe_source, probe_operand, probe_scale}) {
    wrong = tex_env(c, target, pname, Params(probe));
    if (!wrong) break;
  }
  return wrong;
}

Invalid get_tex_gen(const Context&, GLenum coord, GLenum pname, const Out&) {
  return generated_mode(coord, pname);
}

Invalid get_tex_parameter(const Context&, GLenum target, GLenum pname, const Out&) {
  if (const Invalid wrong = texture_target(target)) return wrong;
  return enum_unless(
      pname == GL_TEXTURE_MIN_FILTER || pname == GL_TEXTURE_MAG_FILTER ||
          pname == GL_TEXTURE_WRAP_S || pname == GL_TEXTURE_WRAP_T || pname == GL_GENERATE_MIPMAP ||
          pname == GL_TEXTURE_CROP_RECT_OES || pname == GL_TEXTURE_IMMUTABLE_FORMAT_EXT ||
          pname == GL_TEXTURE_MAX_LEVEL_APPLE || pname == GL_TEXTURE_MAX_ANISOTROPY_EXT ||
          pname == GL_REQUIRED_TEXTURE_IMAGE_UNITS_OES,
      "{1} is no parameter of textures (6.1.3, table 6.14)");
}

Invalid get_buffer_parameter(const Context& c, GLenum target, GLenum pname, const GLint*) {
  if (const Invalid wrong = buffer_target(c, target, 0)) return wrong;
  if (pname != GL_BUFFER_SIZE && pname != GL_BUFFER_USAGE && pname != GL_BUFFER_ACCESS_OES &&
      pname != GL_BUFFER_MAPPED_OES) {
    return {GL_INVALID_ENUM, "{1} is no parameter of buffer objects (6.1.6, table 6.6)"};
  }
  return operation_unless(bound_buffer(c, target) != nullptr, kNoBuffer);
}

}  // namespace validate

namespace exec {

void get(Context& c, GLenum pname, const Out& out) {
  if (!query(c, pname, &out)) out.boolean(0, is_enabled(c, pname) != 0);
}

const GLubyte* get_string(Context& c, GLenum name) {
  const char* text = "";
  switch (name) {
    case GL_VENDOR:
      text = "clearpipe";
      break;
    case GL_RENDERER:
      text = c.renderer.c_str();
      break;
    case GL_VERSION:
      text = "OpenGL ES-CM 1.1 clearpipe 0.1.0";
      break;
    default:
      text =
#define EXTENSION(name) "GL_" #name " "
#include "api/extensions.def"
#undef EXTENSION
          ;
  }
  return reinterpret_cast<const GLubyte*>(text);
}

void get_pointer(Context& c, GLenum pname, void** params) {
  if (pname == GL_DEBUG_CALLBACK_FUNCTION_KHR) {
    *params = reinterpret_cast<void*>(c.debug.callback);
    return;
  }
  if (pname == GL_DEBUG_CALLBACK_USER_PARAM_KHR) {
    *params = const_cast<void*>(c.debug.user_param);
    return;
  }
  *params = const_cast<void*>(find_array(c.state.arrays, array_of_pointer(pname))->pointer);
}

GLboolean is_enabled(Context& c, GLenum cap) {
  if (const ArrayState* array = find_array(c.state.arrays, cap)) return array->enabled;
  return *capability(c, cap).value;
}

void get_clip_plane(Context& c, GLenum plane, const Out& out) {
  const Vec4& v = c.state.transform.clip_plane[plane - GL_CLIP_PLANE0];
  put_number(out, {v.x, v.y, v.z, v.w});
}

void get_light(Context& c, GLenum light, GLenum pname, const Out& out) {
  const LightState& l = c.state.lighting.light[light - GL_LIGHT0];
  switch (pname) {
    case GL_AMBIENT:
      put_vec4(out, l.ambient);
      break;
    case GL_DIFFUSE:
      put_vec4(out, l.diffuse);
      break;
    case GL_SPECULAR:
      put_vec4(out, l.specular);
      break;
    case GL_POSITION:
      put_number(out, {l.position.x, l.position.y, l.position.z, l.position.w});
      break;
    case GL_SPOT_DIRECTION:
      put_number(out, {l.spot_direction.x, l.spot_direction.y, l.spot_direction.z});
      break;
    case GL_SPOT_EXPONENT:
      out.number(0, l.spot_exponent);
      break;
    case GL_SPOT_CUTOFF:
      out.number(0, l.spot_cutoff);
      break;
    default:
      out.number(0, l.attenuation[pname - GL_CONSTANT_ATTENUATION]);
      break;
  }
}

void get_material(Context& c, GLenum, GLenum pname, const Out& out) {
  const LightingState& l = c.state.lighting;
  switch (pname) {
    case GL_AMBIENT:
      put_vec4(out, l.ambient);
      break;
    case GL_DIFFUSE:
      put_vec4(out, l.diffuse);
      break;
    case GL_SPECULAR:
      put_vec4(out, l.specular);
      break;
    case GL_EMISSION:
      put_vec4(out, l.emission);
      break;
    default:
      out.number(0, l.shininess);
      break;
  }
}

void get_tex_env(Context& c, GLenum target, GLenum pname, const Out& out) {
  const TextureUnitState& u = c.active_unit();
  if (target == GL_POINT_SPRITE_OES) return out.boolean(0, u.coord_replace);
  if (target == GL_TEXTURE_FILTER_CONTROL_EXT) return out.number(0, u.lod_bias);
  switch (pname) {
    case GL_TEXTURE_ENV_MODE:
      out.enumerant(0, u.env_mode);
      break;
    case GL_TEXTURE_ENV_COLOR:
      put_vec4(out, u.env_colour);
      break;
    case GL_COMBINE_RGB:
      out.enumerant(0, u.combine_rgb);
      break;
    case GL_COMBINE_ALPHA:
      out.enumerant(0, u.combine_alpha);
      break;
    case GL_RGB_SCALE:
      out.number(0, u.rgb_scale);
      break;
    case GL_ALPHA_SCALE:
      out.number(0, u.alpha_scale);
      break;
    case GL_SRC0_RGB:
    case GL_SRC1_RGB:
    case GL_SRC2_RGB:
      out.enumerant(0, u.src_rgb[pname - GL_SRC0_RGB]);
      break;
    case GL_SRC0_ALPHA:
    case GL_SRC1_ALPHA:
    case GL_SRC2_ALPHA:
      out.enumerant(0, u.src_alpha[pname - GL_SRC0_ALPHA]);
      break;
    case GL_OPERAND0_RGB:
    case GL_OPERAND1_RGB:
    case GL_OPERAND2_RGB:
      out.enumerant(0, u.operand_rgb[pname - GL_OPERAND0_RGB]);
      break;
    default:
      out.enumerant(0, u.operand_alpha[pname - GL_OPERAND0_ALPHA]);
      break;
  }
}

void get_tex_gen(Context& c, GLenum, GLenum, const Out& out) {
  out.enumerant(0, c.active_unit().gen_mode);
}

void get_tex_parameter(Context& c, GLenum target, GLenum pname, const Out& out) {
  const TextureObject& t = *bound_texture(c, target);
  switch (pname) {
    case GL_TEXTURE_MIN_FILTER:
      out.enumerant(0, t.min_filter);
      break;
    case GL_TEXTURE_MAG_FILTER:
      out.enumerant(0, t.mag_filter);
      break;
    case GL_TEXTURE_WRAP_S:
      out.enumerant(0, t.wrap_s);
      break;
    case GL_TEXTURE_WRAP_T:
      out.enumerant(0, t.wrap_t);
      break;
    case GL_REQUIRED_TEXTURE_IMAGE_UNITS_OES:
      out.integer(0, 1);
      break;
    case GL_TEXTURE_IMMUTABLE_FORMAT_EXT:
      out.boolean(0, t.storage_levels > 0);
      break;
    case GL_TEXTURE_CROP_RECT_OES:
      put_integer(out, {t.crop_rect[0], t.crop_rect[1], t.crop_rect[2], t.crop_rect[3]});
      break;
    case GL_TEXTURE_MAX_LEVEL_APPLE:
      out.integer(0, t.max_level);
      break;
    case GL_TEXTURE_MAX_ANISOTROPY_EXT:
      out.number(0, t.max_anisotropy);
      break;
    default:
      out.boolean(0, t.generate_mipmap);
      break;
  }
}

void get_buffer_parameter(Context& c, GLenum target, GLenum pname, GLint* params) {
  const ArraysState& a = c.state.arrays;
  const BufferObject& buffer =
      *(target == GL_ARRAY_BUFFER ? a.array_buffer : a.element_array_buffer);
  *params = pname == GL_BUFFER_SIZE         ? saturate_int(static_cast<double>(buffer.data->size()))
            : pname == GL_BUFFER_USAGE      ? static_cast<GLint>(buffer.usage)
            : pname == GL_BUFFER_MAPPED_OES ? buffer.mapped
                                            : GL_WRITE_ONLY_OES;
}

// OES_query_matrix: component i is mantissa[i] * 2^exponent[i]; a set bit marks one that is not a
// finite number. All 24 bits of a float fit into a mantissa between 2^13 and 2^14.
GLbitfield query_matrix(Context& c, GLfixed* mantissa, GLint* exponent) {
  constexpr int kIntegerBits = 14;
  GLbitfield invalid = 0;
  const Mat4& matrix = current_stack(c).top();
  for (unsigned i = 0; i < 16; ++i) {
    mantissa[i] = 0;
    exponent[i] = 0;
    const float value = matrix.m[i];
    if (!std::isfinite(value)) {
      invalid |= 1u << i;
    } else if (value != 0) {
      mantissa[i] = to_fixed(std::ldexp(std::frexp(value, &exponent[i]), kIntegerBits));
      exponent[i] -= kIntegerBits;
    }
  }
  return invalid;
}

}  // namespace exec

}  // namespace clearpipe::api
