// Lights and materials: what is set is what is asked for, and the lighting equation (2.12.1) in
// double precision is what is drawn.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

using Vec = std::array<double, 4>;

double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec unit(const Vec& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length, 0};
}

// Table 2.8, with its initial values for lights other than light 0.
struct Light {
  Vec ambient{0, 0, 0, 1}, diffuse{0, 0, 0, 1}, specular{0, 0, 0, 1}, position{0, 0, 1, 0};
  Vec spot_direction{0, 0, -1, 0};
  double spot_exponent = 0, spot_cutoff = 180, attenuation[3] = {1, 0, 0};
};
struct Material {
  Vec ambient{0.2, 0.2, 0.2, 1}, diffuse{0.8, 0.8, 0.8, 1}, specular{0, 0, 0, 1},
      emission{0, 0, 0, 1};
  double shininess = 0;
};
struct Scene {
  const char* name;
  Light light[2];
  Material material;
  Vec normal{0, 0, 1, 0};
  Vec model_ambient{0.2, 0.2, 0.2, 1};
  bool lights[2] = {true, false};
};

class Lighting : public CallTest {
 protected:
  static std::array<GLfloat, 4> floats(const Vec& v) {
    return {static_cast<GLfloat>(v[0]), static_cast<GLfloat>(v[1]), static_cast<GLfloat>(v[2]),
            static_cast<GLfloat>(v[3])};
  }
  static void set(const Scene& s) {
    glEnable(GL_LIGHTING);
    for (GLenum i = 0; i < 2; ++i) {
      const Light& l = s.light[i];
      const GLenum name = GL_LIGHT0 + i;
      s.lights[i] ? glEnable(name) : glDisable(name);
      glLightfv(name, GL_AMBIENT, floats(l.ambient).data());
      glLightfv(name, GL_DIFFUSE, floats(l.diffuse).data());
      glLightfv(name, GL_SPECULAR, floats(l.specular).data());
      glLightfv(name, GL_POSITION, floats(l.position).data());
      glLightfv(name, GL_SPOT_DIRECTION, floats(l.spot_direction).data());
      glLightf(name, GL_SPOT_EXPONENT, static_cast<GLfloat>(l.spot_exponent));
      glLightf(name, GL_SPOT_CUTOFF, static_cast<GLfloat>(l.spot_cutoff));
      for (GLenum k = 0; k < 3; ++k) {
        glLightf(name, GL_CONSTANT_ATTENUATION + k, static_cast<GLfloat>(l.attenuation[k]));
      }
    }
    const Material& m = s.material;
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, floats(m.ambient).data());
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, floats(m.diffuse).data());
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, floats(m.specular).data());
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, floats(m.emission).data());
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, static_cast<GLfloat>(m.shininess));
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, floats(s.model_ambient).data());
    glNormal3f(static_cast<GLfloat>(s.normal[0]), static_cast<GLfloat>(s.normal[1]),
               static_cast<GLfloat>(s.normal[2]));
  }

  // The colour of a vertex at `at`, in eye coordinates.
  static Vec lit(const Scene& s, const Vec& at) {
    const Material& m = s.material;
    Vec c;
    for (size_t k = 0; k < 3; ++k) c[k] = m.emission[k] + m.ambient[k] * s.model_ambient[k];
    for (size_t i = 0; i < 2; ++i) {
      if (!s.lights[i]) continue;
      const Light& l = s.light[i];
      Vec to = l.position;
      double attenuation = 1;
      if (l.position[3] != 0) {
        for (size_t k = 0; k < 3; ++k) to[k] = l.position[k] / l.position[3] - at[k];
        const double d = std::sqrt(dot(to, to));
        attenuation = 1 / (l.attenuation[0] + l.attenuation[1] * d + l.attenuation[2] * d * d);
      }
      to = unit(to);
      double spot = 1;
      if (l.spot_cutoff != 180) {
        const Vec direction = unit(l.spot_direction);
        const double cosine = -dot(to, direction);
        spot = cosine >= std::cos(l.spot_cutoff * 3.14159265358979323846 / 180)
                   ? std::pow(std::max(cosine, 0.0), l.spot_exponent)
                   : 0;
      }
      const double facing = std::max(dot(s.normal, to), 0.0);
      const Vec half = unit({to[0], to[1], to[2] + 1, 0});
      const double shine =
          facing > 0 ? std::pow(std::max(dot(s.normal, half), 0.0), m.shininess) : 0;
      for (size_t k = 0; k < 3; ++k) {
        c[k] += attenuation * spot *
                (m.ambient[k] * l.ambient[k] + facing * m.diffuse[k] * l.diffuse[k] +
                 shine * m.specular[k] * l.specular[k]);
      }
    }
    c[3] = m.diffuse[3];
    return c;
  }

  // A point as large as the surface has the colour of its one vertex.
  static void expect_lit(const Scene& s) {
    static const GLfloat kAt[3] = {0.25f, -0.5f, 0.5f};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, kAt);
    glPointSize(kSize);
    glDrawArrays(GL_POINTS, 0, 1);
    const uint32_t seen = pixel(9, 5);
    const Vec expected = lit(s, {kAt[0], kAt[1], kAt[2], 1});
    for (size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(seen >> 8 * k & 255, std::clamp(expected[k], 0.0, 1.0) * 255, 1)
          << s.name << ", component " << k;
    }
  }
};

