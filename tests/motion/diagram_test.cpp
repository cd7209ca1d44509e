// SPDX-License-Identifier: MIT
#include "motion/diagram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "math/so3.h"
#include "motion/derived.h"
#include "support/motions.h"

namespace polhode {
namespace {

using Kind = DiagramCurve::Kind;

// how far a point is from the curves of a kind, in units of the axes
double distance_from(const Diagram& diagram, Kind kind, const Vec2& point) {
  const Vec2 size(diagram.across.high - diagram.across.low, diagram.up.high - diagram.up.low);
  double least = std::numeric_limits<double>::infinity();
  for (const DiagramCurve& curve : diagram.curves) {
    if (curve.kind != kind) continue;
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      const Vec2 a = (curve.points[i - 1] - point).cwiseQuotient(size);
      const Vec2 way = (curve.points[i] - curve.points[i - 1]).cwiseQuotient(size);
      const double part =
          way.norm() > 0.0 ? std::clamp(-a.dot(way) / way.squaredNorm(), 0.0, 1.0) : 0.0;
      least = std::min(least, (a + part * way).norm());
    }
  }
  return least;
}

// all that a diagram shows lies within its axes, also where the motion will be
void expect_within(const Diagram& diagram, const Motion& motion) {
  const auto expect = [&](const Vec2& at) {
    const double free_x = 1e-9 * (diagram.across.high - diagram.across.low);
    const double free_y = 1e-9 * (diagram.up.high - diagram.up.low);
    EXPECT_GE(at.x(), diagram.across.low - free_x);
    EXPECT_LE(at.x(), diagram.across.high + free_x);
    EXPECT_GE(at.y(), diagram.up.low - free_y);
    EXPECT_LE(at.y(), diagram.up.high + free_y);
  };
  for (const DiagramCurve& curve : diagram.curves)
    for (const Vec2& point : curve.points)
      expect(point);
  for (const DiagramMark& mark : diagram.marks)
    expect(mark.at);
  for (int i = 0; i <= 50; ++i)
    expect(diagram.now(motion.duration() * i / 50));
}

MotionSpec top_spec(const Vec3& rates, double tilt, double duration = 1.5) {
  MotionSpec spec = test::spinning_on_pivot();
  spec.attitude = {};
  spec.attitude.zxz = Vec3(0.3, tilt, 0.2);
  spec.spin = {};
  spec.spin.rates = rates;
  spec.duration = duration;
  return spec;
}

double theory(const Motion& motion, const MotionSpec& spec, const char* key) {
  return value_of(derived_quantities(motion.model(), spec), key).value();
}

TEST(Diagrams, EveryKindHasANameOfItsOwn) {
  std::set<std::string> names;
  for (const std::string& name : plot_names())
    EXPECT_TRUE(names.insert(name).second) << name;
  EXPECT_EQ(find_diagram("nothing"), nullptr);
}

// the turning points are those of the closed form, and the motion stays below its energy
TEST(Diagrams, TheTiltTurnsWhereThePotentialIsTheEnergy) {
  for (const Vec3& rates : {Vec3(0, 0, 300), Vec3(3, 0, 250), Vec3(-4, 1, 200), Vec3(1, 5, -180)}) {
    for (const double tilt : {0.2, 0.9, 2.0}) {
      SCOPED_TRACE(testing::Message() << rates.transpose() << " at " << tilt);
      const MotionSpec spec = top_spec(rates, tilt);
      const Motion motion = test::moving(test::cone_body(), spec);
      const Diagram diagram = find_diagram("potential")->make(motion);
      expect_within(diagram, motion);
      ASSERT_EQ(diagram.marks.size(), 2U);
      EXPECT_NEAR(diagram.marks[0].at.x() * kDegree, theory(motion, spec, "least_tilt_rad"), 1e-7);
      EXPECT_NEAR(
          diagram.marks[1].at.x() * kDegree, theory(motion, spec, "greatest_tilt_rad"), 1e-7);
      const double energy = diagram.marks[0].at.y();
      const double I1 = motion.model().moments.x();
      for (double t = 0.0; t <= 1.5; t += 0.093) {
        const Vec2 now = diagram.now(t);
        EXPECT_LT(distance_from(diagram, Kind::potential, now), 1e-4);
        // what is left of the energy is that of the tilt's own motion
        const Sample sample = motion.at(t);
        const Vec3 axis = sample.q_SB * Vec3::UnitZ();
        const Vec3 axis_rate = sample.w_S.cross(axis);
        const double tilt_rate = -axis_rate.z() / std::sin(angle_between(axis, Vec3::UnitZ()));
        const double rounding = 1e-9 * (std::abs(energy) + motion.model().chi_P.norm());
        EXPECT_NEAR(0.5 * I1 * tilt_rate * tilt_rate + now.y(), energy, rounding);
      }
    }
  }
}

// The moments of a satellite of ratios (yaw, roll); pitch, roll and yaw are z, y and x.
Vec3 moments_of(double yaw, double roll) {
  return Vec3((1.0 - roll), (1.0 - yaw), 1.0 - yaw * roll) / (1.0 - yaw * roll);
}

// how fast a small disturbance grows in one orbit: the largest eigenvalue of the map from turn and
// rate before it to turn and rate after it
double growth_in_an_orbit(const Vec3& moments) {
  BodySpec body;
  body.moments = moments;
  MotionSpec spec;
  spec.duration = 2.0 * kPi;
  LoadSpec gradient;
  gradient.kind = "gravity_gradient";
  gradient.rate = 1.0;
  spec.torque = {gradient};
  const double size = 1e-5;
  const auto after = [&](const Vec3& turn, const Vec3& rate) {
    const Quat q = exp_rotation(turn);
    MotionSpec disturbed = spec;
    disturbed.attitude.quaternion = Eigen::Vector4d(q.w(), q.x(), q.y(), q.z());
    // in the orbit's frame, which turns about Z
    disturbed.spin.space = Vec3::UnitZ() + rate;
    const Sample end =
        simulate(make_model(body, disturbed), disturbed, {}, 1e-10).motion.at(spec.duration);
    Eigen::Matrix<double, 6, 1> found;
    found << std::copysign(2.0, end.q_SB.w()) * end.q_SB.vec(), end.w_S - Vec3::UnitZ();
    return found;
  };
  Eigen::Matrix<double, 6, 6> map;
  for (int i = 0; i < 3; ++i) {
    const Vec3 step = size * Vec3::Unit(i);
    map.col(i) = (after(step, Vec3::Zero()) - after(-step, Vec3::Zero())) / (2.0 * size);
    map.col(3 + i) = (after(Vec3::Zero(), step) - after(Vec3::Zero(), -step)) / (2.0 * size);
  }
  return map.eigenvalues().cwiseAbs().maxCoeff();
}

bool is_within(const std::vector<Vec2>& outline, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const Vec2 &a = outline[i - 1], &b = outline[i];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double x = a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y());
    if (point.x() < x) inside = !inside;
  }
  return inside;
}

