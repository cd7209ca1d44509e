// SPDX-License-Identifier: MIT
// The lecture notes' mechanics, equation by equation, on motions that the program finds: time
// derivatives of sums over particles against what the notes say of them (docs/theory.md).
#include <gtest/gtest.h>

#include "model/rigid_body.h"
#include "motion/simulate.h"
#include "support/motions.h"
#include "support/particles.h"
#include "support/tops.h"

namespace polhode {
namespace {

using namespace test;
using namespace testing;

// d/dt by seven central points: the error is h^6 f''''''' / 140, below 1e-12 for the rates here.
template <class Function>
auto derivative(const Function& f, double t) {
  constexpr double h = 5e-3;
  using Value = decltype(f(t));
  const Value near = f(t + h) - f(t - h);
  const Value middle = f(t + 2 * h) - f(t - 2 * h);
  const Value far = f(t + 3 * h) - f(t - 3 * h);
  return Value((45.0 * near - 9.0 * middle + far) / (60.0 * h));
}

// Twelve random masses as a scene would give them, and the motion they make.
struct Cloud {
  BodySpec body;
  MotionSpec spec;
  Motion motion;

  // where particle p is, m
  Vec3 place(const PointSpec& p, double t) const {
    const Sample s = motion.at(t);
    return s.reference_S + s.q_SB * (p.at - motion.model().reference_B());
  }
  Vec3 velocity(const PointSpec& p, double t) const {
    return derivative([&](double time) { return place(p, time); }, t);
  }
};

Cloud cloud(const std::string& hold, std::uint64_t seed) {
  BodySpec body;
  for (const PointMass& p : random_particles(seed).points)
    body.points.push_back({p.mass, p.at});
  if (hold == "pivot") body.pivot = Vec3(0.3, -0.2, 0.4);
  MotionSpec spec;
  spec.hold = hold;
  spec.gravity = Vec3(0.3, 0.1, -2.0);
  spec.duration = 2.0;
  spec.attitude.zxz = Vec3(0.4, 0.9, -0.7);
  spec.spin.body = Vec3(0.8, -0.5, 1.3);
  if (hold == "free") spec.velocity = Vec3(0.5, 0.2, -0.4);
  const BodyModel model = make_model(body, spec);
  return {body, spec, simulate(model, spec, {}, 1e-11).motion};
}

constexpr double kTimes[] = {0.1, 0.73, 1.9};

// Residuals of derivatives, measured: 1.1e-12 for one particle, 3.4e-12 for sums over all.
constexpr double kDerivative = 3e-12;
constexpr double kSummed = 1e-11;

// A free symmetric top with its axis tilted from L, and the closed form's quantities.
struct FreeTop {
  Motion motion = moving(prolate_body(), wobbling());
  Vec3 moments = motion.model().moments;  // I1 = I2, I3 in B as well: an ellipsoid
  Vec3 L = motion.at(0.0).L_S;
  double cos_theta = axis(0.0).dot(L) / L.norm();

