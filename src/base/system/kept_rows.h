// SPDX-License-Identifier: MIT
// Results that a run which is stopped leaves behind for the next one, a line of text for each.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

namespace polhode {

// The file is written now and then while lines are added, whole each time. Not for several threads
// at once. All throw Error (environment) when the file cannot be written.
class KeptRows {
 public:
  // `words`: one line that says what the run was asked for; rows of other words are not taken up.
  KeptRows(std::filesystem::path file, std::string words);

  // Gives the lines of an earlier run to `take_up`, until it refuses one.
  void load(const std::function<bool(const std::string& line)>& take_up);
  void add(const std::string& line);
  void save() const;
  void remove() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::filesystem::path file_;
  std::string words_;
  std::string lines_;
  Clock::time_point saved_ = Clock::now();
};

}  // namespace polhode
