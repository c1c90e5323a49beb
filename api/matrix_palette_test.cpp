// OES_matrix_palette, OES_extended_matrix_palette: skinned vertices against the sums of the
// extension in double precision, as they reach the pixels; the matrices and arrays they come from.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

constexpr int kSide = 64;
constexpr int kMatrices = 48, kUnits = 4;

using Matrix = std::array<float, 16>;  // column-major
using Vec = std::array<double, 4>;

constexpr Matrix kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Matrix translation(float x, float y) {
  Matrix m = kIdentity;
  m[12] = x;
  m[13] = y;
  return m;
}

Vec product(const Matrix& m, const Vec& v) {
  Vec out{};
  for (size_t row = 0; row < 4; ++row) {
    for (size_t c = 0; c < 4; ++c) out[row] += double{m[4 * c + row]} * v[c];
  }
  return out;
}

// n * Inv(Mu) by cofactors: element (i, j) of the inverse is that of (j, i) over the determinant.
Vec normal_product(const Matrix& m, const Vec& n, Vec& third_row) {
  const auto at = [&m](size_t row, size_t col) { return double{m[4 * (col % 3) + row % 3]}; };
  const auto cofactor = [&at](size_t row, size_t col) {
    return at(row + 1, col + 1) * at(row + 2, col + 2) -
           at(row + 1, col + 2) * at(row + 2, col + 1);
  };
  const double det =
      at(0, 0) * cofactor(0, 0) + at(0, 1) * cofactor(0, 1) + at(0, 2) * cofactor(0, 2);
  Vec out{};
  for (size_t row = 0; row < 3; ++row) {
    for (size_t k = 0; k < 3; ++k) out[row] += n[k] * cofactor(row, k) / det;
    third_row[row] = cofactor(row, 2) / det;
  }
  return out;
}

struct Vertex {
  float position[4] = {0, 0, 0, 1};
  float normal[3] = {0, 0, 1};
  uint8_t colour[4] = {255, 255, 255, 255};
  float weight[kUnits] = {};
  uint8_t index[kUnits] = {};
};

class MatrixPalette : public CallTest {
 protected:
  void SetUp() override {
    target_ = make_target(kSide, kSide);
    CallTest::SetUp();
    glEnable(GL_MATRIX_PALETTE_OES);
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY,
                               GL_MATRIX_INDEX_ARRAY_OES, GL_WEIGHT_ARRAY_OES}) {
      glEnableClientState(array);
    }
  }

  void set_matrix(size_t i, const Matrix& m) {
    palette_[i] = m;
    glMatrixMode(GL_MATRIX_PALETTE_OES);
    glCurrentPaletteMatrixOES(static_cast<GLuint>(i));
    glLoadMatrixf(m.data());
  }
  void random_palette() {
    for (size_t i = 0; i < kMatrices; ++i) {
      Matrix m;
      for (float& v : m) v = number(-1, 1);
      m[3] = m[7] = m[11] = 0;
      m[15] = 1;
      set_matrix(i, m);
    }
  }
  float number(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }
  // Weights whose sum is 1.
  Vertex random_vertex() {
    Vertex v;
    for (int c = 0; c < 3; ++c) v.position[c] = number(-0.6f, 0.6f);
    for (float& n : v.normal) n = number(-1, 1);
    for (uint8_t& c : v.colour) c = static_cast<uint8_t>(random_());
    float left = 1;
    for (int unit = 0; unit < kUnits; ++unit) {
      v.index[unit] = static_cast<uint8_t>(random_() % kMatrices);
      v.weight[unit] = unit == kUnits - 1 ? left : number(0, left);
      left -= v.weight[unit];
    }
    return v;
  }

  // The arrays in client memory or, with a buffer bound, as offsets into it.
  static void point_at(const Vertex* v, int indices = kUnits, int weights = kUnits) {
    constexpr GLsizei kStride = sizeof(Vertex);
    const auto at = [v](size_t offset) {
      return reinterpret_cast<const void*>(reinterpret_cast<uintptr_t>(v) + offset);
    };
    glVertexPointer(4, GL_FLOAT, kStride, at(offsetof(Vertex, position)));
    glNormalPointer(GL_FLOAT, kStride, at(offsetof(Vertex, normal)));
    glColorPointer(4, GL_UNSIGNED_BYTE, kStride, at(offsetof(Vertex, colour)));
    glMatrixIndexPointerOES(indices, GL_UNSIGNED_BYTE, kStride, at(offsetof(Vertex, index)));
    glWeightPointerOES(weights, GL_FLOAT, kStride, at(offsetof(Vertex, weight)));
  }

  // Eye coordinates by the sum of the extension.
  Vec eye(const Vertex& v, int units) const {
    Vec sum{};
    for (int unit = 0; unit < units; ++unit) {
      const Vec term = product(palette_[v.index[unit]],
                               {v.position[0], v.position[1], v.position[2], v.position[3]});
      for (size_t c = 0; c < 4; ++c) sum[c] += double{v.weight[unit]} * term[c];
    }
    return sum;
  }

  static std::vector<uint32_t> picture() {
    std::vector<uint32_t> pixels(kSide * kSide);
    glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  }
  // Pixels that are not the colour of a cleared surface.
  static int drawn() {
    const auto pixels = picture();
    return static_cast<int>(
        std::count_if(pixels.begin(), pixels.end(), [](uint32_t p) { return p != 0; }));
  }

  std::mt19937 random_{77};
  std::array<Matrix, kMatrices> palette_ = [] {
    std::array<Matrix, kMatrices> initial;
    initial.fill(kIdentity);
    return initial;
  }();
};

