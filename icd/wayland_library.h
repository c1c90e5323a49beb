// libwayland-client, opened when the first display asks for it.
//
// The protocol's header has requests as inline functions, which need the library when a program is
// linked. Here requests are made by wl_proxy_marshal_flags and the numbers of that header.
// SPDX-License-Identifier: MIT
#pragma once

#include <wayland-client-core.h>
#include <wayland-client-protocol.h>

namespace clearpipe::icd {

// Without wl_ before the names.
#define WAYLAND_FUNCTIONS(FUNCTION)        \
  FUNCTION(display_connect)                \
  FUNCTION(display_disconnect)             \
  FUNCTION(display_create_queue)           \
  FUNCTION(display_dispatch_queue_pending) \
  FUNCTION(display_prepare_read_queue)     \
  FUNCTION(display_cancel_read)            \
  FUNCTION(display_read_events)            \
  FUNCTION(display_flush)                  \
  FUNCTION(display_get_fd)                 \
  FUNCTION(display_get_error)              \
  FUNCTION(display_roundtrip_queue)        \
  FUNCTION(event_queue_destroy)            \
  FUNCTION(proxy_marshal_flags)            \
  FUNCTION(proxy_create_wrapper)           \
  FUNCTION(proxy_wrapper_destroy)          \
  FUNCTION(proxy_set_queue)                \
  FUNCTION(proxy_add_listener)             \
  FUNCTION(proxy_destroy)                  \
  FUNCTION(proxy_get_version)
#define WAYLAND_INTERFACES(INTERFACE) \
  INTERFACE(display)                  \
  INTERFACE(registry)                 \
  INTERFACE(shm)                      \
  INTERFACE(shm_pool)                 \
  INTERFACE(buffer)                   \
  INTERFACE(callback)

struct WaylandLibrary {
#define FUNCTION(name) decltype(&wl_##name) name = nullptr;
  WAYLAND_FUNCTIONS(FUNCTION)
#undef FUNCTION
#define INTERFACE(name) const wl_interface* name##_interface = nullptr;
  WAYLAND_INTERFACES(INTERFACE)
#undef INTERFACE

  // A request without a new object, and one that makes an object of the interface and version.
  template <class... Arguments>
  void request(void* object, uint32_t opcode, Arguments... arguments) const {
    auto* proxy = static_cast<wl_proxy*>(object);
    proxy_marshal_flags(proxy, opcode, nullptr, proxy_get_version(proxy), 0, arguments...);
  }
  template <class Object, class... Arguments>
  Object* create(void* object, uint32_t opcode, const wl_interface* interface, uint32_t version,
                 Arguments... arguments) const {
    return reinterpret_cast<Object*>(proxy_marshal_flags(static_cast<wl_proxy*>(object), opcode,
                                                         interface, version, 0, arguments...));
  }
  // A request after which the object is gone.
  void destroy(void* object, uint32_t opcode) const {
    auto* proxy = static_cast<wl_proxy*>(object);
    proxy_marshal_flags(proxy, opcode, nullptr, proxy_get_version(proxy), WL_MARSHAL_FLAG_DESTROY);
  }
};

// Null where there is no such library, or one older than 1.20.
const WaylandLibrary* wayland_library();

// Whether the pointer is to a wl_display.
bool is_wayland_display(void* pointer);

}  // namespace clearpipe::icd
