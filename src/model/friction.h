// SPDX-License-Identifier: MIT
// What a body on a table moves on: the law of friction and the surface that touches.
#pragma once

#include <memory>

#include "model/contact_surface.h"
#include "model/friction_spec.h"

namespace polhode {

// The law of friction in the form that the equations of motion use.
struct Friction {
  enum class Kind { none, rolling, viscous, coulomb };
  Kind kind = Kind::none;
  double mu = 0.0;           // coulomb
  double c = 0.0;            // viscous, s/m
  double rolling = 0.0;      // moment against rolling over the normal force, m
  double boring = 0.0;       // moment against turning about the vertical over it, m
  double restitution = 0.0;  // 0..1
  double turntable = 0.0;    // angular velocity of the table about Z, rad/s

  // Whether the table takes no energy from a body that stays on it, and gives it none.
  bool keeps_energy() const {
    return (kind == Kind::none || kind == Kind::rolling) && rolling == 0.0 && boring == 0.0 &&
           turntable == 0.0;
  }
};

// What holds a body on a table; a part of BodyModel.
struct Table {
  std::shared_ptr<const ContactSurface> surface;
  Friction friction;
};

// Makes the table of a [motion] table. Throws Error (input) naming motion.friction.KEY for a key
// that the kind needs or does not take.
Friction make_friction(const FrictionSpec& spec);

}  // namespace polhode
