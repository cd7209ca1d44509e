// SPDX-License-Identifier: MIT
#include "math/elliptic.h"

#include <cmath>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <gtest/gtest.h>

#include "base/units.h"
#include "support/residual.h"

namespace polhode {
namespace {

using test::expect_residual;
using test::worse;

// 1 - m, from almost nothing to 1
const double kComplements[] = {1e-300,
                               1e-100,
                               1e-20,
                               1e-12,
                               1e-6,
                               1e-3,
                               0.05,
                               0.2,
                               0.25,
                               0.3,
                               0.5,
                               0.7,
                               0.9,
                               0.99,
                               1.0 - 1e-6,
                               1.0 - 1e-12};

TEST(CarlsonRf, AgreesWithBoostAndCarlson) {
  // Carlson 1995, section 3: published values
  EXPECT_NEAR(carlson_rf(1, 2, 0), 1.3110287771461, 6e-14);
  EXPECT_NEAR(carlson_rf(0.5, 1, 0), 1.8540746773014, 6e-14);
  EXPECT_NEAR(carlson_rf(2, 3, 4), 0.58408284167715, 2e-15);
  double worst = 0.0;
  for (const double x : {0.0, 1e-200, 1e-10, 0.3, 1.0, 50.0}) {
    for (const double y : {1e-8, 0.7, 1.0, 1e6}) {
      const double expected = boost::math::ellint_rf(x, y, 1.0);
      worst = worse(worst, std::abs(carlson_rf(x, y, 1.0) / expected - 1.0));
    }
  }
  expect_residual("RF against Boost", worst, 2e-15);
}

TEST(EllipticK, PublishedAndBoost) {
  // Abramowitz and Stegun, table 17.1
  EXPECT_NEAR(elliptic_k(1.0), 1.570796326794897, 1e-15);
  EXPECT_NEAR(elliptic_k(0.5), 1.854074677301372, 1e-15);
  EXPECT_NEAR(elliptic_k(0.1), 2.578092113348173, 1e-15);
  EXPECT_TRUE(std::isinf(elliptic_k(0.0)));
  // K -> ln(4/sqrt(m1)) where m1 cannot be got from m any more
  EXPECT_NEAR(elliptic_k(1e-100), std::log(4e50), 1e-13);
  double worst = 0.0;
  for (const double m1 : {0.01, 0.2, 0.5, 0.8, 0.99})
    worst =
        worse(worst, std::abs(elliptic_k(m1) / boost::math::ellint_1(std::sqrt(1.0 - m1)) - 1.0));
  expect_residual("K against Boost", worst, 2e-15);
}

// of all three kinds, with p from almost nothing to far above 1
TEST(EllipticCel, LimitsAndBoost) {
  for (const double root : {1e-8, 1e-4, 0.3, 1.0, 7.0, 1e5, 1e9}) {
    const double circular = 0.5 * kPi * (2.0 + 3.0 / root) / (1.0 + root);
    const double found = elliptic_cel(1.0, root * root, 2.0, 3.0);
    expect_residual("circular", std::abs(found / circular - 1.0), 2e-15);
  }
  for (const double m : {0.01, 0.4, 0.9, 0.999}) {
    const double k = std::sqrt(m), m1 = 1.0 - m;
    expect_residual("first", std::abs(elliptic_cel(m1, 1, 1, 1) / elliptic_k(m1) - 1.0), 2e-15);
    const double second = boost::math::ellint_2(k);
    expect_residual("second", std::abs(elliptic_cel(m1, 1, 1, m1) / second - 1.0), 4e-15);
    for (const double p : {1e-3, 0.2, 0.99, 3.0, 40.0}) {
      const double third = boost::math::ellint_3(k, 1.0 - p);
      expect_residual("third", std::abs(elliptic_cel(m1, p, 1, 1) / third - 1.0), 1e-13);
    }
  }
}

TEST(EllipticF, AllQuadrantsAgainstBoost) {
  double worst = 0.0;
  for (const double m : {0.0, 0.1, 0.5, 0.9, 0.999}) {
    for (int i = -31; i <= 31; ++i) {
      const double phi = 0.1 * i;
      // in wider arithmetic, for the modulus k = sqrt(m) loses digits near 1
      const long double k = std::sqrt(static_cast<long double>(m));
      const double expected =
          static_cast<double>(boost::math::ellint_1(k, static_cast<long double>(phi)));
      const double found = elliptic_f(3.0 * std::sin(phi), 3.0 * std::cos(phi), m, 1.0 - m);
      worst = worse(worst, std::abs(found - expected) / (1.0 + std::abs(expected)));
    }
  }
  expect_residual("F against Boost", worst, 3e-15);
  EXPECT_EQ(elliptic_f(0.0, 0.0, 0.5, 0.5), 0.0);
  EXPECT_NEAR(elliptic_f(0.0, -1.0, 0.5, 0.5), 2.0 * elliptic_k(0.5), 1e-15);
  EXPECT_NEAR(elliptic_f(-1.0, 0.0, 0.5, 0.5), -elliptic_k(0.5), 1e-15);
}

TEST(JacobiFunctions, DetestB5ToRoundOff) {
  // sn, cn, dn(20 | .51), the published end of DETEST B5
  const SnCnDn f = EllipticParameter(0.51, 0.49).at(20.0);
  EXPECT_NEAR(f.sn, -0.93965707987292039619, 1e-14);
  EXPECT_NEAR(f.cn, -0.34211777540007490653, 1e-14);
  EXPECT_NEAR(f.dn, 0.74141265961999530078, 1e-14);
}

TEST(JacobiFunctions, AgreeWithBoostForEveryParameter) {
  double worst = 0.0;
  for (const double m : {0.0, 1e-14, 1e-6, 0.1, 0.5, 0.7, 0.83, 0.87, 0.95, 0.999, 0.999999}) {
    const EllipticParameter parameter(m, 1.0 - m);
    for (int i = -60; i <= 60; ++i) {
      const double v = 0.17 * i;
      double cn = 0.0, dn = 0.0;
      // Boost loses digits near m = 1; in wider arithmetic it does not
      long double cn_wide = 0.0L, dn_wide = 0.0L;
      const long double k = std::sqrt(static_cast<long double>(m));
      const double sn = static_cast<double>(
          boost::math::jacobi_elliptic(k, static_cast<long double>(v), &cn_wide, &dn_wide));
      cn = static_cast<double>(cn_wide);
      dn = static_cast<double>(dn_wide);
      const SnCnDn f = parameter.at(v);
      worst = worse(worst, std::hypot(f.sn - sn, f.cn - cn, f.dn - dn));
    }
  }
  expect_residual("sn, cn, dn against Boost", worst, 1e-14);
}

TEST(JacobiFunctions, KeepTheirIdentitiesForEveryParameter) {
  double worst = 0.0;
  for (const double m1 : kComplements) {
    const double m = 1.0 - m1;
    const EllipticParameter parameter(m, m1);
    const double K = parameter.quarter_period();
    for (int i = 0; i <= 400; ++i) {
      const double v = K * (0.0137 * i - 2.1);
      const SnCnDn f = parameter.at(v);
      worst = worse(worst, std::abs(f.sn * f.sn + f.cn * f.cn - 1.0));
      worst = worse(worst, std::abs(f.dn * f.dn - (f.cn * f.cn + m1 * f.sn * f.sn)));
      // half a period on
      const SnCnDn g = parameter.at(v + 2.0 * K);
      const double round_off = 4e-16 * (std::abs(v) + 2.0 * K);
      EXPECT_NEAR(g.sn, -f.sn, 2e-15 + round_off);
      EXPECT_NEAR(g.dn, f.dn, 2e-15 + round_off);
    }
  }
  expect_residual("sn^2 + cn^2 = 1, dn^2 = cn^2 + m1 sn^2", worst, 3e-15);
}

TEST(JacobiFunctions, LimitsAreCircularAndHyperbolic) {
  const EllipticParameter circular(0.0, 1.0), hyperbolic(1.0, 0.0);
  for (const double v : {-5.0, -0.3, 0.0, 1.0, 30.0}) {
    EXPECT_NEAR(circular.at(v).sn, std::sin(v), 4e-15);
    EXPECT_NEAR(circular.at(v).cn, std::cos(v), 4e-15);
    EXPECT_NEAR(circular.at(v).dn, 1.0, 1e-15);
    EXPECT_NEAR(hyperbolic.at(v).sn, std::tanh(v), 1e-15);
    EXPECT_NEAR(hyperbolic.at(v).cn, 1.0 / std::cosh(v), 1e-15);
    EXPECT_NEAR(hyperbolic.at(v).dn, 1.0 / std::cosh(v), 1e-15);
  }
}

// at v = K - d, dn = sqrt(m1) nd(d): nothing of a tiny m1 is lost
TEST(JacobiFunctions, QuarterPeriodOfATinyComplement) {
  for (const double m1 : {1e-12, 1e-30, 1e-200}) {
    const EllipticParameter parameter(1.0 - m1, m1);
    const SnCnDn f = parameter.at(parameter.quarter_period());
    EXPECT_NEAR(f.dn / std::sqrt(m1), 1.0, 1e-12);
    EXPECT_LE(std::abs(f.cn), 1e-12 * std::sqrt(m1));
    EXPECT_NEAR(f.sn, 1.0, 1e-15);
  }
}

}  // namespace
}  // namespace polhode
