// SPDX-License-Identifier: MIT
#include "frame/elements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/units.h"

namespace polhode {
namespace {

// proportions, in units of the body's radius
constexpr double kOmegaLength = 1.3;
constexpr double kMomentumLength = kReachOfVectors;
constexpr double kVelocityLength = 0.6;
constexpr double kForceLength = 0.8;
constexpr double kBodyAxisLength = 1.2;
constexpr double kSpaceAxisLength = 1.2;
constexpr double kPrecessionSlant = 1.2;
constexpr double kStandHeight = 0.55;
constexpr double kStandRadius = 0.17;
constexpr double kBallRadius = 0.05;
constexpr double kAngleRadius = 0.55;
// where the two are parallel, the shorter one is the thicker one: both are seen
constexpr ArrowShape kOmegaShape{0.025, 0.064, 0.17};
constexpr ArrowShape kMomentumShape{0.018, 0.054, 0.17};
constexpr ArrowShape kAxisShape{0.010, 0.030, 0.10};
constexpr ArrowShape kFieldShape{0.008, 0.024, 0.08};
constexpr double kRimRadius = 0.008;
constexpr double kLongestVector = 50.0;
constexpr double kShortestNamed = 0.05;  // shorter vectors are no more than a dot

// names of what is shown, as the notes write them
constexpr const char* kOmegaName = "<b>Ω</b>";
constexpr const char* kMomentumName = "<b>L</b>";
constexpr std::array<const char*, 3> kBodyAxisNames = {
    "<b>ê</b><sub>1</sub>", "<b>ê</b><sub>2</sub>", "<b>ê</b><sub>3</sub>"};
constexpr std::array<const char*, 3> kSpaceAxisNames = {"<i>X</i>", "<i>Y</i>", "<i>Z</i>"};

constexpr int kFramingTimes = 240;
constexpr std::size_t kFieldPoints = 48;
constexpr double kSmallestCone = 1e-4;  // rad; below this there is no wobble to draw
constexpr double kWidestCone = 0.995 * kPi / 2.0;

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

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

ArrowShape times(const ArrowShape& shape, double factor) {
  return {shape.shaft_radius * factor, shape.head_radius * factor, shape.head_length * factor};
}

void add_vector(const Stage& stage,
                const Vec3& from,
                const Vec3& end,
                const ArrowShape& shape,
                const Material& material,
                Marks& marks,
                const char* name = nullptr) {
  // a vector that a failing method has blown up still fits single precision
  const double most = kLongestVector * stage.scale.body;
  const double length = (end - from).norm();
  const Vec3 tip = length > most ? Vec3(from + (end - from) * (most / length)) : end;
  marks.arrows.push_back({from, tip, times(shape, stage.scale.body), material});
  if (name == nullptr || length < kShortestNamed * stage.scale.body) return;
  marks.labels.push_back({tip, tip - from, name, material.color});
}

// the axis that a picture follows: of symmetry, else towards the centre of mass, else the third
Vec3 figure_axis_B(const Stage& stage) {
  const Model& model = stage.motion.model();
  const Vec3 arm = model.body.center - model.pivot_B;
  const bool off_pivot = model.on_pivot && arm.norm() > 1e-9 * stage.scale.body;
  if (model.kind.symmetric()) {
    const Vec3 axis = model.R_BP.col(model.kind.axis);
    return off_pivot && axis.dot(arm) < 0.0 ? Vec3(-axis) : axis;
  }
  if (off_pivot) return arm.normalized();
  return Vec3::UnitZ();
}

bool has_cones(const Stage& stage) {
  const Model& model = stage.motion.model();
  if (model.chi_P.squaredNorm() > 0.0 || !model.loads.only_damp_momentum()) return false;
  if (!model.kind.symmetric()) return false;
  const Sample start = stage.motion.at(0.0);
  return angle_between(start.w_S, start.L_S) > kSmallestCone;
}

// a stand under the pivot would be in the way of a body that hangs
bool stays_above_stand(const Stage& stage) {
  const Vec3 axis_B = figure_axis_B(stage);
  const Vec3& up = stage.motion.model().up_S;
  const std::vector<double> times = framing_times(stage.motion);
  return std::all_of(times.begin(), times.end(), [&](double t) {
    return (stage.motion.at(t).q_SB * axis_B).dot(up) >= -0.3;
  });
}

void add_body(const Stage& stage, const Sample& sample, Marks& marks) {
  Placement space_from_body = Placement::Identity();
  space_from_body.linear() = sample.q_SB.toRotationMatrix();
  space_from_body.translation() =
      sample.reference_S - space_from_body.linear() * stage.motion.model().reference_B();
  for (const LookPart& part : stage.look) {
    Material material = part.material;
    material.alpha = static_cast<float>(stage.body_opacity);
    marks.meshes.push_back({part.mesh, space_from_body * part.body_from_mesh, material});
  }
  for (const Vec3& point_B : stage.hull_B)
    marks.reach.push_back(space_from_body * point_B);
}

void add_body_axes(const Stage& stage, const Sample& sample, Marks& marks) {
  const Vec3& from = sample.reference_S;
  for (int i = 0; i < 3; ++i) {
    const Vec3 along = kBodyAxisLength * stage.scale.body * (sample.q_SB * Vec3::Unit(i));
    add_vector(stage,
               from,
               from + along,
               kAxisShape,
               plain(stage.theme.body_axes, 0.2f),
               marks,
               kBodyAxisNames[static_cast<std::size_t>(i)]);
  }
}

void add_axes_at(const Stage& stage, const Vec3& from, Marks& marks) {
  for (int i = 0; i < 3; ++i) {
    const Vec3 along = kSpaceAxisLength * stage.scale.body * Vec3::Unit(i);
    add_vector(stage,
               from,
               from + along,
               kAxisShape,
               plain(stage.theme.space_axes, 0.1f),
               marks,
               kSpaceAxisNames[static_cast<std::size_t>(i)]);
  }
}

void add_fixed_frame(const Stage& stage, const Sample& sample, Marks& marks) {
  add_axes_at(stage, Vec3::Zero(), marks);
  add_vector(stage,
             Vec3::Zero(),
             sample.reference_S,
             kAxisShape,
             plain(stage.theme.position, 0.2f),
             marks,
             "<b>R</b>");
}

// between each axis of space and that of the body with the same number
void add_angles(const Stage& stage, const Sample& sample, Marks& marks) {
  for (int i = 0; i < 3; ++i) {
    const Vec3 to = sample.q_SB * Vec3::Unit(i);
    const double angle = angle_between(Vec3::Unit(i), to);
    if (angle < 1e-3 || angle > kPi - 1e-3) continue;
    marks.arcs.push_back({sample.reference_S,
                          Vec3::Unit(i),
                          to,
                          (kAngleRadius + 0.12 * i) * stage.scale.body,
                          0.6 * kAxisShape.shaft_radius * stage.scale.body,
                          plain(stage.theme.position, 0.1f)});
  }
}

void add_cone(const Stage& stage,
              const Sample& sample,
              const Vec3& axis,
              double half_angle,
              double slant,
              const Material& material,
              Marks& marks) {
  if (half_angle < kSmallestCone || half_angle > kWidestCone) return;
  marks.cones.push_back(
      {sample.reference_S, axis, half_angle, slant, kRimRadius * stage.scale.body, material});
}

// the two cones touch along omega and end at its tip
void add_space_cone(const Stage& stage, const Sample& sample, Marks& marks) {
  add_cone(stage,
           sample,
           sample.L_S.normalized(),
           angle_between(sample.L_S, sample.w_S),
           stage.scale.omega * sample.w_S.norm(),
           shell(stage.theme.space_cone, 0.30f),
           marks);
}

void add_body_cone(const Stage& stage, const Sample& sample, Marks& marks) {
  const Vec3 figure = sample.q_SB * figure_axis_B(stage);
  const Vec3 axis = figure.dot(sample.w_S) < 0.0 ? Vec3(-figure) : figure;
  add_cone(stage,
           sample,
           axis,
           angle_between(axis, sample.w_S),
           stage.scale.omega * sample.w_S.norm(),
           shell(stage.theme.body_cone, 0.30f),
           marks);
}

// about the vertical, through the body axis of this moment
void add_precession_cone(const Stage& stage, const Sample& sample, Marks& marks) {
  const Vec3 figure = sample.q_SB * figure_axis_B(stage);
  const Vec3& up = stage.motion.model().up_S;
  const Vec3 axis = figure.dot(up) < 0.0 ? Vec3(-up) : up;
  add_cone(stage,
           sample,
           axis,
           angle_between(axis, figure),
           kPrecessionSlant * stage.scale.body,
           shell(stage.theme.precession_cone, 0.20f),
           marks);
}

void add_stand(const Stage& stage, const Sample&, Marks& marks) {
  const Vec3& up = stage.motion.model().up_S;
  const double size = stage.scale.body;
  Placement place = Placement::Identity();
  place.translation() = -kStandHeight * size * up;
  place.linear() = Quat::FromTwoVectors(Vec3::UnitZ(), up).toRotationMatrix() *
                   (size * Vec3(kStandRadius, kStandRadius, kStandHeight)).asDiagonal();
  marks.meshes.push_back({stage.stand, place, plain(stage.theme.stand, 0.3f)});
  // corners around the foot
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0})
      marks.reach.push_back(place * Vec3(x, y, 0.0));
  }
}

