// SPDX-License-Identifier: MIT
#include "export/key_times.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/system/interrupt.h"
#include "math/so3.h"

namespace polhode {
namespace {

constexpr double kTurnBetweenLooks = 0.5;  // rad
constexpr int kFewestLooks = 16;
constexpr double kMostLooks = 1e6;
constexpr double kJump = 1e-5;  // of the animation: what is longer is no jump
constexpr double kFalls = 0.5;  // of its error, where a motion that does not jump is halved twice
constexpr double kUnknown = std::numeric_limits<double>::infinity();
constexpr double kSafety = 0.75;  // of the tolerance: what is between the tested places is more
constexpr double kStill = 1e-3;   // of the tolerance
constexpr std::size_t kFewestTried = 4, kMostTried = 32;  // intervals
constexpr std::size_t kOneTriedOf = 8;

double in_single_precision(double value) {
  return static_cast<double>(static_cast<float>(value));
}

// The keys of one thing, as they are found.
class Search {
 public:
  Search(const Thing& thing,
         const std::function<Pose(double)>& pose_at,
         const AnimationClock& clock,
         double tolerance)
      : thing_(thing), pose_at_(pose_at), clock_(clock), tolerance_(tolerance) {}

  Pose exact(double played) const {
    stop_if_interrupted();
    return pose_at_(clock_.motion_time(played));
  }
  double error_at(double a, const Pose& pose_a, double b, const Pose& pose_b, double part) const {
    const double played = in_single_precision(a + part * (b - a));
    const double exact_part = (played - a) / (b - a);
    return distance(thing_, exact(played), between(thing_, pose_a, pose_b, exact_part));
  }
  // The keys after a up to b. A motion that is halved is followed better and better; a jump, and
  // what only rounding errors move, are not. `before`: the error of the interval of which this is a
  // half.
  void add(double a,
           const Pose& pose_a,
           double b,
           const Pose& pose_b,
           KeyedPoses& keys,
           std::array<double, 2> before = {kUnknown, kUnknown}) const {
    const double middle = in_single_precision(0.5 * (a + b));
    const bool divisible = middle > a && middle < b;
    const bool is_short = b - a <= kJump * clock_.duration();
    double error = 0.0;
    for (const double part : {0.5, 0.25, 0.75}) {
      if (divisible && (is_short || error <= kSafety * tolerance_))
        error = std::max(error, error_at(a, pose_a, b, pose_b, part));
    }
    const bool jumps = !divisible || (is_short && error > kFalls * before[1]);
    // at other places than those that decided, between which something short may have happened
    double measured = 0.0;
    for (const double part : {0.375, 0.625}) {
      if (!jumps && error <= kSafety * tolerance_)
        measured = std::max(measured, error_at(a, pose_a, b, pose_b, part));
    }
    if (!jumps && (error > kSafety * tolerance_ || measured > tolerance_)) {
      const Pose pose = exact(middle);
      std::array<double, 2> own = {kUnknown, before[0]};
      if (is_short) own[0] = error;
      add(a, pose_a, middle, pose, keys, own);
      add(middle, pose, b, pose_b, keys, own);
      return;
    }
    keys.times.push_back(b);
    keys.poses.push_back(pose_b);
    keys.error = std::max(keys.error, measured);
    require_few_keys(keys.times.size());
  }

 private:
  const Thing& thing_;
  const std::function<Pose(double)>& pose_at_;
  const AnimationClock& clock_;
  double tolerance_;
};

}  // namespace

void require_few_keys(std::size_t count) {
  if (count <= kMostKeys) return;
  throw input_error(
      "a table of this motion needs more than {} times; export a part of it with --from and --to, "
      "or ask for less with --accuracy, such as 1px",
      kMostKeys);
}

std::vector<double> first_times(const Motion& motion, const AnimationClock& clock) {
  const double turned = fastest_turn(motion) * (clock.to - clock.from);
  const double looks = std::ceil(turned / kTurnBetweenLooks) + kFewestLooks;
  if (!(looks < kMostLooks)) {
    throw input_error(
        "the body turns by {:.3g} radians, too much for a table of its motion; export a part of it "
        "with --from and --to",
        turned);
  }
  std::vector<double> times;
  for (int i = 0; i <= static_cast<int>(looks); ++i)
    times.push_back(in_single_precision(clock.duration() * i / std::floor(looks)));
  for (const double t : motion.model().loads.switches) {
    if (t > clock.from && t < clock.to)
      times.push_back(in_single_precision((t - clock.from) / clock.scale));
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

KeyedPoses keyed(const Thing& thing,
                 const std::function<Pose(double)>& pose_at,
                 const std::vector<double>& first,
                 const AnimationClock& clock,
                 double tolerance) {
  const Search search(thing, pose_at, clock, tolerance);
  KeyedPoses keys;
  keys.times = {first.front()};
  keys.poses = {search.exact(first.front())};
  keys.still = std::all_of(first.begin(), first.end(), [&](double played) {
    return distance(thing, keys.poses.front(), search.exact(played)) <= kStill * tolerance;
  });
  if (keys.still) return keys;
  for (std::size_t i = 0; i + 1 < first.size(); ++i)
    search.add(first[i], keys.poses.back(), first[i + 1], search.exact(first[i + 1]), keys);
  return keys;
}

double expected_keys(const Thing& thing,
                     const std::function<Pose(double)>& pose_at,
                     const std::vector<double>& first,
                     const AnimationClock& clock,
                     double tolerance,
                     double enough) {
  const Search search(thing, pose_at, clock, tolerance);
  const std::size_t intervals = first.size() - 1;
  const std::size_t tried =
      std::min(intervals, std::clamp(intervals / kOneTriedOf, kFewestTried, kMostTried));
  const double each = static_cast<double>(intervals) / static_cast<double>(tried);
  KeyedPoses keys;
  const Pose start = search.exact(first.front());
  bool still = true;
  const auto found = [&] {
    return static_cast<double>(keys.times.size()) * each;
  };
  for (std::size_t i = 0; i < tried && found() <= enough; ++i) {
    const std::size_t at = (2 * i + 1) * intervals / (2 * tried);
    const Pose pose = search.exact(first[at]);
    still = still && distance(thing, start, pose) <= kStill * tolerance;
    search.add(first[at], pose, first[at + 1], search.exact(first[at + 1]), keys);
  }
  return still ? 1.0 : found();
}

}  // namespace polhode
