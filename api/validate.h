// Validators: pure functions of the context and the arguments that return the error a call
// generates, or NO_ERROR. Each sees the arguments its executor gets (gles1.def).
// SPDX-License-Identifier: MIT
#pragma once

#include "api/context_state.h"
#include "api/params.h"

namespace clearpipe::api::validate {

template <typename... Arguments>
GLenum none(const Context&, const Arguments&...) {
  return GL_NO_ERROR;
}

// The buffer object bound to a target of buffer objects, or null.
inline const BufferPtr& bound_buffer(const Context& c, GLenum target) {
  return target == GL_ARRAY_BUFFER ? c.state.arrays.array_buffer
                                   : c.state.arrays.element_array_buffer;
}

// validate_state.cpp
GLenum hint(const Context&, GLenum target, GLenum mode);
GLenum enable(const Context&, GLenum cap, bool value);
GLenum is_enabled(const Context&, GLenum cap);
GLenum multi_tex_coord(const Context&, GLenum target, float, float, float, float);
GLenum texture_unit(const Context&, GLenum texture);
GLenum matrix_mode(const Context&, GLenum mode);
GLenum push_matrix(const Context&);
GLenum pop_matrix(const Context&);
GLenum frustum_planes(const Context&, float l, float r, float b, float t, float n, float f);
GLenum ortho_planes(const Context&, float l, float r, float b, float t, float n, float f);
GLenum rectangle(const Context&, GLint x, GLint y, GLsizei width, GLsizei height);
GLenum clip_plane(const Context&, GLenum plane, const Params&);
GLenum clip_plane(const Context&, GLenum plane, const Out&);
GLenum shade_model(const Context&, GLenum mode);
GLenum light_model(const Context&, GLenum pname, const Params&);
GLenum light(const Context&, GLenum light, GLenum pname, const Params&);
GLenum material(const Context&, GLenum face, GLenum pname, const Params&);
GLenum positive(const Context&, float value);
GLenum point_parameter(const Context&, GLenum pname, const Params&);
GLenum cull_face(const Context&, GLenum mode);
GLenum front_face(const Context&, GLenum mode);
// validate_fragment.cpp
GLenum fog(const Context&, GLenum pname, const Params&);
GLenum alpha_func(const Context&, GLenum func, float);
GLenum compare_func(const Context&, GLenum func);
GLenum stencil_func(const Context&, GLenum func, GLint, GLuint);
GLenum stencil_op(const Context&, GLenum fail, GLenum zfail, GLenum zpass);
GLenum blend_func(const Context&, GLenum src, GLenum dst);
GLenum blend_func_separate(const Context&, GLenum, GLenum, GLenum, GLenum);
GLenum blend_equation(const Context&, GLenum rgb, GLenum alpha);
GLenum logic_op(const Context&, GLenum opcode);
// validate_texture.cpp
GLenum pixel_store(const Context&, GLenum pname, GLint param);
GLenum texture_target(const Context&, GLenum target, GLuint);
GLenum names(const Context&, GLsizei n, const GLuint*);
GLenum tex_image(const Context&, GLenum target, GLint level, GLint internal, GLsizei width,
                 GLsizei height, GLint border, GLenum format, GLenum type, const void*);
GLenum tex_sub_image(const Context&, GLenum target, GLint level, GLint x, GLint y, GLsizei width,
                     GLsizei height, GLenum format, GLenum type, const void*);
GLenum copy_tex_image(const Context&, GLenum target, GLint level, GLenum internal, GLint x, GLint y,
                      GLsizei width, GLsizei height, GLint border);
GLenum copy_tex_sub_image(const Context&, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                          GLint x, GLint y, GLsizei width, GLsizei height);
GLenum compressed_tex_image(const Context&, GLenum target, GLint level, GLenum internal,
                            GLsizei width, GLsizei height, GLint border, GLsizei size, const void*);
GLenum compressed_tex_sub_image(const Context&, GLenum target, GLint level, GLint, GLint, GLsizei,
                                GLsizei, GLenum format, GLsizei size, const void*);
GLenum tex_parameter(const Context&, GLenum target, GLenum pname, const Params&);
GLenum tex_env(const Context&, GLenum target, GLenum pname, const Params&);
// validate_draw.cpp
GLenum client_state(const Context&, GLenum array, bool);
GLenum vertex_pointer(const Context&, GLint size, GLenum type, GLsizei stride, const void*);
GLenum color_pointer(const Context&, GLint size, GLenum type, GLsizei stride, const void*);
GLenum normal_pointer(const Context&, GLenum type, GLsizei stride, const void*);
GLenum point_size_pointer(const Context&, GLenum type, GLsizei stride, const void*);
GLenum buffer_target(const Context&, GLenum target, GLuint);
GLenum buffer_data(const Context&, GLenum target, GLsizeiptr size, const void*, GLenum usage);
GLenum buffer_sub_data(const Context&, GLenum target, GLintptr offset, GLsizeiptr size,
                       const void*);
GLenum map_buffer(const Context&, GLenum target, GLenum access);
GLenum map_buffer_range(const Context&, GLenum target, GLintptr offset, GLsizeiptr length,
                        GLbitfield access);
GLenum flush_mapped_range(const Context&, GLenum target, GLintptr offset, GLsizeiptr length);
GLenum unmap_buffer(const Context&, GLenum target);
GLenum get_buffer_pointer(const Context&, GLenum target, GLenum pname, void**);
GLenum bind_vertex_array(const Context&, GLuint name);
GLenum clear(const Context&, GLbitfield mask);
GLenum read_pixels(const Context&, GLint, GLint, GLsizei width, GLsizei height, GLenum format,
                   GLenum type, const void*);
GLenum draw_arrays(const Context&, GLenum mode, GLint first, GLsizei count);
GLenum draw_elements(const Context&, GLenum mode, GLsizei count, GLenum type, const void*);
// validate_framebuffer.cpp
GLenum framebuffer_target(const Context&, GLenum target);
GLenum framebuffer_target(const Context&, GLenum target, GLuint);
GLenum renderbuffer_target(const Context&, GLenum target, GLuint);
GLenum renderbuffer_storage(const Context&, GLenum target, GLenum internal, GLsizei width,
                            GLsizei height);
GLenum get_renderbuffer_parameter(const Context&, GLenum target, GLenum pname, const GLint*);
GLenum framebuffer_renderbuffer(const Context&, GLenum target, GLenum point,
                                GLenum renderbuffer_target, GLuint name);
GLenum framebuffer_texture(const Context&, GLenum target, GLenum point, GLenum texture_target,
                           GLuint name, GLint level);
GLenum get_framebuffer_attachment_parameter(const Context&, GLenum target, GLenum point,
                                            GLenum pname, const GLint*);
GLenum discard_framebuffer(const Context&, GLenum target, GLsizei n, const GLenum* attachments);
GLenum generate_mipmap(const Context&, GLenum target);
GLenum multi_draw_arrays(const Context&, GLenum mode, const GLint* first, const GLsizei* count,
                         GLsizei n);
GLenum multi_draw_elements(const Context&, GLenum mode, const GLsizei* count, GLenum type,
                           const void* const* indices, GLsizei n);
// egl_image.cpp
GLenum egl_image_target_texture(const Context&, GLenum target, const void* image);
GLenum egl_image_target_renderbuffer(const Context&, GLenum target, const void* image);
// validate_debug.cpp
GLenum debug_message_control(const Context&, GLenum source, GLenum type, GLenum severity,
                             GLsizei count, const GLuint* ids, GLboolean);
GLenum debug_message_insert(const Context&, GLenum source, GLenum type, GLuint, GLenum severity,
                            GLsizei length, const char* text);
GLenum get_debug_message_log(const Context&, GLuint, GLsizei size, const GLenum*, const GLenum*,
                             const GLuint*, const GLenum*, const GLsizei*, const char* text);
GLenum push_debug_group(const Context&, GLenum source, GLuint, GLsizei length, const char* text);
GLenum pop_debug_group(const Context&);
GLenum object_label(const Context&, GLenum identifier, GLuint name, GLsizei length, const char*);
GLenum get_object_label(const Context&, GLenum identifier, GLuint name, GLsizei size,
                        const GLsizei*, const char*);
// No object is named by a pointer: there are no sync objects.
template <typename... Arguments>
GLenum sync_label(const Context&, const Arguments&...) {
  return GL_INVALID_VALUE;
}
// queries.cpp
GLenum get(const Context&, GLenum pname, const Out&);
GLenum get_string(const Context&, GLenum name);
GLenum get_pointer(const Context&, GLenum pname, void**);
GLenum get_light(const Context&, GLenum light, GLenum pname, const Out&);
GLenum get_material(const Context&, GLenum face, GLenum pname, const Out&);
GLenum get_tex_env(const Context&, GLenum target, GLenum pname, const Out&);
GLenum get_tex_parameter(const Context&, GLenum target, GLenum pname, const Out&);
GLenum get_buffer_parameter(const Context&, GLenum target, GLenum pname, const GLint*);

}  // namespace clearpipe::api::validate
