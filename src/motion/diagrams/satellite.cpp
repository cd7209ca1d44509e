// SPDX-License-Identifier: MIT
// Which satellites keep their attitude to the Earth: DeBra and Delp, J. Astronaut. Sci. 8 (1961)
// 14; Wie, Space Vehicle Dynamics and Control, section 6.7.
#include <algorithm>
#include <array>
#include <cmath>

#include "motion/diagram.h"

namespace polhode {
namespace {

constexpr int kBoundaryPieces = 200;

const Load* gradient_of(const BodyModel& model) {
  const std::vector<Load>& loads = model.loads.turning;
  const auto found = std::find_if(loads.begin(), loads.end(), [](const Load& load) {
    return load.kind == Load::Kind::gradient;
  });
  return found == loads.end() ? nullptr : &*found;
}

// The ratios of moments of a satellite whose principal axes with these indices are nearest to the
// normal of the orbit (pitch), the direction of flight (roll) and that of the Earth (yaw).
Vec2 ratios(const Vec3& moments, int pitch, int roll, int yaw) {
  return {(moments[pitch] - moments[roll]) / moments[yaw],
          (moments[pitch] - moments[yaw]) / moments[roll]};
}

// the lower of the two roots of 1 + 3 r + r y = 4 sqrt(r y) between 0 and -1/3, for y < 0
double limit_of_roll(double yaw) {
  // with u = sqrt(-r): (3 + y) u^2 + 4 sqrt(-y) u - 1 = 0
  const double b = 2.0 * std::sqrt(-yaw);
  const double u = 1.0 / (b + std::sqrt(b * b + 3.0 + yaw));
  return -u * u;
}

}  // namespace

std::string why_not_satellite(const Motion& motion) {
  const BodyModel& model = motion.model();
  const Load* gradient = gradient_of(model);
  if (gradient == nullptr || model.kind.rotator) {
    return "needs a satellite, neither a thin rod nor on a pivot: motion.torque = [{ kind = "
           "\"gravity_gradient\", rate = ... }]";
  }
  // damping, for one, brings down those that only rotation holds
  if (model.loads.turning.size() == 1 && gradient->acts.always()) return {};
  return "needs a satellite without other torques, whose gravity_gradient always acts";
}

// Small turns about the normal of the orbit swing if roll > yaw; those about the other two axes are
// bounded if roll yaw > 0 and 1 + 3 roll + roll yaw > 4 sqrt(roll yaw). All stable satellites are
// in two regions: that of Lagrange, and a small one found by DeBra and Delp, in which rotation
// holds what the gradient would turn over.
Diagram satellite_map(const Motion& motion) {
  using Kind = DiagramCurve::Kind;
  Diagram diagram;
  diagram.title = "moments of inertia";
  diagram.across = {"moments of inertia: (pitch − roll)/yaw", "", -1.0, 1.0};
  diagram.up = {"(pitch − yaw)/roll", "", -1.0, 1.0};
  diagram.curves.push_back({Kind::other, {{-1.0, 0.0}, {1.0, 0.0}}});
  diagram.curves.push_back({Kind::other, {{0.0, -1.0}, {0.0, 1.0}}});
  diagram.curves.push_back({Kind::other, {{-1.0, -1.0}, {1.0, 1.0}}});
  diagram.curves.push_back({Kind::boundary, {{0.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {0.0, 0.0}}});
  // from where roll = yaw meets the limit, 1 + 7 r + r^2 = 0, to yaw = -1
  DiagramCurve small{Kind::boundary, {{0.0, 0.0}}};
  const double corner = 0.5 * (std::sqrt(45.0) - 7.0);
  for (int i = 0; i <= kBoundaryPieces; ++i) {
    const double yaw = corner + (-1.0 - corner) * i / kBoundaryPieces;
    small.points.emplace_back(yaw, limit_of_roll(yaw));
  }
  small.points.emplace_back(-1.0, 0.0);
  small.points.emplace_back(0.0, 0.0);
  diagram.curves.push_back(std::move(small));

  diagram.now = [=](double t) -> Vec2 {
    const BodyModel& model = motion.model();
    const Quat q = motion.state_at(t).q;
    const Vec3 normal = (q.conjugate() * Vec3::UnitZ()).cwiseAbs();
    const Vec3 away = (q.conjugate() * away_from_earth(*gradient_of(model), t)).cwiseAbs();
    Eigen::Index pitch = 0;
    normal.maxCoeff(&pitch);
    const auto first = static_cast<int>((pitch + 1) % 3),
               second = static_cast<int>((pitch + 2) % 3);
    const bool nearer = away[first] > away[second];
    return ratios(
        model.moments, static_cast<int>(pitch), nearer ? second : first, nearer ? first : second);
  };
  return diagram;
}

}  // namespace polhode
