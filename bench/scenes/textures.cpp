// SPDX-License-Identifier: MIT
//
// Textures over the whole surface: filters by magnification, minification and at grazing angles,
// and two to four units with their environments.
#include "bench/scene.h"
#include "bench/shapes.h"

#include <GLES/glext.h>

#include <array>
#include <vector>

namespace bench {

namespace {

// Texels for a pixel in each direction, about.
double set_up_scaled(const View& view, float texels, const TextureOptions& options) {
  use_noise_texture(1, options);
  use_corner_coordinates(0, texels * float(view.height) / float(options.size));
  glColor4f(1, 1, 1, 1);
  return view.pixels();
}

void whole(const View&, int) { draw_whole(); }

constexpr TextureOptions kNearest = {.min = GL_NEAREST, .mag = GL_NEAREST};
constexpr TextureOptions kTrilinear = {
    .size = 512, .min = GL_LINEAR_MIPMAP_LINEAR, .mag = GL_LINEAR, .mipmaps = true};

double nearest_magnified(const View& view) { return set_up_scaled(view, 0.2f, kNearest); }
double nearest_minified(const View& view) { return set_up_scaled(view, 2.6f, kNearest); }
double bilinear_magnified(const View& view) { return set_up_scaled(view, 0.2f, {}); }
double bilinear_even(const View& view) { return set_up_scaled(view, 0.9f, {}); }
double bilinear_minified(const View& view) { return set_up_scaled(view, 2.6f, {}); }
double bilinear_clamped(const View& view) {
  return set_up_scaled(view, 0.3f, {.wrap = GL_CLAMP_TO_EDGE});
}
double mipmap_nearest_minified(const View& view) {
  return set_up_scaled(view, 2.6f, {.size = 512, .min = GL_LINEAR_MIPMAP_NEAREST, .mipmaps = true});
}
double trilinear_magnified(const View& view) { return set_up_scaled(view, 0.2f, kTrilinear); }
double trilinear_minified(const View& view) { return set_up_scaled(view, 2.6f, kTrilinear); }

// A floor and a ceiling that run to the horizon.
double set_up_grazing(const View& view, TextureOptions options, float anisotropy) {
  set_perspective(view.width, view.height, 60, 0.5f, 100);
  options.smooth = true;
  use_noise_texture(1, options);
  if (anisotropy > 1) {
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
  }
  glColor4f(1, 1, 1, 1);
  return view.pixels();
}

double bilinear_grazing(const View& view) { return set_up_grazing(view, {}, 1); }
double trilinear_grazing(const View& view) { return set_up_grazing(view, kTrilinear, 1); }
double anisotropic_grazing(const View& view) { return set_up_grazing(view, kTrilinear, 8); }

void grazing(const View&, int) {
  static const GLfloat coordinates[] = {0, 0, 40, 0.5f, -0.5f, 20, 40, 21};
  static const GLfloat corners[2][12] = {
      {-90, -1, 1, 90, -1, 1, -90, -1, -95, 90, -1, -95},
      {-90, 1, -95, 90, 1, -95, -90, 1, 1, 90, 1, 1},
  };
  glClearColor(0.5f, 0.6f, 0.7f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(2, GL_FLOAT, 0, coordinates);
  for (const GLfloat* side : corners) {
    glVertexPointer(3, GL_FLOAT, 0, side);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
}

// Units 0 to units - 1 with bilinear textures of different scales.
void use_units(int units) {
  for (int unit = 0; unit < units; ++unit) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    use_noise_texture(uint32_t(unit + 1), {.smooth = unit % 2 != 0});
    use_corner_coordinates(GLenum(unit), 2.5f + float(unit));
  }
}

double two_units(const View& view) {
  use_corner_colours();
  use_units(2);
  return view.pixels();
}

// An environment of COMBINE: function(texture, previous) by `interpolator` where it takes three.
void combine(GLenum unit, GLint function, GLint scale) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, function);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_PREVIOUS);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, GL_CONSTANT);
  glTexEnvi(GL_TEXTURE_ENV, GL_RGB_SCALE, scale);
  const GLfloat constant[] = {0.4f, 0.5f, 0.6f, 0.5f};
  glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
}

double two_combined(const View& view) {
  two_units(view);
  combine(0, GL_MODULATE, 2);
  combine(1, GL_INTERPOLATE, 1);
  return view.pixels();
}

double three_combined(const View& view) {
  use_corner_colours();
  use_units(3);
  combine(0, GL_MODULATE, 1);
  combine(1, GL_ADD_SIGNED, 1);
  combine(2, GL_DOT3_RGB, 1);
  return view.pixels();
}

double four_units(const View& view) {
  use_corner_colours();
  use_units(4);
  combine(1, GL_ADD, 1);
  combine(3, GL_INTERPOLATE, 1);
  return view.pixels();
}

