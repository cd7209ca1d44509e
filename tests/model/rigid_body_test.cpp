// SPDX-License-Identifier: MIT
#include "model/rigid_body.h"

#include <cmath>

#include <gtest/gtest.h>

#include "math/so3.h"
#include "support/particles.h"

namespace polhode::test {
namespace {

// the particles are the oracle: sums over twelve of them, of order one
constexpr double kRoundOff = 3e-14;

TEST(RigidBody, PointVelocityIsTheRateOfAMovingPoint) {
  const Vec3 V(0.3, -0.1, 0.7), Omega(0.5, 1.1, -0.4), r(0.2, 0.9, -0.6);
  const auto place = [&](double t) {
    return Vec3(t * V + exp_rotation(t * Omega) * r);
  };
  const double h = 1e-5;
  EXPECT_LE(((place(h) - place(-h)) / (2.0 * h) - point_velocity(V, Omega, r)).norm(), 1e-10);
}

TEST(RigidBody, TensorOfFourPointsFollowsTheDefinition) {
  // 2 kg each at (+-3, 0, 0) and (0, +-1, 0): about the centre diag(4, 36, 40)
  const std::vector<PointMass> cross = {
      {2, {3, 0, 0}}, {2, {-3, 0, 0}}, {2, {0, 1, 0}}, {2, {0, -1, 0}}};
  const Mat3 wanted = Vec3(4, 36, 40).asDiagonal();
  EXPECT_EQ((inertia_tensor(cross, Vec3::Zero()) - wanted).norm(), 0.0);
  // Steiner: 8 kg at 2 m along z
  const Mat3 lower = Vec3(4 + 32, 36 + 32, 40).asDiagonal();
  EXPECT_EQ((inertia_tensor(cross, {0, 0, -2}) - lower).norm(), 0.0);
}

TEST(RigidBody, AMovedOriginNeedNotBeTheCenter) {
  for (int seed = 1; seed <= 5; ++seed) {
    const Particles body = random_particles(seed);
    Vec3 first = Vec3::Zero();
    double mass = 0.0;
    for (const PointMass& p : body.points) {
      first += p.mass * p.at;
      mass += p.mass;
    }
    const Vec3 a(0.4, -1.3, 0.8);
    const Mat3 moved =
        tensor_with_origin_moved(inertia_tensor(body.points, Vec3::Zero()), mass, first, a);
    EXPECT_LE((moved - inertia_tensor(body.points, a)).norm(), kRoundOff) << seed;
  }
}

TEST(RigidBody, MomentumAndEnergyAreSumsOverParticles) {
  for (int seed = 1; seed <= 5; ++seed) {
    const Particles body = random_particles(seed);
    const Vec3 origin(0.2, -0.5, 0.3);  // moves with V
    Vec3 L = Vec3::Zero();
    double energy = 0.0;
    for (const PointMass& p : body.points) {
      const Vec3 r = p.at - origin;
      L += p.mass * r.cross(body.Omega.cross(r));
      energy += 0.5 * p.mass * (body.V + body.Omega.cross(r)).squaredNorm();
    }
    const Mat3 tensor = inertia_tensor(body.points, origin);
    EXPECT_LE((angular_momentum(tensor, body.Omega) - L).norm(), kRoundOff) << seed;
    const KineticEnergy split = kinetic_energy(of_points(body.points), origin, body.V, body.Omega);
    EXPECT_NEAR(split.total(), energy, kRoundOff) << seed;
    EXPECT_GT(std::abs(split.coupling), 1e-3) << "about no centre of mass";
  }
}

}  // namespace
}  // namespace polhode::test
