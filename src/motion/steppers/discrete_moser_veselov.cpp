// SPDX-License-Identifier: MIT
// The discrete Moser-Veselov method of a free body in quaternions, and the same on moments that are
// changed a little at each start so that its order is 4, 6, 8 or 10. It keeps energy, |y| and L in
// space to round-off. E. Hairer and G. Vilmart, J. Phys. A 39 (2006) 13225, table 1 (coefficients);
// J. Moser and A. P. Veselov, Commun. Math. Phys. 139 (1991) 217; R. I. McLachlan and A. Zanna,
// Found. Comput. Math. 5 (2005) 87 (order 4).
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "base/error.h"
#include "math/so3.h"
#include "motion/steppers/all.h"

namespace polhode {
namespace {

// Sums of powers of the moments: sigma_a = sum I_i^a, and tau_{b,c}, the sum of
// (I_i^b + I_j^b) / I_k^c over the three choices of k.
struct PowerSums {
  explicit PowerSums(const Vec3& moments) : I(moments), d(moments.prod()) {}
  double s(int a) const { return I.array().pow(a).sum(); }
  double t(int b, int c) const {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
      sum += (std::pow(I[(k + 1) % 3], b) + std::pow(I[(k + 2) % 3], b)) / std::pow(I[k], c);
    return sum;
  }
  Vec3 I;
  double d;  // the product of the moments
};

// Factors of C^i H^j, C = h^2 |y|^2 / 2 and H = h^2 y.w / 2, in 1/I~ = S/I + D: one row per order,
// factor [k] belongs to C^(n - k) H^k.
struct Corrections {
  explicit Corrections(const Vec3& moments) {
    const PowerSums p(moments);
    const double d = p.d, d2 = d * d, d3 = d2 * d, d4 = d3 * d;
    const double s1 = p.s(1), s2 = p.s(2), s3 = p.s(3), s4 = p.s(4);
    const double m1 = p.s(-1), m2 = p.s(-2), m3 = p.s(-3), m4 = p.s(-4);
    const double t11 = p.t(1, 1), t12 = p.t(1, 2), t13 = p.t(1, 3);
    const double t21 = p.t(2, 1), t22 = p.t(2, 2), t31 = p.t(3, 1);
    // clang-format off
    S[0] = {s1 / (6 * d), -m1 / 3};
    D[0] = {-1 / (3 * d), s1 / (6 * d)};
    S[1] = {(s2 / d - m1) / (30 * d), (1 - t11) / (30 * d), (3 * s1 / d + 2 * m2) / 60};
    D[1] = {-s1 / (60 * d2), (6 * d * m1 - s2) / (60 * d2), -(9 + t11) / (60 * d)};
    S[2] = {(4 * d + 17 * s3 - 15 * d * t11) / (2520 * d3),
            (9 * s1 + 10 * d * m2 - 6 * t21) / (420 * d2),
            (6 * d * t12 - 100 * d * m1 + 53 * s2) / (2520 * d2),
            (15 - d * m3 - 2 * t11) / (630 * d)};
    D[2] = {(34 * d * m1 - 19 * s2) / (2520 * d3),
            (s3 + 2 * d * t11 - 85 * d) / (1260 * d3),
            (47 * s1 + 13 * t21 - 38 * d * m2) / (2520 * d2),
            (9 * d * m1 + d * t12 - 11 * s2) / (1260 * d2)};
    S[3] = {(62 * s4 - 94 * d * t21 + 66 * d2 * m2 + 81 * d * s1) / (45360 * d4),
            (-77 * t31 + 75 * d * t12 + 214 * s2 - 240 * d * m1) / (22680 * d3),
            (26 * d * t22 + 55 * s3 + 204 * d - 50 * d2 * m3 - 59 * d * t11) / (7560 * d3),
            (137 * d * m2 - d * t13 + 3 * s1 - 69 * t21) / (11340 * d2),
            (2 * d2 * m4 + 5 * d * t12 - 171 * d * m1 + 159 * s2) / (45360 * d2)};
    D[3] = {(60 * d * t11 - 61 * s3 - 247 * d) / (45360 * d4),
            (54 * d * s1 - s4 + 218 * d * t21 - 426 * d2 * m2) / (45360 * d4),
            (125 * d * m1 - 5 * t31 - 130 * s2 + 4 * d * t12) / (7560 * d3),
            (67 * s3 - 735 * d - 15 * d * t22 + 87 * d * t11 + 34 * d2 * m3) / (22680 * d3),
            (165 * s1 - d * t13 - 9 * t21 - 145 * d * m2) / (45360 * d2)};
    // clang-format on
  }