// A game in two dimensions: a map of tiles, and sprites over it, that move. Rectangles are pairs of
// triangles, with texels as large as pixels.
constexpr int kMapTile = 32, kSprite = 64, kAtlas = 256;
std::vector<GLfloat> corners, places;  // of the map, then of the sprites
GLsizei map_corners;

void add_rectangle(float x, float y, float side, float s, float t) {
  const float end_s = s + side / kAtlas, end_t = t + side / kAtlas;
  corners.insert(corners.end(),
                 {x, y, x + side, y, x, y + side, x, y + side, x + side, y, x + side, y + side});
  places.insert(places.end(), {s, t, end_s, t, s, end_t, s, end_t, end_s, t, end_s, end_t});
}

double set_up_game(const View& view) {
  glMatrixMode(GL_PROJECTION);
  glOrthof(0, GLfloat(view.width), 0, GLfloat(view.height), -1, 1);
  glMatrixMode(GL_MODELVIEW);
  use_noise_texture(3, {.size = kAtlas, .wrap = GL_CLAMP_TO_EDGE, .smooth = true});
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  Noise noise(4);
  for (int y = 0; y < view.height; y += kMapTile) {
    for (int x = 0; x < view.width; x += kMapTile) {
      const uint32_t tile = noise.bits();
      constexpr int kInAtlas = kAtlas / kMapTile;
      add_rectangle(float(x), float(y), kMapTile, float(tile % kInAtlas) / kInAtlas,
                    float(tile / kInAtlas % kInAtlas) / kInAtlas);
    }
  }
  map_corners = GLsizei(corners.size() / 2);
  for (int i = 0; i < view.amount; ++i) {
    add_rectangle(noise.between(-kSprite, float(view.width)),
                  noise.between(-kSprite, float(view.height)), kSprite,
                  0.25f * float(noise.bits() % 4), 0.25f * float(noise.bits() % 4));
  }
  glVertexPointer(2, GL_FLOAT, 0, corners.data());
  glTexCoordPointer(2, GL_FLOAT, 0, places.data());
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  return view.amount;
}

void draw_game(const View&, int number) {
  const auto sprite_corners = GLsizei(corners.size() / 2) - map_corners;
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_BLEND);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glDrawArrays(GL_TRIANGLES, 0, map_corners);
  glEnable(GL_BLEND);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  glColor4f(1, 0.9f, 0.8f, 1);
  glPushMatrix();
  glTranslatef(float(number % 8), float(number % 5), 0);
  glDrawArrays(GL_TRIANGLES, map_corners, sprite_corners);
  glPopMatrix();
}

constexpr Scene scene(const char* name, const char* what, double (*set_up)(const View&),
                      void (*frame)(const View&, int) = whole, double share = 0.999) {
  return {.name = name,
          .what = what,
          .unit = "pixel",
          .amount = 0,
          .set_up = set_up,
          .frame = frame,
          .share = share};
}

// How an anisotropic filter takes its samples is up to the implementation
// (EXT_texture_filter_anisotropic).
constexpr std::array kScenes = {
    scene("texture_nearest_magnified", "nearest texels, 5 pixels each", nearest_magnified, whole,
          0.99),
    scene("texture_nearest_minified", "nearest texels, one of 7", nearest_minified, whole, 0.99),
    scene("texture_bilinear_magnified", "bilinear, 5 pixels a texel", bilinear_magnified),
    scene("texture_bilinear", "bilinear, about a texel a pixel", bilinear_even, whole, 0.99),
    scene("texture_bilinear_clamped", "bilinear, clamped to the edge", bilinear_clamped),
    scene("texture_bilinear_minified", "bilinear, 2.6 texels a pixel", bilinear_minified, whole,
          0.98),
    scene("texture_mipmap_nearest", "bilinear in the nearest mipmap", mipmap_nearest_minified),
    scene("texture_trilinear_magnified", "mipmaps that are not needed", trilinear_magnified),
    scene("texture_trilinear_minified", "bilinear in two mipmaps", trilinear_minified),
    scene("texture_bilinear_grazing", "a floor and a ceiling, bilinear", bilinear_grazing, grazing,
          0.98),
    scene("texture_trilinear_grazing", "a floor and a ceiling, trilinear", trilinear_grazing,
          grazing),
    scene("texture_anisotropic_grazing", "a floor and a ceiling, 8 times anisotropic",
          anisotropic_grazing, grazing, 0.7),
    Scene{.name = "tiles_and_sprites",
          .what = "a map of 32x32 tiles, 300 blended sprites of 64x64",
          .unit = "sprite",
          .amount = 300,
          .set_up = set_up_game,
          .frame = draw_game},
    scene("units_two_modulated", "two bilinear textures, modulated", two_units),
    scene("units_two_combined", "two: modulated and scaled, interpolated", two_combined),
    scene("units_three_combined", "three: modulated, added, and their dot product", three_combined),
    scene("units_four", "four: modulated, added, modulated, interpolated", four_units),
};

}  // namespace

std::span<const Scene> texture_scenes() { return kScenes; }

}  // namespace bench