// V + Omega x r (notes, section 0.1) at points of the body
void add_velocity_field(const Stage& stage, const Sample& sample, Marks& marks) {
  const Model& model = stage.motion.model();
  for (const Vec3& r_B : stage.field_points_B) {
    const Vec3 from = point_position(model, sample, r_B);
    const Vec3 along = stage.scale.velocity * point_velocity(model, sample, r_B);
    add_vector(stage, from, from + along, kFieldShape, plain(stage.theme.velocity, 0.2f), marks);
  }
}

// forces at the points where they act; springs as thin rods to where they are held
void add_forces(const Stage& stage, const Sample& sample, Marks& marks) {
  const Model& model = stage.motion.model();
  const Quat q_SP = sample.q_SB * Quat(model.R_BP);
  const Material material = plain(stage.theme.force, 0.25f);
  for (const Load& load : model.loads.listed) {
    const Vec3 at = sample.reference_S + q_SP * load.at_P;
    const Vec3 force = stage.scale.force * point_force(load, sample.t, q_SP, sample.reference_S);
    if (load.kind == Load::Kind::spring) {
      marks.rods.push_back({at, load.anchor_S, 0.012 * stage.scale.body, material});
    } else if (force.squaredNorm() > 0.0) {
      add_vector(stage, at, at + force, kMomentumShape, material, marks, "<b>F</b>");
    }
    if (load.kind == Load::Kind::couple) {
      const Vec3 opposite = at - q_SP * load.arm_P;
      add_vector(stage, opposite, opposite - force, kMomentumShape, material, marks);
    }
  }
}

