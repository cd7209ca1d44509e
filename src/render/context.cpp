// SPDX-License-Identifier: MIT
#include "render/context.h"

#include <algorithm>
#include <cstdlib>
#include <latch>
#include <string_view>
#include <system_error>
#include <thread>
#include <unistd.h>

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

// Mesa's software rasteriser crashes when it finds no memory, and says nothing. Each thread of it
// takes a stack and an arena of its own: with 2 threads it crashed up to 1020 MiB, with 16 up to
// 1400.
void refuse_little_memory() {
  constexpr rlim_t kBase = 992, kOfThread = 32;  // MiB
  constexpr unsigned kMostThreads = 32;          // of Mesa
  const unsigned threads = std::min(std::thread::hardware_concurrency(), kMostThreads);
  const rlim_t least = (kBase + kOfThread * threads) << 20;
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur >= least) return;
  throw environment_error("out of memory: the limit is {} MB (ulimit -v), and drawing needs {} MB",
                          limit.rlim_cur >> 20,
                          least >> 20);
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

// Variables that are set for those who debug Mesa: with them it stops, crashes, writes files, draws
// less or otherwise, and mostly without a word. Those that choose drivers, processors and caches
// are none.
std::vector<std::string> debugging_variables() {
  constexpr std::string_view kHeads[] = {"DRAW_",
                                         "GALLIUM_",
                                         "GALLIVM_",
                                         "LP_",
                                         "MESA_",
                                         "NIR_",
                                         "SOFTPIPE_",
                                         "ST_",
                                         "TGSI_",
                                         "allow_glsl_",
                                         "disable_",
                                         "force_gl",
                                         "glsl_",
                                         "pp_"};
  constexpr std::string_view kKept[] = {"GALLIUM_DRIVER",
                                        "GALLIUM_NOSSE",
                                        "GALLIUM_OVERRIDE_CPU_CAPS",
                                        "LP_NATIVE_VECTOR_WIDTH",
                                        "LP_NUM_THREADS",
                                        "MESA_D3D12_",
                                        "MESA_DISK_CACHE_",
                                        "MESA_GLSL_CACHE_",
                                        "MESA_LOADER_DRIVER_OVERRIDE",
                                        "MESA_SHADER_CACHE_",
                                        "MESA_VK_"};
  const auto begins = [](std::string_view name, const auto& heads) {
    return std::any_of(std::begin(heads), std::end(heads), [&](std::string_view head) {
      return name.starts_with(head);
    });
  };
  std::vector<std::string> names;
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string_view setting = *entry;
    const std::string_view name = setting.substr(0, setting.find('='));
    if (begins(name, kHeads) && !begins(name, kKept)) names.emplace_back(name);
  }
  return names;
}

// Mesa crashes at vectors that the processor lacks, and at longer ones on some that have them
void refuse_other_vectors() {
  const char* asked = std::getenv("LP_NATIVE_VECTOR_WIDTH");
  if (asked == nullptr) return;
  const std::string_view width = asked;
  bool is_safe = width == "128";
#ifdef __x86_64__
  is_safe = is_safe || (width == "256" && __builtin_cpu_supports("avx") != 0);
#endif
  if (is_safe) return;
  throw environment_error(
      "LP_NATIVE_VECTOR_WIDTH is '{}'; Mesa draws with 128, and with 256 where the processor has "
      "AVX; unset it",
      width);
}

}  // namespace

void settle_mesa() {
  // what is wrong is told in our own words
  setenv("EGL_LOG_LEVEL", "fatal", 0);
  for (const std::string& name : debugging_variables())
    unsetenv(name.c_str());
}

std::unique_ptr<Context> open_context(const std::string& name) {
  refuse_little_memory();
  refuse_few_threads();
  refuse_other_vectors();
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
