// EGLImages (3.9, EGL_KHR_image_base, EGL_KHR_gl_image) and what OpenGL ES makes of them
// (OES_EGL_image): memory that textures and renderbuffers of several contexts share.
// SPDX-License-Identifier: MIT
#include <thread>

#include "icd/image_test.h"

namespace clearpipe::icd {
namespace {

TEST_F(ImageTest, Extensions) {
  const auto egl = words(eglQueryString(display, EGL_EXTENSIONS));
  for (const char* name : {"EGL_KHR_image", "EGL_KHR_image_base", "EGL_KHR_gl_texture_2D_image",
                           "EGL_KHR_gl_texture_cubemap_image", "EGL_KHR_gl_renderbuffer_image"}) {
    EXPECT_TRUE(egl.count(name)) << name;
  }
  const auto gl = words(reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS)));
  EXPECT_TRUE(gl.count("GL_OES_EGL_image"));
  EXPECT_TRUE(gl.count("GL_OES_EGL_image_external"));
  EXPECT_TRUE(gl.count("GL_OES_EGL_sync"));
}

TEST_F(ImageTest, RefusedToCreate) {
  const GLuint name = texture(kRed);
  const auto refuse = [&](EGLContext ctx, EGLenum target, GLuint source, EGLint error,
                          std::vector<EGLAttrib> list = {}) {
    list.push_back(EGL_NONE);
    EXPECT_EGL_FAIL(eglCreateImage(display, ctx, target, buffer(source), list.data()), EGL_NO_IMAGE,
                    error);
    const std::vector<EGLint> khr_list(list.begin(), list.end());
    EXPECT_EGL_FAIL(create_khr(display, ctx, target, buffer(source), khr_list.data()), EGL_NO_IMAGE,
                    error);
  };
  refuse(random_handle(), EGL_GL_TEXTURE_2D, name, EGL_BAD_CONTEXT);
  refuse(EGL_NO_CONTEXT, EGL_GL_TEXTURE_2D, name, EGL_BAD_CONTEXT);
  refuse(context_, EGL_GL_TEXTURE_3D, name, EGL_BAD_PARAMETER);
  refuse(context_, EGL_NATIVE_PIXMAP_KHR, name, EGL_BAD_PARAMETER);
  refuse(EGL_NO_CONTEXT, EGL_NATIVE_PIXMAP_KHR, name, EGL_BAD_PARAMETER);
  refuse(context_, GL_TEXTURE_2D, name, EGL_BAD_PARAMETER);
  refuse(context_, EGL_GL_TEXTURE_2D, 0, EGL_BAD_PARAMETER);
  refuse(context_, EGL_GL_TEXTURE_2D, name + 1, EGL_BAD_PARAMETER);
  refuse(context_, EGL_GL_RENDERBUFFER, name, EGL_BAD_PARAMETER);
  refuse(context_, EGL_GL_TEXTURE_2D, name, EGL_BAD_PARAMETER, {EGL_WIDTH, 1});
  refuse(context_, EGL_GL_TEXTURE_2D, name, EGL_BAD_PARAMETER, {EGL_IMAGE_PRESERVED, 2});
  refuse(context_, EGL_GL_TEXTURE_2D, name, EGL_BAD_MATCH, {EGL_GL_TEXTURE_LEVEL, 1});
  refuse(context_, EGL_GL_TEXTURE_2D, name, EGL_BAD_MATCH, {EGL_GL_TEXTURE_LEVEL, -1});
  refuse(context_, EGL_GL_TEXTURE_2D, name, EGL_BAD_MATCH, {EGL_GL_TEXTURE_LEVEL, 1000});
  EXPECT_EGL_FAIL(
      eglCreateImage(random_handle(), context_, EGL_GL_TEXTURE_2D, buffer(name), nullptr),
      EGL_NO_IMAGE, EGL_BAD_DISPLAY);
  EXPECT_EGL_FAIL(eglDestroyImage(random_handle(), random_handle()), EGL_FALSE, EGL_BAD_DISPLAY);
  EXPECT_EGL_FAIL(eglDestroyImage(display, random_handle()), EGL_FALSE, EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(destroy_khr(display, EGL_NO_IMAGE), EGL_FALSE, EGL_BAD_PARAMETER);
  // Renderbuffers that have no storage, and textures without the levels that they want.
  refuse(context_, EGL_GL_RENDERBUFFER, empty_renderbuffer(), EGL_BAD_PARAMETER);
  refuse(context_, EGL_GL_TEXTURE_2D, empty_texture(), EGL_BAD_PARAMETER);
  // Textures of another target.
  GLuint cube = 0;
  glGenTextures(1, &cube);
  glBindTexture(GL_TEXTURE_CUBE_MAP_OES, cube);
  glTexParameteri(GL_TEXTURE_CUBE_MAP_OES, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  for (GLenum face = 0; face < 6; ++face) {
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face, 0, GL_RGBA, kSize, kSize, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, texels(kRed, kSize).data());
  }
  refuse(context_, EGL_GL_TEXTURE_2D, cube, EGL_BAD_PARAMETER);
  // Multisampled ones.
  const GLuint multisampled = empty_renderbuffer();
  proc<PFNGLRENDERBUFFERSTORAGEMULTISAMPLEEXTPROC>("glRenderbufferStorageMultisampleEXT")(
      GL_RENDERBUFFER_OES, 4, GL_RGBA8_OES, kSize, kSize);
  refuse(context_, EGL_GL_RENDERBUFFER, multisampled, EGL_BAD_PARAMETER);
  const GLuint incomplete = texture(kRed);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  tex_image(kRed, 1, kSize / 2);
  refuse(context_, EGL_GL_TEXTURE_2D, incomplete, EGL_BAD_PARAMETER);
  refuse(context_, EGL_GL_TEXTURE_2D, incomplete, EGL_BAD_PARAMETER, {EGL_GL_TEXTURE_LEVEL, 1});
}

TEST_F(ImageTest, RefusedByAnotherDisplay) {
  const GLuint name = texture(kRed);
  auto devices = proc<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  EGLDeviceEXT device = nullptr;
  EGLint count = 0;
  ASSERT_TRUE(devices(1, &device, &count));
  const EGLDisplay other = eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  ASSERT_TRUE(eglInitialize(other, nullptr, nullptr));
  EXPECT_EGL_FAIL(eglCreateImage(other, context_, EGL_GL_TEXTURE_2D, buffer(name), nullptr),
                  EGL_NO_IMAGE, EGL_BAD_MATCH);
  const EGLImage image = image_of_texture(name);
  EXPECT_EGL_FAIL(eglDestroyImage(other, image), EGL_FALSE, EGL_BAD_PARAMETER);
  EXPECT_EGL_OK(eglDestroyImage(display, image));
  eglTerminate(other);
}

TEST_F(ImageTest, RefusedAsTargets) {
  const EGLImage image = image_of_texture(texture(kRed));
  ASSERT_NE(image, EGL_NO_IMAGE);
  image_target_texture(GL_TEXTURE_2D, random_handle());
  expect_gl_error(GL_INVALID_VALUE);
  image_target_texture(GL_TEXTURE_2D, nullptr);
  expect_gl_error(GL_INVALID_VALUE);
  image_target_texture(GL_RENDERBUFFER_OES, image);
  expect_gl_error(GL_INVALID_ENUM);
  image_target_renderbuffer(GL_RENDERBUFFER_OES, image);
  expect_gl_error(GL_INVALID_OPERATION);  // none is bound
  empty_renderbuffer();
  image_target_renderbuffer(GL_TEXTURE_2D, image);
  expect_gl_error(GL_INVALID_ENUM);
  image_target_renderbuffer(GL_RENDERBUFFER_OES, random_handle());
  expect_gl_error(GL_INVALID_VALUE);
  // Nothing can be drawn to an image of alpha alone.
  const GLuint alpha = empty_texture();
  glTexImage2D(GL_TEXTURE_2D, 0, GL_ALPHA, 1, 1, 0, GL_ALPHA, GL_UNSIGNED_BYTE, "a");
  image_target_renderbuffer(GL_RENDERBUFFER_OES, image_of_texture(alpha));
  expect_gl_error(GL_INVALID_OPERATION);
  // Depth is not sampled.
  const EGLImage depth = create(EGL_GL_RENDERBUFFER, renderbuffer(GL_DEPTH_COMPONENT16_OES));
  ASSERT_NE(depth, EGL_NO_IMAGE);
  image_target_texture(GL_TEXTURE_2D, depth);
  expect_gl_error(GL_INVALID_OPERATION);
  EXPECT_EGL_OK(eglDestroyImage(display, image));
  image_target_texture(GL_TEXTURE_2D, image);
  expect_gl_error(GL_INVALID_VALUE);
}

TEST_F(ImageTest, SourceCannotBeSharedTwice) {
  const GLuint name = texture(kRed);
  const EGLImage image = image_of_texture(name);
  EXPECT_EGL_FAIL(image_of_texture(name), EGL_NO_IMAGE, EGL_BAD_ACCESS);
  const GLuint target = target_texture(image);
  EXPECT_EGL_FAIL(image_of_texture(target), EGL_NO_IMAGE, EGL_BAD_ACCESS);
  EXPECT_EGL_OK(eglDestroyImage(display, image));
  EXPECT_EGL_FAIL(image_of_texture(name), EGL_NO_IMAGE, EGL_BAD_ACCESS);
  glDeleteTextures(1, &target);
  EXPECT_NE(image_of_texture(name), EGL_NO_IMAGE);
  const GLuint colour = renderbuffer(GL_RGBA8_OES);
  EXPECT_NE(create(EGL_GL_RENDERBUFFER, colour), EGL_NO_IMAGE);
  EXPECT_EGL_FAIL(create(EGL_GL_RENDERBUFFER, colour), EGL_NO_IMAGE, EGL_BAD_ACCESS);
}

// What one context uploads, draws to or copies into a sibling, the other one sees.
TEST_F(ImageTest, TextureSharedBetweenContexts) {
  const GLuint source = texture(kRed);
  const EGLImage image = image_of_texture(source);
  const EGLContext other = context();
  bind(other);
  const GLuint target = target_texture(image);
  EXPECT_EQ(look_at(target), kRed);
  tex_sub_image(kGreen);
  EXPECT_EQ(look_at(target), kGreen);
  bind(context_);
  EXPECT_EQ(look_at(source), kGreen);
  framebuffer_of_texture(source);
  clear(kBlue);
  EXPECT_EQ(pixel(), kBlue);
  to_surface();
  bind(other);
  EXPECT_EQ(look_at(target), kBlue);
  clear(kWhite);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, kSize, kSize);
  bind(context_);
  EXPECT_EQ(look_at(source), kWhite);
}

