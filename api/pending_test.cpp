// Draws are executed after they are recorded: each must show the texels and vertices that were
// there when it was called, whatever became of the objects afterwards (2.9, 3.7.1, 3.7.2, 3.7.11).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <thread>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

// A texture or a vertex buffer is changed between two draws of a frame; `size` decides whether the
// data is copied or the frame is finished.
struct Change {
  const char* name;
  GLsizei size;
  std::function<void(GLsizei)> change;  // from red to blue
};

void sub_image(GLsizei size) {
  const std::vector<uint32_t> blue(static_cast<size_t>(size) * static_cast<size_t>(size), kBlue);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, blue.data());
}
void image(GLsizei size) {
  const std::vector<uint32_t> blue(static_cast<size_t>(size) * static_cast<size_t>(size), kBlue);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, blue.data());
}
void smaller_image(GLsizei) {
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &kBlue);
}
void higher_level(GLsizei size) {
  glTexImage2D(GL_TEXTURE_2D, 3, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &kBlue);
  sub_image(size);
}
void mipmapped_sub_image(GLsizei size) {
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  sub_image(size);
}
void paint_blue() {
  glDisable(GL_TEXTURE_2D);
  glColor4f(0, 0, 1, 1);
  glViewport(kSize / 2, 0, kSize / 2, kSize);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glEnable(GL_TEXTURE_2D);
}
void copied_image(GLsizei) {
  paint_blue();
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kSize / 2, 0, 4, 4, 0);
}
void copied_sub_image(GLsizei size) {
  paint_blue();
  const GLsizei part = std::min(size, kSize / 2);
  for (GLsizei y = 0; y < size; y += part) {
    for (GLsizei x = 0; x < size; x += part) {
      glCopyTexSubImage2D(GL_TEXTURE_2D, 0, x, y, kSize / 2, 0, part, part);
    }
  }
}
void deletion(GLsizei) {
  GLint name = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &name);
  const GLuint names[] = {static_cast<GLuint>(name)};
  glDeleteTextures(1, names);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  smaller_image(1);
}

const Change kChanges[] = {
    {"TexSubImage2D, copied", 8, sub_image},
    {"TexSubImage2D, finished", 512, sub_image},
    {"TexImage2D", 8, image},
    {"TexImage2D, large", 512, image},
    {"TexImage2D, smaller", 8, smaller_image},
    {"another level", 8, higher_level},
    {"GENERATE_MIPMAP", 8, mipmapped_sub_image},
    {"CopyTexImage2D", 8, copied_image},
    {"CopyTexSubImage2D", 8, copied_sub_image},
    {"DeleteTextures", 8, deletion},
};

class Pending : public CallTest {
 protected:
  static void expect_both(const char* what) {
    EXPECT_EQ(left(), kRed) << what;
    EXPECT_EQ(right(), kBlue) << what;
    EXPECT_ERROR(GL_NO_ERROR) << what;
  }
};

TEST_F(Pending, EachDrawShowsItsOwnTexels) {
  for (const Change& c : kChanges) {
    one_colour_texture(kRed, c.size);
    draw_half(0);
    c.change(c.size);
    draw_half(1);
    expect_both(c.name);
  }
}

// So many that the workers are given the first of them before the last is recorded.
void draw_often(int half) {
  glViewport(half * kSize / 2, 0, kSize / 2, kSize);
  for (int i = 0; i < 700; ++i) {
    i % 2 == 0 ? glEnable(GL_DEPTH_TEST) : glDisable(GL_DEPTH_TEST);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
}

TEST_F(Pending, ChangesWhileWorkersDraw) {
  glDepthFunc(GL_ALWAYS);
  for (const Change& c : kChanges) {
    one_colour_texture(kRed, c.size);
    draw_half(0);
    for (int i = 0; i < 3; ++i) draw_often(0);
    c.change(c.size);
    for (int i = 0; i < 3; ++i) draw_often(1);
    expect_both(c.name);
  }
}

// The second round begins with a context that has derived its state from the texture already.
TEST_F(Pending, ManyUpdatesInOneFrame) {
  for (const GLsizei size : {4, 512}) {
    one_colour_texture(kRed, size);
    for (int x = 0; x < kSize; ++x) {
      sub_image(size);
      const uint32_t colour = 0xff000000u | static_cast<uint32_t>(x) * 16;
      glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE,
                      texels(colour, size).data());
      glViewport(x, 0, 1, kSize);
      draw_quad();
    }
    for (int x = 0; x < kSize; ++x) {
      EXPECT_EQ(pixel(x, 5), 0xff000000u | static_cast<uint32_t>(x) * 16) << size;
    }
  }
}

