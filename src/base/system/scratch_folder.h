// SPDX-License-Identifier: MIT
// A temporary folder for one run.
#pragma once

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>

#include <sys/stat.h>

#include "base/error.h"
#include "base/system/system_error.h"
#include "base/system/unfinished.h"

namespace polhode {

// Owns a new folder in the system's folder for temporary files, which is the first of TMPDIR, TMP,
// TEMP and TEMPDIR that is set, else /tmp; also /tmp if TMPDIR is empty. The destructor removes it
// with everything in it; failure is ignored. After kill -9 it stays.
class ScratchFolder {
 public:
  // Throws Error (environment) if it cannot be created.
  ScratchFolder() : ScratchFolder(folder_for_all() / "polhode-XXXXXX", "; set TMPDIR") {}
  // One of that name, whose last six letters must be XXXXXX; they are replaced. `advice` ends the
  // message. Throws as system_error() (base/system/system_error.h) does if it cannot be created.
  explicit ScratchFolder(const std::filesystem::path& pattern, const std::string& advice = "") {
    std::string name = pattern.string();
    const Unbroken until_remembered;
    if (mkdtemp(name.data()) == nullptr) {
      const int reason = errno;
      throw Error(advice.empty() ? fault_of(reason) : Fault::environment,
                  fmt::format("cannot make a temporary folder in {}: {}{}",
                              pattern.parent_path().string(),
                              std::strerror(reason),
                              advice));
    }
    chmod(name.c_str(), S_IRWXU);  // whatever the umask
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
  static std::filesystem::path folder_for_all() {
    const char* named = std::getenv("TMPDIR");
    const bool empty = named != nullptr && *named == 0;
    std::error_code failed;
    std::filesystem::path where = empty ? "/tmp" : std::filesystem::temp_directory_path(failed);
    if (failed) {
      throw environment_error("there is no folder {} for temporary files; set TMPDIR",
                              named != nullptr ? named : "/tmp");
    }
    return where;
  }

  std::filesystem::path path_;
  std::optional<Unfinished> unfinished_;
};

}  // namespace polhode
