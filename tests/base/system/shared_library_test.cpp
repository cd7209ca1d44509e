// SPDX-License-Identifier: MIT
#include "base/system/shared_library.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"

namespace polhode::test {
namespace {

TEST(SharedLibrary, TakesTheFirstNameThatIsThere) {
  const SharedLibrary library({"libpolhode-no-such.so.1", "libm.so.6"});
  EXPECT_EQ(library.function<double(double)>("cos")(0.0), 1.0);
  expect_error([&] { library.function<void()>("no_such_function"); },
               Fault::environment,
               "",
               "no function no_such_function");
}

TEST(SharedLibrary, NamesTheFirstOfThoseThatAreMissing) {
  expect_error(
      [] {
        SharedLibrary({"libpolhode-first.so.1", "libpolhode-second.so.1"});
      },
      Fault::environment,
      "",
      "libpolhode-first.so.1");
}

}  // namespace
}  // namespace polhode::test
