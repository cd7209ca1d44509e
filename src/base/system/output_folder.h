// SPDX-License-Identifier: MIT
// A folder whose files are replaced together.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/system/atomic_file.h"

namespace polhode {

// Invariant: the files keep their old content until commit(), so a run that fails or is interrupted
// changes none of them. The files are locked, so two runs cannot write the same folder.
class OutputFolder {
 public:
  // Creates the folder if needed and claims a file for each of `names`. Throws Error (input) as
  // AtomicFile does, or naming `option` if the folder cannot be created.
  OutputFolder(const std::filesystem::path& folder,
               const std::vector<std::string>& names,
               const char* option = "--output");
  // Writes one content per name, in the order of `names`. Throws Error (environment) as AtomicFile
  // does.
  void commit(const std::vector<std::string>& contents);

 private:
  std::vector<std::unique_ptr<AtomicFile>> files_;
};

// `asked`, or output/SCENE_what if that is empty, where SCENE is the file name of `scene` without
// its ending.
std::filesystem::path folder_or_default(const std::string& asked,
                                        const std::filesystem::path& scene,
                                        const std::string& what);

}  // namespace polhode
