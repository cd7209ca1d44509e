// SPDX-License-Identifier: MIT
// Holds an Error to its promises: its fault, the key it names, and a word of its message.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "base/error.h"

namespace polhode::test {

template <class Action>
void expect_error(Action action, Fault fault, const std::string& key, const std::string& words) {
  SCOPED_TRACE("expected: " + key + ": ..." + words + "...");
  try {
    action();
    ADD_FAILURE() << "no error was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.fault(), fault) << error.what();
    EXPECT_EQ(error.place().key, key) << error.what();
    EXPECT_NE(error.message().find(words), std::string::npos) << error.what();
  }
}

template <class Action>
void expect_input_error(Action action, const std::string& key, const std::string& words) {
  expect_error(action, Fault::input, key, words);
}

}  // namespace polhode::test
