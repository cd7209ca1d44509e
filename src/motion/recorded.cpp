// SPDX-License-Identifier: MIT
#include "motion/recorded.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/units.h"
#include "math/so3.h"
#include "model/contact_invariants.h"
#include "model/figure_axis.h"
#include "motion/deviation.h"

namespace polhode {
namespace {

std::vector<double> parts(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

Vec3 axis_S(const Motion& motion, const Sample& sample) {
  return sample.q_SB * figure_axis_B(motion.model());
}

// what of the momentum the drift is of: on a table, the laws that hold
std::string name_of_kept(const BodyModel& model) {
  if (!model.table) return model.chi_P.squaredNorm() > 0.0 ? "L about the vertical" : "L";
  std::vector<std::string> names;
  for (const ContactInvariant& law : contact_invariants()) {
    if (!law.holds(model)) continue;
    // "momentum_about_contact" as "L about contact"
    std::string name = law.name;
    const std::string momentum = "momentum";
    const std::size_t at = name.find(momentum);
    if (at != std::string::npos) name.replace(at, momentum.size(), "L");
    std::replace(name.begin(), name.end(), '_', ' ');
    // those of one word are called after people
    if (name.find(' ') == std::string::npos && name.front() >= 'a')
      name.front() = static_cast<char>(name.front() - ('a' - 'A'));
    names.push_back(name);
  }
  if (names.empty()) return "nothing else";
  if (names.size() > 2) return "constants of motion";  // more names than a heading holds
  return names.size() == 1 ? names.front() : names.front() + ", " + names.back();
}

std::string needs_table(const Motion& motion) {
  if (!motion.model().table) return "needs a body on a table";
  if (!motion.contact_at(0.0)) return "needs the method dop853; others do not tell what touches";
  return "";
}

std::string needs_constants(const Motion& motion) {
  const Drift drift = drift_at(motion, 0.0);
  return drift.energy || drift.momentum
             ? ""
             : "needs a motion that keeps its energy or angular momentum; loads change both here";
}

constexpr double kNoPeriod = 0.0;

}  // namespace

// Long, because it is one table: a row for each.
const std::vector<Recorded>& recorded_quantities() {
  static const std::vector<Recorded> table = {
      {"omega",
       "angular velocity in body axes",
       "rad/s",
       {"Ω₁", "Ω₂", "Ω₃"},
       [](const Motion&, const Sample& now) {
         return parts(now.w_B);
       }},
      {"omega_space",
       "angular velocity in space axes",
       "rad/s",
       {"Ωx", "Ωy", "Ωz"},
       [](const Motion&, const Sample& now) {
         return parts(now.w_S);
       }},
      {"momentum",
       "angular momentum in space axes",
       "kg m²/s",
       {"Lx", "Ly", "Lz"},
       [](const Motion&, const Sample& now) {
         return parts(now.L_S);
       }},
      {"momentum_body",
       "angular momentum in body axes",
       "kg m²/s",
       {"L₁", "L₂", "L₃"},
       [](const Motion&, const Sample& now) {
         return parts(now.q_SB.conjugate() * now.L_S);
       }},
      {"tilt",
       "tilt of the axis",
       "°",
       {"θ"},
       [](const Motion& motion, const Sample& now) {
         const double tilt = angle_between(axis_S(motion, now), motion.model().up_S);
         return std::vector<double>{tilt * 180.0 / kPi};
       }},
      {"azimuth",
       "azimuth of the axis",
       "°",
       {"φ"},
       [](const Motion& motion, const Sample& now) {
         // about the vertical, from X; for a vertical that is not Z, from where turning Z there
         // takes X
         const Quat upright = turn_between(motion.model().up_S, Vec3::UnitZ());
         const Vec3 axis = upright * axis_S(motion, now);
         return std::vector<double>{std::atan2(axis.y(), axis.x()) / kDegree};
       },
       360.0},
      {"euler_angles",
       "zxz angles",
       "°",
       {"φ", "θ", "ψ"},
       [](const Motion&, const Sample& now) {
         const Vec3 angles = zxz_angles(now.q_SB);
         // while the axis is upright, phi and psi are any two with the same sum or difference
         const bool upright = std::sin(angles[1]) < 1e-9;
         const auto within_a_turn = [&](double angle) {
           return upright ? NAN : std::remainder(angle, 2.0 * kPi) / kDegree;
         };
         return std::vector<double>{
             within_a_turn(angles[0]), angles[1] / kDegree, within_a_turn(angles[2])};
       },
       360.0},
      {"euler_rates",
       "rates of the zxz angles",
       "rad/s",
       {"φ′", "θ′", "ψ′"},
       [](const Motion& motion, const Sample& now) {
         // rings, which know their rates in gimbal lock too, turn about the vertical
         const BodyModel& model = motion.model();
         if (model.loads.gimbals && model.up_S == Vec3::UnitZ())
           return parts(motion.state_at(now.t).rings.rates);
         return parts(zxz_rates_from_body_rate(zxz_angles(now.q_SB), now.w_B));
       }},
      {"energy",
       "energy",
       "J",
       {"total", "kinetic", "potential"},
       [](const Motion& motion, const Sample& now) {
         const double turning = 0.5 * now.w_S.dot(now.L_S);
         const double moving =
             0.5 * motion.model().body.mass * now.reference_velocity_S.squaredNorm();
         const double rings = kinetic_energy_of_gimbals(motion.model(), motion.state_at(now.t));
         const double kinetic = turning + moving + rings;
         return std::vector<double>{now.energy, kinetic, now.energy - kinetic};
       }},
      {"drift",
       "drift",
       "",
       {"energy", "L"},
       [](const Motion& motion, const Sample& now) {
         const Drift drift = drift_at(motion, now.t);
         return std::vector<double>{drift.energy.value_or(NAN), drift.momentum.value_or(NAN)};
       },
       kNoPeriod,
       needs_constants,
       [](const BodyModel& model) {
         return std::vector<std::string>{"energy", name_of_kept(model)};
       }},
      {"contact_force",
       "forces of the table",
       "N",
       {"N", "F"},
       [](const Motion& motion, const Sample& now) {
         if (!motion.contact_at(now.t)) return std::vector<double>{NAN, NAN};
         const std::optional<Reaction> found = reaction_at(motion, now.t);
         if (!found) return std::vector<double>{0.0, 0.0};
         return std::vector<double>{found->normal, found->friction_S.norm()};
       },
       kNoPeriod,
       needs_table},
      {"slip",
       "slip on the table",
       "m/s",
       {"v"},
       [](const Motion& motion, const Sample& now) {
         const std::optional<Reaction> found = reaction_at(motion, now.t);
         return std::vector<double>{found ? found->slip_S.norm() : NAN};
       },
       kNoPeriod,
       needs_table},
      {"jellett",
       "Jellett's constant −L·r",
       "kg m³/s",
       {"λ"},
       [](const Motion& motion, const Sample& now) {
         const std::optional<Reaction> found = reaction_at(motion, now.t);
         if (!found) return std::vector<double>{NAN};
         const Vec3 L_P = (now.q_SB * Quat(motion.model().R_BP)).conjugate() * now.L_S;
         return std::vector<double>{-L_P.dot(found->point.arm_P)};
       },
       kNoPeriod,
       needs_table},
      {"position",
       "centre of mass",
       "m",
       {"x", "y", "z"},
       [](const Motion&, const Sample& now) {
         return parts(now.center_S);
       }},
  };
  return table;
}

const Recorded* find_recorded(const std::string& name) {
  for (const Recorded& quantity : recorded_quantities()) {
    if (quantity.name == name) return &quantity;
  }
  return nullptr;
}

std::vector<std::string> curve_names(const Recorded& quantity, const Motion& motion) {
  return quantity.names != nullptr ? quantity.names(motion.model()) : quantity.curves;
}

std::string why_not(const Recorded& quantity, const Motion& motion) {
  return quantity.why_not != nullptr ? quantity.why_not(motion) : "";
}

std::vector<std::vector<double>> values_over_time(const Recorded& quantity,
                                                  const Motion& motion,
                                                  double end,
                                                  int steps) {
  std::vector<std::vector<double>> curves(quantity.curves.size());
  std::vector<double> before;
  for (int i = 0; i <= steps; ++i) {
    const std::vector<double> now = quantity.values(motion, motion.at(end * i / steps));
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const bool begins_again = quantity.period > 0.0 && !before.empty() &&
                                std::abs(now[k] - before[k]) > 0.5 * quantity.period;
      curves[k].push_back(begins_again ? NAN : now[k]);
    }
    before = now;
  }
  return curves;
}

namespace {

// The least and the greatest value of a curve within a step, and where they are, s.
struct Peaks {
  double low, high, at_low, at_high;

