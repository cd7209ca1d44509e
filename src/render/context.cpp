// SPDX-License-Identifier: MIT
#include "render/context.h"

#include <cstdlib>
#include <latch>
#include <system_error>
#include <thread>

#include <sys/resource.h>

#include "base/error.h"
#include "base/nearest.h"
#include "base/system/log.h"
#include "render/shader_cache.h"

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

// Mesa waits for ever for a thread of its own that could not be started
void refuse_few_threads() {
  constexpr unsigned kBesideOnePerCore = 8;
  const unsigned wanted = std::thread::hardware_concurrency() + kBesideOnePerCore;
  std::vector<std::thread> threads;
  std::latch all_started(1);
  bool enough = true;
  try {
    while (threads.size() < wanted)
      threads.emplace_back([&] { all_started.wait(); });
  } catch (const std::system_error&) {
    enough = false;
  }
  all_started.count_down();
  for (std::thread& thread : threads)
    thread.join();
  if (enough) return;
  throw environment_error(
      "no more than {} threads can be started, and drawing needs {} (ulimit -u, or the limit of a "
      "container)",
      threads.size(),
      wanted);
}

}  // namespace

void settle_mesa() {
  // what is wrong is told in our own words
  setenv("EGL_LOG_LEVEL", "fatal", 0);
  // shaders of another version than ours and extensions that are taken away crash Mesa, or are
  // refused; what is for those who debug it stops it, or draws less without a word
  for (const char* name : {"MESA_GLSL_VERSION_OVERRIDE",
                           "MESA_GL_VERSION_OVERRIDE",
                           "MESA_EXTENSION_OVERRIDE",
                           "GALLIUM_TRACE",
                           "LP_PERF",
                           "ST_DEBUG",
                           "DRAW_USE_LLVM"})
    unsetenv(name);
}

std::unique_ptr<Context> open_context(const std::string& name) {
  refuse_little_memory();
  refuse_few_threads();
  leave_full_shader_cache();
  settle_mesa();
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
