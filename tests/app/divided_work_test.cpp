// SPDX-License-Identifier: MIT
#include "app/divided_work.h"

#include <algorithm>
#include <set>
#include <thread>

#include <gtest/gtest.h>

namespace polhode {
namespace {

// of any length, the series leaves no gap larger than a few times the mean one
TEST(SpreadOver, LeavesNoGaps) {
  for (const int length : {5, 20, 100}) {
    std::set<long> places = {0, 10000};
    for (int k = 0; k < length; ++k)
      places.insert(spread_over(k, 10000));
    long widest = 0;
    for (auto place = std::next(places.begin()); place != places.end(); ++place)
      widest = std::max(widest, *place - *std::prev(place));
    EXPECT_LT(widest, 3 * 10000 / length) << length;  // measured: 2.0
  }
}

TEST(SpreadOver, StaysInside) {
  for (int k = 0; k < 1000; ++k) {
    EXPECT_EQ(spread_over(k, 1), 0);
    const long place = spread_over(k, 7);
    EXPECT_TRUE(place >= 0 && place < 7);
  }
}

TEST(MeanSeconds, CountsEachSample) {
  int samples = 0;
  const double mean = mean_seconds([&](int k) {
    EXPECT_EQ(k, samples++);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  EXPECT_EQ(samples, 32);
  EXPECT_GE(mean, 1e-3);
}

}  // namespace
}  // namespace polhode
