// SPDX-License-Identifier: MIT
#include "model/contact_surface.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/on_table.h"

namespace polhode::test {
namespace {

SolidSpec solid_of_kind(const std::string& kind) {
  SolidSpec s;
  s.kind = kind;
  s.mass = 1.0;
  s.turn = Vec3(0.3, -0.2, 0.5);
  s.at = Vec3(0.01, 0.02, -0.03);
  return s;
}

// an ellipsoid as a smooth outline through so many points
SolidSpec egg(double radius, double half_length, int pieces) {
  SolidSpec s = solid_of_kind("lathe");
  s.smooth = true;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = kPi * i / pieces;
    s.profile.emplace_back(i % pieces == 0 ? 0.0 : radius * std::sin(angle),
                           -half_length * std::cos(angle));
  }
  return s;
}

std::vector<SolidSpec> smooth_solids() {
  std::vector<SolidSpec> all;
  all.push_back(solid_of_kind("sphere"));
  all.back().radius = 0.2;
  all.push_back(solid_of_kind("ellipsoid"));
  all.back().semi_axes = Vec3(0.1, 0.2, 0.3);
  all.push_back(solid_of_kind("ring"));
  all.back().radius = 0.2;
  all.back().tube = 0.05;
  all.push_back(solid_of_kind("disc"));
  all.back().radius = 0.2;
  all.push_back(egg(0.02, 0.03, 16));
  return all;
}

BodySpec body(const SolidSpec& one) {
  BodySpec spec;
  spec.solid = one;
  return spec;
}

// the height is minus down . arm, the least over the surface, and its gradient is the arm
TEST(ContactSurface, IsTheGradientOfItsHeight) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (const SolidSpec& one : smooth_solids()) {
    SCOPED_TRACE(one.kind);
    const BodyModel model = make_model(body(one), on_table(1.0, rolling()));
    const ContactSurface& surface = *model.table->surface;
    for (int i = 0; i < 20; ++i) {
      const Vec3 down = Vec3(normal(random), normal(random), normal(random)).normalized();
      const Vec3 rate = down.cross(Vec3(normal(random), normal(random), normal(random)));
      const SurfacePoint here = surface.at(down, rate, 0);
      EXPECT_NEAR(here.height, down.dot(here.arm_P), 1e-15);
      EXPECT_NEAR(here.height, surface.height(down, 0), 1e-15);
      EXPECT_LT(here.arm_P.norm(), surface.reach() * (1.0 + 1e-12));
      EXPECT_NEAR(here.arm_rate_P.dot(down), 0.0, 1e-14 * (1.0 + here.arm_rate_P.norm()));
      // central differences
      constexpr double kH = 1e-6;
      const auto at = [&](double t) {
        return surface.at((down + t * rate).normalized(), rate, 0);
      };
      const Vec3 slope = (at(kH).arm_P - at(-kH).arm_P) / (2.0 * kH);
      EXPECT_LT((slope - here.arm_rate_P).norm(), 1e-7 * (1.0 + slope.norm()));
      const double fall = (at(kH).height - at(-kH).height) / (2.0 * kH);
      EXPECT_NEAR(fall, rate.dot(here.arm_P), 1e-8);
    }
  }
}

// Outlines of spheres are exact; the error of others falls with the fourth power of the distance of
// their points: 16 of them put this egg 6e-6 m too high or low, 32 of them a twelfth of that.
TEST(SmoothOutline, GoesThroughItsPoints) {
  const auto error = [](double radius, double half_length, int pieces) {
    SolidSpec one = egg(radius, half_length, pieces);
    one.turn = one.at = Vec3::Zero();
    const BodyModel model = make_model(body(one), on_table(1.0, rolling()));
    const ContactSurface& surface = *model.table->surface;
    EXPECT_EQ(surface.pieces().size(), 1u);
    EXPECT_EQ(surface.as_sphere(), nullptr);
    double worst = 0.0;
    for (int i = 0; i <= 100; ++i) {
      const double angle = kPi * i / 100;
      const Vec3 down_B(std::sin(angle), 0.0, std::cos(angle));
      const Vec3 down_P = model.R_BP.transpose() * down_B;
      const double exact = std::hypot(radius * down_B.x(), half_length * down_B.z());
      const double center = down_B.dot(model.body.center);
      worst = std::max(worst, std::abs(surface.height(down_P, 0) + center - exact));
    }
    return worst;
  };
  EXPECT_LT(error(0.02, 0.02, 8), 1e-16);
  const double coarse = error(0.02, 0.03, 16), fine = error(0.02, 0.03, 32);
  RecordProperty("coarse", std::to_string(coarse));
  EXPECT_LT(coarse, 1.2e-5);
  EXPECT_LT(fine, coarse / 6.0);
}

