// EGL commands on images (3.9), and the forms that EGL_KHR_image_base has of them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <memory>
#include <new>
#include <optional>

#include "icd/entry.h"
#include "icd/pixmap_image.h"

namespace clearpipe::icd::entry {

namespace {

bool has_pixmaps(const Display& display) {
  return std::any_of(display.configs.begin(), display.configs.end(), [](const Config& config) {
    return (config.native_surfaces & EGL_PIXMAP_BIT) != 0;
  });
}

std::optional<api::ImageSource> source_of(EGLenum target) {  // table 3.10
  switch (target) {
    case EGL_GL_TEXTURE_2D:
      return api::ImageSource::kTexture2D;
    case EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_X:
      return api::ImageSource::kCubePositiveX;
    case EGL_GL_TEXTURE_CUBE_MAP_NEGATIVE_X:
      return api::ImageSource::kCubeNegativeX;
    case EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_Y:
      return api::ImageSource::kCubePositiveY;
    case EGL_GL_TEXTURE_CUBE_MAP_NEGATIVE_Y:
      return api::ImageSource::kCubeNegativeY;
    case EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_Z:
      return api::ImageSource::kCubePositiveZ;
    case EGL_GL_TEXTURE_CUBE_MAP_NEGATIVE_Z:
      return api::ImageSource::kCubeNegativeZ;
    case EGL_GL_RENDERBUFFER:
      return api::ImageSource::kRenderbuffer;
    default:
      return std::nullopt;
  }
}

// Table 3.11. An attribute that does not concern the target is ignored. Pixels are always
// preserved.
template <class Attribute>
EGLint parse_attributes(const Attribute* list, int& level) {
  for (; list != nullptr && *list != EGL_NONE; list += 2) {
    switch (list[0]) {
      case EGL_GL_TEXTURE_LEVEL:
        if (list[1] < 0 || list[1] > std::numeric_limits<int>::max()) return EGL_BAD_MATCH;
        level = static_cast<int>(list[1]);
        break;
      case EGL_IMAGE_PRESERVED:
        if (list[1] != EGL_FALSE && list[1] != EGL_TRUE) return EGL_BAD_PARAMETER;
        break;
      case EGL_GL_TEXTURE_ZOFFSET:
        break;
      default:
        return EGL_BAD_PARAMETER;
    }
  }
  return EGL_SUCCESS;
}

EGLint egl_error(api::ImageError error) {
  switch (error) {
    case api::ImageError::kNone:
      return EGL_SUCCESS;
    case api::ImageError::kBadParameter:
      return EGL_BAD_PARAMETER;
    case api::ImageError::kBadMatch:
      return EGL_BAD_MATCH;
    case api::ImageError::kBadAccess:
      return EGL_BAD_ACCESS;
    case api::ImageError::kBadAlloc:
      break;
  }
  return EGL_BAD_ALLOC;
}

// An image of a native pixmap (EGL_KHR_image_pixmap); attributes other than EGL_IMAGE_PRESERVED are
// ignored.
template <class Attribute>
EGLImage create_pixmap_image(Display& display, EGLClientBuffer pixmap, const Attribute* list) {
  for (; list != nullptr && *list != EGL_NONE; list += 2) {
    if (list[0] == EGL_IMAGE_PRESERVED && list[1] != EGL_FALSE && list[1] != EGL_TRUE) {
      return fail(EGL_BAD_PARAMETER, EGL_NO_IMAGE);
    }
  }
  std::shared_ptr<NativeSurface> native;
  if (display.platform->make_pixmap(Config(), pixmap, false, native) != EGL_SUCCESS) {
    return fail(EGL_BAD_PARAMETER, EGL_NO_IMAGE);
  }
  const std::optional<Size> size = native->size();
  if (!size) return fail(EGL_BAD_PARAMETER, EGL_NO_IMAGE);
  std::erase_if(display.image_pixmaps, [](const auto& old) { return old.expired(); });
  display.image_pixmaps.push_back(native);
  auto image = std::make_unique<Image>(Object::next_handle());
  display.images.reserve(display.images.size() + 1);
  const api::ImageError error =
      api::create_egl_image(make_pixmap_image(std::move(native), *size), image->handle);
  if (error != api::ImageError::kNone) return fail(egl_error(error), EGL_NO_IMAGE);
  display.images.push_back(std::move(image));
  return succeed<EGLImage>(display.images.back()->handle);
}

template <class Attribute>
EGLImage create_image(EGLDisplay dpy, EGLContext ctx, EGLenum target, EGLClientBuffer buffer,
                      const Attribute* attrib_list) noexcept try {
  finish_current(this_thread());
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_NO_IMAGE;
  const Context* context = find_context(ctx);
  if (ctx != EGL_NO_CONTEXT && context == nullptr) return fail(EGL_BAD_CONTEXT, EGL_NO_IMAGE);
  if (target == EGL_NATIVE_PIXMAP_KHR && has_pixmaps(*display)) {
    if (ctx != EGL_NO_CONTEXT) return fail(EGL_BAD_PARAMETER, EGL_NO_IMAGE);
    return create_pixmap_image(*display, buffer, attrib_list);
  }
  const std::optional<api::ImageSource> source = source_of(target);
  if (!source) return fail(EGL_BAD_PARAMETER, EGL_NO_IMAGE);
  if (context == nullptr) return fail(EGL_BAD_CONTEXT, EGL_NO_IMAGE);
  if (display->context(ctx) != context) return fail(EGL_BAD_MATCH, EGL_NO_IMAGE);
  int level = 0;
  if (const EGLint error = parse_attributes(attrib_list, level); error != EGL_SUCCESS) {
    return fail(error, EGL_NO_IMAGE);
  }
  const auto name = reinterpret_cast<uintptr_t>(buffer);
  if (name == 0 || name > std::numeric_limits<unsigned>::max()) {
    return fail(EGL_BAD_PARAMETER, EGL_NO_IMAGE);
  }
  auto image = std::make_unique<Image>(Object::next_handle());
  display->images.reserve(display->images.size() + 1);
  const api::ImageError error = api::create_egl_image(
      context->context, *source, static_cast<unsigned>(name), level, image->handle);
  if (error != api::ImageError::kNone) return fail(egl_error(error), EGL_NO_IMAGE);
  display->images.push_back(std::move(image));
  return succeed<EGLImage>(display->images.back()->handle);
} catch (const std::bad_alloc&) {
  return fail(EGL_BAD_ALLOC, EGL_NO_IMAGE);
}

}  // namespace

EGLImage CreateImage(EGLDisplay dpy, EGLContext ctx, EGLenum target, EGLClientBuffer buffer,
                     const EGLAttrib* attrib_list) noexcept {
  return create_image(dpy, ctx, target, buffer, attrib_list);
}

EGLImageKHR CreateImageKHR(EGLDisplay dpy, EGLContext ctx, EGLenum target, EGLClientBuffer buffer,
                           const EGLint* attrib_list) noexcept {
  return create_image(dpy, ctx, target, buffer, attrib_list);
}

EGLBoolean DestroyImage(EGLDisplay dpy, EGLImage handle) noexcept {
  const std::lock_guard<std::mutex> lock(egl_mutex());
  Display* display = initialized_display(dpy);
  if (display == nullptr) return EGL_FALSE;
  const size_t erased =
      std::erase_if(display->images, [&](const auto& image) { return image->handle == handle; });
  display->labels.erase(handle);
  return erased == 0 ? fail(EGL_BAD_PARAMETER, EGL_FALSE) : succeed(EGL_TRUE);
}

EGLBoolean DestroyImageKHR(EGLDisplay dpy, EGLImageKHR image) noexcept {
  return DestroyImage(dpy, image);
}

}  // namespace clearpipe::icd::entry
