// SPDX-License-Identifier: MIT
#include "base/atomic_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#include "base/error.h"

namespace polhode {
namespace fs = std::filesystem;
namespace {

fs::path part_of(const fs::path& target) {
  fs::path part = target;
  part += ".part";
  return part;
}

}  // namespace

AtomicFile::AtomicFile(fs::path target) : target_(std::move(target)), part_(part_of(target_)) {
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    throw input_error("the folder '{}' does not exist; create it or choose another output",
                      folder.string())
        .at({target_.string(), 0, {}});
  }
  if (fs::is_directory(target_, ignored)) {
    throw input_error("is a folder; give a file name").at({target_.string(), 0, {}});
  }

  // claim the temporary name now, so that an unwritable folder is told before any work is done
  std::FILE* file = std::fopen(part_.c_str(), "wb");
  if (file == nullptr) {
    throw input_error("cannot write here ({}); choose another output", std::strerror(errno))
        .at({target_.string(), 0, {}});
  }
  std::fclose(file);
}

AtomicFile::~AtomicFile() {
  if (committed_) return;
  std::error_code ignored;
  fs::remove(part_, ignored);
}

void AtomicFile::commit() {
  std::error_code failed;
  fs::rename(part_, target_, failed);
  if (failed) {
    throw environment_error("cannot rename the finished file: {}", failed.message())
        .at({target_.string(), 0, {}});
  }
  committed_ = true;
}

void write_file(const fs::path& target, std::string_view content) {
  AtomicFile file(target);
  std::FILE* out = std::fopen(file.part().c_str(), "wb");
  const bool written = out != nullptr &&
                       std::fwrite(content.data(), 1, content.size(), out) == content.size() &&
                       std::fflush(out) == 0;
  const int reason = errno;
  const bool closed = out != nullptr && std::fclose(out) == 0;
  if (!written || !closed) {
    throw environment_error("cannot write: {}", std::strerror(written ? errno : reason))
        .at({target.string(), 0, {}});
  }
  file.commit();
}

std::string read_file(const fs::path& path, std::size_t most) {
  const Place place{path.string(), 0, {}};
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw input_error("no such file").at(place);
  if (fs::is_directory(path, ignored)) throw input_error("is a folder; give a file").at(place);
  std::ifstream in(path, std::ios::binary);
  if (!in) throw input_error("cannot be read ({})", std::strerror(errno)).at(place);

  // block by block, to stop at the limit
  std::string content;
  std::array<char, 65536> block{};
  while (in.read(block.data(), block.size()), in.gcount() > 0) {
    content.append(block.data(), static_cast<std::size_t>(in.gcount()));
    if (content.size() > most) {
      throw input_error("holds more than {} bytes; is this the right file?", most).at(place);
    }
  }
  if (in.bad()) throw input_error("cannot be read").at(place);
  return content;
}

}  // namespace polhode