  // the moments for a step with these C and H; `order` 2, 4, 6, 8 or 10
  Vec3 moments(const Vec3& inverse, int order, double C, double H) const {
    double scale = 1.0, shift = 0.0;
    for (int n = 1; n < order / 2; ++n) {
      const auto row = static_cast<std::size_t>(n - 1);
      for (int k = 0; k <= n; ++k) {
        const double power = std::pow(C, n - k) * std::pow(H, k);
        scale += S[row][static_cast<std::size_t>(k)] * power;
        shift += D[row][static_cast<std::size_t>(k)] * power;
      }
    }
    return (inverse * scale + Vec3::Constant(shift)).cwiseInverse();
  }

  std::array<std::array<double, 5>, 4> S{}, D{};
};

class DiscreteMoserVeselov final : public Stepper {
 public:
  DiscreteMoserVeselov(const Model& model, int order)
      : model_(model), order_(order), corrections_(model.moments) {}

  void step(double t, double h, State& s) override {
    if (h == 0.0) return;
    const double C = 0.5 * h * h * s.y.squaredNorm();
    const double H = 0.5 * h * h * s.y.dot(angular_velocity(model_, s.y));
    const Vec3 I = corrections_.moments(model_.inverse_moments, order_, C, H);
    const Vec3 apart(I[1] - I[2], I[2] - I[0], I[0] - I[1]);
    const Vec3 c = solve(t, h, I, apart, 0.5 * h * s.y.cwiseQuotient(I));
    const double alpha = 1.0 + c.squaredNorm();
    s.q = normalized(s.q * Quat(1.0, c[0], c[1], c[2]));
    s.y += 4.0 / (h * alpha) * apart.cwiseProduct(products(c));
  }

 private:
  static Vec3 products(const Vec3& c) { return {c[1] * c[2], c[2] * c[0], c[0] * c[1]}; }

  // Newton's method for c = (1 + |c|^2) a + (I2 - I3)/I1 c2 c3 and so on; (1, c) is half the turn
  Vec3 solve(double t, double h, const Vec3& I, const Vec3& apart, const Vec3& a) {
    const Vec3 ratio = apart.cwiseQuotient(I);
    Vec3 c = a;
    double last = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
      const Vec3 residual = c - (1.0 + c.squaredNorm()) * a - ratio.cwiseProduct(products(c));
      Mat3 jacobian = Mat3::Identity() - 2.0 * a * c.transpose();
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        jacobian(i, j) -= ratio[i] * c[k];
        jacobian(i, k) -= ratio[i] * c[j];
      }
      const Vec3 change = jacobian.inverse() * residual;
      c -= change;
      ++evaluations_;
      const double size = change.norm();
      if (size <= 2.0 * std::numeric_limits<double>::epsilon() * (1.0 + c.norm())) return c;
      if (size >= last && size <= 1e-13 * (1.0 + c.norm())) return c;
      if (!std::isfinite(size)) break;
      last = size;
    }
    throw Error(
        Fault::check_failed,
        fmt::format("discrete Moser-Veselov has no solution at t = {} s with step {} s: its "
                    "step turns by asin(h |omega|), and h |omega| is {:.3g} there; take one "
                    "with less than 1, better 0.3",
                    t,
                    h,
                    2.0 * a.norm()));
  }

  static constexpr int kMostIterations = 50;
  Model model_;
  int order_;
  Corrections corrections_;
};

template <int Order>
std::unique_ptr<Stepper> make_of_order(const Model& model) {
  return std::make_unique<DiscreteMoserVeselov>(model, Order);
}

}  // namespace

std::unique_ptr<Stepper> make_dmv2(const Model& model, double) {
  return make_of_order<2>(model);
}
std::unique_ptr<Stepper> make_dmv4(const Model& model, double) {
  return make_of_order<4>(model);
}
std::unique_ptr<Stepper> make_dmv6(const Model& model, double) {
  return make_of_order<6>(model);
}
std::unique_ptr<Stepper> make_dmv8(const Model& model, double) {
  return make_of_order<8>(model);
}
std::unique_ptr<Stepper> make_dmv10(const Model& model, double) {
  return make_of_order<10>(model);
}

}  // namespace polhode
