// Configs: their attributes, selection and order (3.4).
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "icd/egl_test.h"

namespace clearpipe::icd {
namespace {

class ConfigTest : public EglTest {
 protected:
  EGLint attrib(EGLConfig of, EGLint attribute) {
    EGLint value = -12345;
    EXPECT_EGL_OK(eglGetConfigAttrib(display, of, attribute, &value));
    return value;
  }
  std::vector<EGLConfig> all() {
    EGLint count = 0;
    EXPECT_EGL_OK(eglGetConfigs(display, nullptr, 0, &count));
    std::vector<EGLConfig> list(static_cast<size_t>(count));
    EXPECT_EGL_OK(eglGetConfigs(display, list.data(), count, &count));
    EXPECT_EQ(static_cast<size_t>(count), list.size());
    return list;
  }
  // The configs that match, in the order in which they come.
  std::vector<EGLConfig> chosen(std::vector<EGLint> attributes) {
    if (std::find(attributes.begin(), attributes.end(), EGL_SURFACE_TYPE) == attributes.end()) {
      attributes.insert(attributes.end(), {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT});
    }
    attributes.push_back(EGL_NONE);
    std::array<EGLConfig, 64> list{};
    EGLint count = -1;
    EXPECT_EGL_OK(eglChooseConfig(display, attributes.data(), list.data(), 64, &count));
    return std::vector<EGLConfig>(list.begin(), list.begin() + std::max(count, 0));
  }
  void expect_bad(EGLint attribute, EGLint value) {
    const EGLint list[] = {attribute, value, EGL_NONE};
    EGLConfig found = nullptr;
    EGLint count = 77;
    EXPECT_EGL_FAIL(eglChooseConfig(display, list, &found, 1, &count), EGL_FALSE,
                    EGL_BAD_ATTRIBUTE);
    EXPECT_EQ(count, 77) << std::hex << attribute << " " << value;
  }
};

// Every attribute of table 3.1 can be read, and what the text under it demands holds.
TEST_F(ConfigTest, EveryConfigIsConsistent) {
  EGLint id = 0;
  for (const EGLConfig c : all()) {
    EXPECT_EQ(attrib(c, EGL_CONFIG_ID), ++id);
    EXPECT_EQ(attrib(c, EGL_COLOR_BUFFER_TYPE), EGL_RGB_BUFFER);
    EXPECT_EQ(attrib(c, EGL_LUMINANCE_SIZE), 0);
    EXPECT_EQ(attrib(c, EGL_BUFFER_SIZE), attrib(c, EGL_RED_SIZE) + attrib(c, EGL_GREEN_SIZE) +
                                              attrib(c, EGL_BLUE_SIZE) + attrib(c, EGL_ALPHA_SIZE));
    EXPECT_TRUE(attrib(c, EGL_SURFACE_TYPE) & EGL_PBUFFER_BIT);
    EXPECT_LE(attrib(c, EGL_DEPTH_SIZE) + attrib(c, EGL_STENCIL_SIZE), 32);
    EXPECT_EQ(attrib(c, EGL_RENDERABLE_TYPE), EGL_OPENGL_ES_BIT);
    EXPECT_EQ(attrib(c, EGL_CONFORMANT) & ~attrib(c, EGL_RENDERABLE_TYPE), 0);
    EXPECT_EQ(attrib(c, EGL_SAMPLES), attrib(c, EGL_SAMPLE_BUFFERS) == 0 ? 0 : 4);
    EXPECT_EQ(attrib(c, EGL_BIND_TO_TEXTURE_RGB), EGL_TRUE);
    EXPECT_EQ(attrib(c, EGL_BIND_TO_TEXTURE_RGBA), attrib(c, EGL_ALPHA_SIZE) > 0);
    EXPECT_LE(attrib(c, EGL_MIN_SWAP_INTERVAL), attrib(c, EGL_MAX_SWAP_INTERVAL));
    EXPECT_GE(attrib(c, EGL_MAX_PBUFFER_WIDTH), 4096);
    EXPECT_GE(attrib(c, EGL_MAX_PBUFFER_HEIGHT), 4096);
    EXPECT_GE(attrib(c, EGL_MAX_PBUFFER_PIXELS), 4096 * 4096);
    for (const EGLint attribute :
         {EGL_ALPHA_MASK_SIZE, EGL_CONFIG_CAVEAT, EGL_DEPTH_SIZE, EGL_LEVEL, EGL_NATIVE_RENDERABLE,
          EGL_NATIVE_VISUAL_ID, EGL_NATIVE_VISUAL_TYPE, EGL_STENCIL_SIZE, EGL_TRANSPARENT_TYPE,
          EGL_TRANSPARENT_RED_VALUE, EGL_TRANSPARENT_GREEN_VALUE, EGL_TRANSPARENT_BLUE_VALUE}) {
      attrib(c, attribute);
    }
  }
  EXPECT_GE(id, 8);
}

TEST_F(ConfigTest, GetConfigsFillsNoMoreThanThereIsRoomFor) {
  const auto list = all();
  EGLConfig two[3] = {nullptr, nullptr, random_handle()};
  const EGLConfig guard = two[2];
  EGLint count = 0;
  EXPECT_EGL_OK(eglGetConfigs(display, two, 2, &count));
  EXPECT_EQ(count, 2);
  EXPECT_EQ(two[0], list[0]);
  EXPECT_EQ(two[1], list[1]);
  EXPECT_EQ(two[2], guard);
  EXPECT_EGL_OK(eglGetConfigs(display, two, 0, &count));
  EXPECT_EQ(count, 0);
  EXPECT_EGL_FAIL(eglGetConfigs(display, two, 2, nullptr), EGL_FALSE, EGL_BAD_PARAMETER);
  EXPECT_EGL_FAIL(eglChooseConfig(display, nullptr, two, 2, nullptr), EGL_FALSE, EGL_BAD_PARAMETER);
  EXPECT_EGL_OK(eglChooseConfig(display, nullptr, nullptr, 0, &count));
}

TEST_F(ConfigTest, GetConfigAttribErrors) {
  EGLint value = 77;
  EXPECT_EGL_FAIL(eglGetConfigAttrib(display, random_handle(), EGL_RED_SIZE, &value), EGL_FALSE,
                  EGL_BAD_CONFIG);
  EXPECT_EGL_FAIL(eglGetConfigAttrib(display, nullptr, EGL_RED_SIZE, &value), EGL_FALSE,
                  EGL_BAD_CONFIG);
  EXPECT_EGL_FAIL(eglGetConfigAttrib(display, config, EGL_WIDTH, &value), EGL_FALSE,
                  EGL_BAD_ATTRIBUTE);
  EXPECT_EGL_FAIL(eglGetConfigAttrib(display, config, EGL_MATCH_NATIVE_PIXMAP, &value), EGL_FALSE,
                  EGL_BAD_ATTRIBUTE);
  EXPECT_EGL_FAIL(eglGetConfigAttrib(display, config, EGL_RED_SIZE, nullptr), EGL_FALSE,
                  EGL_BAD_PARAMETER);
  EXPECT_EQ(value, 77);
}

// Table 3.4: at least, exactly, mask.
TEST_F(ConfigTest, Selection) {
  EXPECT_EQ(chosen({}).size(), all().size());
  for (const EGLConfig c : chosen({EGL_ALPHA_SIZE, 1})) EXPECT_GE(attrib(c, EGL_ALPHA_SIZE), 1);
  for (const EGLConfig c : chosen({EGL_ALPHA_SIZE, 5})) EXPECT_EQ(attrib(c, EGL_ALPHA_SIZE), 8);
  for (const EGLConfig c : chosen({EGL_DEPTH_SIZE, 16})) EXPECT_GE(attrib(c, EGL_DEPTH_SIZE), 16);
  for (const EGLConfig c : chosen({EGL_DEPTH_SIZE, 17, EGL_STENCIL_SIZE, 1})) {
    EXPECT_EQ(attrib(c, EGL_DEPTH_SIZE), 24);
  }
  for (const EGLConfig c : chosen({EGL_STENCIL_SIZE, 1})) EXPECT_EQ(attrib(c, EGL_STENCIL_SIZE), 8);
  EXPECT_FALSE(chosen({EGL_ALPHA_SIZE, 1}).empty());
  EXPECT_TRUE(chosen({EGL_RED_SIZE, 9}).empty());
  EXPECT_TRUE(chosen({EGL_DEPTH_SIZE, 33}).empty());
  EXPECT_TRUE(chosen({EGL_DEPTH_SIZE, 25, EGL_STENCIL_SIZE, 1}).empty());
  for (const EGLint attribute : {EGL_SAMPLES, EGL_SAMPLE_BUFFERS}) {
    const auto multisampled = chosen({attribute, 1});
    EXPECT_EQ(multisampled.size() * 2, all().size());
    for (const EGLConfig c : multisampled) EXPECT_EQ(attrib(c, EGL_SAMPLES), 4);
  }
  EXPECT_TRUE(chosen({EGL_SAMPLES, 5}).empty());
  EXPECT_TRUE(chosen({EGL_LEVEL, 1}).empty());
  EXPECT_TRUE(chosen({EGL_COLOR_BUFFER_TYPE, EGL_LUMINANCE_BUFFER}).empty());
  EXPECT_TRUE(chosen({EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT | EGL_OPENGL_ES2_BIT}).empty());
  EXPECT_TRUE(chosen({EGL_SURFACE_TYPE, EGL_WINDOW_BIT}).empty());
  EXPECT_EQ(chosen({EGL_SURFACE_TYPE, 0}).size(), all().size());
  EXPECT_EQ(chosen({EGL_RENDERABLE_TYPE, 0}).size(), all().size());
  EXPECT_EQ(chosen({EGL_CONFIG_CAVEAT, EGL_NONE}).size(), all().size());
  EXPECT_TRUE(chosen({EGL_CONFIG_CAVEAT, EGL_SLOW_CONFIG}).empty());
  EXPECT_TRUE(chosen({EGL_TRANSPARENT_TYPE, EGL_TRANSPARENT_RGB}).empty());
  EXPECT_EQ(chosen({EGL_MATCH_NATIVE_PIXMAP, EGL_NONE}).size(), all().size());
}

// Every size of colour with every size of depth and stencil, with and without samples, once.
TEST_F(ConfigTest, AllSizes) {
  std::set<std::array<EGLint, 7>> expected, found;
  for (const auto& [r, g, b, a] : std::vector<std::array<EGLint, 4>>{
           {8, 8, 8, 8}, {8, 8, 8, 0}, {5, 6, 5, 0}, {5, 5, 5, 1}, {4, 4, 4, 4}}) {
    for (const auto& [depth, stencil] :
         std::vector<std::array<EGLint, 2>>{{0, 0}, {16, 0}, {24, 0}, {32, 0}, {0, 8}, {24, 8}}) {
      for (const EGLint samples : {0, 4}) expected.insert({r, g, b, a, depth, stencil, samples});
    }
  }
  for (const EGLConfig c : all()) {
    const bool is_new =
        found
            .insert({attrib(c, EGL_RED_SIZE), attrib(c, EGL_GREEN_SIZE), attrib(c, EGL_BLUE_SIZE),
                     attrib(c, EGL_ALPHA_SIZE), attrib(c, EGL_DEPTH_SIZE),
                     attrib(c, EGL_STENCIL_SIZE), attrib(c, EGL_SAMPLES)})
            .second;
    EXPECT_TRUE(is_new);
  }
  EXPECT_EQ(found, expected);
  // Who asks for at least 5, 6, 5 gets more if there is more; who asks for 16 bits in all, those.
  EXPECT_EQ(
      attrib(chosen({EGL_RED_SIZE, 5, EGL_GREEN_SIZE, 6, EGL_BLUE_SIZE, 5})[0], EGL_BUFFER_SIZE),
      24);
  EXPECT_EQ(attrib(chosen({EGL_BUFFER_SIZE, 16})[0], EGL_GREEN_SIZE), 6);
  EXPECT_EQ(attrib(chosen({EGL_DEPTH_SIZE, 1})[0], EGL_DEPTH_SIZE), 16);
}

TEST_F(ConfigTest, ANullListAsksForWindows) {
  const EGLint none[] = {EGL_NONE};
  for (const EGLint* list : {static_cast<const EGLint*>(nullptr), none}) {
    EGLint count = -1;
    EGLConfig found = nullptr;
    EXPECT_EGL_OK(eglChooseConfig(display, list, &found, 1, &count));
    EXPECT_EQ(count, 0);  // EGL_WINDOW_BIT is the default, and this display has no windows
  }
}

// 3.4.1.1: EGL_CONFIG_ID overrides all others; some attributes are ignored.
TEST_F(ConfigTest, ConfigIdAndIgnoredAttributes) {
  for (const EGLConfig c : all()) {
    const auto found = chosen({EGL_RED_SIZE, 32, EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_CONFIG_ID,
                               attrib(c, EGL_CONFIG_ID)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0], c);
  }
  EXPECT_TRUE(chosen({EGL_CONFIG_ID, 9999}).empty());
  EXPECT_EQ(chosen({EGL_CONFIG_ID, EGL_DONT_CARE}).size(), all().size());
  EXPECT_EQ(chosen({EGL_MAX_PBUFFER_WIDTH, 1 << 30, EGL_MAX_PBUFFER_HEIGHT, 3,
                    EGL_MAX_PBUFFER_PIXELS, 5, EGL_NATIVE_VISUAL_ID, 7})
                .size(),
            all().size());
  EXPECT_EQ(chosen({EGL_NATIVE_VISUAL_TYPE, 7}).size(), all().size());
  EXPECT_EQ(chosen({EGL_TRANSPARENT_RED_VALUE, 7, EGL_TRANSPARENT_GREEN_VALUE, 7,
                    EGL_TRANSPARENT_BLUE_VALUE, 7})
                .size(),
            all().size());
}

TEST_F(ConfigTest, DontCareMatchesEverything) {
  for (const EGLint attribute : {EGL_BUFFER_SIZE,          EGL_RED_SIZE,
                                 EGL_GREEN_SIZE,           EGL_BLUE_SIZE,
                                 EGL_LUMINANCE_SIZE,       EGL_ALPHA_SIZE,
                                 EGL_ALPHA_MASK_SIZE,      EGL_BIND_TO_TEXTURE_RGB,
                                 EGL_BIND_TO_TEXTURE_RGBA, EGL_COLOR_BUFFER_TYPE,
                                 EGL_CONFIG_CAVEAT,        EGL_CONFORMANT,
                                 EGL_DEPTH_SIZE,           EGL_MAX_SWAP_INTERVAL,
                                 EGL_MIN_SWAP_INTERVAL,    EGL_NATIVE_RENDERABLE,
                                 EGL_NATIVE_VISUAL_TYPE,   EGL_RENDERABLE_TYPE,
                                 EGL_SAMPLE_BUFFERS,       EGL_SAMPLES,
                                 EGL_STENCIL_SIZE,         EGL_SURFACE_TYPE,
                                 EGL_TRANSPARENT_TYPE,     EGL_TRANSPARENT_RED_VALUE}) {
    EXPECT_EQ(chosen({attribute, EGL_DONT_CARE}).size(), all().size()) << std::hex << attribute;
  }
  expect_bad(EGL_LEVEL, EGL_DONT_CARE);
  expect_bad(EGL_MATCH_NATIVE_PIXMAP, EGL_DONT_CARE);
}

TEST_F(ConfigTest, UnrecognizedAttributesAndValues) {
  expect_bad(EGL_WIDTH, 1);
  expect_bad(0x7fff, 1);
  expect_bad(EGL_COLOR_BUFFER_TYPE, 0);
  expect_bad(EGL_CONFIG_CAVEAT, EGL_TRUE);
  expect_bad(EGL_TRANSPARENT_TYPE, EGL_RGB_BUFFER);
  expect_bad(EGL_BIND_TO_TEXTURE_RGB, 2);
  expect_bad(EGL_NATIVE_RENDERABLE, 2);
  expect_bad(EGL_SURFACE_TYPE, 1 << 20);
  expect_bad(EGL_RENDERABLE_TYPE, 1 << 20);
  expect_bad(EGL_CONFORMANT, 1 << 20);
  expect_bad(EGL_CONFIG_ID, 0);
  expect_bad(EGL_RED_SIZE, -2);
  expect_bad(EGL_DEPTH_SIZE, -2);
  expect_bad(EGL_SAMPLE_BUFFERS, 2);
  expect_bad(EGL_MATCH_NATIVE_PIXMAP, 1234);
}

// 3.4.1.2, computed here from the text for every combination of requested sizes.
TEST_F(ConfigTest, Sorting) {
  const auto key = [&](EGLConfig c, const std::vector<EGLint>& request) {
    EGLint bits = 0;
    for (const EGLint a : {EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE, EGL_ALPHA_SIZE}) {
      for (size_t i = 0; i < request.size(); i += 2) {
        if (request[i] == a && request[i + 1] > 0) bits += attrib(c, a);
      }
    }
    return std::array<EGLint, 7>{-bits,
                                 attrib(c, EGL_BUFFER_SIZE),
                                 attrib(c, EGL_SAMPLE_BUFFERS),
                                 attrib(c, EGL_SAMPLES),
                                 attrib(c, EGL_DEPTH_SIZE),
                                 attrib(c, EGL_STENCIL_SIZE),
                                 attrib(c, EGL_CONFIG_ID)};
  };
  for (const EGLint red : {EGL_DONT_CARE, 0, 1, 5, 8}) {
    for (const EGLint alpha : {EGL_DONT_CARE, 0, 1, 4, 8}) {
      for (const EGLint depth : {0, 1, 24, 32, -4}) {
        std::vector<EGLint> request = {EGL_RED_SIZE,   red,  EGL_ALPHA_SIZE, alpha,
                                       EGL_DEPTH_SIZE, depth};
        if (depth < 0) request = {EGL_RED_SIZE, red, EGL_ALPHA_SIZE, alpha, EGL_SAMPLES, -depth};
        const auto list = chosen(request);
        EXPECT_GE(list.size(), 2u);
        for (size_t i = 1; i < list.size(); ++i) {
          EXPECT_LT(key(list[i - 1], request), key(list[i], request));
        }
      }
    }
  }
  // In words: without asking for alpha the smaller buffer comes first, with alpha the deeper.
  EXPECT_EQ(attrib(chosen({})[0], EGL_ALPHA_SIZE), 0);
  EXPECT_EQ(attrib(chosen({EGL_RED_SIZE, 1, EGL_ALPHA_SIZE, 0})[0], EGL_ALPHA_SIZE), 0);
  EXPECT_EQ(attrib(chosen({EGL_ALPHA_SIZE, 1})[0], EGL_ALPHA_SIZE), 8);
  EXPECT_EQ(attrib(chosen({})[0], EGL_DEPTH_SIZE), 0);
  EXPECT_EQ(attrib(chosen({})[0], EGL_STENCIL_SIZE), 0);
  EXPECT_EQ(attrib(chosen({})[0], EGL_SAMPLES), 0);
  EXPECT_EQ(attrib(chosen({EGL_DEPTH_SIZE, 24, EGL_STENCIL_SIZE, 8})[0], EGL_SAMPLES), 0);
}

}  // namespace
}  // namespace clearpipe::icd
