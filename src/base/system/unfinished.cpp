// SPDX-License-Identifier: MIT
#include "base/system/unfinished.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <iterator>
#include <poll.h>
#include <string>
#include <string_view>
#include <unistd.h>

#include <sys/wait.h>

namespace polhode {
namespace {

constexpr std::size_t kSlots = 64;
constexpr std::size_t kLongestPath = 4000;

// A signal handler may read nothing that needs a lock or memory.
struct Slot {
  std::atomic<bool> taken{false};
  std::atomic<pid_t> owner{0};  // 0: not to be read
  pid_t child = 0;              // 0: a path
  std::array<char, kLongestPath + 1> path{};
};
std::array<Slot, kSlots> slots;
std::atomic<bool> ending{false};

// the number of a slot, kSlots if there is none
std::size_t remember(std::string_view path, pid_t child) {
  if (path.size() > kLongestPath) return kSlots;
  for (std::size_t i = 0; i < kSlots; ++i) {
    if (slots[i].taken.exchange(true)) continue;
    path.copy(slots[i].path.data(), path.size());
    slots[i].path[path.size()] = '\0';
    slots[i].child = child;
    slots[i].owner.store(getpid(), std::memory_order_release);
    return i;
  }
  return kSlots;
}

void remove(const char* path) {
  if (unlink(path) == 0 || (errno != EISDIR && errno != EPERM)) return;
  // fork() takes locks that the interrupted code may hold
  const pid_t child = _Fork();
  if (child == 0) {
    execl("/bin/rm", "rm", "-rf", "--", path, static_cast<char*>(nullptr));
    _exit(1);
  }
  if (child > 0) waitpid(child, nullptr, 0);
}

void remove_unfinished() {
  ending = true;
  const auto is_ours = [](const Slot& slot) {
    return slot.owner.load(std::memory_order_acquire) == getpid();
  };
  // first those who still write
  for (const Slot& slot : slots)
    if (is_ours(slot) && slot.child > 0) end_with_all_it_started(slot.child);
  for (const Slot& slot : slots)
    if (is_ours(slot) && slot.child == 0) remove(slot.path.data());
}

// what the program, a library or the machine does wrong; the rest comes from outside
constexpr int kCrashes[] = {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGTRAP, SIGSYS};
constexpr int kOrders[] = {SIGQUIT, SIGXCPU, SIGUSR1, SIGUSR2, SIGVTALRM, SIGPROF};

extern "C" void end_after_signal(int signal) {
  constexpr std::string_view kCrash =
      "polhode: crashed: a fault of the program or of a library, or no memory left; what was "
      "unfinished is removed\n";
  constexpr std::string_view kLimit =
      "polhode: the limit of processor time is reached (ulimit -t); what was unfinished is "
      "removed\n";
  constexpr std::string_view kOrder =
      "polhode: ended by a signal; what was unfinished is removed\n";
  const bool crashed =
      std::find(std::begin(kCrashes), std::end(kCrashes), signal) != std::end(kCrashes);
  const std::string_view words = crashed ? kCrash : signal == SIGXCPU ? kLimit : kOrder;
  say_in_passing(words);
  remove_unfinished();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void tidy_up_after(int signal) {
  struct sigaction now {};
  sigaction(signal, nullptr, &now);
  if ((now.sa_flags & SA_SIGINFO) != 0 || now.sa_handler != SIG_DFL) return;
  struct sigaction ours {};
  ours.sa_handler = end_after_signal;
  ours.sa_flags = SA_ONSTACK | static_cast<int>(SA_RESETHAND);
  sigaction(signal, &ours, nullptr);
}

}  // namespace

Unfinished::Unfinished(const std::filesystem::path& path)
    : slot_([&] {
        // the process may go to another folder
        std::error_code failed;
        const std::filesystem::path whole = std::filesystem::absolute(path, failed);
        return remember(failed ? path.native() : whole.native(), 0);
      }()) {}

Unfinished::Unfinished(pid_t child) : slot_(remember({}, child)) {}

Unfinished::~Unfinished() {
  if (slot_ == kSlots) return;
  slots[slot_].owner.store(0);
  slots[slot_].taken.store(false);
}

bool is_ending() {
  return ending;
}

void end_with_all_it_started(pid_t child) {
  // there is such a group only if the child leads it
  if (kill(-child, SIGKILL) != 0) kill(child, SIGKILL);
}

void say_in_passing(std::string_view words) {
  pollfd error{STDERR_FILENO, POLLOUT, 0};
  if (poll(&error, 1, 0) != 1 || (error.revents & POLLOUT) == 0) return;
  static_cast<void>(!write(STDERR_FILENO, words.data(), words.size()));
}

void end_at_once(int exit_code) {
  remove_unfinished();
  _exit(exit_code);
}

void tidy_up_after_crashes() {
  // a stack that has overflowed is no place for a handler
  static std::array<char, 65536> other_stack;
  stack_t stack{};
  stack.ss_sp = other_stack.data();
  stack.ss_size = other_stack.size();
  sigaltstack(&stack, nullptr);
  for (const int signal : kCrashes)
    tidy_up_after(signal);
  for (const int signal : kOrders)
    tidy_up_after(signal);
}

}  // namespace polhode
