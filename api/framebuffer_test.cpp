// What becomes of a fragment's colour in the framebuffer: logical operations and masks (4.1.9,
// 4.2.2), bit by bit.
// SPDX-License-Identifier: MIT
#include <functional>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

class Framebuffer : public CallTest {
 protected:
  static constexpr uint32_t kSource = 0xcc5a0ff0u, kDestination = 0xaa333c5au;

  static GLubyte component(uint32_t colour, int i) { return static_cast<GLubyte>(colour >> 8 * i); }
  static void clear_to(uint32_t c) {
    glClearColor(component(c, 0) / 255.0f, component(c, 1) / 255.0f, component(c, 2) / 255.0f,
                 component(c, 3) / 255.0f);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  static void draw(uint32_t c) {
    glColor4ub(component(c, 0), component(c, 1), component(c, 2), component(c, 3));
    draw_quad();
  }
  static uint32_t mask_bits(unsigned mask) {
    uint32_t bits = 0;
    for (unsigned i = 0; i < 4; ++i) bits |= mask >> i & 1 ? 0xffu << 8 * i : 0;
    return bits;
  }
  static void set_mask(unsigned mask) {
    glColorMask(mask & 1, mask >> 1 & 1, mask >> 2 & 1, mask >> 3 & 1);
  }
};

struct Operation {
  GLenum op;
  std::function<uint32_t(uint32_t s, uint32_t d)> result;
};
// Table 4.2.
const Operation kOperations[] = {
    {GL_CLEAR, [](uint32_t, uint32_t) { return 0u; }},
    {GL_AND, [](uint32_t s, uint32_t d) { return s & d; }},
    {GL_AND_REVERSE, [](uint32_t s, uint32_t d) { return s & ~d; }},
    {GL_COPY, [](uint32_t s, uint32_t) { return s; }},
    {GL_AND_INVERTED, [](uint32_t s, uint32_t d) { return ~s & d; }},
    {GL_NOOP, [](uint32_t, uint32_t d) { return d; }},
    {GL_XOR, [](uint32_t s, uint32_t d) { return s ^ d; }},
    {GL_OR, [](uint32_t s, uint32_t d) { return s | d; }},
    {GL_NOR, [](uint32_t s, uint32_t d) { return ~(s | d); }},
    {GL_EQUIV, [](uint32_t s, uint32_t d) { return ~(s ^ d); }},
    {GL_INVERT, [](uint32_t, uint32_t d) { return ~d; }},
    {GL_OR_REVERSE, [](uint32_t s, uint32_t d) { return s | ~d; }},
    {GL_COPY_INVERTED, [](uint32_t s, uint32_t) { return ~s; }},
    {GL_OR_INVERTED, [](uint32_t s, uint32_t d) { return ~s | d; }},
    {GL_NAND, [](uint32_t s, uint32_t d) { return ~(s & d); }},
    {GL_SET, [](uint32_t, uint32_t) { return ~0u; }},
};

// Each operation with each mask; blending is as if disabled (4.1.9).
TEST_F(Framebuffer, LogicalOperationsWithEveryColourMask) {
  glEnable(GL_COLOR_LOGIC_OP);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_ZERO);
  for (const Operation& o : kOperations) {
    glLogicOp(o.op);
    for (unsigned mask = 0; mask < 16; ++mask) {
      set_mask(15);
      clear_to(kDestination);
      set_mask(mask);
      draw(kSource);
      const uint32_t bits = mask_bits(mask);
      EXPECT_EQ(pixel(8, 8), (o.result(kSource, kDestination) & bits) | (kDestination & ~bits))
          << std::hex << o.op << " mask " << mask;
    }
  }
}

TEST_F(Framebuffer, ColourMasksOfDrawsAndClears) {
  for (unsigned mask = 0; mask < 16; ++mask) {
    const uint32_t bits = mask_bits(mask);
    set_mask(15);
    clear_to(kDestination);
    set_mask(mask);
    draw(kSource);
    EXPECT_EQ(pixel(8, 8), (kSource & bits) | (kDestination & ~bits)) << mask;
    clear_to(0x01020304);
    EXPECT_EQ(pixel(8, 8), (0x01020304 & bits) | (kDestination & ~bits)) << mask;
  }
}

// Without alpha bits a surface reads as opaque, whatever is written.
TEST_F(Framebuffer, WithoutAlphaItReadsAsOne) {
  const pipeline::Target opaque = make_target(kSize, kSize, false);
  make_current(context_, opaque, opaque);
  glEnable(GL_COLOR_LOGIC_OP);
  for (const Operation& o : kOperations) {
    glLogicOp(o.op);
    clear_to(kDestination);
    draw(kSource);
    EXPECT_EQ(pixel(8, 8), o.result(kSource, kDestination) | 0xff000000u) << std::hex << o.op;
  }
}

// Depth and stencil: what a mask protects is still there for the next test.
TEST_F(Framebuffer, DepthAndStencilMasks) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_EQUAL);
  glClearDepthf(0.5f);  // draw_quad lies at window depth 0.5
  glClear(GL_DEPTH_BUFFER_BIT);
  glDepthMask(GL_FALSE);
  glClearDepthf(1);
  glClear(GL_DEPTH_BUFFER_BIT);
  draw(kSource);
  EXPECT_EQ(pixel(8, 8), kSource);
  glDisable(GL_DEPTH_TEST);

  glEnable(GL_STENCIL_TEST);
  glClearStencil(0xf5);
  glClear(GL_STENCIL_BUFFER_BIT);
  glStencilMask(0x3c);
  glClearStencil(0x0a);
  glClear(GL_STENCIL_BUFFER_BIT);
  const GLint cleared = (0xf5 & ~0x3c) | (0x0a & 0x3c);
  glStencilFunc(GL_EQUAL, cleared, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
  draw(kDestination);
  EXPECT_EQ(pixel(8, 8), kDestination);
  glStencilFunc(GL_EQUAL, cleared ^ 0x3c, 0xff);
  draw(kSource);
  EXPECT_EQ(pixel(8, 8), kSource);
}

}  // namespace
}  // namespace clearpipe::api
