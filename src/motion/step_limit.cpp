// SPDX-License-Identifier: MIT
#include "motion/step_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {

double oscillation_rate(const BodyModel& model, const State& start) {
  const Vec3& J = model.inverse_moments;
  Eigen::Index least = 0, greatest = 0;
  J.minCoeff(&least);
  J.maxCoeff(&greatest);
  if (least == greatest) return 0.0;
  // 2T / |y|^2 says which of the two axes the momentum circles
  const Eigen::Index middle = 3 - least - greatest;
  const double twice_energy = start.y.cwiseProduct(start.y).dot(J);
  const Eigen::Index k = twice_energy < J[middle] * start.y.squaredNorm() ? least : greatest;
  const Eigen::Index i = (k + 1) % 3, j = (k + 2) % 3;
  return std::abs(start.y[k]) * std::sqrt(std::max(0.0, (J[k] - J[i]) * (J[k] - J[j])));
}

double step_limit(const StepperInfo& method, const BodyModel& model, const State& start) {
  const double rate = method.limit_of == StepLimit::oscillation ? oscillation_rate(model, start)
                      : method.limit_of == StepLimit::spin ? angular_velocity(model, start.y).norm()
                                                           : 0.0;
  return rate > 0.0 ? method.limit_turn / rate : std::numeric_limits<double>::infinity();
}

}  // namespace polhode
