// SPDX-License-Identifier: MIT
// An output folder whose files are replaced together, at the end of a run.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/system/atomic_file.h"

namespace polhode {

// Invariant: the files keep their old content until commit(), so a run that fails or is interrupted
// before it changes none of them. The files are locked, so two runs cannot write the same files.
class OutputFolder {
 public:
  // Creates the folder if needed and claims a file for each of `names` in it. Throws Error
  // as AtomicFile does, and with `option`, the option that names the folder, as key if the folder
  // cannot be created.
  OutputFolder(const std::filesystem::path& folder,
               const std::vector<std::string>& names,
               const char* option = "--output");
  // Writes one content for each of `names`, in their order, for commit(). Throws Error
  // (environment) if a file cannot be written.
  void write(const std::vector<std::string>& contents);
  // Gives what is written the names of the files. Call it once. Throws Error (environment) if the
  // disk tells so late that it is full; the files before have their names then.
  void commit();
  // Calls write(), then commit(): if one file cannot be written, all keep their old content.
  void commit(const std::vector<std::string>& contents);

 private:
  std::vector<std::unique_ptr<AtomicFile>> files_;
};

// The folder of a command's results: `asked`, or, if that is empty, output/SCENE_what, where SCENE
// is the file name of `scene` without its ending ("output/top_chart" for top.toml and "chart").
std::filesystem::path folder_or_default(const std::string& asked,
                                        const std::filesystem::path& scene,
                                        const std::string& what);

// Throws Error (input), without a place, if two of the files have the same name without folder and
// ending, by which results are told apart. The message names both.
void refuse_same_stem(const std::vector<std::filesystem::path>& scenes);

}  // namespace polhode
