// SPDX-License-Identifier: MIT
// The lecture notes' statics of mass, equation by equation, on random bodies of twelve particles:
// what is printed right holds to round-off, what is printed wrong fails by far (docs/theory.md).
#include <gtest/gtest.h>

#include "base/units.h"
#include "math/so3.h"
#include "model/body_model.h"
#include "model/rigid_body.h"
#include "support/expect_error.h"
#include "support/particles.h"

namespace polhode {
namespace {

using namespace test;

// Twelve terms of order one: the worst residual measured over all seeds is 5.8e-15.
constexpr double kRoundOff = 1e-14;
// The same for tensors of moved origins, which are larger; measured 1.7e-14.
constexpr double kRoundOffMoved = 3e-14;
// A wrong formula is wrong by order one; the least such residual over all seeds is 0.037.
constexpr double kWrong = 0.02;
constexpr int kSeeds = 20;

template <class Check>
void for_random_bodies(const Check& check) {
  for (int seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    check(random_particles(seed));
  }
}

template <class Check>
void for_centered_bodies(const Check& check) {
  for (int seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    check(random_centered_particles(seed));
  }
}

MassProperties properties(const Particles& body) {
  return of_points(body.points);
}

double asymmetry(const Mat3& m) {
  return (m - m.transpose()).norm();
}

TEST(Notes, Eq01ASmallDisplacementIsAShiftAndATurn) {
  // the remainder is of second order in the turn: halving it divides the remainder by four
  const Vec3 phi(0.3, -0.8, 0.5);
  const Vec3 r(0.7, 0.2, -1.1);
  const auto remainder = [&](double h) {
    return (exp_rotation(h * phi) * r - r - point_velocity(Vec3::Zero(), h * phi, r)).norm();
  };
  EXPECT_NEAR(remainder(1e-3) / remainder(5e-4), 4.0, 1e-3);
}

TEST(Notes, Eq02VelocityOfAPoint) {
  for_random_bodies([](const Particles& body) {
    for (const PointMass& p : body.points) {
      // two points keep their distance: r.v is zero for the difference of any two
      const Vec3 r = p.at - body.points[0].at;
      const Vec3 v = point_velocity(body.V, body.Omega, p.at) -
                     point_velocity(body.V, body.Omega, body.points[0].at);
      EXPECT_LE(std::abs(r.dot(v)), kRoundOff);
      EXPECT_LE((v - body.Omega.cross(r)).norm(), kRoundOff);
    }
  });
}

TEST(Notes, Eq03KineticEnergyIsTheSumOverParticles) {
  for_random_bodies([](const Particles& body) {
    const KineticEnergy split = kinetic_energy(properties(body), Vec3::Zero(), body.V, body.Omega);
    EXPECT_NEAR(split.total(), body.energy(), kRoundOff);
  });
}

TEST(Notes, Eq04EnergySplitsAboutTheCenterOfMass) {
  for_centered_bodies([](const Particles& body) {
    const KineticEnergy split = kinetic_energy(properties(body), Vec3::Zero(), body.V, body.Omega);
    EXPECT_NEAR(split.coupling, 0.0, kRoundOff);
    EXPECT_NEAR(split.translation + split.rotation, body.energy(), kRoundOff);
  });
}

TEST(Notes, Eq05RotationalEnergyByTheTensor) {
  for_random_bodies([](const Particles& body) {
    const double sum = body.sum([&](const PointMass& p) {
      const Vec3& w = body.Omega;
      return 0.5 * p.mass * (p.at.squaredNorm() * w.squaredNorm() - std::pow(w.dot(p.at), 2));
    });
    const Mat3 tensor = inertia_tensor(body.points, Vec3::Zero());
    EXPECT_NEAR(0.5 * body.Omega.dot(tensor * body.Omega), sum, kRoundOff);
  });
}

TEST(Notes, Eq06InertiaTensorAboutAnyOrigin) {
  for_random_bodies([](const Particles& body) {
    EXPECT_LE((inertia_tensor(body.points, Vec3::Zero()) - body.tensor()).norm(), kRoundOff);
    const Mat3 about = inertia_tensor(body.points, body.V);
    EXPECT_LE((about - tensor_about(properties(body), body.V)).norm(), kRoundOff);
  });
}

TEST(Notes, Eq09AContinuousBodyIsTheLimitOfParticles) {
  // an n^3 lattice of a box differs from the integral by exactly 1/n^2 of it
  SolidSpec box;
  box.kind = "box";
  box.size = Vec3(0.3, 0.5, 0.7);
  box.mass = 1.3;
  const Mat3 integral = mass_properties([&] {
                          BodySpec spec;
                          spec.solid = box;
                          return spec;
                        }())
                            .tensor;
  for (const int n : {4, 8}) {
    std::vector<PointMass> points;
    for (int i = 0; i < n * n * n; ++i) {
      const Vec3 cell(i % n, i / n % n, i / n / n);
      const Vec3 unit = (cell + Vec3::Constant(0.5)) / n - Vec3::Constant(0.5);
      points.push_back({1.3 / (n * n * n), unit.cwiseProduct(*box.size)});
    }
    const Mat3 lattice = inertia_tensor(points, Vec3::Zero());
    EXPECT_LE((lattice - (1.0 - 1.0 / (n * n)) * integral).norm(), kRoundOff);
  }
}

TEST(Notes, Eq12ParallelAxesFromTheCenterOfMass) {
  for_centered_bodies([](const Particles& body) {
    const Vec3 a = 2.0 * body.V;
    const Mat3 expected = inertia_tensor(body.points, a);
    EXPECT_LE((body.tensor() + steiner_tensor(body.mass(), a) - expected).norm(), kRoundOffMoved);
    EXPECT_LE((tensor_about(properties(body), a) - expected).norm(), kRoundOffMoved);
  });
}

TEST(Notes, Eq14AngularMomentumIsTheTensorTimesOmega) {
  for_random_bodies([](const Particles& body) {
    // eq. 13: the definition; the notes take V = 0
    const Vec3 L = body.sum(
        [&](const PointMass& p) { return Vec3(p.mass * p.at.cross(body.Omega.cross(p.at))); });
    EXPECT_LE((angular_momentum(body.tensor(), body.Omega) - L).norm(), kRoundOff);
  });
}

TEST(Notes, Eq15OnlyASphericalTopHasLAlongEveryOmega) {
  // masses at the corners of a cube: L = I Omega for every Omega; not so for a random body
  Particles cube = random_particles(1);
  cube.points.clear();
  for (int i = 0; i < 8; ++i)
    cube.points.push_back({0.5, Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)});
  EXPECT_LE((angular_momentum(cube.tensor(), cube.Omega) - 8.0 * cube.Omega).norm(), kRoundOff);
  for_centered_bodies([](const Particles& body) {
    const Vec3 L = angular_momentum(body.tensor(), body.Omega);
    EXPECT_GE(L.cross(body.Omega).norm(), 0.1 * kWrong);  // least: 0.0042
  });
}

TEST(Notes, Eq22TorqueAboutAnotherOrigin) {
  Dice dice(22);
  for (int i = 0; i < kSeeds; ++i) {
    const Vec3 a = dice.vector();
    Vec3 before = Vec3::Zero(), after = Vec3::Zero(), force = Vec3::Zero();
    for (int k = 0; k < 12; ++k) {
      const Vec3 r = dice.vector();
      const Vec3 f = dice.vector();
      before += r.cross(f);
      after += (r - a).cross(f);
      force += f;
    }
    EXPECT_LE((before - after - a.cross(force)).norm(), kRoundOff);
  }
}

TEST(Erratum, Row01ThreeAnglesBetweenAxesDoNotFixTheAttitude) {
  // a rotation and its inverse have the same angles between corresponding axes
  const Mat3 R = exp_rotation({0.4, 0.5, -0.6}).toRotationMatrix();
  const Mat3 inverse = R.transpose();
  EXPECT_EQ(Vec3(R.diagonal()), Vec3(inverse.diagonal()));
  EXPECT_GE((R - inverse).norm(), 1.0);
}

TEST(Erratum, Row02ARotatorHasFiveDegreesOfFreedom) {
  // a turn about the line moves no particle, so three rates are one too many
  const Vec3 line(0.0, 0.0, 1.0);
  for (const double z : {-0.7, 0.1, 0.9})
    EXPECT_EQ(point_velocity(Vec3::Zero(), line, z * line), Vec3(Vec3::Zero()));
  EXPECT_TRUE(classify({1.0, 1.0, 0.0}).rotator);
}

TEST(Erratum, Row05TheMixedTermOfVSquaredHasAFactorTwo) {
  for_random_bodies([](const Particles& body) {
    double right = 0.0, printed = 0.0;
    for (const PointMass& p : body.points) {
      const Vec3 turn = body.Omega.cross(p.at);
      const double square = point_velocity(body.V, body.Omega, p.at).squaredNorm();
      const double others = body.V.squaredNorm() + turn.squaredNorm();
      right = std::max(right, std::abs(others + 2.0 * body.V.dot(turn) - square));
      printed = std::max(printed, std::abs(others + body.V.dot(turn) - square));
    }
    EXPECT_LE(right, kRoundOff);
    EXPECT_GE(printed, kWrong);
  });
  // and about the centre of mass neither form contributes to the sum
  for_centered_bodies([](const Particles& body) {
    EXPECT_NEAR(
        body.sum([&](const PointMass& p) { return p.mass * body.V.dot(body.Omega.cross(p.at)); }),
        0.0,
        kRoundOff);
  });
}

TEST(Erratum, Row06RotationalEnergyLacksAHalf) {
  for_centered_bodies([](const Particles& body) {
    const double printed_rotation = body.sum([&](const PointMass& p) {
      return p.mass *
             (body.Omega.squaredNorm() * p.at.squaredNorm() - std::pow(body.Omega.dot(p.at), 2));
    });
    const double translation = 0.5 * body.mass() * body.V.squaredNorm();
    EXPECT_NEAR(translation + 0.5 * printed_rotation, body.energy(), kRoundOff);
    // printed: too large by T_rot itself
    EXPECT_GE(translation + printed_rotation - body.energy(), kWrong);
    EXPECT_NEAR(translation + printed_rotation - body.energy(), 0.5 * printed_rotation, kRoundOff);
  });
}

TEST(Erratum, Row08ThePrintedMatrixIsNotSymmetric) {
  for_random_bodies([](const Particles& body) {
    const Mat3 right = inertia_tensor(body.points, Vec3::Zero());
    Mat3 printed = right;
    printed(1, 2) = right(0, 2);
    EXPECT_LE(asymmetry(right), kRoundOff);
    EXPECT_LE((right - body.tensor()).norm(), kRoundOff);
    EXPECT_GE(asymmetry(printed), kWrong);
  });
}

TEST(Erratum, Row09TheDiagonalFormHasSquares) {
  for_random_bodies([](const Particles& body) {
    BodySpec spec;
    for (const PointMass& p : body.points)
      spec.points.push_back({p.mass, p.at});
    const BodyModel model = make_model(spec, false, Vec3::Zero());
    const Vec3 w_P = model.R_BP.transpose() * body.Omega;
    const double form = body.Omega.dot(model.body.tensor * body.Omega);
    EXPECT_NEAR(model.moments.dot(w_P.cwiseProduct(w_P)), form, kRoundOff);
    EXPECT_GE(std::abs(model.moments.dot(w_P) - form), kWrong);
  });
}

TEST(Erratum, Row10TheTriangleInequalityIsATheoremInThreeForms) {
  for_random_bodies([](const Particles& body) {
    const Mat3 tensor = body.tensor();
    for (int i = 0; i < 3; ++i) {
      const double excess = tensor.trace() - 2.0 * tensor(i, i);
      const double sum = body.sum([&](const PointMass& p) { return p.mass * p.at[i] * p.at[i]; });
      EXPECT_NEAR(excess, 2.0 * sum, kRoundOff);
    }
  });
  // (1,1,3) is no body, whatever the order; equality is a flat one
  EXPECT_NE(impossible_moments({1, 1, 3}), "");
  EXPECT_NE(impossible_moments({1, 3, 1}), "");
  EXPECT_NE(impossible_moments({3, 1, 1}), "");  // passes the one printed form
  EXPECT_EQ(impossible_moments({1, 2, 3}), "");
  EXPECT_TRUE(classify({1, 2, 3}).planar);
  BodySpec spec;
  spec.moments = Vec3(1, 1, 3);
  expect_input_error([&] { make_model(spec, false, Vec3::Zero()); }, "body.moments", "no body");
}

TEST(Erratum, Row11AsymmetricMeansAllThreeDistinct) {
  // (1, 2, 1) passes "I1 != I2 != I3" and is a symmetric top
  EXPECT_TRUE(classify({1, 2, 1}).symmetric());
  EXPECT_FALSE(classify({1, 2, 1.5}).symmetric());
}

TEST(Erratum, Row12MomentsOfAFlatBody) {
  for_random_bodies([](Particles body) {
    for (PointMass& p : body.points)
      p.at.z() = 0.0;
    const Mat3 tensor = inertia_tensor(body.points, Vec3::Zero());
    const auto moment = [&](int axis) {
      return body.sum([&](const PointMass& p) { return p.mass * p.at[axis] * p.at[axis]; });
    };
    EXPECT_NEAR(tensor(0, 0), moment(1), kRoundOff);
    EXPECT_NEAR(tensor(1, 1), moment(0), kRoundOff);
    EXPECT_NEAR(tensor(2, 2), tensor(0, 0) + tensor(1, 1), kRoundOff);
  });
}

// `order` copies of two masses, turned by 360/order degrees each about z.
Mat3 tensor_with_axis_of_order(int order) {
  std::vector<PointMass> points;
  for (int i = 0; i < order; ++i) {
    const Quat turn = exp_rotation({0, 0, 2.0 * kPi * i / order});
    points.push_back({1.0, turn * Vec3(0.9, 0.2, 0.6)});
    points.push_back({0.7, turn * Vec3(0.1, -0.5, -0.3)});
  }
  return inertia_tensor(points, Vec3::Zero());
}

TEST(Erratum, Row13TwoEqualMomentsNeedAnAxisOfOrderThree) {
  for (const int order : {3, 4, 5, 6}) {
    const Mat3 tensor = tensor_with_axis_of_order(order);
    EXPECT_NEAR(tensor(0, 0), tensor(1, 1), kRoundOff);
    EXPECT_NEAR(tensor(0, 1), 0.0, kRoundOff);
    EXPECT_GE(tensor(2, 2), 1.0);  // and I3 is not zero
  }
  const Mat3 second = tensor_with_axis_of_order(2);
  EXPECT_GE(std::abs(second(0, 0) - second(1, 1)), 1.0);

  // a box has three axes of order two and three moments; a cylinder has I1 = I2 and I3 > 0
  EXPECT_EQ(classify({8.08, 6.83, 1.42}).shape, TopKind::Shape::asymmetric);
}

TEST(Erratum, Row14ARotatorHasNoMomentBecauseItsMassesLieOnTheAxis) {
  BodySpec spec;
  spec.points = {{1.0, Vec3(0, 0, 0.4)}, {2.0, Vec3(0, 0, -0.1)}, {0.5, Vec3(0, 0, 0.9)}};
  const BodyModel model = make_model(spec, false, Vec3::Zero());
  EXPECT_TRUE(model.kind.rotator);
  EXPECT_EQ(model.body.tensor(2, 2), 0.0);
  EXPECT_EQ(model.inverse_moments.minCoeff(), 0.0);  // 1/I3 is never formed
  // a mass off the line gives the axis a moment: rotation about it had a meaning all along
  spec.points.push_back({1.0, Vec3(0.1, 0, 0)});
  EXPECT_FALSE(make_model(spec, false, Vec3::Zero()).kind.rotator);
}

TEST(Erratum, Row15TheTensorAboutAMovedOrigin) {
  for_random_bodies([](const Particles& body) {
    const Vec3 a = 2.0 * body.Omega;
    const Mat3 expected = inertia_tensor(body.points, a);
    const Vec3 S = body.first_moment();
    const Mat3 right = tensor_with_origin_moved(body.tensor(), body.mass(), S, a);
    const Mat3 printed = body.tensor() + 2.0 * (S.dot(a) * Mat3::Identity() - S * a.transpose()) +
                         steiner_tensor(body.mass(), a);
    EXPECT_LE((right - expected).norm(), kRoundOffMoved);
    EXPECT_LE(asymmetry(right), kRoundOffMoved);
    EXPECT_GE((printed - expected).norm(), 0.1);
    EXPECT_GE(asymmetry(printed), kWrong);
  });
}

TEST(Erratum, Row16TheCenterOfMassIsTheLeastInTheSemidefiniteOrder) {
  for_centered_bodies([](const Particles& body) {
    const Vec3 a = body.V;
    const Mat3 difference = inertia_tensor(body.points, a) - body.tensor();
    const Vec3 along = difference * a;
    EXPECT_LE(along.norm(), kRoundOff);  // nothing is added about the line of a itself
    EXPECT_GE(body.Omega.dot(difference * body.Omega), kWrong * kWrong);
    EXPECT_GE(a.norm(), kWrong);
  });
}

TEST(Erratum, Row17ThePrintedOrderOfIndicesGivesMinusL) {
  for_random_bodies([](const Particles& body) {
    // eps_{mns} eps^{sdg} r^n A_d B_g is r x (A x B)
    const Vec3 printed = body.sum(
        [&](const PointMass& p) { return Vec3(p.mass * p.at.cross(p.at.cross(body.Omega))); });
    const Vec3 L = angular_momentum(body.tensor(), body.Omega);
    EXPECT_LE((printed + L).norm(), kRoundOff);
    EXPECT_GE((printed - L).norm(), kWrong);
  });
}

TEST(Erratum, Row24NotTheVelocitiesVanishButMVCrossV) {
  for_centered_bodies([](Particles body) {
    body.V = Vec3::Zero();  // the rest frame of the centre of mass
    double fastest = 0.0;
    for (const PointMass& p : body.points)
      fastest = std::max(fastest, body.velocity(p).norm());
    EXPECT_GE(fastest, 0.1);
    const Vec3 sum = body.sum([&](const PointMass& p) {
      return Vec3(p.mass * body.velocity(p).cross(body.velocity(p)));
    });
    EXPECT_LE(sum.norm(), kRoundOff);
  });
}

TEST(Erratum, Row22CentralForcesAreWhatLeavesLAlone) {
  // f_ij = -f_ji alone leaves a torque; only forces along the line of the pair cancel it
  Dice dice(7);
  for (int i = 0; i < kSeeds; ++i) {
    const Vec3 r1 = dice.vector(), r2 = dice.vector(), f = dice.vector();
    const Vec3 central = f.norm() * (r1 - r2);
    EXPECT_LE((r1.cross(central) - r2.cross(central)).norm(), kRoundOff);
    EXPECT_GE((r1.cross(f) - r2.cross(f)).norm(), kWrong);
  }
}

TEST(Erratum, Row25TorqueDependsOnTheOriginUnlessTheForcesCancel) {
  Dice dice(25);
  for (int i = 0; i < kSeeds; ++i) {
    const Vec3 r1 = dice.vector(), r2 = dice.vector(), f = dice.vector(), a = dice.vector();
    const auto torque = [&](const Vec3& f1, const Vec3& f2, const Vec3& origin) {
      return Vec3((r1 - origin).cross(f1) + (r2 - origin).cross(f2));
    };
    // a couple: the same about every origin
    EXPECT_LE((torque(f, -f, Vec3::Zero()) - torque(f, -f, a)).norm(), kRoundOff);
    // a force: it changes by a x F, no more and no less
    const Vec3 change = torque(f, 0.5 * f, Vec3::Zero()) - torque(f, 0.5 * f, a);
    EXPECT_LE((change - a.cross(1.5 * f)).norm(), kRoundOff);
    EXPECT_GE(change.norm(), kWrong);
  }
}

TEST(Erratum, Row27TheSignOfTheVirtualWork) {
  Dice dice(27);
  for (int i = 0; i < kSeeds; ++i) {
    double work = 0.0, right = 0.0, printed = 0.0;
    const Vec3 turn = dice.vector();
    for (int k = 0; k < 12; ++k) {
      const Vec3 r = dice.vector(), f = dice.vector();
      work += -f.dot(turn.cross(r));
      right += -turn.dot(r.cross(f));
      printed += -turn.dot(f.cross(r));
    }
    EXPECT_NEAR(right, work, kRoundOff);
    EXPECT_NEAR(printed, -work, kRoundOff);
    EXPECT_GE(std::abs(printed - work), kWrong);
  }
}

}  // namespace
}  // namespace polhode
