// SPDX-License-Identifier: MIT
// Torques and forces on a body, ready for the equations of motion:
//   dy/dt = y x omega + tau,   dP/dt = F   (notes, eqs. 19 to 22).
#pragma once

#include <string>
#include <vector>

#include "math/notation.h"
#include "model/load_spec.h"

namespace polhode {

// One row per kind: the keys that it needs and those that it may have.
struct LoadKind {
  std::string name;
  std::string doc;
  std::vector<std::string> needs;
  std::vector<std::string> takes;
  bool directed = false;  // needs one of space and body
};
const std::vector<LoadKind>& load_kinds();

// A load in principal axes P, about the reference point.
struct Load {
  enum class Kind { torque, damp_momentum, damp_spin, couple, force, spring };
  Kind kind = Kind::torque;
  bool in_body = false;        // `vector` is in P, else in S
  Vec3 vector = Vec3::Zero();  // torque, N m, or force, N
  Vec3 arm_P =
      Vec3::Zero();          // from the reference point, m; of a couple from one force to the other
  Vec3 at_P = Vec3::Zero();  // where it acts, from the reference point, m
  Vec3 anchor_S = Vec3::Zero();  // of a spring, m
  double k = 0.0;                // N/m
  double length = 0.0;           // m
  double c = 0.0;                // 1/s or N m s
  double rate = 0.0;             // rad/s
  double phase = 0.0;            // rad

  // the force or torque does not change with time, nor turn with the body, nor damp: it has a
  // potential
  bool conservative() const;
};

// A force in space axes on the centre of mass, F cos(rate t + phase): its path is known in closed
// form, whatever the body turns like.
struct Push {
  Vec3 force_S = Vec3::Zero();  // N
  double rate = 0.0;            // rad/s
  double phase = 0.0;           // rad
};

// What a [motion] table's loads are for a body.
struct Loads {
  std::vector<Load> turning;  // with a torque about the reference point, or a force that depends on
                              // attitude or place
  std::vector<Push> pushes;   // on a free body
  std::vector<Load> listed;   // as the scene lists them, for pictures
  // The path of the centre of mass depends on attitude or place: six degrees of freedom.
  bool need_place = false;

  bool empty() const { return turning.empty() && pushes.empty(); }
  // nothing turns the body but -c L; c is the sum
  bool only_damp_momentum() const;
  double momentum_damping() const;
};

// reference_B: the fixed point or the centre of mass; R_BP: principal axes as columns. Throws Error
// (input) with key motion.torque[i].NAME.
Loads make_loads(const std::vector<LoadSpec>& specs,
                 bool on_pivot,
                 const Vec3& center_B,
                 const Vec3& reference_B,
                 const Mat3& R_BP);

// Torque about the reference point in P, N m, and the force of attitude and place in S, N.
struct Wrench {
  Vec3 torque_P = Vec3::Zero();
  Vec3 force_S = Vec3::Zero();
};

// q maps P to S; y and w_P momentum and angular velocity in P; place_S: the reference point, m.
Wrench wrench_of(const std::vector<Load>& loads,
                 double t,
                 const Quat& q,
                 const Vec3& y,
                 const Vec3& w_P,
                 const Vec3& place_S);

// The force of one load on the point where it acts, S, N; zero for what is no force.
Vec3 point_force(const Load& load, double t, const Quat& q, const Vec3& place_S);

// Potential of the conservative loads, J; that of a constant force is zero when its point is at the
// reference point.
double potential_of(const std::vector<Load>& loads, const Quat& q, const Vec3& place_S);
// A size of it that does not vanish where the potential happens to, J.
double potential_scale(const std::vector<Load>& loads, const Quat& q, const Vec3& place_S);

// How far (m, per kg of mass) and how fast (m/s, per kg) a push has moved a body after t.
Vec3 way_of(const Push& push, double t);
Vec3 speed_of(const Push& push, double t);

}  // namespace polhode
