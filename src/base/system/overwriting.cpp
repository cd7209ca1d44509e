// SPDX-License-Identifier: MIT
#include "base/system/overwriting.h"

#include "base/error.h"

namespace polhode {

void refuse_same_file(const std::string& written,
                      const std::string& what,
                      const std::filesystem::path& needed) {
  if (written.empty()) return;
  if (written.ends_with(".toml")) {
    throw input_error("{} '{}' has the ending of scene files; choose another name", what, written);
  }
  std::error_code ignored;
  if (std::filesystem::path(written).lexically_normal() != needed.lexically_normal() &&
      !std::filesystem::equivalent(written, needed, ignored)) {
    return;
  }
  throw input_error("{} would overwrite {}; choose another name", what, needed.string());
}

}  // namespace polhode
