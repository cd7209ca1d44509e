// SPDX-License-Identifier: MIT
#include "chart/section.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/system/interrupt.h"
#include "math/bracketed_zero.h"
#include "math/so3.h"
#include "motion/scales.h"
#include "motion/trajectory.h"
#include "motion/walk.h"

namespace polhode {
namespace {

constexpr double kSectionTolerance = 1e-12;
constexpr double kPatience = 200.0;      // turns without a crossing
constexpr double kTurnsToJudge = 100.0;  // the least, to call a motion regular
constexpr double kTurnsTogether = 2.0;   // after which a neighbour is brought back
constexpr double kRegular = 3.0, kChaotic = 6.0;
constexpr int kMostHalvings = 20;  // of a step that grazes the surface
constexpr double kBeside = 1e-8;   // of the neighbour at first, in units of the state's scales

using Passage = SectionSurface::Passage;

// A part of a step of the motion: from a time after the step's beginning (s) to another, and how
// the surface is passed there.
struct PartOfStep {
  double low, high;
  Passage at_low, at_high;

  // the greatest rate of gamma_1 at its ends, and the greatest distance from the surface
  double rate() const { return std::max(std::abs(at_low.rate), std::abs(at_high.rate)); }
  double distance() const { return std::max(std::abs(at_low.at), std::abs(at_high.at)); }
};

// A step of the motion from a state, as far as is asked.
struct Step {
  const SectionSurface& surface;
  const Stepper& stepper;
  double t;
  const State& begin;

