// The objects contexts share: buffer objects (2.9), textures (3.7), and the framebuffer and
// renderbuffer objects of OES_framebuffer_object, under their names.
//
// A share group owns the names; a context that has an object bound also holds the object, so an
// object deleted elsewhere lives on until it is unbound. Deleting a name unbinds the object in the
// context that deletes it only (2.9, 3.7.11).
//
// Contexts of a share group may be current to different threads at once. The rule: whoever looks at
// the names, or at a member of an object, holds the group's mutex. Entry points take it by the
// group of the call in gles1.def: `texture`, `buffer`, `framebuffer`, `label`, `sync` and `draw`
// lock, all others do not and so must not follow a BufferPtr or TexturePtr further than to its
// constant name. Executing a frame needs no lock, because what it reads is not written before it is
// finished (frame_uses.h); only calls that hold it anyway and must see pixels, or whose frame has
// grown too large, execute with it. SPDX-License-Identifier: MIT
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "api/frame_uses.h"
#include "api/limits.h"
#include "pipeline/command.h"
#include "pipeline/image.h"
#include "pipeline/surface.h"

namespace clearpipe::api {

// Table 6.6.
struct BufferObject {
  explicit BufferObject(GLuint n) : name(n) {}
  const GLuint name;
  GLenum usage = GL_STATIC_DRAW;
  std::shared_ptr<pipeline::BufferData> data = std::make_shared<pipeline::BufferData>();
  std::string label;  // KHR_debug, as of all objects
  FrameUses uses;     // of data
  // OES_mapbuffer, EXT_map_buffer_range: the range an application may write, with its flags. The
  // store stays where it is while it is mapped, and no draw reads it.
  bool mapped = false;
  GLbitfield map_access = 0;
  size_t map_offset = 0, map_length = 0;
};
using BufferPtr = std::shared_ptr<BufferObject>;

struct EglImage;  // egl_image.h
using EglImagePtr = std::shared_ptr<EglImage>;

struct SurfaceTexture;  // surface_texture.cpp

struct TextureLevel {
  int width = 0, height = 0;
  GLenum internal = 0;  // as specified, sized and compressed ones too: levels must agree (3.7.9)
  GLenum format = 0;    // its base format: ALPHA, LUMINANCE, LUMINANCE_ALPHA, RGB or RGBA
  EglImagePtr sibling = nullptr;  // what it shares its texels with
};

// Table 6.14.
struct TextureObject {
  explicit TextureObject(GLuint n, GLenum t = 0) : name(n) {
    if (t != 0) set_target(t);
  }
  const GLuint name;
  GLenum target = 0;  // that it was first bound to (3.7.11); 0: to none
  void set_target(GLenum t);
  int storage_levels = 0;  // EXT_texture_storage: so many levels, immutable; 0: not immutable
  // Grows with every change but that of texels alone. Contexts that have the texture bound compare
  // it with what they derived from.
  uint64_t version = 1;
  GLenum min_filter = GL_NEAREST_MIPMAP_LINEAR;
  GLenum mag_filter = GL_LINEAR;
  GLenum wrap_s = GL_REPEAT;
  GLenum wrap_t = GL_REPEAT;
  bool generate_mipmap = false;
  GLint max_level = 1000;             // APPLE_texture_max_level
  float max_anisotropy = 1;           // EXT_texture_filter_anisotropic, as set
  GLint crop_rect[4] = {0, 0, 0, 0};  // OES_draw_texture
  // As in a pipeline::Image, those of the faces of a cube map one after the other.
  std::array<TextureLevel, pipeline::kCubeFaces * kTextureLevels> level;
  std::shared_ptr<pipeline::Image> image = std::make_shared<pipeline::Image>();
  std::string label;
  FrameUses uses;                           // of image
  bool has_siblings = false;                // a level is the sibling of an EGLImage
  std::shared_ptr<SurfaceTexture> surface;  // its images are those of a surface (3.6 of EGL 1.5)
};
using TexturePtr = std::shared_ptr<TextureObject>;

// Table 8.nnn of EXT_framebuffer_object, state of a renderbuffer.
struct RenderbufferObject {
  explicit RenderbufferObject(GLuint n) : name(n) {}
  const GLuint name;
  int width = 0, height = 0;
  int samples = 0;  // EXT_multisampled_render_to_texture
  GLenum internal = GL_RGBA4_OES;
  std::string label;
  // Of the two, what the internal format has; none before there is storage, or when it has no size.
  std::shared_ptr<pipeline::ColourBuffer> colour;
  std::shared_ptr<pipeline::DepthStencilBuffer> depth_stencil;
  EglImagePtr sibling;
};
using RenderbufferPtr = std::shared_ptr<RenderbufferObject>;

// One attachment point: nothing, a renderbuffer, or a level of a texture or of its face.
struct Attachment {
  RenderbufferPtr renderbuffer;
  TexturePtr texture;
  GLint level = 0;
  GLenum face = 0;   // 0: not a cube map
  size_t image = 0;  // in TextureObject::level
  // EXT_multisampled_render_to_texture, of textures: the samples, and the implicit multisample
  // buffer, which is made when it is drawn to.
  int samples = 0;
  std::shared_ptr<pipeline::SampleBuffer> sample_buffer = nullptr;
  std::weak_ptr<uint32_t[]> sampled = {};  // the pixels it belongs to
  // The image as it was last drawn to, for the next time it is.
  std::shared_ptr<pipeline::ColourBuffer> colour_buffer = nullptr;
  std::shared_ptr<pipeline::DepthStencilBuffer> depth_stencil_buffer = nullptr;
};

struct FramebufferObject {
  explicit FramebufferObject(GLuint n) : name(n) {}
  const GLuint name;
  Attachment colour, depth, stencil;
  std::string label;
};
using FramebufferPtr = std::shared_ptr<FramebufferObject>;

// APPLE_sync: signaled when the frame it was made in is over. Immutable but for its label.
struct SyncObject {
  explicit SyncObject(GLuint) {}
  FrameClock clock;
  uint64_t frame = 0;
  std::string label;
  bool signaled() const { return clock->is_over(frame); }
};
using SyncPtr = std::shared_ptr<SyncObject>;

// Names in use. A name is generated with no object (null) and gets one when first bound.
template <typename Object>
class NameTable {
 public:
  GLuint generate() {
    GLuint name = next_;
    while (name == 0 || objects_.count(name) != 0) ++name;
    objects_[name] = nullptr;
    next_ = name + 1;
    return name;
  }
  // The object of a name, made if there is none. Like that of find(), the reference is good until
  // the name is erased.
  const std::shared_ptr<Object>& bind(GLuint name) {
    std::shared_ptr<Object>& object = objects_[name];
    if (!object) {
      object = std::make_shared<Object>(name);
    }
    return object;
  }
  // Null: the name has no object.
  const std::shared_ptr<Object>& find(GLuint name) const {
    static const std::shared_ptr<Object> none;
    const auto found = objects_.find(name);
    return found != objects_.end() ? found->second : none;
  }
  // Whether the name is generated or has an object.
  bool contains(GLuint name) const { return objects_.count(name) != 0; }
  void erase(GLuint name) { objects_.erase(name); }

