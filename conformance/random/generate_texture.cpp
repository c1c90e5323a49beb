// Textures and their environments (3.7).
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "conformance/random/generator.h"

namespace clearpipe::conformance::random {

namespace {

struct Format {
  GLenum format, type;
  size_t bytes;
};

constexpr Format kFormats[] = {{GL_RGBA, GL_UNSIGNED_BYTE, 4},
                               {GL_RGB, GL_UNSIGNED_BYTE, 3},
                               {GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 2},
                               {GL_LUMINANCE, GL_UNSIGNED_BYTE, 1},
                               {GL_ALPHA, GL_UNSIGNED_BYTE, 1},
                               {GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 2},
                               {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 2},
                               {GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 2}};

bool uses_textures(const Generator& g) {
  // Operations on bits make much of a difference of 1/255.
  if (g.has(Group::logic_op)) return false;
  for (const Group group :
       {Group::texture, Group::mipmaps, Group::texture_matrix, Group::environment, Group::combine,
        Group::multitexture, Group::sub_images, Group::copies, Group::sprites}) {
    if (g.has(group)) return true;
  }
  return false;
}

Data texels(Generator& g, const Format& format, int width, int height) {
  Data data{std::vector<uint8_t>(static_cast<size_t>(width) * height * format.bytes)};
  for (uint8_t& byte : data.bytes) byte = g.random.byte();
  return data;
}

void set_parameters(Generator& g, bool mipmaps) {
  const GLenum target = GL_TEXTURE_2D;
  const GLint min = mipmaps ? g.integer(GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR)
                            : g.integer(GL_NEAREST, GL_LINEAR);
  // With these, magnification begins at a lod of 0.5, in Mesa at 0 (numerics.md).
  const bool late = min == GL_NEAREST_MIPMAP_NEAREST || min == GL_NEAREST_MIPMAP_LINEAR;
  to::TexParameteri{g, target, GL_TEXTURE_MIN_FILTER, min};
  to::TexParameterx{g, target, GL_TEXTURE_MAG_FILTER,
                    late ? GL_NEAREST : g.integer(GL_NEAREST, GL_LINEAR)};
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    to::TexParameterf{g, target, wrap,
                      g.one_of<GLenum>({GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT_OES})};
  }
}

void set_image(Generator& g) {
  const Format format = kFormats[g.random.below(8)];
  const bool mipmaps = g.has(Group::mipmaps);
  int width = 1 << g.integer(mipmaps ? 3 : 0, 6), height = 1 << g.integer(mipmaps ? 3 : 0, 6);
  to::BindTexture{g, GL_TEXTURE_2D, g.textures++};
  set_parameters(g, mipmaps);
  to::PixelStorei{g, GL_UNPACK_ALIGNMENT, 1};
  // Mesa rounds generated levels to the bits of a packed format (numerics.md).
  const bool generated = mipmaps && format.type == GL_UNSIGNED_BYTE && g.chance(0.3f);
  if (generated) to::TexParameteri{g, GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1};
  const bool incomplete = mipmaps && g.chance(0.05f);  // 3.7.10: as if it were disabled
  for (int level = 0;; ++level) {
    to::TexImage2D{g,           GL_TEXTURE_2D,
                   level,       format.format,
                   width,       height,
                   0,           format.format,
                   format.type, texels(g, format, width, height)};
    if (!mipmaps || generated || incomplete || (width == 1 && height == 1)) break;
    width = std::max(width / 2, 1);
    height = std::max(height / 2, 1);
  }
  if (!g.has(Group::sub_images)) return;
  const int w = g.integer(1, width), h = g.integer(1, height);
  to::TexSubImage2D{
      g, GL_TEXTURE_2D, 0,           g.integer(0, width - w), g.integer(0, height - h), w,
      h, format.format, format.type, texels(g, format, w, h)};
}

void set_combiner(Generator& g) {
  const GLenum env = GL_TEXTURE_ENV;
  to::TexEnvi{g, env, GL_TEXTURE_ENV_MODE, GL_COMBINE};
  to::TexEnvi{g, env, GL_COMBINE_RGB,
              g.one_of<GLenum>({GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE,
                                GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA})};
  to::TexEnvi{g, env, GL_COMBINE_ALPHA,
              g.one_of<GLenum>(
                  {GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT})};
  for (GLenum i = 0; i < 3; ++i) {
    const auto source = [&] {
      const GLenum unit = GL_TEXTURE0 + g.random.below(static_cast<uint32_t>(g.units));
      return g.one_of<GLenum>({GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS, unit});
    };
    to::TexEnvi{g, env, GL_SRC0_RGB + i, source()};
    to::TexEnvi{g, env, GL_SRC0_ALPHA + i, source()};
    to::TexEnvi{g, env, GL_OPERAND0_RGB + i, g.integer(GL_SRC_COLOR, GL_ONE_MINUS_SRC_ALPHA)};
    to::TexEnvi{g, env, GL_OPERAND0_ALPHA + i, g.integer(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)};
  }
  to::TexEnvf{g, env, GL_RGB_SCALE, g.one_of<int>({1, 1, 2, 4})};
  to::TexEnvf{g, env, GL_ALPHA_SCALE, g.one_of<int>({1, 1, 2, 4})};
}

void set_environment(Generator& g) {
  to::TexEnvfv{g, GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, floats(g.several(4, 0, 1))};
  if (g.has(Group::combine)) {
    set_combiner(g);
  } else if (g.has(Group::environment) || g.has(Group::multitexture)) {
    to::TexEnvi{g, GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
                g.one_of<GLenum>({GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD})};
  }
}

void set_texture_matrix(Generator& g) {
  to::MatrixMode{g, GL_TEXTURE};
  to::Translatef{g, g.uniform(-1, 1), g.uniform(-1, 1), 0};
  to::Rotatef{g, g.uniform(-180, 180), 0.1f, 0.2f, 1};
  to::Scalef{g, g.uniform(0.3f, 2), g.uniform(-2, -0.3f), 1};
  to::MatrixMode{g, GL_MODELVIEW};
}

}  // namespace

