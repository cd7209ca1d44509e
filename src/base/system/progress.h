// SPDX-License-Identifier: MIT
// How a long run tells how far it is, on stderr.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace polhode {

enum class ProgressKind { automatic, bar, json, none };

// "auto", "bar", "json", "none".
const std::vector<std::string>& progress_names();

// One of them. Throws Error (input).
ProgressKind parse_progress(const std::string& text);

// Prints at most ten times a second; automatic means a bar on a terminal and nothing elsewhere.
class Progress {
 public:
  // total: how many there are of `things`, in the plural; `there` of them were done before.
  Progress(ProgressKind kind, int total, std::string things = "frames", int there = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // done: in this run. limit: the stage that the others wait for; empty: there is but one
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
