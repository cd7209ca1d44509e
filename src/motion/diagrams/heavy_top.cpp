// SPDX-License-Identifier: MIT
// The tilt theta of a heavy symmetric top moves like a particle in one dimension: I1 theta'^2 / 2 +
// U(theta) is constant, with U = (L_z - L_3 cos theta)^2 / (2 I1 sin^2 theta) + m g l cos theta.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "math/so3.h"
#include "motion/diagram.h"

namespace polhode {
namespace {

constexpr int kTiltPieces = 400;      // of a curve
constexpr double kLeastReach = 0.12;  // rad that a picture shows on each side of a steady motion
constexpr double kOverEnergy = 2.2;   // height of a picture, in units of the depth of the motion
constexpr double kFree = 0.06;        // of the axes, beside what is shown

struct HeavyTop {
  Vec3 axis_P;    // from the pivot to the centre of mass, unit
  double I1;      // about an axis across it, kg m^2
  double mgl;     // J
  double L3;      // momentum about the axis
  double minus;   // L_z - L_3; zero where the axis can pass upright
  double plus;    // L_z + L_3; zero where it can pass straight down
  double energy;  // without that of the rotation about the axis, J

  bool passes_upright() const { return minus == 0.0; }
  bool passes_down() const { return plus == 0.0; }
  // it swings in a plane
  bool is_pendulum() const { return passes_upright() && passes_down(); }

