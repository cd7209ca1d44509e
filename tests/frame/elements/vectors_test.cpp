// SPDX-License-Identifier: MIT
// Arrows, against the motion that they belong to.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "frame/compose.h"
#include "frame/composers.h"
#include "frame/to_glm.h"
#include "support/motions.h"
#include "support/show_only.h"

namespace polhode {
namespace {

using test::composer;
using test::moving;
using test::prolate_body;
using test::show_only;
using test::wobbling;

// of all labels of the first picture (markup)
std::vector<std::string> names_of(const Composer& picture) {
  std::vector<std::string> names;
  for (const LabelGlyph& label : picture.glyphs_at(picture.scenery().motion.at(0.0)).labels)
    names.push_back(label.markup);
  return names;
}

// a scene may call vectors as it likes; its words are no markup
TEST(Vectors, HaveTheNamesThatTheSceneGives) {
  ShowSpec show = show_only("omega");
  show["momentum"] = true;
  const auto names = [&] {
    return names_of(composer(prolate_body(), wobbling(), show));
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names(), (Names{"<b>Ω</b>", "<b>L</b>"}));
  show.names = VectorNames{"ω", "a<b", {}, {}, {}, {}, {}, {}};
  EXPECT_EQ(names(), (Names{"<b>ω</b>", "<b>a&lt;b</b>"}));
  show.names = VectorNames{"", {}, {}, {}, {}, {}, {}, {}};
  EXPECT_EQ(names(), (Names{"<b>L</b>"})) << "none";
  show["space_axes"] = true;
  show["omega"] = false;
  show.names = VectorNames{{}, {}, {}, {}, {}, "north", {}, ""};
  EXPECT_EQ(names(), (Names{"<b>north</b>", "<i>Y</i>", "<b>L</b>"}));
}

// Omega x r, measured: the tips are where the points are a moment later
TEST(Vectors, VelocitiesPointWhereThePointsGo) {
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

// the velocity of the reference point and that of one of the fastest points have their names
TEST(Vectors, TheVelocityFieldIsNamed) {
  MotionSpec spec = wobbling();
  const auto names = [&] {
    std::vector<std::string> found;
    const Composer picture = composer(prolate_body(), spec, show_only("velocity_field"));
    for (const LabelGlyph& label : picture.glyphs_at(picture.scenery().motion.at(0.0)).labels)
      found.push_back(label.markup);
    return found;
  };
  using Names = std::vector<std::string>;
  const std::string field = "<b>V</b> + <b>Ω</b> × <b>r</b>";
  EXPECT_EQ(names(), (Names{field})) << "its centre is at rest";
  spec.velocity = Vec3(0.1, -0.2, 0.3);
  EXPECT_EQ(names(), (Names{field, "<b>V</b>"}));
}

// beside the arrows that reach farthest, it moves as they do
TEST(Vectors, TheNameOfTheVelocityFieldDoesNotJump) {
  const Composer picture = composer(prolate_body(), wobbling(), show_only("velocity_field"));
  const double duration = picture.scenery().motion.duration();
  constexpr int kLooks = 4000;
  std::optional<Vec2> before;
  double farthest = 0.0;
  for (int i = 0; i <= kLooks; ++i) {
    const LabelView view = picture.label_view(duration * i / kLooks, duration);
    ASSERT_EQ(view.labels.size(), 1U);
    const Vec2 now = view.labels.front().at;
    if (before) farthest = std::max(farthest, (now - *before).norm());
    before = now;
  }
  EXPECT_LT(farthest, 3.0) << "pixels of a picture of 640 by 360, in a thousandth of the motion";
}

// the place of a body has its name wherever it is
TEST(Vectors, TheWayToTheBodyIsNamedInEveryDirection) {
  for (const Vec3& place : {Vec3(0, 0, 0.7), Vec3(0.7, 0, 0), Vec3(0.1, -0.6, 0.2)}) {
    MotionSpec spec = wobbling();
    spec.position = place;
    const Composer picture = composer(prolate_body(), spec, show_only("fixed_frame"));
    const std::vector<LabelGlyph> labels =
        picture.glyphs_at(picture.scenery().motion.at(0.0)).labels;
    EXPECT_EQ(std::count_if(labels.begin(),
                            labels.end(),
                            [](const LabelGlyph& label) { return label.markup == "<b>R</b>"; }),
              1)
        << place.transpose();
  }
}

// figure 1 of the notes: r = R + r~
TEST(Vectors, PositionsCloseATriangle) {
  MotionSpec spec = wobbling();
  spec.position = Vec3(0.3, 0.5, 0.2);
  ShowSpec show = show_only("fixed_frame");
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

  // each by its name: r~ at its tip, r and R beside their middles, away from one another
  const auto label = [&](const char* name) {
    return *std::find_if(glyphs.labels.begin(), glyphs.labels.end(), [&](const LabelGlyph& l) {
      return l.markup == name;
    });
  };
  EXPECT_EQ(label("<b>r̃</b>").at, 0.5 * (r_tilde.from + r_tilde.tip));
  EXPECT_EQ(label("<b>r</b>").at, Vec3(0.5 * r.tip));
  EXPECT_EQ(label("<b>R</b>").at, Vec3(0.5 * R.tip));
  EXPECT_LT(label("<b>r</b>").away.dot(label("<b>R</b>").away), 0.0);
}

// one point is r, several are numbered
TEST(Vectors, SeveralPointsAreNumbered) {
  ShowSpec show = show_only("momentum");
  show["momentum"] = false;
  show.points = {Vec3(0.05, 0.02, 0.1)};
  EXPECT_EQ(names_of(composer(prolate_body(), wobbling(), show)),
            (std::vector<std::string>{"<b>r</b>"}));
  show.points.push_back(Vec3(0.05, -0.02, -0.1));
  EXPECT_EQ(names_of(composer(prolate_body(), wobbling(), show)),
            (std::vector<std::string>{"<b>r</b><sub>1</sub>", "<b>r</b><sub>2</sub>"}));
}

// where the origin is the reference point, r and r~ are one
TEST(Vectors, PointsOfABodyAtTheOriginHaveTheirNames) {
  ShowSpec show = show_only("fixed_frame");
  show.points = {Vec3(0.05, 0.02, 0.1), Vec3(0.05, -0.02, -0.1)};
  const std::vector<std::string> names = names_of(composer(prolate_body(), wobbling(), show));
  EXPECT_EQ(std::count(names.begin(), names.end(), "<b>r</b><sub>1</sub>"), 1);
  EXPECT_EQ(std::count(names.begin(), names.end(), "<b>r</b><sub>2</sub>"), 1);
}

// two sets of axes at one place have one set of names
TEST(Vectors, AxesAtOnePlaceAreNamedOnce) {
  ShowSpec show = show_only("fixed_frame");
  show.asked.erase("space_axes");  // shown by default
  const std::vector<std::string> once = {"<i>X</i>", "<i>Y</i>", "<i>Z</i>"};
  EXPECT_EQ(names_of(composer(prolate_body(), wobbling(), show)), once);
  show["space_axes"] = false;
  EXPECT_EQ(names_of(composer(prolate_body(), wobbling(), show)), once);
  show["space_axes"] = true;
  EXPECT_EQ(names_of(composer(prolate_body(), wobbling(), show)), once);
  MotionSpec away = wobbling();
  away.position = Vec3(0.3, 0.5, 0.2);
  EXPECT_EQ(names_of(composer(prolate_body(), away, show)).size(), 7u) << "and R";
}

// a spring reaches from the point of the body to where it is held, in any direction and however
// short it is, and is always as thick
TEST(Vectors, ASpringReachesFromTheBodyToWhereItIsHeld) {
  const Vec3 at(0.02, 0.01, 0.05);
  const MotionSpec still;
  const Vec3 held = moving(prolate_body(), still).at(0.0).reference_S + at;
  for (const Vec3& along :
       {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0.3, -0.8, 0.1), Vec3(-1e-9, 0, 0), Vec3(0, 0, 0)}) {
    SCOPED_TRACE(along.transpose());
    MotionSpec spec = still;
    spec.torque.resize(1);
    spec.torque[0].kind = "spring";
    spec.torque[0].k = 0.2;
    spec.torque[0].at = at;
    spec.torque[0].to = held + along;
    const Composer picture = composer(prolate_body(), spec, show_only("forces"));
    const Glyphs glyphs = picture.glyphs_at(picture.scenery().motion.at(0.0));
    ASSERT_EQ(glyphs.meshes.size(), 2u) << "the coil, and a ball that holds it";
    EXPECT_LT((glyphs.meshes[1].space_from_mesh.translation() - held - along).norm(), 1e-12);
    const double size = picture.scenery().scale.body;
    const Placement& place = glyphs.meshes[0].space_from_mesh;
    EXPECT_NEAR(place.linear().determinant(), std::pow(size, 3), 1e-12 * std::pow(size, 3));
    // the flat ends of the wire are about the two points
    const std::vector<Vertex>& vertices = glyphs.meshes[0].mesh->vertices;
    double to_body = size, to_anchor = size, off_axis = 0.0;
    for (const Vertex& vertex : vertices) {
      const Vec3 point = place * to_eigen(vertex.position);
      ASSERT_TRUE(point.allFinite());
      to_body = std::min(to_body, (point - held).norm());
      to_anchor = std::min(to_anchor, (point - held - along).norm());
      const Vec3 axis = place.linear().col(2) / size;
      off_axis = std::max(off_axis, (point - held).cross(axis).norm());
    }
    EXPECT_LT(to_body, 1e-6 * size);
    EXPECT_LT(to_anchor, 1e-5 * size);
    EXPECT_NEAR(off_axis / size, 0.13, 0.002);  // of the coil and its wire
  }
}

// the sums that make components what they are
TEST(Vectors, ComponentsAddUpToOmega) {
  for (const char* name : {"omega_components", "euler_rates"}) {
    const BodySpec body = test::brick_body();
    const Composer picture(test::moving(body, test::wobbling()),
                           body,
                           CameraSpec{},
                           test::show_only(name),
                           {},
                           {640, 360});
    const Sample now = picture.scenery().motion.at(1.1);
    Vec3 sum = Vec3::Zero();
    for (const ArrowGlyph& arrow : picture.glyphs_at(now).arrows)
      sum += arrow.tip - arrow.from;
    EXPECT_LT((sum - picture.scenery().scale.omega * now.w_S).norm(), 1e-12) << name;
  }
}

// dL/dt is the torque that is drawn
TEST(Vectors, TorqueIsTheRateOfL) {
  const BodySpec body = test::cone_body();
  const Composer picture(test::moving(body, test::spinning_on_pivot()),
                         body,
                         CameraSpec{},
                         test::show_only("torque"),
                         {},
                         {640, 360});
  const Motion& motion = picture.scenery().motion;
  const double h = 1e-5;
  for (const double t : {0.3, 1.0}) {
    const Vec3 rate = (motion.at(t + h).L_S - motion.at(t - h).L_S) / (2.0 * h);
    const ArrowGlyph arrow = picture.glyphs_at(motion.at(t)).arrows.at(0);
    const Vec3 drawn = (arrow.tip - arrow.from) / picture.scenery().scale.torque;
    EXPECT_LT((drawn - rate).norm(), 1e-6 * rate.norm());
  }
}

// a couple is two forces that cancel; its moment is the arm times the force
TEST(Vectors, ACoupleIsTwoOppositeForces) {
  MotionSpec spec = wobbling();
  spec.torque.resize(1);
  spec.torque[0].kind = "couple";
  spec.torque[0].body = Vec3(0, 0.1, 0);
  spec.torque[0].at = Vec3(0, 0, 0.1);
  spec.torque[0].opposite = Vec3(0, 0, -0.1);
  const Composer picture = composer(prolate_body(), spec, show_only("forces"));
  const Sample s = picture.scenery().motion.at(0.9);
  const std::vector<ArrowGlyph> arrows = picture.glyphs_at(s).arrows;
  ASSERT_EQ(arrows.size(), 2u);
  const Vec3 one = arrows[0].tip - arrows[0].from;
  const Vec3 other = arrows[1].tip - arrows[1].from;
  EXPECT_LT((one + other).norm(), 1e-15);
  const double size = picture.scenery().scale.force;
  EXPECT_LT((one - size * (s.q_SB * Vec3(0, 0.1, 0))).norm(), 1e-12);
  EXPECT_LT((arrows[0].from - arrows[1].from - s.q_SB * Vec3(0, 0, 0.2)).norm(), 1e-12);
}

// the weight acts on the centre of mass, three quarters up a cone from its apex
TEST(Vectors, GravityPullsTheCentreOfMassDown) {
  const Composer picture =
      composer(test::cone_body(), test::spinning_on_pivot(), show_only("gravity"));
  const Sample s = picture.scenery().motion.at(0.7);
  const ArrowGlyph arrow = picture.glyphs_at(s).arrows.at(0);
  EXPECT_LT((arrow.from - s.q_SB * Vec3(0, 0, 0.75 * 0.05)).norm(), 1e-12);
  const Vec3 down = (arrow.tip - arrow.from).normalized();
  EXPECT_LT((down + Vec3::UnitZ()).norm(), 1e-12);
}

}  // namespace
}  // namespace polhode
