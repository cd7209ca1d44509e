// SPDX-License-Identifier: MIT
#include "base/system/atomic_file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <sys/file.h>
#include <sys/stat.h>
#include <sys/xattr.h>

#include "base/error.h"
#include "base/system/overwriting.h"
#include "base/system/system_error.h"

namespace polhode {
namespace fs = std::filesystem;
namespace {

// what a symbolic link points to, whether it is there or not: renaming would replace the link
fs::path behind_links(const fs::path& asked) {
  fs::path target = asked;
  // of a pipe, such as /dev/stdout may be, /proc only has a name that leads nowhere
  std::error_code none;
  if (fs::exists(target, none) && !fs::is_regular_file(target, none)) return target;
  constexpr int kMostLinks = 40;  // as the system counts them
  std::error_code failed;
  for (int i = 0; i < kMostLinks && fs::is_symlink(target, failed); ++i) {
    const fs::path folder =
        fs::canonical(target.has_parent_path() ? target.parent_path() : ".", failed);
    if (folder.string().starts_with("/proc/")) {
      throw input_error(
          "is a file that is open, which would be replaced; choose another output (standard output "
          "is -)")
          .at({asked.string(), 0, {}});
    }
    const fs::path next = fs::read_symlink(target, failed);
    if (failed) break;
    target = target.parent_path() / next;  // an absolute path stays itself
  }
  return target;
}

// Whether it belongs to somebody else, in a folder such as /tmp, in which nobody gives its name to
// another file.
bool keeps_its_name(const fs::path& target, const fs::path& folder) {
  struct stat its = {}, folders = {};
  const uid_t user = geteuid();
  return user != 0 && stat(target.c_str(), &its) == 0 && stat(folder.c_str(), &folders) == 0 &&
         (folders.st_mode & S_ISVTX) != 0 && its.st_uid != user && folders.st_uid != user;
}

// Gives a new file the owner, the group, the mode and the list of users (acl(5)) of the one that it
// will replace, as far as the user may: what only some may read stays so from its first byte on.
void keep_readers(int file, const fs::path& replaced) {
  struct stat its = {};
  if (stat(replaced.c_str(), &its) != 0) return;
  mode_t mode = (its.st_mode & 0777) | S_IRUSR | S_IWUSR;
  const bool has_group =
      fchown(file, its.st_uid, its.st_gid) == 0 || fchown(file, geteuid(), its.st_gid) == 0;
  // where there is a list of users, the bits of the group are the most that these may have
  constexpr const char* kList = "system.posix_acl_access";
  std::array<char, 4096> list{};
  const ssize_t length = getxattr(replaced.c_str(), kList, list.data(), list.size());
  const bool has_list =
      length <= 0 || fsetxattr(file, kList, list.data(), static_cast<std::size_t>(length), 0) == 0;
  if (!has_group || !has_list) mode &= ~static_cast<mode_t>(S_IRWXG);
  fchmod(file, mode);
}

fs::path part_of(const fs::path& target) {
  fs::path part = target;
  part += ".part";
  return part;
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& target)
    : target_(behind_links(target)), part_(part_of(target_)) {
  refuse_protected_file(target);
  const Place place{target_.string(), 0, {}};
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    throw input_error("the folder '{}' does not exist; create it or choose another output",
                      folder.string())
        .at(place);
  }
  if (fs::is_directory(target_, ignored)) {
    throw input_error("is a folder; give a file name").at(place);
  }
  if (fs::exists(target_, ignored) && !fs::is_regular_file(target_, ignored)) {
    throw input_error("is not a regular file; choose another output (standard output is -)")
        .at(place);
  }
  if (fs::exists(target_, ignored) && access(target_.c_str(), W_OK) != 0) {
    throw input_error("is write-protected; choose another output").at(place);
  }
  if (keeps_its_name(target_, folder)) {
    throw input_error("belongs to another user and cannot be replaced here; choose another output")
        .at(place);
  }