  // J; infinite at a pole that the axis cannot reach
  double potential(double tilt) const {
    const double s = std::sin(0.5 * tilt), c = std::cos(0.5 * tilt);
    // L_z - L_3 cos(tilt), from the nearer pole
    const double turning = tilt < 0.5 * kPi ? minus + 2.0 * L3 * s * s : plus - 2.0 * L3 * c * c;
    const double weight = mgl * std::cos(tilt);
    if (turning == 0.0) return weight;
    if (passes_upright() && tilt < 0.5 * kPi) return L3 * L3 * s * s / (2.0 * I1 * c * c) + weight;
    if (passes_down() && tilt >= 0.5 * kPi) return L3 * L3 * c * c / (2.0 * I1 * s * s) + weight;
    const double sine = 2.0 * s * c;
    return turning * turning / (2.0 * I1 * sine * sine) + weight;
  }
};

HeavyTop heavy_top(const Motion& motion) {
  const BodyModel& model = motion.model();
  const State start = motion.state_at(0.0);
  HeavyTop top;
  top.axis_P = model.chi_P.normalized();
  top.mgl = model.chi_P.norm();
  top.I1 = model.moments[model.kind.symmetric() ? (model.kind.axis + 1) % 3 : 0];
  top.L3 = start.y.dot(top.axis_P);
  const Vec3 up = up_in_body(model, start.q);
  const double Lz = start.y.dot(up);
  const double rounding = 1e-12 * (std::abs(Lz) + std::abs(top.L3) + std::sqrt(top.mgl * top.I1));
  const auto exact_zero = [&](double value) {
    return std::abs(value) < rounding ? 0.0 : value;
  };
  top.minus = exact_zero(Lz - top.L3);
  top.plus = exact_zero(Lz + top.L3);
  if (top.is_pendulum()) top.L3 = 0.0;
  const double across2 = std::max(0.0, start.y.squaredNorm() - top.L3 * top.L3);
  top.energy = 0.5 * across2 / top.I1 + top.mgl * up.dot(top.axis_P);
  return top;
}

// the tilt of least potential: it has one minimum
double steady_tilt(const HeavyTop& top) {
  double low = 0.0, high = kPi;
  for (int i = 0; i < 200; ++i) {
    const double third = (high - low) / 3.0;
    if (top.potential(low + third) < top.potential(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  return 0.5 * (low + high);
}

// the tilt between `inside`, whose potential is below `level`, and the pole `end` where it reaches
// it; the pole if it never does
double reached(const HeavyTop& top, double level, double inside, double end) {
  if (top.potential(end) <= level) return end;
  double outside = end;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (inside + outside);
    (top.potential(middle) <= level ? inside : outside) = middle;
  }
  return inside;
}

// What a picture shows of the potential: between these tilts (rad), from the least value to `most`.
struct Window {
  double steady, low, high;  // rad
  double least, most;        // J
};
Window window_of(const HeavyTop& top) {
  Window window;
  window.steady = steady_tilt(top);
  window.least = top.potential(window.steady);
  const auto beside = [&](double tilt) {
    return top.potential(std::clamp(tilt, 0.0, kPi));
  };
  double rise = 0.0;  // at the least reach, on the side where it is finite and larger
  for (const double side : {-kLeastReach, kLeastReach}) {
    const double here = beside(window.steady + side) - window.least;
    if (std::isfinite(here)) rise = std::max(rise, here);
  }
  const double depth = std::max(0.0, top.energy - window.least);
  window.most = window.least + std::max(kOverEnergy * depth, rise);
  window.low = reached(top, window.most, window.steady, 0.0);
  window.high = reached(top, window.most, window.steady, kPi);
  return window;
}

// what is shown, with something free beside it, within what is possible
DiagramAxis axis_between(std::string name,
                         std::string unit,
                         double low,
                         double high,
                         double least = -std::numeric_limits<double>::infinity(),
                         double most = std::numeric_limits<double>::infinity()) {
  const double free = kFree * (high - low);
  return {
      std::move(name), std::move(unit), std::max(least, low - free), std::min(most, high + free)};
}

// The closed curve (or two halves, at poles that the axis passes) of the motion with that energy:
// tilt in degrees, its rate in degrees per second.
std::vector<Vec2> level(const HeavyTop& top, const Window& window, double energy) {
  const double low = reached(top, energy, window.steady, 0.0);
  const double high = reached(top, energy, window.steady, kPi);
  std::vector<Vec2> points;
  for (int i = 0; i <= kTiltPieces; ++i) {
    const double turn = 2.0 * kPi * i / kTiltPieces;
    const double tilt = 0.5 * (low + high) - 0.5 * (high - low) * std::cos(turn);
    const double rate = std::sqrt(std::max(0.0, 2.0 * (energy - top.potential(tilt)) / top.I1));
    points.emplace_back(tilt / kDegree, (turn <= kPi ? rate : -rate) / kDegree);
  }
  return points;
}

// A pendulum swings in a plane: its angle from straight down, which goes on through the top.
// degrees, and degrees per second
std::vector<std::vector<Vec2>> pendulum_level(const HeavyTop& top, double energy) {
  const auto rate = [&](double angle) {
    return std::sqrt(std::max(0.0, 2.0 * (energy + top.mgl * std::cos(angle)) / top.I1)) / kDegree;
  };
  std::vector<std::vector<Vec2>> curves;
  if (energy < top.mgl) {
    const double most = std::acos(std::clamp(-energy / top.mgl, -1.0, 1.0));
    curves.emplace_back();
    for (int i = 0; i <= kTiltPieces; ++i) {
      const double turn = 2.0 * kPi * i / kTiltPieces;
      const double angle = -most * std::cos(turn);
      curves.back().emplace_back(angle / kDegree, turn <= kPi ? rate(angle) : -rate(angle));
    }
    return curves;
  }
  for (const double way : {1.0, -1.0}) {
    curves.emplace_back();
    for (int i = 0; i <= kTiltPieces; ++i) {
      const double angle = kPi * (2.0 * i / kTiltPieces - 1.0);
      curves.back().emplace_back(angle / kDegree, way * rate(angle));
    }
  }
  return curves;
}

Diagram pendulum_portrait(const Motion& motion, const HeavyTop& top) {
  using Kind = DiagramCurve::Kind;
  Diagram diagram;
  const auto add = [&](double energy, Kind kind) {
    for (std::vector<Vec2>& points : pendulum_level(top, energy))
      diagram.curves.push_back({kind, std::move(points)});
  };
  const double most = std::max(3.0 * top.mgl, 1.3 * (top.energy + top.mgl) - top.mgl);
  for (const double part : {0.25, 1.0, 2.0, 3.0})
    add(part * top.mgl - top.mgl, Kind::other);
  for (const double part : {0.5, 1.0})
    add(top.mgl + part * (most - top.mgl), Kind::other);
  add(top.mgl, Kind::separatrix);
  add(top.energy, Kind::motion);
  diagram.marks.push_back({"hanging", Vec2::Zero(), true});
  diagram.marks.push_back({"upright", Vec2(180.0, 0.0), false});
  diagram.marks.push_back({"", Vec2(-180.0, 0.0), false});
  diagram.title = "phase portrait";
  diagram.across = {"angle from hanging", "°", -180.0, 180.0};
  const double reach = std::sqrt(2.0 * (most + top.mgl) / top.I1) / kDegree;
  diagram.up = axis_between("rate", "°/s", -reach, reach);

  // the horizontal axis about which it swings
  const BodyModel& model = motion.model();
  const Vec3 up = model.up_S;
  double most_turning = 0.0;
  Vec3 about = up.unitOrthogonal();
  for (int i = 0; i <= 64; ++i) {
    const Vec3 L = motion.at(motion.duration() * i / 64).L_S;
    if (L.norm() <= most_turning) continue;
    most_turning = L.norm();
    about = L.normalized();
  }
  diagram.now = [=](double t) -> Vec2 {
    const Sample now = motion.at(t);
    const Vec3 axis = now.q_SB * (motion.model().R_BP * top.axis_P);
    const double angle = std::atan2(axis.dot(about.cross(-up)), -axis.dot(up));
    return {angle / kDegree, now.w_S.dot(about) / kDegree};
  };
  return diagram;
}

}  // namespace

std::string why_not_tilt(const Motion& motion) {
  const BodyModel& model = motion.model();
  const bool spherical = model.kind.shape == TopKind::Shape::spherical;
  const bool heavy = model.chi_P.squaredNorm() > 0.0;
  if (heavy && model.loads.empty() && (spherical || center_on_symmetry_axis(model))) return {};
  return "needs a heavy symmetric top on a pivot, without other torques";
}

Diagram tilt_potential(const Motion& motion) {
  using Kind = DiagramCurve::Kind;
  const HeavyTop top = heavy_top(motion);
  const Window window = window_of(top);
  Diagram diagram;
  diagram.title = "effective potential";
  diagram.across = axis_between(
      "tilt of the axis", "°", window.low / kDegree, window.high / kDegree, 0.0, 180.0);
  diagram.up = axis_between("", "J", window.least, window.most);
  DiagramCurve curve{Kind::potential, {}};
  for (int i = 0; i <= kTiltPieces; ++i) {
    const double tilt = window.low + (window.high - window.low) * i / kTiltPieces;
    curve.points.emplace_back(tilt / kDegree, top.potential(tilt));
  }
  diagram.curves.push_back(
      {Kind::energy, {{diagram.across.low, top.energy}, {diagram.across.high, top.energy}}});
  diagram.curves.push_back(std::move(curve));
  const double least = reached(top, top.energy, window.steady, 0.0) / kDegree;
  const double greatest = reached(top, top.energy, window.steady, kPi) / kDegree;
  if (greatest - least > 0.02 * (diagram.across.high - diagram.across.low)) {
    diagram.marks.push_back({"θ₁", Vec2(least, top.energy)});
    diagram.marks.push_back({"θ₂", Vec2(greatest, top.energy)});
  }
  diagram.now = [=](double t) -> Vec2 {
    const Sample now = motion.at(t);
    const double tilt =
        angle_between(now.q_SB * (motion.model().R_BP * top.axis_P), motion.model().up_S);
    return {tilt / kDegree, top.potential(tilt)};
  };
  return diagram;
}

Diagram tilt_portrait(const Motion& motion) {
  using Kind = DiagramCurve::Kind;
  const HeavyTop top = heavy_top(motion);
  if (top.is_pendulum()) return pendulum_portrait(motion, top);
  const Window window = window_of(top);
  Diagram diagram;
  diagram.title = "phase portrait";
  const auto add = [&](double energy, Kind kind) {
    diagram.curves.push_back({kind, level(top, window, energy)});
  };
  for (const double part : {0.15, 0.4, 0.65, 1.0})
    add(window.least + part * (window.most - window.least), Kind::other);
  // a pole that the axis can reach, and where the potential is not least, is an unstable motion
  for (const double pole : {0.0, kPi}) {
    const double energy = top.potential(pole);
    const bool reaches = pole == 0.0 ? top.passes_upright() : top.passes_down();
    if (!reaches || energy > window.most || energy - window.least < 1e-9 * top.mgl) continue;
    add(energy, Kind::separatrix);
    diagram.marks.push_back(
        {pole == 0.0 ? "upright" : "hanging", Vec2(pole / kDegree, 0.0), false});
  }
  add(top.energy, Kind::motion);
  diagram.marks.push_back({"steady", Vec2(window.steady / kDegree, 0.0), true});
  diagram.across = axis_between(
      "tilt of the axis", "°", window.low / kDegree, window.high / kDegree, 0.0, 180.0);
  const double reach = std::sqrt(2.0 * (window.most - window.least) / top.I1) / kDegree;
  diagram.up = axis_between("rate", "°/s", -reach, reach);
  diagram.now = [=](double t) -> Vec2 {
    const Sample now = motion.at(t);
    const Vec3& up = motion.model().up_S;
    const Vec3 axis = now.q_SB * (motion.model().R_BP * top.axis_P);
    const double sine = axis.cross(up).norm();
    // d(cos theta)/dt = -sin(theta) theta'; at a pole all of the turning of the axis tilts it
    const double rate =
        sine > 1e-12 ? -up.dot(now.w_S.cross(axis)) / sine : now.w_S.cross(axis).norm();
    return {angle_between(axis, up) / kDegree, rate / kDegree};
  };
  return diagram;
}

}  // namespace polhode
