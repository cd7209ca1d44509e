// SPDX-License-Identifier: MIT
// Keeps the finished results of a long run in a file, one line each, so that an interrupted run can
// be continued, and so that several runs can make one result together. Each line ends with a hash
// of what is before it: what was changed since is not believed.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

// The lines are kept in memory. add() also rewrites the whole file atomically: for the first line
// added, then at most every two seconds, every 30 if many runs may do so in the same folder. Call
// save() before the end of the run, so that the lines added since the last rewrite are not lost.
// Not thread-safe. add() and save() throw Error as write_file does.
class KeptRows {
 public:
  // Does not touch the file yet. `words`: one line that describes the job, with everything that its
  // results depend on. It is the first line of the file. `part`: names the part of the job that
  // this run makes, such as "2-of-8"; its lines go to a file of their own beside FILE, called
  // FILE-HASH.PART.HOST-PROCESS, so that runs on any machines disturb neither each other nor a
  // run of theirs that is believed dead. Empty: the whole job.
  KeptRows(std::filesystem::path file, std::string words, const std::string& part = "");

  // Passes the lines of earlier runs of the job and of runs of its parts (to a part: of earlier
  // runs of that part), without line breaks, to `take_up`, file by file in their order; a line may
  // come more than once. Those for which it returns true are kept, by the whole job as if they had
  // been added; the first one for which it returns false, or whose hash is wrong, and all later
  // ones of that file are discarded. Call it before add(). Does nothing if there is no file. FILE,
  // if it is of another job, is set aside under a name of its own (not by the run of a part), where
  // load() finds it when that job is run again. Throws Error (input) as read_file does,
  // (environment) if the file cannot be set aside, and what `take_up` throws.
  void load(const std::function<bool(const std::string& line)>& take_up);
  // Appends a line, given without its line break.
  void add(const std::string& line);
  // Writes the file now, unless there are no lines.
  void save() const;
  // Deletes the file and those of the parts of the job, after a complete run; failure is ignored.
  void remove() const;

 private:
  using Clock = std::chrono::steady_clock;
  // where the work of the job with these words waits while another one is run in the folder
  std::filesystem::path aside(const std::string& words) const;
  // the files of the parts of this job, or of this part, also unfinished ones
  std::vector<std::filesystem::path> parts() const;
  void set_others_aside() const;
  void take_from(const std::filesystem::path& file,
                 const std::function<bool(const std::string& line)>& take_up);

  std::filesystem::path file_;
  std::string words_;
  std::filesystem::path own_;  // file_, or that of this run
  std::string parts_;          // how the names of the files of parts() begin
  std::string lines_;
  std::optional<Clock::time_point> saved_;
};

}  // namespace polhode