TEST_F(MatrixPalette, PointsStandWhereTheSumsSay) {
  const Matrix projection = {1, 0.1f, 0, 0.2f, -0.1f, 0.9f, 0, 0.1f, 0, 0.1f, 0.1f, 0, 0, 0, 0, 1};
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(projection.data());
  glMatrixMode(GL_MODELVIEW);
  glTranslatef(5, 5, 5);  // not in use
  glEnable(GL_BLEND);     // the colours of points that meet are added
  glBlendFunc(GL_ONE, GL_ONE);
  int seen = 0;
  for (int indices = 1; indices <= kUnits; ++indices) {
    for (int weights = 1; weights <= kUnits; ++weights) {
      random_palette();
      std::vector<Vertex> vertices;
      std::vector<Vec> expected(kSide * kSide);
      const int units = std::min(indices, weights);
      while (vertices.size() < 60) {
        const Vertex v = random_vertex();
        const Vec clip = product(projection, eye(v, units));
        const double x = (clip[0] / clip[3] + 1) / 2 * kSide,
                     y = (clip[1] / clip[3] + 1) / 2 * kSide;
        const double near =
            std::min({x - std::floor(x), std::ceil(x) - x, y - std::floor(y), std::ceil(y) - y});
        if (clip[3] < 0.1 || near < 0.01) continue;  // not too close to the border of a pixel
        vertices.push_back(v);
        if (std::fabs(clip[2]) > clip[3] || x < 0 || x >= kSide || y < 0 || y >= kSide) continue;
        ++seen;
        Vec& pixel = expected[static_cast<size_t>(y) * kSide + static_cast<size_t>(x)];
        for (size_t c = 0; c < 4; ++c) pixel[c] = std::min(pixel[c] + v.colour[c], 255.0);
      }
      glClear(GL_COLOR_BUFFER_BIT);
      point_at(vertices.data(), indices, weights);
      glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(vertices.size()));
      const auto found = picture();
      for (size_t i = 0; i < found.size(); ++i) {
        for (unsigned c = 0; c < 4; ++c) {
          ASSERT_EQ(found[i] >> (8 * c) & 255, expected[i][c])
              << indices << " indices, " << weights << " weights, pixel " << i;
        }
      }
    }
  }
  EXPECT_GT(seen, 400);
}