// points spread over the body: each the farthest from those before it
std::vector<Vec3> spread(const std::vector<Vec3>& points, std::size_t count) {
  std::vector<Vec3> chosen;
  if (points.empty()) return chosen;
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
  std::size_t next = 0;
  while (chosen.size() < std::min(count, points.size())) {
    chosen.push_back(points[next]);
    for (std::size_t i = 0; i < points.size(); ++i)
      nearest[i] = std::min(nearest[i], (points[i] - chosen.back()).squaredNorm());
    next = static_cast<std::size_t>(std::max_element(nearest.begin(), nearest.end()) -
                                    nearest.begin());
    if (nearest[next] == 0.0) break;
  }
  return chosen;
}

// the longest vector of the film has the full length; a body at rest has none to scale
Scale make_scale(const Stage& stage, double radius) {
  const Model& model = stage.motion.model();
  double turning = 0.0, momentum = 0.0, speed = 0.0, force = 0.0;
  for (const double t : framing_times(stage.motion)) {
    const Sample sample = stage.motion.at(t);
    for (const Load& load : model.loads.listed) {
      const Quat q_SP = sample.q_SB * Quat(model.R_BP);
      force = std::max(force, point_force(load, t, q_SP, sample.reference_S).norm());
    }
    turning = std::max(turning, sample.w_S.norm());
    momentum = std::max(momentum, sample.L_S.norm());
    for (const Vec3& r_B : stage.field_points_B)
      speed = std::max(speed, point_velocity(model, sample, r_B).norm());
  }
  const auto per = [&](double length, double most) {
    return most > 0.0 ? length * radius / most : 0.0;
  };
  return {radius,
          per(kOmegaLength, turning),
          per(kMomentumLength, momentum),
          per(kVelocityLength, speed),
          per(kForceLength, force)};
}

// conditions that several elements share
bool always(const Stage&) {
  return true;
}
bool never(const Stage&) {
  return false;
}
bool on_pivot(const Stage& stage) {
  return stage.motion.model().on_pivot;
}
std::string nothing_against(const Stage&) {
  return {};
}
bool has_forces(const Stage& stage) {
  const std::vector<Load>& listed = stage.motion.model().loads.listed;
  return std::any_of(listed.begin(), listed.end(), [](const Load& load) {
    return load.kind == Load::Kind::force || load.kind == Load::Kind::couple ||
           load.kind == Load::Kind::spring;
  });
}
std::string needs_forces(const Stage& stage) {
  return has_forces(stage) ? "" : "needs a force, a couple or a spring in motion.torque";
}
std::string needs_cones(const Stage& stage) {
  return has_cones(stage) ? "" : "the space and body cones need a free symmetric top that wobbles";
}
std::string needs_pivot(const Stage& stage) {
  return on_pivot(stage) ? "" : "needs a body on a pivot (motion.hold = \"pivot\")";
}

}  // namespace

std::vector<double> framing_times(const Motion& motion) {
  std::vector<double> times;
  for (int i = 0; i <= kFramingTimes; ++i)
    times.push_back(motion.duration() * i / kFramingTimes);
  return times;
}

