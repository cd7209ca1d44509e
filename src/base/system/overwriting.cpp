// SPDX-License-Identifier: MIT
#include "base/system/overwriting.h"

#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include <sys/stat.h>

#include "base/error.h"

namespace polhode {
namespace {

// what a file is, whatever its path: device and inode
using FileId = std::pair<dev_t, ino_t>;

std::optional<FileId> id_of(const std::filesystem::path& file) {
  struct stat status = {};
  if (stat(file.c_str(), &status) != 0) return std::nullopt;
  return FileId(status.st_dev, status.st_ino);
}

// 0 to 2 as long as they are files: of pipes and terminals nothing can be replaced
std::optional<FileId> id_of_stream(int descriptor) {
  struct stat status = {};
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return FileId(status.st_dev, status.st_ino);
}

// Whoever sent a stream into a file wants what all commands write there.
void refuse_own_stream(const FileId& id, const std::filesystem::path& target) {
  constexpr const char* kStreams[] = {"standard input", "standard output", "standard error"};
  for (int descriptor = 0; descriptor < 3; ++descriptor) {
    if (id_of_stream(descriptor) != id) continue;
    throw input_error("would replace the file of {}; choose another output (standard output is -)",
                      kStreams[descriptor])
        .at({target.string(), 0, {}});
  }
}

struct Protected {
  std::mutex lock;
  std::map<FileId, std::filesystem::path> files;  // as they were named
};

Protected& protected_files() {
  static Protected all;
  return all;
}

}  // namespace

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

void protect_file(const std::filesystem::path& file) {
  const std::optional<FileId> id = id_of(file);
  if (!id) return;
  Protected& all = protected_files();
  const std::lock_guard guard(all.lock);
  all.files[*id] = file;
}

void refuse_protected_file(const std::filesystem::path& target) {
  const std::optional<FileId> id = id_of(target);
  if (!id) return;
  refuse_own_stream(*id, target);
  Protected& all = protected_files();
  const std::lock_guard guard(all.lock);
  const auto found = all.files.find(*id);
  // the number of a file that has been deleted meanwhile may be that of another one
  if (found == all.files.end() || id_of(found->second) != id) return;
  throw input_error("would overwrite {}; choose another name", found->second.string())
      .at({target.string(), 0, {}});
}

}  // namespace polhode
