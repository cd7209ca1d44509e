// SPDX-License-Identifier: MIT
#include "base/system/output_folder.h"

#include "base/check.h"
#include "base/error.h"

namespace polhode {

OutputFolder::OutputFolder(const std::filesystem::path& folder,
                           const std::vector<std::string>& names,
                           const char* option) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure || !std::filesystem::is_directory(folder)) {
    throw input_error("cannot make the folder '{}': {}",
                      folder.string(),
                      failure ? failure.message() : "there is a file of that name")
        .at({{}, 0, option});
  }
  for (const std::string& name : names)
    files_.push_back(std::make_unique<AtomicFile>(folder / name));
}

void OutputFolder::commit(const std::vector<std::string>& contents) {
  CHECK(contents.size() == files_.size());
  for (std::size_t i = 0; i < contents.size(); ++i)
    files_[i]->commit_with(contents[i]);
}

std::filesystem::path folder_or_default(const std::string& asked,
                                        const std::filesystem::path& scene,
                                        const std::string& what) {
  if (!asked.empty()) return asked;
  return std::filesystem::path("output") / (scene.stem().string() + "_" + what);
}

}  // namespace polhode
