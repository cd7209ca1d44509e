// SPDX-License-Identifier: MIT
// Keeps the finished results of a long run in a file, one line each, so that an interrupted run can
// be continued. Each line ends with a hash of what is before it: what was changed since is not
// believed.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace polhode {

// The lines are kept in memory. add() also rewrites the whole file atomically: for the first line
// added, then at most every two seconds. Call save() before an early end of the run, so that the
// lines added since the last rewrite are not lost. Not thread-safe. add() and save() throw Error as
// write_file does.
class KeptRows {
 public:
  // Does not touch the file yet. `words`: one line that describes the job, with everything that its
  // results depend on. It is the first line of the file.
  KeptRows(std::filesystem::path file, std::string words);

  // Passes the lines of an earlier run, without line breaks, to `take_up` in their order. Those for
  // which it returns true are kept, as if they had been added; the first one for which it returns
  // false, or whose hash is wrong, and all later ones are discarded. Call it before add(). Does
  // nothing if there is no file. A file of another job is set aside under a name of its own, where
  // load() finds it when that job is run again. Throws Error (input) as read_file does,
  // (environment) if the file cannot be set aside, and what `take_up` throws.
  void load(const std::function<bool(const std::string& line)>& take_up);
  // Appends a line, given without its line break.
  void add(const std::string& line);
  // Writes the file now.
  void save() const;
  // Deletes the file, after a complete run; failure is ignored.
  void remove() const;

 private:
  using Clock = std::chrono::steady_clock;
  // where the work of the job with these words waits while another one is run in the folder
  std::filesystem::path aside(const std::string& words) const;

  std::filesystem::path file_;
  std::string words_;
  std::string lines_;
  std::optional<Clock::time_point> saved_;
};

}  // namespace polhode
