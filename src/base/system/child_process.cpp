// SPDX-License-Identifier: MIT
#include "base/system/child_process.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <unistd.h>

#include <sys/resource.h>
#include <sys/wait.h>

#include "base/error.h"
#include "base/system/interrupt.h"

namespace polhode {
namespace {

// One end or both ends of a pipe, closed at the end.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) {
      throw environment_error("no pipe to another program: {}", std::strerror(errno));
    }
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reader() const { return ends_[0]; }
  int writer() const { return ends_[1]; }
  // 0: the reading end, 1: the writing end
  void close_end(std::size_t end) {
    if (ends_[end] >= 0) close(ends_[end]);
    ends_[end] = -1;
  }

 private:
  std::array<int, 2> ends_ = {-1, -1};
};

// The process; ended and reaped if it still runs when it goes out of scope.
class Child {
 public:
  Child(const std::vector<std::string>& words, const Pipe& in, const Pipe& out, const Pipe& err) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (const std::string& word : words)
      arguments.push_back(const_cast<char*>(word.c_str()));  // posix_spawn does not write to them
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, in.reader(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, out.writer(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, err.writer(), STDERR_FILENO);
    // our own way with signals is not its way
    posix_spawnattr_t how;
    posix_spawnattr_init(&how);
    sigset_t all;
    sigfillset(&all);
    posix_spawnattr_setsigdefault(&how, &all);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSIGDEF);
    const int failure = posix_spawnp(&id_, arguments[0], &files, &how, arguments.data(), environ);
    posix_spawnattr_destroy(&how);
    posix_spawn_file_actions_destroy(&files);
    if (failure != 0) {
      id_ = -1;
      throw environment_error("cannot start {}: {}", words[0], std::strerror(failure));
    }
  }
  ~Child() {
    if (id_ < 0) return;
    kill(id_, SIGKILL);
    wait_for_end();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // what it asks for beyond this is refused to it
  void limit_memory(std::size_t bytes) const {
    const rlimit limit{bytes, bytes};
    prlimit(id_, RLIMIT_DATA, &limit, nullptr);
  }
  void end_now() const { kill(id_, SIGKILL); }

  int wait_for_end() {
    int status = 0;
    while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = -1;
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }

 private:
  pid_t id_ = -1;
};

// appends what is there to read; false at the end
bool drain(int file, std::string& text) {
  std::array<char, 1 << 16> buffer;
  const ssize_t got = read(file, buffer.data(), buffer.size());
  if (got > 0) text.append(buffer.data(), static_cast<std::size_t>(got));
  return got > 0 || (got < 0 && (errno == EINTR || errno == EAGAIN));
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& words,
                      std::string_view input,
                      const ChildLimits& limits) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  Pipe in, out, err;
  Child child(words, in, out, err);
  if (limits.memory) child.limit_memory(*limits.memory);
  in.close_end(0);
  out.close_end(1);
  err.close_end(1);
  fcntl(in.writer(), F_SETFL, O_NONBLOCK);

  ChildResult result;
  bool out_open = true, err_open = true;
  while (out_open || err_open) {
    stop_if_interrupted();
    if (std::chrono::duration<double>(Clock::now() - start).count() > limits.seconds) {
      result.exceeded = fmt::format("took longer than {:g} s", limits.seconds);
    } else if (result.out.size() + result.err.size() > limits.output) {
      result.exceeded = fmt::format("wrote more than {} bytes", limits.output);
    }
    if (!result.exceeded.empty()) {
      child.end_now();
      break;
    }
    if (input.empty()) in.close_end(1);
    // a negative file descriptor is skipped
    std::array<pollfd, 3> files = {{{out_open ? out.reader() : -1, POLLIN, 0},
                                    {err_open ? err.reader() : -1, POLLIN, 0},
                                    {in.writer(), POLLOUT, 0}}};
    constexpr int kPatience_ms = 100;  // between looks at our own signals
    if (poll(files.data(), files.size(), kPatience_ms) <= 0) continue;
    if (files[0].revents != 0) out_open = drain(out.reader(), result.out);
    if (files[1].revents != 0) err_open = drain(err.reader(), result.err);
    if (files[2].revents == 0) continue;
    const ssize_t sent = write(in.writer(), input.data(), input.size());
    if (sent > 0) input.remove_prefix(static_cast<std::size_t>(sent));
    // it reads no more: let it end, and its exit code tell
    if (sent < 0 && errno != EAGAIN && errno != EINTR) input = {};
  }
  result.status = child.wait_for_end();
  return result;
}

}  // namespace polhode
