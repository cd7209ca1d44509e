// SPDX-License-Identifier: MIT
#include "frame/compose.h"

#include <map>

#include <gtest/gtest.h>

#include "base/error.h"
#include "math/so3.h"
#include "support/motions.h"
#include "support/show_only.h"

namespace polhode {
namespace {

using test::cone_body;
using test::moving;
using test::oblate_body;
using test::prolate_body;
using test::show_only;
using test::spinning_on_pivot;
using test::wobbling;

constexpr PictureSize kSize{640, 360};

Composer composer(const BodySpec& body,
                  const MotionSpec& motion,
                  const ShowSpec& show = {},
                  const CameraSpec& camera = {}) {
  return {moving(body, motion), body, camera, show, ThemeSpec{}, kSize};
}

// both cones hold omega on their surface and end at its tip, at every time
TEST(Cones, TouchAlongOmega) {
  for (const BodySpec& body : {prolate_body(), oblate_body()}) {
    const Motion motion = moving(body, wobbling());
    const Composer picture = composer(body, wobbling());
    for (double t = 0.0; t <= 4.0; t += 0.37) {
      const Sample s = motion.at(t);
      const std::vector<Cone> cones = picture.glyphs_at(s).cones;
      ASSERT_EQ(cones.size(), 2u);
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

// the names that a composer shows, in the order of the table
std::vector<std::string> shown(const Composer& picture) {
  std::vector<std::string> names;
  for (const Element& element : elements()) {
    if (picture.shows(element.name)) names.push_back(element.name);
  }
  return names;
}

TEST(Shown, DefaultsFollowTheScene) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(shown(composer(prolate_body(), wobbling())),
            (Names{"body", "space_axes", "omega", "momentum", "space_cone", "body_cone"}));
  EXPECT_EQ(shown(composer(cone_body(), spinning_on_pivot())),
            (Names{"body", "space_axes", "omega", "momentum", "precession_cone", "pivot"}));

  MotionSpec steady = wobbling();
  steady.spin.body = Vec3(0, 0, 3);
  EXPECT_FALSE(composer(prolate_body(), steady).shows("space_cone")) << "no wobble, no cone";
}

TEST(Shown, AskingForWhatIsNotThereIsAnError) {
  ShowSpec cones;
  cones["space_cone"] = true;
  ShowSpec stand;
  stand["pivot"] = true;
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

// a force, a couple and a spring
MotionSpec pulled() {
  MotionSpec spec = wobbling();
  spec.torque.resize(3);
  spec.torque[0].kind = "force";
  spec.torque[0].space = Vec3(0, 0, 0.1);
  spec.torque[1].kind = "couple";
  spec.torque[1].body = Vec3(0, 0.1, 0);
  spec.torque[1].at = Vec3(0, 0, 0.1);
  spec.torque[1].opposite = Vec3(0, 0, -0.1);
  spec.torque[2].kind = "spring";
  spec.torque[2].k = 0.2;
  return spec;
}

TEST(Shown, EachNameAddsItsOwnMarks) {
  struct Count {
    std::size_t arrows = 0, meshes = 0, rods = 0, arcs = 0, cones = 0;
    std::size_t shades = 0, ghosts = 0, shells = 0, sheets = 0;
    bool operator==(const Count&) const = default;
  };
  const std::map<std::string, Count> wanted = {{"", {}},
                                               {"body", {.meshes = 1}},
                                               {"axes", {.arrows = 3}},
                                               {"space_axes", {.arrows = 3}},
                                               {"omega", {.arrows = 1}},
                                               {"momentum", {.arrows = 1}},
                                               {"space_cone", {.cones = 1}},
                                               {"body_cone", {.cones = 1}},
                                               {"precession_cone", {.cones = 1}},
                                               {"pivot", {.meshes = 1}},
                                               {"forces", {.arrows = 3, .rods = 1}},
                                               {"velocity_field", {.arrows = 48}},
                                               {"fixed_frame", {.arrows = 4}},
                                               {"angles", {.arcs = 3}},
                                               {"tilt", {.arcs = 1}},
                                               {"ghosts", {.ghosts = 5}},
                                               {"omega_components", {.arrows = 3}},
                                               {"euler_rates", {.arrows = 3}},
                                               {"torque", {.arrows = 1}},
                                               {"gravity", {.arrows = 1}},
                                               {"axis_plane", {.meshes = 1, .sheets = 1}},
                                               {"ellipsoid", {.shells = 1}},
                                               {"plane", {.meshes = 1, .sheets = 1}},
                                               {"polhode", {.meshes = 1}},
                                               {"polhodes", {.meshes = 36}},
                                               {"herpolhode", {.meshes = 1}},
                                               {"binet", {.meshes = 2, .shells = 1}},
                                               {"trail", {.meshes = 1}},
                                               {"trail_sphere", {.shells = 1}},
                                               {"floor", {.meshes = 1, .shades = 1}}};
  ASSERT_EQ(wanted.size(), elements().size() + 1) << "a name without its glyphs here";
  for (const auto& [name, count] : wanted) {
    SCOPED_TRACE(name);
    const bool heavy = name == "precession_cone" || name == "pivot" || name == "gravity" ||
                       name == "torque" || name == "ghosts";
    const MotionSpec motion = heavy              ? spinning_on_pivot()
                              : name == "forces" ? pulled()
                                                 : wobbling();
    const Composer picture =
        composer(heavy ? cone_body() : prolate_body(), motion, show_only(name));
    const Glyphs glyphs = picture.glyphs_at(picture.scenery().motion.at(0.5));
    const Count found{glyphs.arrows.size(),
                      glyphs.meshes.size(),
                      glyphs.rods.size(),
                      glyphs.arcs.size(),
                      glyphs.cones.size(),
                      glyphs.shades.size(),
                      glyphs.ghosts.size(),
                      glyphs.shells.size(),
                      glyphs.sheets.size()};
    EXPECT_TRUE(found == count) << ::testing::PrintToString(std::vector<std::size_t>{found.arrows,
                                                                                     found.meshes,
                                                                                     found.rods,
                                                                                     found.arcs,
                                                                                     found.cones,
                                                                                     found.shades,
                                                                                     found.ghosts,
                                                                                     found.shells,
                                                                                     found.sheets});
  }
}

// Omega x r, measured: the tips are where the points are a moment later
TEST(VelocityField, PointsWhereThePointsGo) {
  MotionSpec spec = wobbling();
  spec.velocity = Vec3(0.1, -0.2, 0.3);
  const Composer picture = composer(prolate_body(), spec, show_only("velocity_field"));
  const Motion& motion = picture.scenery().motion;
  const double h = 1e-5;
  const Glyphs before = picture.glyphs_at(motion.at(0.7 - h));
  const Glyphs now = picture.glyphs_at(motion.at(0.7));
  const Glyphs after = picture.glyphs_at(motion.at(0.7 + h));
  double longest = 0.0;
  for (std::size_t i = 0; i < now.arrows.size(); ++i) {
    const Vec3 velocity = (after.arrows[i].from - before.arrows[i].from) / (2.0 * h);
    const Vec3 along = now.arrows[i].tip - now.arrows[i].from;
    EXPECT_LT((picture.scenery().scale.velocity * velocity - along).norm(), 1e-8);
    longest = std::max(longest, along.norm());
  }
  EXPECT_GT(longest, 0.3 * picture.scenery().scale.body);
}

// figure 1 of the notes: r = R + r~, and arcs from each space axis to its body axis
TEST(FixedFrame, VectorsCloseAndArcsEndOnTheAxes) {
  MotionSpec spec = wobbling();
  spec.position = Vec3(0.3, 0.5, 0.2);
  ShowSpec show = show_only("fixed_frame");
  show["angles"] = true;
  show.points = {Vec3(0.05, 0.02, 0.1)};
  const Composer picture = composer(prolate_body(), spec, show);
  const Sample s = picture.scenery().motion.at(1.1);
  const Glyphs glyphs = picture.glyphs_at(s);
  ASSERT_EQ(glyphs.arrows.size(), 6u);
  const ArrowGlyph& R = glyphs.arrows[3];
  const ArrowGlyph& r_tilde = glyphs.arrows[4];
  const ArrowGlyph& r = glyphs.arrows[5];
  EXPECT_EQ(R.from, Vec3::Zero());
  EXPECT_EQ(R.tip, s.reference_S);
  EXPECT_EQ(r_tilde.from, s.reference_S);
  EXPECT_LT(((R.tip - R.from) + (r_tilde.tip - r_tilde.from) - (r.tip - r.from)).norm(), 1e-15);
  EXPECT_LT((glyphs.meshes[0].space_from_mesh.translation() - r.tip).norm(), 1e-15);
  for (int i = 0; i < 3; ++i) {
    const ArcGlyph& arc = glyphs.arcs[static_cast<std::size_t>(i)];
    EXPECT_LT((point_of(arc, 0.0) - arc.center - arc.radius * Vec3::Unit(i)).norm(), 1e-15);
    EXPECT_LT((point_of(arc, 1.0) - arc.center - arc.radius * (s.q_SB * Vec3::Unit(i))).norm(),
              1e-15);
    EXPECT_NEAR((point_of(arc, 0.4) - arc.center).norm(), arc.radius, 1e-15);
  }
}

// far side, then near side; cones would not know where to go
TEST(BodyOpacity, SeenThrough) {
  ShowSpec show = show_only("body");
  show.body_opacity = 0.4;
  const DrawList list = composer(prolate_body(), wobbling(), show).at(0.3);
  EXPECT_TRUE(list.opaque.empty());
  ASSERT_EQ(list.translucent.size(), 2u);
  EXPECT_EQ(list.translucent[0].faces, Faces::back);
  EXPECT_EQ(list.translucent[1].faces, Faces::front);
  show["space_cone"] = true;
  try {
    composer(prolate_body(), wobbling(), show);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.place().key, "show.body_opacity");
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
    const std::vector<Cone> cones = picture.glyphs_at(s).cones;
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
    const double tolerance = attitude_tolerance(camera, 0.1, picture.scenery().scale.body, kSize);
    EXPECT_GT(tolerance, 1e-5);
    const Sample s = moving(body, wobbling()).at(1.0);
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
      const Quat error(Eigen::AngleAxisd(tolerance, axis));
      for (const Vec3& tip :
           {momentum_tip(picture.scenery(), s), omega_tip(picture.scenery(), s)}) {
        const Vec2 moved = picture.camera().project(error * tip) - picture.camera().project(tip);
        EXPECT_LE(moved.norm(), 0.1);
      }
    }
  }
}

}  // namespace
}  // namespace polhode
