// SPDX-License-Identifier: MIT
// Cones and angles, against the theory of the symmetric top.
#include <cmath>

#include <gtest/gtest.h>

#include "frame/compose.h"
#include "frame/composers.h"
#include "math/so3.h"
#include "support/motions.h"
#include "support/show_only.h"

namespace polhode {
namespace {

using test::composer;
using test::cone_body;
using test::moving;
using test::oblate_body;
using test::prolate_body;
using test::show_only;
using test::spinning_on_pivot;
using test::wobbling;

// both cones hold omega on their surface and end at its tip, at every time
TEST(Cones, TouchAlongOmega) {
  for (const BodySpec& body : {prolate_body(), oblate_body()}) {
    const Motion motion = moving(body, wobbling());
    const Composer picture = composer(body, wobbling());
    for (double t = 0.0; t <= 4.0; t += 0.37) {
      const Sample s = motion.at(t);
      const std::vector<Cone> cones = picture.glyphs_at(s).cones;
      ASSERT_EQ(cones.size(), 2u);
      // both axes and omega are in one plane
      EXPECT_NEAR(cones[0].axis.cross(cones[1].axis).dot(s.w_S.normalized()), 0.0, 1e-12);
      for (const Cone& cone : cones) {
        EXPECT_NEAR(angle_between(cone.axis, s.w_S), cone.half_angle, 1e-12);
        EXPECT_NEAR(cone.slant, (omega_tip(picture.scenery(), s) - cone.apex).norm(), 1e-12);
      }
    }
  }
}

// textbook half-angles: tan(space) and tan(body) from the moments; outside for prolate, inside for
// oblate
TEST(Cones, RollOutsideForProlateAndInsideForOblate) {
  for (const bool prolate : {true, false}) {
    const BodySpec body = prolate ? prolate_body() : oblate_body();
    const Motion motion = moving(body, wobbling());
    const Composer picture = composer(body, wobbling());
    const Sample s = motion.at(0.7);
    const std::vector<Cone> cones = picture.glyphs_at(s).cones;
    ASSERT_EQ(cones.size(), 2u);
    const Vec3 axis_S = s.q_SB * Vec3::UnitZ();
    const double theta = angle_between(s.L_S, axis_S);
    const double ratio = motion.model().moments[2] / motion.model().moments[0];
    const double body_angle = std::atan(ratio * std::tan(theta));
    EXPECT_NEAR(cones[1].half_angle, body_angle, 1e-12);
    EXPECT_NEAR(cones[0].half_angle, std::abs(theta - body_angle), 1e-12);
    const double apart = angle_between(cones[0].axis, cones[1].axis);
    if (prolate) {
      EXPECT_NEAR(apart, cones[0].half_angle + cones[1].half_angle, 1e-12);
    } else {
      EXPECT_NEAR(apart, cones[1].half_angle - cones[0].half_angle, 1e-12);
    }
  }
}

// cones are named at their rims, on the side that is away from omega; narrow ones are not
TEST(Cones, AreNamedAwayFromOmega) {
  const auto names_of = [](const MotionSpec& spec) {
    const Composer picture = composer(prolate_body(), spec);
    const Sample s = picture.scenery().motion.at(0.7);
    const Glyphs glyphs = picture.glyphs_at(s);
    int count = 0;
    for (const LabelGlyph& label : glyphs.labels) {
      const bool of_space = label.markup == "space cone";
      if (!of_space && label.markup != "body cone") continue;
      ++count;
      const Cone& cone = glyphs.cones.at(of_space ? 0 : 1);
      const auto across = [&](const Vec3& v) {
        return Vec3(v - v.dot(cone.axis) * cone.axis);
      };
      const Vec3 out = across(label.at - cone.apex).normalized();
      EXPECT_NEAR(out.dot(across(s.w_S).normalized()), -1.0, 1e-9);
      const Vec3 rim =
          cone.slant * (std::cos(cone.half_angle) * cone.axis + std::sin(cone.half_angle) * out);
      EXPECT_LT((label.at - cone.apex - rim).norm(), 0.2 * picture.scenery().scale.body);
    }
    return count;
  };
  EXPECT_EQ(names_of(wobbling()), 2);
  MotionSpec little = wobbling();
  little.spin.body = Vec3(0.05, 0.0, 3.0);
  EXPECT_EQ(names_of(little), 0);
}

// rolling without slipping: the material line of the body on the contact generator has no velocity,
// and the generator moves over both cones by the same arc
TEST(Cones, RollWithoutSlipping) {
  const BodySpec body = prolate_body();
  const Motion motion = moving(body, wobbling());
  const Composer picture = composer(body, wobbling());
  const double h = 1e-4;
  const Sample before = motion.at(1.0 - h);
  const Sample now = motion.at(1.0);
  const Sample after = motion.at(1.0 + h);
  const Vec3 contact_B =
      now.q_SB.conjugate() * (omega_tip(picture.scenery(), now) - now.reference_S);
  const Vec3 velocity = (after.q_SB * contact_B - before.q_SB * contact_B) / (2.0 * h);
  EXPECT_LT(velocity.norm(), 1e-6 * contact_B.norm() * now.w_S.norm());

  // arc of the contact line over the space cone and over the body cone
  const auto arc = [&](const Vec3& a, const Vec3& b) {
    return angle_between(a, b);
  };
  const double in_space = arc(before.w_S, after.w_S);
  const double in_body = arc(before.w_B, after.w_B);
  EXPECT_GT(in_space, 0.0);
  EXPECT_NEAR(in_space / in_body, 1.0, 1e-6);
}

// the cone about the vertical passes through the figure axis, whatever the tilt of the moment
TEST(Cones, PrecessionConeFollowsTheTilt) {
  const Motion motion = moving(cone_body(), spinning_on_pivot());
  const Composer picture = composer(cone_body(), spinning_on_pivot());
  double least = 10.0;
  double most = 0.0;
  for (double t = 0.0; t <= 2.0; t += 0.01) {
    const Sample s = motion.at(t);
    const std::vector<Cone> cones = picture.glyphs_at(s).cones;
    ASSERT_EQ(cones.size(), 1u);
    EXPECT_NEAR(cones[0].half_angle, angle_between(s.q_SB * Vec3::UnitZ(), Vec3::UnitZ()), 1e-12);
    least = std::min(least, cones[0].half_angle);
    most = std::max(most, cones[0].half_angle);
  }
  EXPECT_NEAR(least, 0.5, 1e-4);
  EXPECT_GT(most, least + 0.01) << "the top nutates";
}

// a gyroscope whose level axle nodes: its cone is there at every moment, and its rim, which is a
// circle through the axle's end, never jumps
TEST(Cones, PrecessionConeIsADiscWhenTheAxisIsLevel) {
  MotionSpec spec = spinning_on_pivot();
  spec.attitude.zxz = Vec3(0.0, 0.5 * kPi - 0.02, 0.0);
  spec.spin.rates = Vec3(0.0, 0.0, 250.0);
  const Motion motion = moving(cone_body(), spec);
  const Composer picture = composer(cone_body(), spec);
  const double step = 1e-3;
  double least = 1.0, most = -1.0;
  Vec3 before = Vec3::Zero();
  for (double t = 0.0; t <= 1.0; t += step) {
    const Sample s = motion.at(t);
    const std::vector<Cone> cones = picture.glyphs_at(s).cones;
    ASSERT_EQ(cones.size(), 1u) << t;
    const Cone& cone = cones.front();
    const double level = (s.q_SB * Vec3::UnitZ()).z();
    least = std::min(least, level);
    most = std::max(most, level);
    EXPECT_LE(cone.half_angle, 0.5 * kPi + 1e-12);
    const Vec3 middle = cone.slant * std::cos(cone.half_angle) * cone.axis;
    EXPECT_NEAR(middle.z(), cone.slant * level, 1e-9 * cone.slant) << t;
    if (t > 0.0) {
      EXPECT_LT((middle - before).norm(), 2.0 * s.w_S.norm() * step * cone.slant) << t;
    }
    before = middle;
    EXPECT_EQ(cone.material.alpha, picture.glyphs_at(motion.at(0.0)).cones.front().material.alpha);
  }
  EXPECT_LT(least, -1e-3) << "the axle passes the horizontal";
  EXPECT_GT(most, 1e-3);
}

// each arc goes from an axis of space to that of the body, by the angle between them
TEST(Cones, ArcsGoFromAxisToAxis) {
  const Composer picture = composer(prolate_body(), wobbling(), show_only("angles"));
  const Sample s = picture.scenery().motion.at(1.1);
  const Glyphs glyphs = picture.glyphs_at(s);
  ASSERT_EQ(glyphs.arcs.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    const ArcGlyph& arc = glyphs.arcs[static_cast<std::size_t>(i)];
    EXPECT_LT((arc.from - Vec3::Unit(i)).norm(), 1e-15);
    EXPECT_LT((arc.to - s.q_SB * Vec3::Unit(i)).norm(), 1e-15);
  }
}

// theta is the second of the zxz angles that the motion was given, and its name stands on the arc
TEST(Cones, TiltIsTheSecondEulerAngle) {
  MotionSpec motion = wobbling();
  for (const double theta : {0.2, 1.0, 2.0, 3.0}) {
    motion.attitude.zxz = Vec3(0.3, theta, 0.2);
    const Composer picture = composer(prolate_body(), motion, show_only("tilt"));
    const Glyphs glyphs = picture.glyphs_at(picture.scenery().motion.at(0.0));
    ASSERT_EQ(glyphs.arcs.size(), 1u);
    EXPECT_NEAR(angle_between(glyphs.arcs[0].from, glyphs.arcs[0].to), theta, 1e-12);
    // it is measured from the vertical to the axis, which are drawn and pass its ends
    ASSERT_EQ(glyphs.rods.size(), 2u);
    for (const double end : {0.0, 1.0}) {
      const RodGlyph& side = glyphs.rods[end == 0.0 ? 0 : 1];
      const Vec3 along = side.to - side.from;
      EXPECT_EQ(side.from, glyphs.arcs[0].center);
      EXPECT_NEAR(
          (glyphs.arcs[0].radius * along.normalized() + side.from - point_of(glyphs.arcs[0], end))
              .norm(),
          0.0,
          1e-12);
      EXPECT_GT(along.norm(), glyphs.arcs[0].radius);
    }
    ASSERT_EQ(glyphs.labels.size(), 1u);
    EXPECT_NEAR((glyphs.labels[0].at - glyphs.arcs[0].center).norm(), glyphs.arcs[0].radius, 1e-12);
  }
  motion.attitude.zxz = Vec3(0.3, 0.0, 0.2);
  const Composer upright = composer(prolate_body(), motion, show_only("tilt"));
  EXPECT_TRUE(upright.glyphs_at(upright.scenery().motion.at(0.0)).arcs.empty());
}

}  // namespace
}  // namespace polhode
