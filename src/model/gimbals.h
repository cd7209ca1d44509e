// SPDX-License-Identifier: MIT
// Gimbals with inertia and friction: two rings that carry a body on a pivot. The outer ring turns
// by phi about the vertical, the inner one in it by theta about the line of nodes, the body in that
// by psi about its axle: the zxz angles. Unlike the attitude of the body alone, they tell where the
// rings are while the axle is upright (gimbal lock), so that motion is integrated in them.
#pragma once

#include "math/notation.h"
#include "model/gimbals_spec.h"

namespace polhode {

// Gimbals in the form that the equations of motion use.
struct Gimbals {
  enum class Clamp { none, outer, inner };
  Mat3 axes_P = Mat3::Identity();  // columns: two directions across the axle, and the axle; in P
  Mat3 axes_S = Mat3::Identity();  // columns: two directions across the vertical, the first of
                                   // which is the line of nodes at phi = 0, and the vertical; in S
  double outer = 0.0;              // see GimbalsSpec
  Vec3 inner = Vec3::Zero();
  Vec3 friction = Vec3::Zero();
  Clamp clamp = Clamp::none;
  Vec3 frame_S = Vec3::Zero();  // angular velocity of the frame of reference, rad/s

  // Whether they do nothing: rings without mass that turn freely.
  bool idle() const;
};

// The rings at a moment.
struct GimbalPose {
  Vec3 angles = Vec3::Zero();  // phi, theta, psi, rad; theta has either sign
  Vec3 rates = Vec3::Zero();   // their rates, rad/s
};

// The axes about which the angles turn, at psi, in P: the vertical, the line of nodes, the axle.
Mat3 turning_axes_P(const Gimbals& gimbals, const Vec3& angles);

// The attitude (P to S) and the angular velocity (P, rad/s) of the body.
Quat attitude_of(const Gimbals& gimbals, const Vec3& angles);
Vec3 angular_velocity_of(const Gimbals& gimbals, const GimbalPose& pose);

// The pose of a body with attitude q (P to S) and angular velocity w_P (rad/s), whose axle is not
// vertical: near there it has their round-off over sin(theta), squared in the rates. Of the two
// ends of the line of nodes phi points to that which is nearer to `near_phi`; psi is within half a
// turn.
GimbalPose pose_of(const Gimbals& gimbals, const Quat& q, const Vec3& w_P, double near_phi);

// The accelerations of the angles, rad/s^2. moments: of the body about the pivot, along P, kg m^2;
// others_P: the torque on it of everything else, in P, N m.
//
// Virtual turns about the three axes E = (Z, n, a), in which w = E rates: E^T (I w' - y x w -
// others) and what turns the rings add up to minus the friction in the bearings (d'Alembert's
// principle; Arnold, Mathematical Methods of Classical Mechanics, section 21).
Vec3 accelerations(const Gimbals& gimbals,
                   const GimbalPose& pose,
                   const Vec3& moments,
                   const Vec3& others_P);

// The torque of the rings on the body, in P, N m; arguments as above.
Vec3 torque_of_rings(const Gimbals& gimbals,
                     const GimbalPose& pose,
                     const Vec3& moments,
                     const Vec3& others_P);

// The norm of rates (rad/s) of the angles while theta (rad) is so, or off by `nearby`: that of the
// angular velocity they give the body, rad/s, with the moments of the rings over `moment` (kg m^2)
// in it. Near gimbal lock those of phi and psi may be large and give little.
double size_of_rates(
    const Gimbals& gimbals, double theta, double nearby, double moment, const Vec3& rates);

// Kinetic energy of the rings, J; and their potential energy in a frame that rotates, J.
double kinetic_energy(const Gimbals& gimbals, const GimbalPose& pose);
double frame_potential(const Gimbals& gimbals, const Vec3& angles);

// The torque (N m) that a body seems to feel in a frame that turns at W = `frame` (rad/s), besides
// its own y x w: -(I (W x w) + w x I W + W x I w + W x I W). All in the principal axes of the body;
// moments in kg m^2; w in rad/s, relative to the frame. It has the potential -W . I W / 2.
Vec3 frame_torque(const Vec3& moments, const Vec3& w, const Vec3& frame);

}  // namespace polhode
