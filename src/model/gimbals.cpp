// SPDX-License-Identifier: MIT
#include "model/gimbals.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "math/so3.h"

namespace polhode {
namespace {

// the axes of the inner ring in P: line of nodes, across it and the axle, axle
Mat3 inner_axes_P(const Gimbals& gimbals, double psi) {
  Mat3 axes;
  axes.col(0) = gimbals.axes_P * Vec3(std::cos(psi), -std::sin(psi), 0.0);
  axes.col(1) = gimbals.axes_P * Vec3(std::sin(psi), std::cos(psi), 0.0);
  axes.col(2) = gimbals.axes_P.col(2);
  return axes;
}

// the vertical, seen by the inner ring
Vec3 vertical_in_ring(double theta) {
  return {0.0, std::sin(theta), std::cos(theta)};
}

// angular velocity of the inner ring in its own axes
Vec3 rate_of_inner(const GimbalPose& pose) {
  return pose.rates[1] * Vec3::UnitX() + pose.rates[0] * vertical_in_ring(pose.angles[1]);
}

// of the frame, in the axes of the inner ring
Vec3 frame_in_ring(const Gimbals& gimbals, const Vec3& angles) {
  const Vec3 frame_P = attitude_of(gimbals, angles).conjugate() * gimbals.frame_S;
  return inner_axes_P(gimbals, angles[2]).transpose() * frame_P;
}

// moment of both rings about the vertical
double about_vertical(const Gimbals& gimbals, double theta) {
  const Vec3 up = vertical_in_ring(theta);
  return gimbals.outer + up.dot(gimbals.inner.cwiseProduct(up));
}

// the angular velocity of the body about the axes of the inner ring
Vec3 rate_in_ring(const GimbalPose& pose) {
  return rate_of_inner(pose) + pose.rates[2] * Vec3::UnitZ();
}

// The same of its acceleration, but for what comes from accelerations of the angles: products of
// rates, of which those that cancel near gimbal lock are taken together.
Vec3 rest_in_ring(const GimbalPose& pose) {
  const Vec3 up = vertical_in_ring(pose.angles[1]);
  const Vec3& rates = pose.rates;
  return {up.y() * rates[0] * rates[2],
          (up.z() * rates[0] - rates[2]) * rates[1],
          -up.y() * rates[0] * rates[1]};
}

// How the rings speed up: phi'' and theta'', and in place of psi'' that of the body about its axle
// as the inner ring sees it, psi'' + phi'' cos(theta). In gimbal lock, where the vertical is the
// axle, phi'' and psi'' may be large and cancel.
Vec3 speed_up(const Gimbals& gimbals,
              const GimbalPose& pose,
              const Vec3& moments,
              const Vec3& others_P) {
  const Vec3& rates = pose.rates;
  const Mat3 axes = inner_axes_P(gimbals, pose.angles[2]);
  const Mat3 body = axes.transpose() * moments.asDiagonal() * axes;
  const Vec3 up = vertical_in_ring(pose.angles[1]);
  const Vec3 w = axes * rate_in_ring(pose);
  const Vec3 on_body =
      axes.transpose() * (moments.cwiseProduct(w).cross(w) + others_P) - body * rest_in_ring(pose);

  // what turns the inner ring besides its accelerations, about its own axes
  const Vec3& J = gimbals.inner;
  const Vec3 ring = rate_of_inner(pose);
  const Vec3 bent = rates[0] * rates[1] * Vec3(0.0, up.z(), -up.y());
  const Vec3 held = J.cwiseProduct(bent) + ring.cross(J.cwiseProduct(ring)) -
                    frame_torque(J, ring, frame_in_ring(gimbals, pose.angles));

  // The first equation is that of turns about the vertical less that of turns about the axle times
  // cos(theta): of turns across the axle, times sin(theta).
  const Vec3 across(up.y(), 1.0, 1.0);
  const Mat3 in_order = Mat3{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}};  // across, nodes, axle
  Mat3 mass = across.asDiagonal() * in_order * body * in_order.transpose() * across.asDiagonal();
  mass(0, 0) += about_vertical(gimbals, pose.angles[1]);
  mass(1, 1) += J.x();
  const Vec3 dragged = gimbals.friction.cwiseProduct(rates);
  Vec3 turned = across.cwiseProduct(in_order * on_body);
  turned -=
      Vec3(held.dot(up) + dragged[0] - up.z() * dragged[2], held.x() + dragged[1], dragged[2]);

  const int clamped = gimbals.clamp == Gimbals::Clamp::outer   ? 0
                      : gimbals.clamp == Gimbals::Clamp::inner ? 1
                                                               : -1;
  if (clamped >= 0) {
    mass.row(clamped) = Vec3::Unit(clamped).transpose();
    turned[clamped] = 0.0;
  }
  return mass.inverse() * turned;
}

}  // namespace

