// SPDX-License-Identifier: MIT
// The heavy symmetric top on a pivot (Lagrange), with the spherical and the planar pendulum as its
// limits. F. Klein and A. Sommerfeld, Theorie des Kreisels, VI: the Cayley-Klein parameters
// a = w + i z = cos(theta/2) e^(i(phi+psi)/2) and b = x + i y = sin(theta/2) e^(i(phi-psi)/2) are
// single quotients of theta functions, a ~ e^(i r t) theta_1(v - i eta)/theta_4(v), b ~ e^(i r' t)
// theta_2(v - i eta')/theta_4(v). So no angle, no integral of the third kind, and nothing that
// diverges where the axis passes through the vertical (L_z = L_3 or -L_3). Departures from print:
// the roots of the cubic are found from where the top starts, so that neither a release at rest (a
// cusp) nor steady precession loses half of the digits, and the constant phases are matched to
// value and slope.
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>

#include "base/check.h"
#include "base/units.h"
#include "math/elliptic.h"
#include "math/so3.h"
#include "math/theta.h"
#include "motion/exact/exact.h"

namespace polhode {
namespace {

using Complex = std::complex<double>;

// without the inspection for NaN that the operator makes
Complex times(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

// The start: space axes U with the third one up, body axes N with the third one along chi.
struct Lagrange {
  double A;            // moment across the axis, kg m^2
  double mu;           // |chi|, J
  double L3;           // momentum along the axis
  double spin_excess;  // L3 (1/C - 1/A), rad/s; 0 for a rotator
  Complex a, b;        // attitude
  Complex y;           // y1 + i y2

  // what follows from them
  double inner = 0.0;       // y1 gamma1 + y2 gamma2 = L_z - L3 cos(theta)
  double u_rate_A = 0.0;    // A du/dt, u = cos(theta)
  double sum = 0.0;         // L_z + L3, with all its digits where it vanishes
  double difference = 0.0;  // L_z - L3, likewise

  void derive() {
    const Complex gamma = times(Complex(0, 2), times(std::conj(a), b));
    const Complex product = times(std::conj(gamma), y);
    inner = product.real();
    u_rate_A = product.imag();
    sum = inner + 2.0 * L3 * std::norm(a);
    difference = inner - 2.0 * L3 * std::norm(b);
  }
};

// The roots u1 <= u2 <= 1 <= u3 of (du/dt)^2 = f(u), as differences that keep their digits.
struct Roots {
  double h1 = 0.0, h2 = 0.0;        // u1 - u0 <= 0 <= u2 - u0, u0 at the start
  double below = 0.0, above = 0.0;  // u2 - u1, u3 - u2
  double x1 = 0.0, x2 = 0.0;        // 1 - u1, 1 - u2
  double x3 = 0.0;                  // u3 - 1
  double plus2 = 0.0;               // 1 + u2

  double span() const { return below + above; }
};

// h^3 + p2 h^2 + p1 h + p0
struct Cubic {
  double p2, p1, p0;

  // The root beyond the others on the side of `from`, from outside: Newton's method is monotone
  // there, and ends where round-off turns it back.
  double outer_root(double from) const {
    double h = from;
    for (int i = 0; i < 300; ++i) {
      const double value = ((h + p2) * h + p1) * h + p0;
      const double slope = (3.0 * h + 2.0 * p2) * h + p1;
      if (slope <= 0.0) return h;
      const double next = h - value / slope;
      if (from > 0.0 ? !(next < h) : !(next > h)) return h;
      h = next;
    }
    return h;
  }
};

// A f(u0 + h) / 2 mu; sin^2(theta) = 4 |a b|^2
Cubic cubic_around_start(const Lagrange& top) {
  const double mA = top.mu * top.A;
  const double a2 = std::norm(top.a), b2 = std::norm(top.b);
  const double y2 = std::norm(top.y);
  return {2.0 * (a2 - b2) - 0.5 * (y2 + top.L3 * top.L3) / mA,
          -4.0 * a2 * b2 - ((a2 - b2) * y2 - top.L3 * top.inner) / mA,
          0.5 * top.u_rate_A * top.u_rate_A / mA};
}

// The root that stands alone is found first; the pair comes from the quotient, expanded about the
// start for (u1, u2) and about the upper pole for (u2, u3): there the two have opposite signs, so
// that nothing cancels when they meet.
Roots find_roots(const Lagrange& top) {
  const Cubic cubic = cubic_around_start(top);
  const double far = 1.0 + std::abs(cubic.p2) + std::abs(cubic.p1) + std::abs(cubic.p0);
  const double twice_b2 = 2.0 * std::norm(top.b);
  // x1 x2 x3
  const double product = 0.5 * top.difference * top.difference / (top.mu * top.A);

  // h^2 + s h + q, q <= 0, holds u1 and u2
  Roots r;
  const double h3 = std::max(0.0, cubic.outer_root(far));
  const double q = h3 > 0.0 ? -cubic.p0 / h3 : 0.0;
  const double s = h3 > 0.0 ? (q - cubic.p1) / h3 : 0.0;
  const double root = std::sqrt(0.25 * s * s - q);
  const double larger = 0.5 * std::abs(s) + root;
  const double smaller = larger > 0.0 ? -q / larger : 0.0;
  r.h1 = s > 0.0 ? -larger : -smaller;
  r.h2 = s > 0.0 ? smaller : larger;
  r.below = larger + smaller;
  r.above = h3 - r.h2;
  if (r.above >= r.below) {
    r.x1 = twice_b2 - r.h1;
    // of the two next to 1 the larger is a difference, the smaller a quotient
    r.x2 = std::max(0.0, twice_b2 - r.h2);
    r.x3 = std::max(0.0, h3 - twice_b2);
    if (r.x2 > r.x3) {
      r.x3 = product / (r.x1 * r.x2);
    } else if (r.x3 > 0.0 && r.x1 > 0.0) {
      r.x2 = product / (r.x1 * r.x3);
    }
  } else {
    r.h1 = std::min(0.0, cubic.outer_root(-far));
    r.x1 = twice_b2 - r.h1;
    // minus h2 + h3, from the end of the cubic where nothing cancels
    const double sum = -r.h1 > 0.5 * r.x1 ? (-cubic.p0 / r.h1 - cubic.p1) / r.h1 : cubic.p2 + r.h1;
    const double half = twice_b2 + 0.5 * sum;  // (x2 - x3) / 2
    const double pair = product / r.x1;        // x2 x3
    const double apart = std::sqrt(half * half + pair);
    const double big = std::abs(half) + apart;
    const double small = big > 0.0 ? pair / big : 0.0;
    r.x2 = half > 0.0 ? big : small;
    r.x3 = half > 0.0 ? small : big;
    r.h2 = std::max(0.0, twice_b2 - r.x2);
    r.below = r.x1 - r.x2;
    r.above = big + small;
  }
  r.plus2 = 2.0 * std::norm(top.a) + r.h2;
  return r;
}

// the modulus, m and 1 - m; a top whose three roots are one hardly moves
EllipticParameter parameter_of(const Roots& r) {
  return r.span() > 0.0 ? EllipticParameter(r.below / r.span(), r.above / r.span())
                        : EllipticParameter(0.0, 1.0);
}

// dv/dt of the argument of sn, 1/s
double rate_of_argument(const Lagrange& top, const Roots& r) {
  return std::sqrt(0.5 * top.mu * r.span() / top.A);
}

// of the nutation, s
double period_of(const Lagrange& top, const Roots& r) {
  return 2.0 * elliptic_k(parameter_of(r).m1()) / rate_of_argument(top, r);
}

// where 1 + u vanishes: tan am eta = sqrt((1 + u1) / (u2 - u1)), and
// (1 + u1)(1 + u2)(1 + u3) = (L_z + L3)^2 / 2 mu A
double pole_of_a(const Lagrange& top, const Roots& r, const EllipticParameter& parameter) {
  const double others = 2.0 * top.mu * top.A * r.plus2 * (2.0 + r.x3);
  const double s = others > 0.0 ? std::abs(top.sum) / std::sqrt(others) : 0.0;
  return std::copysign(elliptic_f(s, std::sqrt(r.below), parameter.m1(), parameter.m()), top.sum);
}

// where 1 - u vanishes: tan am eta = sqrt((1 - u2)(u3 - u1) / ((u2 - u1)(u3 - 1)))
double pole_of_b(const Lagrange& top, const Roots& r, const EllipticParameter& parameter) {
  const double eta = elliptic_f(
      std::sqrt(r.x2 * r.span()), std::sqrt(r.below * r.x3), parameter.m1(), parameter.m());
  return std::copysign(eta, top.difference);
}

class ExactHeavySymmetric final : public Trajectory {
 public:
  ExactHeavySymmetric(const Lagrange& top, const Roots& r, const Quat& q_SU, const Quat& q_PN)
      : q_SU_(q_SU),
        q_PN_(q_PN),
        A_(top.A),
        L3_(top.L3),
        parameter_(parameter_of(r)),
        kappa_(rate_of_argument(top, r)),
        theta_(parameter_, pole_of_a(top, r, parameter_), pole_of_b(top, r, parameter_)) {
    // the phase of the nutation by its double angle, which a cusp (du/dt = 0) does not hurt
    const double m = parameter_.m(), m1 = parameter_.m1();
    const double sn2 = r.below > 0.0 ? std::min(1.0, -r.h1 / r.below) : 0.0;
    const double cn2 = r.below > 0.0 ? std::min(1.0, r.h2 / r.below) : 1.0;
    const double dn = std::sqrt(cn2 + m1 * sn2);
    const double sine = dn > 0.0 && kappa_ > 0.0 ? top.u_rate_A / (top.A * kappa_ * dn) : 0.0;
    const double twice = std::atan2(sine, r.h1 + r.h2);
    delta_ = elliptic_f(std::sin(0.5 * twice), std::cos(0.5 * twice), m, m1);
    delta_ = std::clamp(delta_, -kLongestWait, kLongestWait);

    // amplitudes: see ThetaPair
    const bool direct = parameter_.direct();
    size_a_ = std::sqrt(direct ? 0.5 * r.plus2 : 0.5 * r.below / std::sqrt(m));
    size_b_ = std::sqrt(0.5 * r.x1) * (direct ? std::pow(m1, 0.25) : 1.0);

    // mean rates: those of (phi + psi)/2 and (phi - psi)/2 at a turning point, less what the theta
    // functions do there
    const double at_u2 = r.plus2 > 0.0 ? top.sum / (top.A * r.plus2) : 0.0;
    const double at_u1 = r.x1 > 0.0 ? top.difference / (top.A * r.x1) : 0.0;
    rate_a_ = 0.5 * (at_u2 + top.spin_excess) - kappa_ * theta_.rate_first();
    rate_b_ = 0.5 * (at_u1 - top.spin_excess) - kappa_ * theta_.rate_second();
    match(top);
  }

  State at(double t) const override {
    Complex a, b, a_rate, b_rate;
    moved(t, a, b, a_rate, b_rate);
    // omega = 2 conj(q) dq/dt, across the axis
    const double n2 = std::norm(a) + std::norm(b);
    const Complex y = (2.0 * A_ / n2) * (times(std::conj(a), b_rate) - times(b, std::conj(a_rate)));
    const double n = 1.0 / std::sqrt(n2);
    const Quat q_UN(n * a.real(), n * b.real(), n * b.imag(), n * a.imag());
    return {q_SU_ * q_UN * q_PN_.conjugate(), q_PN_ * Vec3(y.real(), y.imag(), L3_)};
  }

 private:
  // no top waits longer than this at the unstable equilibrium, in units of 1/kappa
  static constexpr double kLongestWait = 300.0;

  Quat q_SU_, q_PN_;
  double A_, L3_;
  EllipticParameter parameter_;
  double kappa_;  // dv/dt, 1/s
  ThetaPair theta_;
  double delta_ = 0.0;  // v = kappa t + delta
  double size_a_ = 0.0, size_b_ = 0.0;
  double rate_a_ = 0.0, rate_b_ = 0.0;  // mean rates of the phases, rad/s
  Complex phase_a_ = 1.0, phase_b_ = 1.0;

  // a and b over one positive function of t, and their slopes over the same function
  void moved(double t, Complex& a, Complex& b, Complex& a_rate, Complex& b_rate) const {
    ThetaValue first, second;
    theta_.at(kappa_ * t + delta_, first, second);
    const Complex turn_a = times(phase_a_, {std::cos(rate_a_ * t), std::sin(rate_a_ * t)});
    const Complex turn_b = times(phase_b_, {std::cos(rate_b_ * t), std::sin(rate_b_ * t)});
    a = size_a_ * times(turn_a, {first.re, first.im});
    b = size_b_ * times(turn_b, {second.re, second.im});
    const Complex slope_a(kappa_ * first.slope_re - rate_a_ * first.im,
                          kappa_ * first.slope_im + rate_a_ * first.re);
    const Complex slope_b(kappa_ * second.slope_re - rate_b_ * second.im,
                          kappa_ * second.slope_im + rate_b_ * second.re);
    a_rate = size_a_ * times(turn_a, slope_a);
    b_rate = size_b_ * times(turn_b, slope_b);
  }

  // Turns both phases so that value and slope fit the start; where one of them vanishes, at a pole,
  // the other still has all digits.
  void match(const Lagrange& top) {
    Complex a, b, a_rate, b_rate;
    moved(0.0, a, b, a_rate, b_rate);
    // the slope of the common positive function
    const double n2 = std::norm(a) + std::norm(b);
    const double common =
        (times(std::conj(a), a_rate).real() + times(std::conj(b), b_rate).real()) / n2;
    a_rate -= common * a;
    b_rate -= common * b;

    // dq/dt = q o omega / 2
    const Complex across = top.y / top.A;
    const double along = top.L3 / top.A + top.spin_excess;
    const Complex i_along(0.0, along);
    const Complex a_wanted = 0.5 * (times(i_along, top.a) - times(top.b, std::conj(across)));
    const Complex b_wanted = 0.5 * (times(top.a, across) - times(i_along, top.b));
    const double time2 = 1.0 / (kappa_ * kappa_ + along * along + std::norm(across) +
                                rate_a_ * rate_a_ + rate_b_ * rate_b_ + 1e-300);
    phase_a_ = direction(times(top.a, std::conj(a)) + time2 * times(a_wanted, std::conj(a_rate)));
    phase_b_ = direction(times(top.b, std::conj(b)) + time2 * times(b_wanted, std::conj(b_rate)));
  }

  static Complex direction(const Complex& c) {
    const double size = std::abs(c);
    return size > 0.0 ? c / size : Complex(1.0, 0.0);
  }
};

// the rotation that carries the third axis into the direction of v
Quat third_axis_into(const Vec3& v) {
  if (v.x() == 0.0 && v.y() == 0.0) {
    return v.z() >= 0.0 ? Quat::Identity() : Quat(0.0, 1.0, 0.0, 0.0);
  }
  return turn_between(Vec3::UnitZ(), v).normalized();
}

// The start in axes of its own: q = q_SU o (a, b) o q_PN^-1.
struct Start {
  Lagrange top;
  Quat q_SU, q_PN;

  // upright or hanging, without a push aside: it spins in place
  bool stays_vertical() const {
    return (std::norm(top.a) == 0.0 || std::norm(top.b) == 0.0) && std::norm(top.y) == 0.0;
  }
};

Start start_of(const BodyModel& model, const State& state) {
  CHECK(model.chi_P.squaredNorm() > 0.0);
  Start start;
  start.q_SU = third_axis_into(model.up_S);
  start.q_PN = third_axis_into(model.chi_P);
  const Quat q_UN = start.q_SU.conjugate() * normalized(state.q) * start.q_PN;
  const Vec3 y_N = start.q_PN.conjugate() * state.y;

  // the moments along and across chi; a rotator has none along it, and no momentum either
  const int axis = model.kind.axis;
  const double across = model.kind.symmetric() ? model.moments[(axis + 1) % 3] : model.moments[0];
  const double inverse_along = model.inverse_moments[model.kind.symmetric() ? axis : 0];
  Lagrange& top = start.top;
  top.A = across;
  top.mu = model.chi_P.norm();
  top.L3 = model.kind.rotator ? 0.0 : y_N.z();
  top.spin_excess = top.L3 * (inverse_along - 1.0 / across);
  top.a = Complex(q_UN.w(), q_UN.z());
  top.b = Complex(q_UN.x(), q_UN.y());
  top.y = Complex(y_N.x(), y_N.y());
  top.derive();
  return start;
}

// A d(phi)/dt = (L_z - L3 u) / (1 - u^2) at u = u0 + h: by the poles, where nothing cancels near
// the vertical, or from the start, where the spin of a fast top does not, whichever cancels less.
double precession_rate(const Lagrange& top, double h, double one_plus_u, double one_minus_u) {
  const double at_bottom = 0.5 * top.sum / one_plus_u, at_top = 0.5 * top.difference / one_minus_u;
  const double sine2 = one_plus_u * one_minus_u;
  const double before = top.inner / sine2, since = -top.L3 * h / sine2;
  const bool from_start =
      std::abs(before) + std::abs(since) < std::abs(at_bottom) + std::abs(at_top);
  return (from_start ? before + since : at_bottom + at_top) / top.A;
}

// (1 + u1)(1 + u2)(1 + u3) = (L_z + L3)^2 / 2 mu A: nothing cancels where the axis hangs down
double lower_plus(const Lagrange& top, const Roots& r) {
  const double others = 2.0 * top.mu * top.A * r.plus2 * (2.0 + r.x3);
  return others > 0.0 ? top.sum * top.sum / others : std::max(0.0, 2.0 * std::norm(top.a) + r.h1);
}

// An angle, and what round-off may make of it, rad.
struct Turn {
  double angle, error;
};

// How far chi goes round the vertical in a nutation: the integral of its rate as one about each
// pole, 1 - u = x1 cos^2 + x2 sin^2 and 1 + u likewise, u = u1 + (u2 - u1) sn^2.
Turn turn_by_poles(const Lagrange& top, const Roots& r) {
  const double plus1 = lower_plus(top, r);
  const double m1 = parameter_of(r).m1();
  const double factor = 1.0 / (top.A * rate_of_argument(top, r));
  const auto about = [&](double momentum, double low, double high) {
    return factor * momentum * elliptic_cel(m1, high / low, 1.0 / low, 1.0 / low);
  };
  const double at_bottom = about(top.sum, plus1, r.plus2);
  const double at_top = about(top.difference, r.x1, r.x2);
  // The momenta are sums, of an attitude that is rounded; but beside a pole the part is half a
  // turn, whatever the momentum is.
  const auto error_of = [&](double part, double momentum, const Complex& pole) {
    const double from_pole = std::abs(pole);
    const double lost = std::abs(top.inner) + 2.0 * std::abs(top.y) +
                        std::abs(top.L3) * from_pole * (2.0 * from_pole + 4.0);
    const double unsettled = std::min(std::abs(part), std::abs(kPi - std::abs(part)));
    return 8.0 * std::abs(part) + unsettled * lost / std::abs(momentum);
  };
  constexpr double kRoundOff = std::numeric_limits<double>::epsilon();
  const double error =
      kRoundOff * (error_of(at_bottom, top.sum, top.a) + error_of(at_top, top.difference, top.b));
  return {at_bottom + at_top, error};
}

// The same as the mean of the rate at equal times, which of a periodic function is as good as the
// integral: rates have the digits that their parts lack where a fast top hardly precesses. Half as
// many times give another where the rate has peaks, beside the vertical.
Turn turn_by_rates(const Lagrange& top, const Roots& r, double period) {
  constexpr int kTimes = 4096;
  const EllipticParameter parameter = parameter_of(r);
  double even = 0.0, odd = 0.0, largest = 0.0;
  for (int i = 0; i < kTimes; ++i) {
    // u = u1 + (u2 - u1) sn^2
    const double cn = parameter.at(2.0 * parameter.quarter_period() * i / kTimes).cn;
    const double down = r.below * cn * cn;  // below the upper turning point
    const double rate = precession_rate(top, r.h2 - down, r.plus2 - down, r.x2 + down);
    (i % 2 == 0 ? even : odd) += rate / kTimes;
    largest = std::max(largest, std::abs(rate));
  }
  constexpr double kRoundOff = 8.0 * std::numeric_limits<double>::epsilon();
  return {(even + odd) * period, (2.0 * std::abs(even - odd) + kRoundOff * largest) * period};
}

}  // namespace

std::unique_ptr<Trajectory> exact_heavy_symmetric(const BodyModel& model, const State& state) {
  const Start start = start_of(model, state);
  if (start.stays_vertical()) return exact_spherical(model, state);
  return std::make_unique<ExactHeavySymmetric>(
      start.top, find_roots(start.top), start.q_SU, start.q_PN);
}

Nutation nutation_of(const BodyModel& model, const State& state) {
  const Start start = start_of(model, state);
  const Lagrange& top = start.top;
  Nutation nutation;
  if (start.stays_vertical()) {
    nutation.least_tilt = nutation.greatest_tilt = std::norm(top.a) == 0.0 ? kPi : 0.0;
    return nutation;
  }
  const Roots r = find_roots(top);
  const double plus1 = lower_plus(top, r);
  nutation.over_the_top = r.x3 > r.x2;
  nutation.least_tilt = 2.0 * std::atan2(std::sqrt(r.x2), std::sqrt(r.plus2));
  nutation.greatest_tilt = 2.0 * std::atan2(std::sqrt(r.x1), std::sqrt(plus1));
  nutation.precession_at_least = precession_rate(top, r.h2, r.plus2, r.x2);
  nutation.precession_at_greatest = precession_rate(top, r.h1, plus1, r.x1);
  nutation.period = period_of(top, r);
  return nutation;
}

std::optional<double> precession_in_a_nutation(const BodyModel& model, const State& state) {
  constexpr double kAllowed = 1e-5;
  const Start start = start_of(model, state);
  CHECK(!start.stays_vertical());
  const Lagrange& top = start.top;
  const Roots r = find_roots(top);
  const double period = period_of(top, r);
  CHECK(std::isfinite(period));
  const Turn one = turn_by_poles(top, r), other = turn_by_rates(top, r, period);
  const Turn& turn = other.error < one.error || std::isnan(one.angle) ? other : one;
  if (!(turn.error <= kAllowed * std::abs(turn.angle))) return std::nullopt;
  return turn.angle;
}

}  // namespace polhode
