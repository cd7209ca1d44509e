// SPDX-License-Identifier: MIT
#include "app/divided_work.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace polhode {

double seconds_of(const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double mean_seconds(const std::function<void(int k)>& sample) {
  constexpr double kEnough = 1.0;  // s
  constexpr int kMost = 32;
  double sum = 0.0;
  int count = 0;
  while (count == 0 || (count < kMost && sum * (count + 1) / count < kEnough)) {
    sum += seconds_of([&] { sample(count); });
    ++count;
  }
  return sum / count;
}

long spread_over(int k, long count) {
  constexpr double kGolden = 0.6180339887498949;
  const double place = std::fmod(0.5 + k * kGolden, 1.0);
  return std::min(count - 1, static_cast<long>(place * static_cast<double>(count)));
}

}  // namespace polhode
