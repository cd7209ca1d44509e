// SPDX-License-Identifier: MIT
#include "frame/compose.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "frame/composers.h"
#include "frame/elements/parts.h"
#include "math/so3.h"
#include "support/motions.h"
#include "support/show_only.h"

namespace polhode {
namespace {

using test::composer;
using test::cone_body;
using test::kSize;
using test::moving;
using test::prolate_body;
using test::show_only;
using test::spinning_on_pivot;
using test::wobbling;

// a coil has as many corners as its size on the screen needs: a small one has far fewer
TEST(Compose, ASpringIsAsFineAsItIsDrawn) {
  MotionSpec spec;
  spec.torque.resize(1);
  spec.torque[0].kind = "spring";
  spec.torque[0].k = 0.2;
  spec.torque[0].to = Vec3(0, 0, 0.3);
  const auto corners = [&](double zoom) {
    CameraSpec camera;
    camera.zoom = zoom;
    const Composer picture(moving(prolate_body(), spec),
                           prolate_body(),
                           camera,
                           show_only("forces"),
                           ThemeSpec{},
                           {1920, 1080});
    return picture.glyphs_at(picture.scenery().motion.at(0.0)).meshes.at(0).mesh->vertices.size();
  };
  EXPECT_LT(corners(0.2), corners(8.0) / 2);
}

// the pin from the body to its trail is round where it is thick
TEST(Compose, ARodIsAsFineAsItIsDrawn) {
  CameraSpec camera;
  camera.zoom = 6.0;
  const Composer picture(moving(prolate_body(), wobbling()),
                         prolate_body(),
                         camera,
                         show_only("trail"),
                         ThemeSpec{},
                         {3840, 2160});
  const DrawList list = picture.at(0.0);
  ASSERT_EQ(list.opaque.size(), 1u);  // there is no trail yet
  EXPECT_GT(list.opaque[0].mesh->vertices.size(), unit_cylinder(8).vertices.size());
}

// where a method fails, the last vectors say nothing; the body is where it came to
TEST(Compose, VectorsEndWhereTheirMotionFails) {
  const Motion motion = moving(prolate_body(), wobbling());
  ShowSpec show;
  show["angles"] = true;
  const Composer whole = composer(prolate_body(), wobbling(), show);
  const Composer failing(whole, motion, 1.0);
  const auto counts = [&](const Composer& picture, double t) {
    return GlyphCounts(picture.glyphs_at(motion.at(t), t));
  };
  EXPECT_EQ(counts(failing, 0.9).arrows, counts(whole, 0.9).arrows);
  EXPECT_EQ(counts(failing, 0.9).cones, 2u);
  const GlyphCounts later = counts(failing, 1.0);
  EXPECT_EQ(later.arrows + later.cones + later.arcs + later.labels, 0u);
  EXPECT_EQ(later.meshes, counts(whole, 1.0).meshes);
  EXPECT_GT(later.meshes, 0u);
  EXPECT_EQ(failing.glyphs_at(motion.at(0.9), 0.9).meshes.front().material.fade, 1.0f);
  EXPECT_LT(failing.glyphs_at(motion.at(1.0), 1.0).meshes.front().material.fade, 0.5f)
      << "not as a body at rest";
}

// a vector inside a thicker one, or behind it, has no name: it would be read as that of the other
TEST(Compose, OnlyVectorsThatAreSeenAreNamed) {
  const auto has_name = [](const MotionSpec& spec, const Vec3& eye) {
    CameraSpec camera;
    camera.eye = eye;
    camera.target = Vec3::Zero();
    ShowSpec show = show_only("space_axes");
    show["omega"] = true;
    const std::vector<SeenLabel> labels =
        composer(prolate_body(), spec, show, camera).label_view(0.0, 1.0).labels;
    return std::any_of(labels.begin(), labels.end(), [](const SeenLabel& label) {
      return label.markup == "<i>X</i>" && label.fade > 0.99f;
    });
  };
  MotionSpec spec = wobbling();
  const Vec3 side(0.3, 4.0, 1.0);
  // the arrow of the angular velocity is longer than an axis, and thicker
  spec.spin.body = Vec3(0.0, 0.0, 3.0);
  EXPECT_TRUE(has_name(spec, side)) << "the other is elsewhere";
  spec.spin.body = {};
  spec.spin.space = Vec3(3.0, 0.0, 0.0);
  EXPECT_FALSE(has_name(spec, side)) << "inside the other";
  spec.spin.space = Vec3(3.0, 0.9, 0.0);
  EXPECT_TRUE(has_name(spec, Vec3(0, 0, 5))) << "beside the other";
  EXPECT_FALSE(has_name(spec, Vec3(-0.4, 4.0, 0.0))) << "behind the other";
  EXPECT_TRUE(has_name(spec, Vec3(-0.4, -4.0, 0.0))) << "before the other";
}

// far side, then near side; cones would not know where to go
TEST(Compose, BodiesThatAreSeenThroughHaveTwoSides) {
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

// a frame is a function of its time alone
TEST(Compose, AFrameIsAFunctionOfItsTime) {
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
TEST(Compose, AutomaticCameraKeepsEverythingInside) {
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

TEST(Compose, CameraInsideItsTargetIsAnError) {
  CameraSpec camera;
  camera.eye = Vec3(1, 1, 1);
  camera.target = Vec3(1, 1, 1);
  EXPECT_THROW(composer(prolate_body(), wobbling(), {}, camera), Error);
}

// a thing that comes is drawn over what is there, and leaves it as it was when it is not there yet
TEST(Compose, WhatIsNotThereYetIsNotDrawn) {
  const BodySpec body = test::prolate_body();
  const Motion motion = test::moving(body, test::wobbling());
  StoryStep omega_comes;
  omega_comes.at = omega_comes.hold = 1.0;
  omega_comes.show = {"omega"};
  const Staging staging{CameraSpec{}, {}, Timeline({omega_comes}, motion.duration(), 1.0), {}};
  const Composer told(motion, body, staging, {}, {}, {320, 180});
  const auto count = [&](double film) {
    return told.camera_view(film, 4.0).list.opaque.size();
  };
  EXPECT_EQ(count(0.5) + 2, count(1.8));  // shaft and head
  const CameraView fading = told.camera_view(1.2, 4.0);
  EXPECT_EQ(fading.list.opaque.size(), count(0.5));
  EXPECT_LT(fading.list.translucent.front().material.fade, 1.0f);
}

// wherever the camera goes, and whatever it moves with, all that is shown stays in the frame
TEST(Compose, CamerasKeepEverythingInTheFrame) {
  const PictureSize size{640, 360};
  const BodySpec body = test::cone_body();
  for (const char* follow : {"none", "center", "body", "momentum", "upright"}) {
    for (const double orbit : {0.0, 0.8}) {
      CameraSpec camera;
      camera.follow = follow;
      camera.orbit = orbit;
      MotionSpec spec = test::spinning_on_pivot();
      spec.duration = 1.0;
      const Composer picture(test::moving(body, spec), body, camera, {}, {}, size);
      for (double film = 0.0; film <= 1.0; film += 0.0371) {
        const Camera now = picture.camera_at(film);
        const Sample sample = picture.scenery().motion.at(film);
        std::vector<Vec3> points;
        add_extent(picture.glyphs_at(sample), points);
        for (const Vec3& point : points) {
          const Vec2 pixel = now.project(point);
          EXPECT_GT(pixel.x(), -2.0) << follow << ' ' << orbit << ' ' << film;
          EXPECT_LT(pixel.x(), size.width + 2.0);
          EXPECT_GT(pixel.y(), -2.0);
          EXPECT_LT(pixel.y(), size.height + 2.0);
        }
      }
    }
  }
}

// riding on the body, the body stands still in the picture
TEST(Compose, FollowingTheBodyLeavesItWhereItIs) {
  const BodySpec body = test::prolate_body();
  CameraSpec camera;
  camera.follow = "body";
  const Composer picture(test::moving(body, test::wobbling()), body, camera, {}, {}, {640, 360});
  const Vec3 point_B(0.03, 0.05, 0.15);
  const auto pixel = [&](double t) {
    const Sample now = picture.scenery().motion.at(t);
    return picture.camera_at(t).project(now.reference_S + now.q_SB * point_B);
  };
  for (const double t : {0.6, 1.7, 3.9})
    EXPECT_LT((pixel(t) - pixel(0.0)).norm(), 1e-6);
}

TEST(Compose, CamerasLookAlongL) {
  const BodySpec body = test::prolate_body();
  CameraSpec camera;
  camera.follow = "momentum";
  const Composer picture(test::moving(body, test::wobbling()), body, camera, {}, {}, {640, 360});
  const Sample now = picture.scenery().motion.at(2.0);
  const Camera along = picture.camera_at(2.0);
  // the line of L through the eye's middle is nearly a point
  EXPECT_LT(
      (along.project(momentum_tip(picture.scenery(), now)) - along.project(now.reference_S)).norm(),
      25.0);
}

// smooth moves begin and end at their cameras and do not jump; cuts do
TEST(Compose, MovesAreSmoothAndCutsAreNot) {
  const BodySpec body = test::prolate_body();
  const Motion motion = test::moving(body, test::wobbling());
  ShotSpec moved, cut;
  moved.at = 1.0;
  moved.move = 1.0;
  moved.camera.direction = Vec3(-0.5, 1.0, 0.2);
  cut.at = 3.0;
  cut.camera.direction = Vec3(1.0, 0.0, 0.9);
  const Staging staging{CameraSpec{}, {moved, cut}, Timeline({}, motion.duration(), 1.0), {}};
  const Composer picture(motion, body, staging, {}, {}, {640, 360});
  const double h = 0.01;
  for (double film = 0.0; film + h < 4.0; film += h) {
    const double jump = (picture.camera_at(film + h).eye() - picture.camera_at(film).eye()).norm();
    const bool at_cut = film <= 3.0 && film + h >= 3.0 - 1e-9;
    const bool moving = film > 1.0 - 2 * h && film < 2.0 + h;
    if (at_cut) continue;
    EXPECT_LT(jump, moving ? 0.08 : 1e-12) << film;
  }
  EXPECT_GT((picture.camera_at(3.0).eye() - picture.camera_at(2.99).eye()).norm(), 0.1);
}

// moves between cameras of which one turns, past half a turn from the other
TEST(Compose, MovesBetweenTurningCamerasDoNotJump) {
  const BodySpec body = test::prolate_body();
  const Motion motion = test::moving(body, test::wobbling());
  for (const double orbit : {-1.2, -0.6, 0.6, 1.2}) {
    CameraSpec turning;
    turning.orbit = orbit;
    ShotSpec moved;
    moved.at = 0.5;
    moved.move = 3.0;
    moved.camera.direction = Vec3(-0.5, 1.0, 0.4);
    const Staging staging{turning, {moved}, Timeline({}, motion.duration(), 1.0), {}};
    const Composer picture(motion, body, staging, {}, {}, {640, 360});
    const double h = 1.0 / 240;
    const Vec3 beside(0.1, 0.0, 0.0), above(0.0, 0.0, 0.1);
    for (double film = 0.0; film + h < 4.0; film += h) {
      for (const Vec3& point : {beside, above}) {
        const Vec2 before = picture.camera_at(film).project(point);
        const Vec2 after = picture.camera_at(film + h).project(point);
        EXPECT_LT((after - before).norm(), 4.0) << orbit << " " << film;
      }
    }
  }
}

// a move of days is not followed frame by frame, which would take minutes for each picture
TEST(Compose, ALongMoveBetweenTurningCamerasIsSoonKnown) {
  const BodySpec body = test::prolate_body();
  MotionSpec spec = test::wobbling();
  spec.duration = 1e6;
  CameraSpec turning;
  turning.orbit = 1e-4;
  ShotSpec moved;
  moved.move = 9e5;
  moved.camera.direction = Vec3(-0.5, 1.0, 0.4);
  const Staging staging{turning, {moved}, Timeline({}, spec.duration, 1.0), {}};
  const Composer picture(test::moving(body, spec), body, staging, {}, {}, {64, 36});
  for (const double film : {4e5, 8e5, 8.99e5})
    EXPECT_TRUE(picture.camera_at(film).sees(Vec3::Zero())) << film;
}

// a body that flies and turns
MotionSpec thrown() {
  MotionSpec spec = test::wobbling();
  spec.velocity = Vec3(0.1, 0.7, 0.2);
  return spec;
}

double height_in_picture(const Composer& picture, double t) {
  const Sample now = picture.scenery().motion.at(t);
  const Camera camera = picture.camera_at(t);
  double top = 1e9, bottom = -1e9;
  for (const Vec3& point_B : picture.scenery().hull_B) {
    const double y = camera.project(now.reference_S + now.q_SB * point_B).y();
    top = std::min(top, y);
    bottom = std::max(bottom, y);
  }
  return (bottom - top) / kSize.height;
}

// where the reference point is in the picture at the end, from where it was at the start
double moved_in_picture(const Composer& picture) {
  const auto pixel = [&](double t) {
    return picture.camera_at(t).project(picture.scenery().motion.at(t).reference_S);
  };
  return (pixel(4.0) - pixel(0.0)).norm();
}

TEST(Compose, AThrownBodyIsFollowedAndLarge) {
  const BodySpec body = test::brick_body();
  const Composer followed = composer(body, thrown(), show_only("body"));
  EXPECT_LT(moved_in_picture(followed), 1e-6);
  for (const double t : {0.0, 1.3, 4.0})
    EXPECT_GT(height_in_picture(followed, t), 1.0 / 3.0) << t;

  // what has a place in space keeps the camera there, as does who asks for it
  CameraSpec still;
  still.follow = "none";
  CameraSpec aimed;
  aimed.target = Vec3(0.2, 1.0, 0.3);
  ShowSpec path = show_only("body");
  path.trail_points = {Vec3::Zero()};
  EXPECT_GT(moved_in_picture(composer(body, thrown(), show_only("body"), still)), 100.0);
  EXPECT_GT(moved_in_picture(composer(body, thrown(), show_only("body"), aimed)), 100.0);
  EXPECT_GT(moved_in_picture(composer(body, thrown(), show_only("fixed_frame"))), 100.0);
  EXPECT_GT(moved_in_picture(composer(body, thrown(), show_only("floor"))), 100.0);
  EXPECT_GT(moved_in_picture(composer(body, thrown(), path)), 100.0);
  // the end of a path goes along
  path.trail_s = 0.3;
  EXPECT_LT(moved_in_picture(composer(body, thrown(), path)), 1e-6);
  // a little drift needs nobody to follow
  MotionSpec slow = thrown();
  slow.velocity *= 0.02;
  const double drift = moved_in_picture(composer(body, slow, show_only("body")));
  EXPECT_GT(drift, 1.0);
  EXPECT_LT(drift, 100.0);
}

// a ball that rolls `far` (m) on a table
MotionSpec rolling(double far) {
  MotionSpec spec;
  spec.hold = "table";
  spec.duration = 4.0;
  spec.spin.space = Vec3(0, far / 4.0 / 0.03, 0);
  spec.friction = FrictionSpec{};
  spec.friction->kind = "rolling";
  return spec;
}

BodySpec rolling_ball() {
  BodySpec body;
  body.solid = SolidSpec{};
  body.solid->kind = "sphere";
  body.solid->radius = 0.03;
  body.solid->mass = 0.2;
  return body;
}

// along the table, with the table around it and its lines, which stay where they are in space
TEST(Compose, ABodyThatTravelsOnATableIsFollowedAndLarge) {
  const Composer followed = composer(rolling_ball(), rolling(2.0), ShowSpec{});
  EXPECT_LT(moved_in_picture(followed), 1e-6);
  for (const double t : {0.0, 1.3, 4.0}) {
    EXPECT_GT(height_in_picture(followed, t), 1.0 / 3.0) << t;
    const Sample now = followed.scenery().motion.at(t);
    const FloorGlyph floor = followed.glyphs_at(now).floors.at(0);
    EXPECT_LT((floor.place.translation() - now.center_S).head<2>().norm(), 1e-9);
    EXPECT_EQ(floor.dial.mesh, nullptr);
    ASSERT_NE(floor.grid.mesh, nullptr);
    // the middle of a line is a whole number of spacings from the origin of space
    const auto middle = std::find_if(floor.grid.mesh->vertices.begin(),
                                     floor.grid.mesh->vertices.end(),
                                     [](const Vertex& vertex) { return vertex.normal.z > 0.9f; });
    ASSERT_NE(middle, floor.grid.mesh->vertices.end());
    const Vec3 at = floor.grid.space_from_mesh *
                    Vec3(middle->position.x, middle->position.y, middle->position.z);
    const double lines = at.y() / followed.scenery().scale.body;
    EXPECT_NEAR(lines, std::round(lines), 1e-4) << t;
  }
  CameraSpec still;
  still.follow = "none";
  const Composer whole = composer(rolling_ball(), rolling(2.0), ShowSpec{}, still);
  EXPECT_GT(moved_in_picture(whole), 100.0);
  EXPECT_EQ((whole.glyphs_at(whole.scenery().motion.at(0.0)).floors.at(0).place.translation() -
             whole.glyphs_at(whole.scenery().motion.at(4.0)).floors.at(0).place.translation())
                .norm(),
            0.0);
  // one that stays about where it is needs nobody to follow, and has a dial below it
  const Composer near = composer(rolling_ball(), rolling(0.03), ShowSpec{});
  EXPECT_GT(moved_in_picture(near), 10.0);
  EXPECT_NE(near.glyphs_at(near.scenery().motion.at(0.0)).floors.at(0).dial.mesh, nullptr);
}

// a small body's arrows are no hairs, and those of a large one have the sizes of their shapes
TEST(Compose, ArrowsOfSmallBodiesAreThicker) {
  const auto widest = [](const Composer& composer) {
    const Sample start = composer.scenery().motion.at(0.0);
    double radius = 0.0;
    for (const ArrowGlyph& arrow : composer.glyphs_at(start).arrows)
      radius = std::max(radius, arrow.shape.shaft_radius);
    return radius / composer.scenery().scale.body;
  };
  CameraSpec still;
  still.follow = "none";
  const Composer followed = composer(rolling_ball(), rolling(2.0), ShowSpec{});
  EXPECT_DOUBLE_EQ(widest(followed), kOmegaShape.shaft_radius);
  const double small = widest(composer(rolling_ball(), rolling(2.0), ShowSpec{}, still));
  EXPECT_GT(small, 1.5 * kOmegaShape.shaft_radius);
  EXPECT_LE(small, 2.5 * kOmegaShape.shaft_radius * (1.0 + 1e-12));
}

// nothing of the table is cut off by the clip planes, wherever a camera stands
TEST(Compose, TheWholeTableIsWithinTheClipPlanes) {
  for (const char* follow : {"none", "center"}) {
    CameraSpec spec;
    spec.follow = follow;
    const Composer picture = composer(rolling_ball(), rolling(2.0), ShowSpec{}, spec);
    for (const double t : {0.0, 2.0, 4.0}) {
      const Camera camera = picture.camera_at(t);
      const FloorGlyph floor = picture.glyphs_at(picture.scenery().motion.at(t)).floors.at(0);
      for (int k = 0; k < 24; ++k) {
        const double angle = 2.0 * kPi * k / 24;
        const Vec3 rim = floor.place * Vec3(std::cos(angle), std::sin(angle), 0.0);
        if (!camera.sees(rim)) continue;
        const double depth = -(camera.space_from_camera().inverse() * rim).z();
        EXPECT_GT(depth, camera.nearest()) << follow << t;
        EXPECT_LT(depth, camera.farthest()) << follow << t;
      }
    }
  }
}

// ghosts of a throw that comes down again need less room where the camera stands
TEST(Compose, ACameraFollowsOnlyToComeNearer) {
  MotionSpec spec = test::wobbling();
  spec.duration = 0.55;
  spec.gravity = Vec3(0, 0, -9.81);
  spec.velocity = Vec3(0, 1.2, 2.7);
  ShowSpec show = show_only("ghosts");
  show["body"] = true;
  show.ghost_s = 0.09;
  const auto picture = [&](const char* follow) {
    CameraSpec camera;
    camera.follow = follow;
    return composer(test::brick_body(), spec, show, camera);
  };
  const auto size = [&](const Composer& composed) {
    double sum = 0.0;
    for (double t = 0.0; t <= 0.55; t += 0.05)
      sum += height_in_picture(composed, t);
    return sum;
  };
  EXPECT_GT(size(picture("none")), size(picture("center")));
  EXPECT_NEAR(size(picture("auto")), size(picture("none")), 1e-9);
}

// a camera that goes along sees the whole trail at every moment
TEST(Compose, FollowingSeesTheWholeTrail) {
  const BodySpec body = test::brick_body();
  CameraSpec camera;
  camera.follow = "center";
  ShowSpec show = show_only("trail");
  show["body"] = true;
  const Composer picture = composer(body, thrown(), show, camera);
  const Path& path = picture.scenery().paths.axis.path();
  for (const double t : {0.5, 2.0, 4.0}) {
    for (std::size_t i = 0; i < path.points.size() && path.parameters[i] <= t; ++i)
      ASSERT_TRUE(picture.camera_at(t).sees(path.points[i])) << t;
  }
}

TEST(Compose, TheSphereOfATrailIsInsideTheFrame) {
  ShowSpec show = show_only("trail_sphere");
  const Composer picture = composer(test::brick_body(), wobbling(), show);
  const Sample now = picture.scenery().motion.at(1.0);
  const Placement sphere = picture.glyphs_at(now).shells.front().space_from_mesh;
  double top = 1e9, bottom = -1e9;
  for (double z = -1.0; z <= 1.0; z += 0.01) {
    for (double angle = 0.0; angle < 2.0 * kPi; angle += 0.02) {
      const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
      const Vec3 point = sphere * Vec3(r * std::cos(angle), r * std::sin(angle), z);
      const double y = picture.camera().project(point).y();
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  // no farther out than the margins, and hardly less
  const FrameMargins usual;
  EXPECT_GT(top, usual.top * kSize.height - 1e-6);
  EXPECT_LT(bottom, (1.0 - usual.bottom) * kSize.height + 1e-6);
  EXPECT_GT((bottom - top) / kSize.height, 0.88);
}

TEST(Compose, ZoomAndMarginAreThoseOfTheScene) {
  const BodySpec body = test::brick_body();
  const auto height = [&](const CameraSpec& camera) {
    return height_in_picture(composer(body, wobbling(), show_only("body"), camera), 0.7);
  };
  CameraSpec plain, zoomed, own, wide;
  zoomed.zoom = 2.5;
  EXPECT_NEAR(height(zoomed) / height(plain), 2.5, 1e-9);
  own.eye = Vec3(2.0, 0.5, 0.4);
  const double before = height(own);
  own.zoom = 1.7;
  EXPECT_NEAR(height(own) / before, 1.7, 1e-9);
  // text keeps its room beside the margin
  for (const double margin : {0.0, 0.2, 0.4}) {
    wide.margin = margin;
    FrameMargins text;
    text.bottom += 0.05;
    const Motion motion = moving(body, wobbling());
    const Staging staging{wide, {}, Timeline({}, motion.duration(), 1.0), text};
    const Composer picture(motion, body, staging, show_only("body"), {}, kSize);
    double top = 1e9, bottom = -1e9;
    for (double t = 0.0; t <= 4.0; t += 4.0 / 240) {
      const Sample now = motion.at(t);
      for (const Vec3& point_B : picture.scenery().hull_B) {
        const double y =
            picture.camera().project(now.reference_S + now.q_SB * point_B).y() / kSize.height;
        top = std::min(top, y);
        bottom = std::max(bottom, y);
      }
    }
    EXPECT_NEAR(top, margin, 1e-6);
    EXPECT_NEAR(bottom, 1.0 - std::min(margin + 0.05, 0.45), 1e-6);
  }
  // of a shot likewise
  ShotSpec shot;
  shot.at = 2.0;
  shot.camera.zoom = 3.0;
  const Motion motion = moving(body, wobbling());
  const Staging staging{plain, {shot}, Timeline({}, motion.duration(), 1.0), {}};
  const Composer picture(motion, body, staging, show_only("body"), {}, kSize);
  const Vec3 point(0.0, 0.05, 0.02);
  const Vec2 middle(0.5 * kSize.width, 0.5 * kSize.height);
  const Vec2 first = picture.camera_at(1.0).project(point) - middle;
  EXPECT_LT((picture.camera_at(3.0).project(point) - middle - 3.0 * first).norm(), 1e-6);
}

}  // namespace
}  // namespace polhode
