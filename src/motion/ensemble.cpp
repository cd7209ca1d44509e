// SPDX-License-Identifier: MIT
#include "motion/ensemble.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>

#include "base/error.h"
#include "math/so3.h"
#include "motion/convoy.h"
#include "motion/motion.h"

namespace polhode {
namespace {

// a point of the unit ball, evenly; by hand, since distributions differ between libraries
Vec3 point_in_ball(std::mt19937& numbers) {
  const auto number = [&] {
    return 2.0 * (static_cast<double>(numbers()) + 0.5) / 4294967296.0 - 1.0;
  };
  for (;;) {
    // one by one: compilers choose the order of arguments
    Vec3 point;
    for (const int axis : {2, 1, 0})
      point[axis] = number();
    if (point.squaredNorm() <= 1.0) return point;
  }
}

// A body whose mass lies on a line has no momentum along it. vector_B: angular momentum.
Vec3 without_spin_about_line(const BodyModel& model, const Vec3& vector_B) {
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis_B = model.R_BP.col(i);
    if (!(model.moments[i] > 0.0)) return vector_B - axis_B * axis_B.dot(vector_B);
  }
  return vector_B;
}

}  // namespace

void check_ensemble(const MotionSpec& spec) {
  if (!spec.ensemble || spec.ensemble->tilt != 0.0 || spec.ensemble->momentum != 0.0) return;
  throw input_error("all its motions begin alike; give tilt_deg or momentum")
      .at({{}, 0, "motion.ensemble"});
}

std::vector<MotionSpec> ensemble_of(const BodyModel& model, const MotionSpec& spec) {
  check_ensemble(spec);
  if (!spec.ensemble) return {};
  const EnsembleSpec& ensemble = *spec.ensemble;
  const State start = start_state(model, spec);
  const Vec3 L_S = start.q * start.y;
  const Quat q_SB = start.q * Quat(model.R_BP).conjugate();
  std::mt19937 numbers(1);
  std::vector<MotionSpec> members;
  for (int k = 0; k < ensemble.members; ++k) {
    const Quat q = exp_rotation(ensemble.tilt * point_in_ball(numbers)) * q_SB;
    // L stays where it is in space, but for its own change
    const Vec3 L = L_S + ensemble.momentum * L_S.norm() * point_in_ball(numbers);
    MotionSpec member = spec;
    member.ensemble.reset();
    member.attitude = {};
    member.attitude.quaternion = Eigen::Vector4d(q.w(), q.x(), q.y(), q.z());
    member.spin = {};
    member.spin.momentum_body = without_spin_about_line(model, q.conjugate() * L);
    members.push_back(std::move(member));
  }
  return members;
}

std::vector<Simulation> simulate_ensemble(const BodyModel& model,
                                          const std::vector<MotionSpec>& members,
                                          const NumericsSpec& numerics,
                                          double accuracy_rad,
                                          int jobs) {
  const auto count = static_cast<long>(members.size());
  std::vector<std::optional<Simulation>> found(members.size());
  const auto solve = [&](long i) {
    const auto k = static_cast<std::size_t>(i);
    const SimulationReport* neighbour = i < kLanes ? nullptr : &found[0]->report;
    found[k] = simulate(model, members[k], numerics, accuracy_rad, {}, neighbour);
  };
  const long first = std::min<long>(count, kLanes);
  parallel_in_convoys(first, jobs, solve);
  parallel_in_convoys(count - first, jobs, [&](long i) { solve(first + i); });
  std::vector<Simulation> motions;
  motions.reserve(members.size());
  for (std::optional<Simulation>& one : found)
    motions.push_back(std::move(*one));
  return motions;
}

}  // namespace polhode