// The same texture pending in a context of the share group, which cannot be finished from here.
TEST_F(Pending, AnotherContextsFrameKeepsItsTexels) {
  for (const GLsizei size : {4, 512}) {
    const GLuint name = one_colour_texture(kRed, size);
    Context* other = create_context(context_);
    const pipeline::Target other_target = make_target(kSize, kSize);
    glViewport(0, 0, kSize, kSize);
    draw_quad();
    // The frame of context_ would be finished if it were released, so the other one is made current
    // in a thread of its own while this one stays current here.
    std::thread([&] {
      make_current(other, other_target, other_target);
      glBindTexture(GL_TEXTURE_2D, name);
      sub_image(size);
      glDeleteTextures(1, &name);
      make_current(nullptr, {}, {});
    }).join();
    EXPECT_EQ(pixel(8, 8), kRed) << size;
    draw_quad();
    EXPECT_EQ(pixel(8, 8), kBlue) << size;
    destroy_context(other);
  }
}

// Two quads, the second of which covers nothing.
constexpr float kWhole[] = {-1, -1, 1, -1, -1, 1, 1, 1};
constexpr float kNothing[] = {2, 2, 2, 2, 2, 2, 2, 2};

const std::function<void(GLsizeiptr)> kBufferChanges[] = {
    [](GLsizeiptr) { glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof kNothing, kNothing); },
    [](GLsizeiptr) { glBufferData(GL_ARRAY_BUFFER, sizeof kNothing, kNothing, GL_DYNAMIC_DRAW); },
    [](GLsizeiptr) { glBufferData(GL_ARRAY_BUFFER, 0, nullptr, GL_DYNAMIC_DRAW); },
    [](GLsizeiptr) {
      const GLuint name = 5;
      glDeleteBuffers(1, &name);
    },
};

// Red from a buffer that covers all, then green from what it has become.
void draw_red_and_green(const std::function<void()>& draw) {
  glEnableClientState(GL_VERTEX_ARRAY);
  for (const GLsizeiptr size : {sizeof kWhole, size_t{1} << 20}) {
    for (const auto& change : kBufferChanges) {
      glClear(GL_COLOR_BUFFER_BIT);
      glBindBuffer(GL_ARRAY_BUFFER, 5);
      glBufferData(GL_ARRAY_BUFFER, size, nullptr, GL_DYNAMIC_DRAW);
      glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof kWhole, kWhole);
      glVertexPointer(2, GL_FLOAT, 0, nullptr);
      glColor4f(1, 0, 0, 1);
      draw();
      change(size);
      glColor4f(0, 1, 0, 1);
      draw();
      uint32_t value = 0;
      glReadPixels(kSize / 4, kSize / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &value);
      EXPECT_EQ(value, kRed);
      EXPECT_ERROR(GL_NO_ERROR);
    }
  }
}

TEST_F(Pending, EachDrawFetchesItsOwnVertices) {
  draw_red_and_green([] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 4); });
}

TEST_F(Pending, VerticesChangeWhileWorkersDraw) {
  glDepthFunc(GL_ALWAYS);
  draw_red_and_green([] {
    for (int i = 0; i < 3; ++i) draw_often(0);
  });
}

TEST_F(Pending, ElementsToo) {
  const GLushort whole[] = {0, 1, 2, 3}, nothing[] = {0, 0, 0, 0};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, kWhole);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 6);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof whole, whole, GL_STATIC_DRAW);
  glColor4f(1, 0, 0, 1);
  glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_SHORT, nullptr);
  glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, sizeof nothing, nothing);
  glColor4f(0, 1, 0, 1);
  glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_SHORT, nullptr);
  EXPECT_EQ(pixel(8, 8), kRed);
}

TEST_F(Pending, DestroyingTheContextExecutesWhatIsPending) {
  Context* other = create_context(nullptr);
  const pipeline::Target target = make_target(kSize, kSize);
  make_current(other, target, target);
  one_colour_texture(kRed, 4);
  draw_quad();
  destroy_context(other);
  EXPECT_EQ(current_context(), nullptr);
  uint32_t pixel = 0;
  pipeline::read_pixels(*target.colour, 0, 0, 1, &pixel);
  EXPECT_EQ(pixel, kRed);
  glClear(GL_COLOR_BUFFER_BIT);  // without a context: nothing
}

}  // namespace
}  // namespace clearpipe::api
