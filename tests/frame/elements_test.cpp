// SPDX-License-Identifier: MIT
// The table of what can be shown: what is there by default, what is refused, what each name adds.
#include "frame/elements.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "base/error.h"
#include "frame/compose.h"
#include "frame/composers.h"
#include "support/motions.h"
#include "support/on_table.h"
#include "support/show_only.h"

namespace polhode {
namespace {

using test::composer;
using test::cone_body;
using test::prolate_body;
using test::show_only;
using test::spinning_on_pivot;
using test::wobbling;

// the names that a composer shows, in the order of the table
std::vector<std::string> shown(const Composer& picture) {
  std::vector<std::string> names;
  for (const Element& element : elements()) {
    if (picture.shows(element.name)) names.push_back(element.name);
  }
  return names;
}

TEST(Elements, DefaultsFollowTheScene) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(shown(composer(prolate_body(), wobbling())),
            (Names{"body", "space_axes", "omega", "momentum", "space_cone", "body_cone"}));
  EXPECT_EQ(
      shown(composer(cone_body(), spinning_on_pivot())),
      (Names{"body", "space_axes", "omega", "momentum", "precession_cone", "pivot", "floor"}));

  MotionSpec hanging = spinning_on_pivot();
  hanging.attitude.zxz = Vec3(0.0, 2.8, 0.0);
  hanging.spin.rates = Vec3(0.0, 0.0, 1.0);
  EXPECT_EQ(shown(composer(cone_body(), hanging)),
            (Names{"body", "space_axes", "omega", "momentum", "precession_cone", "hinge"}));
  ShowSpec rates;
  rates["euler_rates"] = true;
  EXPECT_TRUE(composer(prolate_body(), wobbling(), rates).shows("sum"));