Scene scene(const char* name, const std::function<void(Scene&)>& change) {
  Scene s;
  s.name = name;
  s.light[0].diffuse = s.light[0].specular = {1, 1, 1, 1};
  change(s);
  return s;
}

std::vector<Scene> scenes() {
  return {
      scene("initial", [](Scene&) {}),
      scene("ambient",
            [](Scene& s) {
              s.light[0].ambient = {0.5, 0.25, 0.75, 1};
            }),
      scene("model ambient",
            [](Scene& s) {
              s.model_ambient = {0.9, 0.1, 0.5, 0.3};
            }),
      scene("material",
            [](Scene& s) {
              s.material.ambient = {0.3, 0.6, 0.9, 0.5};
              s.material.diffuse = {0.1, 0.5, 0.3, 0.4};
              s.material.emission = {0.05, 0.1, 0.2, 0.7};
            }),
      scene("direction",
            [](Scene& s) {
              s.light[0].position = {1, -2, 3, 0};
            }),
      scene("from behind",
            [](Scene& s) {
              s.light[0].position = {0, 0, -1, 0};
            }),
      scene("specular",
            [](Scene& s) {
              s.light[0].position = {0.3, 0.2, 1, 0};
              s.material.specular = {0.6, 0.3, 0.1, 1};
              s.material.shininess = 12.5;
              s.material.diffuse = {0.2, 0.2, 0.2, 1};
            }),
      scene("position",
            [](Scene& s) {
              s.light[0].position = {1, 1, 2, 1};
            }),
      scene("position with w",
            [](Scene& s) {
              s.light[0].position = {1, 1, 2, 0.5};
            }),
      scene("attenuation",
            [](Scene& s) {
              s.light[0].position = {1, 1, 2, 1};
              s.light[0].attenuation[0] = 0.5;
              s.light[0].attenuation[1] = 0.25;
              s.light[0].attenuation[2] = 0.125;
            }),
      scene("spot",
            [](Scene& s) {
              s.light[0].position = {0.25, 0, 2, 1};
              s.light[0].spot_cutoff = 45;
              s.light[0].spot_exponent = 3;
              s.light[0].spot_direction = {0.1, 0, -2, 0};
            }),
      scene("beside the spot",
            [](Scene& s) {
              s.light[0].position = {0.25, 0, 2, 1};
              s.light[0].spot_cutoff = 5;
            }),
      scene("normal",
            [](Scene& s) {
              s.normal = unit({1, 2, 2, 0});
            }),
      scene("two lights",
            [](Scene& s) {
              s.lights[1] = true;
              s.light[0].diffuse = {0.5, 0, 0, 1};
              s.light[1].diffuse = {0, 0.25, 0.5, 1};
              s.light[1].ambient = {0.1, 0.1, 0, 1};
              s.light[1].position = {-1, 0, 1, 0};
            }),
      scene("clamped",
            [](Scene& s) {
              s.light[0].diffuse = {3, -2, 1, 1};
              s.material.emission = {0.5, 0.25, 0, 1};
            }),
  };
}

