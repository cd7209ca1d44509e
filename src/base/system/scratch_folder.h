// SPDX-License-Identifier: MIT
// A folder for what only this run needs.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/error.h"

namespace polhode {

// Made where the system keeps temporary files (TMPDIR, else /tmp), removed with everything in it.
class ScratchFolder {
 public:
  // Throws Error (environment) when it cannot be made.
  ScratchFolder() {
    std::error_code failed;
    std::string name = (std::filesystem::temp_directory_path(failed) / "polhode-XXXXXX").string();
    if (failed || mkdtemp(name.data()) == nullptr) {
      throw environment_error("cannot make a temporary folder '{}'; set TMPDIR", name);
    }
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace polhode
