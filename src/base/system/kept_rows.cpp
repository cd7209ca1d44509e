// SPDX-License-Identifier: MIT
#include "base/system/kept_rows.h"

#include <array>
#include <sstream>
#include <system_error>
#include <unistd.h>

#include "base/error.h"
#include "base/hash.h"
#include "base/system/atomic_file.h"
#include "base/system/files.h"

namespace polhode {
namespace {

std::string seal_of(const std::string& row) {
  return content_hash(row).substr(0, 16);
}

// a name that no other running process has, on any machine with the same folder
std::string name_of_process() {
  std::array<char, 256> host = {};
  gethostname(host.data(), host.size() - 1);
  return fmt::format("{}-{}", host.data(), getpid());
}

// the first line of a file; absent: there is no file
std::optional<std::string> first_line(const std::filesystem::path& file) {
  std::error_code missing;
  if (!std::filesystem::exists(file, missing)) return {};
  std::istringstream text(read_file(file));
  std::string line;
  std::getline(text, line);
  return line;
}

}  // namespace

KeptRows::KeptRows(std::filesystem::path file, std::string words, const std::string& part)
    : file_(std::move(file)), words_(std::move(words)), own_(file_) {
  parts_ = aside(words_).filename().string() + ".";
  if (part.empty()) return;
  parts_ += part + ".";
  own_ = file_.parent_path() / (parts_ + name_of_process());
}

std::filesystem::path KeptRows::aside(const std::string& words) const {
  std::filesystem::path name = file_;
  name += "-" + content_hash(words).substr(0, 8);
  return name;
}

std::vector<std::filesystem::path> KeptRows::parts() const {
  const std::filesystem::path folder = file_.has_parent_path() ? file_.parent_path() : ".";
  std::vector<std::filesystem::path> found;
  if (!is_there(folder)) return found;
  for (std::filesystem::path& entry : entries_of(folder)) {
    if (entry.filename().string().starts_with(parts_)) found.push_back(std::move(entry));
  }
  return found;
}

void KeptRows::set_others_aside() const {
  const auto rename = [](const std::filesystem::path& from, const std::filesystem::path& to) {
    std::error_code failed;
    std::filesystem::rename(from, to, failed);
    if (failed) {
      throw environment_error(
          "cannot rename {} to {}: {}", from.string(), to.string(), failed.message());
    }
  };
  std::error_code missing;
  const std::optional<std::string> there = first_line(file_);
  if (there && *there != words_) rename(file_, aside(*there));
  if (there != words_ && std::filesystem::exists(aside(words_), missing))
    rename(aside(words_), file_);
}

void KeptRows::take_from(const std::filesystem::path& file,
                         const std::function<bool(const std::string& line)>& take_up) {
  std::error_code missing;
  if (!std::filesystem::exists(file, missing)) return;
  std::istringstream text(read_file(file));
  std::string line;
  if (!std::getline(text, line) || line != words_) return;
  while (std::getline(text, line)) {
    const std::size_t end = line.rfind(' ');
    if (end == std::string::npos) return;
    const std::string row = line.substr(0, end);
    if (line.substr(end + 1) != seal_of(row) || !take_up(row)) return;
    if (own_ == file_) lines_.append(line).push_back('\n');
  }
}

void KeptRows::load(const std::function<bool(const std::string& line)>& take_up) {
  const bool whole = own_ == file_;
  if (whole) set_others_aside();
  take_from(file_, take_up);
  if (!whole) take_from(aside(words_), take_up);
  for (const std::filesystem::path& part : parts()) {
    if (part.extension() != ".part") take_from(part, take_up);
  }
}

void KeptRows::add(const std::string& line) {
  lines_.append(line).append(" ").append(seal_of(line)).push_back('\n');
  const auto between = std::chrono::seconds(own_ == file_ ? 2 : 30);
  const Clock::time_point now = Clock::now();
  if (saved_ && now - *saved_ <= between) return;
  save();
  saved_ = now;
}

void KeptRows::save() const {
  if (lines_.empty()) return;
  write_file(own_, words_ + '\n' + lines_);
}

void KeptRows::remove() const {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
  for (const std::filesystem::path& part : parts())
    std::filesystem::remove(part, ignored);
}

}  // namespace polhode
