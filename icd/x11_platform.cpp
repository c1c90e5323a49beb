// X11: connections, visuals and configs. See x11_platform.h.
// SPDX-License-Identifier: MIT
#include "icd/x11_platform.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "icd/x11_drawable.h"

namespace clearpipe::icd {

namespace {

// What libxcb allocates.
template <class Reply>
std::unique_ptr<Reply, decltype(&std::free)> owned(Reply* reply) {
  return {reply, &std::free};
}

Component component_of(uint32_t mask) {
  return mask == 0 ? Component() : Component{std::countr_zero(mask), std::popcount(mask)};
}

bool is_one_run(uint32_t mask) {
  return mask != 0 && std::popcount(mask) <= 16 &&
         mask >> std::countr_zero(mask) == (1u << std::popcount(mask)) - 1;
}

// Whether windows with the mask show components of so many bits, as well as there are any.
bool has_bits(uint32_t mask, EGLint bits) { return std::min(std::popcount(mask), 8) == bits; }

}  // namespace

X11Platform::X11Platform(const X11Library& library, xcb_connection_t* c, bool own, int screen)
    : x(library), connection(c), own_(own), screen_number_(screen) {
  if (!works()) return;
  const auto present_there = [this](xcb_extension_t* extension) {
    if (extension == nullptr) return false;
    const xcb_query_extension_reply_t* reply = x.get_extension_data(connection, extension);
    return reply != nullptr && reply->present != 0;
  };
  if (present_there(x.shm.id)) {
    has_shm_ = owned(x.shm.query_version_reply(connection, x.shm.query_version(connection),
                                               nullptr)) != nullptr;
  }
  if (present_there(x.present.id)) {
    has_present_ = owned(x.present.query_version_reply(
                       connection, x.present.query_version(connection, 1, 0), nullptr)) != nullptr;
  }
}

X11Platform::~X11Platform() {
  if (own_) x.disconnect(connection);
}

bool X11Platform::works() const {
  if (x.connection_has_error(connection) != 0) return false;
  const xcb_setup_t* setup = x.get_setup(connection);
  constexpr auto kOrder = std::endian::native == std::endian::little ? XCB_IMAGE_ORDER_LSB_FIRST
                                                                     : XCB_IMAGE_ORDER_MSB_FIRST;
  return setup != nullptr && setup->image_byte_order == kOrder && screen() != nullptr;
}

const xcb_screen_t* X11Platform::screen() const {
  xcb_screen_iterator_t i = x.setup_roots_iterator(x.get_setup(connection));
  for (int n = 0; i.rem > 0; ++n, x.screen_next(&i)) {
    if (n == screen_number_) return i.data;
  }
  return nullptr;
}

std::optional<PixelLayout> X11Platform::layout_of(uint8_t depth,
                                                  const xcb_visualtype_t* visual) const {
  const xcb_setup_t* setup = x.get_setup(connection);
  const xcb_format_t* formats = x.setup_pixmap_formats(setup);
  const int count = x.setup_pixmap_formats_length(setup);
  const auto* format = std::find_if(formats, formats + count,
                                    [depth](const xcb_format_t& f) { return f.depth == depth; });
  if (format == formats + count || (format->bits_per_pixel != 32 && format->bits_per_pixel != 16)) {
    return std::nullopt;
  }
  PixelLayout layout;
  layout.bytes = format->bits_per_pixel / 8;
  if (visual == nullptr) return std::nullopt;
  const uint32_t masks[] = {visual->red_mask, visual->green_mask, visual->blue_mask};
  uint32_t used = 0;
  for (size_t i = 0; i < 3; ++i) {
    if (!is_one_run(masks[i])) return std::nullopt;
    layout.rgba[i] = component_of(masks[i]);
    used |= masks[i];
  }
  // What a depth of 32 has beyond the colours is alpha.
  const uint32_t rest = ~used;
  if (depth == 32 && layout.bytes == 4 && is_one_run(rest)) layout.rgba[3] = component_of(rest);
  return layout;
}

const xcb_visualtype_t* X11Platform::find_visual(xcb_visualid_t id) const {
  for (auto d = x.screen_allowed_depths_iterator(screen()); d.rem > 0; x.depth_next(&d)) {
    const xcb_visualtype_t* visuals = x.depth_visuals(d.data);
    for (int i = 0; i < x.depth_visuals_length(d.data); ++i) {
      if (visuals[i].visual_id == id) return &visuals[i];
    }
  }
  return nullptr;
}

// The root window's own visual if it has the depth, else the first.
const xcb_visualtype_t* X11Platform::true_colour_visual(uint8_t depth) const {
  const xcb_visualtype_t* best = nullptr;
  for (auto d = x.screen_allowed_depths_iterator(screen()); d.rem > 0; x.depth_next(&d)) {
    if (d.data->depth != depth) continue;
    const xcb_visualtype_t* visuals = x.depth_visuals(d.data);
    for (int i = 0; i < x.depth_visuals_length(d.data); ++i) {
      if (visuals[i]._class != XCB_VISUAL_CLASS_TRUE_COLOR || !layout_of(depth, &visuals[i])) {
        continue;
      }
      if (best == nullptr || visuals[i].visual_id == screen()->root_visual) best = &visuals[i];
    }
  }
  return best;
}

// First the configs for opaque windows, those with alpha among them, because an application that
// asks for alpha seldom wants to be seen through; then those for the visual that has alpha. Colours
// of other sizes than the visual's are for pbuffers.
std::vector<Config> X11Platform::configs() {
  std::vector<Config> list;
  const auto add = [&list](const xcb_visualtype_t* visual, bool alpha_only) {
    if (visual == nullptr) return;
    for (Config config : offscreen_configs()) {
      const bool fits = has_bits(visual->red_mask, config.red) &&
                        has_bits(visual->green_mask, config.green) &&
                        has_bits(visual->blue_mask, config.blue);
      if (alpha_only && (config.alpha == 0 || !fits)) continue;
      if (!fits) {
        list.push_back(config);
        continue;
      }
      // What a pixmap holds is no contents for the samples of a multisample buffer.
      config.native_surfaces = EGL_WINDOW_BIT | (config.samples == 0 ? EGL_PIXMAP_BIT : 0);
      config.visual_id = static_cast<EGLint>(visual->visual_id);
      config.visual_type = visual->_class;
      list.push_back(config);
    }
  };
  const uint8_t root = screen()->root_depth;
  add(true_colour_visual(root == 32 ? 24 : root), false);
  if (list.empty()) add(true_colour_visual(24), false);
  add(true_colour_visual(32), true);
  return list.empty() ? offscreen_configs() : list;
}

std::optional<Size> X11Platform::size_of(xcb_drawable_t drawable, uint8_t* depth) const {
  const auto reply =
      owned(x.get_geometry_reply(connection, x.get_geometry(connection, drawable), nullptr));
  if (reply == nullptr) return std::nullopt;
  if (depth != nullptr) *depth = reply->depth;
  return Size{reply->width, reply->height};
}

EGLint X11Platform::make_window(const Config&, void* native, bool by_pointer,
                                std::shared_ptr<NativeSurface>& out) {
  if (native == nullptr) return EGL_BAD_NATIVE_WINDOW;
  // Both extensions of EGL 1.5 give a pointer to the identifier: an Xlib Window is a long, an
  // xcb_window_t is 32 bits, and X identifiers have 29.
  const auto id = by_pointer ? *static_cast<const xcb_window_t*>(native)
                             : static_cast<xcb_window_t>(reinterpret_cast<uintptr_t>(native));
  const auto attributes = owned(
      x.get_window_attributes_reply(connection, x.get_window_attributes(connection, id), nullptr));
  uint8_t depth = 0;
  if (attributes == nullptr || attributes->_class != XCB_WINDOW_CLASS_INPUT_OUTPUT ||
      !size_of(id, &depth)) {
    return EGL_BAD_NATIVE_WINDOW;
  }
  const auto layout = layout_of(depth, find_visual(attributes->visual));
  if (!layout) return EGL_BAD_MATCH;
  return X11Drawable::make(shared_from_this(), id, {depth, *layout}, true, out)
             ? EGL_SUCCESS
             : EGL_BAD_NATIVE_WINDOW;
}

bool X11Platform::has_pixmap(uintptr_t pixmap) {
  uint8_t depth = 0;
  return size_of(static_cast<xcb_pixmap_t>(pixmap), &depth) &&
         layout_of(depth, true_colour_visual(depth));
}

// A pixmap has a depth, but no visual: it is drawn to as windows of that depth are.
EGLint X11Platform::make_pixmap(const Config&, void* native, bool by_pointer,
                                std::shared_ptr<NativeSurface>& out) {
  if (native == nullptr) return EGL_BAD_NATIVE_PIXMAP;
  const auto id = by_pointer ? *static_cast<const xcb_pixmap_t*>(native)
                             : static_cast<xcb_pixmap_t>(reinterpret_cast<uintptr_t>(native));
  uint8_t depth = 0;
  if (!size_of(id, &depth)) return EGL_BAD_NATIVE_PIXMAP;
  const auto layout = layout_of(depth, true_colour_visual(depth));
  if (!layout) return EGL_BAD_MATCH;
  return X11Drawable::make(shared_from_this(), id, {depth, *layout}, false, out)
             ? EGL_SUCCESS
             : EGL_BAD_NATIVE_PIXMAP;
}

std::shared_ptr<Platform> open_x11(void* xlib_display, xcb_connection_t* connection, int screen) {
  const X11Library* library = x11_library();
  if (library == nullptr) return nullptr;
  const bool own = xlib_display == nullptr && connection == nullptr;
  int preferred = 0;
  if (xlib_display != nullptr) {
    connection = connection_of_xlib(xlib_display);
    preferred = default_screen_of_xlib(xlib_display);
  } else if (own) {
    connection = library->connect(nullptr, &preferred);
  }
  if (connection == nullptr) return nullptr;
  auto platform =
      std::make_shared<X11Platform>(*library, connection, own, screen >= 0 ? screen : preferred);
  return platform->works() ? platform : nullptr;
}

}  // namespace clearpipe::icd
