// SPDX-License-Identifier: MIT
#include "motion/stepper_table.h"

#include <algorithm>

#include <fmt/ranges.h>

#include "base/at_place.h"
#include "base/error.h"
#include "base/name_list.h"
#include "base/nearest.h"
#include "motion/steppers/all.h"

namespace polhode {
namespace {

// "" or what the method cannot do with the model
std::string obstacle(const StepperInfo& method, const BodyModel& model) {
  if (model.table && !method.takes_table)
    return method.name + " does not find the events of a body on a table";
  if (!model.table && method.only_table) return method.name + " is for bodies on a table";
  if (model.table && method.only_table && !model.loads.empty())
    return method.name + " takes no torques or forces besides those of the table";
  if (model.table && method.only_table && !method.takes_bounces &&
      model.table->friction.restitution > 0.0)
    return method.name + " computes no bounces (motion.friction.restitution)";
  if (!method.takes_loads && (model.with_translation || model.loads.turn_body()))
    return method.name + " takes no torques or forces besides gravity";
  if (!method.takes_heavy && model.chi_P.squaredNorm() > 0.0)
    return method.name + " takes free bodies only, and gravity turns this one about its pivot";
  if (!method.adaptive && !model.loads.switches.empty())
    return method.name + " has fixed steps, which do not end where a load is switched";
  if (!method.takes_rotator && model.kind.rotator)
    return method.name + " takes no body with all its mass on a line";
  return {};
}

std::string obstacle_to_fixed_steps(const StepperInfo& method, const BodyModel& model) {
  if (model.table && method.takes_table && !method.only_table)
    return method.name + " goes from event to event on a table, by a tolerance";
  return obstacle(method, model);
}

// the obstacle and the names of methods that have none; "" if there is none
std::string with_names_of_others(const StepperInfo& method,
                                 const BodyModel& model,
                                 MethodObstacle obstacle_of) {
  std::string reason = obstacle_of(method, model);
  if (reason.empty()) return {};
  // of those that can, the highest orders first
  std::vector<const StepperInfo*> able;
  for (const StepperInfo& row : stepper_table()) {
    if (obstacle_of(row, model).empty()) able.push_back(&row);
  }
  if (able.empty()) return reason;
  std::stable_sort(
      able.begin(), able.end(), [](const auto* a, const auto* b) { return a->order > b->order; });
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min<std::size_t>(able.size(), 4); ++i)
    names.push_back(able[i]->name);
  return fmt::format("{}; {} can{}",
                     reason,
                     fmt::join(names, ", "),
                     able.size() > names.size() ? ", and others of `polhode list methods`" : "");
}

}  // namespace

std::string family_title(MethodFamily family) {
  switch (family) {
    case MethodFamily::engines:
      return "game engines";
    case MethodFamily::runge_kutta:
      return "Runge-Kutta";
    case MethodFamily::taylor:
      return "Taylor series";
    case MethodFamily::implicit:
      return "implicit";
    case MethodFamily::lie_group:
      return "Lie groups";
    case MethodFamily::rotations:
      return "turns about axes";
    case MethodFamily::moser_veselov:
      return "Moser-Veselov";
    case MethodFamily::kicks:
      return "free motions and kicks";
    case MethodFamily::table:
      return "tables without events";
  }
  return {};
}

