// SPDX-License-Identifier: MIT
#include "model/loads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/ranges.h>

#include "base/error.h"
#include "base/nearest.h"
#include "model/given_keys.h"

namespace polhode {
namespace {

// sin(x)/x
double sinc(double x) {
  return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x;
}

double swing(double rate, double phase, double t) {
  return rate == 0.0 && phase == 0.0 ? 1.0 : std::cos(rate * t + phase);
}

std::vector<std::string> given_keys(const LoadSpec& s) {
  std::vector<std::string> names;
  if (s.space) names.emplace_back("space");
  if (s.body) names.emplace_back("body");
  if (s.at) names.emplace_back("at");
  if (s.opposite) names.emplace_back("opposite");
  if (s.to) names.emplace_back("to");
  if (s.k) names.emplace_back("k");
  if (s.length) names.emplace_back("length");
  if (s.c) names.emplace_back("c");
  if (s.of) names.emplace_back("of");
  if (s.about) names.emplace_back("about");
  if (s.rate) names.emplace_back("rate");
  if (s.phase) names.emplace_back("phase");
  if (s.from) names.emplace_back("from");
  if (s.until) names.emplace_back("until");
  if (s.ramp) names.emplace_back("ramp");
  return names;
}

const LoadKind& kind_of(const LoadSpec& spec, const std::string& path) {
  for (const LoadKind& kind : load_kinds()) {
    if (kind.name == spec.kind) return kind;
  }
  throw input_error("unknown load '{}'{}", spec.kind, suggestion(spec.kind, load_names()))
      .at({{}, 0, path + ".kind"});
}

void check_keys_of(const LoadSpec& spec, const std::string& path) {
  const LoadKind& kind = kind_of(spec, path);
  const std::vector<std::string> given = given_keys(spec);
  std::vector<std::string> known = kind.needs;
  known.insert(known.end(), kind.takes.begin(), kind.takes.end());
  if (kind.directed) known.insert(known.end(), {"space", "body"});
  known.insert(known.end(), {"from", "until", "ramp"});
  require_keys(kind.name, kind.needs, given, path);
  if (kind.directed && !spec.space && !spec.body) {
    throw input_error("{} needs 'space' or 'body', its vector in those axes",
                      with_article(kind.name))
        .at({{}, 0, path});
  }
  refuse_other_keys(kind.name, known, given, path);
}

Switching switching_of(const LoadSpec& spec, const std::string& path) {
  Switching acts;
  acts.ramp = spec.ramp.value_or(0.0);
  if (spec.from || (acts.ramp > 0.0 && !spec.until)) acts.from = spec.from.value_or(0.0);
  if (spec.until) acts.until = *spec.until;
  const double whole = acts.from + acts.ramp;
  // the sum is rounded: 0.1 + 0.2 is more than 0.3
  const double rounding = std::numeric_limits<double>::epsilon() * std::abs(whole);
  if (acts.until <= acts.from || acts.until < whole - rounding) {
    throw input_error("the load ends at {} s, before it has begun: it {} at {:.15g} s",
                      acts.until,
                      acts.ramp > 0.0 ? "is whole" : "begins",
                      whole)
        .at({{}, 0, path + ".until"});
  }
  return acts;
}

// what happens at or before the start does not happen
void add_switches(const Switching& acts, std::vector<double>& switches) {
  for (const double t : {acts.from, acts.from + acts.ramp, acts.until, acts.until + acts.ramp}) {
    if (std::isfinite(t) && t > 0.0) switches.push_back(t);
  }
}

// the only axis about which a bearing damps, in P
Vec3 axis_of_damping(const LoadSpec& spec, const Mat3& R_BP, const std::string& path) {
  if (spec.of.value_or("momentum") != "spin") {
    throw input_error("is for damping of = \"spin\": a bearing damps angular velocity")
        .at({{}, 0, path + ".about"});
  }
  if (!(spec.about->norm() > 0.0)) throw input_error("must not be 0").at({{}, 0, path + ".about"});
  return R_BP.transpose() * spec.about->stableNormalized();
}

Load::Kind turned_into(const LoadSpec& spec) {
  if (spec.kind == "constant") return Load::Kind::torque;
  if (spec.kind == "couple") return Load::Kind::couple;
  if (spec.kind == "force") return Load::Kind::force;
  if (spec.kind == "spring") return Load::Kind::spring;
  if (spec.kind == "gravity_gradient") return Load::Kind::gradient;
  return spec.of.value_or("momentum") == "momentum" ? Load::Kind::damp_momentum
                                                    : Load::Kind::damp_spin;
}

}  // namespace

const std::vector<LoadKind>& load_kinds() {
  static const std::vector<LoadKind> kinds = {
      {"constant",
       "a torque that is constant or varies as a cosine of time",
       {},
       {"rate", "phase"},
       true},
      {"damping",
       "a torque -c L or -c omega, or that of a bearing about one axis",
       {"c"},
       {"of", "about"}},
      {"couple",
       "a force on one point of the body and the opposite force on another",
       {"at", "opposite"},
       {"rate", "phase"},
       true},
      {"force",
       "a force on a point of the body, by default the centre of mass",
       {},
       {"at", "rate", "phase"},
       true},
      {"spring",
       "a spring from a point of the body, by default the centre of mass, to a point in space, by "
       "default the origin",
       {"k"},
       {"at", "to", "length"}},
      {"gravity_gradient",
       "the torque of the Earth's field on a satellite in a circular orbit in the plane XY",
       {"rate"},
       {"phase"}},
  };
  return kinds;
}

std::vector<std::string> load_names() {
  std::vector<std::string> names;
  for (const LoadKind& kind : load_kinds())
    names.push_back(kind.name);
  return names;
}

double Switching::part(double t) const {
  if (t < from || t >= until + ramp) return 0.0;
  if (ramp == 0.0) return 1.0;
  return std::min({1.0, (t - from) / ramp, (until + ramp - t) / ramp});
}

bool Load::conservative() const {
  if (!acts.always()) return false;
  switch (kind) {
    case Kind::spring:
      return true;
    case Kind::couple:
    case Kind::force:
      return !in_body && rate == 0.0;
    case Kind::frame:
      return true;
    default:
      return false;
  }
}

double Loads::fastest() const {
  double fastest = 0.0;
  for (const Load& load : listed)
    fastest = std::max(fastest, std::abs(load.rate));
  return fastest;
}

bool Loads::only_damp_momentum() const {
  return !gimbals && std::all_of(turning.begin(), turning.end(), [](const Load& load) {
    return load.kind == Load::Kind::damp_momentum && load.acts.always();
  });
}

double Loads::momentum_damping() const {
  double c = 0.0;
  for (const Load& load : turning)
    c += load.kind == Load::Kind::damp_momentum ? load.c : 0.0;
  return c;
}

Loads make_loads(const std::vector<LoadSpec>& specs,
                 bool on_pivot,
                 const Vec3& center_B,
                 const Vec3& reference_B,
                 const Mat3& R_BP,
                 const Vec3& moments,
                 double noise) {
  Loads loads;
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const LoadSpec& spec = specs[i];
    check_keys_of(spec, fmt::format("motion.torque[{}]", i));
    Load load;
    load.kind = turned_into(spec);
    load.in_body = spec.body.has_value();
    load.vector = spec.body    ? Vec3(R_BP.transpose() * *spec.body)
                  : spec.space ? *spec.space
                               : Vec3(Vec3::Zero());
    const Vec3 from_B = spec.opposite.value_or(reference_B);
    load.arm_P = R_BP.transpose() * (spec.at.value_or(center_B) - from_B);
    load.at_P = R_BP.transpose() * (spec.at.value_or(center_B) - reference_B);
    // an arm of round-off is none: a force on the centre of mass turns nothing
    const double reach = spec.at.value_or(center_B).norm() + from_B.norm();
    const double arm = load.arm_P.norm();
    const bool pulls = load.kind == Load::Kind::spring || load.kind == Load::Kind::force;
    if (pulls && arm <= noise * reach) {
      // a spring pulls about as much as it is long
      const double spring = spec.k.value_or(0.0) * (spec.to.value_or(Vec3::Zero()).norm() + reach +
                                                    spec.length.value_or(0.0));
      loads.left_out += arm * (load.vector.norm() + spring);
      load.arm_P.setZero();
    }
    if (load.kind == Load::Kind::couple && load.arm_P.isZero(0.0)) {
      throw input_error("both forces act at one point and cancel; a couple needs two")
          .at({{}, 0, fmt::format("motion.torque[{}].opposite", i)});
    }
    load.anchor_S = spec.to.value_or(Vec3::Zero());
    load.k = spec.k.value_or(0.0);
    load.length = spec.length.value_or(0.0);
    load.c = spec.c.value_or(0.0);
    load.rate = spec.rate.value_or(0.0);
    load.phase = spec.phase.value_or(0.0);

    if (spec.about) load.about_P = axis_of_damping(spec, R_BP, fmt::format("motion.torque[{}]", i));

    load.moments = moments;
    if (load.kind == Load::Kind::gradient && on_pivot) {
      throw input_error("is for free bodies; this one turns about a fixed point")
          .at({{}, 0, fmt::format("motion.torque[{}].kind", i)});
    }
    if (load.kind == Load::Kind::gradient && load.rate == 0.0) {
      throw input_error("must not be 0: a satellite that does not go round falls")
          .at({{}, 0, fmt::format("motion.torque[{}].rate", i)});
    }
    load.acts = switching_of(spec, fmt::format("motion.torque[{}]", i));
    add_switches(load.acts, loads.switches);

    // a phase without a rate is a constant factor
    if (load.rate == 0.0) load.vector *= std::cos(std::exchange(load.phase, 0.0));
    loads.listed.push_back(load);
    const bool is_force = load.kind == Load::Kind::force;
    const bool pushes = is_force && !load.in_body && !on_pivot && load.acts.always();
    if (pushes) loads.pushes.push_back({load.vector, load.rate, load.phase});
    const bool central = load.arm_P.norm() == 0.0;
    const bool needs_place =
        !on_pivot && (load.kind == Load::Kind::spring || (is_force && !pushes));
    loads.need_place = loads.need_place || needs_place;
    if ((is_force || load.kind == Load::Kind::couple) && central && !needs_place) continue;
    loads.turning.push_back(load);
  }
  std::sort(loads.switches.begin(), loads.switches.end());
  loads.switches.erase(std::unique(loads.switches.begin(), loads.switches.end()),
                       loads.switches.end());
  return loads;
}

