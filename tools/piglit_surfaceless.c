// SPDX-License-Identifier: MIT
//
// To be preloaded into piglit's programs. Debian's piglit has an empty event loop for the platform
// surfaceless_egl: a program that draws never comes to its drawing there, and aborts on every
// implementation. Its loop for the platform gbm draws once and reports, which is what a test needs,
// but gbm wants a graphics device. This library lets piglit take its gbm loop and opens a
// surfaceless EGL display below it, by changing the one platform attribute that piglit hands to
// Waffle. Nothing else is touched.

#define _GNU_SOURCE
#define WAFFLE_API_VERSION 0x0106
#include <dlfcn.h>
#include <stddef.h>
#include <waffle.h>

enum { kMostAttributes = 32 };

bool waffle_init(const int32_t* attrib_list) {
  bool (*next)(const int32_t*) = NULL;
  *(void**)&next = dlsym(RTLD_NEXT, "waffle_init");
  if (!next || !attrib_list) return false;

  int32_t attributes[kMostAttributes + 1];
  int count = 0;
  while (attrib_list[count] != 0 && count + 2 <= kMostAttributes) {
    const int32_t name = attrib_list[count], value = attrib_list[count + 1];
    const bool gbm = name == WAFFLE_PLATFORM && value == WAFFLE_PLATFORM_GBM;
    attributes[count++] = name;
    attributes[count++] = gbm ? WAFFLE_PLATFORM_SURFACELESS_EGL : value;
  }
  attributes[count] = 0;
  return next(attributes);
}
