// SPDX-License-Identifier: MIT
#include "render/shader_cache.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <pwd.h>
#include <string>
#include <unistd.h>

#include "base/system/log.h"

namespace polhode {
namespace {

// where Mesa looks for it, in this order
std::filesystem::path cache_folder() {
  for (const char* name : {"MESA_SHADER_CACHE_DIR", "MESA_GLSL_CACHE_DIR", "XDG_CACHE_HOME"}) {
    const char* folder = std::getenv(name);
    if (folder != nullptr) return folder;
  }
  const passwd* user = getpwuid(getuid());
  return user == nullptr ? "" : std::filesystem::path(user->pw_dir) / ".cache";
}

// Only writing tells: a quota leaves free blocks that are not for us. Where no file can be made,
// Mesa has no cache either.
bool is_full(std::filesystem::path folder) {
  constexpr off_t kIndex = 2 << 20;  // bytes; Mesa 22.3 maps 1.3e6
  std::error_code ignored;
  while (folder.has_relative_path() && !std::filesystem::is_directory(folder, ignored))
    folder = folder.parent_path();
  std::string name = (folder / ".polhode-XXXXXX").string();
  const int file = mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) return false;
  unlink(name.c_str());
  const int failed = posix_fallocate(file, 0, kIndex);
  close(file);
  return failed == ENOSPC || failed == EDQUOT || failed == EFBIG;
}

}  // namespace

void leave_full_shader_cache() {
  const std::filesystem::path folder = cache_folder();
  if (!is_full(folder)) return;
  spdlog::info("no room for Mesa's shader cache in {}", folder.string());
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
}

}  // namespace polhode