// One after another in one context: what each leaves behind must be derived again.
TEST_F(Lighting, IsTheEquationsColour) {
  for (const Scene& s : scenes()) {
    set(s);
    expect_lit(s);
  }
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(Lighting, InitialValues) {
  const Light others;
  Light first;
  first.diffuse = first.specular = {1, 1, 1, 1};
  for (GLenum i = 0; i < 8; ++i) {
    const Light& l = i == 0 ? first : others;
    const std::pair<GLenum, Vec> kVectors[] = {{GL_AMBIENT, l.ambient},
                                               {GL_DIFFUSE, l.diffuse},
                                               {GL_SPECULAR, l.specular},
                                               {GL_POSITION, l.position}};
    for (const auto& [name, value] : kVectors) {
      std::array<GLfloat, 4> seen{};
      glGetLightfv(GL_LIGHT0 + i, name, seen.data());
      EXPECT_EQ(seen, floats(value)) << i << " " << name;
    }
    GLfloat seen[4] = {0, 0, 0, 7};
    glGetLightfv(GL_LIGHT0 + i, GL_SPOT_DIRECTION, seen);
    EXPECT_EQ(seen[2], -1);
    EXPECT_EQ(seen[3], 7);
    const std::pair<GLenum, GLfloat> kScalars[] = {{GL_SPOT_EXPONENT, 0.0f},
                                                   {GL_SPOT_CUTOFF, 180.0f},
                                                   {GL_CONSTANT_ATTENUATION, 1.0f},
                                                   {GL_LINEAR_ATTENUATION, 0.0f},
                                                   {GL_QUADRATIC_ATTENUATION, 0.0f}};
    for (const auto& [name, value] : kScalars) {
      glGetLightfv(GL_LIGHT0 + i, name, seen);
      EXPECT_EQ(seen[0], value) << i << " " << name;
    }
  }
}

// Positions and directions come back in eye coordinates, by the modelview matrix of then (2.12.2).
TEST_F(Lighting, PositionsAreTransformedWhenTheyAreSet) {
  glTranslatef(1, 2, 3);
  glScalef(2, 2, 2);
  const GLfloat position[4] = {1, 1, 1, 1}, direction[3] = {0, 1, 0};
  glLightfv(GL_LIGHT3, GL_POSITION, position);
  glLightfv(GL_LIGHT3, GL_SPOT_DIRECTION, direction);
  glLoadIdentity();
  GLfloat seen[4] = {};
  GLfixed fixed[4] = {};
  glGetLightfv(GL_LIGHT3, GL_POSITION, seen);
  EXPECT_EQ(seen[0], 3);
  EXPECT_EQ(seen[1], 4);
  EXPECT_EQ(seen[2], 5);
  EXPECT_EQ(seen[3], 1);
  glGetLightxv(GL_LIGHT3, GL_SPOT_DIRECTION, fixed);
  EXPECT_EQ(fixed[1], 2 << 16);
}

TEST_F(Lighting, MaterialsComeBackForBothFaces) {
  const GLenum kNames[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION};
  GLfixed base = 0x1000;
  for (const GLenum name : kNames) {
    const GLfixed value[4] = {base, base + 1, -base, base * 64};
    glMaterialxv(GL_FRONT_AND_BACK, name, value);
    base += 0x111;
  }
  glMaterialx(GL_FRONT_AND_BACK, GL_SHININESS, 0x208000);
  base = 0x1000;
  for (const GLenum name : kNames) {
    for (const GLenum face : {GL_FRONT, GL_BACK}) {
      GLfixed seen[4] = {};
      glGetMaterialxv(face, name, seen);
      EXPECT_EQ(seen[0], base);
      EXPECT_EQ(seen[1], base + 1);
      EXPECT_EQ(seen[2], -base);
      EXPECT_EQ(seen[3], base * 64);
    }
    base += 0x111;
  }
  GLfloat shininess = 0;
  glGetMaterialfv(GL_BACK, GL_SHININESS, &shininess);
  EXPECT_EQ(shininess, 32.5f);
}

// 2.12.3: the colour is written to the material, refuses other values, and stays afterwards.
TEST_F(Lighting, ColourTracking) {
  const auto diffuse = [] {
    std::array<GLfloat, 4> seen{};
    glGetMaterialfv(GL_FRONT, GL_DIFFUSE, seen.data());
    return seen;
  };
  const std::array<GLfloat, 4> first = {0.25f, 0.5f, 0, 1}, second = {0, 0.5f, 0.75f, 0.5f},
                               third = {0.1f, 0.2f, 0.3f, 0.4f};
  Scene s = scene("tracked", [](Scene&) {});
  set(s);
  glColor4f(first[0], first[1], first[2], first[3]);
  glEnable(GL_COLOR_MATERIAL);
  EXPECT_EQ(diffuse(), first);
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, third.data());
  EXPECT_EQ(diffuse(), first);
  s.material.ambient = s.material.diffuse = {0.25, 0.5, 0, 1};
  expect_lit(s);
  glColor4f(second[0], second[1], second[2], second[3]);
  s.material.ambient = s.material.diffuse = {0, 0.5, 0.75, 0.5};
  expect_lit(s);
  glDisable(GL_COLOR_MATERIAL);
  glColor4f(1, 1, 1, 1);
  EXPECT_EQ(diffuse(), second);
  expect_lit(s);
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, third.data());
  EXPECT_EQ(diffuse(), third);
}

// With LIGHT_MODEL_TWO_SIDE a back face is lit with its normal turned round.
TEST_F(Lighting, TwoSides) {
  Scene s = scene("two sides", [](Scene& x) { x.light[0].position = {0, 0, -1, 0}; });
  set(s);
  glFrontFace(GL_CW);  // draw_quad is counterclockwise: a back face
  draw_quad();
  const uint32_t unlit = pixel(8, 8);
  EXPECT_EQ(unlit & 255, std::lround(0.04 * 255));
  glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 1);
  draw_quad();
  EXPECT_EQ(pixel(8, 8) & 255, std::lround(0.84 * 255));
  glFrontFace(GL_CCW);
  draw_quad();
  EXPECT_EQ(pixel(8, 8), unlit);
}

}  // namespace
}  // namespace clearpipe::api
