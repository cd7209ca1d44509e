// SPDX-License-Identifier: MIT
// A folder of files that are made together.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/system/atomic_file.h"

namespace polhode {

// Made when it is missing. Its files keep their old content until commit(): a run that fails or is
// interrupted changes none, and two runs on the same folder do not mix.
class OutputFolder {
 public:
  // Throws Error (input) as AtomicFile does, before any work is done.
  // `option` is the one that named the folder, for messages.
  OutputFolder(const std::filesystem::path& folder,
               const std::vector<std::string>& names,
               const char* option = "--output");
  // One content per name, in their order.
  void commit(const std::vector<std::string>& contents);

 private:
  std::vector<std::unique_ptr<AtomicFile>> files_;
};

// The folder that is asked for, else output/SCENE_what.
std::filesystem::path folder_or_default(const std::string& asked,
                                        const std::filesystem::path& scene,
                                        const std::string& what);

}  // namespace polhode
