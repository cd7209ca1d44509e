// SPDX-License-Identifier: MIT
// Shows the progress of a long run on stderr.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace polhode {

// How progress is shown: by a bar on one line, as one JSON object per line (docs/render.md has the
// keys), or not at all. `automatic` is a bar on a terminal, and nothing elsewhere.
enum class ProgressKind { automatic, bar, json, none };

// The values of --progress, in the order of ProgressKind: "auto", "bar", "json", "none".
const std::vector<std::string>& progress_names();

// The kind of that name. Throws Error (input), with --progress as key, for any other text.
ProgressKind parse_progress(const std::string& text);

// Prints how many things are done, their rate since the construction of this object and the
// estimated time left, at most ten times a second and when all are done. Not thread-safe.
class Progress {
 public:
  // `things`: plural noun for what is counted, as printed and in the JSON key "THINGS_per_s".
  // `total`: number of all things. `there`: how many of them an earlier run has finished; they do
  // not count in the rate.
  Progress(ProgressKind kind, int total, std::string things = "frames", int there = 0);
  // Ends the line of the bar, if one was shown.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // `done`: number of things finished in this run. `limit`: name of the stage that limits the
  // speed, such as "drawing", to print; empty: none is printed.
  void show(int done, const std::string& limit = "");

 private:
  using Clock = std::chrono::steady_clock;
  void print(int done, double seconds, const std::string& limit);

  ProgressKind kind_;
  int total_;
  std::string things_;
  int there_;
  Clock::time_point start_;
  Clock::time_point last_;
  std::size_t drawn_ = 0;  // columns of the bar
};

// Says what a computation of unknown length is doing, once it has taken a second, and at most ten
// times a second: by a line of a terminal, which disappears at the end, or as {"doing":"..."}.
// Not thread-safe.
class Waiting {
 public:
  explicit Waiting(ProgressKind kind);
  // Clears the line, if one was shown.
  ~Waiting();
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;

  // `words`: what is being done, without quotation marks and line breaks.
  void show(const std::string& words);

 private:
  using Clock = std::chrono::steady_clock;

  ProgressKind kind_;
  Clock::time_point next_;
  std::size_t drawn_ = 0;  // columns
};

// Says likewise, once it has taken a second, what is being done as long as the object lives, for
// work that cannot tell how far it is. It has a thread, so no process may be forked meanwhile, and
// nothing else should be written on stderr.
class Busy {
 public:
  Busy(ProgressKind kind, std::string words);
  ~Busy();
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

 private:
  void tell_after_a_while(const std::stop_token& ended);

  ProgressKind kind_;
  std::string words_;
  std::size_t drawn_ = 0;  // columns; the thread's, until it has ended
  std::mutex mutex_;
  std::condition_variable_any is_ended_;
  std::jthread thread_;  // last, so that it starts when all else is there
};

}  // namespace polhode