  // claim the temporary name now, so that an unwritable folder is told before any work is done
  const fs::file_status there = fs::symlink_status(part_, ignored);
  const bool is_link = fs::is_symlink(there) ||
                       (fs::is_regular_file(there) && fs::hard_link_count(part_, ignored) > 1);
  if (fs::exists(there) && (is_link || !fs::is_regular_file(there))) {
    // a pipe would be waited for
    throw input_error("'{}' is {}; remove it or choose another output",
                      part_.string(),
                      is_link ? "a link" : "not a regular file")
        .at(place);
  }
  const Unbroken until_remembered;
  lock_ = open(part_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (lock_ < 0) {
    throw system_error(
        errno, fmt::format("cannot create '{}'", part_.string()), "choose another output")
        .at(place);
  }
  // a file system without locks is no reason to refuse
  if (flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    unlock();
    throw input_error(
        "is being written already, by another run or as another output of this one; wait for it or "
        "choose another output")
        .at(place);
  }
  keep_readers(lock_, target_);
  unfinished_.emplace(part_);
}

AtomicFile::~AtomicFile() {
  if (state_ == State::unfinished || state_ == State::exchanged) {
    std::error_code ignored;
    fs::remove(part_, ignored);
  }
  unlock();
}

void AtomicFile::unlock() {
  if (lock_ >= 0) close(lock_);
  lock_ = -1;
}

void AtomicFile::commit() {
  make_ready();
  rename_part();
}

void AtomicFile::commit_for_now() {
  make_ready();
  // a folder would be exchanged, too
  std::error_code ignored;
  if (!fs::is_directory(target_, ignored) &&
      renameat2(AT_FDCWD, part_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) {
    state_ = State::exchanged;
    return;
  }
  const bool is_new = !fs::exists(target_, ignored);
  rename_part();
  if (is_new) state_ = State::is_new;
}

void AtomicFile::withdraw() {
  if (state_ == State::exchanged) {
    const int failed =
        renameat2(AT_FDCWD, part_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE);
    state_ = failed == 0 ? State::unfinished : State::committed;
  } else if (state_ == State::is_new) {
    std::error_code ignored;
    fs::remove(target_, ignored);
  }
}

void AtomicFile::make_ready() const {
  refuse_protected_file(target_);  // read since this was opened
  // some systems tell only now that a disk is full; those that cannot do it at all are no reason
  if (lock_ >= 0 && fsync(lock_) != 0 && (errno == EIO || errno == ENOSPC || errno == EDQUOT)) {
    throw environment_error("cannot write: {}", std::strerror(errno)).at({target_.string(), 0, {}});
  }
}

void AtomicFile::rename_part() {
  std::error_code failed;
  fs::rename(part_, target_, failed);
  if (failed) {
    wait_if_ending();
    throw environment_error("cannot rename the finished file: {}", failed.message())
        .at({target_.string(), 0, {}});
  }
  state_ = State::committed;
  unfinished_.reset();
}

void AtomicFile::commit_with(std::string_view content) {
  write(content);
  commit();
}

void AtomicFile::write(std::string_view content) {
  put(From::start, content);
}

void AtomicFile::append(std::string_view content) {
  put(From::end, content);
}

void AtomicFile::put(From from, std::string_view content) const {
  if (const int reason = failure_to_write(part_, from, content); reason != 0) {
    throw environment_error("cannot write: {}", std::strerror(reason))
        .at({target_.string(), 0, {}});
  }
}

std::FILE* open_existing(const fs::path& file, From from) {
  const bool whole = from == From::start;
  const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC | (whole ? O_TRUNC : O_APPEND));
  if (descriptor < 0) {
    wait_if_ending();  // it has been removed
    return nullptr;
  }
  std::FILE* out = fdopen(descriptor, whole ? "wb" : "ab");
  if (out == nullptr) close(descriptor);
  return out;
}

int failure_to_write(const fs::path& file, From from, std::string_view bytes) {
  std::FILE* out = open_existing(file, from);
  const bool written = out != nullptr &&
                       std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size() &&
                       std::fflush(out) == 0;
  const int reason = errno;
  const bool closed = out != nullptr && std::fclose(out) == 0;
  if (written && closed) return 0;
  const int failure = written ? errno : reason;
  return failure != 0 ? failure : EIO;
}

void write_file(const fs::path& target, std::string_view content) {
  AtomicFile(target).commit_with(content);
}

void refuse_unless_file(const fs::path& path) {
  const Place place{path.string(), 0, {}};
  std::error_code failed;
  const fs::file_status status = fs::status(path, failed);
  if (status.type() == fs::file_type::not_found) {
    if (path.empty()) throw input_error("an empty text names no file");
    throw input_error("the file does not exist").at(place);
  }
  // a link to itself, or a folder that may not be entered
  if (failed) throw system_error(failed.value(), "cannot be read").at(place);
  if (fs::is_directory(status)) throw input_error("is a folder; give a file").at(place);
  // a pipe that nobody writes to would be waited for
  if (!fs::is_regular_file(status)) {
    throw input_error("is not a regular file; write it to one first").at(place);
  }
}

std::string head_of_file(const fs::path& path, std::size_t most) {
  std::string head(most, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(most));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return head;
}

std::string read_file(const fs::path& path, std::size_t most) {
  refuse_unless_file(path);
  const Place place{path.string(), 0, {}};
  std::ifstream in(path, std::ios::binary);
  if (!in) throw system_error(errno, "cannot be read").at(place);

  // block by block, to stop at the limit
  std::string content;
  errno = 0;
  std::array<char, 65536> block{};
  while (in.read(block.data(), block.size()), in.gcount() > 0) {
    content.append(block.data(), static_cast<std::size_t>(in.gcount()));
    if (content.size() > most) {
      throw input_error("is larger than {} bytes; is this the right file?", most).at(place);
    }
  }
  if (in.bad()) throw system_error(errno != 0 ? errno : EIO, "cannot be read").at(place);
  return content;
}

std::string read_input(const fs::path& path, std::size_t most) {
  std::string content = read_file(path, most);
  protect_file(path);
  return content;
}

}  // namespace polhode
