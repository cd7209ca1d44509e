// SPDX-License-Identifier: MIT
#include "base/shipped_files.h"

#include <cstdlib>

namespace polhode {

namespace fs = std::filesystem;

fs::path shipped_files() {
  std::error_code failed;
  const fs::path binary_folder = fs::read_symlink("/proc/self/exe", failed).parent_path();
  const fs::path installed = (binary_folder / "../share/polhode").lexically_normal();
  const fs::path built = binary_folder / "share/polhode";
  return !fs::is_directory(installed, failed) && fs::is_directory(built, failed) ? built
                                                                                 : installed;
}

fs::path shipped_scenes() {
  const char* chosen = std::getenv("POLHODE_SCENES");
  if (chosen != nullptr && *chosen != '\0') return chosen;
  return shipped_files() / "scenes";
}

}  // namespace polhode
