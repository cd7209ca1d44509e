// SPDX-License-Identifier: MIT
#include "motion/contact/contact_quantities.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "base/units.h"
#include "math/so3.h"
#include "model/contact_invariants.h"

namespace polhode {
namespace {

using Q = QuantityUnit;
using List = std::vector<Quantity>;

// Numbers of 64 bits: growth may be 1e-5 of the spin and less, and where two frequencies meet,
// errors come out as their roots.
using Number = long double;
using Number2x2 = Eigen::Matrix<Number, 2, 2>;
using Numbers = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

double along_up(const BodyModel& model) {
  return -model.gravity_S.z();
}

// whether the body may roll, and nothing resists that or its turning about the vertical
bool may_roll_freely(const Friction& law) {
  const bool grips = law.kind == Friction::Kind::coulomb || law.kind == Friction::Kind::rolling;
  return grips && law.rolling == 0.0 && law.boring == 0.0;
}

// The equations of small deviations from a spin w about the vertical axis e, in two directions
// across it that turn with the body: of up, e + eps; of the angular velocity, w e + eta; and, with
// viscous friction, the velocity v of the centre of mass. To first order the table pushes with
// N = m g up, at r = -h e - S eps (S: the radii of curvature), where the body slips at
// s = v + h j eta - w j S eps (j a: e x a), and
//   eps' = j eta - w j eps,
//   I eta' = -w j I eta + w C j eta + N (j S - h j) eps - h j F,
//   m v' = -m w j v + F.
// F is -c N s, or what keeps s at 0, or none.
class SmallDeviations {
 public:
  SmallDeviations(const BodyModel& model, const Vec3& up_P)
      : model_(model),
        mass_(model.body.mass),
        push_(model.body.mass * along_up(model)),
        along_(up_P.dot(model.moments.cwiseProduct(up_P))) {
    const ContactSurface& surface = *model.table->surface;
    const int piece = surface.lowest(-up_P);
    const Vec3 first = up_P.unitOrthogonal(), second = up_P.cross(first);
    Eigen::Matrix<double, 3, 2> across;
    across << first, second;
    height_ = surface.height(-up_P, piece);
    I_ = (across.transpose() * model.moments.asDiagonal() * across).cast<Number>();
    for (int i = 0; i < 2; ++i) {
      const SurfacePoint point = surface.at(-up_P, across.col(i), piece);
      S_.col(i) = (across.transpose() * point.arm_rate_P).cast<Number>();
    }
    j_ << 0, -1, 1, 0;
  }

  // Their matrix with angular velocities in units of `rate`, velocities of `speed` and times of
  // 1 / rate.
  Numbers matrix(Number w, Number rate, Number speed) const {
    const Number2x2 zero = Number2x2::Zero(), one = Number2x2::Identity();
    const Number h = height_, m = mass_;
    // without friction
    const Number2x2 on_eps = push_ * (j_ * S_ - h * j_);
    const Number2x2 on_eta = -w * j_ * I_ + w * along_ * j_;
    const Friction& law = model_.table->friction;
    if (law.kind == Friction::Kind::viscous) {
      const Number c = law.c * push_;
      const Number2x2 slip_of_eps = -w * j_ * S_, slip_of_eta = h * j_;
      const Number2x2 inverse = I_.inverse();
      Numbers all(6, 6);
      all << -w * j_, rate * j_, zero, inverse * (on_eps + h * c * j_ * slip_of_eps) / rate,
          inverse * (on_eta + h * c * j_ * slip_of_eta), inverse * (h * c * j_) * speed / rate,
          -c / m * slip_of_eps / speed, -c / m * slip_of_eta * rate / speed, -w * j_ - c / m * one;
      return all / rate;
    }
    // the force that keeps it from slipping is m (v' + w j v) with v = -h j eta + w j S eps
    const Number held = law.kind == Friction::Kind::none ? 0 : m * h;
    const Number2x2 inverse = (I_ + held * h * one).inverse();
    const Number2x2 force_on_eps = w * w * (j_ * S_ * j_ + S_);
    const Number2x2 force_on_eta = -w * (j_ * S_ * j_ + h * one);
    Numbers all(4, 4);
    all << -w * j_, rate * j_, inverse * (on_eps + held * j_ * force_on_eps) / rate,
        inverse * (on_eta + held * j_ * force_on_eta);
    return all / rate;
  }

