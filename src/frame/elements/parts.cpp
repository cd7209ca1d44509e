// SPDX-License-Identifier: MIT
#include "frame/elements/parts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "math/so3.h"

namespace polhode {
namespace {

// in units of the body's radius: shorter vectors have no name, longer ones have it in full. Between
// them it is pale, which looks like a fault in a still, so this is narrow.
constexpr double kShortestNamed = 0.08;
constexpr double kLongEnough = 0.11;
constexpr double kNameOff = 0.12;      // of names from their curves
constexpr double kSizeOfNames = 0.62;  // of their type, in that of names of vectors

bool is_free_top(const Scenery& scenery) {
  const BodyModel& model = scenery.motion.model();
  return model.chi_P.squaredNorm() == 0.0 && !model.loads.turn_body() && !model.with_translation;
}

}  // namespace

Material plain(const glm::vec3& color, float gloss) {
  Material material;
  material.color = color;
  material.gloss = gloss;
  return material;
}

Material shell(const glm::vec3& color, float alpha) {
  Material material = plain(color, 0.15f);
  material.alpha = alpha;
  return material;
}

Material drawn_through(const Scenery& scenery, Material material) {
  material.vivid = true;
  if (scenery.options.hidden == "none") return material;
  const bool dashed = scenery.options.hidden == "dashed";
  material.hidden = dashed ? 0.8f : 0.35f;
  material.dashes = dashed ? 1.0f : 0.0f;
  return material;
}

ArrowShape times(const ArrowShape& shape, double factor) {
  return {shape.shaft_radius * factor, shape.head_radius * factor, shape.head_length * factor};
}

float name_presence(const Scenery& scenery, double length) {
  const double part =
      (length / scenery.scale.body - kShortestNamed) / (kLongEnough - kShortestNamed);
  return static_cast<float>(std::clamp(part, 0.0, 1.0));
}

void add_vector(const Scenery& scenery,
                const Vec3& from,
                const Vec3& end,
                const ArrowShape& shape,
                const Material& material,
                Glyphs& glyphs,
                const std::string& name) {
  add_position(scenery, from, drawn_tip(scenery, from, end), shape, material, glyphs, name);
}

void add_position(const Scenery& scenery,
                  const Vec3& from,
                  const Vec3& place,
                  const ArrowShape& shape,
                  const Material& material,
                  Glyphs& glyphs,
                  const std::string& name) {
  const ArrowShape drawn = times(shape, scenery.thickness * scenery.scale.body);
  glyphs.arrows.push_back({from, place, drawn, drawn_through(scenery, material)});
  // the name of a vector that shrinks into the body goes with it
  const float fade = name_presence(scenery, (place - from).norm());
  if (name.empty() || fade <= 0.0f) return;
  glyphs.labels.push_back({place, place - from, name, material.color, fade, true});
}

void add_at_reference(const Scenery& scenery,
                      const Sample& sample,
                      const Vec3& along,
                      const ArrowShape& shape,
                      const Material& material,
                      Glyphs& glyphs,
                      const std::string& name) {
  const Vec3& from = sample.reference_S;
  add_vector(scenery, from, from + along, shape, material, glyphs, name);
}

bool in_gimbals(const Scenery& scenery) {
  return asks_for(scenery, "gimbals");
}

double foot_depth(const Scenery& scenery) {
  return (scenery.stand_height + (in_gimbals(scenery) ? kOuterGimbal : 0.0)) * scenery.scale.body;
}

Placement body_placement(const Scenery& scenery, const Sample& sample) {
  Placement place = Placement::Identity();
  place.linear() = sample.q_SB.toRotationMatrix();
  place.translation() = sample.reference_S - place.linear() * scenery.motion.model().reference_B();
  return place;
}

Placement principal_placement(const Scenery& scenery, const Sample& sample) {
  Placement place = Placement::Identity();
  place.linear() = sample.q_SB.toRotationMatrix() * scenery.motion.model().R_BP;
  place.translation() = sample.reference_S;
  return place;
}

Placement ball_placement(const Vec3& center, double radius) {
  Placement place = Placement::Identity();
  place.translation() = center;
  place.linear() *= radius;
  return place;
}

Placement disc_placement(const Vec3& center, const Vec3& normal, double radius) {
  Placement place = Placement::Identity();
  place.translation() = center;
  place.linear() = turn_between(Vec3::UnitZ(), normal).toRotationMatrix() * radius;
  return place;
}

void add_rim_reach(const Placement& disc, int count, Glyphs& glyphs) {
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * kPi * k / count;
    glyphs.reach.push_back(disc * Vec3(std::cos(angle), std::sin(angle), 0.0));
  }
}

void add_line(const std::function<Vec3(std::size_t i)>& point,
              std::size_t points,
              std::size_t count,
              Glyphs& glyphs) {
  if (points < 2) return;
  const std::size_t pieces = std::min(count, points - 1);
  for (std::size_t k = 0; k < pieces; ++k) {
    glyphs.lines.push_back(
        {point(k * (points - 1) / pieces), point((k + 1) * (points - 1) / pieces)});
  }
}