// A draw shows what was there when it was recorded, whichever sibling is changed after it.
TEST_F(ImageTest, DrawsThatWaitKeepTheirTexels) {
  const GLuint source = texture(kRed);
  const EGLImage image = image_of_texture(source);
  const GLuint target = target_texture(image);
  clear(0);
  for (int i = 0; i < 4; ++i) {
    const uint32_t colour[] = {kRed, kGreen, kBlue, kWhite};
    glBindTexture(GL_TEXTURE_2D, i % 2 == 0 ? source : target);
    tex_sub_image(colour[i]);
    glBindTexture(GL_TEXTURE_2D, i % 2 == 0 ? target : source);
    glViewport(2 * i, 0, 2, kSize);
    draw_texture();
  }
  glViewport(0, 0, kSize, kSize);
  EXPECT_EQ(pixel(0), kRed);
  EXPECT_EQ(pixel(2), kGreen);
  EXPECT_EQ(pixel(4), kBlue);
  EXPECT_EQ(pixel(6), kWhite);
  EXPECT_EQ(look_at(source), kWhite);
  EXPECT_EQ(look_at(target), kWhite);
  // Larger than what is copied rather than waited for.
  constexpr int kLarge = 512;
  const GLuint large = empty_texture();
  tex_image(kRed, 0, kLarge);
  const GLuint large_target = target_texture(image_of_texture(large));
  clear(0);
  draw_texture();
  glBindTexture(GL_TEXTURE_2D, large);
  tex_sub_image(kGreen, 0, kLarge);
  EXPECT_EQ(pixel(), kRed);
  EXPECT_EQ(look_at(large_target), kGreen);
}

