// SPDX-License-Identifier: MIT
#include "motion/steppers/free_flow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/exact/exact.h"
#include "motion/steppers/turn.h"

namespace polhode {
namespace {

// a series step turns the body by at most this; the terms then fall by more than a factor of two
constexpr double kMostTurn = 0.4;
constexpr int kMostTerms = 48;
// beyond this the closed form, which takes its time to set up, is cheaper than the series
constexpr double kManyTurns = 8.0;

}  // namespace

FreeFlow::FreeFlow(const BodyModel& model)
    : inverse_(model.inverse_moments),
      asymmetric_(model.kind.shape == TopKind::Shape::asymmetric),
      axis_(model.kind.axis),
      across_(inverse_[(axis_ + 1) % 3]),
      difference_(model.kind.symmetric() ? inverse_[axis_] - across_ : 0.0),
      free_(model) {
  free_.chi_P.setZero();
  for (int i = 0; i < 3; ++i)
    gyration_[i] = inverse_[(i + 2) % 3] - inverse_[(i + 1) % 3];
}

// Landau and Lifshitz, Mechanics, 33: a turn about L by |L| h / I1, then one about the own axis
void FreeFlow::by_turns(double h, Quat& q, Vec3& y) const {
  q = q * turn_by(h * across_ * y);
  if (difference_ != 0.0) turn_about_axis(axis_, h * difference_ * y[axis_], q, y);
}

void FreeFlow::by_series_or_closed_form(double h, Quat& q, Vec3& y) const {
  const double turn = std::abs(h) * y.norm() * inverse_.maxCoeff();
  if (turn > kManyTurns) {
    State s;
    s.q = q;
    s.y = y;
    s = exact_asymmetric(free_, s)->at(h);
    q = s.q;
    y = s.y;
    return;
  }
  const int pieces = static_cast<int>(std::ceil(std::max(turn / kMostTurn, 1.0)));
  for (int i = 0; i < pieces; ++i)
    series_step(h / pieces, q, y);
}

void FreeFlow::series_step(double h, Quat& q, Vec3& y) const {
  const double G = y.norm();
  if (G == 0.0) return;
  int e = 0;
  y.cwiseAbs().maxCoeff(&e);
  const double sign = y[e] < 0.0 ? -1.0 : 1.0;

  // terms of y, each times h^k, and of 1 / (|y| + y.e)
  std::array<Vec3, kMostTerms> terms;
  std::array<double, kMostTerms> inverse;
  terms[0] = y;
  inverse[0] = 1.0 / (G + sign * y[e]);
  Vec3 end = y;
  double integral = inverse[0];
  const double enough = 0.125 * std::numeric_limits<double>::epsilon() * G;
  double last = G;
  for (int k = 0; k + 1 < kMostTerms; ++k) {
    Vec3 products = Vec3::Zero();
    for (int m = 0; m <= k; ++m) {
      const Vec3& a = terms[m];
      const Vec3& b = terms[k - m];
      products += Vec3(a[1] * b[2], a[2] * b[0], a[0] * b[1]);
    }
    terms[k + 1] = h / (k + 1) * gyration_.cwiseProduct(products);
    double sum = 0.0;
    for (int m = 0; m <= k; ++m)
      sum += terms[m + 1][e] * inverse[k - m];
    inverse[k + 1] = -sign * inverse[0] * sum;
    end += terms[k + 1];
    integral += inverse[k + 1] / (k + 2);
    const double size = terms[k + 1].lpNorm<1>();
    if (size + last <= enough) break;
    last = size;
  }

  // 2 T - |y|^2 / I without cancellation
  const Vec3 excess = inverse_ - Vec3::Constant(inverse_[e]);
  const double psi = h * (G * inverse_[e] + y.cwiseProduct(y).dot(excess) * integral);
  const auto least_turn = [&](const Vec3& v) {
    const Vec3 across = v.cross(sign * Vec3::Unit(e));
    const double along = v.norm() + sign * v[e];
    return Quat(along, across.x(), across.y(), across.z()).normalized();
  };
  q = q * (least_turn(y).conjugate() * (turn_by(psi * sign * Vec3::Unit(e)) * least_turn(end)));
  y = G / end.norm() * end;
}

}  // namespace polhode
