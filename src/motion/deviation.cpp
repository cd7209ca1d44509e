// SPDX-License-Identifier: MIT
#include "motion/deviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "math/so3.h"

namespace polhode {

double deviation(const BodyModel& model, const State& a, const State& b) {
  const double turned = rotation_angle_between(a.q, b.q);
  if (!model.with_translation) return turned;
  const double gyration = std::sqrt(model.moments.maxCoeff() / model.body.mass);
  const double moved = (a.place_S - b.place_S).norm() / gyration;
  return turned > moved || std::isnan(turned) ? turned : moved;
}

double largest_deviation(const BodyModel& model,
                         const Trajectory& a,
                         const Trajectory& b,
                         const std::vector<double>& times) {
  const std::vector<State> of_a = a.at_each(times), of_b = b.at_each(times);
  LargestDeviation largest(model);
  for (std::size_t i = 0; i < times.size(); ++i)
    largest.look_at(of_a[i], of_b[i]);
  return largest.value();
}

void LargestDeviation::look_at(const State& a, const State& b) {
  // angles grow with the sines of their halves, which cost less
  const double sine = (a.q.conjugate() * b.q).vec().squaredNorm();
  if (sine <= sine_ && !model_.with_translation) return;
  sine_ = sine;
  const double apart = deviation(model_, a, b);
  if (!(apart <= value_) && !std::isnan(value_)) value_ = apart;
}

std::vector<double> cheap_times(const Trajectory& motion, const std::vector<double>& times) {
  constexpr std::size_t kFewer = 4;  // times
  std::vector<double> kept = motion.kept_times(times);
  if (!times.empty()) kept.back() = times.back();
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kFewer * kept.size() < times.size() ? times : kept;
}

std::vector<double> times_after_switches(const std::vector<double>& switches, double duration) {
  constexpr std::size_t kMostSwitches = 64;
  constexpr double kAfter = 0.01;  // of the duration
  constexpr std::array<double, 12> kParts = {
      0.0, 1.0 / 64, 1.0 / 32, 1.0 / 16, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0};
  std::vector<double> times;
  for (std::size_t i = 0; i < std::min(switches.size(), kMostSwitches); ++i) {
    if (!(switches[i] < duration)) break;
    const double next = i + 1 < switches.size() ? switches[i + 1] : duration;
    const double gap = std::min({next, duration, switches[i] + kAfter * duration}) - switches[i];
    for (const double part : kParts)
      times.push_back(switches[i] + part * gap);
  }
  std::sort(times.begin(), times.end());
  return times;
}

std::vector<double> scattered_times(double duration, int parts, unsigned seed) {
  std::mt19937 random(seed);  // its numbers are those of the standard
  std::vector<double> times = {0.0};
  for (int i = 0; i < parts; ++i) {
    const double inside = static_cast<double>(random()) / 0x1p32;
    times.push_back(duration * (i + inside) / parts);
  }
  times.push_back(duration);
  return times;
}

std::vector<double> times_to_compare(
    const BodyModel& model, const Trajectory& motion, double duration, int parts, unsigned seed) {
  constexpr double kFarMore = 4.0;
  // what is over sooner, such as a passage near gimbal lock, is not looked at while it lasts
  constexpr double kShortest = 1e-8;  // of the motion
  constexpr int kHalvings = 10;
  std::vector<double> times = scattered_times(duration, parts, seed);
  const double each = duration / static_cast<double>(times.size());
  const std::vector<double> busy = motion.busy_times(times.size());
  std::vector<double> more = times_after_switches(model.loads.switches, duration);
  for (int i = 1; i <= kHalvings; ++i)
    more.push_back(std::ldexp(each, -i));
  for (std::size_t i = 1; i < busy.size(); ++i) {
    const double gap = busy[i] - busy[i - 1];
    if (kFarMore * gap < each && gap > kShortest * duration) more.push_back(busy[i]);
  }
  times.insert(times.end(), more.begin(), more.end());
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace polhode
