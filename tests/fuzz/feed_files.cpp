// SPDX-License-Identifier: MIT
// Runs a harness without libFuzzer on the files that it is given, and on all files in folders. A
// run that takes too long fails as one that crashes does, and so does a seed that is refused: those
// in the folder found/ may be.
#include <algorithm>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "base/error.h"
#include "base/system/atomic_file.h"
#include "fuzz/harness.h"

namespace {

// whether the harness refused the file
bool is_refused(const std::string& bytes) {
  try {
    polhode::run_harness(bytes);
    return false;
  } catch (const polhode::Error& error) {
    fmt::print("  {}\n", error.what());
    return error.fault() == polhode::Fault::input;
  }
}

}  // namespace

int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  for (int i = 1; i < argc; ++i) {
    if (!fs::is_directory(argv[i])) {
      files.emplace_back(argv[i]);
      continue;
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(argv[i])) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) {
    fmt::print(stderr, "no files to read; name files or folders\n");
    return 2;
  }
  spdlog::set_level(spdlog::level::off);
  constexpr double kLongest = 5.0;  // s of processor time, with room for sanitizers
  double longest = 0.0;
  for (const fs::path& file : files) {
    fmt::print("{}\n", file.string());
    std::fflush(stdout);  // the last one is the one that crashed
    const std::string bytes = polhode::read_file(file);
    const std::clock_t begin = std::clock();
    const bool refused = is_refused(bytes);
    const double took = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    longest = std::max(longest, took);
    const bool seed = file.string().find("/fuzz/found/") == std::string::npos;
    if (took > kLongest) {
      fmt::print(stderr, "{}: took {:.1f} s, more than {} s\n", file.string(), took, kLongest);
      return 1;
    }
    if (refused && seed) {
      fmt::print(stderr, "{}: a seed is refused\n", file.string());
      return 1;
    }
  }
  fmt::print("{} files, at most {:.3f} s\n", files.size(), longest);
  return 0;
}