// Drawing to a sibling and uploading to another one: both arrive, in order.
TEST_F(ImageTest, DrawnToAndUploaded) {
  const GLuint source = texture(kRed);
  const GLuint target = target_texture(image_of_texture(source));
  framebuffer_of_texture(source);
  clear(kBlue);
  glBindTexture(GL_TEXTURE_2D, target);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &kGreen);
  EXPECT_EQ(pixel(0, 0), kGreen);
  EXPECT_EQ(pixel(1, 1), kBlue);
  // A sibling of what is drawn to is sampled: undefined, and harmless.
  draw_texture();
  glFinish();
  expect_gl_error(GL_NO_ERROR);
}

TEST_F(ImageTest, RenderbufferBecomesTexture) {
  for (const GLenum format : {GL_RGBA8_OES, GL_RGB565_OES}) {
    const GLuint source = renderbuffer(format, 100);
    const GLuint target_of_source = framebuffer_of_renderbuffer(source);
    clear(kRed);
    const EGLImage image = create(EGL_GL_RENDERBUFFER, source, {EGL_IMAGE_PRESERVED, EGL_TRUE});
    ASSERT_NE(image, EGL_NO_IMAGE);
    to_surface();
    const GLuint target = target_texture(image);
    EXPECT_EQ(look_at(target), kRed);
    bind_framebuffer(GL_FRAMEBUFFER_OES, target_of_source);
    clear(kGreen & 0x00ffffffu);
    to_surface();
    EXPECT_EQ(look_at(target), format == GL_RGBA8_OES ? kGreen & 0x00ffffffu : kGreen);
    const std::vector<uint32_t> rows = texels(kBlue, 100);
    const GLenum upload = format == GL_RGBA8_OES ? GL_RGBA : GL_RGB;
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 32, 32, upload, GL_UNSIGNED_BYTE, rows.data());
    expect_gl_error(GL_NO_ERROR);
    bind_framebuffer(GL_FRAMEBUFFER_OES, target_of_source);
    EXPECT_NE(pixel(), kGreen);
    EXPECT_EQ(pixel(60, 60) | 0xff000000u, kGreen);
    to_surface();
  }
}

