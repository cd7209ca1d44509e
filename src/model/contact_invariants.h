// SPDX-License-Identifier: MIT
// What a body on a table conserves, besides the energy: one row for each law.
#pragma once

#include <string>
#include <vector>

#include "model/table.h"

namespace polhode {

// A conserved quantity. To add one: a row in contact_invariants().
struct ContactInvariant {
  std::string name;  // as in reports, such as "jellett"
  std::string doc;   // what it is, one phrase
  std::string unit;  // as text
  // Whether it is conserved for this model, which has a table.
  bool (*holds)(const BodyModel& model);
  // Its value, of which unused components are 0. Place and velocity count.
  Vec3 (*value)(const BodyModel& model, const Moving& now);
  // Its typical size at a start, in the same unit, for relative errors; may be 0.
  double (*scale)(const BodyModel& model, const Moving& start);
  bool while_touching = false;  // only until the body leaves the table: a landing changes it
};

// The table of all invariants; it exists until the program ends.
const std::vector<ContactInvariant>& contact_invariants();
// The rows of it that hold for this model, which has a table, in a motion that begins so.
std::vector<const ContactInvariant*> invariants_from(const BodyModel& model, const Moving& start);

// Whether the table of the model is level, and nothing but gravity and the table acts on the body.
bool is_level_and_unloaded(const BodyModel& model);

// A sphere whose centre is on a line through the centre of mass that the body is symmetric about,
// as far as inertia goes: Jellett's and Routh's spheres, tippe tops.
struct EccentricSphere {
  double radius = 0.0;          // m
  Vec3 axis_P = Vec3::UnitZ();  // from the centre of mass to the centre of the sphere, unit
  double offset = 0.0;          // distance of these, over the radius
  double across = 0.0;          // moment across the axis, kg m^2
  double along = 0.0;           // along it
};
// Whether the body of the model, which has a table, is one; fills `sphere`.
bool is_eccentric_sphere(const BodyModel& model, EccentricSphere& sphere);

// Whether the body of the model, which has a table, is of revolution in shape and inertia; axis_P:
// its axis, unit.
bool is_of_revolution(const BodyModel& model, Vec3& axis_P);

}  // namespace polhode
