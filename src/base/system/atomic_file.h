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
// Invariant: NAME itself is either untouched or complete. NAME.part is locked, so the second of two
// runs with the same output is refused. A NAME.part left behind by a killed run is reused.
class AtomicFile {
 public:
  // Throws Error (input), with the file as its place, if the folder is missing or cannot be
  // written, if NAME is a folder, a device or write-protected, or if another run is writing it. If
  // NAME is a symbolic link, its target is replaced.
  explicit AtomicFile(std::filesystem::path target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  // The temporary file to write to until commit().
  const std::filesystem::path& part() const { return part_; }
  // The final name.
  const std::filesystem::path& target() const { return target_; }
  // Renames the finished file to its final name. Throws Error (environment) if that fails.
  void commit();
  // Writes the whole content to the temporary file. Throws Error (environment) if that fails.
  void write(std::string_view content);
  // write(), then commit().
  void commit_with(std::string_view content);
  // Releases the lock early. For numbered sequences, where one lock protects thousands of files.
  void unlock();

 private:
  std::filesystem::path target_;
  std::filesystem::path part_;
  bool committed_ = false;
  int lock_ = -1;  // file descriptor that holds the lock; -1 when there is none
};

// Opens a file with fopen's `mode`, writes the bytes and closes it. Returns 0, or errno of the call
// that failed.
int failure_to_write(const std::filesystem::path& file, const char* mode, std::string_view bytes);

// Writes a complete small file atomically. Throws Error as AtomicFile does, or (environment) if the
// disk is full.
void write_file(const std::filesystem::path& target, std::string_view content);

// Reads a whole file. Throws Error (input), with the file as its place, if it is missing, a folder,
// unreadable, not a regular file, or larger than `most` bytes.
std::string read_file(const std::filesystem::path& path, std::size_t most = SIZE_MAX - 1);

}  // namespace polhode
