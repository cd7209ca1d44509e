// SPDX-License-Identifier: MIT
#include "motion/deviation.h"

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
  double largest = 0.0;
  for (const double t : times) {
    const double apart = deviation(model, a.at(t), b.at(t));
    if (!(apart <= largest)) largest = apart;
    if (std::isnan(largest)) break;
  }
  return largest;
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

}  // namespace polhode
