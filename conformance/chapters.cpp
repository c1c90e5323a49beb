// See chapters.h.
// SPDX-License-Identifier: MIT
#include "conformance/chapters.h"

namespace clearpipe::conformance {

namespace {

constexpr std::string_view kOperation = "2 OpenGL ES Operation";
constexpr std::string_view kRasterization = "3 Rasterization";
constexpr std::string_view kFragments = "4 Per-Fragment Operations and the Framebuffer";

struct Topic {
  std::string_view name;
  Chapter chapter;
};

constexpr Topic kTopics[] = {
    {"arrays", {kOperation, "2.8 Vertex Arrays"}},
    {"objects", {kOperation, "2.9 Buffer Objects, with extensions of arrays"}},
    {"fixed_point", {kOperation, "2.3 GL Command Syntax, in fixed point"}},
    {"clipping", {kOperation, "2.11 Clipping"}},
    {"lighting", {kOperation, "2.12 Colors and Coloring"}},
    {"multisampling", {kRasterization, "3.2.1 Multisampling"}},
    {"primitives", {kRasterization, "3.3 Points, 3.4 Line Segments, 3.5 Polygons"}},
    {"textures", {kRasterization, "3.7 Texturing"}},
    {"combiners", {kRasterization, "3.7.12 Texture Environments"}},
    {"compressed", {kRasterization, "3.7.3 Compressed Texture Images"}},
    {"cube_maps", {kRasterization, "3.7 with OES_texture_cube_map"}},
    {"extensions", {kRasterization, "3.7 with extensions of textures"}},
    {"srgb", {kRasterization, "3.7 with EXT_sRGB"}},
    {"fog", {kRasterization, "3.8 Fog"}},
    {"fragments", {kFragments, "4.1 Per-Fragment Operations"}},
    {"framebuffers", {kFragments, "4.4 with OES_framebuffer_object"}},
    {"random", {"Random streams", "Shortened"}},
};

}  // namespace

Chapter chapter_of(std::string_view topic) {
  for (const Topic& entry : kTopics) {
    if (entry.name == topic) return entry.chapter;
  }
  return {};
}

}  // namespace clearpipe::conformance