// A light at infinity on the z axis shows the z of the normal in eye coordinates.
TEST_F(MatrixPalette, NormalsFollowTheSumOfInverses) {
  const GLfloat white[] = {1, 1, 1, 1}, black[] = {0, 0, 0, 1}, direction[] = {0, 0, 1, 0};
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, black);
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, white);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
  glLightfv(GL_LIGHT0, GL_POSITION, direction);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  // The projection brings every point to the middle of the surface.
  glMatrixMode(GL_PROJECTION);
  const Matrix flat = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  glLoadMatrixf(flat.data());
  glPointSize(9);
  int between = 0;
  for (int round = 0; round < 200; ++round) {
    if (round % 20 == 0) random_palette();
    const bool normalize = round % 3 == 1, rescale = round % 3 == 2;
    normalize ? glEnable(GL_NORMALIZE) : glDisable(GL_NORMALIZE);
    rescale ? glEnable(GL_RESCALE_NORMAL) : glDisable(GL_RESCALE_NORMAL);
    const int units = 1 + round % kUnits;
    const Vertex v = random_vertex();
    Vec n{}, third{};
    for (int unit = 0; unit < units; ++unit) {
      Vec row{};
      const Vec term =
          normal_product(palette_[v.index[unit]], {v.normal[0], v.normal[1], v.normal[2], 0}, row);
      for (size_t c = 0; c < 3; ++c) {
        n[c] += double{v.weight[unit]} * term[c];
        third[c] += double{v.weight[unit]} * row[c];
      }
    }
    double scale = 1;
    if (normalize) scale = 1 / std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (rescale) {
      scale = 1 / std::sqrt(third[0] * third[0] + third[1] * third[1] + third[2] * third[2]);
    }
    const double expected = std::clamp(n[2] * scale, 0.0, 1.0) * 255;
    if (expected > 0 && expected < 255) ++between;
    glClear(GL_COLOR_BUFFER_BIT);
    point_at(&v, units);
    glDrawArrays(GL_POINTS, 0, 1);
    ASSERT_NEAR(pixel(kSide / 2, kSide / 2) & 255, expected, 0.6) << round;
  }
  EXPECT_GT(between, 50);
}

// OES_texture_cube_map: the coordinates of NORMAL_MAP are the skinned normal, with no light.
TEST_F(MatrixPalette, NormalMapsAreSkinned) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_CUBE_MAP_OES, name);
  glTexParameteri(GL_TEXTURE_CUBE_MAP_OES, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  for (GLenum face = 0; face < 6; ++face) {
    const uint32_t colour = 0xff000000u | face;
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face, 0, GL_RGBA, 1, 1, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, &colour);
  }
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glEnable(GL_TEXTURE_CUBE_MAP_OES);
  glEnable(GL_TEXTURE_GEN_STR_OES);
  glTexGeniOES(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, GL_NORMAL_MAP_OES);
  // Cyclic exchanges of the axes: the normal (0, 0, 1) becomes x, y and z.
  const Matrix cycles[3] = {{0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1},
                            {0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1},
                            kIdentity};
  Vertex v;
  v.weight[0] = 1;
  point_at(&v, 1, 1);
  for (uint32_t axis = 0; axis < 3; ++axis) {
    for (const float sign : {1.0f, -1.0f}) {
      set_matrix(0, cycles[axis]);
      v.normal[2] = sign;
      glDrawArrays(GL_POINTS, 0, 1);
      EXPECT_EQ(pixel(kSide / 2, kSide / 2), 0xff000000u | (2 * axis + (sign < 0 ? 1 : 0)));
    }
  }
}

// The current matrix of MATRIX_PALETTE_OES is the palette's.
TEST_F(MatrixPalette, MatrixOperationsGoToThePalette) {
  const auto current = [] {
    GLfixed mantissa[16];
    GLint exponent[16];
    EXPECT_EQ(glQueryMatrixxOES(mantissa, exponent), 0u);
    Matrix m;
    for (size_t i = 0; i < 16; ++i) m[i] = std::ldexp(mantissa[i] / 65536.0f, exponent[i]);
    return m;
  };
  glMatrixMode(GL_MATRIX_PALETTE_OES);
  for (GLuint i = 0; i < kMatrices; ++i) {
    glCurrentPaletteMatrixOES(i);
    EXPECT_EQ(current(), kIdentity) << i;
  }
  glCurrentPaletteMatrixOES(3);
  glTranslatef(2, 4, 0);
  glCurrentPaletteMatrixOES(4);
  glLoadIdentity();
  EXPECT_EQ(current(), kIdentity);
  glScalef(0.5f, 0.5f, 1);
  glTranslatef(2, 4, 0);
  EXPECT_EQ(current()[12], 1.0f);
  glCurrentPaletteMatrixOES(3);
  EXPECT_EQ(current(), translation(2, 4));

  glMatrixMode(GL_MODELVIEW);
  EXPECT_EQ(current(), kIdentity);
  glTranslatef(-1, 0.5f, 0);
  glLoadPaletteFromModelViewMatrixOES();
  glTranslatef(1, 1, 1);
  glMatrixMode(GL_MATRIX_PALETTE_OES);
  EXPECT_EQ(current(), translation(-1, 0.5f));
  // There is no stack.
  glPushMatrix();
  EXPECT_ERROR(GL_STACK_OVERFLOW);
  glPopMatrix();
  EXPECT_ERROR(GL_STACK_UNDERFLOW);
}

