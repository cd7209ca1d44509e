// SPDX-License-Identifier: MIT
// Bodies on a table against closed forms and a second formulation.
#include "motion/contact/contact_trajectory.h"

#include <cmath>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "base/error.h"
#include "math/so3.h"
#include "motion/contact/contact_change.h"
#include "support/contact_oracle.h"
#include "support/expect_error.h"
#include "support/motions.h"
#include "support/on_table.h"

namespace polhode::test {
namespace {

std::vector<double> times_of(const Integration& found, const std::string& event) {
  std::vector<double> times;
  for (const ContactRecord& one : found.record.events)
    if (one.event == event) times.push_back(one.t);
  return times;
}

// 0.1 kg of 4 cm, as thick as a finger
BodySpec thin_ring() {
  BodySpec ring = round_body("ring", 0.04, 0.1);
  ring.solid->tube = 0.006;
  return ring;
}

double angle_of(const State& s, const Vec3& axis_P) {
  return angle_between(s.q * axis_P, Vec3::UnitZ());
}

// A body comes down when a stone would, whatever the tolerance: a zero within a rounding of where a
// trial step ends is enclosed as any other.
TEST(OnTable, LandsWhenItsCentreHasFallenFarEnough) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const double height = std::pow(10.0, 4.0 * part(random) - 1.0);  // of the lowest point
    const double lands = std::sqrt(2.0 * height / kG);
    MotionSpec spec = on_table(1.2 * lands, coulomb(0.3));
    spec.friction->restitution = 0.5;
    spec.position = Vec3(0.0, 0.0, height + 0.028);
    spec.spin.body = Vec3(part(random), part(random), part(random));
    const double tolerance = std::pow(10.0, -7.0 - 3.0 * part(random));
    const std::vector<double> found = times_of(integrated(ball_body(), spec, tolerance), "landing");
    ASSERT_FALSE(found.empty());
    EXPECT_NEAR(found[0] / lands, 1.0, 1e-12) << height << ' ' << tolerance;
    EXPECT_EQ(found.size(), 1u) << height << ' ' << tolerance;
  }
}

// a ball that slides from rest of rotation rolls after 2 v / (7 mu g), with 5/7 of its speed
TEST(OnTable, ABilliardBallRollsAfterItHasSlid) {
  MotionSpec spec = on_table(1.0, coulomb(0.2));
  spec.velocity = Vec3(2.0, 0.0, 0.0);
  const Integration found = integrated(ball_body(), spec, 1e-10);
  const std::vector<double> ends = times_of(found, "slip_ends");
  ASSERT_EQ(ends.size(), 1u);
  EXPECT_NEAR(ends[0], 2.0 * 2.0 / (7.0 * 0.2 * kG), 1e-12);
  const State end = found.trajectory->at(1.0);
  EXPECT_NEAR(end.linear_momentum_S.x() / 0.17, 10.0 / 7.0, 1e-12);
  EXPECT_NEAR(end.place_S.z(), 0.028, 1e-16);
}

// side spin bends the path of the sliding ball to a parabola, as the slip keeps its direction; it
// leaves on a straight line with the velocity that friction at the contact cannot change: the
// momentum about it
TEST(OnTable, ASideSpinBendsAPathToAParabola) {
  MotionSpec spec = on_table(1.0, coulomb(0.2));
  spec.velocity = Vec3(2.0, 0.0, 0.0);
  spec.spin.space = Vec3(30.0, 10.0, 50.0);
  const Integration found = integrated(ball_body(), spec, 1e-12);
  const double R = 0.028;
  const Vec3 slip(2.0 - R * 10.0, R * 30.0, 0.0);  // v + w x (-R z)
  const double ends = slip.norm() / (3.5 * 0.2 * kG);
  ASSERT_EQ(times_of(found, "slip_ends").size(), 1u);
  EXPECT_NEAR(times_of(found, "slip_ends")[0], ends, 1e-8);
  const Vec3 pull = -0.2 * kG * slip.normalized();
  for (const double t : {0.05, 0.1, 0.2}) {
    const Vec3 expected = spec.velocity * t + 0.5 * t * t * pull;
    EXPECT_LT((found.trajectory->at(t).place_S - expected).head<2>().norm(), 1e-12);
  }
  const Vec3 last = 5.0 / 7.0 * spec.velocity + 2.0 / 7.0 * R * Vec3(10.0, -30.0, 0.0);
  EXPECT_LT((found.trajectory->at(0.9).linear_momentum_S / 0.17 - last).norm(), 1e-8);
}

// a ball on a turning table circles at 2/7 of its rate
TEST(OnTable, ABallOnATurningTableCircles) {
  MotionSpec spec = on_table(6.0, rolling());
  spec.friction->turntable = 3.5;
  spec.position = Vec3(0.2, 0.0, 0.0);
  spec.spin.space = Vec3(3.0, 0.0, 1.0);
  const Integration found = integrated(ball_body(), spec, 1e-12);
  const double rate = 2.0 / 7.0 * 3.5;
  // velocity turns uniformly
  const Vec3 v0 = found.trajectory->at(0.0).linear_momentum_S / 0.17;
  for (const double t : {1.0, 3.3, 6.0}) {
    const Vec3 v = Eigen::AngleAxisd(rate * t, Vec3::UnitZ()) * v0;
    EXPECT_LT((found.trajectory->at(t).linear_momentum_S / 0.17 - v).norm(), 1e-9);
  }
}

// An egg on its side soon sticks, and slips again when its wobble needs more friction than there
// is: the slip begins in the direction in which it grows by itself, also where the contact gives
// way more easily in one direction than in the other. The times do not depend on the tolerance.
TEST(OnTable, AnEggSticksAndSlipsAgain) {
  BodySpec egg = ellipsoid_body(Vec3(0.02, 0.02, 0.03));
  egg.solid->mass = 0.06;
  MotionSpec spec = on_table(1.0, coulomb(0.3));
  spec.attitude.zxz = Vec3(0, 85.0 * kPi / 180.0, 0);
  spec.spin.space = Vec3(0, 0, 150);
  const Integration fine = integrated(egg, spec, 1e-11), loose = integrated(egg, spec, 1e-9);
  for (const Integration* found : {&fine, &loose}) {
    EXPECT_EQ(times_of(*found, "slip_ends").size(), 2u);
    EXPECT_EQ(times_of(*found, "slip_begins").size(), 1u);
    EXPECT_LT(found->record.steps, 5000);
  }
  EXPECT_NEAR(times_of(fine, "slip_begins").at(0), times_of(loose, "slip_begins").at(0), 1e-4);
}

