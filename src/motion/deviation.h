// SPDX-License-Identifier: MIT
// How far apart two motions of one body are, and at which times to look.
#pragma once

#include <vector>

#include "motion/trajectory.h"

namespace polhode {

// The distance of two states: the angle between their attitudes, rad, or, with six degrees of
// freedom and if larger, the distance of their positions in radii of gyration, sqrt(greatest moment
// / mass). NaN if an attitude or, with six degrees of freedom, a position is NaN.
double deviation(const BodyModel& model, const State& a, const State& b);

// The largest deviation() of many pairs of states. Keeps a reference to the model.
class LargestDeviation {
 public:
  explicit LargestDeviation(const BodyModel& model) : model_(model) {}
  void look_at(const State& a, const State& b);
  // So far; 0 of no pair, NaN if one of them is NaN.
  double value() const { return value_; }

 private:
  const BodyModel& model_;
  double value_ = 0.0;
  double sine_ = 0.0;  // square of the sine of half the largest angle
};

// The largest deviation() of two motions at these times (s); NaN if one of them is NaN.
double largest_deviation(const BodyModel& model,
                         const Trajectory& a,
                         const Trajectory& b,
                         const std::vector<double>& times);

// The times (s, ascending) moved to where the states of `motion` cost nothing, except the last;
// each once. Where few would be left, because it rests or takes long steps, as they are: the motion
// that it is compared with may move more.
std::vector<double> cheap_times(const Trajectory& motion, const std::vector<double>& times);

// Times (s) in ascending order: 0, one at random in each of `parts` equal parts of the duration
// (s), and the duration. Equal distances, and multiples of an irrational number too, may meet a
// motion always in the same phases. The same on every machine; another `seed` gives other times.
std::vector<double> scattered_times(double duration, int parts, unsigned seed = 5489);

// Times up to `duration` (s, in order) at and after each of the first switches of loads, dense
// enough for a short pulse and for what it leaves: what happens there may be over before the next
// scattered time.
std::vector<double> times_after_switches(const std::vector<double>& switches, double duration);

// The times (s, ascending) at which to hold a motion against others: scattered_times(), and some
// soon after the start, after loads begin and end, and where an integration has far more to do than
// elsewhere. What is wrong while a body tumbles, that then forgets it, would else be over before
// the second time.
std::vector<double> times_to_compare(const BodyModel& model,
                                     const Trajectory& motion,
                                     double duration,
                                     int parts,
                                     unsigned seed = 5489);

}  // namespace polhode
