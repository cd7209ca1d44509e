// SPDX-License-Identifier: MIT
// What every fuzz harness defines, and what they share. A harness reads the bytes as the program
// reads a file of a user. Only polhode::Error may come out of it.
#pragma once

#include <cstdlib>
#include <string>
#include <string_view>
#include <unistd.h>

#include <fmt/format.h>
#include <sys/mman.h>

namespace polhode {

// One run of a harness, defined in its file. Any exception but Error is a finding.
void run_harness(const std::string& bytes);

// Aborts, which is a finding, unless `good`. `what` says which promise was broken.
inline void promise(bool good, std::string_view what) {
  if (good) return;
  fmt::print(stderr, "broken promise: {}\n", what);
  std::abort();
}

// A regular file in memory, for readers that take the name of a file.
class FileInMemory {
 public:
  explicit FileInMemory(std::string_view bytes) : handle_(memfd_create("fuzz", MFD_CLOEXEC)) {
    const ssize_t written = write(handle_, bytes.data(), bytes.size());
    promise(handle_ >= 0 && written == static_cast<ssize_t>(bytes.size()), "a file in memory");
  }
  ~FileInMemory() { close(handle_); }
  FileInMemory(const FileInMemory&) = delete;
  FileInMemory& operator=(const FileInMemory&) = delete;

  std::string name() const { return fmt::format("/proc/self/fd/{}", handle_); }

 private:
  int handle_;
};

}  // namespace polhode
