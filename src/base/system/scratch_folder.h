// SPDX-License-Identifier: MIT
// A temporary folder for one run.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "base/error.h"
#include "base/system/unfinished.h"

namespace polhode {

// Owns a new folder in the system's folder for temporary files, which is the first of TMPDIR, TMP,
// TEMP and TEMPDIR that is set, else /tmp. The destructor removes it with everything in it; failure
// is ignored.
class ScratchFolder {
 public:
  // Throws Error (environment) if it cannot be created.
  ScratchFolder() {
    std::error_code failed;
    std::string name = (std::filesystem::temp_directory_path(failed) / "polhode-XXXXXX").string();
    if (failed || mkdtemp(name.data()) == nullptr) {
      throw environment_error("cannot make a temporary folder '{}'; set TMPDIR", name);
    }
    path_ = name;
    unfinished_.emplace(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  // The path of a file of that name in the folder; the file need not exist.
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
  std::optional<Unfinished> unfinished_;
};

}  // namespace polhode
