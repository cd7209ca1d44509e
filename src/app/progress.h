// SPDX-License-Identifier: MIT
// How a long run tells how far it is, on stderr.
#pragma once

#include <chrono>
#include <string>

namespace polhode {

enum class ProgressKind { automatic, bar, json, none };

// "auto", "bar", "json", "none". Throws Error (input).
ProgressKind parse_progress(const std::string& text);

// Prints at most ten times a second; automatic means a bar on a terminal and nothing elsewhere.
class Progress {
 public:
  // total: how many there are of `things`, in the plural
  Progress(ProgressKind kind, int total, std::string things = "frames");
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(int done);

 private:
  using Clock = std::chrono::steady_clock;
  void print(int done, double seconds) const;

  ProgressKind kind_;
  int total_;
  std::string things_;
  Clock::time_point start_;
  Clock::time_point last_;
  bool drawn_ = false;
};

}  // namespace polhode