// a peg is round where it touches, and the rest of the hull begins where the outline is hollow
TEST(SmoothOutline, IsCutWhereTheOutlineIsHollow) {
  SolidSpec top = solid_of_kind("lathe");
  top.turn = top.at = Vec3::Zero();
  top.smooth = true;
  for (int i = 0; i <= 4; ++i)
    top.profile.emplace_back(0.002 * std::sin(0.3 * i), 0.002 - 0.002 * std::cos(0.3 * i));
  for (const Vec2& p : {Vec2(0.004, 0.006), Vec2(0.02, 0.02), Vec2(0.024, 0.03), Vec2(0.02, 0.04)})
    top.profile.push_back(p);
  const BodyModel model = make_model(body(top), on_table(1.0, rolling()));
  const ContactSurface& surface = *model.table->surface;
  ASSERT_EQ(surface.pieces().size(), 2u);
  // leaning by 0.5 rad, it stands on the ball of the peg
  const Vec3 down = model.R_BP.transpose() * Vec3(std::sin(0.5), 0, -std::cos(0.5));
  const SurfacePoint point = surface.at(down, Vec3(0, 1, 0), surface.lowest(down));
  EXPECT_NEAR(point.arm_rate_P.norm(), 0.002, 1e-9);
}

TEST(SmoothOutline, RefusesOneThatIsTooUneven) {
  SolidSpec uneven = solid_of_kind("lathe");
  uneven.smooth = true;
  uneven.profile = {{0.0, 0.0}, {0.0001, 0.00001}, {0.03, 0.012}, {0.0301, 0.03}, {0.0, 0.031}};
  expect_input_error([&] { make_model(body(uneven), on_table(1.0, rolling())); },
                     "body.solid.profile",
                     "too uneven");
}

// corners of solids with flat faces are circles and tips, and the lowest counts
TEST(ContactSurface, TakesTheLowestCorner) {
  SolidSpec lathe = solid_of_kind("lathe");
  lathe.turn = lathe.at = Vec3::Zero();
  // a cone with a dent, which never touches
  lathe.profile = {{0.0, 0.0}, {0.03, 0.04}, {0.01, 0.05}, {0.02, 0.06}, {0.0, 0.07}};
  const BodyModel model = make_model(body(lathe), on_table(1.0, rolling()));
  const ContactSurface& surface = *model.table->surface;
  EXPECT_EQ(surface.pieces().size(), 4u);
  const Vec3 tip(0, 0, -1);
  EXPECT_NEAR(surface.height(tip, surface.lowest(tip)), model.body.center.z(), 1e-15);
  const Vec3 side(1, 0, 0);
  EXPECT_NEAR(surface.height(side, surface.lowest(side)), 0.03, 1e-15);
  EXPECT_NEAR(surface.clearance(side, surface.lowest(side)), 0.01, 1e-15);

  SolidSpec cylinder = solid_of_kind("cylinder");
  cylinder.radius = 0.1;
  cylinder.height = 0.2;
  const BodyModel can = make_model(body(cylinder), on_table(1.0, rolling()));
  EXPECT_EQ(can.table->surface->pieces().size(), 2u);
}

TEST(ContactSurface, RefusesFacetsAndBodiesWithoutShape) {
  BodySpec box = body(solid_of_kind("box"));
  box.solid->size = Vec3(1, 1, 1);
  expect_input_error(
      [&] { make_model(box, on_table(1.0, rolling())); }, "body.solid.kind", "facets");
  BodySpec bare;
  bare.moments = Vec3(1, 1, 1);
  expect_input_error(
      [&] { make_model(bare, on_table(1.0, rolling())); }, "motion.hold", "body.look");
}

TEST(Table, RefusesKeysThatDoNotFit) {
  const auto refuse = [](const FrictionSpec& friction, const char* key, const char* words) {
    expect_input_error([&] { make_model(ball_body(), on_table(1.0, friction)); }, key, words);
  };
  FrictionSpec ice;
  ice.kind = "none";
  ice.mu = 0.2;
  refuse(ice, "motion.friction.mu", "coulomb");
  ice.mu.reset();
  ice.boring = 0.1;
  refuse(ice, "motion.friction.boring", "none");
  refuse(FrictionSpec{}, "motion.friction", "needs mu");
  FrictionSpec thick;
  thick.kind = "viscous";
  refuse(thick, "motion.friction", "needs c");

  MotionSpec free = on_table(1.0, rolling());
  free.hold = "free";
  expect_input_error([&] { make_model(ball_body(), free); }, "motion.friction", "on a table");
  MotionSpec upwards = on_table(1.0, rolling());
  upwards.gravity = Vec3(0, 0, 1);
  expect_input_error([&] { make_model(ball_body(), upwards); }, "motion.gravity", "down");
  MotionSpec moving = on_table(1.0, rolling());
  moving.velocity = Vec3(1, 0, 0);
  const BodyModel model = make_model(ball_body(), moving);
  expect_input_error([&] { start_state(model, moving); }, "motion.velocity", "follows");
  const MotionSpec flat = on_table(1.0, rolling());
  const BodyModel disc = make_model(disc_body(), flat);
  expect_input_error([&] { start_state(disc, flat); }, "motion.attitude", "tilt it");
}

}  // namespace
}  // namespace polhode::test
