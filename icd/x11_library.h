// The libraries of X11, opened when the first display asks for them: a machine without them runs
// everything else.
// SPDX-License-Identifier: MIT
#pragma once

#include <xcb/present.h>
#include <xcb/shm.h>
#include <xcb/xcb.h>
#include <xcb/xcbext.h>

namespace clearpipe::icd {

// libxcb, without xcb_ before the names.
#define XCB_FUNCTIONS(FUNCTION)            \
  FUNCTION(connect)                        \
  FUNCTION(disconnect)                     \
  FUNCTION(connection_has_error)           \
  FUNCTION(get_setup)                      \
  FUNCTION(setup_roots_iterator)           \
  FUNCTION(setup_pixmap_formats)           \
  FUNCTION(setup_pixmap_formats_length)    \
  FUNCTION(screen_next)                    \
  FUNCTION(screen_allowed_depths_iterator) \
  FUNCTION(depth_next)                     \
  FUNCTION(depth_visuals)                  \
  FUNCTION(depth_visuals_length)           \
  FUNCTION(get_geometry)                   \
  FUNCTION(get_geometry_reply)             \
  FUNCTION(get_window_attributes)          \
  FUNCTION(get_window_attributes_reply)    \
  FUNCTION(get_extension_data)             \
  FUNCTION(get_maximum_request_length)     \
  FUNCTION(generate_id)                    \
  FUNCTION(create_gc_checked)              \
  FUNCTION(free_gc)                        \
  FUNCTION(put_image_checked)              \
  FUNCTION(get_image)                      \
  FUNCTION(get_image_reply)                \
  FUNCTION(get_image_data)                 \
  FUNCTION(get_image_data_length)          \
  FUNCTION(flush)                          \
  FUNCTION(request_check)                  \
  FUNCTION(discard_reply)                  \
  FUNCTION(register_for_special_xge)       \
  FUNCTION(unregister_for_special_event)   \
  FUNCTION(poll_for_special_event)

// libxcb-shm and libxcb-present: without them pixels take the way through the socket, and frames
// are not waited for.
#define XCB_SHM_FUNCTIONS(FUNCTION) \
  FUNCTION(query_version)           \
  FUNCTION(query_version_reply)     \
  FUNCTION(attach_checked)          \
  FUNCTION(detach)                  \
  FUNCTION(put_image_checked)
#define XCB_PRESENT_FUNCTIONS(FUNCTION) \
  FUNCTION(query_version)               \
  FUNCTION(query_version_reply)         \
  FUNCTION(select_input_checked)        \
  FUNCTION(notify_msc_checked)

struct X11Library {
#define FUNCTION(name) decltype(&xcb_##name) name = nullptr;
  XCB_FUNCTIONS(FUNCTION)
#undef FUNCTION
  struct {
    xcb_extension_t* id = nullptr;  // null: there is no such library
#define FUNCTION(name) decltype(&xcb_shm_##name) name = nullptr;
    XCB_SHM_FUNCTIONS(FUNCTION)
#undef FUNCTION
  } shm;
  struct {
    xcb_extension_t* id = nullptr;
#define FUNCTION(name) decltype(&xcb_present_##name) name = nullptr;
    XCB_PRESENT_FUNCTIONS(FUNCTION)
#undef FUNCTION
  } present;
};

// Null where there is no libxcb.
const X11Library* x11_library();

// The connection under an Xlib Display, null without libX11-xcb; and its default screen.
xcb_connection_t* connection_of_xlib(void* display);
int default_screen_of_xlib(void* display);

// Whether the pointer is to a Display of Xlib.
bool is_xlib_display(void* pointer);

}  // namespace clearpipe::icd