Vec3 away_from_earth(const Load& gradient, double t) {
  const double angle = gradient.rate * t + gradient.phase;
  return {std::cos(angle), std::sin(angle), 0.0};
}

void add_wrench(const Load& load,
                double t,
                const Quat& q,
                const Vec3& y,
                const Vec3& w_P,
                const Vec3& place_S,
                Wrench& sum) {
  switch (load.kind) {
    case Load::Kind::damp_momentum:
      sum.torque_P -= load.acts.part(t) * load.c * y;
      break;
    case Load::Kind::damp_spin: {
      const Vec3 damped = load.about_P ? Vec3(load.about_P->dot(w_P) * *load.about_P) : w_P;
      sum.torque_P -= load.acts.part(t) * load.c * damped;
      break;
    }
    case Load::Kind::torque: {
      const Vec3 torque = load.acts.part(t) * swing(load.rate, load.phase, t) * load.vector;
      sum.torque_P += load.in_body ? torque : Vec3(q.conjugate() * torque);
      break;
    }
    case Load::Kind::gradient: {
      // of the first order in the size of the body over its distance from the Earth
      const Vec3 away_P = q.conjugate() * away_from_earth(load, t);
      const double strength = 3.0 * load.rate * load.rate * load.acts.part(t);
      sum.torque_P += strength * away_P.cross(load.moments.cwiseProduct(away_P));
      break;
    }
    case Load::Kind::frame:
      sum.torque_P += frame_torque(load.moments, w_P, q.conjugate() * load.vector);
      break;
    case Load::Kind::couple:
    case Load::Kind::force:
    case Load::Kind::spring: {
      const Vec3 force_S = point_force(load, t, q, place_S);
      sum.torque_P += load.arm_P.cross(q.conjugate() * force_S);
      const bool is_push = load.kind == Load::Kind::force && !load.in_body && load.acts.always();
      if (load.kind != Load::Kind::couple && !is_push) sum.force_S += force_S;
      break;
    }
  }
}

