// SPDX-License-Identifier: MIT
// Loads, which are the torques and forces on a body besides gravity, in the form that the equations
// of motion use:
//   dy/dt = y x omega + tau,   dP/dt = F   (lecture notes, eqs. 19 to 22; see docs/theory.md).
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "math/notation.h"
#include "model/gimbals.h"
#include "model/load_spec.h"

namespace polhode {

// A kind of load, with the keys that it needs and those that it may have.
struct LoadKind {
  std::string name;
  std::string doc;                 // one phrase, for help
  std::vector<std::string> needs;  // keys of LoadSpec that must be given
  std::vector<std::string> takes;  // keys that may be given
  bool directed = false;           // needs exactly one of `space` and `body`
};
// The table of all kinds; it exists until the program ends.
const std::vector<LoadKind>& load_kinds();

// When a load acts: it rises in a straight line from `from` on, is whole from `from` + ramp to
// `until`, and then falls as it rose. All in s.
struct Switching {
  double from = -std::numeric_limits<double>::infinity();
  double until = std::numeric_limits<double>::infinity();
  double ramp = 0.0;
  // The part of the load that acts at t, 0 to 1. Without a ramp it jumps, to 1 at `from` and to 0
  // at `until`.
  double part(double t) const;
  bool always() const { return std::isinf(from) && std::isinf(until); }
};

// A load converted to principal axes P and to the reference point.
struct Load {
  enum class Kind { torque, damp_momentum, damp_spin, couple, force, spring, gradient, frame };
  Kind kind = Kind::torque;
  bool in_body = false;        // true: `vector` is in P; false: in S
  Vec3 vector = Vec3::Zero();  // torque (N m) or force (N), to be multiplied by cos(rate t +
                               // phase); of a frame: its angular velocity, rad/s
  Vec3 arm_P = Vec3::Zero();   // lever arm from the reference point, for a couple from the opposite
                               // force to the force, m
  Vec3 at_P = Vec3::Zero();    // point of action, from the reference point, m
  Vec3 anchor_S = Vec3::Zero();  // fixed end of a spring, m
  double k = 0.0;                // stiffness, N/m
  double length = 0.0;           // length of the unstretched spring, m
  double c = 0.0;                // damping, 1/s (damp_momentum) or N m s (damp_spin)
  Vec3 moments = Vec3::Zero();   // of a gravity gradient and a frame: the principal moments, kg m^2
  std::optional<Vec3> about_P;   // of damping of spin: the only axis about which it acts, unit
  double rate = 0.0;             // rad/s
  double phase = 0.0;            // rad; 0 without a rate: then `vector` contains the cosine
  Switching acts;

  // Whether energy is conserved: of a spring, of a force or couple that is constant in space, none
  // of them switched, and in a frame that rotates.
  bool conservative() const;
};

// A force on a free body that is given in space axes and always acts: force_S cos(rate t + phase).
// The path of the centre of mass is then known in closed form, whatever the attitude.
struct Push {
  Vec3 force_S = Vec3::Zero();  // N
  double rate = 0.0;            // rad/s
  double phase = 0.0;           // rad

  Vec3 at(double t) const { return force_S * std::cos(rate * t + phase); }
};

// The loads of a [motion] table, sorted by their effect on the body.
struct Loads {
  std::vector<Load> turning;  // have a torque about the reference point, or a force that depends on
                              // attitude or place
  std::vector<Push> pushes;   // the forces in space axes on a free body that always act
  std::vector<Load> listed;   // all, in the order of the scene, for drawing
  // When loads jump or have kinks, s, in order; steps of adaptive methods end there.
  std::vector<double> switches;
  // True: a force on a free body depends on its attitude or place or is switched, so six degrees of
  // freedom must be integrated.
  bool need_place = false;

  std::optional<Gimbals> gimbals;  // rings that carry the body, unless they do nothing

  // About so much torque do arms have that count as none, N m.
  double left_out = 0.0;

  // The largest frequency with which one of them varies, rad/s.
  double fastest() const;
  bool empty() const { return !turn_body() && pushes.empty(); }
  // Whether anything besides gravity turns the body.
  bool turn_body() const { return !turning.empty() || gimbals; }
  // Whether no torque acts besides damping -c L; momentum_damping() is the sum of the c, in 1/s.
  bool only_damp_momentum() const;
  double momentum_damping() const;
};

// The direction from the Earth to a satellite on its circular orbit in the plane XY of space, with
// which a load of the kind `gradient` turns; unit, in S.
Vec3 away_from_earth(const Load& gradient, double t);

// Lever arms of at most this part of what they are the difference of count as none.
inline constexpr double kNoArm = 1e-14;

// center_B: centre of mass; reference_B: fixed point or centre of mass (both in B, m); R_BP:
// principal axes as columns, in B; moments: the principal moments, kg m^2; `noise`: what stands for
// kNoArm. Throws Error (input) naming motion.torque[i] if a key that its kind needs is missing,
// motion.torque[i].KEY for an unknown kind, for a key that the kind does not take, for a couple
// whose two forces act at one point, for an end before its beginning, and for a gravity gradient on
// a pivot or without a rate.
Loads make_loads(const std::vector<LoadSpec>& specs,
                 bool on_pivot,
                 const Vec3& center_B,
                 const Vec3& reference_B,
                 const Mat3& R_BP,
                 const Vec3& moments,
                 double noise = kNoArm);

// A torque and a force.
struct Wrench {
  Vec3 torque_P = Vec3::Zero();  // about the reference point, N m
  Vec3 force_S = Vec3::Zero();   // N
};

// Adds a load to a sum, whose force_S leaves out forces given in space axes (Loads::pushes). t in
// s; q rotates P to S; y: angular momentum in P, kg m^2/s; w_P: angular velocity in P, rad/s;
// place_S: reference point, m.
void add_wrench(const Load& load,
                double t,
                const Quat& q,
                const Vec3& y,
                const Vec3& w_P,
                const Vec3& place_S,
                Wrench& sum);
// The sum of the loads.
Wrench wrench_of(const std::vector<Load>& loads,
                 double t,
                 const Quat& q,
                 const Vec3& y,
                 const Vec3& w_P,
                 const Vec3& place_S);

// The force of one load at its point of action, in S, N. Zero for torques and damping. t in s; q
// rotates P to S; place_S: reference point, m.
Vec3 point_force(const Load& load, double t, const Quat& q, const Vec3& place_S);

// Potential energy of the conservative loads, J. That of a constant force is zero if it acts at the
// reference point. q rotates P to S; place_S: reference point, m.
double potential_of(const std::vector<Load>& loads, const Quat& q, const Vec3& place_S);
// A typical size of that potential energy, J, to scale energy errors with. Unlike the potential of
// a force, it does not vanish for particular attitudes.
double potential_scale(const std::vector<Load>& loads, const Quat& q, const Vec3& place_S);

// Mass times displacement (kg m) and mass times velocity (kg m/s) that a push gives to a body at
// rest within the time t (s).
Vec3 way_of(const Push& push, double t);
Vec3 speed_of(const Push& push, double t);

}  // namespace polhode
