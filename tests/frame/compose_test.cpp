// SPDX-License-Identifier: MIT
#include "frame/compose.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/motions.h"

namespace polhode {
namespace {

using test::cone_body;
using test::moving;
using test::oblate_body;
using test::prolate_body;
using test::spinning_on_pivot;
using test::wobbling;

constexpr FrameSize kSize{640, 360};

Composer composer(const BodySpec& body,
                  const MotionSpec& motion,
                  const ShowSpec& show = {},
                  const CameraSpec& camera = {}) {
  return {moving(body, motion), body, camera, show, ThemeSpec{}, kSize};
}

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// both cones hold omega on their surface and end at its tip, at every time
TEST(Cones, TouchAlongOmega) {
  for (const BodySpec& body : {prolate_body(), oblate_body()}) {
    const Motion motion = moving(body, wobbling());
    const Composer picture = composer(body, wobbling());
    for (double t = 0.0; t <= 4.0; t += 0.37) {
      const Sample s = motion.at(t);
      const std::vector<Cone> cones = picture.cones_at(s);
      ASSERT_EQ(cones.size(), 2u);
      for (const Cone& cone : cones) {
        EXPECT_NEAR(angle_between(cone.axis, s.w_S), cone.half_angle, 1e-12);
        EXPECT_NEAR(cone.slant, (picture.omega_tip(s) - cone.apex).norm(), 1e-12);
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
    const std::vector<Cone> cones = picture.cones_at(s);
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
  const Vec3 contact_B = now.q_SB.conjugate() * (picture.omega_tip(now) - now.reference_S);
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

TEST(Shown, DefaultsFollowTheScene) {
  const Shown free = composer(prolate_body(), wobbling()).shown();
  EXPECT_TRUE(free.body && free.omega && free.momentum && free.space_cone && free.body_cone);
  EXPECT_FALSE(free.precession_cone || free.pivot);
  const Shown heavy = composer(cone_body(), spinning_on_pivot()).shown();
  EXPECT_TRUE(heavy.precession_cone && heavy.pivot);
  EXPECT_FALSE(heavy.space_cone || heavy.body_cone);

  MotionSpec steady = wobbling();
  steady.spin.body = Vec3(0, 0, 3);
  EXPECT_FALSE(composer(prolate_body(), steady).shown().space_cone) << "no wobble, no cone";
}

TEST(Shown, AskingForWhatIsNotThereIsAnError) {
  ShowSpec cones;
  cones.space_cone = true;
  ShowSpec stand;
  stand.pivot = true;
  try {
    composer(cone_body(), spinning_on_pivot(), cones);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.place().key, "show.space_cone");
  }
  try {
    composer(prolate_body(), wobbling(), stand);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.place().key, "show.pivot");
  }
}

TEST(Shown, EachNameAddsOrTakesItsOwnItems) {
  ShowSpec nothing;
  nothing.body = nothing.axes = nothing.space_axes = nothing.omega = nothing.momentum = false;
  nothing.space_cone = nothing.body_cone = false;
  const auto count = [&](const ShowSpec& show) {
    const DrawList list = composer(prolate_body(), wobbling(), show).at(0.5);
    return std::pair(list.opaque.size(), list.translucent.size());
  };
  EXPECT_EQ(count(nothing), std::pair(std::size_t{0}, std::size_t{0}));
  const std::pair<std::optional<bool> ShowSpec::*, std::pair<std::size_t, std::size_t>> cases[] = {
      {&ShowSpec::body, {1, 0}},
      {&ShowSpec::axes, {6, 0}},
      {&ShowSpec::space_axes, {6, 0}},
      {&ShowSpec::omega, {2, 0}},
      {&ShowSpec::momentum, {2, 0}},
      {&ShowSpec::space_cone, {1, 2}},
      {&ShowSpec::body_cone, {1, 2}}};
  for (const auto& [name, items] : cases) {
    ShowSpec one = nothing;
    one.*name = true;
    EXPECT_EQ(count(one), items);
  }
}

// the cone about the vertical passes through the figure axis, whatever the tilt of the moment
TEST(PrecessionCone, FollowsTheTilt) {
  const Motion motion = moving(cone_body(), spinning_on_pivot());
  const Composer picture = composer(cone_body(), spinning_on_pivot());
  double least = 10.0;
  double most = 0.0;
  for (double t = 0.0; t <= 2.0; t += 0.01) {
    const Sample s = motion.at(t);
    const std::vector<Cone> cones = picture.cones_at(s);
    ASSERT_EQ(cones.size(), 1u);
    EXPECT_NEAR(cones[0].half_angle, angle_between(s.q_SB * Vec3::UnitZ(), Vec3::UnitZ()), 1e-12);
    least = std::min(least, cones[0].half_angle);
    most = std::max(most, cones[0].half_angle);
  }
  EXPECT_NEAR(least, 0.5, 1e-4);
  EXPECT_GT(most, least + 0.01) << "the top nutates";
}

// a frame is a function of its time alone
TEST(Composer, IsPure) {
  const Composer picture = composer(cone_body(), spinning_on_pivot());
  const DrawList first = picture.at(1.234);
  picture.at(0.1);
  const DrawList again = picture.at(1.234);
  ASSERT_EQ(first.opaque.size(), again.opaque.size());
  for (std::size_t i = 0; i < first.opaque.size(); ++i) {
    EXPECT_EQ(first.opaque[i].world_from_mesh, again.opaque[i].world_from_mesh);
  }
}

// what is drawn stays inside the frame for the whole film
TEST(Composer, AutomaticCameraKeepsEverythingInside) {
  for (const bool heavy : {false, true}) {
    const BodySpec body = heavy ? cone_body() : prolate_body();
    const MotionSpec spec = heavy ? spinning_on_pivot() : wobbling();
    const Composer picture = composer(body, spec);
    for (double t = 0.0; t <= spec.duration; t += 0.0613) {
      const DrawList list = picture.at(t);
      for (const DrawItem& item : list.opaque) {
        for (const Vertex& v : item.mesh->vertices) {
          const glm::vec4 clip =
              list.view.clip_from_world * item.world_from_mesh * glm::vec4(v.position, 1.0f);
          ASSERT_TRUE(std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w);
        }
      }
    }
  }
}

TEST(Composer, CameraInsideItsTargetIsAnError) {
  CameraSpec camera;
  camera.eye = Vec3(1, 1, 1);
  camera.target = Vec3(1, 1, 1);
  EXPECT_THROW(composer(prolate_body(), wobbling(), {}, camera), Error);
}

// turning the body by the tolerance moves no drawn point by more than the pixels it was made from
TEST(AttitudeTolerance, IsAnUpperBoundInPixels) {
  const BodySpec body = prolate_body();
  CameraSpec own;
  own.eye = Vec3(1.2, 0.4, 0.3);
  own.target = Vec3::Zero();
  for (const CameraSpec& camera : {CameraSpec{}, own}) {
    const Composer picture = composer(body, wobbling(), {}, camera);
    const double tolerance = attitude_tolerance(camera, 0.1, picture.scale().body, kSize);
    EXPECT_GT(tolerance, 1e-5);
    const Sample s = moving(body, wobbling()).at(1.0);
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
      const Quat error(Eigen::AngleAxisd(tolerance, axis));
      for (const Vec3& tip : {picture.momentum_tip(s), picture.omega_tip(s)}) {
        const Vec2 moved = picture.camera().project(error * tip) - picture.camera().project(tip);
        EXPECT_LE(moved.norm(), 0.1);
      }
    }
  }
}

}  // namespace
}  // namespace polhode
