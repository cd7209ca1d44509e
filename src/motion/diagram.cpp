// SPDX-License-Identifier: MIT
#include "motion/diagram.h"

#include "motion/recorded.h"

namespace polhode {
namespace {

std::string why_no_potential(const Motion& motion) {
  if (why_not_tilt(motion).empty() || why_not_middle(motion).empty()) return {};
  return "needs a heavy symmetric top on a pivot or a turning, free asymmetric body, without other "
         "torques";
}

Diagram potential(const Motion& motion) {
  return why_not_tilt(motion).empty() ? tilt_potential(motion) : middle_potential(motion);
}

}  // namespace

const std::vector<DiagramKind>& diagram_kinds() {
  static const std::vector<DiagramKind> table = {
      {"potential",
       "effective potential with the energy of the motion: of the tilt of a heavy symmetric top, "
       "of "
       "the middle component of a free asymmetric body's angular velocity",
       why_no_potential,
       potential},
      {"phase", "phase portrait of the tilt of a heavy symmetric top", why_not_tilt, tilt_portrait},
      {"polhode_map",
       "map of the sphere of angular momentum, seen from a free body, with polhodes",
       why_not_polhodes,
       polhode_map},
      {"satellite_map",
       "for which moments of inertia a satellite keeps its attitude to the Earth",
       why_not_satellite,
       satellite_map},
  };
  return table;
}

const DiagramKind* find_diagram(const std::string& name) {
  for (const DiagramKind& kind : diagram_kinds()) {
    if (kind.name == name) return &kind;
  }
  return nullptr;
}

std::vector<std::string> plot_names() {
  std::vector<std::string> names = recorded_names();
  for (const DiagramKind& kind : diagram_kinds())
    names.push_back(kind.name);
  return names;
}

}  // namespace polhode
