// SPDX-License-Identifier: MIT
#include "base/system/child_process.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "support/expect_error.h"
#include "support/in_child.h"
#include "support/run.h"

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

TEST(ChildProcess, HowItEndedIsWorded) {
  const auto words = [](const char* script) {
    return how_it_ended(run_child({"sh", "-c", script}, ""));
  };
  EXPECT_EQ(words("echo; echo no disk >&2; echo more >&2; exit 7"),
            "ended with exit code 7: no disk");
  EXPECT_EQ(words("exit 7"), "ended with exit code 7");
  EXPECT_EQ(words("exit 139"), "ended with exit code 139");
  EXPECT_EQ(words("kill -SEGV $$"), "was ended by signal 11 (Segmentation fault)");
  EXPECT_EQ(how_it_ended(run_child({"sleep", "100"}, "", {.seconds = 0.1})),
            "took longer than 0.1 s");
}

// what it leaves behind holds its output open
TEST(ChildProcess, NobodyWaitsForItsOwnChildren) {
  std::signal(SIGPIPE, SIG_IGN);  // as main has it: nobody reads the input
  const auto start = std::chrono::steady_clock::now();
  const ChildResult ran = run_child({"sh", "-c", "sleep 20 & echo word"}, "unread");
  EXPECT_EQ(ran.out, "word\n");
  EXPECT_EQ(ran.status, 0);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

// a helper of a killed browser wrote to a folder that was being removed
TEST(ChildProcess, WhatItLeavesBehindIsGoneWithIt) {
  std::signal(SIGPIPE, SIG_IGN);
  for (const std::string ending : {"exit 0", "kill -ABRT $$"}) {
    const TemporaryFolder folder;
    const std::string script =
        "while :; do mkdir -p \"$0/left\"; done & while [ ! -d \"$0/left\" ]; do :; done; " +
        ending;
    run_child({"sh", "-c", script, folder.path().string()}, "");
    std::filesystem::remove_all(folder / "left");
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(folder.entries(), 0) << ending;
  }
}

TEST(ChildProcess, AProgramIsAskedForItsVersion) {
  const TemporaryFolder folder;
  const auto found = [&](const std::string& script) {
    write_text(folder / "program", "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(folder / "program", std::filesystem::perms::owner_all);
    return find_program(folder / "program");
  };
  EXPECT_EQ(found("echo program 1.2; echo words").version, "program 1.2");
  EXPECT_EQ(found("echo program 1.2").why_not, "");
  const std::string name = folder / "program";
  EXPECT_EQ(found("exit 0").why_not, name + " tells no version");
  EXPECT_EQ(found("echo broken >&2; exit 7").why_not, name + " ended with exit code 7: broken");
  EXPECT_EQ(found("exec yes").why_not, name + " wrote more than 1048576 bytes");
  EXPECT_TRUE(found("exit 7").installed);
  EXPECT_FALSE(find_program(folder / "none").installed);
  EXPECT_EQ(find_program(folder / "none").why_not, folder / "none" + " is not installed");
}

TEST(ChildProcess, WhatCannotBeStartedIsInstalled) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer needs descriptors of its own to look at memory";
#endif
  const auto told = [] {
    const rlimit few{4, 4};
    setrlimit(RLIMIT_NOFILE, &few);
    const ProgramFound found = find_program("cat");
    return found.installed && found.why_not.ends_with("Too many open files") ? 0 : 1;
  };
  EXPECT_EQ(exit_code_in_child(told), 0);
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

TEST(ChildProcess, WhatItHasStartedIsEndedWithIt) {
  const TemporaryFolder folder;
  const std::string mark = folder / "mark";
  const ChildResult result =
      run_child({"sh", "-c", "(sleep 1; touch \"$0\") & wait", mark}, "", {.seconds = 0.2});
  EXPECT_EQ(result.exceeded, "took longer than 0.2 s");
  std::this_thread::sleep_for(std::chrono::milliseconds(1300));
  EXPECT_EQ(folder.entries(), 0);
}

TEST(ChildProcess, AMissingProgramIsTheEnvironment) {
  expect_error([] { run_child({"polhode-no-such-program"}, ""); },
               Fault::environment,
               "",
               "polhode-no-such-program is not installed");
}

}  // namespace
}  // namespace polhode::test
