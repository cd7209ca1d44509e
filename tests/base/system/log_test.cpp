// SPDX-License-Identifier: MIT
#include "base/system/log.h"

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

}  // namespace
}  // namespace polhode