// Floquet multipliers of the motion itself say where its attitude is stable
TEST(Diagrams, ASatelliteIsStableWithinTheBoundary) {
  MotionSpec spec;
  spec.duration = 10.0;
  LoadSpec gradient;
  gradient.kind = "gravity_gradient";
  gradient.rate = 1.0;
  spec.torque = {gradient};
  int stable = 0, unstable = 0;
  for (const Vec2& at : {Vec2(0.3, 0.6),
                         Vec2(0.1, 0.9),
                         Vec2(0.7, 0.8),
                         Vec2(0.6, 0.5),
                         Vec2(0.5, 0.2),
                         Vec2(-0.5, -0.05),
                         Vec2(-0.9, -0.03),
                         Vec2(-0.15, -0.1),
                         Vec2(-0.5, -0.12),
                         Vec2(-0.9, -0.08),
                         Vec2(-0.3, -0.2),
                         Vec2(-0.3, -0.6),
                         Vec2(-0.4, 0.5),
                         Vec2(0.4, -0.5),
                         Vec2(-0.8, 0.05)}) {
    SCOPED_TRACE(testing::Message() << "yaw " << at.x() << ", roll " << at.y());
    BodySpec body;
    body.moments = moments_of(at.x(), at.y());
    const Motion motion = test::moving(body, spec);
    const Diagram diagram = find_diagram("satellite_map")->make(motion);
    expect_within(diagram, motion);
    EXPECT_LT((diagram.now(0.0) - at).norm(), 1e-12);
    bool inside = false;
    for (const DiagramCurve& curve : diagram.curves)
      inside = inside || (curve.kind == Kind::boundary && is_within(curve.points, at));
    const double growth = growth_in_an_orbit(*body.moments);
    EXPECT_EQ(growth < 1.001, inside) << growth;
    ++(inside ? stable : unstable);
  }
  EXPECT_EQ(stable, 6);
  EXPECT_EQ(unstable, 9);
}

