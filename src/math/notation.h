// SPDX-License-Identifier: MIT
// clang-format off
// The conventions for frames, quaternions and angles used everywhere in the program.
//
// Frames, all right-handed, named by a letter:
//   S  space: inertial, axes XYZ; "up" is against gravity
//   B  body: the axes of the scene file, fixed in the body
//   P  principal: principal axes of inertia about the reference point, fixed in the body
// The reference point is the fixed point of a body on a pivot, else the centre of mass.
//
//   R_SB, q_SB   rotates components in B into components in S: v_S = R_SB v_B (adjacent letters
//                cancel)
//   w_P          angular velocity of the body relative to space, components in P (rad/s)
//   y            angular momentum about the reference point, components in P (kg m^2/s); y = I w_P
//   L_S          the same vector, components in S
//   torque_P     torque about the reference point, components in P (N m)
//   g_S          acceleration of gravity, components in S (m/s^2)
//
// Quaternions are Hamilton's, unit, written (w, x, y, z); o is their product. Equations of motion
// (Hairer, Lubich, Wanner, Geometric Numerical Integration, VII.5):
//   dy/dt = y x w + torque_P,   dq/dt = q o (0, w_P) / 2
// Euler angles are zxz: R_SB = Rz(phi) Rx(theta) Rz(psi); theta is the tilt of the body's third
// axis.
// clang-format on
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace polhode {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;  // constructor order (w, x, y, z)

}  // namespace polhode
