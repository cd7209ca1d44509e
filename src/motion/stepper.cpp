// SPDX-License-Identifier: MIT
#include "motion/stepper.h"

#include "base/check.h"
#include "base/error.h"
#include "base/nearest.h"
#include "motion/steppers/all.h"

namespace polhode {

double Stepper::step_with_error(double, double, State&) {
  CHECK(false && "only adaptive methods estimate their error");
  return 0.0;
}

namespace {

std::string nothing_against(const Model&) {
  return {};
}
std::string against_loads(const Model& model) {
  if (!model.six && model.loads.turning.empty()) return {};
  return "it integrates three degrees of freedom under gravity only, no other torques or forces; "
         "dopri5 and rk4 do";
}
std::string against_all_but_free(const Model& model) {
  if (std::string loads = against_loads(model); !loads.empty()) return loads;
  if (model.chi_P.squaredNorm() > 0.0)
    return "it takes free bodies only, and gravity turns this one";
  if (model.kind.rotator) return "it divides by all three moments, and one is zero";
  return {};
}
std::string against_all_but_heavy(const Model& model) {
  if (std::string loads = against_loads(model); !loads.empty()) return loads;
  if (model.chi_P.squaredNorm() == 0.0) return "it is for bodies that gravity turns";
  return {};
}

// what a method keeps to round-off, whatever the step
struct Kept {
  bool energy = false, norm = false, space = false;
};
constexpr Kept kNothing{};
constexpr Kept kAll{true, true, true};
constexpr Kept kMomentum{false, true, true};

}  // namespace

const std::vector<StepperInfo>& stepper_table() {
  constexpr bool kAdaptive = true, kReversible = true, kSymplectic = true;
  const auto row = [](const char* name,
                      int order,
                      bool adaptive,
                      const Kept& kept,
                      bool reversible,
                      bool symplectic,
                      const char* limit,
                      const char* source,
                      auto why_not,
                      auto make) {
    return StepperInfo{name,
                       order,
                       adaptive,
                       kept.energy,
                       kept.norm,
                       kept.space,
                       reversible,
                       symplectic,
                       limit,
                       source,
                       why_not,
                       make};
  };
  // clang-format off
  static const std::vector<StepperInfo> table = {
      row("explicit_euler", 1, false, kNothing, false, false, "none: |y| grows at every step", "Euler 1768; kept to show how it fails", nothing_against, make_explicit_euler),
      row("semi_implicit_euler", 1, false, kNothing, false, false, "none: energy grows", "game engines; kept to show how it fails", against_loads, make_semi_implicit_euler),
      row("linearly_implicit_euler", 1, false, kNothing, false, false, "none, but tumbling dies out", "Catto, GDC 2015; Bullet, Box3D, MuJoCo", against_loads, make_linearly_implicit_euler),
      row("renormalised_explicit", 1, false, {false, true, false}, false, false, "none, but energy goes to the middle axis", "Jolt, Avian", against_loads, make_renormalised_explicit),
      row("rk2", 2, false, kNothing, false, false, "none: grows at every step", "Runge 1895", nothing_against, make_rk2),
      row("rk4", 4, false, kNothing, false, false, "h omega < 2.83", "Kutta 1901", nothing_against, make_rk4),
      row("dopri5", 5, kAdaptive, kNothing, false, false, "h omega < 1.0", "Dormand and Prince, J. Comput. Appl. Math. 6 (1980) 19", nothing_against, make_dopri5),
      row("implicit_midpoint", 2, false, kAll, kReversible, false, "a solution of its equations", "Hairer, Lubich, Wanner, Geometric Numerical Integration, IV.1 and VII.5", against_loads, make_implicit_midpoint),
      row("three_rotations", 2, false, kMomentum, kReversible, kSymplectic, "resonance, h omega of 2 to 6", "McLachlan, Phys. Rev. Lett. 71 (1993) 3043; Reich, Physica D 76 (1994) 375", against_loads, make_three_rotations),
      row("symmetric_remainder2", 2, false, kMomentum, kReversible, kSymplectic, "resonance, h omega of 2 to 6", "Hairer, Lubich, Wanner, Geometric Numerical Integration, VII.5.3", against_loads, make_symmetric_remainder2),
      row("symmetric_remainder4", 4, false, kMomentum, kReversible, kSymplectic, "as of order 2, per stage", "the same, composed by Suzuki, Phys. Lett. A 146 (1990) 319", against_loads, make_symmetric_remainder4),
      row("symmetric_remainder6", 6, false, kMomentum, kReversible, kSymplectic, "as of order 2, per stage", "the same, composed by Yoshida, Phys. Lett. A 150 (1990) 262", against_loads, make_symmetric_remainder6),
      row("dmv2", 2, false, kAll, kReversible, kSymplectic, "h omega < 1", "Moser and Veselov, Commun. Math. Phys. 139 (1991) 217", against_all_but_free, make_dmv2),
      row("dmv4", 4, false, kAll, kReversible, false, "h omega < 1", "Hairer and Vilmart, J. Phys. A 39 (2006) 13225", against_all_but_free, make_dmv4),
      row("dmv6", 6, false, kAll, kReversible, false, "h omega < 1", "the same", against_all_but_free, make_dmv6),
      row("dmv8", 8, false, kAll, kReversible, false, "h omega < 1", "the same", against_all_but_free, make_dmv8),
      row("dmv10", 10, false, kAll, kReversible, false, "h omega < 1", "the same", against_all_but_free, make_dmv10),
      row("kick_srkn6", 4, false, kMomentum, kReversible, kSymplectic, "h below half a slow precession", "Blanes and Moan, J. Comput. Appl. Math. 142 (2002) 313", against_all_but_heavy, make_kick_srkn6),
      row("kick_srkn11", 6, false, kMomentum, kReversible, kSymplectic, "h below half a slow precession", "the same", against_all_but_heavy, make_kick_srkn11),
  };
  // clang-format on
  return table;
}

const StepperInfo& find_stepper(const std::string& name) {
  std::vector<std::string> names;
  for (const StepperInfo& row : stepper_table()) {
    if (row.name == name) return row;
    names.push_back(row.name);
  }
  throw input_error("no method is called '{}'{}", name, suggestion(name, names));
}

}  // namespace polhode