void set_textures(Generator& g) {
  if (!uses_textures(g)) return;
  g.units = g.has(Group::multitexture) ? g.integer(2, 3) : 1;
  for (int unit = 0; unit < g.units; ++unit) {
    if (g.has(Group::multitexture)) to::ActiveTexture{g, GL_TEXTURE0 + unit};
    to::Enable{g, GL_TEXTURE_2D};
    set_image(g);
    set_environment(g);
    if (g.has(Group::texture_matrix)) set_texture_matrix(g);
  }
}

void change_textures(Generator& g) {
  if (g.has(Group::copies)) {
    const int width = 1 << g.integer(2, 6), height = 1 << g.integer(2, 6);
    // Of the buffer's inside: what lies outside is undefined (3.7.2).
    to::CopyTexImage2D{
        g,
        GL_TEXTURE_2D,
        0,
        g.one_of<GLenum>({GL_RGBA, GL_RGB, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA}),
        g.integer(0, 128 - width),
        g.integer(0, 128 - height),
        width,
        height,
        0};
    const int w = g.integer(1, width), h = g.integer(1, height);
    to::CopyTexSubImage2D{g,
                          GL_TEXTURE_2D,
                          0,
                          g.integer(0, width - w),
                          g.integer(0, height - h),
                          g.integer(0, 128 - w),
                          g.integer(0, 128 - h),
                          w,
                          h};
    to::TexParameteri{g, GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, g.integer(GL_NEAREST, GL_LINEAR)};
  } else if (g.units != 0 && g.chance(0.3f)) {
    set_image(g);
  }
}

}  // namespace clearpipe::conformance::random
