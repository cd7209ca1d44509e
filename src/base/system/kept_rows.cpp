// SPDX-License-Identifier: MIT
#include "base/system/kept_rows.h"

#include <sstream>
#include <system_error>

#include "base/error.h"
#include "base/hash.h"
#include "base/system/atomic_file.h"

namespace polhode {
namespace {

std::string seal_of(const std::string& row) {
  return content_hash(row).substr(0, 16);
}

}  // namespace

KeptRows::KeptRows(std::filesystem::path file, std::string words)
    : file_(std::move(file)), words_(std::move(words)) {}

std::filesystem::path KeptRows::aside(const std::string& words) const {
  std::filesystem::path name = file_;
  name += "-" + content_hash(words).substr(0, 8);
  return name;
}

void KeptRows::load(const std::function<bool(const std::string& line)>& take_up) {
  std::error_code missing;
  const auto first_line = [&]() -> std::optional<std::string> {
    if (!std::filesystem::exists(file_, missing)) return {};
    std::istringstream text(read_file(file_));
    std::string line;
    std::getline(text, line);
    return line;
  };
  const auto rename = [](const std::filesystem::path& from, const std::filesystem::path& to) {
    std::error_code failed;
    std::filesystem::rename(from, to, failed);
    if (failed) {
      throw environment_error(
          "cannot rename {} to {}: {}", from.string(), to.string(), failed.message());
    }
  };
  const std::optional<std::string> there = first_line();
  if (there && *there != words_) rename(file_, aside(*there));
  if (there != words_ && std::filesystem::exists(aside(words_), missing))
    rename(aside(words_), file_);
  if (!std::filesystem::exists(file_, missing)) return;

  std::istringstream text(read_file(file_));
  std::string line;
  if (!std::getline(text, line) || line != words_) return;
  while (std::getline(text, line)) {
    const std::size_t end = line.rfind(' ');
    if (end == std::string::npos) return;
    const std::string row = line.substr(0, end);
    if (line.substr(end + 1) != seal_of(row) || !take_up(row)) return;
    lines_.append(line).push_back('\n');
  }
}

void KeptRows::add(const std::string& line) {
  lines_.append(line).append(" ").append(seal_of(line)).push_back('\n');
  constexpr auto kBetween = std::chrono::seconds(2);
  const Clock::time_point now = Clock::now();
  if (saved_ && now - *saved_ <= kBetween) return;
  save();
  saved_ = now;
}

void KeptRows::save() const {
  write_file(file_, words_ + '\n' + lines_);
}

void KeptRows::remove() const {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

}  // namespace polhode
