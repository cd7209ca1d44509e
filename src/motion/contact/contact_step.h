// SPDX-License-Identifier: MIT
// One step of a body on a table between two events, and the margins whose zeros are events.
#pragma once

#include <array>
#include <vector>

#include "model/body_model.h"
#include "model/table.h"

namespace polhode {

// What is stepped: the motion and the work that the table and the loads without a potential have
// done on the body since the start, J.
struct OnTable {
  Moving moving;
  double work = 0.0;
};

// What can end a way of touching. The margin of each is positive while it goes on.
enum class ContactEvent {
  lift_off,      // the normal force is about to pull
  landing,       // the body comes down on the table
  slip_ends,     // the contact stops slipping
  slip_begins,   // sticking needs more friction than there is
  rolling_ends,  // the horizontal part of the angular velocity comes to zero
  rolling_begins,
  boring_ends,  // likewise that about the vertical
  boring_begins,
  second_contact,  // another edge or part comes down on the table
  lies_flat,       // a face does
};
inline constexpr int kContactEvents = 10;

// Margins in units of weight, reach of the surface, and the velocities that go with them; a margin
// that does not apply is 1.
using Margins = std::array<double, kContactEvents>;

// Typical sizes on the table, to scale errors and margins.
struct TableScales {
  double length = 1.0;    // reach of the surface, m
  double weight = 1.0;    // N
  double speed = 1.0;     // of a fall from there, m/s
  double rate = 1.0;      // that over the length, rad/s
  double momentum = 1.0;  // kg m^2/s
  // Velocities below this part of `speed` and `rate` are zero at an event. So small a slip moves
  // nothing within the error of the steps: what it does is as its power 3/2.
  double stopped = 0.0;
  // Faces closer to the table than this (rad) lie on it: there a disc that runs round on its edge
  // still turns faster than what is zero at an event.
  double flat = 0.0;
  double tolerance = 0.0;  // the local error of a step, relative
};
// `stopped` is this power of the tolerance; so the errors of motions with slips fall.
inline constexpr double kPowerOfStopped = 2.0 / 3.0;
// tolerance: the local error of a step, relative.
TableScales table_scales(const BodyModel& model, const Moving& start, double tolerance);

Margins margins_of(const BodyModel& model,
                   const TableScales& scales,
                   const Touch& touch,
                   const Moving& now,
                   const Reaction& reaction);
double least_of(const Margins& margins);
// Margins may be below zero by this much for their round-off.
inline constexpr double kNoiseOfMargins = 1e-12;

// The margins at some times (s) within a step, in no order; of those at one time the last is the
// best.
struct MarginsAt {
  double t;
  Margins margins;
};
using MarginsSeen = std::vector<MarginsAt>;

// The touch with the directions of slip and rolling as they are now.
Touch refreshed(const BodyModel& model, const Touch& touch, const Moving& now);

// Steps a body that touches in one way. The contact holds by construction: the equations are those
// of attitude, angular momentum and, where they are free, horizontal place and velocity; the rest
// follows. Dormand and Prince's order 8; where a slip of dry friction is so slow that its direction
// follows all else far faster than a step, Radau's order 5, which need not resolve that. Immutable.
class ContactStepper {
 public:
  ContactStepper(const BodyModel& model, const TableScales& scales)
      : model_(model), scales_(scales) {}

  struct Result {
    OnTable end;
    int order = 8;       // of the method that was used
    double error = 0.0;  // estimate of the local error, relative to the scales
  };
  // From t by h (s), by Radau's method if `implicit`; where that finds no solution, by the other
  // one. The margins at the stages are added to `seen`, if there is one; those of a first
  // attempt by Radau's method too. Throws Error (check_failed) as reaction_of does.
  Result step(const Touch& touch,
              double t,
              double h,
              const OnTable& from,
              bool implicit = false,
              MarginsSeen* seen = nullptr) const;
  // The state after a part (s) of a step from t, with the method of the whole: near the end of an
  // implicit step the explicit method may be far off. That the whole has a solution and is exact
  // enough does not mean that a part is: one that is not is taken in halves.
  OnTable part(const Touch& touch, double t, double part, const OnTable& from, bool implicit) const;
  // How fast the direction of a slip turns to where dry friction lets it, 1/s: mu g, times what the
  // rotation adds to the mobility of the contact, over the speed of slip. Zero without such a slip.
  double turning_rate(const Touch& touch, const Moving& now) const;
  // Explicit steps bear this much of it in a step; longer ones are for Radau's.
  static constexpr double kExplicit = 6.0;
  // All margins of a state.
  Margins margins(const Touch& touch, double t, const OnTable& now) const;

  const BodyModel& model() const { return model_; }
  const TableScales& scales() const { return scales_; }

 private:
  BodyModel model_;
  TableScales scales_;
};

}  // namespace polhode