bool Gimbals::idle() const {
  return outer == 0.0 && inner.isZero(0.0) && friction.isZero(0.0) && clamp == Clamp::none;
}

Mat3 turning_axes_P(const Gimbals& gimbals, const Vec3& angles) {
  const Mat3 ring = inner_axes_P(gimbals, angles[2]);
  Mat3 axes;
  axes.col(0) = ring * vertical_in_ring(angles[1]);
  axes.col(1) = ring.col(0);
  axes.col(2) = ring.col(2);
  return axes;
}

Quat attitude_of(const Gimbals& gimbals, const Vec3& angles) {
  return Quat(gimbals.axes_S) * from_zxz_angles(angles) * Quat(gimbals.axes_P).conjugate();
}

Vec3 angular_velocity_of(const Gimbals& gimbals, const GimbalPose& pose) {
  return turning_axes_P(gimbals, pose.angles) * pose.rates;
}

GimbalPose pose_of(const Gimbals& gimbals, const Quat& q, const Vec3& w_P, double near_phi) {
  // the body as the frames of the rings see it
  const Mat3 body = gimbals.axes_S.transpose() * q.toRotationMatrix() * gimbals.axes_P;
  const Vec3 w = gimbals.axes_P.transpose() * w_P;
  const Vec3 axle = body.col(2);
  GimbalPose pose;
  Vec3 nodes = Vec3(-axle.y(), axle.x(), 0.0).normalized();  // Z x axle
  if (nodes.x() * std::cos(near_phi) + nodes.y() * std::sin(near_phi) < 0.0) nodes = -nodes;
  const Vec3 nodes_B = body.transpose() * nodes;
  pose.angles[0] = std::atan2(nodes.y(), nodes.x());
  pose.angles[1] = std::atan2(Vec3::UnitZ().cross(axle).dot(nodes), axle.z());
  pose.angles[2] = std::atan2(-nodes_B.y(), nodes_B.x());
  const Vec3 across_B = Vec3::UnitZ().cross(nodes_B);
  pose.rates[0] = w.dot(across_B) / std::sin(pose.angles[1]);
  pose.rates[1] = w.dot(nodes_B);
  pose.rates[2] = w.z() - pose.rates[0] * axle.z();
  return pose;
}

Vec3 accelerations(const Gimbals& gimbals,
                   const GimbalPose& pose,
                   const Vec3& moments,
                   const Vec3& others_P) {
  const Vec3 found = speed_up(gimbals, pose, moments, others_P);
  return {found[0], found[1], found[2] - std::cos(pose.angles[1]) * found[0]};
}

Vec3 torque_of_rings(const Gimbals& gimbals,
                     const GimbalPose& pose,
                     const Vec3& moments,
                     const Vec3& others_P) {
  const Mat3 axes = inner_axes_P(gimbals, pose.angles[2]);
  const Vec3 w = axes * rate_in_ring(pose);
  const Vec3 found = speed_up(gimbals, pose, moments, others_P);
  const Vec3 faster(found[1], std::sin(pose.angles[1]) * found[0], found[2]);
  const Vec3 acceleration = axes * (faster + rest_in_ring(pose));
  return moments.cwiseProduct(acceleration) - moments.cwiseProduct(w).cross(w) - others_P;
}

double size_of_rates(
    const Gimbals& gimbals, double theta, double nearby, double moment, const Vec3& rates) {
  const double across = std::min(1.0, std::abs(std::sin(theta)) + nearby);
  const double axle = rates[2] + std::cos(theta) * rates[0];
  const double of_body = Vec3(across * rates[0], rates[1], axle).squaredNorm();
  const double of_rings = 2.0 * kinetic_energy(gimbals, {Vec3(0.0, theta, 0.0), rates});
  return std::sqrt(of_body + of_rings / moment);
}

double kinetic_energy(const Gimbals& gimbals, const GimbalPose& pose) {
  return 0.5 * (gimbals.inner.x() * pose.rates[1] * pose.rates[1] +
                about_vertical(gimbals, pose.angles[1]) * pose.rates[0] * pose.rates[0]);
}

double frame_potential(const Gimbals& gimbals, const Vec3& angles) {
  const Vec3 frame = frame_in_ring(gimbals, angles);
  return -0.5 * frame.dot(gimbals.inner.cwiseProduct(frame));
}

Vec3 frame_torque(const Vec3& moments, const Vec3& w, const Vec3& frame) {
  const Vec3 L_frame = moments.cwiseProduct(frame);
  return -(moments.cwiseProduct(frame.cross(w)) + w.cross(L_frame) +
           frame.cross(moments.cwiseProduct(w)) + frame.cross(L_frame));
}

}  // namespace polhode
