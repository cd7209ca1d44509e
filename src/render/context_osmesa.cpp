// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <GL/osmesa.h>

#include "base/error.h"
#include "base/system/shared_library.h"
#include "render/context.h"

namespace polhode {
namespace {

// glFlush copies the whole user buffer, so it is tiny; pictures are drawn into framebuffer objects
constexpr int kBufferSide = 16;  // pixels
constexpr std::size_t kBufferBytes = std::size_t{4} * kBufferSide * kBufferSide;

// OSMesa crashes if the environment asks for a driver that it does not have
void refuse_other_drivers() {
  const char* asked = std::getenv("GALLIUM_DRIVER");
  if (asked == nullptr) return;
  const std::string_view driver = asked;
  if (driver.empty() || driver == "llvmpipe" || driver == "softpipe") return;
  throw environment_error(
      "GALLIUM_DRIVER is '{}', and OSMesa has llvmpipe and softpipe; unset GALLIUM_DRIVER", driver);
}

class OsmesaContext final : public Context {
 public:
  OsmesaContext()
      : library_({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}),
        destroy_(library_.function<decltype(OSMesaDestroyContext)>("OSMesaDestroyContext")),
        get_proc_(library_.function<decltype(OSMesaGetProcAddress)>("OSMesaGetProcAddress")) {
    const auto create =
        library_.function<decltype(OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
    const auto make_current = library_.function<decltype(OSMesaMakeCurrent)>("OSMesaMakeCurrent");
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              0,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    context_ = create(attributes, nullptr);
    if (context_ == nullptr) throw environment_error("OSMesa gives no OpenGL 3.3 core context");
    if (make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, kBufferSide, kBufferSide) == 0) {
      destroy_(context_);
      throw environment_error("OSMesa cannot make its context current");
    }
  }
  ~OsmesaContext() override { destroy_(context_); }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  std::string backend() const override { return "osmesa"; }
  void* function(const char* name) const override {
    return reinterpret_cast<void*>(get_proc_(name));
  }

 private:
  SharedLibrary library_;
  decltype(OSMesaDestroyContext)* destroy_;
  decltype(OSMesaGetProcAddress)* get_proc_;
  OSMesaContext context_ = nullptr;
  std::array<std::uint8_t, kBufferBytes> buffer_{};
};

}  // namespace

std::unique_ptr<Context> open_osmesa() {
  refuse_other_drivers();
  return std::make_unique<OsmesaContext>();
}

}  // namespace polhode
