// Colours of vertices (2.12): the lighting equation, colour material, clamping.
//
//   c = ecm + acm * acs + sum over lights of
//         att spot [ acm * acl + (n . VP) dcm * dcl + f (n . h)^srm scm * scl ]
//
// The viewer is at (0,0,-infinity) always, hence h is VP + (0,0,1). Alpha is that of dcm. With
// two-sided lighting the back colour is the same equation with -n.
// SPDX-License-Identifier: MIT
#if defined(CLEARPIPE_VERTEX_LIGHTING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARPIPE_VERTEX_LIGHTING_INL_H_
#undef CLEARPIPE_VERTEX_LIGHTING_INL_H_
#else
#define CLEARPIPE_VERTEX_LIGHTING_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "pipeline/vertex/math-inl.h"
#include "pipeline/vertex/transform-inl.h"
#include "pipeline/vertex/vertex_batch.h"

HWY_BEFORE_NAMESPACE();
namespace clearpipe::pipeline::vertex::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using FloatVector = hn::Vec<FloatTag>;

struct Direction {
  FloatVector x, y, z;
};

struct Rgb {
  FloatVector r, g, b;
};

// Without lighting the current colour is the primary colour (2.12.5).
HWY_INLINE void clamp_colour(const Lane* in, size_t count, Lane* out) {
  const FloatTag d;
  for (int c = 0; c < 4; ++c) {
    for (size_t i = 0; i < count; i += hn::Lanes(d)) {
      hn::Store(clamp_to_unit(d, hn::Load(d, in[c] + i)), d, out[c] + i);
    }
  }
}

// The unit vector of v, and v's length; the zero vector stays zero.
HWY_INLINE Direction unit_vector(FloatTag d, const Direction& v, FloatVector& length) {
  length = hn::Sqrt(dot3(v.x, v.y, v.z, v.x, v.y, v.z));
  const auto nonzero = hn::Gt(length, hn::Zero(d));
  return {hn::IfThenElseZero(nonzero, hn::Div(v.x, length)),
          hn::IfThenElseZero(nonzero, hn::Div(v.y, length)),
          hn::IfThenElseZero(nonzero, hn::Div(v.z, length))};
}