  MotionSpec steady = wobbling();
  steady.spin.body = Vec3(0, 0, 3);
  EXPECT_FALSE(composer(prolate_body(), steady).shows("space_cone")) << "no wobble, no cone";
}

TEST(Elements, AskingForWhatIsNotThereIsAnError) {
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

// on a table, with friction that slows it all the time
MotionSpec sliding() {
  MotionSpec spec = wobbling();
  spec.hold = "table";
  spec.friction = FrictionSpec{};
  spec.friction->kind = "viscous";
  spec.friction->c = 4.0;
  spec.duration = 1.0;
  return spec;
}

// friction that is a speck beside the normal force would have no name
TEST(Elements, TinyFrictionIsNotDrawn) {
  MotionSpec spec = sliding();
  spec.friction->c = 1e-3;
  const Composer picture = test::composer(prolate_body(), spec, show_only("contact"));
  const Glyphs glyphs = picture.glyphs_at(picture.scenery().motion.at(0.5));
  ASSERT_EQ(glyphs.labels.size(), 1u);
  EXPECT_EQ(glyphs.labels[0].markup, "<b>N</b>");
  EXPECT_EQ(glyphs.arrows.size(), 1u);
}

// a camera along the table sees the path of the contact up to a distance, at every moment the same
TEST(Elements, APathThatIsCutOffEndsEvenly) {
  MotionSpec spec = test::on_table(1.5, test::coulomb(0.1));
  spec.velocity = Vec3(0.6, 0.0, 0.0);
  spec.spin.space = Vec3(3.0, 8.0, 0.0);
  CameraSpec camera;
  camera.follow = "center";
  const Composer picture = composer(test::ball_body(), spec, show_only("contact_trail"), camera);
  const Scenery& scenery = picture.scenery();
  for (double t = 0.8; t < 1.5; t += 0.007) {
    const Sample now = scenery.motion.at(t);
    const Glyphs glyphs = picture.glyphs_at(now);
    const auto drawn = std::find_if(glyphs.paths.begin(),
                                    glyphs.paths.end(),
                                    [](const PathGlyph& path) { return !path.on_body; });
    ASSERT_NE(drawn, glyphs.paths.end());
    const Sample then = scenery.motion.at(drawn->from);
    const double away = (now.center_S - then.center_S).norm() / scenery.scale.body;
    EXPECT_NEAR(away, 4.2, 2e-3) << t;
  }
}

TEST(Elements, EachNameAddsItsOwnGlyphs) {
  struct Count {
    std::size_t arrows = 0, meshes = 0, paths = 0, rods = 0, arcs = 0, cones = 0;
    std::size_t floors = 0, ghosts = 0, shells = 0, sheets = 0;
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
                                               {"hinge", {.meshes = 1}},
                                               {"gimbals", {.meshes = 3, .rods = 3}},
                                               {"frame_rotation", {.arrows = 1}},
                                               {"ensemble", {.meshes = 3, .ghosts = 2}},
                                               {"forces", {.arrows = 3, .meshes = 2}},
                                               {"contact", {.arrows = 2, .meshes = 1}},
                                               {"contact_trail", {.paths = 2}},
                                               {"slip", {.arrows = 1}},
                                               {"velocity_field", {.arrows = 48}},
                                               {"fixed_frame", {.arrows = 4}},
                                               {"angles", {.rods = 6, .arcs = 3}},
                                               {"tilt", {.rods = 2, .arcs = 1}},
                                               {"ghosts", {.ghosts = 5}},
                                               {"omega_components", {.arrows = 3}},
                                               {"euler_rates", {.arrows = 3}},
                                               {"sum", {.arrows = 3, .rods = 17}},
                                               {"torque", {.arrows = 2}},
                                               {"gravity", {.arrows = 1}},
                                               {"axis_plane", {.meshes = 1, .sheets = 1}},
                                               {"ellipsoid", {.shells = 1}},
                                               {"plane", {.meshes = 2, .sheets = 1}},
                                               {"polhode", {.meshes = 1}},
                                               {"polhodes", {.meshes = 36}},
                                               {"herpolhode", {.paths = 1}},
                                               {"binet", {.meshes = 2, .shells = 1}},
                                               {"trail", {.paths = 1, .rods = 1}},
                                               {"trail_sphere", {.shells = 1}},
                                               {"floor", {.floors = 1}}};
  ASSERT_EQ(wanted.size(), elements().size() + 1) << "a name without its glyphs here";
  for (const auto& [name, count] : wanted) {
    SCOPED_TRACE(name);
    const bool heavy = name == "precession_cone" || name == "pivot" || name == "hinge" ||
                       name == "gimbals" || name == "gravity" || name == "torque" ||
                       name == "ghosts" || name == "frame_rotation";
    const bool on_table = name == "contact" || name == "contact_trail" || name == "slip";
    MotionSpec motion = heavy              ? spinning_on_pivot()
                        : name == "forces" ? pulled()
                        : on_table         ? sliding()
                                           : wobbling();
    if (name == "frame_rotation") motion.frame_rotation = Vec3(0.0, 0.1, 0.2);
    const BodySpec body = heavy ? cone_body() : prolate_body();
    Shared shared;
    if (name == "ensemble") {
      MotionSpec other = motion;
      other.attitude = {};
      other.attitude.zxz = Vec3(0.3, 1.0, 0.0);
      // one that is where the body is has no pale body, but its point
      shared.ensemble = {
          test::moving(body, motion), test::moving(body, other), test::moving(body, other)};
    }
    Staging staging;
    staging.timeline = Timeline({}, motion.duration, 1.0);
    ShowSpec show = show_only(name);
    if (name == "sum") show["euler_rates"] = true;
    const Composer picture(
        test::moving(body, motion), body, staging, show, {}, test::kSize, shared);
    const Glyphs glyphs = picture.glyphs_at(picture.scenery().motion.at(0.5));
    const Count found{glyphs.arrows.size(),
                      glyphs.meshes.size(),
                      glyphs.paths.size(),
                      glyphs.rods.size(),
                      glyphs.arcs.size(),
                      glyphs.cones.size(),
                      glyphs.floors.size(),
                      glyphs.ghosts.size(),
                      glyphs.shells.size(),
                      glyphs.sheets.size()};
    EXPECT_TRUE(found == count) << ::testing::PrintToString(std::vector<std::size_t>{found.arrows,
                                                                                     found.meshes,
                                                                                     found.paths,
                                                                                     found.rods,
                                                                                     found.arcs,
                                                                                     found.cones,
                                                                                     found.floors,
                                                                                     found.ghosts,
                                                                                     found.shells,
                                                                                     found.sheets});
  }
}

// the longest vector of the whole film has the length that the table of scales promises
TEST(Elements, LongestVectorsHaveTheirFullLength) {
  const Composer picture = composer(prolate_body(), wobbling());
  const Scenery& scenery = picture.scenery();
  double omega = 0.0, momentum = 0.0;
  for (const double t : framing_times(scenery.motion)) {
    const Sample s = scenery.motion.at(t);
    omega = std::max(omega, (omega_tip(scenery, s) - s.reference_S).norm());
    momentum = std::max(momentum, (momentum_tip(scenery, s) - s.reference_S).norm());
  }
  EXPECT_NEAR(omega, 1.3 * scenery.scale.body, 1e-12);
  EXPECT_NEAR(momentum, kReachOfVectors * scenery.scale.body, 1e-12);
  // an ellipsoid reaches as far as its longest semi-axis; corners of its mesh stand a little out
  EXPECT_NEAR(scenery.scale.body, 0.2, 0.2 * 2e-3);
}

}  // namespace
}  // namespace polhode