// The initial sizes, 0, are none that a call could set (state_table.def has all other state).
TEST_F(MatrixPalette, SizesOfTheArrays) {
  const auto sizes = [] {
    std::array<GLint, 2> found{-1, -1};
    glGetIntegerv(GL_MATRIX_INDEX_ARRAY_SIZE_OES, &found[0]);
    glGetIntegerv(GL_WEIGHT_ARRAY_SIZE_OES, &found[1]);
    return found;
  };
  EXPECT_EQ(sizes(), (std::array<GLint, 2>{0, 0}));
  for (GLint size = 1; size <= kUnits; ++size) {
    glMatrixIndexPointerOES(size, GL_UNSIGNED_BYTE, 0, nullptr);
    glWeightPointerOES(kUnits + 1 - size, GL_FLOAT, 0, nullptr);
    EXPECT_EQ(sizes(), (std::array<GLint, 2>{size, kUnits + 1 - size}));
  }
}

TEST_F(MatrixPalette, NothingIsDrawnWithoutBothArrays) {
  Vertex v;
  v.weight[0] = 1;
  glPointSize(5);
  const auto draws = [] {
    glClear(GL_COLOR_BUFFER_BIT);
    glDrawArrays(GL_POINTS, 0, 1);
    const uint8_t element = 0;
    glDrawElements(GL_POINTS, 1, GL_UNSIGNED_BYTE, &element);
    EXPECT_ERROR(GL_NO_ERROR);
    return drawn() != 0;
  };
  // Enabled, but no pointer was ever given.
  glVertexPointer(4, GL_FLOAT, 0, v.position);
  glDisableClientState(GL_NORMAL_ARRAY);
  glDisableClientState(GL_COLOR_ARRAY);
  EXPECT_FALSE(draws());
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  point_at(&v);
  EXPECT_TRUE(draws());
  for (const GLenum array : {GL_MATRIX_INDEX_ARRAY_OES, GL_WEIGHT_ARRAY_OES}) {
    glDisableClientState(array);
    EXPECT_FALSE(draws());
    glDisable(GL_MATRIX_PALETTE_OES);
    EXPECT_TRUE(draws());
    glEnable(GL_MATRIX_PALETTE_OES);
    glEnableClientState(array);
    EXPECT_TRUE(draws());
  }
  glWeightPointerOES(4, GL_FLOAT, 0, nullptr);
  EXPECT_FALSE(draws());
  point_at(&v);
  // In a buffer that is too small.
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, 2, nullptr, GL_STATIC_DRAW);
  glMatrixIndexPointerOES(4, GL_UNSIGNED_BYTE, 0, nullptr);
  EXPECT_FALSE(draws());
}