// A wide disc that is pressed to the table with more than twice its weight begins to slip: it goes
// on in one direction, rather than by many ends of slips, and comes to the same place by every
// tolerance.
TEST(OnTable, AHeavilyPressedDiscSlipsOnce) {
  MotionSpec spec = on_table(0.2, coulomb(0.8));
  spec.attitude.zxz = Vec3(0, 0.43, 1.26);
  spec.spin.body = Vec3(-3.5, 5.7, 3.7);
  spec.velocity = Vec3(-1.0, 0, 0);
  const BodySpec disc = disc_body(1.0, 1.0);
  const Integration fine = integrated(disc, spec, 1e-10), loose = integrated(disc, spec, 1e-8);
  for (const Integration* found : {&fine, &loose}) {
    EXPECT_EQ(times_of(*found, "slip_ends").size(), 1u);
    EXPECT_EQ(times_of(*found, "slip_begins").size(), 1u);
    EXPECT_EQ(times_of(*found, "lift_off").size(), 1u);
    EXPECT_LT(found->record.steps, 1000);
    EXPECT_LT(*found->record.drift.energy, 1e-8);
  }
  const Vec3 apart = fine.trajectory->at(0.2).place_S - loose.trajectory->at(0.2).place_S;
  EXPECT_LT(apart.norm(), 1e-8);
}

// A coin that leans and wobbles with dry friction slips and sticks in turn: the same events by
// every tolerance, and where slips begin, the equations of stiff steps are solved.
TEST(OnTable, AWobblingCoinSlipsAndSticksInTurn) {
  const BodySpec coin = disc_body(0.0125, 0.008);
  MotionSpec spec = on_table(2.5, coulomb(0.3));
  spec.friction->rolling = 5e-5;
  spec.friction->boring = 3e-4;
  spec.attitude.zxz = Vec3(0, 89.5 * kPi / 180.0, 0);
  spec.spin.rates = Vec3(120, 0, 0);
  const Integration fine = integrated(coin, spec, 1e-9), loose = integrated(coin, spec, 1e-7);
  for (const char* event : {"slip_begins", "slip_ends"}) {
    const std::vector<double> exact = times_of(fine, event), found = times_of(loose, event);
    ASSERT_EQ(found.size(), exact.size());
    EXPECT_GT(exact.size(), 10u);
    for (std::size_t i = 0; i < exact.size(); ++i)
      EXPECT_NEAR(found[i], exact[i], 1e-4) << event;
  }
  EXPECT_LT(fine.record.rejected, fine.record.steps / 2);
}

// each bounce takes e times as long as the one before, and all of them a finite time
TEST(OnTable, ABouncingBallEndsItsBounces) {
  MotionSpec spec = on_table(6.0, coulomb(0.2));
  spec.friction->restitution = 0.8;
  spec.position = Vec3(0, 0, 1.028);
  const Integration found = integrated(ball_body(), spec, 1e-12);
  const double fall = std::sqrt(2.0 / kG);
  const std::vector<double> lands = times_of(found, "landing");
  ASSERT_GT(lands.size(), 40u);
  double expected = fall, way = 2.0 * fall * 0.8;
  for (std::size_t i = 0; i < 20; ++i, expected += way, way *= 0.8)
    EXPECT_NEAR(lands[i], expected, 1e-12) << i;
  ASSERT_EQ(times_of(found, "bounces_end").size(), 1u);
  // the height of the last bounces is rounded: 1e-11 s is four times the error
  EXPECT_NEAR(times_of(found, "bounces_end")[0], fall * (1.0 + 1.6 / 0.2), 1e-11);
  EXPECT_NEAR(found.trajectory->at(5.0).place_S.z(), 0.028, 1e-15);
  EXPECT_EQ(found.trajectory->contact_at(5.0)->touch.phase, Touch::Phase::touching);
}

// A disc whose slip turns in each of endless bounces: the last ones count for more than their sum
// does, and are too low for their heights to be told from round-off. Attitudes after 1 s of an
// integration in 80 bits, bounce by bounce down to 1e-10 of the speed of a fall.
TEST(OnTable, EndlessBouncesAreFollowedToTheirEnd) {
  struct Drop {
    double height, tilt_deg;
    Vec3 spin_B;
    double mu, restitution;
    Quat end;
  };
  const Drop drops[] = {
      {0.08, 15.0, {3, -12, 8}, 0.5, 0.9, Quat(0.28788501679, 0.03386448, 0.08527931, 0.95325907)},
      {0.15, 25.0, {8, -14, 7}, 0.3, 0.7, Quat(0.25136832, -0.86833367, 0.31765417, 0.28619299)}};
  for (const Drop& drop : drops) {
    MotionSpec spec = on_table(1.0, coulomb(drop.mu));
    spec.friction->restitution = drop.restitution;
    spec.position = Vec3(0, 0, drop.height);
    spec.attitude.zxz = Vec3(0, drop.tilt_deg * kPi / 180.0, 0);
    spec.spin.body = drop.spin_B;
    const Integration found = integrated(disc_body(0.05, 0.1), spec, 1e-10);
    EXPECT_LT(rotation_angle_between(found.trajectory->at(1.0).q, drop.end.normalized()), 3e-8);
    EXPECT_FALSE(times_of(found, "bounces_end").empty());
    const std::vector<ContactRecord>& events = found.record.events;
    for (std::size_t i = 1; i < events.size(); ++i)
      EXPECT_GT(events[i].t, events[i - 1].t) << events[i].event;
  }
}

