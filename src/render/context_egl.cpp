// SPDX-License-Identifier: MIT
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "base/error.h"
#include "base/system/shared_library.h"
#include "render/context.h"

namespace polhode {
namespace {

class EglContext final : public Context {
 public:
  EglContext()
      : library_({"libEGL.so.1", "libEGL.so"}),
        get_proc_(library_.function<decltype(eglGetProcAddress)>("eglGetProcAddress")),
        make_current_(library_.function<decltype(eglMakeCurrent)>("eglMakeCurrent")),
        destroy_(library_.function<decltype(eglDestroyContext)>("eglDestroyContext")) {
    const auto get_display =
        library_.function<decltype(eglGetPlatformDisplay)>("eglGetPlatformDisplay");
    display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || library_.function<decltype(eglInitialize)>("eglInitialize")(
                                          display_, nullptr, nullptr) == EGL_FALSE) {
      throw environment_error("EGL has no surfaceless platform");
    }
    try {
      create();
    } catch (...) {
      close();
      throw;
    }
  }
  ~EglContext() override { close(); }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  std::string backend() const override { return "egl"; }
  void* function(const char* name) const override {
    return reinterpret_cast<void*>(get_proc_(name));
  }

 private:
  void create() {
    library_.function<decltype(eglBindAPI)>("eglBindAPI")(EGL_OPENGL_API);
    // no surface is ever bound, so the config must not ask for one (the default asks for a window)
    const EGLint config_attributes[] = {
        EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    library_.function<decltype(eglChooseConfig)>("eglChooseConfig")(
        display_, config_attributes, &config, 1, &count);
    if (count < 1) throw environment_error("EGL has no configuration for OpenGL");
    const EGLint context_attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                         3,
                                         EGL_CONTEXT_MINOR_VERSION,
                                         3,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                         EGL_NONE};
    context_ = library_.function<decltype(eglCreateContext)>("eglCreateContext")(
        display_, config, EGL_NO_CONTEXT, context_attributes);
    if (context_ == EGL_NO_CONTEXT) {
      throw environment_error("EGL gives no OpenGL 3.3 core context");
    }
    if (make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
      throw environment_error("EGL cannot make a context current without a surface");
    }
  }

  void close() {
    make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) destroy_(display_, context_);
    // the display is one for the whole process and stays: ending it would unload the driver under
    // its own threads
  }

  SharedLibrary library_;
  decltype(eglGetProcAddress)* get_proc_;
  decltype(eglMakeCurrent)* make_current_;
  decltype(eglDestroyContext)* destroy_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> open_egl() {
  return std::make_unique<EglContext>();
}

}  // namespace polhode
