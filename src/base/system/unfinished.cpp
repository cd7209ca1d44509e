// SPDX-License-Identifier: MIT
#include "base/system/unfinished.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <iterator>
#include <memory>
#include <poll.h>
#include <string>
#include <string_view>
#include <unistd.h>

#include <sys/wait.h>

namespace polhode {

// A thing that is remembered. A signal handler may read nothing that needs a lock or memory: slots
// are never given back, but used again.
struct Unfinished::Slot {
  explicit Slot(std::size_t bytes) : room(bytes), path(new char[bytes]) {}

  std::atomic<bool> taken{true};
  std::atomic<pid_t> owner{0};  // 0: not to be read
  pid_t child = 0;              // 0: a path
  const std::size_t room;       // bytes
  const std::unique_ptr<char[]> path;
  Slot* next = nullptr;
};

namespace {

using Slot = Unfinished::Slot;
std::atomic<Slot*> slots{nullptr};  // the newest
std::atomic<int> free_slots{0};     // a film of pictures has thousands, of which none is free
std::atomic<int> unbroken{0};       // threads that must not be broken off
std::atomic<pid_t> ending{0};       // the process that ends; not those forked from it meanwhile

Slot* take_slot(std::size_t bytes) {
  if (free_slots > 0) {
    for (Slot* slot = slots; slot != nullptr; slot = slot->next) {
      if (slot->room < bytes || slot->taken.exchange(true)) continue;
      --free_slots;
      return slot;
    }
  }
  constexpr std::size_t kGrain = 256;  // bytes; few paths are longer
  auto* fresh = new Slot((bytes + kGrain - 1) / kGrain * kGrain);
  fresh->next = slots;
  while (!slots.compare_exchange_weak(fresh->next, fresh)) {
  }
  return fresh;
}

Slot* remember(std::string_view path, pid_t child) {
  Slot* slot = take_slot(path.size() + 1);
  path.copy(slot->path.get(), path.size());
  slot->path[path.size()] = '\0';
  slot->child = child;
  slot->owner = getpid();
  return slot;
}

// Whether /bin/rm could remove the folder. It keeps what is blocked here, and has a group of its
// own, so that signals to us do not end it.
bool remove_folder(const char* path) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  // fork() takes locks that the interrupted code may hold
  const pid_t child = _Fork();
  if (child == 0) {
    setpgid(0, 0);
    dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
    execl("/bin/rm", "rm", "-rf", "--", path, static_cast<char*>(nullptr));
    _exit(1);
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  int status = 1;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status == 0;
}

void remove(const char* path) {
  if (unlink(path) == 0 || (errno != EISDIR && errno != EPERM)) return;
  // programs that have just been killed may still write to it
  constexpr timespec kMoment{0, 50'000'000};  // ns
  constexpr int kTimes = 10;
  for (int i = 0; i < kTimes && !remove_folder(path); ++i)
    nanosleep(&kMoment, nullptr);
}

void remove_unfinished() {
  ending = getpid();
  // nobody begins anything else
  constexpr timespec kMoment{0, 100'000};  // ns
  constexpr int kMoments = 12'000;
  for (int i = 0; i < kMoments && unbroken > 0; ++i)
    nanosleep(&kMoment, nullptr);
  const auto for_each_of_ours = [](const auto& act) {
    for (const Slot* slot = slots; slot != nullptr; slot = slot->next)
      if (slot->owner == getpid()) act(*slot);
  };
  // first those who still write
  for_each_of_ours([](const Slot& slot) {
    if (slot.child > 0) end_with_all_it_started(slot.child);
  });
  for_each_of_ours([](const Slot& slot) {
    if (slot.child == 0) remove(slot.path.get());
  });
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
  // another signal may come meanwhile, in another thread: whoever is through first ends the process
  static std::atomic<bool> is_said{false};
  if (!is_said.exchange(true)) say_in_passing(words);
  remove_unfinished();
  std::signal(signal, SIG_DFL);
  sigset_t this_one;
  sigemptyset(&this_one);
  sigaddset(&this_one, signal);
  pthread_sigmask(SIG_UNBLOCK, &this_one, nullptr);
  std::raise(signal);
  // the first process of a container outlives what it sends to itself
  constexpr int kBySignal = 128;  // as shells have it
  _exit(kBySignal + signal);
}

void tidy_up_after(int signal) {
  struct sigaction now {};
  sigaction(signal, nullptr, &now);
  if ((now.sa_flags & SA_SIGINFO) != 0 || now.sa_handler != SIG_DFL) return;
  struct sigaction ours {};
  ours.sa_handler = end_after_signal;
  ours.sa_flags = SA_ONSTACK;
  sigemptyset(&ours.sa_mask);
  for (const int order : kOrders)
    sigaddset(&ours.sa_mask, order);
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
  slot_->owner = 0;
  slot_->taken = false;
  ++free_slots;
}

Unbroken::Unbroken() {
  sigset_t all_but_crashes;
  sigfillset(&all_but_crashes);
  for (const int crash : kCrashes)
    sigdelset(&all_but_crashes, crash);
  pthread_sigmask(SIG_SETMASK, &all_but_crashes, &before_);
  ++unbroken;
  if (!is_ending()) return;
  --unbroken;
  wait_if_ending();
}

Unbroken::~Unbroken() {
  --unbroken;
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  wait_if_ending();
}

bool is_ending() {
  return ending == getpid();
}

void wait_if_ending() {
  while (is_ending())
    pause();
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