  State after(double h) const {
    State now = begin;
    Work work;
    if (h > 0.0) stepper.step(t, h, now, work);
    return now;
  }
};

// where a part crosses the surface, which is on both sides of it at its ends
double crossing_in(const Step& step, const PartOfStep& part) {
  const auto gamma_1 = [&](double at) {
    return step.surface.vertical_F(step.after(at)).x();
  };
  const Bracket found =
      narrowed({part.low, part.high, part.at_low.at, part.at_high.at}, 0.0, gamma_1);
  return std::abs(found.at_low) < std::abs(found.at_high) ? found.low : found.high;
}

// Whether gamma_1 may be zero in a part and turn round there, so that it may cross more often than
// the signs at the ends tell.
bool may_turn_at_surface(const PartOfStep& part) {
  const double h = part.high - part.low;
  const double bend = 2.0 * std::max(part.at_low.bend, part.at_high.bend);  // it changes within
  return part.rate() <= h * bend && part.distance() <= h * (part.rate() + h * bend);
}

// Whether it stays on the surface, as in a plane, and does not pass through it: its ends are as
// near as rounding errors may make them, and it hardly moves.
bool lies_in_surface(const PartOfStep& part) {
  constexpr double kOn = 1e-10;
  return part.distance() < kOn && part.rate() * (part.high - part.low) < kOn;
}

// Appends when gamma_1 rises through 0 in a part, in order.
void find_rises(const Step& step,
                const PartOfStep& part,
                int halvings_left,
                std::vector<double>& rises) {
  if (lies_in_surface(part)) return;
  if (halvings_left > 0 && may_turn_at_surface(part)) {
    const double middle = 0.5 * (part.low + part.high);
    const Passage at_middle = step.surface.passage_of(step.after(middle));
    find_rises(step, {part.low, middle, part.at_low, at_middle}, halvings_left - 1, rises);
    find_rises(step, {middle, part.high, at_middle, part.at_high}, halvings_left - 1, rises);
  } else if (part.at_low.at < 0.0 && part.at_high.at >= 0.0) {
    rises.push_back(crossing_in(step, part));
  }
}

// How far apart neighbours are, in rad and in units of the momentum.
double apart(const State& a, const State& b, double momentum) {
  return std::hypot(rotation_angle_between(a.q, b.q), (a.y - b.y).norm() / momentum);
}

// the mean of the numbers in a quarter of the list, counted from 0
double mean_of_quarter(const std::vector<double>& list, std::size_t quarter) {
  const std::size_t first = list.size() * quarter / 4, end = list.size() * (quarter + 1) / 4;
  if (first == end) return 0.0;
  double sum = 0.0;
  for (std::size_t i = first; i < end; ++i)
    sum += list[i];
  return sum / static_cast<double>(end - first);
}

// the state at a part of the way from a to b
State between(const State& a, const State& b, double part) {
  State s = a;
  const Quat turn = a.q.conjugate() * b.q;
  const Eigen::AngleAxisd way(turn.w() < 0.0 ? Quat(-turn.coeffs()) : turn);
  s.q = (a.q * Quat(Eigen::AngleAxisd(part * way.angle(), way.axis()))).normalized();
  s.y = a.y + part * (b.y - a.y);
  return s;
}

// Lagrange's top and Kovalevskaya's have a third integral, so that no motion is chaotic.
bool has_third_integral(const BodyModel& model) {
  if (center_on_symmetry_axis(model)) return true;
  if (!model.kind.symmetric()) return false;
  constexpr double kAsGiven = 1e-9;  // relative, of numbers typed with ten digits
  const int axis = model.kind.axis;
  const double across = model.moments[(axis + 1) % 3], along = model.moments[axis];
  return std::abs(across - 2.0 * along) <= kAsGiven * across &&
         std::abs(model.chi_P[axis]) <= kAsGiven * model.chi_P.norm();
}

}  // namespace

SectionSurface::SectionSurface(const BodyModel& model, const State& start)
    : model_(model),
      energy_(polhode::energy(model, start)),
      vertical_momentum_(start.y.dot(up_in_body(model, start.q))) {
  // the second axis is on the side where the vertical is while the centre of mass hangs
  const Vec3& chi = model.chi_P;
  if (chi.head<2>().norm() > 1e-9 * chi.norm()) {
    R_PF_ = Eigen::AngleAxisd(std::atan2(chi.x(), -chi.y()), Vec3::UnitZ()).toRotationMatrix();
  }
  inverse_F_ = R_PF_.transpose() * model.inverse_moments.asDiagonal() * R_PF_;
}

Vec3 SectionSurface::vertical_F(const State& state) const {
  return R_PF_.transpose() * up_in_body(model_, state.q);
}

SectionSurface::Passage SectionSurface::passage_of(const State& state) const {
  const Vec3 omega = angular_velocity(model_, state.y);
  const Vec3 gamma = up_in_body(model_, state.q);
  const Vec3 velocity = gamma.cross(omega);
  const Vec3 omega_rate =
      model_.inverse_moments.cwiseProduct(momentum_rate(model_, state.y, gamma));
  const Vec3 bend = velocity.cross(omega) + gamma.cross(omega_rate);
  return {R_PF_.col(0).dot(gamma), R_PF_.col(0).dot(velocity), bend.norm()};
}

Vec2 SectionSurface::point_of(const State& state) const {
  const Vec3 gamma = vertical_F(state);
  return {std::atan2(gamma.y(), gamma.z()), (R_PF_.transpose() * state.y).x()};
}

// On the surface L = p e_1 + L_z gamma + w u, u in the plane of the second and third axis square to
// gamma. The energy is quadratic in w, and gamma_1 increases at its larger root.
struct SectionSurface::AtTilt {
  Vec3 gamma, u;
  double kinetic;  // J
  double a, b, c;  // of the discriminant
};
SectionSurface::AtTilt SectionSurface::at_tilt(double theta) const {
  AtTilt at;
  at.gamma = Vec3(0.0, std::sin(theta), std::cos(theta));
  at.u = Vec3(0.0, -at.gamma.z(), at.gamma.y());
  at.kinetic = energy_ - model_.chi_P.dot(R_PF_ * at.gamma);
  const Vec3 up = vertical_momentum_ * at.gamma;
  const Vec3 of_u = inverse_F_ * at.u, of_x = inverse_F_.col(0), of_up = inverse_F_ * up;
  at.a = of_u.x() * of_u.x() - of_u.dot(at.u) * of_x.x();
  at.b = 2.0 * (of_u.x() * of_u.dot(up) - of_u.dot(at.u) * of_x.dot(up));
  at.c = of_u.dot(up) * of_u.dot(up) - of_u.dot(at.u) * (of_up.dot(up) - 2.0 * at.kinetic);
  return at;
}

std::optional<SectionSurface::Allowed> SectionSurface::allowed_at(double theta) const {
  const AtTilt at = at_tilt(theta);
  const double discriminant = at.b * at.b - 4.0 * at.a * at.c;
  if (!(discriminant >= 0.0)) return {};
  // a is negative
  const double middle = -0.5 * at.b / at.a, half = -0.5 * std::sqrt(discriminant) / at.a;
  return Allowed{middle - half, middle + half};
}

std::optional<State> SectionSurface::state_at(double theta, double p) const {
  const AtTilt at = at_tilt(theta);
  const double left = (at.a * p + at.b) * p + at.c;
  if (!(left >= 0.0) || std::sin(theta) <= 0.0) return {};
  const Vec3 known = Vec3(p, 0.0, 0.0) + vertical_momentum_ * at.gamma;
  const Vec3 of_u = inverse_F_ * at.u;
  const double w = (std::sqrt(left) - of_u.dot(known)) / of_u.dot(at.u);
  State state;
  state.y = R_PF_ * (known + w * at.u);
  state.q = turn_between(Vec3::UnitZ(), model_.up_S) *
            Quat(Eigen::AngleAxisd(theta, Vec3::UnitX())) * Quat(R_PF_).conjugate();
  return state;
}

std::vector<Vec2> SectionSurface::spread(int count) const {
  constexpr int kLooks = 2000;
  double least = 0.0, greatest = 0.0;
  for (int i = 1; i < kLooks; ++i) {
    const std::optional<Allowed> here = allowed_at(kPi * i / kLooks);
    if (!here) continue;
    least = std::min(least, here->least);
    greatest = std::max(greatest, here->greatest);
  }
  std::vector<Vec2> starts;
  // additive recurrence with the plastic number, even in the plane (M. Roberts, 2018)
  constexpr double kFirst = 0.7548776662466927, kSecond = 0.5698402909980532;
  constexpr int kMostTries = 200000;
  double x = 0.5, y = 0.5;
  for (int i = 0; i < kMostTries && static_cast<int>(starts.size()) < count; ++i) {
    x = std::fmod(x + kFirst, 1.0);
    y = std::fmod(y + kSecond, 1.0);
    const Vec2 at(kPi * x, least + y * (greatest - least));
    if (state_at(at.x(), at.y())) starts.push_back(at);
  }
  return starts;
}

std::optional<SectionObstacle> why_not_section(const BodyModel& model) {
  if (!model.on_pivot) {
    return SectionObstacle{"motion.hold",
                           "needs a body on a pivot under gravity; set hold = \"pivot\""};
  }
  if (model.gravity_S.isZero(0.0))
    return SectionObstacle{"motion.gravity", "needs gravity that turns the body"};
  if (model.chi_P.isZero(0.0)) {
    return SectionObstacle{
        "motion.hold", "needs a body that gravity turns: this one is held at its centre of mass"};
  }
  if (model.loads.gimbals)
    return SectionObstacle{"motion.gimbals", "takes no rings that carry the body"};
  if (frame_rotation_of(model))
    return SectionObstacle{"motion.frame_rotation", "takes no space that turns"};
  if (!model.loads.empty())
    return SectionObstacle{"motion.torque", "takes no torques or forces besides gravity"};
  if (model.kind.rotator)
    return SectionObstacle{"body", "takes no body with all its mass on a line"};
  return {};
}

const char* name_of(SectionVerdict verdict) {
  static constexpr std::array<const char*, 3> names = {"regular", "undecided", "chaotic"};
  return names[static_cast<std::size_t>(verdict)];
}

SectionOrbit trace_section(const SectionSurface& surface, const State& start, int crossings) {
  const BodyModel& model = surface.model();
  const StepperInfo& method = find_stepper("dop853");
  const double momentum = momentum_scale(model, start);
  const std::unique_ptr<Stepper> stepper = method.make(model, momentum);
  const double rate = typical_rate(model, start);
  const double chunk = kTurnsTogether * 2.0 * kPi / rate;
  double first = first_step(model, start, kSectionTolerance, method.order);

  SectionOrbit orbit;
  DriftWatch drift(model, start);
  State s = start, neighbour = start;
  // any direction will do: it turns to that of fastest growth
  neighbour.y += kBeside * momentum * Vec3(0.6, -0.5, 0.62);
  Work work;
  double t = 0.0, last_found = 0.0;
  bool is_done = false;
  std::vector<double> growths;
  Passage passage = surface.passage_of(s);
  const auto step_to = [&](double from, const State& before, double to, const State& after) {
    const Passage there = surface.passage_of(after);
    const Step step{surface, *stepper, from, before};
    std::vector<double> rises;
    find_rises(step, {0.0, to - from, passage, there}, kMostHalvings, rises);
    passage = there;
    for (const double rise : rises) {
      const State now = step.after(rise);
      // on the other side psi is half a turn
      if (is_done || surface.vertical_F(now).y() <= 0.0) continue;
      orbit.points.push_back(surface.point_of(now));
      drift.look_at(now);
      last_found = to;
      is_done = static_cast<int>(orbit.points.size()) >= crossings;
    }
  };
  while (!is_done && t - last_found < kPatience * 2.0 * kPi / rate) {
    stop_if_interrupted();
    State before = s;
    double from = 0.0, longest = 0.0;
    walk_adaptive(
        method, *stepper, s, chunk, kSectionTolerance, first, {}, [&](double to, const State& now) {
          step_to(t + from, before, t + to, now);
          // the neighbour takes the same steps: their errors are the same, and do not part the two
          stepper->step(t + from, to - from, neighbour, work);
          longest = std::max(longest, to - from);
          before = now;
          from = to;
        });
    first = longest;
    const double distance = apart(s, neighbour, momentum);
    if (distance > 0.0) {
      orbit.growth += std::log(distance / kBeside);
      neighbour = between(s, neighbour, kBeside / distance);
    }
    growths.push_back(orbit.growth);
    t += chunk;
  }
  orbit.duration = t;
  orbit.energy_drift = drift.worst().energy.value_or(0.0);
  const double late = mean_of_quarter(growths, 3) - mean_of_quarter(growths, 1);
  const bool long_enough = t * rate >= kTurnsToJudge * 2.0 * kPi;
  orbit.verdict = late < kRegular && long_enough ? SectionVerdict::regular
                  : late > kChaotic              ? SectionVerdict::chaotic
                                                 : SectionVerdict::undecided;
  // at a separatrix rounding errors carry regular motions across, as if they were chaotic
  if (orbit.verdict == SectionVerdict::chaotic && has_third_integral(model))
    orbit.verdict = SectionVerdict::undecided;
  return orbit;
}

}  // namespace polhode
