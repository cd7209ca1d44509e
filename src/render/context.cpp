// SPDX-License-Identifier: MIT
#include "render/context.h"

#include <cstdlib>

#include <sys/resource.h>

#include "base/error.h"
#include "base/nearest.h"
#include "base/system/log.h"

namespace polhode {

const std::vector<Backend>& backends() {
  static const std::vector<Backend> table = {
      {"osmesa", "Mesa's off-screen library (libOSMesa)", open_osmesa},
      {"egl", "EGL on the surfaceless platform (libEGL)", open_egl},
  };
  return table;
}

std::vector<std::string> backend_names() {
  std::vector<std::string> names = {"auto"};
  for (const Backend& backend : backends())
    names.push_back(backend.name);
  return names;
}

namespace {

// Mesa's software rasteriser crashes when it finds no memory, and says nothing
void refuse_little_memory() {
  constexpr rlim_t kLeast = rlim_t{768} << 20;
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur >= kLeast) return;
  throw environment_error("out of memory: the limit is {} MB (ulimit -v), and drawing needs {} MB",
                          limit.rlim_cur >> 20,
                          kLeast >> 20);
}

}  // namespace

std::unique_ptr<Context> open_context(const std::string& name) {
  refuse_little_memory();
  // what is wrong is told in our own words
  setenv("EGL_LOG_LEVEL", "fatal", 0);
  std::string reasons;
  for (const Backend& backend : backends()) {
    if (name == backend.name) return backend.open();
    if (name != "auto") continue;
    try {
      return backend.open();
    } catch (const Error& error) {
      spdlog::info("back end {}: {}", backend.name, error.what());
      reasons += fmt::format("{}{}: {}", reasons.empty() ? "" : "; ", backend.name, error.what());
    }
  }
  if (name != "auto") {
    throw input_error("unknown back end '{}'{}", name, suggestion(name, backend_names()))
        .at({{}, 0, "--backend"});
  }
  throw environment_error(
      "OpenGL without a window is not available: {} (Debian: libosmesa6, or libegl1 with "
      "libgl1-mesa-dri)",
      reasons);
}

}  // namespace polhode
