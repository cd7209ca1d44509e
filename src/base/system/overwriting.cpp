// SPDX-License-Identifier: MIT
#include "base/system/overwriting.h"

#include "base/error.h"

namespace polhode {

void refuse_same_file(const std::string& written,
                      const std::string& what,
                      const std::vector<std::filesystem::path>& needed) {
  if (written.ends_with(".toml")) {
    throw input_error("{} '{}' has the ending of scene files; choose another name", what, written);
  }
  refuse_needed_file(written, what, needed);
}

void refuse_needed_file(const std::string& written,
                        const std::string& what,
                        const std::vector<std::filesystem::path>& needed) {
  if (written.empty()) return;
  const auto are_the_same = [](const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code ignored;
    return a.lexically_normal() == b.lexically_normal() ||
           std::filesystem::equivalent(a, b, ignored);
  };
  for (const std::filesystem::path& file : needed) {
    if (are_the_same(written, file) || are_the_same(written + ".part", file))
      throw input_error("{} would overwrite {}; choose another name", what, file.string());
  }
}

void refuse_same_files(const std::filesystem::path& folder,
                       const std::vector<std::string>& names,
                       const std::vector<std::filesystem::path>& needed) {
  for (const std::string& name : names)
    refuse_same_file(folder / name, "--output", needed);
}

}  // namespace polhode
