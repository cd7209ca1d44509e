// SPDX-License-Identifier: MIT
#include "base/system/system_error.h"

#include <cerrno>

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(SystemError, WhatTheMachineLacksIsNotBadInput) {
  for (const int reason : {ENOMEM, EMFILE, ENFILE, ENOSPC, EDQUOT, EIO})
    EXPECT_EQ(fault_of(reason), Fault::environment) << reason;
  for (const int reason : {0, ENOENT, EACCES, ENOTDIR, EISDIR, ELOOP, ENAMETOOLONG})
    EXPECT_EQ(fault_of(reason), Fault::input) << reason;
}

// another name does not help against too many open files
TEST(SystemError, AdviceIsForBadInput) {
  EXPECT_STREQ(system_error(EACCES, "cannot be read", "choose another").what(),
               "cannot be read: Permission denied; choose another");
  EXPECT_STREQ(system_error(EMFILE, "cannot be read", "choose another").what(),
               "cannot be read: Too many open files");
}

}  // namespace
}  // namespace polhode
