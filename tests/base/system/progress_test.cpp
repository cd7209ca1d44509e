// SPDX-License-Identifier: MIT
#include "base/system/progress.h"

#include <algorithm>
#include <pty.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/ioctl.h>
#include <sys/stat.h>

#include "support/background.h"
#include "support/expect_error.h"

namespace polhode::test {
namespace {

// what it leaves on standard error when `done` of 40 are shown, 8 of them from before
std::string shown(ProgressKind kind, int done) {
  ::testing::internal::CaptureStderr();
  {
    Progress progress(kind, 40, "samples", 8);
    if (done + 8 == 40) {
      progress.show(done, "encoder");
    } else {
      // it may not print at once; once it has, its file has grown
      becomes([&] {
        progress.show(done);
        struct stat file {};
        return fstat(STDERR_FILENO, &file) == 0 && file.st_size > 0;
      });
    }
  }
  return ::testing::internal::GetCapturedStderr();
}

TEST(Progress, TheLastOneIsToldAtOnceAsJson) {
  const std::string line = shown(ProgressKind::json, 32);
  EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
  const nlohmann::json told = nlohmann::json::parse(line);
  EXPECT_EQ(told.at("done"), 40);
  EXPECT_EQ(told.at("total"), 40);
  EXPECT_EQ(told.at("seconds_left"), 0.0);
  EXPECT_EQ(told.at("limit"), "encoder");
  EXPECT_GT(told.at("samples_per_s"), 0.0);
}

// those from before take no time: the rate is of this run, and what is left follows from it
TEST(Progress, TheTimeLeftFollowsFromTheRateOfThisRun) {
  const nlohmann::json told = nlohmann::json::parse(shown(ProgressKind::json, 2));
  EXPECT_EQ(told.at("done"), 10);
  EXPECT_TRUE(told.at("limit").is_null());
  const double rate = told.at("samples_per_s"), left = told.at("seconds_left");
  // both are rounded, to 0.01 and 0.1
  EXPECT_LE(30.0 / (rate + 0.005), left + 0.05);
  EXPECT_GE(30.0 / (rate - 0.005), left - 0.05);
}

TEST(Progress, TheBarIsAsFullAsTheWorkAndEndsItsLine) {
  const std::string all = shown(ProgressKind::bar, 32);
  EXPECT_EQ(std::count(all.begin(), all.end(), '='), 30);
  EXPECT_NE(all.find("] 40/40 samples, "), std::string::npos) << all;
  EXPECT_NE(all.find(", encoder limits"), std::string::npos) << all;
  EXPECT_EQ(all.back(), '\n');
  const std::string half = shown(ProgressKind::bar, 12);
  EXPECT_EQ(std::count(half.begin(), half.end(), '='), 15);
  EXPECT_EQ(half.find('\n'), half.size() - 1) << "one line, redrawn";
}

// a wrapped line would stay when the next one is drawn
TEST(Progress, TheLineIsNoWiderThanTheTerminal) {
  for (const unsigned short width : {20, 40, 60, 200}) {
    int master = -1, slave = -1;
    winsize size = {24, width, 0, 0};
    ASSERT_EQ(openpty(&master, &slave, nullptr, nullptr, &size), 0);
    const int before = dup(STDERR_FILENO);
    dup2(slave, STDERR_FILENO);
    {
      Progress progress(ProgressKind::automatic, 1000000, "frames");
      progress.show(1000000, "drawing");
    }
    dup2(before, STDERR_FILENO);
    close(before);
    std::string line(1000, ' ');
    line.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(master, line.data(), 1000))));
    close(slave);
    close(master);
    line.erase(line.find_last_not_of("\r\n") + 1);
    EXPECT_LT(line.size() - 1, width) << line;
    EXPECT_NE(line.find("1000000/1000000"), std::string::npos) << line;
    EXPECT_EQ(line.find('[') != std::string::npos, width == 200) << line;
  }
}

TEST(Progress, NothingIsToldUnlessATerminalLooksOn) {
  EXPECT_EQ(shown(ProgressKind::none, 32), "");
  EXPECT_EQ(shown(ProgressKind::automatic, 32), "");
}

TEST(ParseProgress, KnowsItsNamesAndNoOthers) {
  EXPECT_EQ(parse_progress("auto"), ProgressKind::automatic);
  EXPECT_EQ(parse_progress("bar"), ProgressKind::bar);
  EXPECT_EQ(parse_progress("json"), ProgressKind::json);
  EXPECT_EQ(parse_progress("none"), ProgressKind::none);
  for (const std::string& name : progress_names())
    EXPECT_NO_THROW(parse_progress(name)) << name;
  expect_input_error([] { parse_progress("jsn"); }, "--progress", "did you mean 'json'?");
}

bool is_something_told() {
  struct stat file {};
  return fstat(STDERR_FILENO, &file) == 0 && file.st_size > 0;
}

// what a computation that says "half" leaves on standard error
std::string waited(ProgressKind kind, bool long_enough) {
  ::testing::internal::CaptureStderr();
  {
    Waiting waiting(kind);
    waiting.show("half");
    if (long_enough) {
      becomes([&] {
        waiting.show("half");
        return is_something_told();
      });
    }
  }
  return ::testing::internal::GetCapturedStderr();
}

TEST(Waiting, IsToldAfterAWhileAndClearsItsLine) {
  EXPECT_EQ(waited(ProgressKind::bar, false), "");
  EXPECT_EQ(waited(ProgressKind::bar, true), "\rhalf\r    \r");
  EXPECT_EQ(waited(ProgressKind::json, true), "{\"doing\":\"half\"}\n");
}

// what work that cannot tell how far it is leaves on standard error
std::string worked(ProgressKind kind, bool long_enough) {
  ::testing::internal::CaptureStderr();
  {
    const Busy busy(kind, "half");
    if (long_enough) becomes(is_something_told);
  }
  return ::testing::internal::GetCapturedStderr();
}

TEST(Busy, IsToldAfterAWhileAndClearsItsLine) {
  EXPECT_EQ(worked(ProgressKind::bar, false), "");
  EXPECT_EQ(worked(ProgressKind::none, false), "");
  EXPECT_EQ(worked(ProgressKind::bar, true), "\rhalf\r    \r");
  EXPECT_EQ(worked(ProgressKind::json, true), "{\"doing\":\"half\"}\n");
}

}  // namespace
}  // namespace polhode::test
