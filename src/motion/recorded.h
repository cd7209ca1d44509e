// SPDX-License-Identifier: MIT
// The table of quantities over time that a plot can show.
#pragma once

#include <string>
#include <vector>

#include "motion/motion.h"

namespace polhode {

// A quantity with one or more curves in the same unit. To add one: a row in recorded_quantities().
struct Recorded {
  std::string name;                 // as in show.plots
  std::string title;                // of the plot
  std::string unit;                 // of the plotted values, such as "rad/s" or "°"; "": a ratio
  std::vector<std::string> curves;  // the name of each curve
  // The value of each curve at the moment of `sample`, in `unit`; NaN where it is not defined.
  // Throws Error (check_failed) as drift_at does.
  std::vector<double> (*values)(const Motion& motion, const Sample& sample);
  // The values are angles in `unit` that begin again after this much; 0: no.
  double period = 0.0;
  // Why the motion does not have it, as in "needs a body on a table"; "": it does. Null: all do.
  std::string (*why_not)(const Motion& motion) = nullptr;
  // The name of each curve for a motion of this model; null: `curves`.
  std::vector<std::string> (*names)(const BodyModel& model) = nullptr;
};

// How many equal steps up to `end` (s) show what the quantities of a motion do: at least `least`,
// 24 in a turn of the body's fastest rotation and of the fastest load, and 12 between two switches
// of loads, but no more than kMostShown. That many steps are too few for a turn.
inline constexpr int kMostShown = 100'000;
int steps_to_show(const Motion& motion, double end, int least);

// The values of each curve at `steps` equal steps of the motion up to `end` (s), and there. NaN
// where they are not defined, and where an angle begins again: no line belongs there. Throws Error
// (check_failed) as Recorded::values does.
std::vector<std::vector<double>> values_over_time(const Recorded& quantity,
                                                  const Motion& motion,
                                                  double end,
                                                  int steps);

// Puts peaks between the steps into curves of values_over_time(): a step whose middle is far from
// the line between its ends, as where an axis passes close by the vertical and the rates of its
// angles are great, is halved up to twenty times, and what is beyond its ends takes the place of
// the nearer end. For pictures, not for tables. Not for angles that begin again. Throws Error
// likewise.
void add_peaks(const Recorded& quantity,
               const Motion& motion,
               double end,
               std::vector<std::vector<double>>& curves);

// The same number of values or fewer, at most `most` + 1 at equal steps: of the values that a
// column of two steps stands for, the least and the greatest, in their order, so that a line
// through them covers what the whole line covers. A column with a NaN is NaN, unless that would
// leave little.
std::vector<double> extremes_of(const std::vector<double>& values, int most);

// What a picture shows of values_over_time(), with peaks, as extremes_of() that many steps. Throws
// Error likewise.
std::vector<std::vector<double>> drawn_values(
    const Recorded& quantity, const Motion& motion, double end, int steps, int most);

// All quantities; the table exists until the program ends.
const std::vector<Recorded>& recorded_quantities();
// The one of this name; null if there is none.
const Recorded* find_recorded(const std::string& name);
// The name of each curve for this motion.
std::vector<std::string> curve_names(const Recorded& quantity, const Motion& motion);
// Why the motion does not have the quantity, as in "needs a body on a table"; empty: it does.
std::string why_not(const Recorded& quantity, const Motion& motion);
// Their names, for show.plots and the schema.
std::vector<std::string> recorded_names();

}  // namespace polhode
