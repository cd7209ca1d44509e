// SPDX-License-Identifier: MIT
// Shows the progress of a long run on stderr.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace polhode {

enum class ProgressKind { automatic, bar, json, none };

// The values of --progress: "auto", "bar", "json", "none".
const std::vector<std::string>& progress_names();

// The kind of that name. Throws Error (input), naming --progress, for any other text.
ProgressKind parse_progress(const std::string& text);

// Prints at most ten times a second. `automatic` shows a bar on a terminal and nothing elsewhere.
// Not thread-safe.
class Progress {
 public:
  // `total` counts all `things` (a plural noun for the output); `there` of them were finished by an
  // earlier run.
  Progress(ProgressKind kind, int total, std::string things = "frames", int there = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // `done` counts the things finished in this run. `limit` names the slowest stage; empty: there is
  // only one.
  void show(int done, const std::string& limit = "");

 private:
  using Clock = std::chrono::steady_clock;
  void print(int done, double seconds, const std::string& limit) const;

  ProgressKind kind_;
  int total_;
  std::string things_;
  int there_;
  Clock::time_point start_;
  Clock::time_point last_;
  bool drawn_ = false;
};

}  // namespace polhode