  void meet(double value, double at) {
    if (value < low) {
      low = value;
      at_low = at;
    }
    if (value > high) {
      high = value;
      at_high = at;
    }
  }
};

}  // namespace

void add_peaks(const Recorded& quantity,
               const Motion& motion,
               double end,
               std::vector<std::vector<double>>& curves) {
  constexpr double kBent = 0.05;   // of the values, and
  constexpr double kSeen = 0.002;  // of the range of the curve
  constexpr int kMostHalvings = 20;
  if (quantity.period > 0.0 || curves.empty()) return;
  const std::size_t steps = curves.front().size() - 1;
  const auto most_looks = 4 * static_cast<long>(steps) + 20'000;  // round-off is bent everywhere
  std::vector<double> range;
  for (const std::vector<double>& values : curves) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const double value : values) {
      low = std::fmin(low, value);
      high = std::fmax(high, value);
    }
    range.push_back(high - low);
  }
  long looks = 0;
  std::vector<Peaks> peaks(curves.size());
  using Values = std::vector<double>;
  const std::function<void(double, const Values&, double, const Values&, int)> look =
      [&](double from, const Values& a, double to, const Values& b, int depth) {
        const double middle = 0.5 * (from + to);
        const Values m = quantity.values(motion, motion.at(middle));
        ++looks;
        bool bent = false;
        for (std::size_t k = 0; k < m.size(); ++k) {
          const double off = std::abs(m[k] - 0.5 * (a[k] + b[k]));
          const double size = std::abs(a[k]) + std::abs(m[k]) + std::abs(b[k]);
          bent = bent || (off > kBent * size / 3.0 && off > kSeen * range[k]);
          peaks[k].meet(m[k], middle);
        }
        if (!bent || depth >= kMostHalvings || looks > most_looks) return;
        look(from, a, middle, m, depth + 1);
        look(middle, m, to, b, depth + 1);
      };
  const auto values_at = [&](std::size_t i) {
    Values values;
    for (const std::vector<double>& curve : curves)
      values.push_back(curve[i]);
    return values;
  };
  const double step = end / static_cast<double>(steps);
  Values a = values_at(0);
  for (std::size_t i = 0; i < steps && looks <= most_looks; ++i) {
    const Values b = values_at(i + 1);
    const double from = step * static_cast<double>(i), to = from + step;
    for (std::size_t k = 0; k < b.size(); ++k) {
      peaks[k] = {a[k], a[k], from, from};
      peaks[k].meet(b[k], to);
    }
    const long before = looks;
    look(from, a, to, b, 0);
    // what is hardly bent stays as it is
    for (std::size_t k = 0; k < b.size() && looks > before + 1; ++k) {
      const auto put = [&](double value, double at) {
        curves[k][at < from + 0.5 * step ? i : i + 1] = value;
      };
      if (peaks[k].low < std::fmin(a[k], b[k])) put(peaks[k].low, peaks[k].at_low);
      if (peaks[k].high > std::fmax(a[k], b[k])) put(peaks[k].high, peaks[k].at_high);
    }
    a = b;
  }
}

