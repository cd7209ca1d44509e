// SPDX-License-Identifier: MIT
// A file that appears under its name only when it is complete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace polhode {

// Owns NAME.part beside NAME. commit() renames it; without commit the destructor removes it.
// Invariant: NAME itself is either untouched or whole. NAME.part is locked, so that of two runs
// with the same output the second is refused; one that a killed run left behind is taken over.
class AtomicFile {
 public:
  // Throws Error (input) when the folder is missing or cannot be written, when NAME is a folder, a
  // device or write-protected, and when another run is writing it. A symbolic link is followed.
  explicit AtomicFile(std::filesystem::path target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  // Where to write until commit().
  const std::filesystem::path& part() const { return part_; }
  const std::filesystem::path& target() const { return target_; }
  // Moves the finished file to its name. Throws Error (environment) when that fails.
  void commit();
  // Writes the whole content to the temporary file. Throws Error (environment) when that fails.
  void write(std::string_view content);
  // The same, then commits.
  void commit_with(std::string_view content);
  // Gives the lock up before the end: for thousands of files that one lock stands for.
  void unlock();

 private:
  std::filesystem::path target_;
  std::filesystem::path part_;
  bool committed_ = false;
  int lock_ = -1;  // file descriptor that holds the lock; -1 when there is none
};

// Opens a file as fopen does, writes to it and closes it: 0, or the errno of what failed.
int failure_to_write(const std::filesystem::path& file, const char* mode, std::string_view bytes);

// Writes a whole small file atomically. Throws Error as AtomicFile does, or (environment) when the
// disk is full.
void write_file(const std::filesystem::path& target, std::string_view content);

// Reads a whole file. Throws Error (input) when it is missing, a folder, unreadable, no ordinary
// file, or holds more than `most` bytes.
std::string read_file(const std::filesystem::path& path, std::size_t most = SIZE_MAX - 1);

}  // namespace polhode
