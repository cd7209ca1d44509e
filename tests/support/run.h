// SPDX-License-Identifier: MIT
// Runs the real binary and keeps what it says.
#pragma once

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>
#include <sys/wait.h>

namespace polhode::test {

// A folder of one test's own, removed with it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = ::testing::TempDir() + "polhode-XXXXXX";
    path_ = mkdtemp(name.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }
  // How many files and folders are inside.
  long entries() const { return std::distance(std::filesystem::directory_iterator(path_), {}); }

 private:
  std::filesystem::path path_;
};

inline void write_text(const std::string& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

inline std::string read_text(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

struct Ran {
  int code = -1;  // exit code; 128 + signal when killed
  std::string out;
  std::string err;
};

// `polhode ARGUMENTS` through the shell; `before` stands in front, for environment and limits.
inline Ran run_polhode(const std::string& arguments, const std::string& before = "") {
  const TemporaryFolder folder;
  const std::string command = before + " '" POLHODE_BINARY "' " + arguments + " >'" +
                              (folder / "out") + "' 2>'" + (folder / "err") + "' </dev/null";
  const int status = std::system(command.c_str());
  Ran ran;
  ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  ran.out = read_text(folder / "out");
  ran.err = read_text(folder / "err");
  return ran;
}

inline const char* const kSmallScene = R"(format = 1
title = "test"
[body]
solid = { kind = "ellipsoid", semi_axes = [0.1, 0.1, 0.2], mass = 1.0 }
[motion]
duration = 1
attitude = { zxz_deg = [0, 40, 0] }
spin = { body = [1, 0, 3] }
[video]
size = "128x72"
fps = 10
)";

// That scene as a film of 12 000 frames, which takes long to draw but not to prepare.
inline std::string long_scene() {
  std::string text = kSmallScene;
  text.replace(text.find("duration = 1"), 12, "duration = 100");
  text.replace(text.find("fps = 10"), 8, "fps = 120");
  return text;
}

}  // namespace polhode::test
