// See through_egl.h. The loader is opened with RTLD_LOCAL: none of its GL symbols may be found by
// the reference's libraries in the same process.
// SPDX-License-Identifier: MIT
#include "conformance/through_egl.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

namespace clearpipe::conformance {

namespace {

// Keeps every library of the process loaded until its end: a driver that is unloaded with its
// display would be nameless in a report of what it leaked, and could not be told from clearpipe.
void keep_libraries() {
  const auto keep = [](dl_phdr_info* library, size_t, void*) {
    if (*library->dlpi_name != 0)
      dlopen(library->dlpi_name, RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
    return 0;
  };
  dl_iterate_phdr(keep, nullptr);
}

class ThroughEgl final : public Implementation {
 public:
  // Opens the display of the vendor of that name, or, for null, the surfaceless one.
  ThroughEgl(const char* vendor, const Buffers& buffers) : buffers_(buffers) {
    library_ = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (library_ == nullptr) throw std::runtime_error(dlerror());
    const auto egl = [&](const char* symbol) { return dlsym(library_, symbol); };
    get_proc_address_ = reinterpret_cast<decltype(&eglGetProcAddress)>(egl("eglGetProcAddress"));
    get_error_ = reinterpret_cast<decltype(&eglGetError)>(egl("eglGetError"));
    choose_config_ = reinterpret_cast<decltype(&eglChooseConfig)>(egl("eglChooseConfig"));
    get_config_attrib_ = reinterpret_cast<decltype(&eglGetConfigAttrib)>(egl("eglGetConfigAttrib"));
    create_context_ = reinterpret_cast<decltype(&eglCreateContext)>(egl("eglCreateContext"));
    destroy_context_ = reinterpret_cast<decltype(&eglDestroyContext)>(egl("eglDestroyContext"));
    create_pbuffer_ =
        reinterpret_cast<decltype(&eglCreatePbufferSurface)>(egl("eglCreatePbufferSurface"));
    destroy_surface_ = reinterpret_cast<decltype(&eglDestroySurface)>(egl("eglDestroySurface"));
    make_current_ = reinterpret_cast<decltype(&eglMakeCurrent)>(egl("eglMakeCurrent"));
    terminate_ = reinterpret_cast<decltype(&eglTerminate)>(egl("eglTerminate"));
    initialize_ = reinterpret_cast<decltype(&eglInitialize)>(egl("eglInitialize"));
    query_string_ = reinterpret_cast<decltype(&eglQueryString)>(egl("eglQueryString"));
    get_platform_display_ =
        reinterpret_cast<decltype(&eglGetPlatformDisplay)>(egl("eglGetPlatformDisplay"));

    if (vendor != nullptr) {
      open_display_of(vendor);
    } else {
      display_ = get_platform_display_(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
      check(display_ != EGL_NO_DISPLAY && initialize_(display_, nullptr, nullptr), "eglInitialize");
    }
    choose_config();
    gl_ = load_gl(
        [&](const char* symbol) { return reinterpret_cast<void*>(get_proc_address_(symbol)); });
  }

  ~ThroughEgl() override {
    end();
    keep_libraries();
    terminate_(display_);
    dlclose(library_);
  }

  const Gl& begin(int width, int height) override {
    end();
    context_ = create_context_(display_, config_, EGL_NO_CONTEXT, nullptr);
    check(context_ != EGL_NO_CONTEXT, "eglCreateContext");
    const EGLint size[] = {EGL_WIDTH,
                           width,
                           EGL_HEIGHT,
                           height,
                           buffers_.srgb ? EGL_GL_COLORSPACE : EGL_NONE,
                           EGL_GL_COLORSPACE_SRGB,
                           EGL_NONE};
    surface_ = create_pbuffer_(display_, config_, size);
    check(surface_ != EGL_NO_SURFACE, "eglCreatePbufferSurface");
    check(make_current_(display_, surface_, surface_, context_), "eglMakeCurrent");
    name_ = reinterpret_cast<const char*>(gl_.GetString(GL_RENDERER));
    return gl_;
  }

  void end() override {
    if (context_ == EGL_NO_CONTEXT) return;
    make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (surface_ != EGL_NO_SURFACE) destroy_surface_(display_, surface_);
    destroy_context_(display_, context_);
    context_ = EGL_NO_CONTEXT;
    surface_ = EGL_NO_SURFACE;
  }

  std::string name() const override { return name_; }

 private:
  // The display of a vendor's software device.
  void open_display_of(const std::string& vendor) {
    const auto query_devices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(get_proc_address_("eglQueryDevicesEXT"));
    const auto query_device = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(
        get_proc_address_("eglQueryDeviceStringEXT"));
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    check(query_devices(16, devices.data(), &count), "eglQueryDevicesEXT");
    for (EGLint i = 0; i < count; ++i) {
      const EGLDeviceEXT device = devices[static_cast<size_t>(i)];
      const char* extensions = query_device(device, EGL_EXTENSIONS);
      if (extensions == nullptr || !std::strstr(extensions, "EGL_MESA_device_software")) continue;
      const EGLDisplay display = get_platform_display_(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
      if (display == EGL_NO_DISPLAY || !initialize_(display, nullptr, nullptr)) continue;
      if (vendor == query_string_(display, EGL_VENDOR)) {
        display_ = display;
        return;
      }
      terminate_(display);
    }
    throw std::runtime_error("no EGL software device of " + vendor);
  }

  // The first config that has exactly what is wanted.
  void choose_config() {
    const std::array<std::pair<EGLint, EGLint>, 7> wanted = {{{EGL_RED_SIZE, buffers_.red},
                                                              {EGL_GREEN_SIZE, buffers_.green},
                                                              {EGL_BLUE_SIZE, buffers_.blue},
                                                              {EGL_ALPHA_SIZE, buffers_.alpha},
                                                              {EGL_DEPTH_SIZE, buffers_.depth},
                                                              {EGL_STENCIL_SIZE, buffers_.stencil},
                                                              {EGL_SAMPLES, buffers_.samples}}};
    std::vector<EGLint> list = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                EGL_OPENGL_ES_BIT};
    for (const auto& [attribute, value] : wanted) list.insert(list.end(), {attribute, value});
    list.push_back(EGL_NONE);
    std::array<EGLConfig, 256> configs{};
    EGLint count = 0;
    check(choose_config_(display_, list.data(), configs.data(), 256, &count), "eglChooseConfig");
    for (EGLint i = 0; i < count && config_ == nullptr; ++i) {
      const EGLConfig candidate = configs[static_cast<size_t>(i)];
      const bool fits = std::all_of(wanted.begin(), wanted.end(), [&](const auto& want) {
        EGLint value = -1;
        get_config_attrib_(display_, candidate, want.first, &value);
        return value == want.second;
      });
      if (fits) config_ = candidate;
    }
    check(config_ != nullptr, "eglChooseConfig");
  }

  void check(bool good, const char* call) {
    if (good) return;
    throw std::runtime_error(std::string(call) + " failed, EGL error " +
                             std::to_string(get_error_()));
  }

  const Buffers buffers_;
  void* library_ = nullptr;
  decltype(&eglGetProcAddress) get_proc_address_;
  decltype(&eglGetError) get_error_;
  decltype(&eglGetPlatformDisplay) get_platform_display_;
  decltype(&eglInitialize) initialize_;
  decltype(&eglQueryString) query_string_;
  decltype(&eglChooseConfig) choose_config_;
  decltype(&eglGetConfigAttrib) get_config_attrib_;
  decltype(&eglCreateContext) create_context_;
  decltype(&eglDestroyContext) destroy_context_;
  decltype(&eglCreatePbufferSurface) create_pbuffer_;
  decltype(&eglDestroySurface) destroy_surface_;
  decltype(&eglMakeCurrent) make_current_;
  decltype(&eglTerminate) terminate_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLConfig config_ = nullptr;
  EGLContext context_ = EGL_NO_CONTEXT;
  EGLSurface surface_ = EGL_NO_SURFACE;
  Gl gl_;
  std::string name_;
};

}  // namespace

std::unique_ptr<Implementation> open_through_egl(const Buffers& buffers) {
  return std::make_unique<ThroughEgl>(nullptr, buffers);
}
std::unique_ptr<Implementation> open_through_egl(int samples) {
  return open_through_egl(Buffers{.samples = samples});
}

std::unique_ptr<Implementation> open_mesa_through_egl(const Buffers& buffers) {
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  return std::make_unique<ThroughEgl>("Mesa Project", buffers);
}
std::unique_ptr<Implementation> open_mesa_through_egl(int samples) {
  return open_mesa_through_egl(Buffers{.samples = samples});
}

}  // namespace clearpipe::conformance
