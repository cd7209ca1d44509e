// SPDX-License-Identifier: MIT
// The free asymmetric top. Momentum: Jacobi's elliptic functions, with the two signs of the energy
// excess kept apart (R. van Zon and J. Schofield, J. Comput. Phys. 225 (2007) 145; E. Celledoni and
// others, J. Comput. Phys. 227 (2008) 3164). Attitude: q = q0 P(0)^-1 exp(psi e / 2) P(t), where
// P(t) turns the momentum, seen in the body, onto the axis e about which it never turns back, and
// psi is the angle about the fixed L. Departures from print: the differences of squares that decide
// everything are computed without cancellation, and psi is a uniform turn plus the phase of a theta
// function (Jacobi 1849) instead of an incomplete integral of the third kind, so that it has no
// branches.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "math/so3.h"
#include "math/theta.h"
#include "motion/exact/exact.h"

namespace polhode {
namespace {

// Components in the axes N: the principal axes in order of their moments, I1 < I2 < I3, one of them
// turned round if that makes N right-handed, and the body turned by pi about axis 2 if the momentum
// along the axis of rotation is negative.
class SortedAxes {
 public:
  SortedAxes(const Vec3& moments) {
    std::iota(index_.begin(), index_.end(), 0);
    std::sort(index_.begin(), index_.end(), [&](int i, int j) { return moments[i] < moments[j]; });
    const bool even = (index_[0] + 1) % 3 == index_[1];
    sign_ = Vec3(1, even ? 1 : -1, 1);
  }

  void turn_about_second() {
    sign_[0] = -sign_[0];
    sign_[2] = -sign_[2];
  }

  Vec3 sorted(const Vec3& v_P) const {
    return {sign_[0] * v_P[index_[0]], sign_[1] * v_P[index_[1]], sign_[2] * v_P[index_[2]]};
  }

  Vec3 principal(const Vec3& v_N) const {
    Vec3 v_P;
    for (int i = 0; i < 3; ++i)
      v_P[index_[i]] = sign_[i] * v_N[i];
    return v_P;
  }

  // the same rotation with its axis in P
  Quat principal(double w, const Vec3& v_N) const {
    const Vec3 v = principal(v_N);
    return {w, v.x(), v.y(), v.z()};
  }

 private:
  std::array<int, 3> index_;
  Vec3 sign_;
};

// The numbers that both branches share; all in N.
struct FreeTop {
  SortedAxes axes;
  double I1, I2, I3;
  Vec3 y;               // at the start
  double G;             // |y|
  double excess1;       // 2 E I1 - G^2 up to sign and scale: y2^2 (I2-I1)/I2 + y3^2 (I3-I1)/I3 >= 0
  double excess2;       // y3^2 (I3-I2)/I3 - y1^2 (I2-I1)/I1; 0 on the separatrix
  double excess3;       // y1^2 (I3-I1)/I1 + y2^2 (I3-I2)/I2 >= 0
  double most1, most3;  // largest |y1| and |y3| that the invariants allow

