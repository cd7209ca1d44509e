// SPDX-License-Identifier: MIT
// Files that appear under their name only when they are complete, and reading and writing of
// whole files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/system/unfinished.h"

namespace polhode {

// Where writing begins: at the start of a file, whose content goes, or behind its end.
enum class From { start, end };

// Owns NAME.part beside NAME. commit() renames it to NAME; without commit() the destructor removes
// it. Invariant: NAME itself is either untouched or complete. NAME.part is locked (flock, where the
// file system has it), so the second of two runs with the same output is refused. A NAME.part left
// behind by a killed run is reused; it keeps its contents until somebody opens part() and truncates
// it, as write() does. Not thread-safe. All errors have target() as their place.
class AtomicFile {
 public:
  // Creates and locks NAME.part, with the owner, group, mode and list of users (acl(5)) of NAME, if
  // that is there, as far as the user may give them. If NAME is a symbolic link, the file it points
  // to is meant. Throws Error (input) if the folder is missing or cannot be written, if NAME is a
  // folder, a device, write-protected, protected (base/system/overwriting.h) or a link in /proc, as
  // /dev/fd/3 is, or somebody else's in a folder like /tmp, if NAME.part is a link of either kind
  // or no regular file, or if another run is writing it, and as system_error()
  // (base/system/system_error.h) does if it cannot be created.
  explicit AtomicFile(const std::filesystem::path& target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  // The temporary file NAME.part, to write to until commit().
  const std::filesystem::path& part() const { return part_; }
  // The final name; for a symbolic link, the file that it points to.
  const std::filesystem::path& target() const { return target_; }
  // Waits until the file is on the disk, unless it is unlocked, and renames it to its final name.
  // Call it once. Throws Error (environment) if that fails, and (input) if the file is protected
  // by now.
  void commit();
  // The same, but withdraw() can undo it: what had the name before stays in part(), where the file
  // system can exchange two files, until this is destroyed.
  void commit_for_now();
  // After commit_for_now(): the name belongs again to what had it before; where the file system has
  // not kept that, to what was written. Does not throw.
  void withdraw();
  // Makes this the whole content of the temporary file. Throws Error (environment) if that fails.
  void write(std::string_view content);
  // Adds to what write() made. Throws Error (environment) if that fails.
  void append(std::string_view content);
  // Calls write(), then commit().
  void commit_with(std::string_view content);
  // Releases the lock early, to have fewer open files. For numbered sequences, in which the lock on
  // one file protects all of them.
  void unlock();

 private:
  enum class State {
    unfinished,
    committed,
    is_new,     // nothing had the name
    exchanged,  // part() is what had it
  };

  void make_ready() const;
  void rename_part();
  void put(From from, std::string_view content) const;

  std::filesystem::path target_;
  std::filesystem::path part_;
  State state_ = State::unfinished;
  int lock_ = -1;  // file descriptor that holds the lock; -1 when there is none
  std::optional<Unfinished> unfinished_;
};

// Opens a file that is there, such as AtomicFile::part(), to write to it. Null, with errno, if that
// fails; what is removed because the process ends is not made again (base/system/unfinished.h).
std::FILE* open_existing(const std::filesystem::path& file, From from);

// Opens a file as open_existing() does, writes the bytes and closes it. Returns 0 on success, else
// the errno of the call that failed. Does not throw.
int failure_to_write(const std::filesystem::path& file, From from, std::string_view bytes);

// Writes a whole file by AtomicFile. Throws Error (input) as its constructor does, and
// (environment) if writing or renaming fails, for example on a full disk.
void write_file(const std::filesystem::path& target, std::string_view content);

// Throws Error (input), with the file as its place, if `path` leads to no regular file: to nothing,
// to a folder, to a pipe, or round in a circle. Throws as system_error()
// (base/system/system_error.h) does if that cannot be found out.
void refuse_unless_file(const std::filesystem::path& path);

// The first bytes of a file, at most `most`; fewer if it is shorter or cannot be read. Does not
// throw.
std::string head_of_file(const std::filesystem::path& path, std::size_t most);

// The content of a whole file. Throws Error (input) as refuse_unless_file() does, and if the file
// is larger than `most` bytes; the default is no limit. Throws as system_error() does if it cannot
// be read.
std::string read_file(const std::filesystem::path& path, std::size_t most = SIZE_MAX - 1);

// The same of a file that the user gave, which is protected (base/system/overwriting.h) from then
// on.
std::string read_input(const std::filesystem::path& path, std::size_t most = SIZE_MAX - 1);

}  // namespace polhode
