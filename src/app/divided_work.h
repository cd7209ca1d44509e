// SPDX-License-Identifier: MIT
// The work of a command as it is before it is begun: what `submit` divides into tasks.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace polhode {

// Checked, measured, not begun. A run of the command with --shard K/N makes the pieces K, K + N, …,
// the run without it collects them.
struct DividedWork {
  std::string words;               // all that the results depend on; see hash_of_work()
  std::filesystem::path output;    // the film or the folder that the collecting run makes
  std::vector<std::string> proof;  // files that are there when it is made, of a folder: names in it
  std::string things;              // plural noun for its pieces: "rows"
  long pieces = 1;
  double start_s = 0.0;  // s, measured: what each run does before its first piece
  double piece_s = 0.0;  // s, measured: a piece on one processor, on average
  // what the command line of every run needs beside what the user gave: "--resume"
  std::vector<std::string> options;
  bool has_jobs = true;  // the command has --jobs
  bool alone = false;    // it measures times, and wants nodes of its own
};

// The mean time of sample(k), k = 0, 1, …, in s: as many as fit into about a second, at least
// one and at most 32. Throws what `sample` throws.
double mean_seconds(const std::function<void(int k)>& sample);

// The k-th of a series of numbers from 0 to count - 1 that spreads evenly over them, whatever its
// length (multiples of the golden section).
long spread_over(int k, long count);

// The time that a call takes, s.
double seconds_of(const std::function<void()>& work);

}  // namespace polhode