// Damping, for one, brings down what only rotation holds.
TEST(Diagrams, TheMapOfSatellitesIsOfTheGradientAlone) {
  MotionSpec spec;
  LoadSpec gradient;
  gradient.kind = "gravity_gradient";
  gradient.rate = 1.0;
  BodySpec body;
  body.moments = moments_of(0.3, 0.6);
  const auto refusal = [&](const std::vector<LoadSpec>& loads) {
    spec.torque = loads;
    return find_diagram("satellite_map")->why_not(test::moving(body, spec));
  };
  EXPECT_EQ(refusal({gradient}), "");
  LoadSpec damping;
  damping.kind = "damping";
  damping.c = 1e-3;
  EXPECT_EQ(refusal({gradient, damping}),
            "needs a satellite without other torques, whose gravity_gradient always acts");
  gradient.until = 3.0;
  EXPECT_NE(refusal({gradient}), "");
}

TEST(Diagrams, APhasePortraitHoldsItsMotion) {
  for (const double tilt : {0.3, 1.2, 2.5}) {
    const MotionSpec spec = top_spec(Vec3(2, 1, 220), tilt);
    const Motion motion = test::moving(test::cone_body(), spec);
    const Diagram diagram = find_diagram("phase")->make(motion);
    expect_within(diagram, motion);
    for (double t = 0.0; t <= 1.5; t += 0.0617) {
      EXPECT_LT(distance_from(diagram, Kind::motion, diagram.now(t)), 1e-4) << t;
      // the second coordinate is the rate of the first
      if (t == 0.0) continue;
      const double h = 1e-5;
      const double rate = (diagram.now(t + h).x() - diagram.now(t - h).x()) / (2.0 * h);
      EXPECT_NEAR(diagram.now(t).y(), rate, 1e-4 * (diagram.up.high - diagram.up.low)) << t;
    }
  }
}

// a top that sleeps too slowly: the separatrix begins upright, with the energy of standing there
TEST(Diagrams, ASlowTopHasASeparatrixThroughUpright) {
  const Motion motion = test::moving(test::cone_body(), top_spec(Vec3(0, 0, 30), 0.0));
  const Diagram diagram = find_diagram("phase")->make(motion);
  EXPECT_LT(distance_from(diagram, Kind::separatrix, Vec2::Zero()), 1e-9);
  const auto upright = std::find_if(diagram.marks.begin(),
                                    diagram.marks.end(),
                                    [](const DiagramMark& mark) { return mark.name == "upright"; });
  ASSERT_NE(upright, diagram.marks.end());
  EXPECT_FALSE(upright->stable);
  // a fast one sleeps: no separatrix
  const Motion fast = test::moving(test::cone_body(), top_spec(Vec3(0, 0, 2000), 0.0));
  const Diagram sleeping = find_diagram("phase")->make(fast);
  EXPECT_TRUE(std::isinf(distance_from(sleeping, Kind::separatrix, Vec2::Zero())));
}

// swings of a pendulum end where m g l (1 - cos) is the energy; it turns over beyond 2 m g l
TEST(Diagrams, APendulumSwingsInsideItsSeparatrix) {
  for (const double rate : {0.0, 5.0, 40.0}) {
    const MotionSpec spec = top_spec(Vec3(0, rate, 0), 2.2, 1.0);
    const Motion motion = test::moving(test::cone_body(), spec);
    const Diagram diagram = find_diagram("phase")->make(motion);
    expect_within(diagram, motion);
    EXPECT_LT(distance_from(diagram, Kind::separatrix, Vec2(180.0, 0.0)), 1e-9);
    for (double t = 0.0; t <= 1.0; t += 0.037)
      EXPECT_LT(distance_from(diagram, Kind::motion, diagram.now(t)), 1e-4) << rate << ' ' << t;
    // half of the separatrix's height is at 120 degrees: cos^2(60) = 1/4
    const double I1 = motion.model().moments.x(), mgl = motion.model().chi_P.norm();
    const double height = 2.0 * std::sqrt(mgl / I1) / kDegree;
    EXPECT_LT(distance_from(diagram, Kind::separatrix, Vec2(0.0, height)), 1e-4);
    EXPECT_LT(distance_from(diagram, Kind::separatrix, Vec2(120.0, 0.5 * height)), 1e-4);
  }
}

