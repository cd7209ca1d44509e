// SPDX-License-Identifier: MIT
#include "base/system/output_folder.h"

#include <map>

#include "base/check.h"
#include "base/error.h"
#include "base/system/files.h"

namespace polhode {

OutputFolder::OutputFolder(const std::filesystem::path& folder,
                           const std::vector<std::string>& names,
                           const char* option) {
  make_folder(folder, {{}, 0, option});
  for (const std::string& name : names)
    files_.push_back(std::make_unique<AtomicFile>(folder / name));
}

void OutputFolder::write(const std::vector<std::string>& contents) {
  CHECK(contents.size() == files_.size());
  for (std::size_t i = 0; i < contents.size(); ++i)
    files_[i]->write(contents[i]);
}

void OutputFolder::commit() {
  for (const std::unique_ptr<AtomicFile>& file : files_)
    file->commit();
}

void OutputFolder::commit(const std::vector<std::string>& contents) {
  write(contents);
  commit();
}

std::filesystem::path folder_or_default(const std::string& asked,
                                        const std::filesystem::path& scene,
                                        const std::string& what) {
  if (!asked.empty()) return asked;
  return std::filesystem::path("output") / (scene.stem().string() + "_" + what);
}

void refuse_same_stem(const std::vector<std::filesystem::path>& scenes) {
  std::map<std::string, const std::filesystem::path*> by_name;
  for (const std::filesystem::path& scene : scenes) {
    const std::string name = scene.stem().string();
    const auto [place, is_new] = by_name.emplace(name, &scene);
    if (is_new) continue;
    throw input_error("{} and {} are both called '{}' in the results; rename one of them",
                      place->second->string(),
                      scene.string(),
                      name);
  }
}

}  // namespace polhode
