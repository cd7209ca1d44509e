// SPDX-License-Identifier: MIT
#include "frame/scenery.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/motions.h"
#include "support/on_table.h"
#include "support/show_only.h"

namespace polhode {
namespace {

using test::brick_body;
using test::prolate_body;
using test::show_only;
using test::wobbling;

Scenery small_scenery(const BodySpec& body,
                      const MotionSpec& motion,
                      const ShowSpec& show = show_only("")) {
  return make_scenery(test::moving(body, motion), body, ThemeSpec{}, show, 32);
}

TEST(FramingTimes, AreInOrderFromTheStartToTheEnd) {
  const std::vector<double> times = framing_times(test::moving(brick_body(), wobbling()));
  ASSERT_GT(times.size(), 100U);
  EXPECT_EQ(times.front(), 0.0);
  EXPECT_EQ(times.back(), 4.0);
  for (std::size_t i = 1; i < times.size(); ++i) {
    EXPECT_GE(times[i], times[i - 1]);
    EXPECT_LT(times[i] - times[i - 1], 3.0 * 4.0 / static_cast<double>(times.size() - 1));
  }
}

// a motion of exactly so many periods is seen in every phase
TEST(FramingTimes, MeetEveryPhase) {
  const std::vector<double> times = framing_times(test::moving(brick_body(), wobbling()));
  for (const int periods : {1, 2, 60, 119, 120, 144, 233, 240, 241, 377, 480, 960}) {
    std::vector<double> phases;
    for (const double t : times) {
      const double turns = t / 4.0 * periods;
      phases.push_back(turns - std::floor(turns));
    }
    std::sort(phases.begin(), phases.end());
    double gap = 1.0 - phases.back() + phases.front();
    for (std::size_t i = 1; i < phases.size(); ++i)
      gap = std::max(gap, phases[i] - phases[i - 1]);
    EXPECT_LT(gap, 0.04) << periods;
  }
}

// the half diagonal of a box, the long semi-axis of an ellipsoid
TEST(Scenery, TheBodysScaleIsItsFarthestPoint) {
  EXPECT_NEAR(
      small_scenery(brick_body(), wobbling()).scale.body, 0.5 * Vec3(0.3, 0.2, 0.06).norm(), 1e-6);
  EXPECT_NEAR(small_scenery(prolate_body(), wobbling()).scale.body, 0.2, 1e-3) << "of its mesh";
}

TEST(Scenery, PointsThatAreDrawnFarOutEnlargeTheScale) {
  ShowSpec show = show_only("");
  show.points = {Vec3(0.0, 0.0, 0.7)};
  EXPECT_NEAR(small_scenery(prolate_body(), wobbling(), show).scale.body, 0.7, 1e-6);
  show.points.clear();
  show.trail_points = {Vec3(0.0, -0.9, 0.0)};
  EXPECT_NEAR(small_scenery(prolate_body(), wobbling(), show).scale.body, 0.9, 1e-6);
}

// a body that hangs still is off by rounding errors, of which no arrow is drawn
TEST(Scenery, RoundingErrorsAreNoVectors) {
  MotionSpec hanging = test::spinning_on_pivot();
  hanging.spin = {};
  hanging.attitude = {};
  hanging.attitude.zxz = Vec3(0.0, kPi, 0.0);
  const Scenery scenery = small_scenery(test::cone_body(), hanging);
  EXPECT_GT(scenery.motion.at(0.5).w_S.norm(), 0.0);
  EXPECT_EQ(scenery.scale.omega, 0.0);
  EXPECT_EQ(scenery.scale.momentum, 0.0);
  EXPECT_EQ(scenery.scale.torque, 0.0);
  // but a slow turn is one
  hanging.spin.body = Vec3(1e-7, 0.0, 0.0);
  EXPECT_GT(small_scenery(test::cone_body(), hanging).scale.omega, 0.0);
}

// a ball that bounces slips during its falls only, which are over in no time
TEST(Scenery, RoundingErrorsAreNoSlip) {
  FrictionSpec friction = test::coulomb(0.2);
  MotionSpec bouncing = test::on_table(1.0, friction);
  bouncing.friction->restitution = 0.6;
  bouncing.position = Vec3(0.0, 0.0, 0.2);
  bouncing.velocity = Vec3(0.3, 0.0, 0.0);
  EXPECT_EQ(small_scenery(test::ball_body(), bouncing).scale.slip, 0.0);
  MotionSpec sliding = test::on_table(0.1, friction);
  sliding.velocity = Vec3(0.3, 0.0, 0.0);
  EXPECT_GT(small_scenery(test::ball_body(), sliding).scale.slip, 0.0);
}

// else its head would be a collar on the shaft of L
TEST(Scenery, AnAxisOfSpaceAlongAVectorEndsBeyondIt) {
  MotionSpec upright = wobbling();
  upright.attitude = {};
  upright.spin = {};
  upright.spin.body = Vec3(0.0, 0.0, 2.0);
  const Scenery along = small_scenery(prolate_body(), upright, ShowSpec{});
  const Sample start = along.motion.at(0.0);
  const double L = (momentum_tip(along, start) - start.reference_S).norm() / along.scale.body;
  EXPECT_GT(along.axis_lengths[2], L + 0.3);
  EXPECT_EQ(along.axis_lengths[0], kSpaceAxisLength);
  // the other way round, aside, and where no vector is drawn
  upright.spin.body = Vec3(0.0, 0.0, -2.0);
  EXPECT_EQ(small_scenery(prolate_body(), upright, ShowSpec{}).axis_lengths[2], kSpaceAxisLength);
  upright.spin.body = Vec3(0.0, 0.4, 2.0);
  EXPECT_EQ(small_scenery(prolate_body(), upright, ShowSpec{}).axis_lengths[2], kSpaceAxisLength);
  upright.spin.body = Vec3(0.0, 0.0, 2.0);
  EXPECT_EQ(small_scenery(prolate_body(), upright).axis_lengths[2], kSpaceAxisLength);
}

// over the whole film the longest omega has 1.3 body radii; L of a free body is constant
TEST(Scenery, VectorsKeepTheirScaleOverTheFilm) {
  const Scenery scenery = small_scenery(brick_body(), wobbling());
  double longest = 0.0;
  for (double t = 0.0; t <= 4.0; t += 0.002) {
    const Sample now = scenery.motion.at(t);
    longest = std::max(longest, (omega_tip(scenery, now) - now.reference_S).norm());
    const Vec3 L = momentum_tip(scenery, now) - now.reference_S;
    EXPECT_LT((L.normalized() - now.L_S.normalized()).norm(), 1e-12);
    EXPECT_NEAR(L.norm(), scenery.scale.momentum * now.L_S.norm(), 1e-12);
  }
  EXPECT_NEAR(longest, 1.3 * scenery.scale.body, 2e-3 * scenery.scale.body);
}

// vectors may leave a large body; those of other kinds keep their length
TEST(Scenery, OmegaAndMomentumAreAsLongAsTheSceneWants) {
  ShowSpec show = show_only("velocity_field");
  MotionSpec pushed = wobbling();
  pushed.torque.resize(1);
  pushed.torque[0].kind = "constant";
  pushed.torque[0].space = Vec3(0.0, 1e-3, 0.0);
  const Scale usual = small_scenery(brick_body(), pushed, show).scale;
  show.vector_length = 1.7;
  const Scale longer = small_scenery(brick_body(), pushed, show).scale;
  EXPECT_NEAR(longer.omega, 1.7 * usual.omega, 1e-12 * usual.omega);
  EXPECT_NEAR(longer.momentum, 1.7 * usual.momentum, 1e-12 * usual.momentum);
  EXPECT_GT(usual.torque, 0.0);
  EXPECT_NEAR(longer.torque, 1.7 * usual.torque, 1e-12 * usual.torque);
  EXPECT_EQ(longer.velocity, usual.velocity);
  EXPECT_EQ(longer.body, usual.body);
}

// it is at right angles to the plane, on which omega ends too
TEST(Scenery, MomentumEndsOnTheInvariablePlane) {
  const Scenery scenery = small_scenery(brick_body(), wobbling(), show_only("plane"));
  for (const double t : {0.0, 1.3, 3.9}) {
    const Sample now = scenery.motion.at(t);
    const Vec3 L = momentum_tip(scenery, now) - now.reference_S;
    const Vec3 w = omega_tip(scenery, now) - now.reference_S;
    EXPECT_NEAR(L.norm(), w.dot(L.normalized()), 1e-9 * L.norm());
  }
}

// the tip of w lies along w: from the centre of mass, wherever that has gone
TEST(Scenery, TipsStartAtTheReferencePoint) {
  MotionSpec thrown = wobbling();
  thrown.velocity = Vec3(1.0, 0.0, 2.0);
  thrown.gravity = Vec3(0.0, 0.0, -9.8);
  const Scenery scenery = small_scenery(brick_body(), thrown);
  const Sample now = scenery.motion.at(0.5);
  EXPECT_LT((now.reference_S - Vec3(0.5, 0.0, 1.0 - 0.5 * 9.8 * 0.25)).norm(), 1e-12);
  const Vec3 w = omega_tip(scenery, now) - now.reference_S;
  EXPECT_LT(w.cross(now.w_S).norm(), 1e-12);
  EXPECT_GT(w.dot(now.w_S), 0.0);
}

TEST(Scenery, ABodyAtRestHasNoVectorsToScale) {
  MotionSpec rest = wobbling();
  rest.spin.body = Vec3::Zero();
  const Scale scale = small_scenery(brick_body(), rest).scale;
  EXPECT_EQ(scale.omega, 0.0);
  EXPECT_EQ(scale.momentum, 0.0);
  EXPECT_EQ(scale.velocity, 0.0);
  EXPECT_EQ(scale.force, 0.0);
  EXPECT_GT(scale.body, 0.0);
}

// a method that fails may blow a vector up to what single precision cannot hold
TEST(Scenery, LongVectorsAreCutAtFiftyRadii) {
  const Scenery scenery = small_scenery(prolate_body(), wobbling());
  const Vec3 from(1, 2, 3);
  EXPECT_EQ(drawn_length(scenery, 9.0), 9.0);
  const double longest = 50.0 * scenery.scale.body;
  EXPECT_DOUBLE_EQ(drawn_length(scenery, 1e200), longest);
  EXPECT_NEAR(longest, 10.0, 0.05);
  EXPECT_EQ(drawn_tip(scenery, from, from + Vec3(0, 3, 4)), from + Vec3(0, 3, 4));
  const Vec3 cut = drawn_tip(scenery, from, from + Vec3(0, 3e20, 4e20)) - from;
  EXPECT_LT((cut - longest * Vec3(0, 0.6, 0.8)).norm(), 1e-9);
}

// the field is drawn at points of the body's hull, far apart from each other
TEST(Scenery, TheVelocityFieldIsSpreadOverTheBody) {
  const Scenery scenery = small_scenery(prolate_body(), wobbling());
  const std::vector<Vec3>& points = scenery.field_points_B;
  ASSERT_EQ(points.size(), 48U);
  Vec3 low = points[0], high = points[0];
  double nearest = 1.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    low = low.cwiseMin(points[i]);
    high = high.cwiseMax(points[i]);
    for (std::size_t k = 0; k < i; ++k)
      nearest = std::min(nearest, (points[i] - points[k]).norm());
  }
  EXPECT_LT((high - Vec3(0.1, 0.1, 0.2)).norm(), 0.03);
  EXPECT_LT((low + Vec3(0.1, 0.1, 0.2)).norm(), 0.03);
  EXPECT_GT(nearest, 0.03) << "48 points share 0.2 m^2";
}

// only the paths that the scene asks for are computed; each is that of its name
TEST(Scenery, PathsAreThoseThatAreAskedFor) {
  const Scenery none = small_scenery(brick_body(), wobbling());
  EXPECT_TRUE(none.paths.axis.path().points.empty());
  EXPECT_TRUE(none.paths.herpolhode.path().points.empty());
  EXPECT_EQ(none.paths.polhode, nullptr);
  const Scenery one = small_scenery(brick_body(), wobbling(), show_only("herpolhode"));
  EXPECT_FALSE(one.paths.herpolhode.path().points.empty());
  EXPECT_TRUE(one.paths.axis.path().points.empty());
}

TEST(Scenery, TheLookHasTheMaterialThatIsAskedFor) {
  ShowSpec show = show_only("body");
  for (const std::string& material : material_names()) {
    show.material = material;
    const Scenery scenery = small_scenery(brick_body(), wobbling(), show);
    ASSERT_FALSE(scenery.look.empty());
    for (const LookPart& part : scenery.look)
      EXPECT_EQ(part.material.finish, finish_named(material)) << material;
  }
}

}  // namespace
}  // namespace polhode
