// SPDX-License-Identifier: MIT
// The real binary in the background, to be killed.
#pragma once

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <functional>
#include <thread>

#include "support/run.h"

namespace polhode::test {

// Until it is so, at most half a minute. Nothing wakes one up for a file of another program or for
// what /proc tells, so one looks again and again.
inline bool becomes(const std::function<bool()>& so) {
  for (int i = 0; i < 120000; ++i) {
    if (so()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

// Does such a process run? One that has ended and waits to be reaped does not.
inline bool runs(pid_t id) {
  const std::string status = read_text("/proc/" + std::to_string(id) + "/status");
  return !status.empty() && status.find("State:\tZ") == std::string::npos &&
         status.find("State:\tX") == std::string::npos;
}

// The words of a command line without quotes.
inline std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    words.push_back(word);
  }
  return words;
}

// `polhode ARGUMENTS…`, its standard output into a file if one is named; killed at the end if it
// still runs.
class Background {
 public:
  explicit Background(std::vector<std::string> arguments, const std::string& out = "") {
    arguments.insert(arguments.begin(), POLHODE_BINARY);
    std::vector<char*> words;
    for (std::string& argument : arguments) {
      words.push_back(argument.data());
    }
    words.push_back(nullptr);
    const std::string err = folder_ / "err";
    id_ = fork();
    if (id_ != 0) return;
    std::signal(SIGHUP, SIG_DFL);  // whatever runs the tests
    dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    if (!out.empty()) dup2(open(out.c_str(), O_WRONLY), STDOUT_FILENO);
    execv(words[0], words.data());
    _exit(127);
  }
  ~Background() {
    if (id_ > 0) end(SIGKILL);
  }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  // The processes that it has started.
  std::vector<pid_t> children() const {
    const std::string id = std::to_string(id_);
    std::istringstream list(read_text("/proc/" + id + "/task/" + id + "/children"));
    std::vector<pid_t> ids;
    for (pid_t child = 0; list >> child;) {
      ids.push_back(child);
    }
    return ids;
  }

  // Waits until it is amid its work; it must have got `--progress json`.
  void await_progress() const {
    EXPECT_TRUE(becomes([&] { return read_text(folder_ / "err").find(kProgress) != npos; }))
        << read_text(folder_ / "err");
  }

  // Sends the signal (0: none) and waits for the end. What it says is without lines of progress.
  Ran end(int signal = 0) {
    if (signal != 0) kill(id_, signal);
    int status = 0;
    waitpid(id_, &status, 0);
    id_ = -1;
    Ran ran;
    ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    std::istringstream lines(read_text(folder_ / "err"));
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with(kProgress) && !line.starts_with(kPreparing)) ran.err += line + "\n";
    }
    return ran;
  }

 private:
  static constexpr const char* kProgress = "{\"done\":";
  static constexpr const char* kPreparing = "{\"doing\":";  // on a busy machine
  static constexpr std::size_t npos = std::string::npos;

  TemporaryFolder folder_;
  pid_t id_ = -1;
};

}  // namespace polhode::test