Wrench wrench_of(const std::vector<Load>& loads,
                 double t,
                 const Quat& q,
                 const Vec3& y,
                 const Vec3& w_P,
                 const Vec3& place_S) {
  Wrench sum;
  for (const Load& load : loads)
    add_wrench(load, t, q, y, w_P, place_S, sum);
  return sum;
}

Vec3 point_force(const Load& load, double t, const Quat& q, const Vec3& place_S) {
  if (load.kind == Load::Kind::spring) {
    const Vec3 reach = load.anchor_S - (place_S + q * load.arm_P);
    const double stretched = reach.norm();
    const double rest = stretched > 0.0 ? load.length / stretched : 0.0;
    return load.acts.part(t) * load.k * (1.0 - rest) * reach;
  }
  if (load.kind != Load::Kind::force && load.kind != Load::Kind::couple) return Vec3::Zero();
  const Vec3 force = load.acts.part(t) * swing(load.rate, load.phase, t) * load.vector;
  return load.in_body ? Vec3(q * force) : force;
}

double potential_scale(const std::vector<Load>& loads, const Quat& q, const Vec3& place_S) {
  double sum = 0.0;
  for (const Load& load : loads) {
    if (load.kind == Load::Kind::spring) {
      sum += potential_of({load}, q, place_S);
    } else if (load.kind == Load::Kind::frame) {
      sum += 0.5 * load.moments.maxCoeff() * load.vector.squaredNorm();
    } else if (load.conservative()) {
      sum += load.vector.norm() * load.arm_P.norm();
    }
  }
  return sum;
}