  Vec3 axis(double t) const { return motion.at(t).q_SB * Vec3::UnitZ(); }
  Vec3 momentum_B(double t) const { return motion.at(t).q_SB.conjugate() * motion.at(t).L_S; }
};

TEST(Notes, Eq02VelocitiesOfAMovingBody) {
  for (const std::string hold : {"free", "pivot"}) {
    const Cloud c = cloud(hold, 2);
    for (const double t : kTimes) {
      const Sample s = c.motion.at(t);
      const Vec3 V = derivative([&](double time) { return c.motion.at(time).reference_S; }, t);
      for (const PointSpec& p : c.body.points) {
        const Vec3 r = s.q_SB * (p.at - c.motion.model().reference_B());
        EXPECT_LE((c.velocity(p, t) - point_velocity(V, s.w_S, r)).norm(), kDerivative);
      }
    }
  }
}

TEST(Notes, Eq07KineticAndPotentialEnergyOfTheLagrangian) {
  for (const std::string hold : {"free", "pivot"}) {
    const Cloud c = cloud(hold, 3);
    for (const double t : kTimes) {
      double energy = 0.0;
      for (const PointSpec& p : c.body.points) {
        energy += 0.5 * p.m * c.velocity(p, t).squaredNorm();
        energy -= p.m * c.spec.gravity->dot(c.place(p, t));
      }
      EXPECT_NEAR(c.motion.at(t).energy, energy, kSummed);
    }
  }
}

TEST(Notes, Eq13AngularMomentumOfAMovingBody) {
  const Cloud c = cloud("pivot", 4);
  for (const double t : kTimes) {
    Vec3 L = Vec3::Zero();
    for (const PointSpec& p : c.body.points)
      L += p.m * c.place(p, t).cross(c.velocity(p, t));
    EXPECT_LE((c.motion.at(t).L_S - L).norm(), kSummed);
  }
}

TEST(Notes, Eq15ASphericalTopTurnsUniformly) {
  const Motion motion = moving(ellipsoid_body(Vec3::Constant(0.2)), wobbling());
  for (const double t : kTimes) {
    EXPECT_LE((motion.at(t).w_S - motion.at(0.0).w_S).norm(), 1e-15);
    const Vec3 L = motion.model().moments[0] * motion.at(t).w_S;
    EXPECT_LE((motion.at(t).L_S - L).norm(), 1e-16);
  }
}

TEST(Notes, Eq16ComponentsAlongAndAcrossTheAxis) {
  const FreeTop top;
  const double sin_theta = std::sqrt(1.0 - top.cos_theta * top.cos_theta);
  for (const double t : kTimes) {
    const Vec3 w = top.motion.at(t).w_S;
    const Vec3 e3 = top.axis(t);
    EXPECT_NEAR(w.dot(e3), top.L.norm() / top.moments[2] * top.cos_theta, 4e-15);
    EXPECT_NEAR(w.cross(e3).norm(), top.L.norm() / top.moments[0] * sin_theta, 4e-15);
    // e3, L and Omega lie in one plane, always
    EXPECT_NEAR(e3.dot(top.L.normalized().cross(w)), 0.0, 4e-15);
  }
}

TEST(Notes, Eq17TheAxisPrecessesAboutL) {
  const FreeTop top;
  for (const double t : kTimes) {
    const Quat turn = exp_rotation(t / top.moments[0] * top.L);
    EXPECT_LE((top.axis(t) - turn * top.axis(0.0)).norm(), 4e-15);
  }
}

TEST(Notes, Eq19TotalMomentumFollowsTheExternalForce) {
  const Cloud c = cloud("free", 5);
  const double mass = c.motion.model().body.mass;
  const auto P = [&](double t) {  // eq. 18
    return derivative(
        [&](double time) {
          Vec3 sum = Vec3::Zero();
          for (const PointSpec& p : c.body.points)
            sum += p.m * c.place(p, time);
          return sum;
        },
        t);
  };
  for (const double t : kTimes)
    EXPECT_LE((derivative(P, t) - mass * *c.spec.gravity).norm(), 6e-10);
}

TEST(Notes, Eq21MomentumChangesByTheTorque) {
  const Cloud c = cloud("pivot", 6);
  for (const double t : kTimes) {
    Vec3 torque = Vec3::Zero();
    for (const PointSpec& p : c.body.points)
      torque += c.place(p, t).cross(p.m * *c.spec.gravity);
    const Vec3 rate = derivative([&](double time) { return c.motion.at(time).L_S; }, t);
    EXPECT_GE(torque.norm(), 0.1);
    EXPECT_LE((rate - torque).norm(), kSummed);
  }
}

TEST(Notes, Eq24MomentumIsTheGradientOfTheKineticEnergy) {
  const Particles body = random_centered_particles(8);
  const MassProperties mass = of_points(body.points);
  const auto T = [&](const Vec3& w) {
    return kinetic_energy(mass, Vec3::Zero(), body.V, w).total();
  };
  for (int i = 0; i < 3; ++i) {
    // a quadratic: the central difference of step one is exact
    const double slope = 0.5 * (T(body.Omega + Vec3::Unit(i)) - T(body.Omega - Vec3::Unit(i)));
    EXPECT_NEAR(slope, angular_momentum(mass.tensor, body.Omega)[i], 4e-15);
  }
}

TEST(Notes, Eq25TorqueIsTheSlopeOfThePotential) {
  const Cloud c = cloud("pivot", 9);
  const Sample s = c.motion.at(0.5);
  const auto U = [&](const Vec3& turn) {
    const Vec3 arm = c.motion.model().body.center - c.body.pivot;
    return -c.motion.model().body.mass * c.spec.gravity->dot(exp_rotation(turn) * (s.q_SB * arm));
  };
  const Vec3 rate = derivative([&](double t) { return c.motion.at(t).L_S; }, 0.5);
  for (int i = 0; i < 3; ++i) {
    const double slope = derivative([&](double x) { return U(x * Vec3::Unit(i)); }, 0.0);
    EXPECT_NEAR(-slope, rate[i], kSummed);
  }
}

TEST(Erratum, Row03VelocitiesAloneAreNotTheState) {
  // the same V and Omega at another attitude lead elsewhere: a heavy body tilted or upright
  MotionSpec upright = spinning_on_pivot();
  upright.attitude.zxz = Vec3::Zero();
  upright.spin = {};
  MotionSpec tilted = upright;
  tilted.attitude.zxz = Vec3(0.0, 0.5, 0.0);
  EXPECT_LE(moving(cone_body(), upright).at(0.3).w_S.norm(), 1e-12);
  EXPECT_GE(moving(cone_body(), tilted).at(0.3).w_S.norm(), 1.0);
}

TEST(Erratum, Row18OnlyWithoutTorqueIsOmegaConstant) {
  // moments equal about the pivot, centre of mass off it: spherical and yet not uniform
  const Problem free{free_body({1, 1, 1}), {Quat::Identity(), {0.3, 0.4, 1.0}}};
  const Problem heavy{heavy_body({1, 1, 1}, {0.2, 0.0, 0.5}), free.start};
  MotionSpec spec;
  spec.duration = 2.0;
  spec.spin.momentum_body = free.start.y;
  const Motion still = simulate(free.model, spec, {}, 1e-10).motion;
  spec.hold = "pivot";
  const Motion turned = simulate(heavy.model, spec, {}, 1e-10).motion;
  EXPECT_LE((still.at(1.0).w_S - still.at(0.0).w_S).norm(), 1e-15);
  EXPECT_GE((turned.at(1.0).w_S - turned.at(0.0).w_S).norm(), 0.1);
}

TEST(Erratum, Row19ARotatorTurnsAboutAnAxisAcrossItsLine) {
  BodySpec body;
  body.points = {{1.0, Vec3(0, 0, 0.5)}, {2.0, Vec3(0, 0, -0.3)}};
  MotionSpec spec;
  spec.duration = 2.0;
  spec.attitude.zxz = Vec3(0.2, 0.6, 0.0);
  spec.spin.body = Vec3(0.7, -1.1, 0.0);
  const Motion motion = moving(body, spec);
  for (const double t : kTimes) {
    const Sample s = motion.at(t);
    EXPECT_LE(std::abs(s.w_S.dot(s.q_SB * Vec3::UnitZ())), 1e-15);
    EXPECT_LE((s.w_S - motion.at(0.0).w_S).norm(), 1e-15);
  }
}

TEST(Erratum, Row20TheSecondComponentVanishesForOneInstant) {
  const FreeTop top;
  const double beta = (1.0 / top.moments[2] - 1.0 / top.moments[0]) * top.momentum_B(0.0).z();
  // from the time at which L2 = 0 in body axes, a quarter turn later all of it is along axis 2
  const Vec3 y = top.momentum_B(0.0);
  const double across = std::hypot(y.x(), y.y());
  double t0 = std::atan2(y.y(), y.x()) / beta;
  const double turn = kPi / std::abs(beta);
  while (t0 < 0.0)
    t0 += turn;
  EXPECT_NEAR(top.momentum_B(t0).y(), 0.0, 1e-16);
  EXPECT_NEAR(std::abs(top.momentum_B(t0 + 0.5 * turn).y()), across, 1e-16);
}

TEST(Erratum, Row21TheSpinAboutTheOwnAxis) {
  const FreeTop top;
  const Vec3 y = top.momentum_B(0.0);
  const double psi_rate =
      top.L.norm() * top.cos_theta * (1.0 / top.moments[2] - 1.0 / top.moments[0]);
  const double omega_3 = y.z() / top.moments[2];
  for (const double t : kTimes) {
    // seen from the body L goes round backwards at the rate of psi, which is not Omega_3
    const auto turned = [&](double rate) {
      return exp_rotation({0, 0, -rate * t}) * y;
    };
    EXPECT_LE((top.momentum_B(t) - turned(psi_rate)).norm(), 1e-16);
    EXPECT_GE((top.momentum_B(t) - turned(omega_3)).norm(), 1e-4);
  }
  EXPECT_GE(std::abs(psi_rate - omega_3), 0.1);
}

TEST(Erratum, Row23ThePotentialDependsOnTheAttitude) {
  const Problem top = gni_heavy_top();
  State turned = top.start;
  turned.y = Vec3::Zero();
  State other = turned;
  turned.q = Quat::Identity();
  other.q = exp_rotation({1.2, 0.0, 0.0});
  // the pivot has not moved: U(R) alone would be the same
  EXPECT_NEAR(energy(top.model, turned) - energy(top.model, other), 1.0 - std::cos(1.2), 1e-15);
}

TEST(Erratum, Row26EulersEquationsInBodyAxes) {
  const Cloud c = cloud("pivot", 10);
  const auto L_B = [&](double t) {
    return Vec3(c.motion.at(t).q_SB.conjugate() * c.motion.at(t).L_S);
  };
  const Vec3 arm_B = c.motion.model().body.center - c.body.pivot;
  for (const double t : kTimes) {
    const Sample s = c.motion.at(t);
    const Vec3 weight_B = s.q_SB.conjugate() * (c.motion.model().body.mass * *c.spec.gravity);
    const Vec3 torque = arm_B.cross(weight_B);
    const Vec3 printed = derivative(L_B, t) - torque;
    EXPECT_LE((printed + s.w_B.cross(L_B(t))).norm(), kSummed);
    EXPECT_GE(printed.norm(), 0.1);
  }
}

TEST(Erratum, Row28AConstantTensorInSpaceDropsTheGyroscopicTerm) {
  // in space axes L = I Omega holds with I(t) = Q I Q^T, not with the tensor of the start
  const Cloud c = cloud("free", 11);
  const MassProperties& body = c.motion.model().body;
  const Mat3 Q0 = c.motion.at(0.0).q_SB.toRotationMatrix();
  const Mat3 frozen = Q0 * body.tensor * Q0.transpose();
  for (const double t : kTimes) {
    const Sample s = c.motion.at(t);
    const Mat3 Q = s.q_SB.toRotationMatrix();
    EXPECT_LE((Q * body.tensor * Q.transpose() * s.w_S - s.L_S).norm(), 1e-14);
    if (t > 0.5) {
      EXPECT_GE((frozen * s.w_S - s.L_S).norm(), 0.1);
    }
    // no torque, and yet the printed dL/dt = 0 with constant body moments fails by Omega x L
    const auto L_B = [&](double time) {
      return Vec3(c.motion.at(time).q_SB.conjugate() * c.motion.at(time).L_S);
    };
    EXPECT_LE((derivative(L_B, t) + s.w_B.cross(L_B(t))).norm(), kSummed);
    EXPECT_GE(derivative(L_B, t).norm(), 0.1);
  }
}

}  // namespace
}  // namespace polhode
