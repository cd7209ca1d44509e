// SPDX-License-Identifier: MIT
#include "export/key_times.h"

#include <csignal>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/system/interrupt.h"
#include "math/so3.h"
#include "support/expect_error.h"
#include "support/in_child.h"
#include "support/motions.h"

namespace polhode {
namespace {

Thing ball() {
  Thing thing;
  thing.low = Vec3::Constant(-1.0);
  thing.high = Vec3::Constant(1.0);
  return thing;
}

std::vector<double> looks(int count) {
  std::vector<double> times;
  for (int i = 0; i <= count; ++i)
    times.push_back(static_cast<double>(static_cast<float>(1.0 * i / count)));
  return times;
}

const AnimationClock kSecond{0.0, 1.0, 1.0};

// slerp is exact for it
TEST(KeyTimes, AUniformRotationNeedsNoMoreThanTheFirstTimes) {
  const auto pose_at = [](double t) {
    return Pose{Vec3::Zero(), exp_rotation(Vec3(0, 0, 3.0 * t)), Vec3::Ones()};
  };
  const KeyedPoses keys = keyed(ball(), pose_at, looks(6), kSecond, 1e-6);
  EXPECT_EQ(keys.times.size(), 7u);
  EXPECT_LT(keys.error, 1e-12);
}

// of x = a t^2 / 2, a chord over h is off by a h^2 / 8 at its middle
TEST(KeyTimes, AreAsDenseAsTheAccelerationAsks) {
  const double a = 8.0, tolerance = 1e-4;
  const auto pose_at = [&](double t) {
    return Pose{Vec3(0.5 * a * t * t, 0, 0), Quat::Identity(), Vec3::Ones()};
  };
  const KeyedPoses keys = keyed(ball(), pose_at, looks(1), kSecond, tolerance);
  EXPECT_LE(keys.error, tolerance);
  const double needed = std::sqrt(a / (8.0 * tolerance));  // intervals, if they were all as long
  EXPECT_GE(keys.times.size(), needed);
  EXPECT_LE(keys.times.size(),
            3.0 * needed);  // halving wastes up to a factor of two, and the safety
  for (const double t : keys.times)
    EXPECT_EQ(t, static_cast<double>(static_cast<float>(t)));
}

// as of a rate of Euler's angles where the body passes gimbal lock
TEST(KeyTimes, ASpikeBetweenTheTestedPlacesIsSeen) {
  const double tolerance = 1e-3;
  const auto pose_at = [](double t) {
    const double spike = std::exp(-std::pow((t - 0.375) / 0.01, 2));
    return Pose{Vec3(spike, t, 0), Quat::Identity(), Vec3::Ones()};
  };
  const KeyedPoses keys = keyed(ball(), pose_at, looks(1), kSecond, tolerance);
  EXPECT_LE(keys.error, tolerance);
  double highest = 0.0;
  for (const Pose& pose : keys.poses)
    highest = std::max(highest, pose.at.x());
  EXPECT_NEAR(highest, 1.0, tolerance);
}

// a long animation of a fast motion: an interval may be shorter than what a jump takes
TEST(KeyTimes, AreAsCloseAsALongAnimationAsks) {
  constexpr double kFast = 400.0;  // rad/s
  const AnimationClock clock{0.0, 300.0, 1.0};
  const auto pose_at = [](double t) {
    return Pose{Vec3(std::sin(kFast * t), 0, 0), Quat::Identity(), Vec3::Ones()};
  };
  std::vector<double> first;
  for (int i = 0; i <= 200; ++i)
    first.push_back(static_cast<double>(static_cast<float>(200.0 + 0.005 * i)));
  constexpr double kTolerance = 1e-3;
  const KeyedPoses keys = keyed(ball(), pose_at, first, clock, kTolerance);
  double most = 0.0;
  for (std::size_t i = 0; i + 1 < keys.times.size(); ++i) {
    const double middle = 0.5 * (keys.times[i] + keys.times[i + 1]);
    const double between = 0.5 * (keys.poses[i].at.x() + keys.poses[i + 1].at.x());
    most = std::max(most, std::abs(between - std::sin(kFast * middle)));
  }
  EXPECT_LE(most, kTolerance);
  EXPECT_GT(keys.error, 0.3 * most) << "as it is told";
}

TEST(KeyTimes, AJumpTakesAMomentAndIsNoError) {
  const auto pose_at = [](double t) {
    return Pose{Vec3(t < 0.4 ? 0.0 : 1.0, 0, 0), Quat::Identity(), Vec3::Ones()};
  };
  const KeyedPoses keys = keyed(ball(), pose_at, looks(4), kSecond, 1e-3);
  EXPECT_LT(keys.times.size(), 64u);
  EXPECT_EQ(keys.error, 0.0);
  for (std::size_t i = 0; i + 1 < keys.times.size(); ++i) {
    if (keys.poses[i].at.x() != keys.poses[i + 1].at.x()) {
      EXPECT_LT(keys.times[i + 1] - keys.times[i], 2e-5);
    }
  }
}

TEST(KeyTimes, WhatIsStillHasOnePose) {
  const auto pose_at = [](double) {
    return Pose{Vec3(1, 2, 3), Quat::Identity(), Vec3::Ones()};
  };
  const KeyedPoses keys = keyed(ball(), pose_at, looks(4), kSecond, 1e-3);
  EXPECT_TRUE(keys.still);
  EXPECT_EQ(keys.poses.size(), 1u);
}

// how a round thing is turned about its own axis says nothing
TEST(KeyTimes, ARoundThingMayTurnAboutItsAxis) {
  Thing rod = ball();
  rod.kind = ThingKind::rod;
  rod.round = true;
  const auto pose_at = [](double t) {
    return Pose{Vec3::Zero(), exp_rotation(Vec3(0, 0, 100.0 * t * t)), Vec3(0.1, 0.1, 1.0)};
  };
  EXPECT_TRUE(keyed(rod, pose_at, looks(4), kSecond, 1e-6).still);
}

// a level cone that opens up or down is the same disc
TEST(KeyTimes, ARingMayTurnOver) {
  Thing ring = ball();
  ring.round = true;
  ring.low.z() = -0.1;
  ring.high.z() = 0.1;
  const auto pose_at = [](double t) {
    const bool over = std::fmod(10.0 * t, 1.0) > 0.5;
    return Pose{Vec3::Zero(), exp_rotation(Vec3(over ? kPi : 0.0, 0, 0)), Vec3::Ones()};
  };
  EXPECT_TRUE(keyed(ring, pose_at, looks(8), kSecond, 1e-6).still);
}

TEST(KeyTimes, FirstTimesFollowTheBody) {
  const Motion motion = test::moving(test::prolate_body(), test::wobbling());
  const AnimationClock clock{0.0, motion.duration(), 2.0};
  const std::vector<double> times = first_times(motion, clock);
  EXPECT_EQ(times.front(), 0.0);
  EXPECT_NEAR(times.back(), clock.duration(), 1e-6 * clock.duration());
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const Quat a = motion.at(clock.motion_time(times[i])).q_SB;
    const Quat b = motion.at(clock.motion_time(times[i + 1])).q_SB;
    EXPECT_LT(rotation_angle_between(a, b), 0.51);
  }
}

// in a process of its own: an interrupt stays
TEST(KeyTimes, AreNotSoughtAfterAnInterrupt) {
  const auto work = [] {
    watch_for_interrupt();
    raise(SIGINT);
    try {
      keyed(
          {}, [](double) { return Pose{}; }, looks(8), kSecond, 1e-6);
    } catch (const Error& error) {
      return static_cast<int>(error.fault());
    }
    return 0;
  };
  EXPECT_EQ(test::exit_code_in_child(work), 130);
}

// a file has no room for a motion of millions of turns
TEST(KeyTimes, TooManyAreRefused) {
  require_few_keys(kMostKeys);
  test::expect_input_error(
      [] { require_few_keys(kMostKeys + 1); }, "", "export a part of it with --from and --to");
}

// of a vibration, parts tell how many there will be, and no more is looked at than is needed
TEST(KeyTimes, AreExpectedFromAFewIntervals) {
  int looked = 0;
  const auto pose_at = [&](double t) {
    ++looked;
    return Pose{Vec3(0.1 * std::sin(300.0 * t), 0, 0), Quat::Identity(), Vec3::Ones()};
  };
  const auto expected = [&](double enough) {
    looked = 0;
    return expected_keys(ball(), pose_at, looks(400), kSecond, 1e-4, enough);
  };
  const auto found =
      static_cast<double>(keyed(ball(), pose_at, looks(400), kSecond, 1e-4).times.size());
  EXPECT_GT(found, 1000.0);
  EXPECT_NEAR(expected(1e9), found, 0.15 * found);
  const int all = looked;
  EXPECT_GT(expected(100.0), 100.0);
  EXPECT_LT(looked, all / 4);
}

}  // namespace
}  // namespace polhode
