// Vertex state from GL state: matrices, lights, materials, clip planes and points (2.10 to 2.12,
// 3.3).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "api/context_state.h"
#include "api/matrix.h"
#include "api/texture_target.h"

namespace clearpipe::api {

namespace {

Vec4 unit(const Vec4& v) {
  const float length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  if (!(length > 0)) return {v.x, v.y, v.z, 0};
  return {v.x / length, v.y / length, v.z / length, 0};
}

pipeline::Light derive_light(const LightState& s) {
  pipeline::Light l;
  l.enabled = s.enabled;
  l.ambient = s.ambient;
  l.diffuse = s.diffuse;
  l.specular = s.specular;
  l.positional = s.position.w != 0;
  if (l.positional) {
    const float w = s.position.w;
    l.position = {s.position.x / w, s.position.y / w, s.position.z / w, 1};
  } else {
    l.position = unit(s.position);
    l.half_vector = unit({l.position.x, l.position.y, l.position.z + 1, 0});
  }
  l.spot = s.spot_cutoff != 180;
  l.spot_direction = unit(s.spot_direction);
  l.spot_exponent = s.spot_exponent;
  double sine, cosine;
  sin_cos(static_cast<double>(s.spot_cutoff) * 3.14159265358979323846 / 180.0, sine, cosine);
  l.spot_cutoff_cos = static_cast<float>(cosine);
  std::copy_n(s.attenuation, 3, l.attenuation);
  l.attenuated =
      l.positional && (s.attenuation[0] != 1 || s.attenuation[1] != 0 || s.attenuation[2] != 0);
  return l;
}

void set_bit(uint8_t& bits, size_t i) { bits = static_cast<uint8_t>(bits | 1u << i); }

// False: vertices get the same coordinates as before, as when a texture takes another's place.
bool derive_texture_coordinates(const State& s, pipeline::VertexState& v) {
  uint8_t units = 0, matrices = 0, reflection = 0, normal = 0;
  bool changed = false;
  for (size_t u = 0; u < kTextureUnits; ++u) {
    const TextureUnitState& unit = s.texture.unit[u];
    const TextureObject* texture = enabled_texture(unit);
    if (!texture || !is_complete(*texture)) continue;
    set_bit(units, u);
    if (unit.gen_str) set_bit(unit.gen_mode == GL_REFLECTION_MAP_OES ? reflection : normal, u);
    const Mat4& matrix = s.transform.texture[u].top();
    if (!is_identity(matrix)) {
      set_bit(matrices, u);
      changed = changed || matrix.m != v.texture_matrices[u].m;
      v.texture_matrices[u] = matrix;
    }
  }
  changed = changed || units != v.texture_units || matrices != v.texture_matrix ||
            reflection != v.reflection_map || normal != v.normal_map;
  v.texture_units = units;
  v.texture_matrix = matrices;
  v.reflection_map = reflection;
  v.normal_map = normal;
  return changed;
}

// The normal matrix is the transpose of the inverse (2.10.3).
void store_normal_matrix(const Mat4& inverse, float* out) {
  for (size_t col = 0; col < 3; ++col) {
    for (size_t row = 0; row < 3; ++row) out[3 * col + row] = inverse.m[4 * row + col];
  }
}

// OES_matrix_palette. Few of the matrices change from draw to draw.
void derive_palette(Context& context, bool normals) {
  pipeline::MatrixPalette& palette = context.palette;
  const bool all_normals = normals && !context.palette_has_normals;
  for (size_t i = 0; i < kPaletteMatrices; ++i) {
    const Mat4& matrix = context.state.transform.palette[i].top();
    float* derived = palette.matrix.data() + 16 * i;
    const bool changed = !std::equal(matrix.m.begin(), matrix.m.end(), derived);
    if (changed) std::copy(matrix.m.begin(), matrix.m.end(), derived);
    if (all_normals || (normals && changed)) {
      store_normal_matrix(invert(matrix), palette.normal_matrix.data() + 9 * i);
    }
  }
  context.palette_has_normals = normals;
}

void derive_matrices(Context& context, bool normals) {
  const State& s = context.state;
  pipeline::VertexState& v = context.vertex_state;
  v.model_view = s.transform.modelview.top();
  v.model_view_projection = multiply(s.transform.projection.top(), v.model_view);
  v.palette = nullptr;
  if (s.transform.matrix_palette) {
    derive_palette(context, normals);
    v.palette = &context.palette;
    v.projection = s.transform.projection.top();
  }
  if (!normals) return;
  // RESCALE_NORMAL uses the inverse's third row (2.10.3).
  const Mat4 inverse = invert(v.model_view);
  store_normal_matrix(inverse, v.normal_matrix.data());
  const float f =
      inverse.m[2] * inverse.m[2] + inverse.m[6] * inverse.m[6] + inverse.m[10] * inverse.m[10];
  v.rescale = f > 1e-12f ? 1.0f / std::sqrt(f) : 1.0f;
  v.rescale_normal = s.transform.rescale_normal;
  v.normalize = s.transform.normalize;
}

void derive_lighting(const State& s, pipeline::VertexState& v) {
  v.lighting = s.lighting.enabled;
  v.two_sided = v.lighting && s.lighting.two_sided;
  if (!v.lighting) return;
  v.colour_material = s.lighting.colour_material;
  v.scene_ambient = s.lighting.model_ambient;
  v.material = {s.lighting.ambient, s.lighting.diffuse, s.lighting.specular, s.lighting.emission,
                s.lighting.shininess};
  for (size_t i = 0; i < v.lights.size(); ++i) v.lights[i] = derive_light(s.lighting.light[i]);
}

void derive_planes_and_points(const State& s, pipeline::VertexState& v) {
  v.clip_planes = 0;
  for (size_t i = 0; i < kClipPlanes; ++i) {
    if (!s.transform.clip_plane_enabled[i]) continue;
    set_bit(v.clip_planes, i);
    v.clip_plane[i] = s.transform.clip_plane[i];
  }
  v.point_size = s.raster.point_size;
  v.point_size_min = s.raster.point_size_min;
  v.point_size_max = std::min(s.raster.point_size_max, kMaxPointSize);
  v.point_fade_threshold = s.raster.point_fade_threshold;
  std::copy_n(s.raster.point_attenuation, 3, v.point_attenuation);
  v.point_attenuated =
      v.point_attenuation[0] != 1 || v.point_attenuation[1] != 0 || v.point_attenuation[2] != 0;
}

bool needs_normals(const pipeline::VertexState& v) {
  return v.lighting || (v.reflection_map | v.normal_map) != 0;
}

}  // namespace

void derive_vertex(Context& context) {
  const State& s = context.state;
  pipeline::VertexState& v = context.vertex_state;
  const uint8_t units = v.texture_units;
  const bool normals = needs_normals(v);
  bool changed = (context.dirty & (kDirtyMatrix | kDirtyVertex)) != 0;
  if (context.dirty & kDirtyTexCoord) changed = derive_texture_coordinates(s, v) || changed;
  if (!changed) return;
  if (context.dirty & kDirtyVertex) {
    derive_lighting(s, v);
    derive_planes_and_points(s, v);
    v.fog = s.fog.enabled;
  }
  const bool all_matrices = (context.dirty & kDirtyVertex) != 0 || needs_normals(v) != normals;
  if (all_matrices || context.dirty & kDirtyMatrix) derive_matrices(context, needs_normals(v));
  // Arrays of coordinates matter while they are sampled with.
  if (v.texture_units != units) context.dirty |= kDirtyArrays;
  context.frame.set_vertex_state(v);
}

}  // namespace clearpipe::api