// Long, because it is one table: a row for each.
const std::vector<StepperInfo>& stepper_table() {
  // clang-format off
  static const std::vector<StepperInfo> table = {
      {.name = "explicit_euler", .title = "Explicit Euler", .family = MethodFamily::engines, .order = 1, .takes_heavy = true, .takes_loads = true, .takes_rotator = true,
       .cost = "1 evaluation", .limit = "unstable for every step",
       .source = "Euler 1768; kept to show how it fails", .make = make_explicit_euler},
      {.name = "semi_implicit_euler", .title = "Semi-implicit Euler", .family = MethodFamily::engines, .order = 1, .takes_heavy = true, .takes_rotator = true,
       .cost = "1 evaluation", .limit = "unstable for every step",
       .source = "game engines; MuJoCo's Euler without implicit terms", .make = make_semi_implicit_euler},
      {.name = "linearly_implicit_euler", .title = "Linearly implicit Euler", .family = MethodFamily::engines, .order = 1, .takes_heavy = true, .takes_rotator = true,
       .cost = "1 evaluation, 3x3 solve", .limit = "none, but damps tumbling",
       .source = "Catto, Numerical Methods, GDC 2015 (Bullet, Box3D, MuJoCo implicit)", .make = make_linearly_implicit_euler},
      {.name = "renormalised_explicit", .title = "Explicit Euler, |L| put right", .family = MethodFamily::engines, .order = 1, .keeps_momentum_norm = true, .takes_heavy = true, .takes_rotator = true,
       .cost = "1 evaluation", .limit = "energy goes to that of the middle axis",
       .source = "the gyroscopic step of Jolt and Avian", .make = make_renormalised_explicit},
      {.name = "rk2", .title = "RK2", .family = MethodFamily::runge_kutta, .order = 2, .takes_heavy = true, .takes_loads = true, .takes_rotator = true,
       .cost = "2 evaluations", .limit = "unstable for every step",
       .source = "Runge 1895, the midpoint method", .make = make_rk2},
      {.name = "rk4", .title = "RK4", .family = MethodFamily::runge_kutta, .order = 4, .takes_heavy = true, .takes_loads = true, .takes_rotator = true,
       .cost = "4 evaluations", .limit = "h < 2 sqrt 2 / rate of L in the body", .limit_of = StepLimit::oscillation, .limit_turn = 2.8284271,
       .source = "Kutta 1901", .make = make_rk4},
      {.name = "rk4_euler_angles", .title = "RK4 on Euler angles", .family = MethodFamily::runge_kutta, .order = 4, .takes_heavy = true, .takes_rotator = true,
       .cost = "4 evaluations", .limit = "fails at tilt 0 and 180 degrees", .limit_of = StepLimit::oscillation, .limit_turn = 2.8284271,
       .source = "Kutta 1901 on zxz angles; kept to show where a chart fails", .make = make_rk4_euler_angles},
      {.name = "dopri5", .title = "Dormand-Prince 5(4)", .family = MethodFamily::runge_kutta, .order = 5, .adaptive = true, .takes_heavy = true, .takes_loads = true, .takes_rotator = true,
       .cost = "7 evaluations", .limit = "h < 0.997 / rate of L in the body", .limit_of = StepLimit::oscillation, .limit_turn = 0.997,
       .source = "Dormand and Prince, J. Comput. Appl. Math. 6 (1980) 19", .make = make_dopri5},
      {.name = "dop853", .title = "Dormand-Prince 8(5,3)", .family = MethodFamily::runge_kutta, .order = 8, .adaptive = true, .takes_heavy = true, .takes_loads = true, .takes_table = true, .takes_rotator = true,
       .cost = "12 evaluations", .limit = "h < 5.9 / rate of L in the body", .limit_of = StepLimit::oscillation, .limit_turn = 5.9,
       .source = "Hairer, Norsett, Wanner, Solving ODEs I, II.10", .make = make_dop853},
      {.name = "taylor10", .title = "Taylor series of order 10", .family = MethodFamily::taylor, .order = 10, .adaptive = true, .takes_heavy = true, .takes_rotator = true,
       .cost = "10 terms of a series", .limit = "h below the radius of convergence",
       .source = "Jorba and Zou, Experiment. Math. 14 (2005) 99", .make = make_taylor10},
      {.name = "taylor16", .title = "Taylor series of order 16", .family = MethodFamily::taylor, .order = 16, .adaptive = true, .takes_heavy = true, .takes_rotator = true,
       .cost = "16 terms of a series", .limit = "h below the radius of convergence",
       .source = "Jorba and Zou, Experiment. Math. 14 (2005) 99", .make = make_taylor16},
      {.name = "implicit_midpoint", .title = "Implicit midpoint", .family = MethodFamily::implicit, .order = 2, .keeps_energy = true, .keeps_momentum_norm = true, .keeps_momentum_space = true, .reversible = true, .takes_heavy = true, .takes_rotator = true,
       .cost = "Newton, 3x3", .limit = "Newton, h |omega| < 1 is safe",
       .source = "Hairer, Lubich, Wanner, GNI, IV.2.1 and VII.5", .make = make_implicit_midpoint},
      {.name = "gauss4", .title = "Gauss, order 4", .family = MethodFamily::implicit, .order = 4, .keeps_energy = true, .keeps_momentum_norm = true, .reversible = true, .takes_heavy = true, .takes_loads = true, .takes_rotator = true,
       .cost = "fixed point, 2 evaluations each", .limit = "fixed point, h |omega| < 1 is safe",
       .source = "Hairer, Lubich, Wanner, GNI, II.1.3 and IV.2.1", .make = make_gauss4},
      {.name = "gauss6", .title = "Gauss, order 6", .family = MethodFamily::implicit, .order = 6, .keeps_energy = true, .keeps_momentum_norm = true, .reversible = true, .takes_heavy = true, .takes_loads = true, .takes_rotator = true,
       .cost = "fixed point, 3 evaluations each", .limit = "fixed point, h |omega| < 1 is safe",
       .source = "Hairer, Lubich, Wanner, GNI, II.1.3 and IV.2.1", .make = make_gauss6},
      {.name = "radau5", .title = "Radau IIA, order 5", .family = MethodFamily::implicit, .order = 5, .adaptive = true, .stiff = true, .takes_heavy = true, .takes_loads = true, .takes_rotator = true,
       .cost = "Newton's method, 3 evaluations each, and a Jacobian",
       .source = "Hairer and Wanner, Solving Ordinary Differential Equations II, IV.5 and IV.8", .make = make_radau5},
      {.name = "rkmk4", .title = "Munthe-Kaas, order 4", .family = MethodFamily::lie_group, .order = 4, .keeps_momentum_norm = true, .keeps_momentum_space = true, .takes_heavy = true, .takes_rotator = true,
       .cost = "4 evaluations, 4 exponentials",
       .source = "Munthe-Kaas, Appl. Numer. Math. 29 (1999) 115", .make = make_rkmk4},
      {.name = "cf4", .title = "Commutator-free, order 4", .family = MethodFamily::lie_group, .order = 4, .keeps_momentum_norm = true, .keeps_momentum_space = true, .takes_heavy = true, .takes_rotator = true,
       .cost = "4 evaluations, 5 exponentials",
       .source = "Celledoni, Marthinsen, Owren, Future Gener. Comput. Syst. 19 (2003) 341", .make = make_cf4},
      {.name = "three_rotations", .title = "Three rotations", .family = MethodFamily::rotations, .order = 2, .keeps_momentum_norm = true, .keeps_momentum_space = true, .symplectic = true, .reversible = true, .takes_heavy = true,
       .cost = "5 turns about axes", .limit = "resonances, first at h |omega| about 2",
       .source = "Hairer, Lubich, Wanner, GNI, VII.5.3; McLachlan 1993, Reich 1994", .make = make_three_rotations},
      {.name = "symmetric_remainder2", .title = "Symmetric + remainder, order 2", .family = MethodFamily::rotations, .order = 2, .keeps_momentum_norm = true, .keeps_momentum_space = true, .symplectic = true, .reversible = true, .takes_heavy = true, .takes_rotator = true,
       .cost = "4 turns", .limit = "resonances, first at h |omega| about 2",
       .source = "Dullweber, Leimkuhler, McLachlan, J. Chem. Phys. 107 (1997) 5840", .make = make_symmetric_remainder2},
      {.name = "symmetric_remainder4", .title = "Symmetric + remainder, order 4", .family = MethodFamily::rotations, .order = 4, .keeps_momentum_norm = true, .keeps_momentum_space = true, .symplectic = true, .reversible = true, .takes_heavy = true, .takes_rotator = true,
       .cost = "20 turns",
       .source = "the same, composed by Suzuki, Phys. Lett. A 146 (1990) 319", .make = make_symmetric_remainder4},
      {.name = "symmetric_remainder6", .title = "Symmetric + remainder, order 6", .family = MethodFamily::rotations, .order = 6, .keeps_momentum_norm = true, .keeps_momentum_space = true, .symplectic = true, .reversible = true, .takes_heavy = true, .takes_rotator = true,
       .cost = "36 turns",
       .source = "the same, composed by Kahan and Li, Math. Comp. 66 (1997) 1089", .make = make_symmetric_remainder6},
      {.name = "dmv2", .title = "Moser-Veselov, order 2", .family = MethodFamily::moser_veselov, .order = 2, .keeps_energy = true, .keeps_momentum_norm = true, .keeps_momentum_space = true, .symplectic = true, .reversible = true,
       .cost = "Newton, 3x3", .limit = "no solution beyond h |omega| = 1", .limit_of = StepLimit::spin, .limit_turn = 1.0,
       .source = "Moser and Veselov, Comm. Math. Phys. 139 (1991) 217", .make = make_dmv2},
      {.name = "dmv4", .title = "Moser-Veselov, order 4", .family = MethodFamily::moser_veselov, .order = 4, .keeps_energy = true, .keeps_momentum_norm = true, .keeps_momentum_space = true, .reversible = true,
       .cost = "Newton, 3x3", .limit = "none beyond h |omega| about 1",
       .source = "Hairer and Vilmart, J. Phys. A 39 (2006) 13225", .make = make_dmv4},
      {.name = "dmv6", .title = "Moser-Veselov, order 6", .family = MethodFamily::moser_veselov, .order = 6, .keeps_energy = true, .keeps_momentum_norm = true, .keeps_momentum_space = true, .reversible = true,
       .cost = "Newton, 3x3", .limit = "none beyond h |omega| about 1",
       .source = "Hairer and Vilmart, J. Phys. A 39 (2006) 13225", .make = make_dmv6},
      {.name = "dmv8", .title = "Moser-Veselov, order 8", .family = MethodFamily::moser_veselov, .order = 8, .keeps_energy = true, .keeps_momentum_norm = true, .keeps_momentum_space = true, .reversible = true,
       .cost = "Newton, 3x3", .limit = "none beyond h |omega| about 1",
       .source = "Hairer and Vilmart, J. Phys. A 39 (2006) 13225", .make = make_dmv8},
      {.name = "dmv10", .title = "Moser-Veselov, order 10", .family = MethodFamily::moser_veselov, .order = 10, .keeps_energy = true, .keeps_momentum_norm = true, .keeps_momentum_space = true, .reversible = true,
       .cost = "Newton, 3x3", .limit = "none beyond h |omega| about 1",
       .source = "Hairer and Vilmart, J. Phys. A 39 (2006) 13225", .make = make_dmv10},
      {.name = "kick_strang", .title = "Strang splitting", .family = MethodFamily::kicks, .order = 2, .keeps_momentum_norm = true, .keeps_momentum_space = true, .symplectic = true, .reversible = true, .exact_when_free = true, .takes_heavy = true, .takes_rotator = true,
       .cost = "1 free motion, 2 kicks", .limit = "resonance at h pi / slow precession",
       .source = "Strang, SIAM J. Numer. Anal. 5 (1968) 506", .make = make_kick_strang},
      {.name = "kick_suzuki4", .title = "Suzuki splitting, order 4", .family = MethodFamily::kicks, .order = 4, .keeps_momentum_norm = true, .keeps_momentum_space = true, .symplectic = true, .reversible = true, .exact_when_free = true, .takes_heavy = true, .takes_rotator = true,
       .cost = "5 free motions, 6 kicks",
       .source = "Suzuki, Phys. Lett. A 146 (1990) 319", .make = make_kick_suzuki4},
      {.name = "kick_chin4", .title = "Chin splitting, order 4", .family = MethodFamily::kicks, .order = 4, .keeps_momentum_norm = true, .keeps_momentum_space = true, .symplectic = true, .reversible = true, .exact_when_free = true, .takes_heavy = true, .takes_rotator = true,
       .cost = "2 free motions, 3 kicks",
       .source = "Chin, Phys. Lett. A 226 (1997) 344, scheme A", .make = make_kick_chin4},
      {.name = "kick_srkn6", .title = "Blanes-Moan splitting, order 4", .family = MethodFamily::kicks, .order = 4, .keeps_momentum_norm = true, .keeps_momentum_space = true, .symplectic = true, .reversible = true, .exact_when_free = true, .takes_heavy = true, .takes_rotator = true,
       .cost = "6 free motions, 7 kicks",
       .source = "Blanes and Moan, J. Comput. Appl. Math. 142 (2002) 313, SRKN 6b", .make = make_kick_srkn6},
      {.name = "kick_srkn11", .title = "Blanes-Moan splitting, order 6", .family = MethodFamily::kicks, .order = 6, .keeps_momentum_norm = true, .keeps_momentum_space = true, .symplectic = true, .reversible = true, .exact_when_free = true, .takes_heavy = true, .takes_rotator = true,
       .cost = "11 free motions, 12 kicks",
       .source = "Blanes and Moan, J. Comput. Appl. Math. 142 (2002) 313, SRKN 11b", .make = make_kick_srkn11},
      {.name = "table_euler", .title = "Explicit Euler on a table", .family = MethodFamily::table, .order = 1, .takes_loads = true, .takes_table = true, .only_table = true, .takes_rotator = true,
       .cost = "1 evaluation, 3x3 solve", .limit = "none; drifts off the table, and its energy grows",
       .source = "accelerations that keep the constraint; kept to show how it fails", .make = make_table_euler},
      {.name = "table_penalty", .title = "Penalty springs", .family = MethodFamily::table, .order = 1, .takes_loads = true, .takes_table = true, .only_table = true, .takes_rotator = true,
       .cost = "1 evaluation", .limit = "the period of a stiff spring",
       .source = "a spring with a damper instead of a table; kept to show how it fails", .make = make_table_penalty},
      {.name = "table_smoothed", .title = "Smoothed friction", .family = MethodFamily::table, .order = 1, .takes_loads = true, .takes_table = true, .only_table = true, .takes_rotator = true,
       .cost = "1 evaluation, 3x3 solve", .limit = "the time in which small slip is damped",
       .source = "dry friction in proportion to small slip; kept to show how it creeps", .make = make_table_smoothed},
      {.name = "table_baumgarte", .title = "Impulses, Baumgarte 0.2", .family = MethodFamily::table, .order = 1, .takes_loads = true, .takes_table = true, .only_table = true, .takes_rotator = true,
       .cost = "1 evaluation, 3x3 solve", .limit = "none, but does not keep the energy",
       .source = "game engines; Baumgarte, Comput. Methods Appl. Mech. Eng. 1 (1972) 1", .make = make_table_baumgarte},
      {.name = "table_baumgarte_hard", .title = "Impulses, Baumgarte 1.8", .family = MethodFamily::table, .order = 1, .takes_loads = true, .takes_table = true, .only_table = true, .takes_rotator = true,
       .cost = "1 evaluation, 3x3 solve", .limit = "close to unstable: a gain of 2 is",
       .source = "the same with too large a gain; kept to show how it fails", .make = make_table_baumgarte_hard},
      {.name = "table_projection", .title = "Impulses, position put right", .family = MethodFamily::table, .order = 1, .takes_loads = true, .takes_table = true, .only_table = true, .takes_rotator = true,
       .cost = "1 evaluation, 3x3 solve", .limit = "none, but does not keep the energy",
       .source = "position-level projection of game engines", .make = make_table_projection},
      {.name = "table_rk4", .title = "RK4 without events", .family = MethodFamily::table, .order = 4, .takes_loads = true, .takes_table = true, .only_table = true, .takes_rotator = true, .takes_bounces = true,
       .cost = "4 evaluations", .limit = "order 1 across events",
       .source = "Kutta 1901, in reduced coordinates; kept to show what missed events do", .make = make_table_rk4},
  };
  // clang-format on
  return table;
}

const StepperInfo& find_stepper(const std::string& name) {
  for (const StepperInfo& row : stepper_table()) {
    if (row.name == name) return row;
  }
  std::vector<std::string> names;
  for (const StepperInfo& row : stepper_table())
    names.push_back(row.name);
  throw input_error("unknown method '{}'{}", name, suggestion(name, names));
}

std::vector<const StepperInfo*> parse_methods(const std::string& names) {
  std::vector<const StepperInfo*> methods;
  for (const std::string& name : split_names(names)) {
    const StepperInfo& found =
        at_place({{}, 0, "--methods"}, [&]() -> const StepperInfo& { return find_stepper(name); });
    if (std::find(methods.begin(), methods.end(), &found) == methods.end())
      methods.push_back(&found);
  }
  if (methods.empty()) {
    for (const StepperInfo& row : stepper_table())
      methods.push_back(&row);
  }
  return methods;
}

std::string why_not(const StepperInfo& method, const BodyModel& model) {
  return with_names_of_others(method, model, obstacle);
}

std::string why_not_by_fixed_steps(const StepperInfo& method, const BodyModel& model) {
  return with_names_of_others(method, model, obstacle_to_fixed_steps);
}

}  // namespace polhode
