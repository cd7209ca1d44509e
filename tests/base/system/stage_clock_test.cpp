// SPDX-License-Identifier: MIT
#include "base/system/stage_clock.h"

#include <algorithm>
#include <future>
#include <iterator>
#include <thread>

#include <gtest/gtest.h>

#include "support/background.h"

namespace polhode::test {
namespace {

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// keeps this thread's processor busy until its own clock says so
void burn(double seconds) {
  const double end = cpu_seconds() + seconds;
  while (cpu_seconds() < end) {
  }
}

// a shorter and a longer measurement of the same stretch hold the timer between them
TEST(StageTimer, AddsTheTimeOfItsScope) {
  constexpr double kRoundOff = 1e-9;
  StageTime stage{100.0, 200.0};
  const auto outer_wall = std::chrono::steady_clock::now();
  const double outer_cpu = cpu_seconds();
  double inner = 0.0;
  {
    const StageTimer timer(stage);
    const double begin = cpu_seconds();
    burn(2e-3);
    inner = cpu_seconds() - begin;
  }
  const double cpu = cpu_seconds() - outer_cpu;
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - outer_wall;
  EXPECT_GE(stage.cpu_s, 200.0 + inner - kRoundOff);
  EXPECT_LE(stage.cpu_s, 200.0 + cpu + kRoundOff);
  EXPECT_GE(stage.wall_s, 100.0 + 2e-3 - kRoundOff);
  EXPECT_LE(stage.wall_s, 100.0 + wall.count() + kRoundOff);
}

TEST(StageTimer, CountsItsOwnThreadOnly) {
  StageTime stage;
  const double before = cpu_seconds();
  {
    const StageTimer timer(stage);
    std::thread([] { burn(0.02); }).join();
  }
  EXPECT_LE(stage.cpu_s, cpu_seconds() - before);
  EXPECT_LT(stage.cpu_s, 0.02);
  EXPECT_GE(stage.wall_s, 0.02);
}

// a thread that burns some time, then waits to be sent away
class Helper {
 public:
  explicit Helper(double seconds)
      : thread_([this, seconds] {
          burn(seconds);
          burnt_.set_value();
          leave_.get_future().wait();
        }) {
    burnt_.get_future().wait();
  }
  void leave() {
    leave_.set_value();
    thread_.join();
  }

 private:
  std::promise<void> burnt_, leave_;
  std::thread thread_;  // last: it uses the others
};

TEST(ThreadClocks, ReadThreadsThatLiveAndRememberThoseThatEnded) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "the sanitizer starts a thread of its own";
#endif
  const std::set<int> before = thread_ids();
  EXPECT_GE(before.size(), 1U);
  Helper helper(0.01);
  const std::set<int> now = thread_ids();
  std::set<int> added;
  std::set_difference(
      now.begin(), now.end(), before.begin(), before.end(), std::inserter(added, added.end()));
  ASSERT_EQ(added.size(), 1U);

  ThreadClocks clocks(added);
  EXPECT_EQ(clocks.total(), 0.0);
  EXPECT_TRUE(becomes([&] {
    clocks.read();
    return clocks.total() >= 0.01;
  })) << clocks.total();
  const double last = clocks.total();
  helper.leave();
  EXPECT_TRUE(becomes([&] { return thread_ids() == before; }));
  clocks.read();
  EXPECT_GE(clocks.total(), last);
}

}  // namespace
}  // namespace polhode::test
