// SPDX-License-Identifier: MIT
#include "base/system/kept_rows.h"

#include <sstream>
#include <system_error>

#include "base/system/atomic_file.h"

namespace polhode {

KeptRows::KeptRows(std::filesystem::path file, std::string words)
    : file_(std::move(file)), words_(std::move(words)) {}

void KeptRows::load(const std::function<bool(const std::string& line)>& take_up) {
  std::error_code missing;
  if (!std::filesystem::exists(file_, missing)) return;
  std::istringstream text(read_file(file_));
  std::string line;
  if (!std::getline(text, line) || line != words_) return;
  while (std::getline(text, line) && take_up(line))
    lines_.append(line).push_back('\n');
}

void KeptRows::add(const std::string& line) {
  lines_.append(line).push_back('\n');
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
