// SPDX-License-Identifier: MIT
#include "model/body_model.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "support/expect_error.h"
#include "support/tops.h"

namespace polhode {
namespace {

using test::expect_input_error;
using Shape = TopKind::Shape;

BodySpec with_moments(const Vec3& moments) {
  BodySpec spec;
  spec.moments = moments;
  return spec;
}

BodySpec with_tensor(const Mat3& tensor) {
  BodySpec spec;
  spec.tensor = tensor;
  return spec;
}

SolidSpec sphere(double mass, double radius, const Vec3& at) {
  SolidSpec s;
  s.kind = "sphere";
  s.mass = mass;
  s.radius = radius;
  s.at = at;
  return s;
}

BodyModel free_model(const BodySpec& spec) {
  return make_model(spec, false, Vec3::Zero());
}

TEST(MassPropertiesOfSpec, DumbbellOfParts) {
  BodySpec spec;
  spec.parts = {sphere(1.0, 0.1, {0, 0, 0.5}), sphere(3.0, 0.2, {0, 0, -0.5})};
  const MassProperties body = mass_properties(spec);
  EXPECT_DOUBLE_EQ(body.mass, 4.0);
  EXPECT_NEAR(body.center.z(), -0.25, 1e-16);
  const double along = 0.4 * (1.0 * 0.01 + 3.0 * 0.04);
  // reduced mass 3/4 kg at a distance of 1 m
  EXPECT_NEAR(body.tensor(0, 0), along + 0.75, 1e-15);
  EXPECT_NEAR(body.tensor(2, 2), along, 1e-16);
}

TEST(MassPropertiesOfSpec, Points) {
  BodySpec spec;
  spec.points = {{1.0, {1, 0, 0}}, {1.0, {-1, 0, 0}}, {2.0, {0, 0.5, 0}}};
  const MassProperties body = mass_properties(spec);
  EXPECT_LE((body.center - Vec3(0, 0.25, 0)).norm(), 1e-16);
  EXPECT_LE((body.tensor.diagonal() - Vec3(0.25, 2.0, 2.25)).norm(), 1e-15);
}

TEST(MassPropertiesOfSpec, MomentsAboutThePivotAreCarriedToTheCenter) {
  BodySpec spec = with_moments({1.0, 1.0, 0.2});
  spec.about = "pivot";
  spec.mass = 2.0;
  spec.center_of_mass = Vec3(0, 0, 0.6);
  spec.pivot = Vec3(0, 0, 0.1);
  const MassProperties body = mass_properties(spec);
  EXPECT_LE((body.tensor.diagonal() - Vec3(0.5, 0.5, 0.2)).norm(), 1e-15);
  // and back: held at the pivot the moments are those given, to the last bit
  const BodyModel held = make_model(spec, true, {0, 0, -9.81});
  EXPECT_EQ(held.moments, Vec3(1.0, 1.0, 0.2));
  // thrown, the body turns about its centre
  EXPECT_LE((free_model(spec).moments - Vec3(0.5, 0.5, 0.2)).norm(), 1e-15);
}

TEST(MakeModel, PivotAddsTheParallelAxisTerm) {
  BodySpec spec = with_moments({0.5, 0.5, 0.2});
  spec.mass = 2.0;
  spec.pivot = Vec3(0, 0, -0.5);
  const BodyModel model = make_model(spec, true, {0, 0, -10.0});
  EXPECT_LE((model.moments - Vec3(1.0, 1.0, 0.2)).norm(), 1e-15);
  EXPECT_LE((model.chi_P - Vec3(0, 0, 10.0)).norm(), 1e-14);
  EXPECT_EQ(model.reference_B(), spec.pivot);
  EXPECT_EQ(model.up_S, Vec3::UnitZ());
}

TEST(MakeModel, UpIsAgainstGravityWhereverItPoints) {
  const BodyModel model = make_model(with_moments({1, 1, 1}), false, {3.0, 0.0, 4.0});
  EXPECT_LE((model.up_S - Vec3(-0.6, 0.0, -0.8)).norm(), 1e-16);
  EXPECT_EQ(model.chi_P, Vec3(Vec3::Zero()));  // gravity does not turn a free body
}

TEST(PrincipalFrame, DiagonalisesAndIsRightHanded) {
  const Mat3 turn = exp_rotation({0.7, -1.2, 0.4}).toRotationMatrix();
  const std::vector<Vec3> cases = {
      {0.9, 0.6, 1.0}, {1.0, 0.6, 0.9}, {0.6, 0.6, 1.0}, {1.0, 0.6, 1.0}, {2e-9, 1.9e-9, 1e-9}};
  for (const Vec3& moments : cases) {
    const Mat3 tensor = turn * moments.asDiagonal() * turn.transpose();
    const BodyModel model = free_model(with_tensor(0.5 * (tensor + tensor.transpose())));
    const Mat3 diagonal = model.R_BP.transpose() * tensor * model.R_BP;
    EXPECT_LE((diagonal - Mat3(model.moments.asDiagonal())).norm(), 2e-15 * moments.norm());
    EXPECT_NEAR(model.R_BP.determinant(), 1.0, 1e-14);
    EXPECT_LE((model.R_BP.transpose() * model.R_BP - Mat3::Identity()).norm(), 2e-15);
    EXPECT_NEAR(model.moments.sum(), moments.sum(), 1e-15 * moments.sum());
  }
}

TEST(PrincipalFrame, AxesThatArePrincipalAlreadyAreKept) {
  EXPECT_EQ(free_model(with_moments({1.0, 0.9, 0.6})).R_BP, Mat3(Mat3::Identity()));
  EXPECT_EQ(free_model(with_tensor(Vec3(1.0, 0.9, 0.6).asDiagonal())).moments, Vec3(1, 0.9, 0.6));
}

// a frame that the next bit of the tensor turns round would turn the drawn axes too
TEST(PrincipalFrame, RoundOffDoesNotTurnIt) {
  const std::vector<Vec3> cases = {
      {1, 1, 0.5}, {0.5, 1, 1}, {1, 0.5, 1}, {1, 1, 1.9}, {1, 1, 1}, {0.6, 0.8, 1}, {1, 0.6, 0.8}};
  const Mat3 turns[] = {Mat3::Identity(),
                        exp_rotation({0.1, -0.2, 0.05}).toRotationMatrix(),
                        exp_rotation({0, kPi / 4, 0}).toRotationMatrix()};
  for (const Vec3& moments : cases) {
    for (const Mat3& turn : turns) {
      const Mat3 turned = turn * moments.asDiagonal() * turn.transpose();
      const Mat3 tensor = 0.5 * (turned + turned.transpose());
      const BodyModel model = free_model(with_tensor(tensor));
      EXPECT_NEAR(model.R_BP.determinant(), 1.0, 1e-14);
      for (int k = 0; k < 27; ++k) {
        Mat3 noise = Mat3::Zero();
        noise(0, 1) = noise(1, 0) = (k % 3 - 1) * 1e-15;
        noise(0, 2) = noise(2, 0) = (k / 3 % 3 - 1) * 1e-15;
        noise(1, 2) = noise(2, 1) = (k / 9 - 1) * 1e-15;
        noise(0, 0) = noise(1, 2);
        const BodyModel other = free_model(with_tensor(tensor + noise));
        EXPECT_LE((other.R_BP - model.R_BP).norm(), 3e-14) << moments.transpose() << " k " << k;
      }
    }
  }
}

TEST(PrincipalFrame, SymmetricBodiesOfPartsKeepTheirAxes) {
  // spokes in a circle: symmetric about z but for round-off
  BodySpec spec;
  for (int i = 0; i < 7; ++i) {
    const double angle = 2.0 * kPi * i / 7;
    spec.parts.push_back(
        sphere(0.1, 0.02, {3.0 * std::cos(angle), 3.0 * std::sin(angle), 0.3 + 1e-3}));
  }
  const BodyModel model = free_model(spec);
  EXPECT_EQ(model.kind.name(), "symmetric oblate");
  EXPECT_EQ(model.kind.axis, 2);
  EXPECT_LE((model.R_BP - Mat3::Identity()).norm(), 1e-14);

  // tilted by 10 degrees about y: each axis stays next to its own, and y where it was
  const Mat3 tilt = exp_rotation({0, kPi / 18, 0}).toRotationMatrix();
  for (SolidSpec& part : spec.parts)
    part.at = tilt * part.at;
  EXPECT_LE((free_model(spec).R_BP - tilt).norm(), 1e-14);
}

TEST(Classify, EveryKind) {
  const auto name = [](double a, double b, double c) {
    return classify({a, b, c}).name();
  };
  EXPECT_EQ(name(1, 1, 1), "spherical");
  EXPECT_EQ(name(1, 1, 0.5), "symmetric prolate");
  EXPECT_EQ(name(1, 1, 1.5), "symmetric oblate");
  EXPECT_EQ(name(1, 1, 2), "symmetric oblate planar");
  EXPECT_EQ(name(1, 0, 1), "symmetric prolate rotator");
  EXPECT_EQ(name(0.6, 0.8, 1), "asymmetric");
  EXPECT_EQ(name(1, 2, 3), "asymmetric planar");
  EXPECT_EQ(classify({1, 1, 2}).axis, 2);
  EXPECT_EQ(classify({2, 1, 1}).axis, 0);
  EXPECT_EQ(classify({1, 2, 1}).axis, 1);
  EXPECT_TRUE(classify({1, 2, 1}).symmetric());
  EXPECT_FALSE(classify({1, 2, 3}).symmetric());
  EXPECT_FALSE(classify({1, 1, 1}).symmetric());
}

TEST(Classify, EqualMeansWithinTheToleranceAtAnyScale) {
  for (const double scale : {1e-12, 1.0, 1e12}) {
    EXPECT_EQ(classify(scale * Vec3(1, 1 + 5e-13, 1.5)).shape, Shape::oblate);
    EXPECT_EQ(classify(scale * Vec3(1, 1 + 5e-12, 1.5)).shape, Shape::asymmetric);
    EXPECT_EQ(classify(scale * Vec3(1, 1, 1 + 5e-13)).shape, Shape::spherical);
    EXPECT_TRUE(classify(scale * Vec3(1, 1, 1e-13)).rotator);
    EXPECT_FALSE(classify(scale * Vec3(1, 1, 1e-11)).rotator);
  }
}

TEST(Rotator, HasNoInverseOfTheMissingMoment) {
  BodySpec spec;
  SolidSpec rod;
  rod.kind = "rod";
  rod.mass = 3.0;
  rod.length = 2.0;
  spec.solid = rod;
  const BodyModel model = free_model(spec);
  EXPECT_TRUE(model.kind.rotator);
  EXPECT_EQ(model.moments, Vec3(1, 1, 0));
  EXPECT_EQ(model.inverse_moments, Vec3(1, 1, 0));

  // two points lie on a line too, whichever its direction
  BodySpec points;
  points.points = {{1.0, {1, 2, 2}}, {2.0, {-1, -2, -2}}};
  const BodyModel dumbbell = free_model(points);
  EXPECT_TRUE(dumbbell.kind.rotator);
  EXPECT_EQ(dumbbell.moments.minCoeff(), 0.0);
  EXPECT_NEAR((dumbbell.R_BP.col(dumbbell.kind.axis).cross(Vec3(1, 2, 2) / 3)).norm(), 0.0, 1e-14);
}

TEST(ImpossibleMoments, AreRefusedInEveryOrderUnlessMathematical) {
  for (const Vec3& moments : {Vec3(1, 1, 3), Vec3(1, 3, 1), Vec3(3, 1, 1)}) {
    EXPECT_NE(impossible_moments(moments), "");
    BodySpec spec = with_moments(moments);
    expect_input_error([&] { free_model(spec); }, "body.moments", "body.mathematical = true");
    spec.mathematical = true;
    EXPECT_EQ(free_model(spec).moments, moments);
  }
  // planar bodies are just possible
  EXPECT_EQ(impossible_moments({1, 2, 3}), "");
  EXPECT_TRUE(free_model(with_moments({1, 2, 3})).kind.planar);
  expect_input_error(
      [] { free_model(with_tensor(Vec3(1, 1, 3).asDiagonal())); }, "body.tensor", "no body has");
}

TEST(BodyErrors, NameTheKey) {
  expect_input_error([] { free_model(with_moments({0, 0, 0})); }, "body.moments", "all zero");
  expect_input_error(
      [] {
        free_model(with_moments({1e-108, 1.5e-108, 2.3e-108}));
      },
      "body.moments",
      "are too small; the largest must be at least 1e-60");
  expect_input_error([] { free_model(with_moments({1, 1, -1})); }, "body.moments", "negative");
  expect_input_error([] { free_model(with_moments({0, 0, 1})); }, "body.moments", "no attitude");

  Mat3 skew = Mat3::Identity();
  skew(0, 1) = 0.1;
  expect_input_error([&] { free_model(with_tensor(skew)); }, "body.tensor", "symmetric");

  BodySpec about = with_moments({1, 1, 1});
  about.about = "pivot";
  about.center_of_mass = Vec3(0, 0, 2);
  expect_input_error([&] { free_model(about); }, "body.moments", "too small for the mass");

  BodySpec solid;
  solid.solid = sphere(1.0, 0.5, Vec3::Zero());
  solid.mass = 2.0;
  expect_input_error([&] { free_model(solid); }, "body.mass", "only with moments or tensor");
  solid.mass.reset();
  solid.center_of_mass = Vec3::Zero();
  expect_input_error(
      [&] { free_model(solid); }, "body.center_of_mass", "only with moments or tensor");
  solid.center_of_mass.reset();
  solid.about = "pivot";
  expect_input_error([&] { free_model(solid); }, "body.about", "only with moments or tensor");

  BodySpec point;
  point.points = {{1.0, {1, 0, 0}}};
  expect_input_error([&] { free_model(point); }, "body.points", "in one point");

  BodySpec parts;
  parts.parts = {sphere(1, 0.5, Vec3::Zero()), sphere(1, 0.5, Vec3::Zero())};
  parts.parts[1].kind = "cube";
  expect_input_error([&] { free_model(parts); }, "body.parts[1].kind", "unknown solid");
}

// a vanishing moment says that all mass is on a line, so the other two are equal
TEST(BodyErrors, UnequalMomentsBesideAZeroAreRefusedEvenWhenMathematical) {
  BodySpec spec = with_moments({1, 2, 0});
  spec.mathematical = true;
  expect_input_error([&] { free_model(spec); }, "body.moments", "other two");
}

// a centre of mass on the pivot but for round-off is not a heavy top
TEST(MakeModel, BalancedBodyOnAPivotFeelsNoGravity) {
  BodySpec spec;
  spec.parts = {sphere(0.1, 0.1, {0.1 + 0.2, 0, 0}), sphere(0.1, 0.1, {-0.3, 0, 0})};
  const BodyModel model = make_model(spec, true, {0, 0, -9.81});
  EXPECT_EQ(model.chi_P, Vec3(Vec3::Zero()));
}

TEST(RightHandSide, KeepsEnergyVerticalMomentumAndGamma) {
  const test::Problem p = test::heavy_asymmetric();
  const Vec3 w = angular_velocity(p.model, p.start.y);
  const Vec3 gamma = up_in_body(p.model, p.start.q);
  const Vec3 y_rate = momentum_rate(p.model, p.start.y, gamma);
  const Vec3 gamma_rate = gamma.cross(w);
  EXPECT_NEAR(w.dot(y_rate) + p.model.chi_P.dot(gamma_rate), 0.0, 1e-15);
  EXPECT_NEAR(gamma.dot(y_rate) + gamma_rate.dot(p.start.y), 0.0, 1e-15);
  EXPECT_GT(y_rate.norm(), 0.1);

  // dgamma/dt = gamma x w is what the attitude's rate says too
  const double h = 1e-6;
  const Vec3 later = up_in_body(p.model, p.start.q * exp_rotation(h * w));
  EXPECT_LE(((later - gamma) / h - gamma_rate).norm(), 1e-5);
}

// a pendulum falls: the torque of gravity pulls the centre of mass down
TEST(RightHandSide, GravityPullsDown) {
  const BodyModel model = test::heavy_body({1, 1, 0.5}, {0, 0, 1});
  const State start{exp_rotation({0.3, 0, 0}), Vec3::Zero()};  // tilted about x by 0.3
  const Vec3 rate = momentum_rate(model, start.y, up_in_body(model, start.q));
  EXPECT_NEAR(rate.x(), std::sin(0.3), 1e-15);  // tilts further
  EXPECT_NEAR(energy(model, start), std::cos(0.3), 1e-15);
}

}  // namespace
}  // namespace polhode
