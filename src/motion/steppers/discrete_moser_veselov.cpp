// SPDX-License-Identifier: MIT
// The discrete Moser-Veselov algorithm of the free body (Moser and Veselov, Comm. Math. Phys. 139
// (1991) 217) in quaternions, and its preprocessed variants of order 4 to 10, which step a body
// with moments modified such that the step is exact to that order (Hairer and Vilmart, J. Phys. A
// 39 (2006) 13225, equations 7 and 8, table 1). All keep energy and L in space.
#include <array>
#include <cmath>

#include "math/so3.h"
#include "motion/steppers/all.h"
#include "motion/steppers/no_solution.h"
#include "motion/steppers/turn.h"

namespace polhode {
namespace {

// 1 / modified moment = (1 + s) / moment + d, with s and d polynomials in C = h^2 |y|^2 / 2 and
// H = h^2 y.w / 2. Row n holds the terms C^(n-k) H^k, k = 0..n, that an order of 2 n + 2 needs.
class ModifiedMoments {
 public:
  ModifiedMoments(const Vec3& moments, int order) : terms_(order / 2 - 1) {
    const auto sum = [&](int a) {
      return moments.array().pow(a).sum();
    };
    const auto pairs = [&](int b, int c) {
      double total = 0.0;
      for (int k = 0; k < 3; ++k) {
        total += (std::pow(moments[(k + 1) % 3], b) + std::pow(moments[(k + 2) % 3], b)) /
                 std::pow(moments[k], c);
      }
      return total;
    };
    const double e = moments.prod();  // delta in the paper
    const double e2 = e * e, e3 = e2 * e, e4 = e3 * e;
    const double p1 = sum(1), p2 = sum(2), p3 = sum(3), p4 = sum(4);
    const double m1 = sum(-1), m2 = sum(-2), m3 = sum(-3), m4 = sum(-4);
    const double t11 = pairs(1, 1), t12 = pairs(1, 2), t21 = pairs(2, 1), t22 = pairs(2, 2);
    const double t13 = pairs(1, 3), t31 = pairs(3, 1);
    // clang-format off
    s_ = {{{p1 / (6 * e), -m1 / 3},
           {(p2 / e - m1) / (30 * e), (1 - t11) / (30 * e), (3 * p1 / e + 2 * m2) / 60},
           {(4 * e + 17 * p3 - 15 * e * t11) / (2520 * e3),
            (9 * p1 + 10 * e * m2 - 6 * t21) / (420 * e2),
            (6 * e * t12 - 100 * e * m1 + 53 * p2) / (2520 * e2),
            (15 - e * m3 - 2 * t11) / (630 * e)},
           {(62 * p4 - 94 * e * t21 + 66 * e2 * m2 + 81 * e * p1) / (45360 * e4),
            (-77 * t31 + 75 * e * t12 + 214 * p2 - 240 * e * m1) / (22680 * e3),
            (26 * e * t22 + 55 * p3 + 204 * e - 50 * e2 * m3 - 59 * e * t11) / (7560 * e3),
            (137 * e * m2 - e * t13 + 3 * p1 - 69 * t21) / (11340 * e2),
            (2 * e2 * m4 + 5 * e * t12 - 171 * e * m1 + 159 * p2) / (45360 * e2)}}};
    d_ = {{{-1 / (3 * e), p1 / (6 * e)},
           {-p1 / (60 * e2), (6 * e * m1 - p2) / (60 * e2), -(9 + t11) / (60 * e)},
           {(34 * e * m1 - 19 * p2) / (2520 * e3),
            (p3 + 2 * e * t11 - 85 * e) / (1260 * e3),
            (47 * p1 + 13 * t21 - 38 * e * m2) / (2520 * e2),
            (9 * e * m1 + e * t12 - 11 * p2) / (1260 * e2)},
           {(60 * e * t11 - 61 * p3 - 247 * e) / (45360 * e4),
            (54 * e * p1 - p4 + 218 * e * t21 - 426 * e2 * m2) / (45360 * e4),
            (125 * e * m1 - 5 * t31 - 130 * p2 + 4 * e * t12) / (7560 * e3),
            (67 * p3 - 735 * e - 15 * e * t22 + 87 * e * t11 + 34 * e2 * m3) / (22680 * e3),
            (165 * p1 - e * t13 - 9 * t21 - 145 * e * m2) / (45360 * e2)}}};
    // clang-format on
  }

