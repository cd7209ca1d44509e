// SPDX-License-Identifier: MIT
#include "base/system/console.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/in_child.h"

namespace polhode::test {
namespace {

TEST(Console, PrintsEveryByte) {
  const std::string text("a\0b\n", 4);
  ::testing::internal::CaptureStdout();
  print_out(text);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), text);
  ::testing::internal::CaptureStderr();
  print_err(text);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), text);
}

// the exit code of a child that prints to `file`
int printing_to(int file) {
  return exit_code_in_child([&] {
    std::signal(SIGPIPE, SIG_IGN);  // as main has it
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    print_err("words");
    try {
      print_out("data");
    } catch (const Error& error) {
      return static_cast<int>(error.fault());
    }
    return 0;
  });
}

TEST(Console, DataThatCannotBeWrittenIsAnError) {
  const int full = open("/dev/full", O_WRONLY);
  EXPECT_EQ(printing_to(full), static_cast<int>(Fault::environment));
  close(full);
}

TEST(Console, AReaderWhoHasGoneIsNoError) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  close(ends[0]);
  EXPECT_EQ(printing_to(ends[1]), 0);
  close(ends[1]);
}

// a file opened after the guard must not become standard output, and printing must still fail
TEST(Console, ClosedStreamsAreFilledByOnesThatRefuse) {
  const int code = exit_code_in_child([] {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      close(stream);
    guard_standard_streams();
    if (open("/dev/null", O_RDWR) <= STDERR_FILENO) return 1;
    char byte = 0;
    if (read(STDIN_FILENO, &byte, 1) != -1 || errno != EBADF) return 2;
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
      if (write(stream, &byte, 1) != -1 || errno != EBADF) return 3;
    }
    return 0;
  });
  EXPECT_EQ(code, 0);
}

TEST(Console, OpenStreamsAreLeftAlone) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const int code = exit_code_in_child([&] {
    dup2(ends[1], STDOUT_FILENO);
    guard_standard_streams();
    return write(STDOUT_FILENO, "x", 1) == 1 ? 0 : 1;
  });
  EXPECT_EQ(code, 0);
  char byte = 0;
  EXPECT_EQ(read(ends[0], &byte, 1), 1);
  EXPECT_EQ(byte, 'x');
  close(ends[0]);
  close(ends[1]);
}

}  // namespace
}  // namespace polhode::test
