// SPDX-License-Identifier: MIT
// The [motion] and [numerics] tables of a scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "math/notation.h"
#include "model/friction_spec.h"
#include "model/gimbals_spec.h"
#include "model/load_spec.h"

namespace polhode {

// Attitude at t = 0: one of these. If the scene gives no attitude, none is set, and R_SB = 1.
struct AttitudeSpec {
  std::optional<Vec3> zxz;                    // Euler angles (phi, theta, psi), rad
  std::optional<Eigen::Vector4d> quaternion;  // (w, x, y, z), rotates B to S; not zero; start_state
                                              // scales it to unit length
  std::optional<double> tilt;       // of the body's z axis from the vertical, about X, rad
  std::optional<bool> momentum_up;  // true: turned so that the angular momentum, which the spin
                                    // gives in body axes, is along Z
};

// Angular velocity at t = 0: one of these. If the scene gives no spin, none is set, and the body is
// at rest.
struct SpinSpec {
  std::optional<Vec3> body;           // rad/s in body axes
  std::optional<Vec3> space;          // rad/s in space axes
  std::optional<Vec3> momentum_body;  // angular momentum in body axes, kg m^2/s
  std::optional<Vec3> rates;          // (phi', theta', psi') of the zxz angles, rad/s; the angles
                                      // are AttitudeSpec::zxz, else zxz_angles() of the attitude
  // of a symmetric top on a pivot under gravity:
  std::optional<std::string> steady;  // precession without nutation, "slow" or "fast"
  std::optional<double> axial;        // with `steady`: rad/s about the line from the pivot to the
                                      // centre of mass
  std::optional<double> sleeping;     // rad/s of an upright top about that line
};

// Motions that begin near the one of the scene, which pictures show beside it.
struct EnsembleSpec {
  int members = 40;
  double tilt = 0.0;      // rad: their attitudes are turned by up to this angle, about any axis
  double momentum = 0.0;  // their angular momenta differ by up to this part of it, in any direction
};

// The [motion] table.
struct MotionSpec {
  // "free"; "pivot": one point of the body is fixed, at the origin of S; or "table": the body is
  // on or above the plane z = 0 of S
  std::string hold = "free";
  // m/s^2 in S; absent: zero for a free body; standard gravity (9.80665) along -Z on a pivot or a
  // table
  std::optional<Vec3> gravity;
  double duration = 10.0;  // s
  AttitudeSpec attitude;
  SpinSpec spin;
  // Of the centre of mass at t = 0, in S, m and m/s; not on a pivot. On a table, a body that is not
  // above it is put on it, so that z and its velocity follow.
  Vec3 position = Vec3::Zero();
  Vec3 velocity = Vec3::Zero();
  std::vector<LoadSpec> torque;  // torques and forces besides gravity
  // Angular velocity of space, such as that of the Earth or of a turntable, rad/s in S; absent:
  // space does not turn. Pivot only; all rates and momenta are relative to S.
  std::optional<Vec3> frame_rotation;
  std::optional<GimbalsSpec>
      gimbals;  // rings that carry the body; absent: nothing does. Pivot only
  std::optional<FrictionSpec> friction;  // of a table; absent: it has none
  std::optional<EnsembleSpec> ensemble;
};

// The allowed attitude error over the whole film, in radians or in pixels of the finished picture.
struct Accuracy {
  double value = 0.1;  // positive
  bool pixels = true;  // false: `value` is in radians
};

// Parses "0.1px" or a number of radians. Throws Error (input), without a key, for other text and
// for values that are not positive.
Accuracy parse_accuracy(const std::string& text);

// The greatest number of fixed steps of one integration. Adaptive methods, which keep every time,
// may take an eighth of it.
inline constexpr long kMostSteps = 50'000'000;

// The [numerics] table.
struct NumericsSpec {
  std::string model = "auto";       // one of model_names()
  std::string method = "auto";      // one of method_names()
  std::optional<double> step;       // s; for fixed-step methods; absent: found from accuracy
  std::optional<double> tolerance;  // local error per step (Stepper::step_with_error); for adaptive
                                    // methods; absent: found from accuracy
  Accuracy accuracy;
  // The most steps of one run, to go beyond the defaults (kMostStepsRefined and kMostStepsGiven of
  // motion/simulate.h); absent: these.
  std::optional<double> max_steps;
  // Methods that a film shows side by side; step and tolerance apply to them. Empty: none.
  std::vector<std::string> compare;
};

// The allowed names, "auto" first, for help, the schema and the reader.
std::vector<std::string> model_names();
std::vector<std::string> method_names();

template <class Visitor>
void fields(Visitor& v, AttitudeSpec& s) {
  v.exactly_one_of({"zxz", "quaternion", "tilt", "momentum_up"});
  v.field("zxz",
          s.zxz,
          Doc{"Euler angles phi, theta, psi: R = Rz(phi) Rx(theta) Rz(psi)", Unit::angle});
  v.field("quaternion",
          s.quaternion,
          Doc{"quaternion w, x, y, z of the rotation from body axes to space axes"});
  v.field("tilt", s.tilt, Doc{"angle from the vertical to the body's z axis", Unit::angle});
  v.field("momentum_up",
          s.momentum_up,
          Doc{"true: turned so that the angular momentum points up; spin in body axes gives it"});
}

template <class Visitor>
void fields(Visitor& v, SpinSpec& s) {
  v.exactly_one_of({"body", "space", "momentum_body", "rates", "steady", "sleeping"});
  v.field("body", s.body, Doc{"angular velocity in body axes", Unit::angular_velocity});
  v.field("space", s.space, Doc{"angular velocity in space axes", Unit::angular_velocity});
  v.field("momentum_body",
          s.momentum_body,
          Doc{"angular momentum in body axes", Unit::angular_momentum});
  v.field("rates", s.rates, Doc{"rates of the zxz angles phi, theta, psi", Unit::angular_velocity});
  v.field("steady",
          s.steady,
          Doc{"steady precession of a symmetric top on a pivot; needs axial",
              Unit::none,
              kAny,
              {"slow", "fast"}});
  v.field("axial",
          s.axial,
          Doc{"angular velocity about the top's own axis, for steady", Unit::angular_velocity});
  v.field("sleeping",
          s.sleeping,
          Doc{"angular velocity of an upright top about its axis", Unit::angular_velocity});
}

template <class Visitor>
void fields(Visitor& v, EnsembleSpec& s) {
  v.field("members", s.members, Doc{"number of motions", Unit::none, Range{1, 1000}});
  v.field("tilt",
          s.tilt,
          Doc{"their attitudes are turned by up to this angle", Unit::angle, Range{0.0, kPi}});
  v.field("momentum",
          s.momentum,
          Doc{"their angular momenta differ by up to this part", Unit::none, Range{0.0, 1.0}});
}

template <class Visitor>
void fields(Visitor& v, MotionSpec& s) {
  v.field("hold",
          s.hold,
          Doc{"whether the body is free, one of its points is fixed (body.pivot), or it moves on "
              "a table, the plane z = 0",
              Unit::none,
              kAny,
              {"free", "pivot", "table"}});
  v.field("gravity",
          s.gravity,
          Doc{"acceleration of gravity in space axes; absent: none for a free body, standard on a "
              "pivot or a table",
              Unit::acceleration});
  v.field("duration", s.duration, Doc{"length of the motion", Unit::time, kPositive});
  v.field("attitude", s.attitude, Doc{"attitude at the start; absent: body axes along space axes"});
  v.field("spin", s.spin, Doc{"angular velocity or momentum at the start; absent: at rest"});
  v.field("position",
          s.position,
          Doc{"position of the centre of mass at the start; not on a pivot", Unit::length});
  v.field("velocity",
          s.velocity,
          Doc{"velocity of the centre of mass at the start; not on a pivot", Unit::velocity});
  v.field("torque", s.torque, Doc{"torques and forces that act besides gravity"});
  v.field("frame_rotation",
          s.frame_rotation,
          Doc{"angular velocity at which space itself turns, such as that of the Earth or of a "
              "turntable, in space axes; pivot only",
              Unit::angular_velocity});
  v.field("gimbals", s.gimbals, Doc{"inertia and friction of the rings that carry the body"});
  v.field("friction", s.friction, Doc{"friction of the table; absent: none"});
  v.field("ensemble", s.ensemble, Doc{"motions that begin near this one"});
}

template <class Visitor>
void fields(Visitor& v, NumericsSpec& s) {
  v.field("model",
          s.model,
          Doc{"solution method; auto: the first that can handle the scene",
              Unit::none,
              kAny,
              model_names()});
  v.field("method",
          s.method,
          Doc{"integrator; auto: a closed form, else the cheapest that reaches the accuracy",
              Unit::none,
              kAny,
              method_names()});
  v.field("step",
          s.step,
          Doc{"step of fixed-step methods; absent: found from accuracy", Unit::time, kPositive});
  v.field("tolerance",
          s.tolerance,
          Doc{"local error per step of adaptive methods; absent: found from accuracy",
              Unit::none,
              kPositive});
  v.field("accuracy",
          s.accuracy,
          Doc{"allowed attitude error over the whole film: radians, or pixels of the picture as "
              "\"0.1px\""});
  v.field("max_steps",
          s.max_steps,
          Doc{.text = "most steps of one run, for motions that need more than the program takes by "
                      "itself",
              .range = Range{1.0, static_cast<double>(kMostSteps)},
              .whole = true});
  v.field("compare",
          s.compare,
          Doc{"methods that the film shows side by side, at most nine; step and tolerance apply to "
              "them",
              Unit::none,
              kAny,
              method_names()});
}

}  // namespace polhode