 private:
  const BodyModel& model_;
  Number mass_, push_, along_, height_ = 0;
  Number2x2 I_, S_, j_;
};

// The principal axis that is nearest to the vertical at the start, upwards; null unless the body
// can spin about it on the table: its lowest point is then right below the centre of mass.
bool spin_axis(const BodyModel& model, const State& start, Vec3& up_P) {
  constexpr double kNearAxis = 0.5;  // rad
  const Vec3 up = up_in_body(model, start.q);
  const ContactSurface& surface = *model.table->surface;
  // bodies of revolution have principal axes in all directions across
  Vec3 axis_P;
  if (is_of_revolution(model, axis_P)) {
    const Vec3 across = up - up.dot(axis_P) * axis_P;
    const bool along = std::abs(up.dot(axis_P)) > across.norm();
    up_P = along ? Vec3(std::copysign(1.0, up.dot(axis_P)) * axis_P) : Vec3(across.normalized());
  } else {
    Eigen::Index i = 0;
    up.cwiseAbs().maxCoeff(&i);
    up_P = std::copysign(1.0, up[i]) * Vec3::Unit(i);
  }
  if (angle_between(up, up_P) > kNearAxis) return false;
  const int piece = surface.lowest(-up_P);
  if (surface.tilt_of_face(-up_P, piece) < 1e-9) return false;
  if (surface.clearance(-up_P, piece) < 1e-9 * surface.reach()) return false;
  const Vec3 arm = surface.at(-up_P, Vec3::Zero(), piece).arm_P;
  return arm.cross(up_P).norm() < 1e-9 * surface.reach();
}

// Where spins in the direction of this one become stable or unstable, rad/s, the nearest such spin
// by its ratio to this one; 0: unknown, or at none below the spin that is far above what gravity
// does. Ranges of spins narrower than one in a hundred may be missed.
double limit_of_spin(const BodyModel& model, const Vec3& up_P, double now) {
  constexpr double kFactor = 1.01;   // from one look to the next
  constexpr double kBeside = 1.003;  // from a limit
  const double gravity = std::sqrt(model.gravity_S.norm() / model.table->surface->reach());
  bool is_known = true;
  const auto growth = [&](double spin) {
    const std::optional<double> rate = growth_rate_of_spin(model, up_P, std::copysign(spin, now));
    is_known = is_known && rate.has_value();
    return rate.value_or(0.0);
  };
  const auto grows = [&](double spin) {
    return growth(spin) > 0.0;
  };
  // growth that fades away falls below what counts somewhere, which is no limit
  const auto is_limit = [&](double low, double high) {
    const double least = std::max(growth(low), growth(high));
    return std::max(growth(low / kBeside), growth(high * kBeside)) > 2.0 * least;
  };
  double nearest = 0.0;
  const auto away = [&](double spin) {
    return std::abs(std::log(spin / std::abs(now)));
  };
  bool before = grows(0.1 * gravity);
  for (double fast = 0.1 * kFactor * gravity; fast <= 100.0 * gravity; fast *= kFactor) {
    const bool after = grows(fast);
    if (after == before) continue;
    double low = fast / kFactor, high = fast;
    while (high - low > 1e-9 * high) {
      const double middle = 0.5 * (low + high);
      (grows(middle) == before ? low : high) = middle;
    }
    before = after;
    if (nearest != 0.0 && away(high) >= away(nearest)) continue;
    if (is_limit(low, high)) nearest = high;
  }
  return is_known ? nearest : 0.0;
}

void add_vertical_spin(List& list, const BodyModel& model, const State& start) {
  Vec3 up_P;
  if (!spin_axis(model, start, up_P)) return;
  const Vec3 w_P = angular_velocity(model, start.y);
  const double spin = w_P.dot(up_P);
  if (std::abs(spin) <= 0.5 * w_P.norm()) return;
  list.push_back({"vertical_spin", Q::rate, spin});
  // moments against rolling hold small deviations, as dry friction does, and those against boring
  // end the spin
  const Friction& law = model.table->friction;
  if (law.rolling != 0.0 || law.boring != 0.0) return;
  if (const std::optional<double> growth = growth_rate_of_spin(model, up_P, spin))
    list.push_back({"growth_rate_of_vertical_spin", Q::growth, *growth});
  if (const std::optional<double> growth = growth_rate_of_spin(model, up_P, -spin))
    list.push_back({"growth_rate_of_vertical_spin_reversed", Q::growth, *growth});
  if (const double limit = limit_of_spin(model, up_P, spin); limit > 0.0)
    list.push_back({"vertical_spin_limit", Q::rate, limit});
}

double jellett_of(const BodyModel& model, const State& start) {
  const std::vector<ContactInvariant>& rows = contact_invariants();
  const auto row = std::find_if(
      rows.begin(), rows.end(), [](const ContactInvariant& one) { return one.name == "jellett"; });
  return row->value(model, moving_of(model, start)).x();
}

// Jellett's constant fixed, the energy of spinning at tilt theta without slip is
// lambda^2 / (2 R^2 D) - m g R e cos(theta), D = I1 sin^2 + I3 (cos - e)^2: its minima are where
// viscous friction ends. Ebenfeld and Scheck, Ann. Phys. 243 (1995) 195; derived anew.
void add_eccentric_sphere(List& list, const BodyModel& model, const State& start) {
  EccentricSphere s;
  // a centre of mass outside the sphere is that of a peg top
  if (!is_eccentric_sphere(model, s) || s.offset >= 1.0) return;
  const double e = s.offset, ratio = s.across / s.along;
  list.push_back({"eccentricity", Q::none, e});
  list.push_back({"inertia_ratio_across_to_along", Q::none, ratio});
  // dry friction holds a body that slips little, so that it does not leave the upright place
  if (e == 0.0 || !is_level_and_unloaded(model)) return;
  const Friction& law = model.table->friction;
  if (law.kind != Friction::Kind::viscous || law.turntable != 0.0) return;
  const bool condition = 1.0 - e < ratio && ratio < 1.0 + e;
  list.push_back({"tippe_top_condition", Q::verdict, condition ? 1.0 : 0.0});
  // the rest follows from Jellett's constant, which these moments change
  if (law.rolling != 0.0 || law.boring != 0.0) return;
  const double lever = model.body.mass * along_up(model) * s.radius * e;
  const double low = s.across - s.along * (1.0 - e), high = s.along * (1.0 + e) - s.across;
  const double upright = low > 0.0 ? (1.0 - e) * std::sqrt(lever / low) : HUGE_VAL;
  const double inverted = high > 0.0 ? (1.0 + e) * std::sqrt(lever / high) : HUGE_VAL;
  if (low > 0.0) list.push_back({"upright_spin_limit", Q::rate, upright});
  if (high > 0.0) list.push_back({"inverted_spin_limit", Q::rate, inverted});
  if (!condition) return;
  // it must leave the upright place, and have enough spin left after the inversion
  const double before = std::max(upright, (1.0 + e) / (1.0 - e) * inverted);
  list.push_back({"upright_spin_for_inversion", Q::rate, before});
  // what leaves the upright place and stays inverted, with the spins that lambda has there; in the
  // air lambda is another
  const bool is_upright = s.axis_P.dot(up_in_body(model, start.q)) > 0.0;
  if (!is_upright || !is_on_table(model, moving_of(model, start))) return;
  const double lambda = std::abs(jellett_of(model, start)) / (s.along * s.radius);
  const double spin_upright = lambda / (1.0 - e), spin_inverted = lambda / (1.0 + e);
  if (spin_upright > upright && spin_inverted > inverted)
    list.push_back({"spin_after_inversion", Q::rate, spin_inverted});
}

// a thin edge or a torus that rolls: its plane upright, or its centre at rest
void add_disc(List& list, const BodyModel& model, const State& start) {
  Vec3 axis_P;
  const std::vector<SurfacePiece>& pieces = model.table->surface->pieces();
  if (pieces.size() != 1 || pieces.front().ring == 0.0 || !is_of_revolution(model, axis_P)) return;
  if (pieces.front().center_P.norm() > 1e-9 * pieces.front().ring) return;
  const SurfacePiece& edge = pieces.front();
  const int axis = model.kind.axis;
  const double mass = model.body.mass, g = along_up(model);
  const double along = model.moments[axis], across = model.moments[(axis + 1) % 3];
  const double a = edge.ring + edge.ball, tube = edge.ball;
  // Upright rolling, linearised: w^2 I3 (I3 + m a^2) = m g (a - tube) I1 for a thin edge. For a
  // tube the contact moves aside too; the growth of the general equations would be needed.
  const Friction& law = model.table->friction;
  if (tube == 0.0 && may_roll_freely(law)) {
    list.push_back({"upright_rolling_limit",
                    Q::rate,
                    std::sqrt(mass * g * a * across / (along * (along + mass * a * a)))});
  }
  if (tube > 0.0) return;
  const Vec3 up_P = up_in_body(model, start.q);
  const double sine = up_P.cross(axis_P).norm();
  if (sine < 1e-6 || sine > 1.0 - 1e-9) return;
  // L = I1 W sin along the radius to the contact turns at W: I1 W^2 sin = m g a
  const double precession = std::sqrt(mass * g * a / (across * sine));
  list.push_back({"face_tilt", Q::angle, std::asin(sine)});
  list.push_back({"precession_with_center_at_rest", Q::rate, precession});
  list.push_back({"energy_with_center_at_rest", Q::energy, 1.5 * mass * g * a * sine});
  // Rolling friction drives the centre out of rest, as simulated the less the flatter the disc
  // lies: the time is right within 1 % below 25 degrees of a plate, and below 15 of what is
  // thicker, for weak friction and from a homogeneous disc on (of one with its mass in the middle
  // it is much less). A disc that slips loses energy there, too.
  const bool is_plate = along >= 1.9 * across, is_flat = along >= (1.0 - kEqualMoments) * across;
  const double steepest = is_plate ? 0.4227 : 0.2588;  // sine of the tilt
  constexpr double kLightest = 0.249, kMost = 1.0;     // of m a^2
  constexpr double kStrongest = 0.1;                   // of a
  const double rim = across / (mass * a * a);
  const bool slips = law.kind == Friction::Kind::viscous ||
                     (law.kind == Friction::Kind::coulomb && law.mu < law.rolling / a);
  const bool stays_at_rest = sine <= steepest && is_flat && rim >= kLightest && rim <= kMost &&
                             law.rolling <= kStrongest * a;
  if (law.rolling == 0.0 || law.boring != 0.0 || slips || !stays_at_rest) return;
  // d/dt (3/2 a sin) = -rolling W sin cos, so that the time is (3 a / 2 rolling) sqrt(I1 / m g a)
  // times the integral of d(tilt) / sqrt(sin(tilt)); with tilt = u^2 nothing is singular
  constexpr int kPartsOfTime = 2000;
  const double top = std::sqrt(std::asin(sine));
  double sum = 0.0;
  for (int i = 0; i < kPartsOfTime; ++i) {
    const double u = top * (i + 0.5) / kPartsOfTime;
    sum += 2.0 * u / std::sqrt(std::sin(u * u)) * top / kPartsOfTime;
  }
  list.push_back(
      {"end_time", Q::time, 1.5 * a / law.rolling * std::sqrt(across / (mass * g * a)) * sum});
}

// a ball that slides until it rolls: uniform friction on a body whose spin does not change it
void add_ball(List& list, const BodyModel& model, const State& start) {
  const SurfacePiece* ball = model.table->surface->as_sphere();
  if (ball == nullptr || model.kind.shape != TopKind::Shape::spherical) return;
  if (ball->center_P.norm() > 1e-12 * ball->ball) return;
  const Friction& law = model.table->friction;
  const double mR2 = model.body.mass * ball->ball * ball->ball, I = model.moments[0];
  if (law.rolling != 0.0) return;
  if (law.turntable != 0.0 && law.kind == Friction::Kind::rolling && law.boring == 0.0)
    list.push_back({"circling_rate", Q::rate, law.turntable * I / (I + mR2)});
  if (law.kind != Friction::Kind::coulomb || law.turntable != 0.0) return;
  if (!is_on_table(model, moving_of(model, start))) return;
  const Vec3 slip = horizontal(slip_of(model, Touch{}, moving_of(model, start)));
  // friction mu m g slows the slip by mu g (1 + m R^2 / I)
  const double slows = law.mu * along_up(model) * (1.0 + mR2 / I);
  // a difference of velocities, which round-off leaves where it rolls
  const double rim_speed = angular_velocity(model, start.y).norm() * ball->ball;
  const bool rolls = slip.norm() < 1e-12 * rim_speed;
  list.push_back({"sliding_time", Q::time, rolls ? 0.0 : slip.norm() / slows});
}

}  // namespace

std::optional<double> growth_rate_of_spin(const BodyModel& model, const Vec3& up_P, double spin) {
  const double reach = model.table->surface->reach();
  const double rate = std::abs(spin) + std::sqrt(model.gravity_S.norm() / reach);
  const Numbers matrix = SmallDeviations(model, up_P).matrix(spin, rate, rate * reach);
  const Eigen::EigenSolver<Numbers> solver(matrix, false);
  // viscous friction may be weak; without it growth begins as a root
  const double neutral = model.table->friction.kind == Friction::Kind::viscous ? 1e-10 : 1e-7;
  // strong friction makes it large
  const auto round_off = static_cast<double>(1e-16L * matrix.norm());
  const auto most = static_cast<double>(solver.eigenvalues().real().maxCoeff());
  if (most > std::max(neutral, round_off)) return most * rate;
  return round_off > neutral ? std::nullopt : std::optional(0.0);
}

std::vector<Quantity> contact_quantities(const BodyModel& model, const State& start) {
  List list;
  add_eccentric_sphere(list, model, start);
  if (!is_level_and_unloaded(model)) return list;
  add_ball(list, model, start);
  if (model.table->friction.turntable != 0.0) return list;
  add_disc(list, model, start);
  add_vertical_spin(list, model, start);
  return list;
}

}  // namespace polhode