  FreeTop(const BodyModel& model, const State& start) : axes(model.moments) {
    const Vec3 moments = axes.sorted(model.moments).cwiseAbs();
    I1 = moments[0], I2 = moments[1], I3 = moments[2];
    y = axes.sorted(start.y);
    G = y.norm();
    const Vec3 squares = y.cwiseProduct(y);
    excess1 = squares[1] * (I2 - I1) / I2 + squares[2] * (I3 - I1) / I3;
    excess2 = squares[2] * (I3 - I2) / I3 - squares[0] * (I2 - I1) / I1;
    excess3 = squares[0] * (I3 - I1) / I1 + squares[1] * (I3 - I2) / I2;
    most1 = std::sqrt(I1 * excess3 / (I3 - I1));
    most3 = std::sqrt(I3 * excess1 / (I3 - I1));
  }
};

// exp(angle e / 2) o P, with P the turn that carries y/G onto e = axis 1 or 3; (c, s) is a complex
// number in the direction of angle / 2.
Quat turned_onto_axis(const FreeTop& top, const Vec3& y, int axis, double c, double s) {
  const double p0 = std::sqrt(0.5 * (1.0 + y[axis] / top.G));
  const double d = 0.5 / (top.G * p0);
  const double n = 1.0 / std::sqrt(c * c + s * s);
  c *= n;
  s *= n;
  if (axis == 0) {
    const double b = y[2] * d, a = -y[1] * d;
    return top.axes.principal(c * p0, {s * p0, c * b - s * a, c * a + s * b});
  }
  const double b = y[1] * d, a = -y[0] * d;
  return top.axes.principal(c * p0, {c * b - s * a, c * a + s * b, s * p0});
}

// Rotation about axis 1 (axis = 0, excess2 < 0) or axis 3 (axis = 2, excess2 > 0).
class ExactAsymmetric final : public Trajectory {
 public:
  ExactAsymmetric(const FreeTop& top, const Quat& q0)
      : top_(top),
        axis_(top.excess2 < 0.0 ? 0 : 2),
        parameter_(squared_modulus(top, false), squared_modulus(top, true)),
        phase_(parameter_, pole(top, parameter_)) {
    if (top_.y[axis_] < 0.0) {
      top_.axes.turn_about_second();
      top_.y = Vec3(-top_.y[0], top_.y[1], -top_.y[2]);
    }
    const double I1 = top.I1, I2 = top.I2, I3 = top.I3;
    const bool first = axis_ == 0;
    const double most2 =
        first ? std::sqrt(I2 * top.excess1 / (I2 - I1)) : std::sqrt(I2 * top.excess3 / (I3 - I2));
    most_ = Vec3(top.most1, most2, top.most3);
    lambda_ = first ? -std::sqrt(top.excess3 * (I2 - I1) / (I1 * I2 * I3))
                    : -std::sqrt(top.excess1 * (I3 - I2) / (I1 * I2 * I3));
    nu_ = first ? elliptic_f(
                      top_.y[1] * most_[2], top_.y[2] * most_[1], parameter_.m(), parameter_.m1())
                : elliptic_f(
                      top_.y[1] * most_[0], top_.y[0] * most_[1], parameter_.m(), parameter_.m1());

    // d psi / dt where the momentum is in the plane of axes 1 and 3, less what the phase does there
    const double G = top.G;
    half_rate_ = first ? 0.5 * (top.most3 * (top.most3 / ((G + top.most1) * I3)) + top.most1 / I1)
                       : 0.5 * (top.most1 * (top.most1 / ((G + top.most3) * I1)) + top.most3 / I3);
    half_rate_ += (first ? lambda_ : -lambda_) * phase_.rate();
    before_ = (q0 * moved(0.0).conjugate()).normalized();
  }

  State at(double t) const override {
    Vec3 y_N;
    const Quat turn = moved(t, &y_N);
    return {before_ * turn, top_.axes.principal(y_N)};
  }

 private:
  FreeTop top_;
  int axis_;
  EllipticParameter parameter_;
  ThetaPhase phase_;
  Vec3 most_;         // amplitudes of the three components
  double lambda_;     // du/dt, 1/s
  double nu_;         // u = lambda t - nu
  double half_rate_;  // half of the mean of d psi/dt, rad/s
  Quat before_;

  // m, or m1 = 1 - m, from the very differences that make it small
  static double squared_modulus(const FreeTop& top, bool complement) {
    const double a = top.excess3 * (top.I2 - top.I1);
    const double b = top.excess1 * (top.I3 - top.I2);
    const double rest = std::abs(top.excess2) * (top.I3 - top.I1);
    if (complement) return std::min(1.0, rest / std::max(a, b));
    return std::min(1.0, std::min(a, b) / std::max(a, b));
  }

  // where psi has its pole: eta = F(atan(1/sqrt(-n)) | m1), n the characteristic of Pi
  static double pole(const FreeTop& top, const EllipticParameter& parameter) {
    const double inner = top.I1 * (top.I3 - top.I2);
    const double outer = top.I3 * (top.I2 - top.I1);
    const bool first = top.excess2 < 0.0;
    return elliptic_f(std::sqrt(first ? outer : inner),
                      std::sqrt(first ? inner : outer),
                      parameter.m1(),
                      parameter.m());
  }

