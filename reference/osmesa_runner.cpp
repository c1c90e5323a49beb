// See osmesa_runner.h. The library is opened with RTLD_LOCAL, so that its gl* symbols meet nobody.
// SPDX-License-Identifier: MIT
#include "reference/osmesa_runner.h"

#include <dlfcn.h>

#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "reference/gles1_on_gl.h"

namespace clearpipe::reference {

namespace {

// From GL/osmesa.h, which cannot be included beside GLES/gl.h.
constexpr int kOsmesaFormat = 0x22;
constexpr int kOsmesaDepthBits = 0x30;
constexpr int kOsmesaStencilBits = 0x31;
constexpr int kOsmesaProfile = 0x33;
constexpr int kOsmesaCompatProfile = 0x35;
constexpr int kGlRgba = 0x1908;

using CreateContext = void* (*)(const int* attributes, void* share);
using MakeCurrent = unsigned char (*)(void* context, void* buffer, GLenum type, int width,
                                      int height);
using DestroyContext = void (*)(void* context);
using GetProcAddress = void* (*)(const char* name);

GetProcAddress get_proc_address;

class Osmesa final : public conformance::Implementation {
 public:
  explicit Osmesa(const char* driver) : driver_(driver) {
    setenv("GALLIUM_DRIVER", driver, 1);
    library_ = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (library_ == nullptr) throw std::runtime_error(dlerror());
    create_context_ =
        reinterpret_cast<CreateContext>(dlsym(library_, "OSMesaCreateContextAttribs"));
    make_current_ = reinterpret_cast<MakeCurrent>(dlsym(library_, "OSMesaMakeCurrent"));
    destroy_context_ = reinterpret_cast<DestroyContext>(dlsym(library_, "OSMesaDestroyContext"));
    get_proc_address = reinterpret_cast<GetProcAddress>(dlsym(library_, "OSMesaGetProcAddress"));
    if (create_context_ == nullptr || get_proc_address == nullptr) {
      throw std::runtime_error("libOSMesa.so.8 lacks what a scene needs");
    }
    gl_ = gles1_on_gl(get_proc_address);
  }

  // The library stays: its worker threads do not like to lose their code.
  ~Osmesa() override { end(); }

  const conformance::Gl& begin(int width, int height) override {
    end();
    const int attributes[] = {
        kOsmesaFormat,        kGlRgba, kOsmesaDepthBits, 24, kOsmesaStencilBits, 8, kOsmesaProfile,
        kOsmesaCompatProfile, 0};
    context_ = create_context_(attributes, nullptr);
    if (context_ == nullptr) throw std::runtime_error("OSMesaCreateContextAttribs failed");
    buffer_.assign(static_cast<size_t>(width) * height * 4, 0);
    if (!make_current_(context_, buffer_.data(), GL_UNSIGNED_BYTE, width, height)) {
      throw std::runtime_error("OSMesaMakeCurrent failed");
    }
    name_ = reinterpret_cast<const char*>(gl_.GetString(GL_RENDERER));
    if (name_.find(driver_) == std::string::npos) {
      throw std::runtime_error("the reference draws with " + name_ + ", not with " + driver_);
    }
    forget_arrays();
    return gl_;
  }

  void end() override {
    if (context_ == nullptr) return;
    gl_.Finish();
    make_current_(nullptr, nullptr, 0, 0, 0);
    destroy_context_(context_);
    context_ = nullptr;
  }

  std::string name() const override { return name_; }

 private:
  std::string driver_;
  void* library_ = nullptr;
  CreateContext create_context_ = nullptr;
  MakeCurrent make_current_ = nullptr;
  DestroyContext destroy_context_ = nullptr;
  void* context_ = nullptr;
  std::vector<unsigned char> buffer_;
  conformance::Gl gl_;
  std::string name_;
};

}  // namespace

std::unique_ptr<conformance::Implementation> open_osmesa(const char* driver) {
  return std::make_unique<Osmesa>(driver);
}

}  // namespace clearpipe::reference
