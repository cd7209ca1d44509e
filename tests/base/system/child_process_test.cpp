// SPDX-License-Identifier: MIT
#include "base/system/child_process.h"

#include <csignal>

#include <gtest/gtest.h>

#include "support/expect_error.h"

namespace polhode::test {
namespace {

TEST(ChildProcess, TextGoesInAndComesOut) {
  // more than a pipe holds, so that reading and writing must go hand in hand
  std::string text;
  for (int i = 0; i < 200'000; ++i)
    text += std::to_string(i) + '\n';
  const ChildResult result = run_child({"cat"}, text);
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(result.out == text);
  EXPECT_EQ(result.err, "");
}

TEST(ChildProcess, WordsAreNotReadByAShell) {
  const ChildResult result = run_child({"printf", "%s|", "a b", "$(echo no)", "`id`", "'"}, "");
  EXPECT_EQ(result.out, "a b|$(echo no)|`id`|'|");
}

TEST(ChildProcess, ExitCodeAndSignalAreTold) {
  EXPECT_EQ(run_child({"sh", "-c", "echo word >&2; exit 7"}, "").status, 7);
  EXPECT_EQ(run_child({"sh", "-c", "echo word >&2; exit 7"}, "").err, "word\n");
  EXPECT_EQ(run_child({"sh", "-c", "kill -9 $$"}, "").status, 128 + 9);
}

// a program that does not read its input is no error of ours
TEST(ChildProcess, InputMayBeLeftUnread) {
  std::signal(SIGPIPE, SIG_IGN);  // as main has it
  EXPECT_EQ(run_child({"true"}, std::string(1 << 20, 'x')).status, 0);
}

TEST(ChildProcess, LimitsEndIt) {
  ChildLimits limits;
  limits.seconds = 0.2;
  const ChildResult slow = run_child({"sleep", "100"}, "", limits);
  EXPECT_EQ(slow.exceeded, "took longer than 0.2 s");
  EXPECT_EQ(slow.status, 128 + 9);
  limits = {};
  limits.output = 1000;
  EXPECT_EQ(run_child({"yes"}, "", limits).exceeded, "wrote more than 1000 bytes");
  limits = {};
  limits.memory = 50'000'000;
  const ChildResult large =
      run_child({"dd", "if=/dev/zero", "of=/dev/null", "bs=200M", "count=1"}, "", limits);
  EXPECT_NE(large.status, 0);
  EXPECT_EQ(large.exceeded, "");
}

TEST(ChildProcess, AMissingProgramIsTheEnvironment) {
  expect_error([] { run_child({"polhode-no-such-program"}, ""); },
               Fault::environment,
               "",
               "polhode-no-such-program");
}

}  // namespace
}  // namespace polhode::test
