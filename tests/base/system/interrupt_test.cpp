// SPDX-License-Identifier: MIT
#include "base/system/interrupt.h"

#include <csignal>
#include <unistd.h>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/system/child_process.h"
#include "support/in_child.h"

namespace polhode::test {
namespace {

// the exit code that stop_if_interrupted() would end in
int interruption() {
  try {
    stop_if_interrupted();
  } catch (const Error& error) {
    return static_cast<int>(error.fault());
  }
  return 0;
}

TEST(Interrupt, ASignalBecomesAnError) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const int code = exit_code_in_child([&] {
      watch_for_interrupt();
      if (interruption() != 0) return 1;
      raise(signal);
      return interruption();
    });
    EXPECT_EQ(code, 130);
  }
}

// a terminal and its shell both send the signal of one key
TEST(Interrupt, TwoSignalsOfOneKeyAreOne) {
  const int code = exit_code_in_child([] {
    watch_for_interrupt(std::chrono::hours(1));
    raise(SIGHUP);
    raise(SIGHUP);
    return interruption();
  });
  EXPECT_EQ(code, 130);
}

TEST(Interrupt, NohupGoesOn) {
  const int code = exit_code_in_child([] {
    std::signal(SIGHUP, SIG_IGN);
    watch_for_interrupt();
    raise(SIGHUP);
    return interruption();
  });
  EXPECT_EQ(code, 0);
}

// where a parent ignores the ends of its children, all exit codes of theirs would be 0
TEST(Interrupt, TheEndsOfProgramsAreTold) {
  const int code = exit_code_in_child([] {
    std::signal(SIGCHLD, SIG_IGN);
    watch_for_interrupt();
    return run_child({"false"}, "").status;
  });
  EXPECT_EQ(code, 1);
}

TEST(Interrupt, ASignalThatAParentHasBlockedArrives) {
  const int code = exit_code_in_child([] {
    sigset_t blocked;
    sigemptyset(&blocked);
    sigaddset(&blocked, SIGTERM);
    sigprocmask(SIG_BLOCK, &blocked, nullptr);
    watch_for_interrupt();
    raise(SIGTERM);
    return interruption();
  });
  EXPECT_EQ(code, 130);
}

TEST(Interrupt, ASecondKeyEndsTheProcess) {
  const int code = exit_code_in_child([] {
    watch_for_interrupt(std::chrono::milliseconds(0));
    raise(SIGINT);
    raise(SIGINT);
    return 0;
  });
  EXPECT_EQ(code, 130);
}

// one line says why the program ends, also when what follows it takes long
TEST(Interrupt, NothingIsSaidTwice) {
  const auto interrupted_twice = [](bool is_told) {
    watch_for_interrupt(std::chrono::milliseconds(0));
    raise(SIGINT);
    if (is_told) end_silently();
    raise(SIGINT);
  };
  const ::testing::ExitedWithCode ended(130);
  EXPECT_EXIT(interrupted_twice(false), ended, "^polhode: interrupted\n$");
  EXPECT_EXIT(interrupted_twice(true), ended, "^$");
}

TEST(Interrupt, WorkThatDoesNotListenIsEnded) {
  const auto begun = std::chrono::steady_clock::now();
  const int code = exit_code_in_child([] {
    watch_for_interrupt();
    raise(SIGTERM);
    while (true)
      pause();
    return 0;
  });
  EXPECT_EQ(code, 130);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(10));
}

TEST(Interrupt, WritingToAClosedPipeIsAnErrorCode) {
  const int code = exit_code_in_child([] {
    watch_for_interrupt();
    int ends[2];
    if (pipe(ends) != 0) return 1;
    close(ends[0]);
    return write(ends[1], "x", 1) == -1 && errno == EPIPE ? 0 : 2;
  });
  EXPECT_EQ(code, 0);
}

}  // namespace
}  // namespace polhode::test