TEST_F(ImageTest, TextureBecomesRenderbuffer) {
  const GLuint source = texture(kRed);
  const EGLImage image = image_of_texture(source);
  bind(context());
  const GLuint target = empty_renderbuffer();
  image_target_renderbuffer(GL_RENDERBUFFER_OES, image);
  expect_gl_error(GL_NO_ERROR);
  GLint value = 0;
  get_renderbuffer(GL_RENDERBUFFER_OES, GL_RENDERBUFFER_WIDTH_OES, &value);
  EXPECT_EQ(value, kSize);
  get_renderbuffer(GL_RENDERBUFFER_OES, GL_RENDERBUFFER_ALPHA_SIZE_OES, &value);
  EXPECT_EQ(value, 8);
  get_renderbuffer(GL_RENDERBUFFER_OES, GL_RENDERBUFFER_INTERNAL_FORMAT_OES, &value);
  EXPECT_EQ(value, GL_RGBA8_OES);
  framebuffer_of_renderbuffer(target);
  EXPECT_EQ(pixel(), kRed);
  clear(kGreen);
  to_surface();
  bind(context_);
  EXPECT_EQ(look_at(source), kGreen);
  // An upload that must not disturb a draw which waits replaces the memory: the renderbuffer
  // follows.
  clear(0);
  draw_texture();
  tex_sub_image(kBlue);
  EXPECT_EQ(pixel(), kGreen);
  bind(eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr));
  const GLuint again = empty_renderbuffer();
  image_target_renderbuffer(GL_RENDERBUFFER_OES, image);
  framebuffer_of_renderbuffer(again);
  EXPECT_EQ(pixel(), kBlue);
  // Other storage: no sibling any more.
  renderbuffer_storage(GL_RENDERBUFFER_OES, GL_RGBA8_OES, kSize, kSize);
  clear(kWhite);
  to_surface();
  EXPECT_EQ(look_at(target_texture(image)), kBlue);
}

