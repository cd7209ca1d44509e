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

#include <sys/prctl.h>
#include <sys/wait.h>

#include "base/error.h"
#include "base/system/interrupt.h"
#include "base/system/unfinished.h"

namespace polhode {
namespace {

std::string not_installed(const std::string& program) {
  return program + " is not installed";
}

// One end or both ends of a pipe, closed at the end.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) {
      throw environment_error("no program can be started: {}", std::strerror(errno));
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
    // what it leaves behind becomes ours, so that its end can be waited for
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    // our own way with signals is not its way
    posix_spawnattr_t how;
    posix_spawnattr_init(&how);
    sigset_t all;
    sigfillset(&all);
    posix_spawnattr_setsigdefault(&how, &all);
    // a group of its own, so that what it starts can be ended with it
    posix_spawnattr_setpgroup(&how, 0);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&how, &none);
    posix_spawnattr_setflags(
        &how, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
    const Unbroken until_remembered;
    const int failure = posix_spawnp(&id_, arguments[0], &files, &how, arguments.data(), environ);
    posix_spawnattr_destroy(&how);
    posix_spawn_file_actions_destroy(&files);
    if (failure != 0) {
      id_ = -1;
      throw failure == ENOENT
          ? environment_error("{}", not_installed(words[0]))
          : environment_error("{} cannot be started: {}", words[0], std::strerror(failure));
    }
    unfinished_.emplace(id_);
  }
  ~Child() {
    if (id_ < 0) return;
    end_now();
    wait_for_end();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void end_now() const { end_with_all_it_started(id_); }

  // It is not reaped, so that its number stays its own.
  bool has_ended() const {
    siginfo_t what{};
    return waitid(P_PID, static_cast<id_t>(id_), &what, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           what.si_pid == id_;
  }

  // Ends what it has left behind, too. Returns what waitpid() tells.
  int wait_for_end() {
    siginfo_t what{};
    while (waitid(P_PID, static_cast<id_t>(id_), &what, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
    }
    end_now();  // the number is still its own, and its group's
    int status = 0;
    while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    // killed is not yet gone: a browser's helper may still write to a folder that is to be removed
    while (waitpid(-id_, nullptr, 0) > 0 || errno == EINTR) {
    }
    unfinished_.reset();
    id_ = -1;
    return status;
  }

 private:
  pid_t id_ = -1;
  std::optional<Unfinished> unfinished_;
};

// the words of a program to which memory beyond a limit is refused from its first instruction
std::vector<std::string> limited(std::vector<std::string> words,
                                 const std::optional<std::size_t>& memory) {
  if (!memory) return words;
  words.insert(words.begin(), {"prlimit", fmt::format("--data={}", *memory), "--"});
  return words;
}

// without the empty lines before it
std::string first_line(const std::string& text) {
  const std::size_t start = text.find_first_not_of(" \n\t");
  if (start == std::string::npos) return "";
  return text.substr(start, text.find('\n', start) - start);
}

// Appends what is there to read; false at the end. Throws Error (environment).
bool drain(int file, std::string& text) {
  std::array<char, 1 << 16> buffer;
  const ssize_t got = read(file, buffer.data(), buffer.size());
  if (got > 0) text.append(buffer.data(), static_cast<std::size_t>(got));
  if (got < 0 && errno != EINTR && errno != EAGAIN)
    throw environment_error("cannot read what another program writes: {}", std::strerror(errno));
  return got != 0;
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& words,
                      std::string_view input,
                      const ChildLimits& limits,
                      const std::function<void()>& meanwhile) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  Pipe in, out, err;
  Child child(limited(words, limits.memory), in, out, err);
  in.close_end(0);
  out.close_end(1);
  err.close_end(1);
  fcntl(in.writer(), F_SETFL, O_NONBLOCK);

  ChildResult result;
  bool out_open = true, err_open = true;
  while (out_open || err_open) {
    stop_if_interrupted();
    if (meanwhile) meanwhile();
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
    // what it has left behind may hold its pipes open; what it wrote itself is in them already
    const bool ended = child.has_ended();
    constexpr int kPatience_ms = 100;  // between looks at our own signals
    const int ready = poll(files.data(), files.size(), ended ? 0 : kPatience_ms);
    if (ready == 0 && ended) break;
    if (ready <= 0) continue;
    if (files[0].revents != 0) out_open = drain(out.reader(), result.out);
    if (files[1].revents != 0) err_open = drain(err.reader(), result.err);
    if (files[2].revents == 0) continue;
    const ssize_t sent = write(in.writer(), input.data(), input.size());
    if (sent > 0) input.remove_prefix(static_cast<std::size_t>(sent));
    // it reads no more: let it end, and its exit code tell
    if (sent < 0 && errno != EAGAIN && errno != EINTR) input = {};
  }
  const int status = child.wait_for_end();
  result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  result.status = result.signal != 0 ? 128 + result.signal : WEXITSTATUS(status);
  return result;
}

bool ended_well(const ChildResult& result) {
  return result.status == 0 && result.exceeded.empty();
}

std::string how_it_ended(const ChildResult& result) {
  if (!result.exceeded.empty()) return result.exceeded;
  if (result.signal != 0) {
    return fmt::format("was ended by signal {} ({})", result.signal, strsignal(result.signal));
  }
  const std::string reason = first_line(result.err);
  return fmt::format(
      "ended with exit code {}{}{}", result.status, reason.empty() ? "" : ": ", reason);
}

ProgramFound find_program(const std::string& program) {
  // a large program may have to come from a slow disk first
  constexpr ChildLimits kLimits{.seconds = 25.0, .memory = {}, .output = 1U << 20U};
  try {
    const ChildResult ran = run_child({program, "--version"}, "", kLimits);
    const std::string version = ended_well(ran) ? first_line(ran.out) : "";
    if (!version.empty()) return {version, "", true};
    return {"",
            fmt::format("{} {}", program, ended_well(ran) ? "tells no version" : how_it_ended(ran)),
            true};
  } catch (const Error& error) {
    if (error.fault() == Fault::interrupted) throw;
    return {"", error.message(), error.message() != not_installed(program)};
  }
}

void require_program(const std::string& program,
                     const std::string& what,
                     const std::string& advice) {
  const ProgramFound found = find_program(program);
  if (found.why_not.empty()) return;
  throw environment_error("{}: {}{}", what, found.why_not, found.installed ? "" : "; " + advice);
}

}  // namespace polhode
