// SPDX-License-Identifier: MIT
#include "base/system/overwriting.h"

#include "base/error.h"

namespace polhode {

void refuse_same_file(const std::string& written,
                      const std::string& what,
                      const std::vector<std::filesystem::path>& needed) {
  if (written.empty()) return;
  if (written.ends_with(".toml")) {
    throw input_error("{} '{}' has the ending of scene files; choose another name", what, written);
  }
  for (const std::filesystem::path& file : needed) {
    std::error_code ignored;
    if (std::filesystem::path(written).lexically_normal() != file.lexically_normal() &&
        !std::filesystem::equivalent(written, file, ignored)) {
      continue;
    }
    throw input_error("{} would overwrite {}; choose another name", what, file.string());
  }
}

}  // namespace polhode