int steps_to_show(const Motion& motion, double end, int least) {
  constexpr double kShownInATurn = 24.0, kFewestInATurn = 8.0;
  constexpr double kShownInAPulse = 12.0;
  const Loads& loads = motion.model().loads;
  double fastest = 0.0;  // of what turns, rad/s
  for (const std::vector<double>& times :
       {scattered_times(end, 256), times_after_switches(loads.switches, end)}) {
    for (const double t : times)
      fastest = std::max(fastest, motion.at(t).w_B.norm());
  }
  fastest = std::max(fastest, loads.fastest());
  double needed = std::ceil(kShownInATurn * fastest * end / (2.0 * kPi));
  const bool enough = needed * kFewestInATurn <= kMostShown * kShownInATurn;
  double before = 0.0;
  for (const double t : loads.switches) {
    if (t > before && t < end) needed = std::max(needed, kShownInAPulse * end / (t - before));
    before = t;
  }
  if (enough) needed = std::min(needed, kMostShown - 1.0);
  return static_cast<int>(std::clamp(needed, 1.0 * least, 1.0 * kMostShown));
}

std::vector<double> extremes_of(const std::vector<double>& values, int most) {
  if (values.size() <= static_cast<std::size_t>(most) + 1) return values;
  // the first value, then two for each column
  const std::size_t columns = static_cast<std::size_t>(most) / 2;
  const auto is_nan = [](double value) {
    return std::isnan(value);
  };
  // where an angle begins again in most columns, gaps would leave nothing
  const auto gaps = static_cast<std::size_t>(std::count_if(values.begin(), values.end(), is_nan));
  const bool with_gaps = 4 * gaps < columns;
  std::vector<double> kept = {values.front()};
  for (std::size_t i = 0; i < columns; ++i) {
    const std::size_t from = 1 + (values.size() - 1) * i / columns;
    const std::size_t to = 1 + (values.size() - 1) * (i + 1) / columns;
    std::size_t low = from, high = from;
    bool gap = is_nan(values[from]);
    for (std::size_t k = from + 1; k < to; ++k) {
      gap = gap || is_nan(values[k]);
      if (is_nan(values[low]) || values[k] < values[low]) low = k;
      if (is_nan(values[high]) || values[k] > values[high]) high = k;
    }
    const bool none = gap && with_gaps;
    kept.push_back(none ? NAN : values[std::min(low, high)]);
    kept.push_back(none ? NAN : values[std::max(low, high)]);
  }
  return kept;
}

std::vector<std::vector<double>> drawn_values(
    const Recorded& quantity, const Motion& motion, double end, int steps, int most) {
  std::vector<std::vector<double>> curves = values_over_time(quantity, motion, end, steps);
  add_peaks(quantity, motion, end, curves);
  for (std::vector<double>& values : curves)
    values = extremes_of(values, most);
  return curves;
}

std::vector<std::string> recorded_names() {
  std::vector<std::string> names;
  for (const Recorded& row : recorded_quantities())
    names.push_back(row.name);
  return names;
}

}  // namespace polhode