// (dw/dt)^2 / 2 + V(w) = 0, with dw/dt from Euler's equations
TEST(Diagrams, TheMiddleComponentMovesInItsPotential) {
  for (const Vec3& rates :
       {Vec3(1.1, 0.4, 2.0), Vec3(3.0, 0.2, 0.1), Vec3(0.01, 4.0, 0.02), Vec3(0.3, 1.0, -5.0)}) {
    MotionSpec spec = test::wobbling();
    spec.spin.body = rates;
    const Motion motion = test::moving(test::brick_body(), spec);
    const Diagram diagram = find_diagram("potential")->make(motion);
    expect_within(diagram, motion);
    const Vec3& I = motion.model().moments;  // of a brick: least about x, middle y, greatest z
    for (double t = 0.0; t <= 4.0; t += 0.21) {
      const Vec3 w = motion.model().R_BP.transpose() * motion.at(t).w_B;
      const double rate = (I.z() - I.x()) * w.z() * w.x() / I.y();
      const Vec2 now = diagram.now(t);
      EXPECT_NEAR(now.x(), w.y(), 1e-12 * w.norm());
      EXPECT_NEAR(0.5 * rate * rate + now.y(), 0.0, 1e-10 * std::pow(w.norm(), 4)) << t;
      EXPECT_LT(distance_from(diagram, Kind::potential, now), 1e-4);
    }
  }
}

TEST(Diagrams, AMapOfPolhodesHoldsItsMotion) {
  for (const Vec3& rates : {Vec3(1.1, 0.4, 2.0),
                            Vec3(-3.0, 0.2, 0.1),
                            Vec3(0.05, 4.0, 0.2),
                            Vec3(0.3, 1.0, -5.0),
                            Vec3(0.0, 0.0, 1.0)}) {
    MotionSpec spec = test::wobbling();
    spec.spin.body = rates;
    const Motion motion = test::moving(test::brick_body(), spec);
    const Diagram diagram = find_diagram("polhode_map")->make(motion);
    expect_within(diagram, motion);
    for (double t = 0.0; t <= 4.0; t += 0.21)
      EXPECT_LT(distance_from(diagram, Kind::motion, diagram.now(t)), 1e-4) << t;
    // the separatrices cross at the middle axis
    for (const double side : {-90.0, 90.0})
      EXPECT_LT(distance_from(diagram, Kind::separatrix, Vec2(side, 0.0)), 1e-3);
  }
  // of a symmetric top L goes round on a circle of latitude
  const Motion symmetric = test::moving(test::prolate_body(), test::wobbling());
  const Diagram diagram = find_diagram("polhode_map")->make(symmetric);
  EXPECT_TRUE(diagram.marks.empty());
  for (double t = 0.1; t <= 4.0; t += 0.21)
    EXPECT_NEAR(diagram.now(t).y(), diagram.now(0.0).y(), 1e-12);
}

TEST(Diagrams, OthersAreTold) {
  const Motion free = test::moving(test::brick_body(), test::wobbling());
  const Motion top = test::moving(test::cone_body(), test::spinning_on_pivot());
  EXPECT_NE(find_diagram("phase")->why_not(free), "");
  EXPECT_NE(find_diagram("polhode_map")->why_not(top), "");
  EXPECT_EQ(find_diagram("potential")->why_not(free), "");
  EXPECT_EQ(find_diagram("potential")->why_not(top), "");
  const Motion symmetric = test::moving(test::prolate_body(), test::wobbling());
  EXPECT_NE(find_diagram("potential")->why_not(symmetric), "");
  // at rest there is no polhode
  MotionSpec rest = test::wobbling();
  rest.spin = {};
  const Motion still = test::moving(test::brick_body(), rest);
  EXPECT_NE(find_diagram("polhode_map")->why_not(still), "");
  EXPECT_NE(find_diagram("potential")->why_not(still), "");
}

}  // namespace
}  // namespace polhode