HWY_INLINE Direction uniform(FloatTag d, const Vec4& v) {
  return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

// n . v of the equation: the dot product, but not below 0.
HWY_INLINE FloatVector positive_dot(FloatTag d, const Direction& a, const Direction& b) {
  return at_least(dot3(a.x, a.y, a.z, b.x, b.y, b.z), hn::Zero(d));
}

// Where one light stands as seen from a vertex, and how much of it arrives there.
struct Incidence {
  Direction to_light;     // VP
  Direction half_vector;  // h, unit
  FloatVector intensity;  // att * spot
};

// 1 / (k0 + k1 dist + k2 dist^2), equation 2.4.
HWY_INLINE FloatVector attenuation(FloatTag d, const Light& light, FloatVector distance) {
  const auto linear = hn::Mul(hn::Set(d, light.attenuation[1]), distance);
  const auto quadratic = hn::Mul(hn::Set(d, light.attenuation[2]), hn::Mul(distance, distance));
  const auto sum = hn::Add(hn::Add(hn::Set(d, light.attenuation[0]), linear), quadratic);
  return hn::Div(hn::Set(d, 1.0f), sum);
}

// Equation 2.5: (PV . sd)^sr inside the cone, 0 outside.
HWY_INLINE FloatVector spot_factor(FloatTag d, const Light& light, const Direction& to_light) {
  const Direction from_light = {hn::Neg(to_light.x), hn::Neg(to_light.y), hn::Neg(to_light.z)};
  const auto cosine = positive_dot(d, from_light, uniform(d, light.spot_direction));
  const auto inside = hn::Ge(cosine, hn::Set(d, light.spot_cutoff_cos));
  if (light.spot_exponent == 0) {
    return hn::IfThenElseZero(inside, hn::Set(d, 1.0f));
  }
  return hn::IfThenElseZero(inside, power(d, cosine, hn::Set(d, light.spot_exponent)));
}

// `place` is the vertex in eye coordinates, divided by w.
HWY_INLINE Incidence incidence(FloatTag d, const Light& light, const Direction& place) {
  Incidence result;
  result.intensity = hn::Set(d, 1.0f);
  if (light.positional) {
    const Vec4& p = light.position;
    const Direction to_light = {hn::Sub(hn::Set(d, p.x / p.w), place.x),
                                hn::Sub(hn::Set(d, p.y / p.w), place.y),
                                hn::Sub(hn::Set(d, p.z / p.w), place.z)};
    FloatVector distance, unused;
    result.to_light = unit_vector(d, to_light, distance);
    const Direction sum = {result.to_light.x, result.to_light.y,
                           hn::Add(result.to_light.z, hn::Set(d, 1.0f))};
    result.half_vector = unit_vector(d, sum, unused);
    if (light.attenuated) {
      result.intensity = attenuation(d, light, distance);
    }
  } else {
    result.to_light = uniform(d, light.position);
    result.half_vector = uniform(d, light.half_vector);
  }
  if (light.spot) {
    result.intensity = hn::Mul(result.intensity, spot_factor(d, light, result.to_light));
  }
  return result;
}

// What the material makes of the light: its colours at one vertex.
struct MaterialColours {
  Rgb ambient, diffuse, specular;
};

HWY_INLINE void add_light(FloatTag d, const Light& light, const Incidence& at,
                          const MaterialColours& material, float shininess, const Direction& normal,
                          Rgb& colour) {
  const auto n_dot_l = positive_dot(d, normal, at.to_light);
  const auto n_dot_h = positive_dot(d, normal, at.half_vector);
  const auto lit = hn::Gt(n_dot_l, hn::Zero(d));
  auto specular = hn::Zero(d);
  if (!hn::AllFalse(d, lit)) {
    const auto shine = shininess == 0 ? hn::Set(d, 1.0f) : power(d, n_dot_h, hn::Set(d, shininess));
    specular = hn::IfThenElseZero(lit, shine);
  }
  const auto channel = [&](FloatVector a, float la, FloatVector df, float ld, FloatVector s,
                           float ls) HWY_ATTR {
    const auto ambient = hn::Mul(a, hn::Set(d, la));
    const auto diffuse = hn::Mul(n_dot_l, hn::Mul(df, hn::Set(d, ld)));
    const auto highlight = hn::Mul(specular, hn::Mul(s, hn::Set(d, ls)));
    return hn::Mul(at.intensity, hn::Add(hn::Add(ambient, diffuse), highlight));
  };
  const MaterialColours& m = material;
  colour.r = hn::Add(colour.r, channel(m.ambient.r, light.ambient.x, m.diffuse.r, light.diffuse.x,
                                       m.specular.r, light.specular.x));
  colour.g = hn::Add(colour.g, channel(m.ambient.g, light.ambient.y, m.diffuse.g, light.diffuse.y,
                                       m.specular.g, light.specular.y));
  colour.b = hn::Add(colour.b, channel(m.ambient.b, light.ambient.z, m.diffuse.b, light.diffuse.z,
                                       m.specular.b, light.specular.z));
}

HWY_INLINE Rgb uniform_rgb(FloatTag d, const Vec4& v) {
  return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

HWY_INLINE void store_colour(FloatTag d, const Rgb& colour, FloatVector alpha, size_t i,
                             Lane* out) {
  hn::Store(clamp_to_unit(d, colour.r), d, out[0] + i);
  hn::Store(clamp_to_unit(d, colour.g), d, out[1] + i);
  hn::Store(clamp_to_unit(d, colour.b), d, out[2] + i);
  hn::Store(clamp_to_unit(d, alpha), d, out[3] + i);
}

// Lights `count` vertices. `current` is the vertex colour, read with colour material only;
// `back_colour` is written with two-sided lighting only.
HWY_INLINE void light_vertices(const VertexState& state, const Lane* eye, const Lane* normals,
                               const Lane* current, size_t count, Lane* colour, Lane* back_colour) {
  const FloatTag d;
  const Material& m = state.material;
  const bool positional =
      std::any_of(state.lights.begin(), state.lights.end(),
                  [](const Light& light) { return light.enabled && light.positional; });
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    MaterialColours material = {uniform_rgb(d, m.ambient), uniform_rgb(d, m.diffuse),
                                uniform_rgb(d, m.specular)};
    auto alpha = hn::Set(d, m.diffuse.w);
    if (state.colour_material) {
      material.ambient = {hn::Load(d, current[0] + i), hn::Load(d, current[1] + i),
                          hn::Load(d, current[2] + i)};
      material.diffuse = material.ambient;
      alpha = hn::Load(d, current[3] + i);
    }
    const Rgb emission = uniform_rgb(d, m.emission);
    const Rgb scene = uniform_rgb(d, state.scene_ambient);
    Rgb front = {hn::Add(emission.r, hn::Mul(material.ambient.r, scene.r)),
                 hn::Add(emission.g, hn::Mul(material.ambient.g, scene.g)),
                 hn::Add(emission.b, hn::Mul(material.ambient.b, scene.b))};
    Rgb back = front;
    const Direction n = {hn::Load(d, normals[0] + i), hn::Load(d, normals[1] + i),
                         hn::Load(d, normals[2] + i)};
    const Direction minus_n = {hn::Neg(n.x), hn::Neg(n.y), hn::Neg(n.z)};
    Direction place = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    if (positional) {
      const auto w = hn::Load(d, eye[3] + i);
      place = {hn::Div(hn::Load(d, eye[0] + i), w), hn::Div(hn::Load(d, eye[1] + i), w),
               hn::Div(hn::Load(d, eye[2] + i), w)};
    }
    for (const Light& light : state.lights) {
      if (!light.enabled) {
        continue;
      }
      const Incidence at = incidence(d, light, place);
      add_light(d, light, at, material, m.shininess, n, front);
      if (state.two_sided) {
        add_light(d, light, at, material, m.shininess, minus_n, back);
      }
    }
    store_colour(d, front, alpha, i, colour);
    if (state.two_sided) {
      store_colour(d, back, alpha, i, back_colour);
    }
  }
}

}  // namespace clearpipe::pipeline::vertex::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CLEARPIPE_VERTEX_LIGHTING_INL_H_
