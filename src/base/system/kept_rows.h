// SPDX-License-Identifier: MIT
// Keeps the finished results of a long run in a file, one line each, so that an interrupted run can
// be continued.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace polhode {

// While lines are added, the whole file is rewritten atomically: with the first line, then at most
// every two seconds, so call save() at the end. Not thread-safe. add() and save() throw Error as
// write_file does.
class KeptRows {
 public:
  // `words`: one line that describes the job, the first of the file. Rows kept by a run with other
  // words are ignored.
  KeptRows(std::filesystem::path file, std::string words);

  // Passes the lines of an earlier run to `take_up`, in order. The first line for which it returns
  // false and all later ones are discarded. Does nothing if there is no file. Throws Error as
  // read_file does.
  void load(const std::function<bool(const std::string& line)>& take_up);
  // Appends a line, given without its line break.
  void add(const std::string& line);
  // Writes the file now.
  void save() const;
  // Deletes the file, after a complete run; failure is ignored.
  void remove() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::filesystem::path file_;
  std::string words_;
  std::string lines_;
  std::optional<Clock::time_point> saved_;
};

}  // namespace polhode