// Where the arrays lie and how they are typed makes no difference.
TEST_F(MatrixPalette, ArraysOfAllKinds) {
  random_palette();
  std::vector<Vertex> vertices(90);
  std::generate(vertices.begin(), vertices.end(), [this] { return random_vertex(); });
  // Weights that fixed-point numbers hold exactly.
  for (Vertex& v : vertices) {
    for (float& w : v.weight) w = std::round(w * 65536) / 65536;
  }
  const auto draw = [&vertices] {
    glClear(GL_COLOR_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
    return picture();
  };
  point_at(vertices.data());
  const auto expected = draw();
  EXPECT_GT(drawn(), 100);

  std::vector<GLfixed> fixed;
  std::vector<uint8_t> indices;
  for (const Vertex& v : vertices) {
    for (const float w : v.weight) fixed.push_back(static_cast<GLfixed>(w * 65536));
    indices.insert(indices.end(), v.index, v.index + kUnits);
  }
  glWeightPointerOES(kUnits, GL_FIXED, 0, fixed.data());
  glMatrixIndexPointerOES(kUnits, GL_UNSIGNED_BYTE, 0, indices.data());
  EXPECT_EQ(draw(), expected);

  GLuint buffers[2] = {}, array = 0;
  glGenBuffers(2, buffers);
  glGenVertexArraysOES(1, &array);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
               vertices.data(), GL_STATIC_DRAW);
  point_at(nullptr);
  EXPECT_EQ(draw(), expected);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(4 * fixed.size()), fixed.data(),
               GL_STATIC_DRAW);
  glWeightPointerOES(kUnits, GL_FIXED, 0, nullptr);
  EXPECT_EQ(draw(), expected);

  // A vertex array object has arrays of its own.
  glBindVertexArrayOES(array);
  EXPECT_FALSE(glIsEnabled(GL_WEIGHT_ARRAY_OES));
  EXPECT_NE(draw(), expected);
  glBindVertexArrayOES(0);
  EXPECT_EQ(draw(), expected);

  // Deleted buffers leave nothing to draw from.
  glDeleteBuffers(1, &buffers[1]);
  GLint binding = -1;
  glGetIntegerv(GL_WEIGHT_ARRAY_BUFFER_BINDING_OES, &binding);
  EXPECT_EQ(binding, 0);
  draw();
  EXPECT_EQ(drawn(), 0);
}

// Draws are executed later: each with the palette that it was called with.
TEST_F(MatrixPalette, EachDrawHasItsPalette) {
  Vertex v;
  v.weight[0] = 1;
  point_at(&v, 1, 1);
  for (int i = 0; i < 8; ++i) {
    set_matrix(0, translation(-0.9f + 0.25f * static_cast<float>(i), 0));
    glDrawArrays(GL_POINTS, 0, 1);
    if (i == 3) glFinish();
  }
  EXPECT_EQ(drawn(), 8);
}

TEST_F(MatrixPalette, AnyIndexIsSafe) {
  set_matrix(kMatrices - 1, translation(0.5f, 0.5f));
  Vertex v;
  v.weight[0] = 1;
  v.index[0] = 255;
  point_at(&v);
  glDrawArrays(GL_POINTS, 0, 1);
  EXPECT_EQ(drawn(), 1);
}

// 2.11, 3.3, 3.8: what is found in eye coordinates is found from the skinned ones.
TEST_F(MatrixPalette, EyeCoordinatesOfOtherStages) {
  Vertex v[2];
  v[0].weight[0] = v[1].weight[0] = 1;
  v[1].index[0] = 1;
  set_matrix(0, translation(-0.5f, 0));
  Matrix far = translation(0.5f, 0);
  far[14] = -0.5f;
  set_matrix(1, far);
  point_at(v);
  glPointSize(8);

  const GLfloat left[] = {-1, 0, 0, 0};
  glClipPlanef(GL_CLIP_PLANE0, left);
  glEnable(GL_CLIP_PLANE0);
  glDrawArrays(GL_POINTS, 0, 2);
  EXPECT_EQ(drawn(), 64);
  EXPECT_NE(pixel(kSide / 4, kSide / 2), 0u);
  glDisable(GL_CLIP_PLANE0);

  const GLfloat blue[] = {0, 0, 1, 1};
  glFogf(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 1);
  glFogfv(GL_FOG_COLOR, blue);
  glEnable(GL_FOG);
  glClear(GL_COLOR_BUFFER_BIT);
  glDrawArrays(GL_POINTS, 0, 2);
  EXPECT_EQ(pixel(kSide / 4, kSide / 2), kWhite);
  EXPECT_EQ(pixel(3 * kSide / 4, kSide / 2), 0xffff8080u);
  glDisable(GL_FOG);

  const GLfloat attenuation[] = {0, 0, 16};  // by the distances 1/2 and 1/sqrt 2
  glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
  glClear(GL_COLOR_BUFFER_BIT);
  glPointSize(12);
  glDrawArrays(GL_POINTS, 0, 2);
  EXPECT_EQ(drawn(), 6 * 6 + 4 * 4);
}

}  // namespace
}  // namespace clearpipe::api