double potential_of(const std::vector<Load>& loads, const Quat& q, const Vec3& place_S) {
  double sum = 0.0;
  for (const Load& load : loads) {
    if (!load.conservative()) continue;
    if (load.kind == Load::Kind::spring) {
      const double stretched = (load.anchor_S - (place_S + q * load.arm_P)).norm();
      sum += 0.5 * load.k * (stretched - load.length) * (stretched - load.length);
    } else if (load.kind == Load::Kind::frame) {
      const Vec3 frame_P = q.conjugate() * load.vector;
      sum -= 0.5 * frame_P.dot(load.moments.cwiseProduct(frame_P));
    } else {
      sum -= load.vector.dot(q * load.arm_P);
    }
  }
  return sum;
}

Vec3 speed_of(const Push& push, double t) {
  // the integral of cos(rate s + phase), as a product that keeps its digits for slow changes
  const double half = 0.5 * push.rate * t;
  return push.force_S * (t * std::cos(push.phase + half) * sinc(half));
}

Vec3 way_of(const Push& push, double t) {
  const double angle = push.rate * t;
  if (std::abs(angle) < 1e-3) {
    const double series = 0.5 * std::cos(push.phase) * (1.0 - angle * angle / 12.0) -
                          std::sin(push.phase) * angle / 6.0 * (1.0 - angle * angle / 20.0);
    return push.force_S * (t * t * series);
  }
  const double half = 0.5 * angle;
  const double mean = std::sin(push.phase + half) * sinc(half) - std::sin(push.phase);
  return push.force_S * (t * mean / push.rate);
}

}  // namespace polhode