 private:
  std::map<GLuint, std::shared_ptr<Object>> objects_;
  GLuint next_ = 1;
};

struct ShareGroup {
  // Goes last: images that nobody will need again have then been freed.
  struct FreeImages {
    ~FreeImages() { pipeline::forget_free_images(); }
  } free_images;
  std::mutex mutex;
  uint64_t buffers_version = 1;  // grows when a buffer object gets another data store
  NameTable<BufferObject> buffers;
  NameTable<TextureObject> textures;
  NameTable<RenderbufferObject> renderbuffers;
  NameTable<FramebufferObject> framebuffers;
  NameTable<SyncObject> syncs;  // GLsync is the name
};

// Whether the texture is complete (3.7.9): an incomplete one disables its unit. A cube map is cube
// complete or, with a filter that needs mipmaps, mipmap cube complete.
bool is_complete(const TextureObject& texture);
// Whether the base levels of all faces fit each other, for what has faces.
bool is_cube_complete(const TextureObject& texture);
// Whether it has all the levels that a mipmap filter asks for.
bool has_mipmap(const TextureObject& texture);
bool is_mipmap_filter(GLenum min_filter);

// The last level that a mipmap of it has: q (3.7.7), for the base level at hand or one whose longer
// side is `size`.
int last_mipmap_level(const TextureObject& texture);
int last_mipmap_level(const TextureObject& texture, int size);

}  // namespace clearpipe::api