TEST_F(ImageTest, DepthIsShared) {
  const GLuint colour = renderbuffer(GL_RGBA8_OES), depth = renderbuffer(GL_DEPTH24_STENCIL8_OES);
  const EGLImage image = create(EGL_GL_RENDERBUFFER, depth);
  ASSERT_NE(image, EGL_NO_IMAGE);
  framebuffer_of_renderbuffer(colour);
  framebuffer_renderbuffer(GL_FRAMEBUFFER_OES, GL_DEPTH_ATTACHMENT_OES, GL_RENDERBUFFER_OES, depth);
  glClearDepthf(0.25f);
  glClear(GL_DEPTH_BUFFER_BIT);
  bind(context());
  const GLuint other_depth = empty_renderbuffer();
  image_target_renderbuffer(GL_RENDERBUFFER_OES, image);
  expect_gl_error(GL_NO_ERROR);
  const GLuint other_colour = renderbuffer(GL_RGBA8_OES);
  framebuffer_of_renderbuffer(other_colour);
  framebuffer_renderbuffer(GL_FRAMEBUFFER_OES, GL_DEPTH_ATTACHMENT_OES, GL_RENDERBUFFER_OES,
                           other_depth);
  ASSERT_EQ(check_framebuffer(GL_FRAMEBUFFER_OES),
            static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE_OES));
  clear(0);
  glEnable(GL_DEPTH_TEST);
  glColor4f(1, 1, 1, 1);
  draw_texture();  // at a depth of 0.5: behind
  EXPECT_EQ(pixel(), 0u);
  glTranslatef(0, 0, 0.75f);
  glScalef(1, 1, -1);
  glLoadIdentity();
  glTranslatef(0, 0, -0.75f);  // at 0.125: in front
  draw_texture();
  EXPECT_EQ(pixel(), kWhite);
}

// A level of a mipmap; the base level of the target is it.
TEST_F(ImageTest, LevelOfAMipmap) {
  const GLuint source = texture(kRed);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  tex_image(kGreen, 1, kSize / 2);
  tex_image(kBlue, 2, kSize / 4);
  tex_image(kWhite, 3, kSize / 8);
  const EGLImage image = image_of_texture(source, 2);
  ASSERT_NE(image, EGL_NO_IMAGE);
  EXPECT_NE(image_of_texture(source, 1), EGL_NO_IMAGE);  // another level, another image
  const GLuint target = target_texture(image);
  EXPECT_EQ(look_at(target), kBlue);
  glBindTexture(GL_TEXTURE_2D, source);
  tex_sub_image(kRed, 2, kSize / 4);
  EXPECT_EQ(look_at(target), kRed);
  // Generated anew, a complete mipmap remains what it was, and shared (issues 4 and 5 of
  // EGL_KHR_gl_image).
  glBindTexture(GL_TEXTURE_2D, source);
  tex_sub_image(kGreen);
  generate_mipmap(GL_TEXTURE_2D);
  EXPECT_EQ(look_at(target), kGreen);
  glBindTexture(GL_TEXTURE_2D, source);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  tex_sub_image(kWhite);
  EXPECT_EQ(look_at(target), kWhite);
}

