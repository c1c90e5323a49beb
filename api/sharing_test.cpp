// Share groups: what one context does to textures and buffers, seen by another, on one thread and
// on several at once (2.9, 3.7.11).
// SPDX-License-Identifier: MIT
#include <atomic>
#include <thread>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

class Sharing : public CallTest {
 protected:
  void SetUp() override {
    CallTest::SetUp();
    other_ = create_context(context_);
    ASSERT_NE(other_, nullptr);
  }
  void TearDown() override {
    CallTest::TearDown();
    destroy_context(other_);
  }
  void use_first() { make_current(context_, target_, target_); }
  void use_other() { make_current(other_, other_target_, other_target_); }
  // While the first context stays current here: making it current again would derive all anew.
  template <typename Body>
  void in_other_thread(const Body& body) {
    std::thread([&] {
      use_other();
      body();
      make_current(nullptr, {}, {});
    }).join();
  }
  static GLint get(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
  }
  pipeline::Target other_target_ = make_target(kSize, kSize);
  Context* other_ = nullptr;
};

TEST_F(Sharing, TextureDeletedElsewhereStaysBoundAndDrawn) {
  const GLuint name = one_colour_texture(kRed);
  use_other();
  EXPECT_TRUE(glIsTexture(name));
  glBindTexture(GL_TEXTURE_2D, name);
  glDeleteTextures(1, &name);
  EXPECT_EQ(get(GL_TEXTURE_BINDING_2D), 0);
  use_first();
  EXPECT_FALSE(glIsTexture(name));
  EXPECT_EQ(get(GL_TEXTURE_BINDING_2D), static_cast<GLint>(name));
  draw_quad();
  EXPECT_EQ(pixel(8, 8), kRed);
}

// A name used again belongs to another object than the one that is still bound elsewhere.
TEST_F(Sharing, DeletingAReusedNameLeavesTheFormerObjectBound) {
  const GLuint name = one_colour_texture(kRed);
  use_other();
  glDeleteTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  use_first();
  glDeleteTextures(1, &name);
  draw_quad();
  EXPECT_EQ(pixel(8, 8), kRed);

  glBindBuffer(GL_ARRAY_BUFFER, 7);
  use_other();
  const GLuint buffer = 7;
  glDeleteBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, 7);
  use_first();
  glDeleteBuffers(1, &buffer);
  EXPECT_EQ(get(GL_ARRAY_BUFFER_BINDING), 7);
}

TEST_F(Sharing, BufferDeletedElsewhereStaysBound) {
  static const float kQuad[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  const GLuint name = 3;
  glBindBuffer(GL_ARRAY_BUFFER, name);
  glBufferData(GL_ARRAY_BUFFER, sizeof kQuad, kQuad, GL_STATIC_DRAW);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  glEnableClientState(GL_VERTEX_ARRAY);
  use_other();
  EXPECT_TRUE(glIsBuffer(name));
  glDeleteBuffers(1, &name);
  EXPECT_FALSE(glIsBuffer(name));
  use_first();
  glColor4f(0, 1, 0, 1);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_EQ(pixel(8, 8), kGreen);
}

// Filters and wrap modes changed in another context act on the next draw here, without a bind.
TEST_F(Sharing, ParametersChangedElsewhereAreNoticed) {
  const uint32_t row[2] = {kRed, kBlue};
  const GLuint name = one_colour_texture(kRed);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, row);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glMatrixMode(GL_TEXTURE);
  glTranslatef(1, 0, 0);
  draw_quad();
  EXPECT_EQ(left(), kRed);

  const auto set = [&](GLenum parameter, GLint value) {
    in_other_thread([&] {
      glBindTexture(GL_TEXTURE_2D, name);
      glTexParameteri(GL_TEXTURE_2D, parameter, value);
    });
    draw_quad();
  };
  set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  EXPECT_EQ(left(), kBlue);
  set(GL_TEXTURE_WRAP_S, GL_REPEAT);
  EXPECT_EQ(left(), kRed);
  set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  EXPECT_NE(pixel(0, 8), kRed);  // half of the wrapped blue
  set(GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  EXPECT_EQ(left(), kWhite);  // incomplete now
  in_other_thread([&] {
    glBindTexture(GL_TEXTURE_2D, name);
    fill_texture(kGreen);  // 1x1 is complete
  });
  draw_quad();
  EXPECT_EQ(left(), kGreen);
}

// Both draw with the objects that both change. What is drawn is one of the colours that were ever
// uploaded, and nothing else; a data race shows in the thread sanitizer.
TEST_F(Sharing, ThreadsMayDrawWhatOthersChange) {
  constexpr int kRounds = 200;
  const GLuint texture = one_colour_texture(kRed, 4);
  static const float kQuad[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  glBindBuffer(GL_ARRAY_BUFFER, 9);
  glBufferData(GL_ARRAY_BUFFER, sizeof kQuad, kQuad, GL_DYNAMIC_DRAW);
  std::atomic<int> strange{0};
  const auto work = [&](Context* context, const pipeline::Target& target, uint32_t colour) {
    make_current(context, target, target);
    glBindTexture(GL_TEXTURE_2D, texture);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glBindBuffer(GL_ARRAY_BUFFER, 9);
    glVertexPointer(2, GL_FLOAT, 0, nullptr);
    glEnableClientState(GL_VERTEX_ARRAY);
    for (int i = 0; i < kRounds; ++i) {
      if (i % 3 == 0) fill_texture(colour, 4);
      glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE,
                      texels(colour, 4).data());
      glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof kQuad, kQuad);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, i % 2 ? GL_NEAREST : GL_LINEAR);
      glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
      if (i % 7 == 0) glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 4, 4);
      const uint32_t seen = pixel(8, 8);
      if (seen != kRed && seen != kBlue) ++strange;
      GLuint own = 0;
      glGenTextures(1, &own);
      glDeleteTextures(1, &own);
    }
    if (glGetError() != GL_NO_ERROR) ++strange;
    make_current(nullptr, {}, {});
  };
  make_current(nullptr, {}, {});
  std::thread thread([&] { work(other_, other_target_, kBlue); });
  work(context_, target_, kRed);
  thread.join();
  EXPECT_EQ(strange, 0);
}

}  // namespace
}  // namespace clearpipe::api
