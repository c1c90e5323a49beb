// Validators: pure functions of the context and the arguments that return the error a call
// generates and the rule it breaks, or nothing. Each sees the arguments its executor gets
// (gles1.def).
// SPDX-License-Identifier: MIT
#pragma once

#include "api/context_state.h"
#include "api/invalid.h"
#include "api/params.h"

namespace clearpipe::api::validate {

template <typename... Arguments>
Invalid none(const Context&, const Arguments&...) {
  return {};
}

// Of a parameter name at that position whose parameter is a vector.
inline Invalid vector_only(const Params& p, int position) {
  const Invalid scalar{GL_INVALID_ENUM,
                       "{0} takes a vector: set it with a form of the call in v (2.3)"};
  return p.scalar() ? scalar.from(position) : Invalid();
}

// Of calls whose first argument is a target of buffer objects.
inline constexpr const char* kNoBuffer = "no buffer object is bound to {0} (2.9)";
inline constexpr const char* kMapped = "the buffer of {0} is mapped (OES_mapbuffer)";

// The buffer object bound to a target of buffer objects, or null.
inline const BufferPtr& bound_buffer(const Context& c, GLenum target) {
  return target == GL_ARRAY_BUFFER ? c.state.arrays.array_buffer
                                   : c.state.arrays.element_array_buffer;
}

// validate_state.cpp
Invalid hint(const Context&, GLenum target, GLenum mode);
Invalid enable(const Context&, GLenum cap, bool value);
Invalid is_enabled(const Context&, GLenum cap);
Invalid multi_tex_coord(const Context&, GLenum target, float, float, float, float);
Invalid texture_unit(const Context&, GLenum texture);
Invalid matrix_mode(const Context&, GLenum mode);
Invalid current_palette_matrix(const Context&, GLuint index);
Invalid push_matrix(const Context&);
Invalid pop_matrix(const Context&);
Invalid frustum_planes(const Context&, float l, float r, float b, float t, float n, float f);
Invalid ortho_planes(const Context&, float l, float r, float b, float t, float n, float f);
Invalid rectangle(const Context&, GLint x, GLint y, GLsizei width, GLsizei height);
Invalid clip_plane(const Context&, GLenum plane, const Params&);
Invalid clip_plane(const Context&, GLenum plane, const Out&);
Invalid shade_model(const Context&, GLenum mode);
Invalid light_model(const Context&, GLenum pname, const Params&);
Invalid light(const Context&, GLenum light, GLenum pname, const Params&);
Invalid material(const Context&, GLenum face, GLenum pname, const Params&);
Invalid positive(const Context&, float value);
Invalid point_parameter(const Context&, GLenum pname, const Params&);
Invalid cull_face(const Context&, GLenum mode);
Invalid front_face(const Context&, GLenum mode);
// validate_fragment.cpp
Invalid fog(const Context&, GLenum pname, const Params&);
Invalid alpha_func(const Context&, GLenum func, float);
Invalid compare_func(const Context&, GLenum func);
Invalid stencil_func(const Context&, GLenum func, GLint, GLuint);
Invalid stencil_op(const Context&, GLenum fail, GLenum zfail, GLenum zpass);
Invalid blend_func(const Context&, GLenum src, GLenum dst);
Invalid blend_func_separate(const Context&, GLenum, GLenum, GLenum, GLenum);
Invalid blend_equation(const Context&, GLenum rgb, GLenum alpha);
Invalid logic_op(const Context&, GLenum opcode);
// validate_texture.cpp
Invalid pixel_store(const Context&, GLenum pname, GLint param);
Invalid texture_target(GLenum target);
Invalid specified_target(GLenum target);
Invalid bind_texture(const Context&, GLenum target, GLuint name);
Invalid names(const Context&, GLsizei n, const GLuint*);
Invalid tex_image(const Context&, GLenum target, GLint level, GLint internal, GLsizei width,
                  GLsizei height, GLint border, GLenum format, GLenum type, const void*);
Invalid tex_sub_image(const Context&, GLenum target, GLint level, GLint x, GLint y, GLsizei width,
                      GLsizei height, GLenum format, GLenum type, const void*);
Invalid copy_tex_image(const Context&, GLenum target, GLint level, GLenum internal, GLint x,
                       GLint y, GLsizei width, GLsizei height, GLint border);
Invalid copy_tex_sub_image(const Context&, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                           GLint x, GLint y, GLsizei width, GLsizei height);
Invalid compressed_tex_image(const Context&, GLenum target, GLint level, GLenum internal,
                             GLsizei width, GLsizei height, GLint border, GLsizei size,
                             const void*);
Invalid compressed_tex_sub_image(const Context&, GLenum target, GLint level, GLint, GLint, GLsizei,
                                 GLsizei, GLenum format, GLsizei size, const void*);
Invalid tex_parameter(const Context&, GLenum target, GLenum pname, const Params&);
Invalid tex_env(const Context&, GLenum target, GLenum pname, const Params&);
Invalid generated_mode(GLenum coord, GLenum pname);
Invalid tex_gen(const Context&, GLenum coord, GLenum pname, const Params&);
// validate_draw.cpp
Invalid client_state(const Context&, GLenum array, bool);
Invalid vertex_pointer(const Context&, GLint size, GLenum type, GLsizei stride, const void*);
Invalid color_pointer(const Context&, GLint size, GLenum type, GLsizei stride, const void*);
Invalid normal_pointer(const Context&, GLenum type, GLsizei stride, const void*);
Invalid point_size_pointer(const Context&, GLenum type, GLsizei stride, const void*);
Invalid matrix_index_pointer(const Context&, GLint size, GLenum type, GLsizei stride,
                             const void* pointer);
Invalid weight_pointer(const Context&, GLint size, GLenum type, GLsizei stride,
                       const void* pointer);
Invalid buffer_target(const Context&, GLenum target, GLuint);
Invalid buffer_data(const Context&, GLenum target, GLsizeiptr size, const void*, GLenum usage);
Invalid buffer_sub_data(const Context&, GLenum target, GLintptr offset, GLsizeiptr size,
                        const void*);
Invalid map_buffer(const Context&, GLenum target, GLenum access);
Invalid map_buffer_range(const Context&, GLenum target, GLintptr offset, GLsizeiptr length,
                         GLbitfield access);
Invalid flush_mapped_range(const Context&, GLenum target, GLintptr offset, GLsizeiptr length);
Invalid unmap_buffer(const Context&, GLenum target);
Invalid get_buffer_pointer(const Context&, GLenum target, GLenum pname, void**);
Invalid bind_vertex_array(const Context&, GLuint name);
Invalid clear(const Context&, GLbitfield mask);
Invalid read_pixels(const Context&, GLint, GLint, GLsizei width, GLsizei height, GLenum format,
                    GLenum type, const void*);
Invalid read_n_pixels(const Context&, GLint, GLint, GLsizei width, GLsizei height, GLenum format,
                      GLenum type, GLsizei size, const void*);
Invalid draw_arrays(const Context&, GLenum mode, GLint first, GLsizei count);
Invalid draw_elements(const Context&, GLenum mode, GLsizei count, GLenum type, const void*);
Invalid draw_texture(const Context&, float x, float y, float z, float width, float height);
// validate_framebuffer.cpp
Invalid framebuffer_target(const Context&, GLenum target);
Invalid framebuffer_target(const Context&, GLenum target, GLuint);
Invalid renderbuffer_target(const Context&, GLenum target, GLuint);
Invalid renderbuffer_storage(const Context&, GLenum target, GLenum internal, GLsizei width,
                             GLsizei height);
Invalid renderbuffer_storage_multisample(const Context&, GLenum target, GLsizei samples,
                                         GLenum internal, GLsizei width, GLsizei height);
Invalid get_renderbuffer_parameter(const Context&, GLenum target, GLenum pname, const GLint*);
Invalid framebuffer_renderbuffer(const Context&, GLenum target, GLenum point,
                                 GLenum renderbuffer_target, GLuint name);
Invalid framebuffer_texture(const Context&, GLenum target, GLenum point, GLenum texture_target,
                            GLuint name, GLint level);
Invalid framebuffer_texture_multisample(const Context&, GLenum target, GLenum point,
                                        GLenum texture_target, GLuint name, GLint level,
                                        GLsizei samples);
Invalid get_framebuffer_attachment_parameter(const Context&, GLenum target, GLenum point,
                                             GLenum pname, const GLint*);
Invalid discard_framebuffer(const Context&, GLenum target, GLsizei n, const GLenum* attachments);
Invalid generate_mipmap(const Context&, GLenum target);
// validate_storage.cpp
Invalid tex_storage(const Context&, GLenum target, GLsizei levels, GLenum internal, GLsizei width,
                    GLsizei height);
Invalid copy_texture_levels(const Context&, GLuint destination, GLuint source, GLint base,
                            GLsizei count);
Invalid multi_draw_arrays(const Context&, GLenum mode, const GLint* first, const GLsizei* count,
                          GLsizei n);
Invalid multi_draw_elements(const Context&, GLenum mode, const GLsizei* count, GLenum type,
                            const void* const* indices, GLsizei n);
// egl_image.cpp
Invalid egl_image_target_texture(const Context&, GLenum target, const void* image);
Invalid egl_image_target_renderbuffer(const Context&, GLenum target, const void* image);
// validate_debug.cpp
Invalid debug_message_control(const Context&, GLenum source, GLenum type, GLenum severity,
                              GLsizei count, const GLuint* ids, GLboolean);
Invalid debug_message_insert(const Context&, GLenum source, GLenum type, GLuint, GLenum severity,
                             GLsizei length, const char* text);
Invalid get_debug_message_log(const Context&, GLuint, GLsizei size, const GLenum*, const GLenum*,
                              const GLuint*, const GLenum*, const GLsizei*, const char* text);
Invalid push_debug_group(const Context&, GLenum source, GLuint, GLsizei length, const char* text);
Invalid pop_debug_group(const Context&);
Invalid object_label(const Context&, GLenum identifier, GLuint name, GLsizei length, const char*);
Invalid get_object_label(const Context&, GLenum identifier, GLuint name, GLsizei size,
                         const GLsizei*, const char*);
Invalid object_ptr_label(const Context&, const void* sync, GLsizei length, const char* label);
Invalid get_object_ptr_label(const Context&, const void* sync, GLsizei size, const GLsizei*,
                             const char*);
Invalid label_object(const Context&, GLenum type, GLuint name, GLsizei length, const char*);
Invalid get_label_ext(const Context&, GLenum type, GLuint name, GLsizei size, const GLsizei*,
                      const char*);
// validate_fence.cpp
Invalid set_fence(const Context&, GLuint name, GLenum condition);
Invalid existing_fence(const Context&, GLuint name);
Invalid get_fence(const Context&, GLuint name, GLenum pname, const GLint*);
// sync_objects.cpp
Invalid fence_sync(const Context&, GLenum condition, GLbitfield flags);
Invalid delete_sync(const Context&, GLsync sync);
Invalid client_wait_sync(const Context&, GLsync sync, GLbitfield flags);
Invalid wait_sync(const Context&, GLsync sync, GLbitfield flags, GLuint64 timeout);
Invalid get_sync(const Context&, GLsync sync, GLenum pname, GLsizei count, const GLsizei*,
                 const GLint*);
// No program has uniforms: there are no programs.
template <typename... Arguments>
Invalid get_uniform(const Context&, const Arguments&...) {
  return {GL_INVALID_VALUE, "{0} is no program: there are none (EXT_robustness, 6.1.8)"};
}
// queries.cpp
Invalid get(const Context&, GLenum pname, const Out&);
Invalid get_string(const Context&, GLenum name);
Invalid get_pointer(const Context&, GLenum pname, void**);
Invalid get_light(const Context&, GLenum light, GLenum pname, const Out&);
Invalid get_material(const Context&, GLenum face, GLenum pname, const Out&);
Invalid get_tex_env(const Context&, GLenum target, GLenum pname, const Out&);
Invalid get_tex_gen(const Context&, GLenum coord, GLenum pname, const Out&);
Invalid get_tex_parameter(const Context&, GLenum target, GLenum pname, const Out&);
Invalid get_buffer_parameter(const Context&, GLenum target, GLenum pname, const GLint*);

}  // namespace clearpipe::api::validate