// a rod that falls on its end with friction
TEST(OnTable, BouncesWithFrictionMakeNoEnergy) {
  BodySpec rod = ball_body();
  rod.solid->kind = "rod";
  rod.solid->length = 1.0;
  rod.solid->radius = 0.02;
  MotionSpec spec = on_table(0.33, coulomb(1.0));
  spec.friction->restitution = 1.0;
  spec.position = Vec3(0, 0, 0.8);
  spec.velocity = Vec3(0, -1.0, 0);
  for (const double tilt : {0.3, 0.6, 0.9}) {
    spec.attitude.zxz = Vec3(0, tilt, 0);
    const Integration found = integrated(rod, spec, 1e-10);
    ASSERT_EQ(times_of(found, "landing").size(), 1u);
    EXPECT_LE(found.trajectory->contact_at(spec.duration)->work, 1e-12) << tilt;
  }
}

// friction that damps all slip at once is that which lets none
TEST(OnTable, StrongViscousFrictionIsThatOfRolling) {
  const auto energy_after = [](const FrictionSpec& friction) {
    MotionSpec spec = on_table(0.6, friction);
    spec.friction->restitution = 0.5;
    spec.position = Vec3(0, 0, 0.5);
    spec.velocity = Vec3(1.0, 0, 0);
    return integrated(ball_body(), spec, 1e-10).trajectory->contact_at(0.6)->work;
  };
  // 0.9e-6 of it is left
  EXPECT_NEAR(energy_after(viscous(1e6)) / energy_after(rolling()), 1.0, 3e-6);
}

TEST(OnTable, StrongViscousFrictionLetsABallRoll) {
  MotionSpec spec = on_table(0.2, viscous(1000.0));
  spec.velocity = Vec3(1.0, 0, 0);
  const Integration found = integrated(ball_body(), spec, 1e-9);
  const double mass = ball_body().solid->mass.value_or(0.0);
  EXPECT_NEAR(found.trajectory->at(0.2).linear_momentum_S.x() / mass, 5.0 / 7.0, 1e-8);
}

// the last of endless bounces is an impulse at the contact
TEST(OnTable, EndsBouncesAtTheContact) {
  BodySpec egg = ball_body();
  egg.solid->kind = "ellipsoid";
  egg.solid->radius.reset();
  egg.solid->semi_axes = Vec3(0.03, 0.03, 0.05);
  MotionSpec spec = on_table(1.0, {});
  spec.friction = FrictionSpec{};
  spec.friction->kind = "none";
  spec.friction->restitution = 0.9;
  spec.attitude.zxz = Vec3(0, 1.0, 0);
  const BodyModel model = with_needed_degrees(make_model(egg, spec));
  OnTable now;
  now.moving = moving_of(model, start_state(model, spec));
  now.moving.velocity_S.z() -= 1e-6;
  const Moving before = now.moving;
  const ContactStepper stepper(model, table_scales(model, before, 1e-9));
  Touch touch;
  touch.phase = Touch::Phase::flying;
  change_at(stepper, ContactEvent::landing, touch, 0.0, now);
  const Vec3 impulse = model.body.mass * (now.moving.velocity_S - before.velocity_S);
  const Vec3 arm_P = posed(model, touch, before).point.arm_P;
  const Vec3 expected = arm_P.cross(before.q.conjugate() * impulse);
  EXPECT_GT(impulse.z(), 1e-9);
  EXPECT_NEAR((now.moving.y - before.y - expected).norm() / expected.norm(), 0.0, 1e-9);
}

// rolling friction stops a ball after a way v^2 (7/5) R / (2 g rho), in a uniform deceleration
TEST(OnTable, RollingFrictionStopsABall) {
  MotionSpec spec = on_table(8.0, rolling());
  spec.friction->rolling = 5e-4;
  spec.spin.space = Vec3(0, 20, 0);
  const Integration found = integrated(ball_body(), spec, 1e-12);
  const double slows = 5e-4 * kG / 0.028 / 1.4, v = 20 * 0.028;
  ASSERT_EQ(times_of(found, "rolling_ends").size(), 1u);
  EXPECT_NEAR(times_of(found, "rolling_ends")[0], v / slows, 1e-9);
  EXPECT_NEAR(found.trajectory->at(8.0).place_S.x(), 0.5 * v * v / slows, 1e-10);
}

struct OracleCase {
  const char* name;
  BodySpec body;
  FrictionSpec friction;
  OracleBody::Law law;
  Real coefficient;
  double duration;
  int steps;
};

class AgainstOracle : public testing::TestWithParam<int> {};

std::vector<OracleCase> oracle_cases() {
  FrictionSpec ice;
  ice.kind = "none";
  using Law = OracleBody::Law;
  return {{"tippe top slides", tippe_top_body(), coulomb(0.1), Law::sliding, 0.1L, 0.2, 4000},
          {"tippe top, viscous", tippe_top_body(), viscous(2.0), Law::viscous, 2.0L, 0.4, 8000},
          {"tippe top rolls", tippe_top_body(), rolling(), Law::rolling, 0.0L, 0.4, 8000},
          {"tippe top on ice", tippe_top_body(), ice, Law::frictionless, 0.0L, 0.4, 8000},
          {"rattleback rolls", rattleback_body(0.2), rolling(), Law::rolling, 0.0L, 2.0, 8000},
          {"rattleback on ice", rattleback_body(0.2), ice, Law::frictionless, 0.0L, 2.0, 8000}};
}

