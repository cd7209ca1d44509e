// SPDX-License-Identifier: MIT
#include "base/system/parallel.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace polhode::test {
namespace {

TEST(ParallelFor, EachPieceIsDoneOnce) {
  for (const int jobs : {0, 1, 2, 7}) {
    std::vector<std::atomic<int>> done(1000);
    parallel_for(1000, jobs, [&](long i) { ++done[static_cast<std::size_t>(i)]; });
    for (const std::atomic<int>& times : done)
      EXPECT_EQ(times, 1);
  }
  parallel_for(0, 0, [](long) { FAIL(); });
}

TEST(ParallelFor, AnExceptionStopsTheRestAndIsThrownAgain) {
  std::atomic<long> done = 0;
  const auto work = [&](long i) {
    if (i == 10) throw std::runtime_error("ten");
    ++done;
  };
  EXPECT_THROW(parallel_for(1'000'000'000, 2, work), std::runtime_error);
  EXPECT_LT(done, 1'000'000'000);
}

}  // namespace
}  // namespace polhode::test
