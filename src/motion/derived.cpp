// SPDX-License-Identifier: MIT
#include "motion/derived.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/units.h"
#include "math/elliptic.h"
#include "math/so3.h"
#include "motion/contact/contact_quantities.h"
#include "motion/exact/exact.h"

namespace polhode {
namespace {

using Q = QuantityUnit;
using List = std::vector<Quantity>;

// a rate that is smaller than another by this is the round-off of its difference
constexpr double kRoundOffOfRates = 1e-12;
constexpr double kRoundOffOfMomentum = 1e-15;

// kinetic energy as that of the centre of mass and that about it (notes, eq. 4)
void add_energies(List& list, const BodyModel& model, const MotionSpec& spec, const State& start) {
  const Vec3 w_P = angular_velocity(model, start.y);
  const double turning = 0.5 * start.y.dot(w_P);
  const Vec3 arm_P = model.R_BP.transpose() * (model.body.center - model.reference_B());
  // on a table, place and velocity follow from the attitude and the spin
  const Vec3 place_S = model.table ? start.place_S : spec.position;
  const Vec3 v = model.on_pivot ? Vec3(w_P.cross(arm_P))
                 : model.table  ? Vec3(start.linear_momentum_S / model.body.mass)
                                : spec.velocity;
  const double travel = 0.5 * model.body.mass * v.squaredNorm();
  double potential = potential_of(model.loads.turning, start.q, place_S);
  potential += model.on_pivot ? model.chi_P.dot(up_in_body(model, start.q))
                              : potential_of_place(model, place_S);
  double kinetic = model.on_pivot ? turning : turning + travel;
  const Vec3 w_B = model.R_BP * w_P;
  const double turning_about_center =
      model.on_pivot ? 0.5 * w_B.dot(model.body.tensor * w_B) : turning;
  double of_rings = 0.0;
  if (model.loads.gimbals) {
    of_rings = kinetic_energy_of_gimbals(model, start);
    kinetic += of_rings;
    potential += frame_potential(*model.loads.gimbals, start.rings.angles);
  }
  list.push_back({"kinetic_energy", Q::energy, kinetic});
  list.push_back({"kinetic_energy_of_center_of_mass", Q::energy, travel});
  list.push_back({"kinetic_energy_about_center_of_mass", Q::energy, turning_about_center});
  if (model.loads.gimbals) list.push_back({"kinetic_energy_of_gimbals", Q::energy, of_rings});
  list.push_back({"potential_energy", Q::energy, potential});
  list.push_back({"total_energy", Q::energy, kinetic + potential});
  list.push_back({"angular_momentum", Q::momentum, start.y.norm()});
  list.push_back({"angular_speed", Q::rate, w_P.norm()});
}

void add_free_symmetric(List& list, const BodyModel& model, const State& start) {
  const int axis = model.kind.axis;
  const double along = model.moments[axis], across = model.moments[(axis + 1) % 3];
  const double precession = start.y.norm() / across;
  if (model.kind.rotator) {
    list.push_back({"rotation_period", Q::time, 2.0 * kPi / precession});
    return;
  }
  // the axis points to the side of L
  const Vec3 figure = std::copysign(1.0, start.y[axis]) * Vec3::Unit(axis);
  const Vec3 w_P = angular_velocity(model, start.y);
  double spin = std::abs(start.y[axis]) * (across - along) / (along * across);
  if (std::abs(start.y[axis]) < kRoundOffOfMomentum * start.y.norm()) spin = 0.0;
  list.push_back({"precession_rate", Q::rate, precession});
  list.push_back({"precession_period", Q::time, 2.0 * kPi / precession});
  list.push_back({"spin_rate", Q::rate, spin});
  if (spin != 0.0) list.push_back({"polhode_period", Q::time, 2.0 * kPi / std::abs(spin)});
  list.push_back({"axis_to_momentum_angle", Q::angle, angle_between(figure, start.y)});
  list.push_back({"space_cone_half_angle", Q::angle, angle_between(w_P, start.y)});
  list.push_back({"body_cone_half_angle", Q::angle, angle_between(w_P, figure)});
}

void add_free_asymmetric(List& list, const BodyModel& model, const State& start) {
  // squares of the momentum in the order of the moments
  int order[] = {0, 1, 2};
  std::sort(order, order + 3, [&](int i, int j) { return model.moments[i] < model.moments[j]; });
  const double I1 = model.moments[order[0]];
  const double I2 = model.moments[order[1]];
  const double I3 = model.moments[order[2]];
  const Vec3 y(start.y[order[0]], start.y[order[1]], start.y[order[2]]);
  const Vec3 q = y.cwiseProduct(y);

  // excesses over the separatrix and the two steady rotations, without cancellation
  const double excess1 = q[1] * (I2 - I1) / I2 + q[2] * (I3 - I1) / I3;
  const double excess2 = q[2] * (I3 - I2) / I3 - q[0] * (I2 - I1) / I1;
  const double excess3 = q[0] * (I3 - I1) / I1 + q[1] * (I3 - I2) / I2;
  const double a = excess3 * (I2 - I1);
  const double b = excess1 * (I3 - I2);
  const double m1 = std::min(1.0, std::abs(excess2) * (I3 - I1) / std::max(a, b));
  const double lambda = std::sqrt(std::max(a, b) / (I1 * I2 * I3));
  if (m1 > 0.0 && std::min(a, b) > 0.0) {
    const double K = elliptic_k(m1);
    list.push_back({"polhode_period", Q::time, 4.0 * K / lambda});
    list.push_back({"flip_time", Q::time, 2.0 * K / lambda});
    // The axis that the momentum goes round in the body never meets L. It goes round it at
    // L (y'^2 / I' + y2^2 / I2) / (y'^2 + y2^2), y' and y2 being as cn and sn: that of the other
    // end of the order, and the middle one.
    const bool about_greatest = excess2 > 0.0;
    const double other = about_greatest ? I1 : I3;
    const double p =
        about_greatest ? I2 * (I3 - I1) / (I1 * (I3 - I2)) : I2 * (I3 - I1) / (I3 * (I2 - I1));
    list.push_back({"mean_precession_rate",
                    Q::rate,
                    start.y.norm() * elliptic_cel(m1, p, 1.0 / other, p / I2) / K});
    list.push_back({"spins_about_long_axis", Q::verdict, excess2 > 0.0 ? 0.0 : 1.0});
  }
  if (q[1] >= std::max(q[0], q[2])) {
    const double rate = std::abs(y[1]) / I2 * std::sqrt((I2 - I1) * (I3 - I2) / (I1 * I3));
    list.push_back({"growth_rate_off_middle_axis", Q::growth, rate});
  }
}

void add_nutation(List& list, const BodyModel& model, const State& start, bool is_pendulum) {
  constexpr double kVertical = 1e-6;  // rad; closer to the vertical it has no direction
  const Nutation nutation = nutation_of(model, start);
  list.push_back({"least_tilt", Q::angle, nutation.least_tilt});
  list.push_back({"greatest_tilt", Q::angle, nutation.greatest_tilt});
  if (nutation.period == 0.0 || !std::isfinite(nutation.period)) return;
  list.push_back({"nutation_period", Q::time, nutation.period});
  const bool through_bottom = nutation.greatest_tilt > kPi - kVertical;
  if (is_pendulum && through_bottom) {
    // in a plane: the tilt is back at its least twice per swing, once per revolution
    const bool revolves = nutation.over_the_top;
    if (!revolves) list.push_back({"swing_period", Q::time, 2.0 * nutation.period});
    if (revolves) list.push_back({"revolution_period", Q::time, nutation.period});
    return;
  }
  if (nutation.least_tilt < kVertical || through_bottom) return;
  if (const std::optional<double> turn = precession_in_a_nutation(model, start)) {
    list.push_back({"mean_precession_rate", Q::rate, *turn / nutation.period});
    list.push_back({"precession_angle_per_nutation", Q::angle, *turn});
  }
  const double at_least = nutation.precession_at_least;
  const double at_greatest = nutation.precession_at_greatest;
  list.push_back({"precession_rate_at_least_tilt", Q::rate, at_least});
  list.push_back({"precession_rate_at_greatest_tilt", Q::rate, at_greatest});
  // at a cusp the rate is round-off of either sign: of the other rate, or of the momentum
  const double slower = std::min(std::abs(at_least), std::abs(at_greatest));
  const double faster = std::max(std::abs(at_least), std::abs(at_greatest));
  const double of_momentum =
      kRoundOffOfMomentum * angular_velocity(model, start.y).norm() / std::sin(nutation.least_tilt);
  const bool reverses =
      at_least * at_greatest < 0.0 && slower > std::max(kRoundOffOfRates * faster, of_momentum);
  list.push_back({"precession_reverses", Q::verdict, reverses ? 1.0 : 0.0});
}

// Lagrange's top: chi along the axis
void add_heavy_symmetric(List& list, const BodyModel& model, const State& start) {
  const int axis = model.kind.symmetric() ? model.kind.axis : 0;
  const double A = model.moments[(axis + 1) % 3];
  const double mu = model.chi_P.norm();
  const double L3 = model.kind.rotator ? 0.0 : start.y.dot(model.chi_P) / mu;
  const double u = std::clamp(up_in_body(model, start.q).dot(model.chi_P) / mu, -1.0, 1.0);
  list.push_back(
      {"tilt_at_start", Q::angle, angle_between(up_in_body(model, start.q), model.chi_P)});
  constexpr double kRoundOffOfSpin = 1e-14;  // of L
  const bool spins = std::abs(L3) > kRoundOffOfSpin * start.y.norm();
  add_nutation(list, model, start, !spins);
  if (!spins) {
    list.push_back({"small_oscillation_period", Q::time, 2.0 * kPi * std::sqrt(A / mu)});
    return;
  }
  // the slow one as a quotient: nothing cancels, and a level axis is no exception
  const double under_root = L3 * L3 - 4.0 * A * mu * u;
  list.push_back({"steady_precession_possible", Q::verdict, under_root >= 0.0 ? 1.0 : 0.0});
  if (under_root >= 0.0) {
    const double sum = L3 + std::copysign(std::sqrt(under_root), L3);
    list.push_back({"slow_steady_precession", Q::rate, 2.0 * mu / sum});
    if (std::abs(u) > 1e-12)
      list.push_back({"fast_steady_precession", Q::rate, sum / (2.0 * A * u)});
  }
  const double ratio = L3 * L3 / (4.0 * A * mu);
  list.push_back({"sleeping_top_stable", Q::verdict, ratio >= 1.0 ? 1.0 : 0.0});
  list.push_back({"sleeping_top_stability_ratio", Q::none, ratio});
  if (ratio < 1.0) {
    const double growth = std::sqrt(4.0 * A * mu - L3 * L3) / (2.0 * A);
    list.push_back({"sleeping_top_growth_rate", Q::growth, growth});
  }
}

}  // namespace

std::string key_of(const Quantity& quantity) {
  static constexpr const char* kSuffixes[] = {
      "", "_s", "_rad", "_rad_per_s", "_per_s", "_J", "_kg_m2_per_s", ""};
  return quantity.name + kSuffixes[static_cast<int>(quantity.unit)];
}

std::vector<Quantity> derived_quantities(const BodyModel& model, const MotionSpec& spec) {
  const State start = start_state(model, spec);
  List list;
  add_energies(list, model, spec, start);
  if (model.table) {
    const List more = contact_quantities(model, start);
    list.insert(list.end(), more.begin(), more.end());
    return list;
  }
  if (model.loads.turn_body()) return list;
  if (model.chi_P.squaredNorm() > 0.0) {
    Vec3 aside = model.chi_P;
    aside[model.kind.axis] = 0.0;
    const bool along = aside.norm() <= kEqualMoments * model.chi_P.norm();
    if (model.kind.shape == TopKind::Shape::spherical || (model.kind.symmetric() && along))
      add_heavy_symmetric(list, model, start);
    return list;
  }
  if (start.y.norm() == 0.0) return list;
  if (model.kind.shape == TopKind::Shape::asymmetric) {
    add_free_asymmetric(list, model, start);
  } else if (model.kind.symmetric()) {
    add_free_symmetric(list, model, start);
  } else {
    const double period = 2.0 * kPi * model.moments[0] / start.y.norm();
    list.push_back({"rotation_period", Q::time, period});
  }
  return list;
}

std::optional<double> value_of(const std::vector<Quantity>& quantities, const std::string& key) {
  for (const Quantity& quantity : quantities) {
    if (key_of(quantity) == key) return quantity.value;
  }
  return std::nullopt;
}

}  // namespace polhode
