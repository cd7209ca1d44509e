// SPDX-License-Identifier: MIT
#include "base/system/log.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace polhode {
namespace {

// what a warning and a remark leave on standard error
std::string logged(bool verbose) {
  spdlog::drop("polhode");
  ::testing::internal::CaptureStderr();
  start_log(verbose);
  spdlog::warn("look {}", 1);
  spdlog::info("by the way");
  spdlog::default_logger()->flush();
  return ::testing::internal::GetCapturedStderr();
}

TEST(Log, WarnsAlwaysAndRemarksWhenVerbose) {
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(logged(false), "polhode: warning: look 1\n");
  EXPECT_EQ(logged(true), "polhode: warning: look 1\npolhode: info: by the way\n");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "") << "standard output is for data";
}

TEST(Log, NamesOfFilesStayWithinTheLine) {
  spdlog::drop("polhode");
  ::testing::internal::CaptureStderr();
  start_log(false);
  spdlog::warn("a\nb\x1b[2J");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "polhode: warning: a b\\x1b[2J\n");
}

TEST(Log, WarningsOfAPieceOfWorkAreKept) {
  spdlog::drop("polhode");
  ::testing::internal::CaptureStderr();
  start_log(false);
  const std::vector<std::string> kept = warnings_of([] {
    for (const char* words : {"one", "two", "one"})
      spdlog::warn("{}", words);
  });
  EXPECT_EQ(kept, (std::vector<std::string>{"one", "two"}));
  spdlog::warn("after it");
  const auto fails = [] {
    spdlog::warn("before the end");
    throw std::runtime_error("the end");
  };
  EXPECT_THROW(warnings_of(fails), std::runtime_error);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
            "polhode: warning: after it\npolhode: warning: before the end\n");
}

}  // namespace
}  // namespace polhode
