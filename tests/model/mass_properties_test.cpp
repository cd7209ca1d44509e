// SPDX-License-Identifier: MIT
#include "model/mass_properties.h"

#include <gtest/gtest.h>

#include "math/so3.h"

namespace polhode {
namespace {

// sum of m (r^2 1 - r r^T) over points, about `about`: the definition (notes eqs. 6, 8)
Mat3 tensor_by_definition(const std::vector<PointMass>& points, const Vec3& about) {
  Mat3 sum = Mat3::Zero();
  for (const PointMass& p : points) {
    const Vec3 r = p.at - about;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        sum(i, j) += p.mass * ((i == j ? r.dot(r) : 0.0) - r[i] * r[j]);
    }
  }
  return sum;
}

const std::vector<PointMass> kPoints = {
    {1.0, {0.2, 0.0, -1.0}}, {2.5, {-0.7, 0.4, 0.3}}, {0.5, {1.0, -1.0, 2.0}}, {3.0, {0, 0.6, 0}}};

TEST(OfPoints, FollowsTheDefinition) {
  const MassProperties body = of_points(kPoints);
  EXPECT_DOUBLE_EQ(body.mass, 7.0);
  const Vec3 center =
      (1.0 * kPoints[0].at + 2.5 * kPoints[1].at + 0.5 * kPoints[2].at + 3.0 * kPoints[3].at) / 7.0;
  EXPECT_LE((body.center - center).norm(), 1e-15);
  EXPECT_LE((body.tensor - tensor_by_definition(kPoints, center)).norm(), 1e-14);
}

TEST(TensorAbout, IsTheTensorAboutThatPoint) {
  const Vec3 about(0.3, -2.0, 1.1);
  const Mat3 expected = tensor_by_definition(kPoints, about);
  EXPECT_LE((tensor_about(of_points(kPoints), about) - expected).norm(), 1e-14 * expected.norm());
}

TEST(Moved, TurnsAndShiftsEveryPoint) {
  const Mat3 R = exp_rotation({0.5, -0.8, 1.9}).toRotationMatrix();
  const Vec3 shift(3.0, -1.0, 0.5);
  std::vector<PointMass> points = kPoints;
  for (PointMass& p : points)
    p.at = R * p.at + shift;
  const MassProperties expected = of_points(points);
  const MassProperties found = moved(of_points(kPoints), R, shift);
  EXPECT_LE((found.center - expected.center).norm(), 2e-15);
  EXPECT_LE((found.tensor - expected.tensor).norm(), 5e-14);
}

TEST(Composed, IsTheBodyOfAllPoints) {
  const MassProperties whole =
      composed({of_points({kPoints[0], kPoints[2]}), of_points({kPoints[1], kPoints[3]})});
  const MassProperties expected = of_points(kPoints);
  EXPECT_DOUBLE_EQ(whole.mass, expected.mass);
  EXPECT_LE((whole.center - expected.center).norm(), 1e-15);
  EXPECT_LE((whole.tensor - expected.tensor).norm(), 1e-14);
}

TEST(Composed, KeepsDigitsFarFromTheOrigin) {
  // a kilometre away nothing of the tensor is lost but what storing the places loses
  std::vector<PointMass> far = kPoints;
  for (PointMass& p : far)
    p.at += Vec3(1024.0, 0.0, 0.0);
  EXPECT_LE((of_points(far).tensor - of_points(kPoints).tensor).norm(), 1e-11);
}

}  // namespace
}  // namespace polhode