// Respecified, a texture is no sibling any more, and takes nothing from the others.
TEST_F(ImageTest, RespecifiedTexturesAreOrphans) {
  const GLuint source = texture(kRed);
  const EGLImage image = image_of_texture(source);
  const GLuint first = target_texture(image), second = target_texture(image);
  glBindTexture(GL_TEXTURE_2D, source);
  tex_image(kGreen);
  EXPECT_EQ(look_at(first), kRed);
  EXPECT_EQ(look_at(second), kRed);
  // A new level: the base level is kept, as a copy.
  glBindTexture(GL_TEXTURE_2D, first);
  tex_image(kWhite, 1, kSize / 2);
  EXPECT_EQ(look_at(first), kRed);
  glBindTexture(GL_TEXTURE_2D, second);
  tex_sub_image(kBlue);
  EXPECT_EQ(look_at(first), kRed);
  // So is a mipmap where there was none.
  const GLuint third = target_texture(image);
  generate_mipmap(GL_TEXTURE_2D);
  tex_sub_image(kWhite);
  EXPECT_EQ(look_at(third), kWhite);
  EXPECT_EQ(look_at(second), kBlue);
  EXPECT_EQ(look_at(source), kGreen);
  // Specified by another image, or by the same once more.
  glBindTexture(GL_TEXTURE_2D, third);
  image_target_texture(GL_TEXTURE_2D, image);
  EXPECT_EQ(look_at(third), kBlue);
  // The source is free to be one again.
  EXPECT_NE(image_of_texture(source), EGL_NO_IMAGE);
}

// The target had other levels: they are gone.
TEST_F(ImageTest, TargetLosesItsImages) {
  const EGLImage image = image_of_texture(texture(kRed));
  const GLuint name = texture(kGreen);
  for (int level = 1; level < 4; ++level) tex_image(kGreen, level, kSize >> level);
  image_target_texture(GL_TEXTURE_2D, image);
  EXPECT_EQ(look_at(name), kRed);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  glColor4f(1, 1, 1, 1);
  EXPECT_EQ(look_at(name), kWhite);  // incomplete: texturing is as if disabled
}

// Siblings live on without the image, the source and its context.
TEST_F(ImageTest, Lifetimes) {
  const GLuint source = texture(kRed);
  const EGLImage image = image_of_texture(source);
  const EGLContext other = context();
  bind(other);
  const GLuint target = target_texture(image);
  bind(context_);
  glDeleteTextures(1, &source);
  bind(other);
  const GLuint second = target_texture(image);  // the source is gone, the image is not
  EXPECT_EGL_OK(eglDestroyImage(display, image));
  EXPECT_EGL_FAIL(eglDestroyImage(display, image), EGL_FALSE, EGL_BAD_PARAMETER);
  EXPECT_EGL_OK(eglDestroyContext(display, context_));
  tex_sub_image(kBlue);
  EXPECT_EQ(look_at(target), kBlue);
  EXPECT_EQ(look_at(second), kBlue);
  const GLuint colour = renderbuffer(GL_RGBA8_OES);
  framebuffer_of_renderbuffer(colour);
  clear(kGreen);
  const EGLImage image_of_colour = create(EGL_GL_RENDERBUFFER, colour);
  to_surface();
  delete_renderbuffers(1, &colour);
  EXPECT_EQ(look_at(target_texture(image_of_colour)), kGreen);
}

