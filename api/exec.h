// Executors: change state, or record work. They assume arguments a validator accepted.
// SPDX-License-Identifier: MIT
#pragma once

#include "api/context_state.h"
#include "api/params.h"

namespace clearpipe::api::exec {

// exec_state.cpp
GLenum get_error(Context&);
// Nothing resets a context (EXT_robustness).
inline GLenum graphics_reset_status(Context&) { return GL_NO_ERROR; }
void finish_all(Context&);
void flush_all(Context&);
void hint(Context&, GLenum target, GLenum mode);
void enable(Context&, GLenum cap, bool value);
void color(Context&, float r, float g, float b, float a);
void normal(Context&, float x, float y, float z);
void multi_tex_coord(Context&, GLenum target, float s, float t, float r, float q);
void point_size(Context&, float size);
void point_parameter(Context&, GLenum pname, const Params&);
void line_width(Context&, float width);
void cull_face(Context&, GLenum mode);
void front_face(Context&, GLenum mode);
void polygon_offset(Context&, float factor, float units);
void polygon_offset_clamp(Context&, float factor, float units, float clamp);
void sample_coverage(Context&, float value, GLboolean invert);
void pixel_store(Context&, GLenum pname, GLint param);
void fog(Context&, GLenum pname, const Params&);
void scissor(Context&, GLint x, GLint y, GLsizei width, GLsizei height);
void alpha_func(Context&, GLenum func, float reference);
void stencil_func(Context&, GLenum func, GLint reference, GLuint mask);
void stencil_op(Context&, GLenum fail, GLenum depth_fail, GLenum pass);
void depth_func(Context&, GLenum func);
void blend_func(Context&, GLenum src, GLenum dst);
void blend_func_separate(Context&, GLenum src_rgb, GLenum dst_rgb, GLenum src_a, GLenum dst_a);
void blend_equation(Context&, GLenum rgb, GLenum alpha);
void logic_op(Context&, GLenum opcode);
void color_mask(Context&, GLboolean r, GLboolean g, GLboolean b, GLboolean a);
void depth_mask(Context&, GLboolean flag);
void stencil_mask(Context&, GLuint mask);
void clear_color(Context&, float r, float g, float b, float a);
void clear_depth(Context&, float depth);
void clear_stencil(Context&, GLint s);
// exec_transform.cpp
void matrix_mode(Context&, GLenum mode);
void load_identity(Context&);
void load_matrix(Context&, const Params&);
void mult_matrix(Context&, const Params&);
void current_palette_matrix(Context&, GLuint index);
void load_palette_from_model_view_matrix(Context&);
void push_matrix(Context&);
void pop_matrix(Context&);
void rotate_matrix(Context&, float angle, float x, float y, float z);
void scale_matrix(Context&, float x, float y, float z);
void translate_matrix(Context&, float x, float y, float z);
void frustum_matrix(Context&, float l, float r, float b, float t, float n, float f);
void ortho_matrix(Context&, float l, float r, float b, float t, float n, float f);
void depth_range(Context&, float n, float f);
void viewport(Context&, GLint x, GLint y, GLsizei width, GLsizei height);
void clip_plane(Context&, GLenum plane, const Params&);
void shade_model(Context&, GLenum mode);
void light_model(Context&, GLenum pname, const Params&);
void light(Context&, GLenum light, GLenum pname, const Params&);
void material(Context&, GLenum face, GLenum pname, const Params&);
// exec_arrays.cpp
void client_active_texture(Context&, GLenum texture);
void client_state(Context&, GLenum array, bool value);
void vertex_pointer(Context&, GLint size, GLenum type, GLsizei stride, const void* pointer);
void color_pointer(Context&, GLint size, GLenum type, GLsizei stride, const void* pointer);
void normal_pointer(Context&, GLenum type, GLsizei stride, const void* pointer);
void tex_coord_pointer(Context&, GLint size, GLenum type, GLsizei stride, const void* pointer);
void point_size_pointer(Context&, GLenum type, GLsizei stride, const void* pointer);
void matrix_index_pointer(Context&, GLint size, GLenum type, GLsizei stride, const void* pointer);
void weight_pointer(Context&, GLint size, GLenum type, GLsizei stride, const void* pointer);
void bind_buffer(Context&, GLenum target, GLuint buffer);
void gen_buffers(Context&, GLsizei n, GLuint* names);
void delete_buffers(Context&, GLsizei n, const GLuint* names);
GLboolean is_buffer(Context&, GLuint name);
void buffer_data(Context&, GLenum target, GLsizeiptr size, const void* data, GLenum usage);
void buffer_sub_data(Context&, GLenum target, GLintptr offset, GLsizeiptr size, const void* data);
void* map_buffer(Context&, GLenum target, GLenum access);
void* map_buffer_range(Context&, GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield);
void flush_mapped_range(Context&, GLenum target, GLintptr offset, GLsizeiptr length);
GLboolean unmap_buffer(Context&, GLenum target);
void get_buffer_pointer(Context&, GLenum target, GLenum pname, void** params);
void bind_vertex_array(Context&, GLuint name);
void gen_vertex_arrays(Context&, GLsizei n, GLuint* names);
void delete_vertex_arrays(Context&, GLsizei n, const GLuint* names);
GLboolean is_vertex_array(Context&, GLuint name);
// exec_texture.cpp
void active_texture(Context&, GLenum texture);
void bind_texture(Context&, GLenum target, GLuint name);
void gen_textures(Context&, GLsizei n, GLuint* names);
void delete_textures(Context&, GLsizei n, const GLuint* names);
GLboolean is_texture(Context&, GLuint name);
void tex_parameter(Context&, GLenum target, GLenum pname, const Params&);
void tex_env(Context&, GLenum target, GLenum pname, const Params&);
void tex_gen(Context&, GLenum coord, GLenum pname, const Params&);
// texture_upload.cpp
void tex_image(Context&, GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height,
               GLint border, GLenum format, GLenum type, const void* pixels);
void tex_sub_image(Context&, GLenum target, GLint level, GLint x, GLint y, GLsizei width,
                   GLsizei height, GLenum format, GLenum type, const void* pixels);
void copy_tex_image(Context&, GLenum target, GLint level, GLenum internal, GLint x, GLint y,
                    GLsizei width, GLsizei height, GLint border);
void copy_tex_sub_image(Context&, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x,
                        GLint y, GLsizei width, GLsizei height);
void compressed_tex_image(Context&, GLenum target, GLint level, GLenum internal, GLsizei width,
                          GLsizei height, GLint border, GLsizei size, const void* data);
void compressed_tex_sub_image(Context&, GLenum target, GLint level, GLint, GLint, GLsizei, GLsizei,
                              GLenum format, GLsizei size, const void* data);
void generate_mipmap(Context&, GLenum target);
// texture_storage.cpp
void tex_storage(Context&, GLenum target, GLsizei levels, GLenum internal, GLsizei width,
                 GLsizei height);
void copy_texture_levels(Context&, GLuint destination, GLuint source, GLint base, GLsizei count);
// exec_framebuffer.cpp
GLboolean is_renderbuffer(Context&, GLuint name);
void bind_renderbuffer(Context&, GLenum target, GLuint name);
void gen_renderbuffers(Context&, GLsizei n, GLuint* names);
void delete_renderbuffers(Context&, GLsizei n, const GLuint* names);
void renderbuffer_storage(Context&, GLenum target, GLenum internal, GLsizei width, GLsizei height);
void renderbuffer_storage_multisample(Context&, GLenum target, GLsizei samples, GLenum internal,
                                      GLsizei width, GLsizei height);
void get_renderbuffer_parameter(Context&, GLenum target, GLenum pname, GLint* params);
GLboolean is_framebuffer(Context&, GLuint name);
void bind_framebuffer(Context&, GLenum target, GLuint name);
void gen_framebuffers(Context&, GLsizei n, GLuint* names);
void delete_framebuffers(Context&, GLsizei n, const GLuint* names);
GLenum check_framebuffer_status(Context&, GLenum target);
void framebuffer_renderbuffer(Context&, GLenum target, GLenum point, GLenum, GLuint name);
void framebuffer_texture(Context&, GLenum target, GLenum point, GLenum, GLuint name, GLint level);
void framebuffer_texture_multisample(Context&, GLenum target, GLenum point, GLenum, GLuint name,
                                     GLint level, GLsizei samples);
void get_framebuffer_attachment_parameter(Context&, GLenum target, GLenum point, GLenum pname,
                                          GLint* params);
void discard_framebuffer(Context&, GLenum target, GLsizei n, const GLenum* attachments);
// egl_image.cpp
void egl_image_target_texture(Context&, GLenum target, const void* image);
void egl_image_target_renderbuffer(Context&, GLenum target, const void* image);
// draw.cpp
void clear(Context&, GLbitfield mask);
void read_pixels(Context&, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                 GLenum type, void* pixels);
void read_n_pixels(Context&, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                   GLenum type, GLsizei size, void* data);
void draw_arrays(Context&, GLenum mode, GLint first, GLsizei count);
void draw_elements(Context&, GLenum mode, GLsizei count, GLenum type, const void* indices);
void multi_draw_arrays(Context&, GLenum mode, const GLint* first, const GLsizei* count, GLsizei n);
void multi_draw_elements(Context&, GLenum mode, const GLsizei* count, GLenum type,
                         const void* const* indices, GLsizei n);
// draw_texture.cpp
void draw_texture(Context&, float x, float y, float z, float width, float height);
// exec_debug.cpp
void debug_message_control(Context&, GLenum source, GLenum type, GLenum severity, GLsizei count,
                           const GLuint* ids, GLboolean enabled);
void debug_message_insert(Context&, GLenum source, GLenum type, GLuint id, GLenum severity,
                          GLsizei length, const char* text);
void debug_message_callback(Context&, DebugCallback callback, const void* user_param);
GLuint get_debug_message_log(Context&, GLuint count, GLsizei size, GLenum* sources, GLenum* types,
                             GLuint* ids, GLenum* severities, GLsizei* lengths, char* text);
void push_debug_group(Context&, GLenum source, GLuint id, GLsizei length, const char* text);
void pop_debug_group(Context&);
void object_label(Context&, GLenum identifier, GLuint name, GLsizei length, const char* label);
void get_object_label(Context&, GLenum identifier, GLuint name, GLsizei size, GLsizei* length,
                      char* label);
void label_object(Context&, GLenum type, GLuint name, GLsizei length, const char* label);
void object_ptr_label(Context&, const void* sync, GLsizei length, const char* label);
void get_object_ptr_label(Context&, const void* sync, GLsizei size, GLsizei* length, char* label);
void insert_event_marker(Context&, GLsizei length, const char* marker);
void push_group_marker(Context&, GLsizei length, const char* marker);
void pop_group_marker(Context&);
// The validator accepts no program.
inline void get_uniform(Context&, GLuint, GLint, GLsizei, const void*) {}
// exec_fence.cpp
void gen_fences(Context&, GLsizei n, GLuint* names);
void delete_fences(Context&, GLsizei n, const GLuint* names);
GLboolean is_fence(Context&, GLuint name);
void set_fence(Context&, GLuint name, GLenum condition);
GLboolean test_fence(Context&, GLuint name);
void finish_fence(Context&, GLuint name);
void get_fence(Context&, GLuint name, GLenum pname, GLint* params);
// sync_objects.cpp
GLsync fence_sync(Context&, GLenum condition, GLbitfield flags);
GLboolean is_sync(Context&, GLsync sync);
void delete_sync(Context&, GLsync sync);
GLenum client_wait_sync(Context&, GLsync sync, GLbitfield flags, GLuint64 timeout);
void wait_sync(Context&, GLsync sync, GLbitfield flags, GLuint64 timeout);
void get_sync(Context&, GLsync sync, GLenum pname, GLsizei count, GLsizei* length, GLint* values);
// queries.cpp
void get(Context&, GLenum pname, const Out&);
const GLubyte* get_string(Context&, GLenum name);
void get_pointer(Context&, GLenum pname, void** params);
GLboolean is_enabled(Context&, GLenum cap);
void get_clip_plane(Context&, GLenum plane, const Out&);
void get_light(Context&, GLenum light, GLenum pname, const Out&);
void get_material(Context&, GLenum face, GLenum pname, const Out&);
void get_tex_env(Context&, GLenum target, GLenum pname, const Out&);
void get_tex_gen(Context&, GLenum coord, GLenum pname, const Out&);
void get_tex_parameter(Context&, GLenum target, GLenum pname, const Out&);
void get_buffer_parameter(Context&, GLenum target, GLenum pname, GLint* params);
GLbitfield query_matrix(Context&, GLfixed* mantissa, GLint* exponent);

}  // namespace clearpipe::api::exec
