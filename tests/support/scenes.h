// SPDX-License-Identifier: MIT
// The shipped scenes.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace polhode::test {

inline std::string scene_path(const std::string& name) {
  return POLHODE_SOURCE_DIR "/scenes/" + name + ".toml";
}

// The names of all of them, in order.
inline std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(POLHODE_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace polhode::test