// the same motion by multipliers in long double, within 1e-9 rad and 1e-9 m
TEST_P(AgainstOracle, GivesTheSameMotion) {
  const OracleCase one = oracle_cases()[static_cast<std::size_t>(GetParam())];
  SCOPED_TRACE(one.name);
  const bool top = one.body.moments.has_value();
  MotionSpec spec = on_table(one.duration, one.friction);
  spec.attitude.zxz = top ? Vec3(0.3, 0.5, 0.2) : Vec3(0.3, 0.1, 0.2);
  spec.spin.body = top ? Vec3(2.0, -1.0, 100.0) : Vec3(0.5, 0.2, -4.0);
  if (one.law != OracleBody::Law::rolling) spec.velocity = Vec3(0.3, -0.1, 0.0);
  const Integration found = integrated(one.body, spec, 1e-14);
  const BodyModel model = with_needed_degrees(make_model(one.body, spec));

  OracleBody oracle;
  oracle.mass = model.body.mass;
  oracle.law = one.law;
  oracle.coefficient = one.coefficient;
  const SolidSpec& look = *one.body.look;
  const Vec3 axes = look.semi_axes.value_or(Vec3::Constant(look.radius.value_or(0.0)));
  const Vec3 middle = look.at - model.body.center;
  for (int i = 0; i < 3; ++i) {
    oracle.semi_axes[static_cast<std::size_t>(i)] = axes[i];
    oracle.middle[static_cast<std::size_t>(i)] = middle[i];
    for (int j = 0; j < 3; ++j)
      oracle.tensor[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
          model.body.tensor(i, j);
  }
  const State start = found.trajectory->at(0.0);
  const Mat3 R_SB = start.q.toRotationMatrix() * model.R_BP.transpose();
  const Vec3 w_S = start.q * angular_velocity(model, start.y);
  const ContactOracle solver(oracle);
  OracleState s;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    s.x[k] = start.place_S[i];
    s.v[k] = start.linear_momentum_S[i] / model.body.mass;
    s.w[k] = w_S[i];
    for (int j = 0; j < 3; ++j)
      s.R[k][static_cast<std::size_t>(j)] = R_SB(i, j);
  }
  s.contact = solver.lowest(s.R);
  const OracleState end = solver.after(s, one.duration, one.steps);

  const State here = found.trajectory->at(one.duration);
  const Mat3 R = here.q.toRotationMatrix() * model.R_BP.transpose();
  double turned = 0.0, moved = 0.0;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    moved = std::max(moved, std::abs(here.place_S[i] - static_cast<double>(end.x[k])));
    for (int j = 0; j < 3; ++j)
      turned = std::max(
          turned, std::abs(R(i, j) - static_cast<double>(end.R[k][static_cast<std::size_t>(j)])));
  }
  EXPECT_LT(turned, 1e-9);
  EXPECT_LT(moved, 1e-9);
}
INSTANTIATE_TEST_SUITE_P(All, AgainstOracle, testing::Range(0, 6));

// energy with the work of the table, and what contact_invariants() lists, over 1000 turns
TEST(OnTable, KeepsItsInvariants) {
  struct Case {
    const char* name;
    BodySpec body;
    FrictionSpec friction;
    Vec3 spin;
    double seconds;
  };
  FrictionSpec ice;
  ice.kind = "none";
  BodySpec chaplygin = ball_body();
  chaplygin.look = chaplygin.solid;
  chaplygin.look->mass.reset();
  chaplygin.solid.reset();
  chaplygin.moments = Vec3(4e-5, 5e-5, 6e-5);
  const double turns = 2000.0 * kPi;
  for (const Case& one :
       {Case{"jellett, sliding", tippe_top_body(), viscous(0.5), Vec3(5, 0, 200), turns / 200},
        Case{"routh", tippe_top_body(), rolling(), Vec3(5, 0, 100), turns / 100},
        Case{"ice", tippe_top_body(), ice, Vec3(5, 0, 100), turns / 100},
        Case{"chaplygin", chaplygin, rolling(), Vec3(20, 30, 40), turns / 54}}) {
    SCOPED_TRACE(one.name);
    MotionSpec spec = on_table(one.seconds, one.friction);
    spec.attitude.tilt = 0.3;
    spec.spin.body = one.spin;
    const Integration found = integrated(one.body, spec, 1e-13);
    ASSERT_TRUE(found.record.drift.momentum);
    EXPECT_LT(*found.record.drift.energy, 1e-10);
    EXPECT_LT(*found.record.drift.momentum, 1e-10);
  }
}

// The steady disc with its centre at rest: the precession goes round at sqrt(4 g / (a sin)).
TEST(OnTable, ADiscWithItsCentreAtRestStaysThere) {
  MotionSpec spec = on_table(5.0, rolling());
  spec.attitude.tilt = 0.4;
  const double rate = std::sqrt(4.0 * kG / 0.0375 / std::sin(0.4));
  spec.spin.rates = Vec3(rate, 0.0, -rate * std::cos(0.4));
  const Integration found = integrated(disc_body(), spec, 1e-12);
  for (const double t : {1.0, 5.0}) {
    const State s = found.trajectory->at(t);
    EXPECT_NEAR(angle_of(s, Vec3::UnitZ()), 0.4, 1e-9);
    EXPECT_LT(s.place_S.head<2>().norm(), 1e-9);
    const Vec3 axis = s.q * Vec3::UnitZ();
    const double azimuth = std::atan2(axis.x(), -axis.y());
    EXPECT_NEAR(std::remainder(azimuth - rate * t, 2.0 * kPi), 0.0, 1e-7);
  }
}

// a disc that rolls upright falls below w^2 = g / (3 a) and not above: near the limit a lean of
// 1e-7 rad swings up to 1000 times as far
TEST(OnTable, ARollingDiscStaysUprightAboveItsLimit) {
  const double limit = std::sqrt(kG / (3.0 * 0.0375));
  const auto leans = [&](double part) {
    MotionSpec spec = on_table(60.0, rolling());
    spec.attitude.tilt = 0.5 * kPi + 1e-7;
    spec.spin.body = Vec3(0, 0, part * limit);
    const Integration found = integrated(disc_body(), spec, 1e-11);
    double most = 0.0;
    for (int i = 0; i <= 600; ++i) {
      const double tilt = angle_of(found.trajectory->at(0.1 * i), Vec3::UnitZ());
      most = std::max(most, std::abs(tilt - 0.5 * kPi));
    }
    return most;
  };
  EXPECT_LT(leans(1.001), 2e-4);
  EXPECT_GT(leans(0.999), 0.03);
}