// A context that is not current can be the one whose texture is shared.
TEST_F(ImageTest, SourceOfAContextThatIsNotCurrent) {
  const GLuint source = texture(kGreen);
  bind(context());
  const EGLImage image =
      eglCreateImage(display, context_, EGL_GL_TEXTURE_2D, buffer(source), nullptr);
  ASSERT_NE(image, EGL_NO_IMAGE);
  EXPECT_EQ(look_at(target_texture(image)), kGreen);
}

TEST_F(ImageTest, TerminatedWithTheDisplay) {
  const EGLImage image = image_of_texture(texture(kRed));
  const GLuint target = target_texture(image);
  ASSERT_TRUE(eglTerminate(display));
  EXPECT_EQ(look_at(target), kRed);  // the context is still current
  image_target_texture(GL_TEXTURE_2D, image);
  expect_gl_error(GL_INVALID_VALUE);
  EXPECT_EGL_FAIL(eglDestroyImage(display, image), EGL_FALSE, EGL_NOT_INITIALIZED);
  eglReleaseThread();
  ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
  EXPECT_EGL_FAIL(eglDestroyImage(display, image), EGL_FALSE, EGL_BAD_PARAMETER);
}

// One thread draws to the image, another one shows it, in turns kept by syncs.
TEST_F(ImageTest, ProducerAndConsumerThreads) {
  constexpr int kFrames = 40;
  auto create_sync = proc<PFNEGLCREATESYNCKHRPROC>("eglCreateSyncKHR");
  auto signal_sync = proc<PFNEGLSIGNALSYNCKHRPROC>("eglSignalSyncKHR");
  const EGLImage image = image_of_texture(texture(kRed));
  std::vector<EGLSync> drawn, shown;
  for (int i = 0; i < kFrames; ++i) {
    drawn.push_back(create_sync(display, EGL_SYNC_REUSABLE_KHR, nullptr));
    shown.push_back(create_sync(display, EGL_SYNC_REUSABLE_KHR, nullptr));
  }
  const EGLContext other = context();
  std::thread producer([&] {
    ASSERT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, other));
    const GLuint target = target_texture(image);
    framebuffer_of_texture(target);
    for (size_t i = 0; i < kFrames; ++i) {
      if (i % 2 == 0) {
        clear(0xff000000u + static_cast<uint32_t>(i));
      } else {
        tex_sub_image(0xff000000u + static_cast<uint32_t>(i));
      }
      glFinish();
      signal_sync(display, drawn[i], EGL_SIGNALED);
      eglClientWaitSync(display, shown[i], 0, EGL_FOREVER);
    }
    eglReleaseThread();
  });
  const GLuint target = target_texture(image);
  for (size_t i = 0; i < kFrames; ++i) {
    eglClientWaitSync(display, drawn[i], 0, EGL_FOREVER);
    EXPECT_EQ(look_at(target), 0xff000000u + static_cast<uint32_t>(i));
    signal_sync(display, shown[i], EGL_SIGNALED);
  }
  producer.join();
}

// Images made, used and destroyed in several threads at once.
TEST_F(ImageTest, ManyThreads) {
  const EGLImage shared = image_of_texture(texture(kRed));
  std::vector<std::thread> threads;
  for (int t = 0; t < 3; ++t) {
    threads.emplace_back([&] {
      const EGLContext ctx = context();
      ASSERT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, ctx));
      for (int i = 0; i < 30; ++i) {
        const GLuint source = texture(kBlue);
        const EGLImage own = image_of_texture(source);
        const GLuint target = target_texture(own);
        EXPECT_TRUE(eglDestroyImage(display, own));
        framebuffer_of_texture(target);
        clear(kGreen);
        EXPECT_EQ(pixel(), kGreen);
        const GLuint other = target_texture(shared);
        const GLuint names[] = {source, target, other};
        glDeleteTextures(3, names);
      }
      eglReleaseThread();
    });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace clearpipe::icd
