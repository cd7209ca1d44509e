// SPDX-License-Identifier: MIT
// Torques and forces at the edges: orders in time, starts almost at rest, arms of round-off, lines
// of mass.
#include <cmath>

#include <gtest/gtest.h>

#include "math/so3.h"
#include "motion/simulate.h"
#include "motion/stepper_table.h"
#include "support/expect_error.h"
#include "support/loads.h"

namespace polhode {
namespace {

using test::body_with;
using test::expect_input_error;
using test::load;
using test::solved;
using test::spun;

// the stages of an adaptive method see the torque at their own times: its order shows in equal
// steps
TEST(Torque, OrderOfDopri5IsKeptInTime) {
  MotionSpec spec = spun({0.4, -0.1, 1.0}, 2.0);
  spec.torque = {load("constant"), load("force")};
  spec.torque[0].body = Vec3(0.5, 0.8, -0.3);
  spec.torque[0].rate = 3.0;
  spec.torque[1].body = Vec3(1, 0.5, 0.2);
  spec.torque[1].at = Vec3(0.1, 0.2, 0.3);
  spec.torque[1].rate = 2.0;
  BodyModel model = make_model(body_with({1, 1.3, 1.7}), spec);
  model.with_translation = true;
  const auto end = [&](int steps) {
    const auto stepper = find_stepper("dopri5").make(model, 1.0);
    State s = start_state(model, spec);
    for (int i = 0; i < steps; ++i)
      stepper->step(2.0 * i / steps, 2.0 / steps, s);
    return s;
  };
  const State exact = end(4000);
  const auto error = [&](int steps) {
    const State s = end(steps);
    return (s.y - exact.y).norm() + (s.place_S - exact.place_S).norm() +
           rotation_angle_between(s.q, exact.q);
  };
  // the slope comes down to 5 from above; a stage at a wrong time makes it 4 or less
  EXPECT_GT(std::log2(error(20) / error(40)), 4.8);
  EXPECT_GT(std::log2(error(40) / error(80)), 4.8);
}

// An accuracy that a load far away does not allow is refused as one that was asked for too much,
// also where the load is switched on amid the motion and steps end at it.
TEST(Torque, AnAccuracyOutOfReachIsAMistakeOfTheScene) {
  MotionSpec spec = spun({1, 2, 3}, 20.0);
  spec.position = Vec3(1e4, 0, 0);
  spec.torque = {load("spring")};
  spec.torque[0].k = 0.01;
  spec.torque[0].at = Vec3(0.3, 0.2, 0.5);
  for (const double from : {0.0, 5.0}) {
    spec.torque[0].from = from;
    for (const double accuracy : {1e-4, 1e-7}) {
      expect_input_error(
          [&] {
            simulate(make_model(body_with({0.01, 0.012, 0.015}), spec), spec, {}, accuracy);
          },
          "numerics.accuracy",
          "cannot reach an attitude accuracy");
    }
  }
}

// a spin too small to see must not set the scale of errors: it once took two hundred times the work
TEST(Torque, AStartAlmostAtRestCostsNoMore) {
  BodySpec body = body_with({0.01, 0.013, 0.016});
  MotionSpec spec = spun({0, 0, 0});
  spec.gravity = Vec3(0, 0, -9.81);
  spec.position = Vec3(0.1, 0, -0.4);
  spec.torque = {load("spring")};
  spec.torque[0].k = 20.0;
  spec.torque[0].at = Vec3(0.05, 0.03, 0.1);
  spec.torque[0].length = 0.3;
  const auto work = [&](double spin) {
    spec.spin.body = Vec3(0, 0, spin);
    return simulate(make_model(body, spec), spec, {}, 1e-6).report.record.evaluations;
  };
  const double at_rest = static_cast<double>(work(0.0));
  for (const double spin : {1e-3, 1e-9, 1e-15})
    EXPECT_LT(static_cast<double>(work(spin)), 1.5 * at_rest) << spin;
}

// the energy that six degrees of freedom keep is mostly that of flight
TEST(Models, DriftOfAFlightIsRelativeToItsEnergy) {
  MotionSpec flight = spun({0, 0, 1e-3});
  flight.gravity = Vec3(0, 0, -9.81);
  flight.position = Vec3(0.2, 0.1, -1);
  flight.velocity = Vec3(100.3, -0.3, 50.7);
  NumericsSpec numerics;
  numerics.model = "ode6";
  const Simulation s = solved(body_with({1, 1.3, 1.7}), flight, numerics);
  EXPECT_LT(s.report.record.drift.energy.value(), 1e-12);
}

// given by hand, the centre of mass is off by round-off: still no torque, still a closed form
TEST(Force, OnTheCenterGivenByHandTurnsNothing) {
  BodySpec body;
  body.points = {{0.1, {0.1, 0, 0}}, {0.2, {0, 0.7, 0.1}}, {0.3, {0, 0, 0.3}}};
  MotionSpec spec = spun({0.4, -0.1, 1.0});
  spec.torque = {load("force")};
  spec.torque[0].space = Vec3(1, 0, 0);
  spec.torque[0].at = Vec3(0.01 / 0.6, 0.14 / 0.6, 0.11 / 0.6);
  ASSERT_NE(*spec.torque[0].at, mass_properties(body).center);
  EXPECT_EQ(solved(body, spec).report.method, "exact");
}

TEST(Models, NoTorqueAboutALineOfMass) {
  BodySpec body;
  body.points = {{1.0, {0, 0, 1}}, {1.0, {0, 0, -1}}};
  const auto with = [&](const LoadSpec& one) {
    return [=] {
      MotionSpec spec = spun({1, 0, 0});
      spec.torque = {load("damping"), one};
      spec.torque[0].c = 0.1;
      make_model(body, spec);
    };
  };
  LoadSpec torque = load("constant");
  torque.body = Vec3(1, 0, 2);
  expect_input_error(with(torque), "motion.torque[1].body", "all mass lies on a line");
  torque.body = Vec3(1, 2, 0);
  EXPECT_NO_THROW(with(torque)());
  torque.body.reset();
  torque.space = Vec3(1, 2, 0);
  expect_input_error(with(torque), "motion.torque[1].space", "all mass lies on a line");
  LoadSpec force = load("force");
  force.space = Vec3(0, 0, 1);
  force.at = Vec3(0.1, 0, 0.5);
  expect_input_error(with(force), "motion.torque[1].at", "all mass lies on a line");
  force.at = Vec3(0, 0, 0.5);
  EXPECT_NO_THROW(with(force)());
}

}  // namespace
}  // namespace polhode
