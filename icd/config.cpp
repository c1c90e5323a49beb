// Configs: see config.h.
// SPDX-License-Identifier: MIT
#include "icd/config.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "icd/lock_surface.h"
#include "pipeline/surface.h"

namespace clearpipe::icd {

namespace {

// How eglChooseConfig compares an attribute (table 3.4).
enum class Match { kAtLeast, kExact, kMask, kFormat, kIgnored };

struct Criterion {
  EGLint attribute;
  Match match;
  EGLint value;  // the default of table 3.4
};

constexpr std::array kDefaults = {
    Criterion{EGL_BUFFER_SIZE, Match::kAtLeast, 0},
    Criterion{EGL_RED_SIZE, Match::kAtLeast, 0},
    Criterion{EGL_GREEN_SIZE, Match::kAtLeast, 0},
    Criterion{EGL_BLUE_SIZE, Match::kAtLeast, 0},
    Criterion{EGL_LUMINANCE_SIZE, Match::kAtLeast, 0},
    Criterion{EGL_ALPHA_SIZE, Match::kAtLeast, 0},
    Criterion{EGL_ALPHA_MASK_SIZE, Match::kAtLeast, 0},
    Criterion{EGL_BIND_TO_TEXTURE_RGB, Match::kExact, EGL_DONT_CARE},
    Criterion{EGL_BIND_TO_TEXTURE_RGBA, Match::kExact, EGL_DONT_CARE},
    Criterion{EGL_COLOR_BUFFER_TYPE, Match::kExact, EGL_RGB_BUFFER},
    Criterion{EGL_CONFIG_CAVEAT, Match::kExact, EGL_DONT_CARE},
    Criterion{EGL_CONFIG_ID, Match::kExact, EGL_DONT_CARE},
    Criterion{EGL_CONFORMANT, Match::kMask, 0},
    Criterion{EGL_DEPTH_SIZE, Match::kAtLeast, 0},
    Criterion{EGL_LEVEL, Match::kExact, 0},
    Criterion{EGL_MATCH_FORMAT_KHR, Match::kFormat, EGL_DONT_CARE},
    Criterion{EGL_MATCH_NATIVE_PIXMAP, Match::kIgnored, EGL_NONE},
    Criterion{EGL_MAX_SWAP_INTERVAL, Match::kExact, EGL_DONT_CARE},
    Criterion{EGL_MIN_SWAP_INTERVAL, Match::kExact, EGL_DONT_CARE},
    Criterion{EGL_NATIVE_RENDERABLE, Match::kExact, EGL_DONT_CARE},
    Criterion{EGL_NATIVE_VISUAL_TYPE, Match::kExact, EGL_DONT_CARE},
    Criterion{EGL_RENDERABLE_TYPE, Match::kMask, EGL_OPENGL_ES_BIT},
    Criterion{EGL_SAMPLE_BUFFERS, Match::kAtLeast, 0},
    Criterion{EGL_SAMPLES, Match::kAtLeast, 0},
    Criterion{EGL_STENCIL_SIZE, Match::kAtLeast, 0},
    Criterion{EGL_SURFACE_TYPE, Match::kMask, EGL_WINDOW_BIT},
    Criterion{EGL_TRANSPARENT_TYPE, Match::kExact, EGL_NONE},
    Criterion{EGL_TRANSPARENT_RED_VALUE, Match::kExact, EGL_DONT_CARE},
    Criterion{EGL_TRANSPARENT_GREEN_VALUE, Match::kExact, EGL_DONT_CARE},
    Criterion{EGL_TRANSPARENT_BLUE_VALUE, Match::kExact, EGL_DONT_CARE},
    Criterion{EGL_Y_INVERTED_NOK, Match::kExact, EGL_DONT_CARE},
    // Queries only: accepted and ignored in a list.
    Criterion{EGL_MAX_PBUFFER_WIDTH, Match::kIgnored, 0},
    Criterion{EGL_MAX_PBUFFER_HEIGHT, Match::kIgnored, 0},
    Criterion{EGL_MAX_PBUFFER_PIXELS, Match::kIgnored, 0},
    Criterion{EGL_NATIVE_VISUAL_ID, Match::kIgnored, 0},
};

// Whether eglChooseConfig takes the value; else it is unrecognized or out of range (3.4.1).
bool recognized(EGLint attribute, EGLint value) {
  constexpr EGLint kClientApis =
      EGL_OPENGL_ES_BIT | EGL_OPENGL_ES2_BIT | EGL_OPENGL_ES3_BIT | EGL_OPENVG_BIT | EGL_OPENGL_BIT;
  constexpr EGLint kSurfaceTypes =
      EGL_WINDOW_BIT | EGL_PIXMAP_BIT | EGL_PBUFFER_BIT | EGL_MULTISAMPLE_RESOLVE_BOX_BIT |
      EGL_SWAP_BEHAVIOR_PRESERVED_BIT | EGL_VG_COLORSPACE_LINEAR_BIT | EGL_VG_ALPHA_FORMAT_PRE_BIT |
      EGL_LOCK_SURFACE_BIT_KHR | EGL_OPTIMAL_FORMAT_BIT_KHR;
  if (value == EGL_DONT_CARE) {
    return attribute != EGL_LEVEL && attribute != EGL_MATCH_NATIVE_PIXMAP;
  }
  switch (attribute) {
    case EGL_BIND_TO_TEXTURE_RGB:
    case EGL_BIND_TO_TEXTURE_RGBA:
    case EGL_NATIVE_RENDERABLE:
    case EGL_Y_INVERTED_NOK:
      return value == EGL_FALSE || value == EGL_TRUE;
    case EGL_MATCH_FORMAT_KHR:
      return value == EGL_NONE ||
             (value >= EGL_FORMAT_RGB_565_EXACT_KHR && value <= EGL_FORMAT_RGBA_8888_KHR);
    case EGL_COLOR_BUFFER_TYPE:
      return value == EGL_RGB_BUFFER || value == EGL_LUMINANCE_BUFFER;
    case EGL_CONFIG_CAVEAT:
      return value == EGL_NONE || value == EGL_SLOW_CONFIG || value == EGL_NON_CONFORMANT_CONFIG;
    case EGL_TRANSPARENT_TYPE:
      return value == EGL_NONE || value == EGL_TRANSPARENT_RGB;
    case EGL_CONFORMANT:
    case EGL_RENDERABLE_TYPE:
      return (value & ~kClientApis) == 0;
    case EGL_SURFACE_TYPE:
      return (value & ~kSurfaceTypes) == 0;
    case EGL_CONFIG_ID:
      return value >= 1;
    case EGL_SAMPLE_BUFFERS:
      return value == 0 || value == 1;
    case EGL_MATCH_NATIVE_PIXMAP:
    case EGL_LEVEL:
    case EGL_NATIVE_VISUAL_TYPE:
    case EGL_NATIVE_VISUAL_ID:
    case EGL_MAX_PBUFFER_WIDTH:
    case EGL_MAX_PBUFFER_HEIGHT:
    case EGL_MAX_PBUFFER_PIXELS:
      return true;
    default:  // sizes, counts and intervals
      return value >= 0;
  }
}

struct ColourSizes {
  EGLint red, green, blue, alpha;
  pipeline::ColourFormat format;
};
constexpr ColourSizes kColours[] = {
    {8, 8, 8, 8, pipeline::ColourFormat::kRgba8},  {8, 8, 8, 0, pipeline::ColourFormat::kRgba8},
    {5, 6, 5, 0, pipeline::ColourFormat::kRgb565}, {5, 5, 5, 1, pipeline::ColourFormat::kRgb5A1},
    {4, 4, 4, 4, pipeline::ColourFormat::kRgba4},
};

bool matches(const Config& config, const Criterion& criterion) {
  if (criterion.match == Match::kIgnored || criterion.value == EGL_DONT_CARE) return true;
  EGLint value = 0;
  config_attrib(config, criterion.attribute, value);
  switch (criterion.match) {
    case Match::kAtLeast:
      return value >= criterion.value;
    case Match::kExact:
      return value == criterion.value;
    case Match::kMask:
      return (value & criterion.value) == criterion.value;
    case Match::kFormat:
      return matches_format(config, criterion.value);
    case Match::kIgnored:
      break;
  }
  return true;
}

}  // namespace

std::vector<Config> offscreen_configs() {
  // A depth of 32 bits leaves no room for stencil (pipeline/surface.h), and one of 16 with stencil
  // would be no smaller than one of 24.
  constexpr std::pair<EGLint, EGLint> kDepthStencil[] = {{0, 0},  {16, 0}, {24, 0},
                                                         {32, 0}, {0, 8},  {24, 8}};
  std::vector<Config> list;
  for (const EGLint samples : {0, pipeline::kSampleCount}) {
    for (const ColourSizes& colour : kColours) {
      for (const auto& [depth, stencil] : kDepthStencil) {
        Config config;
        config.red = colour.red;
        config.green = colour.green;
        config.blue = colour.blue;
        config.alpha = colour.alpha;
        config.format = colour.format;
        config.depth = depth;
        config.stencil = stencil;
        config.samples = samples;
        list.push_back(config);
      }
    }
  }
  return list;
}

bool config_attrib(const Config& config, EGLint attribute, EGLint& value) {
  switch (attribute) {
    case EGL_BUFFER_SIZE:
      value = config.red + config.green + config.blue + config.alpha;
      break;
    case EGL_RED_SIZE:
      value = config.red;
      break;
    case EGL_GREEN_SIZE:
      value = config.green;
      break;
    case EGL_BLUE_SIZE:
      value = config.blue;
      break;
    case EGL_ALPHA_SIZE:
      value = config.alpha;
      break;
    case EGL_DEPTH_SIZE:
      value = config.depth;
      break;
    case EGL_STENCIL_SIZE:
      value = config.stencil;
      break;
    case EGL_SAMPLE_BUFFERS:
      value = config.samples > 0 ? 1 : 0;
      break;
    case EGL_SAMPLES:
      value = config.samples;
      break;
    case EGL_LUMINANCE_SIZE:
    case EGL_ALPHA_MASK_SIZE:
    case EGL_LEVEL:
    case EGL_TRANSPARENT_RED_VALUE:
    case EGL_TRANSPARENT_GREEN_VALUE:
    case EGL_TRANSPARENT_BLUE_VALUE:
    case EGL_MIN_SWAP_INTERVAL:
    case EGL_Y_INVERTED_NOK:  // pixmaps are textures with their lower row at t = 0
      value = 0;
      break;
    case EGL_MAX_SWAP_INTERVAL:
      value = config.max_swap_interval;
      break;
    case EGL_BIND_TO_TEXTURE_RGB:
      value = EGL_TRUE;
      break;
    case EGL_BIND_TO_TEXTURE_RGBA:
      value = config.alpha > 0 ? EGL_TRUE : EGL_FALSE;
      break;
    case EGL_NATIVE_RENDERABLE:
      value = config.visual_type != EGL_NONE ? EGL_TRUE : EGL_FALSE;
      break;
    case EGL_MATCH_FORMAT_KHR:
      value = mapped_format(config);
      break;
    case EGL_NATIVE_VISUAL_ID:
      value = config.visual_id;
      break;
    case EGL_NATIVE_VISUAL_TYPE:
      value = config.visual_type;
      break;
    case EGL_COLOR_BUFFER_TYPE:
      value = EGL_RGB_BUFFER;
      break;
    case EGL_CONFIG_CAVEAT:
    case EGL_TRANSPARENT_TYPE:
      value = EGL_NONE;
      break;
    case EGL_CONFIG_ID:
      value = config.id;
      break;
    case EGL_CONFORMANT:
    case EGL_RENDERABLE_TYPE:
      value = EGL_OPENGL_ES_BIT;
      break;
    case EGL_MAX_PBUFFER_WIDTH:
    case EGL_MAX_PBUFFER_HEIGHT:
      value = kMaxPbuffer;
      break;
    case EGL_MAX_PBUFFER_PIXELS:
      value = kMaxPbuffer * kMaxPbuffer;
      break;
    case EGL_SURFACE_TYPE:
      // Posting copies: a surface keeps its pixels, so it can promise to.
      value = EGL_PBUFFER_BIT | EGL_SWAP_BEHAVIOR_PRESERVED_BIT | config.native_surfaces;
      if (config.samples > 0) value |= EGL_MULTISAMPLE_RESOLVE_BOX_BIT;
      if (is_lockable(config)) value |= EGL_LOCK_SURFACE_BIT_KHR;
      // The pixels of these are only put in another order.
      if (is_lockable(config) && config.red == 8) value |= EGL_OPTIMAL_FORMAT_BIT_KHR;
      break;
    default:
      return false;
  }
  return true;
}

EGLint choose_configs(std::span<const Config> configs, const EGLint* attrib_list,
                      const std::function<bool(EGLint)>& is_pixmap,
                      std::vector<const Config*>& out) {
  auto criteria = kDefaults;
  for (const EGLint* a = attrib_list; a != nullptr && *a != EGL_NONE; a += 2) {
    const auto found = std::find_if(criteria.begin(), criteria.end(),
                                    [&](const Criterion& c) { return c.attribute == a[0]; });
    if (found == criteria.end()) return EGL_BAD_ATTRIBUTE;
    if (!recognized(a[0], a[1])) return EGL_BAD_ATTRIBUTE;
    if (a[0] == EGL_MATCH_NATIVE_PIXMAP && a[1] != EGL_NONE && !is_pixmap(a[1])) {
      return EGL_BAD_ATTRIBUTE;
    }
    found->value = a[1];
  }
  const auto requested = [&](EGLint attribute) {
    return std::find_if(criteria.begin(), criteria.end(),
                        [&](const Criterion& c) { return c.attribute == attribute; })
        ->value;
  };
  // 3.4.1.1: attributes that count only together with another one.
  const auto ignore = [&](EGLint attribute) {
    for (Criterion& c : criteria) {
      if (c.attribute == attribute) c.match = Match::kIgnored;
    }
  };
  if ((requested(EGL_SURFACE_TYPE) & EGL_WINDOW_BIT) == 0) ignore(EGL_NATIVE_VISUAL_TYPE);
  if (requested(EGL_TRANSPARENT_TYPE) == EGL_NONE) {
    ignore(EGL_TRANSPARENT_RED_VALUE);
    ignore(EGL_TRANSPARENT_GREEN_VALUE);
    ignore(EGL_TRANSPARENT_BLUE_VALUE);
  }
  // All configs for pixmaps draw to any of them.
  if (requested(EGL_MATCH_NATIVE_PIXMAP) != EGL_NONE) {
    for (Criterion& c : criteria) {
      if (c.attribute == EGL_SURFACE_TYPE) {
        c.value = (c.value == EGL_DONT_CARE ? 0 : c.value) | EGL_PIXMAP_BIT;
      }
    }
  }
  // 3.4.1.1: a config asked for by its number is returned whatever the other attributes say.
  if (const EGLint id = requested(EGL_CONFIG_ID); id != EGL_DONT_CARE) {
    for (const Config& config : configs) {
      if (config.id == id) out.push_back(&config);
    }
    return EGL_SUCCESS;
  }
  for (const Config& config : configs) {
    if (std::all_of(criteria.begin(), criteria.end(),
                    [&](const Criterion& c) { return matches(config, c); })) {
      out.push_back(&config);
    }
  }
  // More bits of the colours that were asked for come first, then the smaller buffer, fewer
  // samples, the smaller depth and stencil, and the number of the config.
  const auto asked = [&](EGLint attribute) {
    const EGLint value = requested(attribute);
    return value != 0 && value != EGL_DONT_CARE;
  };
  const auto key = [&](const Config* c) {
    const EGLint bits =
        (asked(EGL_RED_SIZE) ? c->red : 0) + (asked(EGL_GREEN_SIZE) ? c->green : 0) +
        (asked(EGL_BLUE_SIZE) ? c->blue : 0) + (asked(EGL_ALPHA_SIZE) ? c->alpha : 0);
    return std::tuple(-bits, c->red + c->green + c->blue + c->alpha, c->samples, c->depth,
                      c->stencil, c->id);
  };
  std::sort(out.begin(), out.end(),
            [&](const Config* a, const Config* b) { return key(a) < key(b); });
  return EGL_SUCCESS;
}

}  // namespace clearpipe::icd