  // 1 / modified moments, from 1 / moments
  Vec3 inverse(const Vec3& inverse_moments, double C, double H) const {
    double s = 1.0, d = 0.0;
    for (int n = 0; n < terms_; ++n) {
      // sum of coefficient k times C^(n+1-k) H^k
      double in_s = 0.0, in_d = 0.0, power = 1.0;
      for (int k = 0; k <= n + 1; ++k) {
        in_s = in_s * C + s_[n][k] * power;
        in_d = in_d * C + d_[n][k] * power;
        power *= H;
      }
      s += in_s;
      d += in_d;
    }
    return s * inverse_moments + Vec3::Constant(d);
  }

 private:
  int terms_;
  std::array<std::array<double, 5>, 4> s_, d_;
};

class DiscreteMoserVeselov final : public Stepper {
 public:
  DiscreteMoserVeselov(const BodyModel& model, int order)
      : model_(model), order_(order), modified_(model.moments, order) {}

  void step(double t, double h, State& s, Work& work) const override {
    const Vec3 w = angular_velocity(model_, s.y);
    Vec3 inverse = model_.inverse_moments;
    if (order_ > 2) {
      const double half = 0.5 * h * h;
      inverse = modified_.inverse(inverse, half * s.y.squaredNorm(), half * s.y.dot(w));
    }
    const Vec3 moments = inverse.cwiseInverse();
    const Vec3 rest(moments[1] - moments[2], moments[2] - moments[0], moments[0] - moments[1]);
    const Vec3 a = 0.5 * h * inverse.cwiseProduct(s.y);
    const Vec3 c = solve(a, rest.cwiseProduct(inverse));
    const double alpha = 1.0 + c.squaredNorm();
    // written so that a NaN fails; beyond a quarter turn lies the other branch of the arcsine
    if (!(alpha <= 2.0)) {
      throw no_solution("dmv" + std::to_string(order_), t, h, model_, s.y, kLimit);
    }
    s.q = s.q * Quat(1.0, c.x(), c.y(), c.z());
    s.q.coeffs() /= s.q.norm();
    s.y += 4.0 / (h * alpha) * rest.cwiseProduct(products(c));
    ++work.evaluations;
  }

 private:
  static constexpr const char* kLimit =
      "the step turns the body by asin(h |omega|) and has no solution beyond h |omega| = 1";
  static constexpr int kMostIterations = 25;

  BodyModel model_;
  int order_;
  ModifiedMoments modified_;

  static Vec3 products(const Vec3& c) { return {c[1] * c[2], c[2] * c[0], c[0] * c[1]}; }

  // Newton's method for c = (1 + |c|^2) a + k o (c2 c3, c3 c1, c1 c2); NaN where there is none
  static Vec3 solve(const Vec3& a, const Vec3& k) {
    Vec3 c = (1.0 + a.squaredNorm()) * a + k.cwiseProduct(products(a));
    for (int i = 0; i < kMostIterations; ++i) {
      const Vec3 residual = c - (1.0 + c.squaredNorm()) * a - k.cwiseProduct(products(c));
      Mat3 jacobian = Mat3::Identity() - 2.0 * a * c.transpose();
      jacobian(0, 1) -= k[0] * c[2], jacobian(0, 2) -= k[0] * c[1];
      jacobian(1, 0) -= k[1] * c[2], jacobian(1, 2) -= k[1] * c[0];
      jacobian(2, 0) -= k[2] * c[1], jacobian(2, 1) -= k[2] * c[0];
      // by Cramer's rule
      const Vec3 r1 = jacobian.row(0), r2 = jacobian.row(1), r3 = jacobian.row(2);
      const Vec3 x1 = r2.cross(r3), x2 = r3.cross(r1), x3 = r1.cross(r2);
      const Vec3 change = (residual[0] * x1 + residual[1] * x2 + residual[2] * x3) / r1.dot(x1);
      c -= change;
      // the next change would be of the order of the square of this one
      if (change.squaredNorm() <= 1e-17 * c.norm() * (1.0 + k.norm())) return c;
      if (c.squaredNorm() == 0.0) return c;
    }
    return Vec3::Constant(std::nan(""));
  }
};

}  // namespace

std::unique_ptr<Stepper> make_dmv2(const BodyModel& model, double) {
  return std::make_unique<DiscreteMoserVeselov>(model, 2);
}
std::unique_ptr<Stepper> make_dmv4(const BodyModel& model, double) {
  return std::make_unique<DiscreteMoserVeselov>(model, 4);
}
std::unique_ptr<Stepper> make_dmv6(const BodyModel& model, double) {
  return std::make_unique<DiscreteMoserVeselov>(model, 6);
}
std::unique_ptr<Stepper> make_dmv8(const BodyModel& model, double) {
  return std::make_unique<DiscreteMoserVeselov>(model, 8);
}
std::unique_ptr<Stepper> make_dmv10(const BodyModel& model, double) {
  return std::make_unique<DiscreteMoserVeselov>(model, 10);
}

}  // namespace polhode
