// SPDX-License-Identifier: MIT
// The accuracy that an answer claims, held against an independent integration with more digits.
#include "motion/refinement.h"

#include <cstdlib>
#include <random>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include "motion/simulate.h"
#include "support/expect_error.h"
#include "support/residual.h"
#include "support/taylor_oracle.h"
#include "support/tops.h"

namespace polhode {
namespace {

using namespace test;

// 113 bits of mantissa
using Quad = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<113, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

struct Case {
  BodyModel model;
  MotionSpec spec;
  std::string name;
};

MotionSpec spinning(const Vec3& w_B, const Quat& attitude, double duration) {
  MotionSpec spec;
  spec.hold = "pivot";
  spec.duration = duration;
  spec.spin.body = w_B;
  spec.attitude.quaternion =
      Eigen::Vector4d(attitude.w(), attitude.x(), attitude.y(), attitude.z());
  return spec;
}

// A body without symmetry under gravity, fast or slow, short or long; every third starts next to
// the axis of its middle moment or to the upright equilibrium.
Case random_case(int number) {
  std::mt19937_64 random(static_cast<std::uint64_t>(number) + 20260101U);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto direction = [&] {
    return Vec3(between(-1, 1), between(-1, 1), between(-1, 1)).normalized();
  };
  const Vec3 second(between(0.1, 1), between(0.1, 1), between(0.1, 1));
  const Vec3 moments = Vec3::Constant(second.sum()) - second;
  Vec3 chi = std::pow(10.0, between(-2.0, 1.0)) * direction();
  Vec3 w = between(0.2, 3.0) * direction();
  Quat attitude = exp_rotation(3.0 * between(0, 1) * direction());
  if (number % 3 == 1) {
    int order[] = {0, 1, 2};
    std::sort(order, order + 3, [&](int i, int j) { return moments[i] < moments[j]; });
    w = between(0.5, 3.0) * Vec3::Unit(order[1]) +
        std::pow(10.0, between(-9.0, -1.0)) * direction();
    chi *= 1e-3;
  } else if (number % 3 == 2) {
    attitude = turn_between(chi, Vec3::UnitZ());  // upright, nearly at rest
    w = std::pow(10.0, between(-9.0, -1.0)) * direction();
  }
  const double duration = std::pow(10.0, between(0.5, 2.3));
  return {
      heavy_body(moments, chi), spinning(w, attitude, duration), fmt::format("case {}", number)};
}

enum class Outcome { answered, doubted, refused };

// The largest error of the motion at times that no run was compared at.
template <class Real>
double error_of(const Case& one, const Motion& motion) {
  BasicTaylorOracle<Real> oracle(one.model, start_state(one.model, one.spec));
  double worst = 0.0;
  constexpr int kLookedAt = 100;
  for (int i = 1; i <= kLookedAt; ++i) {
    const double t = one.spec.duration * i / kLookedAt;
    worst = worse(worst, rotation_angle_between(motion.state_at(t).q, oracle.at(t).q));
  }
  return worst;
}

// An answer is right, or doubted, or refused.
template <class Real>
Outcome check(const Case& one, double accuracy, const NumericsSpec& numerics = {}) {
  SCOPED_TRACE(fmt::format("{} at {:g} rad", one.name, accuracy));
  try {
    const Simulation found = simulate(one.model, one.spec, numerics, accuracy);
    if (!found.report.reliability.doubts.empty()) return Outcome::doubted;
    const double error = error_of<Real>(one, found.motion);
    expect_residual(fmt::format("{} by {} (claims {:.1e}, rounding {:.1e})",
                                one.name,
                                found.report.method,
                                found.report.error_estimate_rad.value_or(0.0),
                                found.report.conditioning->effect),
                    error,
                    accuracy);
    return Outcome::answered;
  } catch (const Error& error) {
    EXPECT_EQ(error.place().key, "numerics.accuracy") << error.message();
    return Outcome::refused;
  }
}

template <class Real>
void check_many(int cases, double accuracy) {
  int outcomes[3] = {};
  for (int i = 0; i < cases; ++i)
    ++outcomes[static_cast<int>(check<Real>(random_case(i), accuracy))];
  fmt::print("    {:g} rad: {} answered, {} doubted, {} refused\n",
             accuracy,
             outcomes[0],
             outcomes[1],
             outcomes[2]);
  EXPECT_GT(outcomes[0], cases / 2);
}

// the slow tier sets POLHODE_THOROUGHLY
TEST(Trust, AnswersAboutChaosAreRightOrDoubted) {
  if (std::getenv("POLHODE_THOROUGHLY") == nullptr) {
    check_many<long double>(60, 1e-4);
    check_many<long double>(30, 1e-8);
    return;
  }
  check_many<Quad>(500, 1e-4);
  check_many<long double>(2000, 1e-7);
  check_many<long double>(2000, 1e-2);
}

// two runs of order 4 that agree by chance: 1.4e-5 rad apart, both wrong by 6.9e-4
TEST(Trust, IsNotWonByChance) {
  const BodySpec body = [] {
    BodySpec spec;
    spec.moments = Vec3(0.9, 1.2, 1.6);
    spec.mass = 0.9;
    spec.about = "pivot";
    spec.center_of_mass = Vec3(0.1, 0.2, 0.15);
    return spec;
  }();
  const MotionSpec spec = spinning({0.4, -1.3, 1.0}, Quat(0.6, -0.3, 0.5, 0.2).normalized(), 120.0);
  const Case one{make_model(body, spec), spec, "two runs that agree"};
  constexpr double kAccuracy = 9.08e-5;
  check<long double>(one, kAccuracy);
  NumericsSpec numerics;
  for (const char* method :
       {"kick_chin4", "rk4", "gauss4", "cf4", "dopri5", "dop853", "taylor16"}) {
    numerics.method = method;
    check<long double>(one, kAccuracy, numerics);
  }
}

// A body that is shaken for six seconds and then comes to rest for hours: what is wrong while it
// tumbles would be forgotten before the second of times that are spread over all of it.
TEST(Refinement, LooksWhereABodyTumbles) {
  SolidSpec box;
  box.kind = "box";
  box.size = Vec3(0.06, 0.10, 0.16);
  box.mass = 0.4;
  BodySpec body;
  body.solid = box;
  body.pivot = Vec3(0.01, 0.02, 0.07);
  MotionSpec spec;
  spec.hold = "pivot";
  spec.attitude.zxz = Vec3(288.6, 80.2, 160.0) * kPi / 180.0;
  LoadSpec damping, shaking, spring;
  damping.kind = "damping";
  damping.of = "spin";
  damping.c = 0.00585;
  shaking.kind = "constant";
  shaking.space = Vec3(0.34, 0.17, 0.11);
  shaking.rate = 10.09;
  shaking.until = 6.0;
  spring.kind = "spring";
  spring.k = 6.6;
  spring.at = Vec3(0.03, 0.05, -0.08);
  spring.to = Vec3(0.1, 0.0, -0.18);
  spec.torque = {damping, shaking, spring};
  const auto moved = [&](double duration, double accuracy) {
    spec.duration = duration;
    return simulate(make_model(body, spec), spec, NumericsSpec{}, accuracy);
  };
  const Motion right = moved(30.0, 1e-7).motion;
  const Simulation found = moved(10'000.0, 1e-3);
  EXPECT_TRUE(found.report.reliability.doubts.empty());
  for (double t = 0.0; t <= 30.0; t += 0.5) {
    const Quat q = found.motion.at(t).q_SB;
    EXPECT_LT(rotation_angle_between(q, right.at(t).q_SB), 1e-3) << t;
  }
  // a tolerance that is given is held against a finer one in the same way
  NumericsSpec given;
  given.method = "dop853";
  given.tolerance = 1e-7;
  const Simulation coarse = simulate(make_model(body, spec), spec, given, 1e-3);
  EXPECT_FALSE(coarse.report.reliability.doubts.empty());
}

}  // namespace
}  // namespace polhode
