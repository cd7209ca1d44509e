// SPDX-License-Identifier: MIT
#include "math/theta.h"

#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "base/units.h"
#include "support/residual.h"

namespace polhode {
namespace {

using test::expect_residual;
using test::worse;
using Wide = std::complex<long double>;

// The defining series (DLMF 20.2) in wide arithmetic, always in the nome itself.
Wide theta(int which, const Wide& z, long double q) {
  const Wide i(0.0L, 1.0L);
  Wide sum = 0.0L;
  for (int n = -60; n <= 60; ++n) {
    const long double k = which <= 2 ? n + 0.5L : n;
    const long double sign = (which == 1 || which == 4) && n % 2 != 0 ? -1.0L : 1.0L;
    sum += sign * std::exp(2.0L * i * k * z + k * k * std::log(q));
  }
  return which == 1 ? -i * sum : sum;
}

Wide wide_direction(const Wide& c) {
  return c / std::abs(c);
}

// on both sides of the change of series, and near both ends
const double kNomeComplements[] = {1.0 - 1e-8, 0.7, 0.25, 0.2, 0.15, 0.05, 1e-4, 1e-8};

struct Wrapped {
  EllipticParameter parameter;
  long double per_v, q;
  explicit Wrapped(double m1)
      : parameter(1.0 - m1, m1),
        per_v(0.5L * 3.14159265358979323846L / parameter.quarter_period()),
        q(std::exp(-2.0L * per_v * parameter.other_quarter_period())) {}
};

TEST(ThetaPhase, HasTheDirectionOfTheta4) {
  double worst = 0.0;
  for (const double m1 : kNomeComplements) {
    const Wrapped w(m1);
    const double K = w.parameter.quarter_period();
    for (const double part : {0.0, 0.1, 0.6, 0.99}) {
      const double eta = part * w.parameter.other_quarter_period();
      const ThetaPhase phase(w.parameter, eta);
      for (int i = -30; i <= 30; i += 3) {
        const double v = 0.11 * i * K;
        const ThetaValue found = phase.at(v);
        const Wide expected = wide_direction(theta(4, {w.per_v * v, w.per_v * eta}, w.q * w.q));
        const Wide direction = wide_direction({found.re, found.im});
        worst = worse(worst, static_cast<double>(std::abs(direction - expected)));
      }
      const long double h = 1e-5L;
      const long double rate = (std::arg(theta(4, {w.per_v * h, w.per_v * eta}, w.q * w.q)) -
                                std::arg(theta(4, {-w.per_v * h, w.per_v * eta}, w.q * w.q))) /
                               (2.0L * h);
      EXPECT_NEAR(phase.rate(), static_cast<double>(rate), 1e-9);
    }
  }
  expect_residual("theta_4 of nome q^2, direction", worst, 1e-15);
}

TEST(ThetaPair, HasTheQuotientOfTheta1AndTheta2) {
  double worst = 0.0, worst_slope = 0.0;
  for (const double m1 : kNomeComplements) {
    const Wrapped w(m1);
    const double K = w.parameter.quarter_period(), K1 = w.parameter.other_quarter_period();
    for (const double part : {-0.9, -0.3, 0.0, 0.2, 0.95}) {
      const double eta1 = part * K1, eta2 = (0.1 - 0.7 * part) * K1;
      const ThetaPair pair(w.parameter, eta1, eta2);
      const auto first = [&](long double v) {
        return theta(1, {w.per_v * v, -w.per_v * eta1}, w.q);
      };
      const auto second = [&](long double v) {
        return theta(2, {w.per_v * v, -w.per_v * eta2}, w.q);
      };
      ThetaValue a, b;
      const double v0 = 0.4 * K;
      pair.at(v0, a, b);
      const Wide scale_a = Wide(a.re, a.im) / first(v0), scale_b = Wide(b.re, b.im) / second(v0);
      for (int i = -30; i <= 30; i += 3) {
        // one positive factor of v, one constant each
        const double v = 0.11 * i * K;
        pair.at(v, a, b);
        const Wide want_a = scale_a * first(v), want_b = scale_b * second(v);
        const long double factor =
            std::sqrt((std::norm(want_a) + std::norm(want_b)) /
                      (a.re * a.re + a.im * a.im + b.re * b.re + b.im * b.im));
        const long double size = std::sqrt(std::norm(want_a) + std::norm(want_b));
        worst = worse(worst, double(std::abs(factor * Wide(a.re, a.im) - want_a) / size));
        worst = worse(worst, double(std::abs(factor * Wide(b.re, b.im) - want_b) / size));

        // conj(a) b' - b conj(a') does not see the slope of the common factor
        const long double h = 1e-4L;
        const Wide rate_a = scale_a * (first(v + h) - first(v - h)) / (2.0L * h);
        const Wide rate_b = scale_b * (second(v + h) - second(v - h)) / (2.0L * h);
        const Wide want = std::conj(want_a) * rate_b - want_b * std::conj(rate_a);
        const Wide found = std::conj(Wide(a.re, a.im)) * Wide(b.slope_re, b.slope_im) -
                           Wide(b.re, b.im) * std::conj(Wide(a.slope_re, a.slope_im));
        worst_slope =
            worse(worst_slope, double(std::abs(factor * factor * found - want) / (size * size)));
      }

      const long double h = 1e-5L;
      const long double quarter = K;
      const long double rate1 = std::arg(first(quarter + h) / first(quarter - h)) / (2.0L * h);
      EXPECT_NEAR(pair.rate_first(), static_cast<double>(rate1), 1e-8);
      const long double rate2 = std::arg(second(h) / second(-h)) / (2.0L * h);
      EXPECT_NEAR(pair.rate_second(), static_cast<double>(rate2), 1e-8);
    }
  }
  expect_residual("theta_1 and theta_2, quotient", worst, 2e-15);
  expect_residual("their slopes", worst_slope, 1e-8);
}

// without gravity to speak of, or on a separatrix: the series end after one term
TEST(ThetaPair, LimitsAreElementary) {
  const ThetaPair circular(EllipticParameter(0.0, 1.0), 0.7, -0.2);
  const ThetaPair hyperbolic(EllipticParameter(1.0, 0.0), 0.7, -0.2);
  ThetaValue a, b;
  for (const double v : {-2.0, 0.0, 0.5, 40.0}) {
    circular.at(v, a, b);
    EXPECT_NEAR(a.re, std::sin(v), 1e-14);
    EXPECT_NEAR(a.im, -std::tanh(0.7) * std::cos(v), 1e-14);
    EXPECT_NEAR(b.im, std::tanh(-0.2) * std::sin(v), 1e-14);
    hyperbolic.at(v, a, b);
    const double cosh = std::exp(-std::abs(v)) * std::cosh(v);
    const double sinh = std::exp(-std::abs(v)) * std::sinh(v);
    EXPECT_NEAR(a.re, std::tan(0.7) * cosh, 1e-15);
    EXPECT_NEAR(a.im, sinh, 1e-15);
    EXPECT_NEAR(b.re, std::exp(-std::abs(v)), 1e-15);
    EXPECT_EQ(b.im, 0.0);
  }
}

}  // namespace
}  // namespace polhode
