// The objects contexts share: buffer objects (2.9) and textures (3.7), under their names.
//
// A share group owns the names; a context that has an object bound also holds the object, so an
// object deleted elsewhere lives on until it is unbound. A buffer's data store and a texture's
// image are replaced, never changed, while a frame holds them.
// SPDX-License-Identifier: MIT
#pragma once

#include <GLES/gl.h>

#include <array>
#include <map>
#include <memory>
#include <mutex>

#include "api/limits.h"
#include "pipeline/command.h"
#include "pipeline/image.h"

namespace clearpipe::api {

// Table 6.8.
struct BufferObject {
  GLuint name = 0;
  GLenum usage = GL_STATIC_DRAW;
  std::shared_ptr<pipeline::BufferData> data = std::make_shared<pipeline::BufferData>();
};
using BufferPtr = std::shared_ptr<BufferObject>;

struct TextureLevel {
  int width = 0, height = 0;
  GLenum format = 0;  // base internal format: ALPHA, LUMINANCE, LUMINANCE_ALPHA, RGB or RGBA
  GLenum type = 0;    // as specified: levels must agree (3.7.10)
};

// Tables 6.13 and 6.14.
struct TextureObject {
  GLuint name = 0;
  GLenum min_filter = GL_NEAREST_MIPMAP_LINEAR;
  GLenum mag_filter = GL_LINEAR;
  GLenum wrap_s = GL_REPEAT;
  GLenum wrap_t = GL_REPEAT;
  bool generate_mipmap = false;
  std::array<TextureLevel, kTextureLevels> level;
  std::shared_ptr<pipeline::Image> image = std::make_shared<pipeline::Image>();
};
using TexturePtr = std::shared_ptr<TextureObject>;

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
  std::shared_ptr<Object> bind(GLuint name) {
    std::shared_ptr<Object>& object = objects_[name];
    if (!object) {
      object = std::make_shared<Object>();
      object->name = name;
    }
    return object;
  }
  bool is_object(GLuint name) const {
    const auto found = objects_.find(name);
    return found != objects_.end() && found->second;
  }
  void erase(GLuint name) { objects_.erase(name); }

 private:
  std::map<GLuint, std::shared_ptr<Object>> objects_;
  GLuint next_ = 1;
};

struct ShareGroup {
  // Recursive: a call holds it while it uses objects, and may use several.
  std::recursive_mutex mutex;
  NameTable<BufferObject> buffers;
  NameTable<TextureObject> textures;
};

// Whether the texture is complete (3.7.10): an incomplete one disables its unit.
bool is_complete(const TextureObject& texture);
bool is_mipmap_filter(GLenum min_filter);

// The image to write to: the texture's own, or a copy when somebody else still holds it.
pipeline::Image& writable_image(TextureObject& texture);

}  // namespace clearpipe::api