  Quat moved(double t, Vec3* momentum = nullptr) const {
    const double u = lambda_ * t - nu_;
    const SnCnDn f = parameter_.at(u);
    const Vec3 y = axis_ == 0 ? Vec3(most_[0] * f.dn, -most_[1] * f.sn, most_[2] * f.cn)
                              : Vec3(most_[0] * f.cn, -most_[1] * f.sn, most_[2] * f.dn);
    if (momentum) *momentum = y;

    // exp(i half_rate t) times the phase, which runs the other way about axis 1
    const ThetaValue theta = phase_.at(u);
    const double im = axis_ == 0 ? -theta.im : theta.im;
    const double c = std::cos(half_rate_ * t), s = std::sin(half_rate_ * t);
    return turned_onto_axis(top_, y, axis_, c * theta.re - s * im, c * im + s * theta.re);
  }
};

// On the separatrix, the rotation about axis 2 included: hyperbolic functions.
class ExactSeparatrix final : public Trajectory {
 public:
  ExactSeparatrix(const FreeTop& top, const Quat& q0) : top_(top) {
    const double I1 = top.I1, I2 = top.I2, I3 = top.I3;
    axis_ = top.most1 >= top.most3 ? 2 : 0;
    if (top_.y[axis_] < 0.0) {
      top_.axes.turn_about_second();
      top_.y = Vec3(-top_.y[0], top_.y[1], -top_.y[2]);
    }
    const Vec3& y = top_.y;
    const double across = std::hypot(y[0], y[2]);
    const double signs = std::copysign(1.0, y[0]) * std::copysign(1.0, y[2]);
    rate_ = signs * (top.G / I2) * std::sqrt((I2 - I1) * (I3 - I2) / (I1 * I3));
    // tanh(nu) = -y2/G without the loss of 1 - y2/G
    nu_ = across > 0.0 ? -std::asinh(y[1] / across) : 0.0;
    // at rest on axis 2 nothing moves but psi
    still_ = across == 0.0;
    // |y1| and |y3| in the plane of axes 1 and 3; on the separatrix their squares add to G^2
    const double a = std::sqrt(I1 * (I3 - I2)), b = std::sqrt(I3 * (I2 - I1));
    plane_ = Vec3(std::copysign(top.G * a / std::hypot(a, b), y[0]),
                  0.0,
                  std::copysign(top.G * b / std::hypot(a, b), y[2]));
    const double other = plane_[2 - axis_];
    slope_ = (std::abs(plane_[axis_]) - top.G) / other * (axis_ == 2 ? 1.0 : -1.0);
    half_rate_ = 0.5 * top.G / I2;
    before_ = (q0 * moved(0.0).conjugate()).normalized();
  }

  State at(double t) const override {
    Vec3 y_N;
    const Quat turn = moved(t, &y_N);
    return {before_ * turn, top_.axes.principal(y_N)};
  }

 private:
  FreeTop top_;
  int axis_;
  bool still_;
  double rate_, nu_, slope_, half_rate_;
  Vec3 plane_;
  Quat before_;

  Quat moved(double t, Vec3* momentum = nullptr) const {
    const double u = rate_ * t - nu_;
    const double sech = still_ ? 0.0 : 1.0 / std::cosh(u);
    const double tanh = still_ ? std::copysign(1.0, top_.y[1]) : std::tanh(u);
    const Vec3 y(plane_[0] * sech, top_.G * tanh, plane_[2] * sech);
    if (momentum) *momentum = y;
    // psi = G t / I2 + 2 atan(slope tanh(u/2))
    const double bend = still_ ? 0.0 : slope_ * std::tanh(0.5 * u);
    const double c = std::cos(half_rate_ * t), s = std::sin(half_rate_ * t);
    return turned_onto_axis(top_, y, axis_, c - s * bend, c * bend + s);
  }
};

}  // namespace

std::unique_ptr<Trajectory> exact_asymmetric(const BodyModel& model, const State& start) {
  const FreeTop top(model, start);
  if (top.G == 0.0) return exact_spherical(model, start);
  // nearer to the separatrix than the elliptic functions can tell
  const double least = 1e-280 * std::max(top.excess1, top.excess3);
  if (std::abs(top.excess2) <= least) return std::make_unique<ExactSeparatrix>(top, start.q);
  return std::make_unique<ExactAsymmetric>(top, start.q);
}

}  // namespace polhode