Stage make_stage(const Motion& motion,
                 const BodySpec& body,
                 const ThemeSpec& theme_spec,
                 const ShowSpec& show,
                 int segments) {
  const Theme theme = make_theme(theme_spec);
  Stage stage{motion,
              theme,
              body_look(body, motion.model(), theme, segments),
              {},
              {},
              std::make_shared<const Mesh>(unit_sphere(std::max(16, segments / 4))),
              std::make_shared<const Mesh>(unit_cone(segments)),
              show.body_opacity,
              show.points,
              {}};
  stage.hull_B = hull_of(stage.look);
  stage.field_points_B = spread(stage.hull_B, kFieldPoints);
  double radius = body_radius(stage.look, motion.model());
  for (const Vec3& point : show.points)
    radius = std::max(radius, (point - motion.model().reference_B()).norm());
  stage.scale = make_scale(stage, radius);
  return stage;
}

Vec3 omega_tip(const Stage& stage, const Sample& sample) {
  return sample.reference_S + stage.scale.omega * sample.w_S;
}

Vec3 momentum_tip(const Stage& stage, const Sample& sample) {
  return sample.reference_S + stage.scale.momentum * sample.L_S;
}

void add_points(const Stage& stage, const Sample& sample, bool from_origin, Marks& marks) {
  const Material material = plain(stage.theme.position, 0.3f);
  for (const Vec3& r_B : stage.points_B) {
    const Vec3 at = point_position(stage.motion.model(), sample, r_B);
    Placement place = Placement::Identity();
    place.translation() = at;
    place.linear() *= kBallRadius * stage.scale.body;
    marks.meshes.push_back({stage.ball, place, material});
    for (int i = 0; i < 3; ++i) {
      marks.reach.push_back(place * Vec3::Unit(i));
      marks.reach.push_back(place * Vec3(-Vec3::Unit(i)));
    }
    add_vector(stage, sample.reference_S, at, kAxisShape, material, marks, "<b>r</b>");
    if (from_origin) add_vector(stage, Vec3::Zero(), at, kAxisShape, material, marks);
  }
}

const std::vector<Element>& elements() {
  static const std::vector<Element> table = {
      {"body", "the body", always, nothing_against, add_body},
      {"axes", "body axes", never, nothing_against, add_body_axes},
      {"space_axes",
       "space axes, from the reference point",
       always,
       nothing_against,
       [](const Stage& stage, const Sample& sample, Marks& marks) {
         add_axes_at(stage, sample.reference_S, marks);
       }},
      {"omega",
       "angular velocity",
       always,
       nothing_against,
       [](const Stage& stage, const Sample& sample, Marks& marks) {
         add_vector(stage,
                    sample.reference_S,
                    omega_tip(stage, sample),
                    kOmegaShape,
                    plain(stage.theme.omega, 0.25f),
                    marks,
                    kOmegaName);
       }},
      {"momentum",
       "angular momentum",
       always,
       nothing_against,
       [](const Stage& stage, const Sample& sample, Marks& marks) {
         add_vector(stage,
                    sample.reference_S,
                    momentum_tip(stage, sample),
                    kMomentumShape,
                    plain(stage.theme.momentum, 0.25f),
                    marks,
                    kMomentumName);
       }},
      {"space_cone",
       "the cone that omega draws in space (symmetric free top)",
       has_cones,
       needs_cones,
       add_space_cone},
      {"body_cone",
       "the cone that omega draws in the body (symmetric free top)",
       has_cones,
       needs_cones,
       add_body_cone},
      {"precession_cone",
       "the cone about the vertical through the body axis (pivot)",
       on_pivot,
       needs_pivot,
       add_precession_cone},
      {"pivot",
       "the stand under the fixed point",
       [](const Stage& stage) { return on_pivot(stage) && stays_above_stand(stage); },
       needs_pivot,
       add_stand},
      {"forces",
       "the forces of motion.torque where they act, springs as rods",
       has_forces,
       needs_forces,
       add_forces},
      {"velocity_field",
       "velocities V + Omega x r of points of the body, as small arrows",
       never,
       nothing_against,
       add_velocity_field},
      {"fixed_frame",
       "space axes at the origin of space, and R from there to the reference point",
       never,
       nothing_against,
       add_fixed_frame},
      {"angles",
       "the angle between each space axis and its body axis, as an arc",
       never,
       nothing_against,
       add_angles},
  };
  return table;
}

std::vector<ShowName> show_names() {
  std::vector<ShowName> names;
  for (const Element& element : elements())
    names.push_back({element.name, element.doc});
  return names;
}

}  // namespace polhode