// the same trajectory may be asked from many threads, in any order, and gives the same bits
TEST(OnTable, IsAPureFunctionOfTime) {
  MotionSpec spec = on_table(3.0, coulomb(0.02));
  spec.attitude.tilt = 0.1;
  spec.spin.body = Vec3(0, 0, 200);
  const Integration found = integrated(tippe_top_body(), spec, 1e-9);
  std::vector<Vec3> forwards(300), backwards(300);
  std::thread other([&] {
    for (std::size_t i = 300; i-- > 0;)
      backwards[i] = found.trajectory->at(0.01 * static_cast<double>(i)).y;
  });
  for (std::size_t i = 0; i < 300; ++i)
    forwards[i] = found.trajectory->at(0.01 * static_cast<double>(i)).y;
  other.join();
  for (std::size_t i = 0; i < 300; ++i)
    EXPECT_EQ(forwards[i], backwards[i]) << i;
}

// Routh's constant is that of a ball that rolls: a landing changes it, and the motion is sound.
TEST(OnTable, ALandingIsNoDriftOfRouthsConstant) {
  MotionSpec spec = on_table(0.2, rolling());
  spec.position = Vec3(0, 0, 0.05);
  spec.attitude.zxz = Vec3(0, 0.5 * kPi, 0);
  spec.spin.body = Vec3(0, 0, 2);
  const Integration found = integrated(ball_body(), spec, 1e-9);
  EXPECT_EQ(times_of(found, "landing").size(), 1u);
  EXPECT_NEAR(angular_velocity(make_model(ball_body(), spec), found.trajectory->at(0.2).y).norm(),
              2.0 * 2.0 / 7.0,
              1e-9);
  EXPECT_LT(found.record.drift.momentum.value_or(1.0), 1e-8);
}

// The steps before the end of a slip may be long, and are not a method's that needs short ones:
// that would find the end where there is none.
TEST(OnTable, TheEndOfASlipIsFoundInLongSteps) {
  MotionSpec spec = on_table(0.82, coulomb(0.3));
  spec.friction->restitution = 0.7;
  spec.position = Vec3(0, 0, 0.15);
  spec.attitude.zxz = Vec3(0, 25.0 * kPi / 180.0, 0);
  spec.spin.body = Vec3(8, -14, 7);
  const BodySpec disc = disc_body(0.05, 0.1);
  const std::vector<double> exact = times_of(integrated(disc, spec, 1e-11), "slip_ends");
  ASSERT_EQ(exact.size(), 2u);
  for (const double tolerance : {1e-8, 1e-9, 1e-10}) {
    const std::vector<double> found = times_of(integrated(disc, spec, tolerance), "slip_ends");
    ASSERT_EQ(found.size(), 2u) << tolerance;
    EXPECT_NEAR(found[1], exact[1], 1e-8) << tolerance;
  }
}

// Where a slip passes through zero beside the direction in which it dies, friction beyond still
// brakes what goes to the side: else steps shrink to nothing.
TEST(OnTable, ASlipThatDiesAtAnAngleKeepsItsSteps) {
  BodySpec disc = disc_body(0.29917458271146724, 1.0);
  MotionSpec spec = on_table(3.4722031438640513, coulomb(0.07145526744667563));
  spec.friction->restitution = 0.5;
  spec.position = Vec3(0, 0, 1.927736649174093);
  spec.velocity = Vec3(0, 0, 2.378277457603887);
  spec.attitude.quaternion = Eigen::Vector4d(
      0.8127141953042449, 0.10888429906360549, -0.07600858234254922, 0.5673293061165419);
  spec.spin.body = Vec3(0.4183323346862953, -0.025197083680389216, 0.03324756010229996);
  const Simulation found = simulated(disc, spec, 1e-7), finer = simulated(disc, spec, 1e-8);
  EXPECT_LT(rotation_angle_between(found.motion.state_at(3.47).q, finer.motion.state_at(3.47).q),
            1e-7);
}

