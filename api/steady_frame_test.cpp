// A frame like the one before it allocates nothing: every allocation of the process is counted,
// whoever makes it.
// SPDX-License-Identifier: MIT
#include <atomic>
#include <cstdlib>
#include <new>

#include "api/call_fixture.h"

namespace {
std::atomic<size_t> allocations{0};
}  // namespace

void* operator new(size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(size_t size, std::align_val_t alignment) {
  ++allocations;
  const size_t align = static_cast<size_t>(alignment);
  if (void* memory = std::aligned_alloc(align, (size + align - 1) / align * align)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, size_t, std::align_val_t) noexcept { std::free(memory); }

namespace clearpipe::api {
namespace {

class SteadyFrame : public CallTest {
 protected:
  template <typename Frame>
  static size_t allocations_of(const Frame& frame) {
    for (int i = 0; i < 4; ++i) frame();
    const size_t before = allocations;
    for (int i = 0; i < 3; ++i) frame();
    return allocations - before;
  }
};

TEST_F(SteadyFrame, CountsAllocations) {
  EXPECT_GT(allocations_of([] { std::vector<int> some(100); }), 0u);
}

TEST_F(SteadyFrame, WithManySmallDrawsAllocatesNothing) {
  const GLuint red = one_colour_texture(kRed), blue = one_colour_texture(kBlue);
  static const GLfloat corners[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  static const GLushort indices[] = {0, 1, 2, 2, 1, 3};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, corners);
  EXPECT_EQ(allocations_of([&] {
              glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
              for (int i = 0; i < 2000; ++i) {
                glBindTexture(GL_TEXTURE_2D, i % 3 == 0 ? red : blue);
                i % 5 == 0 ? glEnable(GL_BLEND) : glDisable(GL_BLEND);
                glColor4f(1, static_cast<float>(i % 2), 0, 1);
                glPushMatrix();
                glTranslatef(0.001f * static_cast<float>(i), 0, 0);
                i % 2 == 0 ? glDrawArrays(GL_TRIANGLE_STRIP, 0, 4)
                           : glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, indices);
                glPopMatrix();
              }
              glFinish();
            }),
            0u);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(SteadyFrame, WithAMeshAllocatesNothing) {
  constexpr int kVertices = 6000;
  std::vector<GLfloat> positions;
  for (int i = 0; i < 2 * kVertices; ++i) {
    positions.push_back(static_cast<float>(i * 7919 % 2003) / 1000.0f - 1.0f);
  }
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(positions.size() * sizeof(GLfloat)),
               positions.data(), GL_STATIC_DRAW);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  std::vector<uint32_t> pixels(static_cast<size_t>(kSize) * kSize);
  EXPECT_EQ(allocations_of([&] {
              glClear(GL_COLOR_BUFFER_BIT);
              glDrawArrays(GL_TRIANGLES, 0, kVertices);
              glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
            }),
            0u);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(SteadyFrame, WithANewImageAllocatesNothing) {
  const GLuint name = one_colour_texture(kRed);
  const std::vector<GLushort> image(size_t{512} * 512, 0x1234);
  EXPECT_EQ(allocations_of([&] {
              glBindTexture(GL_TEXTURE_2D, name);
              glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 512, 512, 0, GL_RGB, GL_UNSIGNED_SHORT_5_6_5,
                           image.data());
              draw_quad();
              glFinish();
            }),
            0u);
  EXPECT_ERROR(GL_NO_ERROR);
}

TEST_F(SteadyFrame, WithAFramebufferObjectAllocatesNothing) {
  const GLuint name = one_colour_texture(kRed, 128);
  GLuint framebuffer = 0, depth = 0;
  glGenFramebuffersOES(1, &framebuffer);
  glBindFramebufferOES(GL_FRAMEBUFFER_OES, framebuffer);
  glFramebufferTexture2DOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, name, 0);
  glGenRenderbuffersOES(1, &depth);
  glBindRenderbufferOES(GL_RENDERBUFFER_OES, depth);
  glRenderbufferStorageOES(GL_RENDERBUFFER_OES, GL_DEPTH_COMPONENT24_OES, 128, 128);
  glFramebufferRenderbufferOES(GL_FRAMEBUFFER_OES, GL_DEPTH_ATTACHMENT_OES, GL_RENDERBUFFER_OES,
                               depth);
  EXPECT_EQ(allocations_of([&] {
              glBindFramebufferOES(GL_FRAMEBUFFER_OES, framebuffer);
              glDisable(GL_TEXTURE_2D);
              glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
              draw_quad();
              glBindFramebufferOES(GL_FRAMEBUFFER_OES, 0);
              glEnable(GL_TEXTURE_2D);
              draw_quad();
              glFinish();
            }),
            0u);
  EXPECT_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace clearpipe::api
