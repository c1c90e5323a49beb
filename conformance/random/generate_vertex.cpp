// Transformation and lighting (2.10 to 2.12).
// SPDX-License-Identifier: MIT
#include "conformance/random/generator.h"

namespace clearpipe::conformance::random {

namespace {

void rotate(Generator& g) {
  const float angle = g.uniform(-180, 180), x = g.uniform(-1, 1), y = g.uniform(-1, 1);
  if (g.chance(0.7f)) {
    to::Rotatef{g, angle, x, y, g.uniform(0.2f, 1)};
  } else {
    to::Rotatex{g, fixed(angle), fixed(x), fixed(y), fixed(g.uniform(0.2f, 1))};
  }
}

// Some commands that change a matrix by little, so that things stay in view.
void disturb(Generator& g) {
  const int steps = g.integer(1, 4);
  for (int i = 0; i < steps; ++i) {
    switch (g.integer(0, 5)) {
      case 0:
        to::Translatef{g, g.uniform(-1, 1), g.uniform(-1, 1), g.uniform(-0.5f, 0.1f)};
        break;
      case 1:
        to::Translatex{g, fixed(g.uniform(-1, 1)), fixed(g.uniform(-1, 1)), 0};
        break;
      case 2:
        to::Scalef{g, g.uniform(0.6f, 1.4f), g.uniform(0.6f, 1.4f), g.uniform(0.6f, 1.4f)};
        break;
      case 3:
        to::Scalex{g, fixed(g.uniform(-1.3f, 1.3f)), fixed(g.uniform(0.7f, 1.4f)), fixed(0.9f)};
        break;
      case 4: {
        std::vector<float> matrix = g.several(16, -0.2f, 0.2f);
        for (size_t d = 0; d < 4; ++d) matrix[d * 5] += 1;
        // Affine with lights, see set_positions.
        const bool lit = g.has(Group::lighting) || g.has(Group::two_sided);
        for (size_t w = 3; w < 16; w += 4) matrix[w] = lit ? 0.0f : matrix[w] * 0.1f;
        matrix[15] = 1;
        to::MultMatrixf{g, floats(matrix)};
        break;
      }
      default:
        to::Rotatef{g, g.uniform(-40, 40), g.uniform(-1, 1), g.uniform(-1, 1), g.uniform(0.2f, 1)};
        break;
    }
  }
}

}  // namespace

void set_projection(Generator& g) {
  g.perspective = g.has(Group::matrices) || g.has(Group::clip_planes) || g.has(Group::two_sided) ||
                  g.has(Group::lighting) || g.has(Group::fog) || g.has(Group::mipmaps) ||
                  g.chance(0.3f);
  to::MatrixMode{g, GL_PROJECTION};
  if (g.perspective) {
    const float n = g.uniform(0.5f, 1.2f), half = n * g.uniform(0.5f, 0.8f);
    if (g.chance(0.8f)) {
      to::Frustumf{g, -half, half, -half * g.uniform(0.8f, 1.2f), half, n, g.uniform(9, 30)};
    } else {
      to::Frustumx{g, fixed(-half), fixed(half), fixed(-half), fixed(half), fixed(n), fixed(20)};
    }
  } else {
    const float x = g.uniform(-3, 3), y = g.uniform(-3, 3);
    to::Orthof{g, x, x + 128.31f, y, y + 127.83f, -1, 1};
  }
  to::MatrixMode{g, GL_MODELVIEW};
  if (g.has(Group::matrices) && g.perspective) {
    to::Translatef{g, 0, 0, -3};
    to::PushMatrix{g};
    disturb(g);
    if (g.chance(0.3f)) {
      to::PopMatrix{g};
      rotate(g);
    }
    to::Translatef{g, 0, 0, 3};
  }
  if (g.has(Group::viewport)) {
    to::Viewport{g, g.integer(-40, 40), g.integer(-40, 40), g.integer(50, 180), g.integer(50, 180)};
    const float a = g.uniform(0, 0.4f), b = g.uniform(0.6f, 1);
    if (g.chance(0.7f)) {
      to::DepthRangef{g, a, b};
    } else {
      to::DepthRangex{g, fixed(b), fixed(a)};
    }
  }
}

void set_clip_planes(Generator& g) {
  if (!g.has(Group::clip_planes)) return;
  const int planes = g.integer(1, 3);
  for (int i = 0; i < planes; ++i) {
    const GLenum plane = GL_CLIP_PLANE0 + g.random.below(6);
    const float a = g.uniform(-1, 1), b = g.uniform(-1, 1), c = g.uniform(-0.3f, 0.3f);
    const float d = g.uniform(0, 2) + 3 * c;
    if (g.chance(0.7f)) {
      to::ClipPlanef{g, plane, floats({a, b, c, d})};
    } else {
      to::ClipPlanex{g, plane,
                     data_of(std::vector<GLfixed>{fixed(a), fixed(b), fixed(c), fixed(d)})};
    }
    to::Enable{g, plane};
  }
}

namespace {

// Returns whether distance or direction weakens it.
bool set_light(Generator& g, GLenum light) {
  to::Enable{g, light};
  to::Lightfv{g, light, GL_AMBIENT, floats(g.several(4, -0.05f, 0.3f))};
  to::Lightfv{g, light, GL_DIFFUSE, floats(g.several(4, -0.1f, 1.1f))};
  if (g.chance(0.6f)) to::Lightfv{g, light, GL_SPECULAR, floats(g.several(4, 0, 1))};
  const bool positional = g.chance(0.6f);
  std::vector<float> position = g.several(4, -4, 4);
  // Not another w: Mesa does not divide by it (numerics.md).
  position[3] = positional ? 1.0f : 0.0f;
  to::Lightfv{g, light, GL_POSITION, floats(position)};
  bool attenuated = false;
  if (!positional) return false;
  if (g.chance(0.5f)) {
    attenuated = true;
    to::Lightf{g, light, GL_CONSTANT_ATTENUATION, g.uniform(0.3f, 1)};
    to::Lightf{g, light, GL_LINEAR_ATTENUATION, g.uniform(0, 0.3f)};
    to::Lightx{g, light, GL_QUADRATIC_ATTENUATION, fixed(g.uniform(0, 0.1f))};
  }
  if (g.chance(0.5f)) {
    attenuated = true;
    std::vector<float> direction = g.several(3, -1, 1);
    direction[2] -= 0.5f;
    to::Lightfv{g, light, GL_SPOT_DIRECTION, floats(direction)};
    to::Lightf{g, light, GL_SPOT_CUTOFF, g.uniform(10, 89)};
    to::Lightf{g, light, GL_SPOT_EXPONENT, g.chance(0.3f) ? 0 : g.uniform(0, 40)};
  }
  return attenuated;
}

}  // namespace

void set_lighting(Generator& g) {
  // An operation on bits makes much of a difference of 1/255.
  if (g.has(Group::flat) || g.has(Group::logic_op)) to::ShadeModel{g, GL_FLAT};
  to::Color4f{g, g.uniform(0, 1), g.uniform(0, 1), g.uniform(0, 1), g.uniform(0, 1)};
  if (!g.has(Group::lighting) && !g.has(Group::two_sided)) return;
  to::Enable{g, GL_LIGHTING};
  const int lights = g.integer(1, 3);
  bool attenuated = false;
  for (int i = 0; i < lights; ++i) attenuated |= set_light(g, GL_LIGHT0 + g.random.below(8));
  to::LightModelfv{g, GL_LIGHT_MODEL_AMBIENT, floats(g.several(4, 0, 0.4f))};
  if (g.has(Group::two_sided)) to::LightModelf{g, GL_LIGHT_MODEL_TWO_SIDE, 1};
  if (g.chance(0.4f)) to::Enable{g, GL_COLOR_MATERIAL};
  const GLenum both = GL_FRONT_AND_BACK;
  if (g.chance(0.3f)) {
    to::Materialfv{g, both, GL_AMBIENT_AND_DIFFUSE, floats(g.several(4, 0, 1))};
  } else {
    to::Materialfv{g, both, GL_AMBIENT, floats(g.several(4, 0, 1))};
    to::Materialfv{g, both, GL_DIFFUSE, floats(g.several(4, 0, 1))};
  }
  to::Materialfv{g, both, GL_SPECULAR, floats(g.several(4, 0, 1))};
  to::Materialfv{g, both, GL_EMISSION, floats(g.several(4, 0, 0.2f))};
  // Not 0 with a weakened light: Mesa's power is then of something else (numerics.md).
  to::Materialf{g, both, GL_SHININESS, g.chance(0.2f) && !attenuated ? 0 : g.uniform(0.5f, 128)};
  if (g.chance(0.6f)) to::Enable{g, g.one_of<GLenum>({GL_NORMALIZE, GL_RESCALE_NORMAL})};
  to::Normal3f{g, g.uniform(-1, 1), g.uniform(-1, 1), g.uniform(0.1f, 1)};
}

}  // namespace clearpipe::conformance::random