// A slip that takes long to die is stepped over by an implicit method, and its end found without.
TEST(OnTable, ASlipThatDiesSlowlyEndsWhereItIsZero) {
  const BodySpec stone = ellipsoid_body(
      Vec3(0.09674143557125464, 0.09810197959521542, 0.06455661517396155), 0.39060519973981817);
  MotionSpec spec = on_table(3.6, coulomb(0.05525844827233813));
  spec.friction->boring = 0.0030337455365028933;
  spec.attitude.zxz = Vec3(2.6368044276063145, 0.25603983184145873, -2.944771737574621);
  spec.spin.space = Vec3(-0.08495646659058308, 0.0030793872833071415, -0.8659231130833052);
  const State fine = integrated(stone, spec, 1e-12).trajectory->at(3.6);
  for (const double tolerance : {1e-8, 1e-10}) {
    const Integration found = integrated(stone, spec, tolerance);
    EXPECT_LT(found.record.steps, 10'000) << tolerance;
    EXPECT_LT(rotation_angle_between(found.trajectory->at(3.6).q, fine.q), 100.0 * tolerance);
  }
}

// A slip against the direction in which one could grow, where none does, stops: with moments
// against boring it was held there.
TEST(OnTable, ASlipThatCannotTurnBackStops) {
  BodySpec ring = round_body("ring", 0.011941103045447274, 0.051730312585832064);
  ring.solid->tube = 0.0012890931675733177;
  MotionSpec spec = on_table(0.8, coulomb(0.14662310547825147));
  spec.friction->boring = 0.00011302228742523065;
  spec.attitude.zxz = Vec3(-2.153983876302235, 0.2736280945439353, -1.3104304578737933);
  spec.spin.body = Vec3(0, 0, -59.19104584674296);
  spec.velocity = Vec3(-0.3212140299067895, -0.19976385837610974, 0);
  const State fine = integrated(ring, spec, 1e-12).trajectory->at(0.8);
  const Integration found = integrated(ring, spec, 1e-8);
  EXPECT_LT(found.record.steps, 10'000);
  EXPECT_LT(rotation_angle_between(found.trajectory->at(0.8).q, fine.q), 1e-5);
}

// A body that sticks never has more friction than there is, also for less than a step: where it
// would need more, it slips.
TEST(OnTable, ASlipShorterThanAStepIsNotLeftOut) {
  const BodySpec egg = ellipsoid_body(
      Vec3(0.06627618956276575, 0.06627618956276575, 0.06818428638099938), 0.3015327826149502);
  MotionSpec spec = on_table(1.3, {});
  spec.attitude.zxz = Vec3(-1.5243035730374233, 1.7880747151110035, -2.5608404225728503);
  spec.spin.space = Vec3(-0.3431571440566419, -0.03537523938826256, 5.23403371637687);
  spec.velocity = Vec3(-0.0025456747601283972, 0.02702876907763899, 0);
  for (const double mu : {0.008163192096974126, 0.008245648582802148}) {
    spec.friction = coulomb(mu);
    const BodyModel model = with_needed_degrees(make_model(egg, spec));
    for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
      const Integration found = integrated(egg, spec, tolerance);
      int slips = 0;
      for (int i = 0; i <= 5000; ++i) {
        const double t = spec.duration * i / 5000;
        const Touch touch = found.trajectory->contact_at(t)->touch;
        slips += touch.sticks ? 0 : 1;
        if (!touch.sticks) continue;
        const Reaction r = reaction_of(model, touch, t, moving_of(model, found.trajectory->at(t)));
        EXPECT_LE(r.friction_S.norm() / (mu * r.normal), 1.0 + 1e-9 + tolerance / mu) << t;
      }
      EXPECT_GT(slips, 0) << mu << ' ' << tolerance;
    }
  }
}

// Between the steps behind its begin, too, a slip is what its equations say: that a step as a whole
// has a solution does not mean that Newton's method finds that of each part.
TEST(OnTable, ASlipThatBeginsIsExactBetweenItsSteps) {
  struct Slip {
    BodySpec body;
    double mu;
    Vec3 zxz_deg, spin, velocity;
  };
  BodySpec disc = disc_body(0.1, 1.0);
  disc.solid->thickness = 0.01;
  for (const Slip& one : {Slip{ellipsoid_body(Vec3(0.1, 0.07, 0.05), 1.0),
                               0.31,
                               {0, 61, 302},
                               {30.2, 21.4, 21.5},
                               {-0.21, -0.05, 0}},
                          Slip{disc, 0.31, {0, 37, 262}, {-9.6, -18.1, -2.8}, {0.26, 0.25, 0}}}) {
    MotionSpec spec = on_table(0.5, coulomb(one.mu));
    spec.attitude.zxz = one.zxz_deg * (kPi / 180.0);
    spec.spin.body = one.spin;
    spec.velocity = one.velocity;
    const Integration fine = integrated(one.body, spec, 1e-12);
    for (const double tolerance : {1e-7, 1e-8, 1e-9, 1e-10}) {
      const Integration found = integrated(one.body, spec, tolerance);
      double worst = 0.0;
      for (const double begins : times_of(found, "slip_begins")) {
        for (int i = 1; i <= 2000; ++i) {
          const double t = std::min(begins + 1e-6 * i, spec.duration);
          const Vec3 y = fine.trajectory->at(t).y;
          worst = std::max(worst, (found.trajectory->at(t).y - y).norm() / y.norm());
        }
      }
      EXPECT_GT(worst, 0.0);
      EXPECT_LT(worst, 100.0 * tolerance) << tolerance;
    }
  }
}

// Where a body that is kept from turning about the vertical begins to slip, it slips in the
// direction in which its slip grows while it is kept: else the slip ends as it begins, for ever.
TEST(OnTable, ASlipBeginsInTheDirectionInWhichItGrowsWhileMomentsHoldTheBody) {
  BodySpec ring = round_body("ring", 0.0038085051752944623, 0.26328060988293056);
  ring.solid->tube = 0.0018453754833074943;
  MotionSpec spec = on_table(0.2548748241888096, coulomb(0.5351674314452965));
  spec.friction->boring = 0.00025824052325264414;
  spec.attitude.zxz = Vec3(0.5687957646604715, 2.5896114245171913, 0.07423969271986808);
  spec.spin.space = Vec3(-0.7501013533655482, 4.850538568794845, 29.765986676328108);
  spec.velocity = Vec3(0.1009967770612597, -0.21545782252522944, 0);
  const BodyModel model = with_needed_degrees(make_model(ring, spec));
  const Integration found = integrated(ring, spec, 1e-9);
  int held = 0;
  for (const double t : times_of(found, "slip_begins")) {
    const Touch touch = found.trajectory->contact_at(t)->touch;
    if (touch.sticks || !touch.keeps_from_boring) continue;
    ++held;
    const Reaction r = reaction_of(model, touch, t, moving_of(model, found.trajectory->at(t)));
    // at the limit of friction it grows from nothing, so that there is little to see at once
    const double along = r.slip_rate_S.dot(r.slip_direction_S);
    EXPECT_LT((r.slip_rate_S - along * r.slip_direction_S).norm(), 1e-3 * kG) << t;
    EXPECT_GT(along, -1e-6 * kG) << t;
  }
  EXPECT_GT(held, 0);
  const State fine = integrated(ring, spec, 1e-11).trajectory->at(0.25);
  EXPECT_LT(rotation_angle_between(found.trajectory->at(0.25).q, fine.q), 1e-6);
}

// Where a spin about the vertical passes through zero while the contact sticks, holding both would
// need more friction than there is; letting the spin go on spares the contact, which then sticks.
TEST(OnTable, WhatGivesWaySparesTheRest) {
  BodySpec ring = round_body("ring", 0.03669469084247925, 0.9122243474899219);
  MotionSpec spec = on_table(0.4, coulomb(0.3014501785623426));
  spec.friction->boring = 3.709106238416931e-05;
  spec.attitude.zxz = Vec3(-2.894871837221481, 1.5146550608892695, -1.030362143234245);
  spec.spin.body = Vec3(-1.5027952933817148, 0.2742679452997455, -0.24069631699446192);
  spec.velocity = Vec3(-0.0037508047017140783, -0.0212715483369181, 0);
  const Integration found = integrated(ring, spec, 1e-8);
  // the spin changes its sign at 0.278116 s
  for (const double t : {0.2785, 0.279, 0.28})
    EXPECT_TRUE(found.trajectory->contact_at(t)->touch.sticks) << t;
  const State fine = integrated(ring, spec, 1e-11).trajectory->at(0.4);
  EXPECT_LT(rotation_angle_between(found.trajectory->at(0.4).q, fine.q), 1e-6);
}

// A needle that slides with its tip ahead jams under strong friction, whether or not something
// keeps it from turning about the vertical.
TEST(OnTable, ANeedleJamsAlsoWhereMomentsHoldIt) {
  const BodySpec needle = ellipsoid_body(Vec3(0.01, 0.01, 0.3), 0.1);
  MotionSpec spec = on_table(1.0, coulomb(3.0));
  spec.friction->boring = 0.001;
  spec.attitude.tilt = 0.8;
  const BodyModel model = with_needed_degrees(make_model(needle, spec));
  Touch touch;
  touch.sticks = touch.keeps_from_rolling = false;
  Moving now = moving_of(model, start_state(model, spec));
  const SurfacePoint point = reaction_of(model, Touch{}, 0.0, now).point;
  now.velocity_S = horizontal(now.q * point.arm_P).normalized();
  touch.slip_S = now.velocity_S;
  for (const bool keeps : {false, true}) {
    touch.keeps_from_boring = keeps;
    expect_error([&] { reaction_of(model, touch, 0.0, now); },
                 Fault::check_failed,
                 "motion.friction",
                 "jams");
    // drawn the other way it does not
    Touch back = touch;
    back.slip_S = -touch.slip_S;
    Moving drawn = now;
    drawn.velocity_S = -now.velocity_S;
    EXPECT_GT(reaction_of(model, back, 0.0, drawn).normal, 0.0);
  }
}

// An ellipsoid that would jam if it slipped the other way: its slip ends, and it sticks. Held
// against the same motion from a little later on, when it sticks already.
TEST(OnTable, ASlipEndsAlsoWhereTheBodyWouldJamTheOtherWay) {
  BodySpec body;
  body.tensor = Mat3{{0.00044381082251881927, -6.606835515351377e-06, 1.8049511761929396e-05},
                     {-6.606835515351377e-06, 0.0005621116013520112, 2.0031348612824496e-05},
                     {1.8049511761929396e-05, 2.0031348612824496e-05, 0.0005376466333878821}};
  body.mass = 0.565799750948446;
  body.look = SolidSpec{};
  body.look->kind = "ellipsoid";
  body.look->semi_axes = Vec3(0.06549918742370313, 0.0325374397614445, 0.06667420086353146);
  body.look->at = Vec3(0.004482619028637301, -0.008908248081544274, -0.006930109619417611);
  MotionSpec spec = on_table(0.18, {});
  spec.attitude.quaternion = Eigen::Vector4d(
      -0.48267155064919276, -0.01642098371362095, -0.7321315139278785, -0.480356088544169);
  spec.spin.body = Vec3(-3.113430984344415, -0.934979757180893, -0.5029698505383741);
  spec.velocity = Vec3(1.1078359912233229, 0.6242151729221312, 0.0);
  spec.gravity = Vec3(-3.5998937177699806, -4.3215617179801535, -8.033383705571932);
  for (const double mu : {1.8, 2.5, 3.008207793101244, 4.0}) {
    spec.friction = coulomb(mu);
    spec.friction->turntable = 1.2078786485021633;
    const BodyModel model = with_needed_degrees(make_model(body, spec));
    const Integration fine = integrated(body, spec, 1e-11);
    ASSERT_FALSE(times_of(fine, "slip_ends").empty()) << mu;
    const double stops = times_of(fine, "slip_ends")[0];
    const State stuck = fine.trajectory->at(stops + 2e-4);
    ASSERT_TRUE(fine.trajectory->contact_at(stops + 2e-4)->touch.sticks) << mu;
    const Integration later =
        integrate_with(find_stepper("dop853"), model, stuck, 0.14 - stops, 1e-11);
    for (const double tolerance : {1e-6, 1e-8, 1e-9, 1e-10, 1e-11}) {
      const Integration found = integrated(body, spec, tolerance);
      const State end = found.trajectory->at(0.14 + 2e-4);
      EXPECT_LT(rotation_angle_between(end.q, later.trajectory->at(0.14 - stops).q),
                std::pow(tolerance, kPowerOfStopped) + 1e-8)
          << mu << ' ' << tolerance;
    }
  }
}

// the law itself: just beyond the end of a slip along x, with a little slip along y
TEST(OnTable, FrictionBeyondTheEndOfASlipBrakesWhatGoesToTheSide) {
  const BodyModel model = with_needed_degrees(make_model(ball_body(), on_table(1.0, coulomb(0.2))));
  Touch touch;
  touch.sticks = false;
  touch.slip_S = Vec3::UnitX();
  for (const double side : {-1e-3, 0.0, 1e-3}) {
    Moving now = moving_of(model, start_state(model, on_table(1.0, coulomb(0.2))));
    now.velocity_S = Vec3(-1e-3, side, 0);
    const Reaction beyond = reaction_of(model, touch, 0.0, now);
    now.velocity_S.x() = 1e-3;
    const Reaction before = reaction_of(model, touch, 0.0, now);
    EXPECT_LT((beyond.friction_S - before.friction_S).norm(), 1e-15) << side;
    EXPECT_LE(beyond.friction_S.y() * side, 0.0);
    EXPECT_LT(beyond.friction_S.x(), 0.0);
  }
}

// A ball with its mass off its middle rolls so fast that nothing presses it to the table, while
// rolling still needs friction: let go, it would sink into the table. Dry friction slips before.
TEST(OnTable, IdealRollingEndsWhereItNeedsFrictionWithoutPressure) {
  const BodySpec ball = tippe_top_body(0.46, 7.8 / 7.2);
  MotionSpec spec = on_table(0.6, rolling());
  spec.attitude.zxz = Vec3(0, 135.0 * kPi / 180.0, 0);
  spec.spin.space = Vec3(46, 0, 8);
  expect_error([&] { integrated(ball, spec, 1e-9); },
               Fault::check_failed,
               "motion.friction",
               "rolling needs a friction that holds the body while nothing presses it");
  spec.friction = coulomb(0.5);
  const Integration slips = integrated(ball, spec, 1e-9);
  for (double t = 0.0; t <= 0.6; t += 0.001) {
    const State s = slips.trajectory->at(t);
    const double gap = s.place_S.z() + (s.q * Vec3(0, 0, 0.46 * 0.02)).z() - 0.02;
    EXPECT_GT(gap, -1e-10) << t;
  }
}

// a disc that comes down rolling would be thrown up and come down for ever
TEST(OnTable, IdealRollingAfterALandingEndsInTheSameWay) {
  const BodySpec disc = disc_body(0.6979385273825542, 0.3590414473487886);
  MotionSpec spec = on_table(1.26, rolling());
  spec.attitude.quaternion = Eigen::Vector4d(
      0.05409574110831877, 0.19832972755578349, -0.21649690086749046, 0.9543940810149456);
  spec.spin.body = Vec3(-1.1738651211907483, -7.564532456566998, 11.601909052647349);
  spec.velocity = Vec3(0.6476855153854472, 0.5465004963744775, 1.4237396571799887);
  spec.position = Vec3(0, 0, 1.3555503019460517);
  expect_error([&] { integrated(disc, spec, 1e-9); },
               Fault::check_failed,
               "motion.friction",
               "rolling needs a friction that holds the body while nothing presses it");
}

// Where the accuracy is loose, the first runs are so coarse that they come to an end that the
// motion does not have. Finer runs pass it.
TEST(OnTable, AnEndThatOnlyCoarseRunsHaveIsNotThatOfTheMotion) {
  MotionSpec spec = on_table(0.353, coulomb(0.38));
  spec.attitude.zxz = Vec3(228.2, 73.9, 117.2) * (kPi / 180.0);
  spec.spin.body = Vec3(4.97, 0.46, -43.26);
  spec.position = Vec3(0, 0, 0.082);
  spec.velocity = Vec3(0.35, -0.03, 0);
  const State end = simulated(thin_ring(), spec, 1e-7).motion.state_at(0.353);
  for (const double accuracy : {0.5, 0.3}) {
    EXPECT_THROW(integrated(thin_ring(), spec, accuracy), Error) << accuracy;  // by one run of it
    const State found = simulated(thin_ring(), spec, accuracy).motion.state_at(0.353);
    EXPECT_LT(rotation_angle_between(found.q, end.q), accuracy);
  }
}

// Steps from a fall into a contact may be so long that numbers overflow: they are shortened.
TEST(OnTable, AStepThatOverflowsIsShortened) {
  MotionSpec spec = on_table(0.3, coulomb(0.78));
  spec.attitude.zxz = Vec3(26, 11, -25) * (kPi / 180.0);
  spec.spin.body = Vec3(-3.5, 1.9, -59);
  spec.position = Vec3(0, 0, 0.1);
  spec.velocity = Vec3(0.34, -0.29, 0);
  const State end = integrated(thin_ring(), spec, 1e-9).trajectory->at(0.3);
  for (const double tolerance : {1e-4, 7e-5, 5e-5, 4e-5, 3e-5, 2e-5}) {
    const Integration found = integrated(thin_ring(), spec, tolerance);
    EXPECT_LT(rotation_angle_between(found.trajectory->at(0.3).q, end.q), 100.0 * tolerance);
  }
}

// what would slide or turn on its face is refused, and a rest of the motion is told by its size
TEST(OnTable, ABodyLiesOnAFaceOnlyWhereItsMotionEnds) {
  const auto start = [](const Vec3& velocity, const Vec3& spin, double mu) {
    MotionSpec spec = on_table(1.0, coulomb(mu));
    spec.attitude.zxz = Vec3(0.0, 0.005, 0.0);
    spec.velocity = velocity;
    spec.spin.space = spin;
    return spec;
  };
  for (const MotionSpec& spec : {start(Vec3(0.1, 0.0, 0.0), Vec3::Zero(), 0.005),
                                 start(Vec3::Zero(), Vec3(0.0, 0.0, 3.0), 0.002)}) {
    expect_error([&] { integrated(disc_body(), spec, 1e-9); },
                 Fault::check_failed,
                 "motion.duration",
                 "a flat face");
  }
  MotionSpec settles = on_table(6.0, rolling());
  settles.friction->rolling = 4e-4;
  settles.attitude.zxz = Vec3(0.0, 0.35, 0.0);
  settles.spin.rates = Vec3(55.232227, 0.0, -51.884166);
  const IntegrationRecord record = integrated(disc_body(), settles, 1e-9).record;
  EXPECT_EQ(record.events.back().event, "lies_flat");
  EXPECT_GT(record.left_out_rad, 1e-4);
  EXPECT_LT(record.left_out_rad, 1e-2);
}

// where friction would jam, or two points touch, the program says so
TEST(OnTable, RefusesWhatItCannotFollow) {
  MotionSpec spec = on_table(5.0, rolling());
  spec.attitude.zxz = Vec3(0, 137.0 * kPi / 180.0, 0);
  spec.spin.space = Vec3(80.8, 0, 10);
  expect_error([&] { integrated(tippe_top_body(0.58, 7.8 / 7.2), spec, 1e-9); },
               Fault::check_failed,
               "motion.friction",
               "rolling needs a friction that holds the body");
  BodySpec cylinder = ball_body();
  cylinder.solid->kind = "cylinder";
  cylinder.solid->height = 0.06;
  spec = on_table(5.0, {});
  spec.attitude.tilt = 0.3;
  expect_error([&] { integrated(cylinder, spec, 1e-9); },
               Fault::check_failed,
               "motion.duration",
               "a flat face");
}

}  // namespace
}  // namespace polhode::test
