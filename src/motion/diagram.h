// SPDX-License-Identifier: MIT
// The table of diagrams: potentials, phase portraits and maps of a motion, as curves in a plane.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "motion/motion.h"

namespace polhode {

// An axis of a diagram, from low to high.
struct DiagramAxis {
  std::string name;  // plain text, such as "tilt of the axis"; empty: what the title says
  std::string unit;  // of the values, such as "°"; empty: a ratio
  double low = 0.0, high = 1.0;
};

// A curve of a diagram, in units of its axes.
struct DiagramCurve {
  // motion: the curve on which the motion stays; potential; energy: its level; separatrix: between
  // motions of different kinds; boundary: around what is stable; other: motions with another
  // energy, lines to go by
  enum class Kind { motion, potential, energy, separatrix, boundary, other };
  Kind kind = Kind::other;
  std::vector<Vec2> points;
};

// A point of a diagram that has a name: a turning point, a steady motion.
struct DiagramMark {
  std::string name;  // plain text; empty: none
  Vec2 at;
  bool stable = true;  // false: an unstable steady motion
};

// What a diagram shows, drawn from the conserved quantities of a motion; and where the motion is.
// A value; `now` may be called from any thread.
struct Diagram {
  std::string title;  // plain text
  DiagramAxis across, up;
  std::vector<DiagramCurve> curves;
  std::vector<DiagramMark> marks;
  // The point of the motion at t (s), 0 <= t <= its duration. Throws Error (check_failed) as
  // Motion::at does.
  std::function<Vec2(double t)> now;
};

// A kind of diagram. To add one: a function in motion/diagrams/ and a row in diagram_kinds().
struct DiagramKind {
  std::string name;  // as in show.plots
  std::string doc;
  // "" if the motion has such a diagram, else what it needs.
  std::string (*why_not)(const Motion& motion);
  Diagram (*make)(const Motion& motion);
};

// All kinds; the table exists until the program ends.
const std::vector<DiagramKind>& diagram_kinds();
// The kind of that name; null if there is none.
const DiagramKind* find_diagram(const std::string& name);
// What show.plots may name: recorded_names() (motion/recorded.h) and the names of diagrams.
std::vector<std::string> plot_names();

// The functions of the table. A heavy symmetric top on a pivot: the potential of its tilt, and its
// phase portrait (Landau and Lifshitz, Mechanics, section 35; Goldstein, Classical Mechanics, 5.7).
std::string why_not_tilt(const Motion& motion);
Diagram tilt_potential(const Motion& motion);
Diagram tilt_portrait(const Motion& motion);
// A free body: the potential of its angular velocity about the middle axis, and the map of the
// sphere of angular momentum with its polhodes (Landau and Lifshitz, Mechanics, section 37; A.
// Deprit, Am. J. Phys. 35 (1967) 424).
std::string why_not_middle(const Motion& motion);
Diagram middle_potential(const Motion& motion);
std::string why_not_polhodes(const Motion& motion);
Diagram polhode_map(const Motion& motion);
// A satellite: the ratios of moments for which its attitude to the Earth is stable.
std::string why_not_satellite(const Motion& motion);
Diagram satellite_map(const Motion& motion);

}  // namespace polhode