void add_ball_reach(const Placement& place, Glyphs& glyphs) {
  constexpr int kAround = 24;
  // as far out as the middles of the faces between the points lie inside
  static const std::vector<Vec3> points = [] {
    const double step = 2.0 * kPi / kAround;
    const double out = 1.0 / (std::cos(0.5 * step) * std::cos(0.5 * step));
    std::vector<Vec3> found = {{0.0, 0.0, out}, {0.0, 0.0, -out}};
    for (int i = 1; i < kAround / 2; ++i) {
      for (int k = 0; k < kAround; ++k) {
        const double r = std::sin(i * step);
        found.emplace_back(
            out * Vec3(r * std::cos(k * step), r * std::sin(k * step), std::cos(i * step)));
      }
    }
    return found;
  }();
  for (const Vec3& point : points)
    glyphs.reach.push_back(place * point);
}

void add_name(const Scenery& scenery,
              const Vec3& at,
              const Vec3& off,
              const char* name,
              const glm::vec3& color,
              float fade,
              Glyphs& glyphs) {
  const Vec3 away = kNameOff * scenery.scale.body * off.normalized();
  glyphs.labels.push_back({at + away, away, name, color, fade, false, kSizeOfNames});
}

Vec3 principal_rate(const BodyModel& model, const Sample& sample) {
  return model.R_BP.transpose() * sample.w_B;
}

double twice_the_energy(const BodyModel& model, const Vec3& w_P) {
  return w_P.dot(model.moments.cwiseProduct(w_P));
}

bool has_cones(const Scenery& scenery) {
  const BodyModel& model = scenery.motion.model();
  if (model.table) return false;
  if (model.chi_P.squaredNorm() > 0.0 || !model.loads.only_damp_momentum()) return false;
  if (!model.kind.symmetric()) return false;
  const Sample start = scenery.motion.at(0.0);
  return angle_between(start.w_S, start.L_S) > kSmallestCone;
}

// a stand under the pivot would be in the way of a body that hangs
bool stays_above_stand(const Scenery& scenery) {
  const Vec3 axis_B = figure_axis_B(scenery.motion.model());
  const Vec3& up = scenery.motion.model().up_S;
  const std::vector<double> times = framing_times(scenery.motion);
  return std::all_of(times.begin(), times.end(), [&](double t) {
    return (scenery.motion.at(t).q_SB * axis_B).dot(up) >= -0.3;
  });
}

// Like a thing that is held over a table: nothing that is drawn comes as low, and it stays where it
// is. What is as large as a planet, or as small as a molecule, is not.
bool hovers(const Scenery& scenery) {
  constexpr double kSmallest = 0.002, kLargest = 20.0;  // m
  const BodyModel& model = scenery.motion.model();
  if (model.on_pivot || model.with_translation || gradient_of(scenery) != nullptr) return false;
  if (scenery.scale.body < kSmallest || scenery.scale.body > kLargest) return false;
  for (const char* large :
       {"ellipsoid", "plane", "herpolhode", "binet", "trail_sphere", "fixed_frame"}) {
    if (asks_for(scenery, large)) return false;
  }
  const double floor = -kFreeFloor * scenery.scale.body;
  const std::vector<double> times = framing_times(scenery.motion);
  return std::all_of(times.begin(), times.end(), [&](double t) {
    const Sample sample = scenery.motion.at(t);
    const auto height = [&](const Vec3& tip) {
      return (tip - sample.reference_S).dot(model.up_S);
    };
    const double moved = (sample.reference_S - scenery.motion.at(0.0).reference_S).norm();
    return moved < 1e-3 * scenery.scale.body && height(omega_tip(scenery, sample)) > floor &&
           height(momentum_tip(scenery, sample)) > floor;
  });
}

const Load* gradient_of(const Scenery& scenery) {
  const std::vector<Load>& listed = scenery.motion.model().loads.listed;
  const auto found = std::find_if(listed.begin(), listed.end(), [](const Load& load) {
    return load.kind == Load::Kind::gradient;
  });
  return found == listed.end() ? nullptr : &*found;
}

bool has_forces(const Scenery& scenery) {
  const std::vector<Load>& listed = scenery.motion.model().loads.listed;
  return std::any_of(listed.begin(), listed.end(), [](const Load& load) {
    return load.kind == Load::Kind::force || load.kind == Load::Kind::couple ||
           load.kind == Load::Kind::spring;
  });
}

std::string needs_forces(const Scenery& scenery) {
  return has_forces(scenery) ? "" : "needs a force, a couple or a spring in motion.torque";
}

std::string needs_cones(const Scenery& scenery) {
  if (has_cones(scenery)) return "";
  return fmt::format(
      "the space and body cones need a free symmetric top whose angular velocity is at least {:g} "
      "rad from its angular momentum",
      kSmallestCone);
}

std::string needs_pivot(const Scenery& scenery) {
  return scenery.motion.model().on_pivot ? "" : "needs a body on a pivot (motion.hold = \"pivot\")";
}

std::string needs_free(const Scenery& scenery) {
  if (scenery.motion.model().on_pivot && !is_free_top(scenery))
    return "needs a body that no torque turns; on a pivot, gravity does";
  if (!is_free_top(scenery)) return "needs a body that no torque turns";
  if (scenery.motion.model().kind.rotator) return "needs a body that is no thin rod";
  return scenery.motion.at(0.0).w_B.norm() > 0.0 ? "" : "needs a body that turns";
}

}  // namespace polhode
