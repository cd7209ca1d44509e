// SPDX-License-Identifier: MIT
#include "model/fall_on_table.h"

#include <cmath>
#include <random>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace polhode {
namespace {

// a point of a body of 1 kg that comes down, and its mobility in space
struct Falling {
  Mat3 mobility;
  Vec3 before;
};

Falling random_fall(std::mt19937& numbers) {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto vector = [&] {
    return Vec3(any(numbers), any(numbers), any(numbers));
  };
  const Vec3 p = vector().cwiseAbs2() + Vec3::Constant(1e-3);
  const Vec3 moments = Vec3(p.y() + p.z(), p.z() + p.x(), p.x() + p.y());
  const Mat3 R =
      Quat(any(numbers), any(numbers), any(numbers), any(numbers)).normalized().toRotationMatrix();
  const Mat3 inverse = R * moments.cwiseInverse().asDiagonal() * R.transpose();
  const Vec3 arm = vector() - Vec3::UnitZ();
  Mat3 across;
  across << 0, -arm.z(), arm.y(), arm.z(), 0, -arm.x(), -arm.y(), arm.x(), 0;
  Vec3 before = vector();
  before.z() = -std::abs(before.z()) - 0.1;
  return {Mat3::Identity() - across * inverse * across, before};
}

double energy_gained(const Falling& fall, const Vec3& impulse) {
  return impulse.dot(fall.before + 0.5 * (fall.mobility * impulse));
}

Friction law(Friction::Kind kind, double value = 0.0) {
  Friction friction;
  friction.kind = kind;
  (kind == Friction::Kind::viscous ? friction.c : friction.mu) = value;
  return friction;
}

// the same by many small normal impulses; a slip below `rest` is held, if friction can
Vec3 by_small_impulses(const Falling& fall, const Friction& friction, double restitution) {
  constexpr int kSteps = 40'000;
  constexpr double kRest = 1e-3;
  const Mat3& K = fall.mobility;
  const double step = std::abs(fall.before.z()) / K(2, 2) / kSteps;
  const Eigen::Vector2d level = -K.topLeftCorner<2, 2>().inverse() * K.topRightCorner<2, 1>();
  Vec3 v = fall.before, total = Vec3::Zero();
  double taken = 0.0, given = 0.0;
  for (int i = 0; i < 100 * kSteps; ++i) {
    const Vec3 slip(v.x(), v.y(), 0.0);
    Vec3 force = Vec3::UnitZ();
    if (friction.kind == Friction::Kind::viscous) force -= friction.c * slip;
    if (friction.kind == Friction::Kind::coulomb) {
      const bool rests = slip.norm() < kRest * std::abs(fall.before.z());
      if (rests && level.norm() <= friction.mu) {
        force.head<2>() = level;
      } else {
        force -= friction.mu * slip.normalized();
      }
    }
    total += step * force;
    const Vec3 next = v + step * (K * force);
    const double work = 0.5 * step * (v.z() + next.z());
    v = next;
    if (given == 0.0 && v.z() < 0.0) {
      taken -= work;
    } else {
      given += work;
      if (given >= restitution * restitution * taken) break;
    }
  }
  return total;
}

TEST(FallOnTable, IsThatOfManySmallImpulses) {
  std::mt19937 numbers(3);
  double worst = 0.0;
  for (int i = 0; i < 20; ++i) {
    const Falling fall = random_fall(numbers);
    for (const Friction& friction : {law(Friction::Kind::none),
                                     law(Friction::Kind::viscous, 0.3),
                                     law(Friction::Kind::viscous, 20.0),
                                     law(Friction::Kind::coulomb, 0.1),
                                     law(Friction::Kind::coulomb, 0.6)}) {
      for (const double restitution : {0.0, 0.5, 1.0}) {
        const Vec3 impulse = impulse_of_fall(fall.mobility, friction, restitution, fall.before);
        const Vec3 other = by_small_impulses(fall, friction, restitution);
        worst = std::max(worst, (impulse - other).norm() / other.norm());
        ASSERT_LT((impulse - other).norm(), 5e-3 * other.norm())
            << i << ' ' << restitution << ' ' << friction.mu << ' ' << friction.c;
      }
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

// Where friction is just what keeps a slip from growing, the slip neither ends nor grows for long,
// in its own direction; a little more or less friction makes a little difference.
TEST(FallOnTable, ChangesLittleWithFrictionWhereSlipHardlyDies) {
  std::mt19937 numbers(7);
  for (int i = 0; i < 50; ++i) {
    const Falling fall = random_fall(numbers);
    const Mat3& K = fall.mobility;
    const double limit = (K.topLeftCorner<2, 2>().inverse() * K.topRightCorner<2, 1>()).norm();
    const auto impulse = [&](double mu) {
      return impulse_of_fall(K, law(Friction::Kind::coulomb, mu), 0.5, fall.before);
    };
    const Vec3 at = impulse(limit);
    for (const double part : {-1e-6, -1e-9, 1e-9, 1e-6}) {
      EXPECT_LT((impulse(limit * (1.0 + part)) - at).norm(),
                100.0 * std::abs(part) * at.norm() + 1e-9)
          << i << ' ' << part;
    }
  }
}

// Newton's rule with Coulomb's cone made up to 3.5 times the energy of the normal velocity
TEST(FallOnTable, MakesNoEnergy) {
  std::mt19937 numbers(4);
  for (int i = 0; i < 300; ++i) {
    const Falling fall = random_fall(numbers);
    const double scale = fall.before.dot(fall.mobility.inverse() * fall.before);
    for (const Friction& friction : {law(Friction::Kind::none),
                                     law(Friction::Kind::rolling),
                                     law(Friction::Kind::viscous, 1e-6),
                                     law(Friction::Kind::viscous, 1.0),
                                     law(Friction::Kind::viscous, 1e5),
                                     law(Friction::Kind::coulomb, 0.2),
                                     law(Friction::Kind::coulomb, 1.0)}) {
      const Vec3 impulse = impulse_of_fall(fall.mobility, friction, 1.0, fall.before);
      ASSERT_TRUE(impulse.allFinite());
      ASSERT_LT(energy_gained(fall, impulse), 1e-10 * scale) << i << ' ' << friction.mu;
      ASSERT_GT((fall.before + fall.mobility * impulse).z(), -1e-10) << i << ' ' << friction.mu;
    }
  }
}

// a ball: its centre is above the contact
TEST(FallOnTable, OfABallReversesItsSpeed) {
  const Mat3 K = Vec3(3.5, 3.5, 1.0).asDiagonal();
  for (const double restitution : {0.0, 0.3, 1.0}) {
    for (const Friction& friction : {law(Friction::Kind::none),
                                     law(Friction::Kind::rolling),
                                     law(Friction::Kind::viscous, 1000.0),
                                     law(Friction::Kind::coulomb, 0.1),
                                     law(Friction::Kind::coulomb, 10.0)}) {
      const Vec3 before(0.3, 0.4, -2.0);
      const Vec3 after = before + K * impulse_of_fall(K, friction, restitution, before);
      EXPECT_NEAR(after.z(), 2.0 * restitution, 1e-12) << friction.mu << ' ' << friction.c;
    }
    const Vec3 slides(3.0, 4.0, -2.0);
    const Vec3 impulse = impulse_of_fall(K, law(Friction::Kind::coulomb, 0.1), restitution, slides);
    EXPECT_NEAR(impulse.head<2>().norm(), 0.1 * impulse.z(), 1e-12);
  }
}

}  // namespace
}  // namespace polhode
