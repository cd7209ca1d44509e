// SPDX-License-Identifier: MIT
// What must hold for every body, on random ones.
#include "support/properties.h"

#include <Eigen/Eigenvalues>

#include "model/body_model.h"
#include "model/rigid_body.h"

namespace polhode {
namespace {

using namespace test;

std::vector<PointMass> any_points(int count) {
  std::vector<PointMass> points;
  for (int i = 0; i < count; ++i)
    points.push_back({number_between(0.01, 3.0), vector_within(2.0)});
  return points;
}

// the triangle inequality is a theorem (notes, errata row 10)
RC_GTEST_PROP(AnyBody, MomentsObeyTheTriangleInequality, ()) {
  const MassProperties body = of_points(any_points(*rc::gen::inRange(4, 12)));
  const Vec3 moments = Eigen::SelfAdjointEigenSolver<Mat3>(body.tensor).eigenvalues();
  RC_ASSERT(impossible_moments(moments).empty());
}

RC_GTEST_PROP(AnyBody, PrincipalFrameIsRightHandedAndDiagonal, ()) {
  BodySpec spec;
  for (const PointMass& p : any_points(*rc::gen::inRange(4, 12)))
    spec.points.push_back({p.mass, p.at});
  const BodyModel model = make_model(spec, false, Vec3::Zero());
  RC_ASSERT(std::abs(model.R_BP.determinant() - 1.0) < 1e-12);
  const Mat3 back = model.R_BP * model.moments.asDiagonal() * model.R_BP.transpose();
  RC_ASSERT((back - model.body.tensor).norm() < 1e-12 * model.body.tensor.norm());
}

// the parallel-axis theorem from any point to any other (notes eq. 11, corrected)
RC_GTEST_PROP(AnyBody, TensorAboutAnyPoint, ()) {
  const std::vector<PointMass> points = any_points(6);
  const MassProperties body = of_points(points);
  const Vec3 from = vector_within(5.0), shift = vector_within(5.0);
  const Mat3 there = tensor_with_origin_moved(
      tensor_about(body, from), body.mass, body.mass * (body.center - from), shift);
  const Mat3 wanted = inertia_tensor(points, from + shift);
  RC_ASSERT((there - wanted).norm() < 1e-11 * (1.0 + wanted.norm()));
}

// a whole is the sum of its halves, and turning it turns its tensor
RC_GTEST_PROP(AnyBody, ComposesAndTurns, ()) {
  const std::vector<PointMass> one = any_points(5), other = any_points(4);
  std::vector<PointMass> all = one;
  all.insert(all.end(), other.begin(), other.end());
  const MassProperties whole = of_points(all);
  const MassProperties composed_whole = composed({of_points(one), of_points(other)});
  RC_ASSERT((whole.tensor - composed_whole.tensor).norm() < 1e-12 * whole.tensor.norm());
  const Mat3 R = any_attitude().toRotationMatrix();
  const Vec3 shift = vector_within(3.0);
  for (PointMass& p : all)
    p.at = R * p.at + shift;
  const MassProperties turned = of_points(all);
  RC_ASSERT((turned.tensor - moved(whole, R, shift).tensor).norm() < 1e-12 * whole.tensor.norm());
}

}  // namespace
}  // namespace polhode
