// SPDX-License-Identifier: MIT
#include "frame/scenery.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "frame/stand.h"
#include "math/so3.h"
#include "motion/deviation.h"

namespace polhode {
namespace {

constexpr int kDialSegments = 72;
constexpr double kDialPixels =
    2.4;  // half the width of its lines, where the dial fills the picture
constexpr double kLongestVector = 50.0;  // drawn, in units of the body's radius
// lengths of the longest vectors of a film, in units of the body's radius
constexpr double kOmegaLength = 1.3;
constexpr double kMomentumLength = kReachOfVectors;
constexpr double kVelocityLength = 0.6;
constexpr double kSlipLength = 2.0;  // from below a body it is seen

constexpr int kRoughSegments = 24;     // of meshes that throw shadows
constexpr double kGimbalTube = 0.017;  // radius of the tube of a gimbal ring, in that of the ring

constexpr std::size_t kFineTriangles = 4000;  // a mesh with more throws the shadow of a rough one
constexpr int kRoughCells = 40;

constexpr int kFramingTimes = 480;
constexpr std::size_t kFieldPoints = 48;

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

MeshPtr rough(const MeshPtr& mesh) {
  if (mesh->indices.size() <= 3 * kFineTriangles) return mesh;
  return std::make_shared<const Mesh>(clustered(*mesh, kRoughCells));
}

// Of a satellite: it leaves the body.
constexpr double kOrbitLength = 1.5;

// The weight ends above the floor, unless it would become too short. In units of the body's radius,
// like `lowest`: how far the centre of mass stays above the pivot.
double weight_length(double lowest, double stand_height) {
  const double above_floor = 0.95 * (lowest + stand_height);
  return above_floor > 0.5 * kForceLength ? std::min(kForceLength, above_floor) : kForceLength;
}

// the longest vector of the film has the full length; a body at rest has none to scale
Scale make_scale(const Scenery& scenery, double radius) {
  const BodyModel& model = scenery.motion.model();
  double turning = 0.0, momentum = 0.0, speed = 0.0, force = 0.0, turned_by = 0.0, slip = 0.0;
  double lowest = std::numeric_limits<double>::infinity();  // centre of mass above the pivot
  for (const double t : framing_times(scenery.motion)) {
    const Sample sample = scenery.motion.at(t);
    for (const Load& load : model.loads.listed) {
      const Quat q_SP = sample.q_SB * Quat(model.R_BP);
      force = std::max(force, point_force(load, t, q_SP, sample.reference_S).norm());
    }
    // what a table bears for an instant would make all other forces short
    const double weight = model.body.mass * model.gravity_S.norm();
    const double most = model.table ? 3.0 * weight * radius : HUGE_VAL;
    if (const std::optional<Vec3> torque_S = torque_at(scenery.motion, t))
      turned_by = std::max(turned_by, std::min(torque_S->norm(), most));
    if (const std::optional<Reaction> found = reaction_at(scenery.motion, t)) {
      force = std::max(force, std::min(found->normal, 3.0 * weight));
      slip = std::max(slip, found->slip_S.norm());
    }
    lowest = std::min(lowest, (sample.center_S - sample.reference_S).dot(model.up_S));
    turning = std::max(turning, sample.w_S.norm());
    momentum = std::max(momentum, sample.L_S.norm());
    for (const Vec3& r_B : scenery.field_points_B)
      speed = std::max(speed, point_velocity(model, sample, r_B).norm());
  }
  const auto per = [&](double length, double most) {
    return most > 0.0 ? length * radius / most : 0.0;
  };
  // what does not turn the body in the whole film is rounding errors of a body at rest
  constexpr double kNoTurn = 1e-9;  // rad
  const double duration = scenery.motion.duration(), inertia = model.moments.maxCoeff();
  if (turning * duration < kNoTurn) turning = 0.0;
  if (momentum / inertia * duration < kNoTurn) momentum = 0.0;
  if (turned_by / inertia * duration * duration < kNoTurn) turned_by = 0.0;
  // so is a slip that is tiny beside the speed of a fall from the height of the body
  constexpr double kNoSlip = 1e-9;
  if (slip < kNoSlip * std::sqrt(model.gravity_S.norm() * radius)) slip = 0.0;
  const double longer = scenery.options.vector_length.value_or(1.0);
  const double omega_scale = per(longer * kOmegaLength, turning);
  double momentum_scale = per(longer * kMomentumLength, momentum);
  // L ends on the invariable plane, through which its head would hardly be seen
  if (asks_for(scenery, "plane") && momentum > 0.0) {
    const Sample start = scenery.motion.at(0.0);
    momentum_scale = omega_scale * start.w_S.dot(start.L_S) / start.L_S.squaredNorm();
  }
  return {radius,
          omega_scale,
          momentum_scale,
          per(kVelocityLength, speed),
          per(kForceLength, force),
          per(longer * kForceLength, turned_by),
          (model.on_pivot ? weight_length(lowest / radius, scenery.stand_height) : kOrbitLength) *
              radius,
          per(kSlipLength, slip)};
}

// the box around all places that a body goes to on its table; about the axis of a turntable, unless
// it is farther from the middle of them than the body goes
void measure_table(Scenery& scenery) {
  if (!scenery.motion.model().table) return;
  Vec3 low = scenery.motion.at(0.0).center_S, high = low;
  double farthest = 0.0;  // from the axis of a turntable
  for (const double t : framing_times(scenery.motion)) {
    const Vec3 center = scenery.motion.at(t).center_S;
    low = low.cwiseMin(center);
    high = high.cwiseMax(center);
    farthest = std::max(farthest, center.head<2>().norm());
  }
  scenery.table_middle = 0.5 * (low + high);
  scenery.table_middle.z() = 0.0;
  scenery.table_reach = 0.5 * (high - low).head<2>().norm();
  if (scenery.motion.model().table->friction.turntable != 0.0 &&
      scenery.table_middle.norm() < scenery.table_reach) {
    scenery.table_middle = Vec3::Zero();
    scenery.table_reach = farthest;
  }
}

// high enough for a body of this radius (m) to swing clear of the floor, in units of it
double stand_height(const Scenery& scenery, double radius) {
  constexpr double kClear = 0.06;
  const BodyModel& model = scenery.motion.model();
  if (!model.on_pivot || asks_for(scenery, "gimbals")) return kStandHeight;
  double lowest = 0.0;
  for (const double t : framing_times(scenery.motion)) {
    const Vec3 up_B = scenery.motion.at(t).q_SB.conjugate() * model.up_S;
    for (const Vec3& point_B : scenery.hull_B)
      lowest = std::min(lowest, (point_B - model.reference_B()).dot(up_B));
  }
  return std::max(kStandHeight, kClear - lowest / radius);
}

// A head on the shaft of a vector would be a collar.
double axis_length(const Scenery& scenery, int axis) {
  constexpr double kAlong = 0.05;   // rad
  constexpr double kBeyond = 0.34;  // of the body's radius; more than a head
  const auto is_hidden = [&](const char* vector) {
    const auto asked = scenery.options.asked.find(vector);
    return asked != scenery.options.asked.end() && !asked->second.value_or(true);
  };
  double longest = 0.0;  // of those along it, m
  const auto look_along = [&](const char* vector, const auto& tip) {
    if (is_hidden(vector)) return;
    double reach = 0.0;
    for (const double t : framing_times(scenery.motion)) {
      const Sample now = scenery.motion.at(t);
      const Vec3 drawn = tip(scenery, now) - now.reference_S;
      if (drawn.norm() > 0.0 && angle_between(drawn, Vec3::Unit(axis)) > kAlong) return;
      reach = std::max(reach, drawn.norm());
    }
    longest = std::max(longest, reach);
  };
  look_along("omega", omega_tip);
  look_along("momentum", momentum_tip);
  if (longest == 0.0) return kSpaceAxisLength;
  return std::max(kSpaceAxisLength, longest / scenery.scale.body + kBeyond);
}

}  // namespace

bool asks_for(const Scenery& scenery, const std::string& element) {
  const auto found = scenery.options.asked.find(element);
  return found != scenery.options.asked.end() && found->second.value_or(false);
}

double drawn_length(const Scenery& scenery, double length) {
  return std::min(length, kLongestVector * scenery.scale.body);
}

Vec3 drawn_tip(const Scenery& scenery, const Vec3& from, const Vec3& end) {
  const double length = (end - from).norm();
  const double drawn = drawn_length(scenery, length);
  return drawn < length ? Vec3(from + (end - from) * (drawn / length)) : end;
}

std::vector<double> framing_times(const Motion& motion) {
  const double duration = motion.duration();
  std::vector<double> times = scattered_times(duration, kFramingTimes);
  const std::vector<double> more = times_after_switches(motion.model().loads.switches, duration);
  times.insert(times.end(), more.begin(), more.end());
  std::sort(times.begin(), times.end());
  return times;
}

double fastest_turn(const Motion& motion) {
  double fastest = 0.0;
  for (const double t : framing_times(motion))
    fastest = std::max(fastest, motion.at(t).w_B.norm());
  return fastest;
}

void make_look(Scenery& scenery, const BodySpec& body, int segments) {
  scenery.look = body_look(body, scenery.motion.model(), scenery.theme, segments);
  for (LookPart& part : scenery.look) {
    part.material.finish = finish_named(scenery.options.material);
  }
  const std::vector<LookPart> coarse =
      body_look(body, scenery.motion.model(), scenery.theme, std::min(segments, kRoughSegments));
  for (std::size_t i = 0; i < coarse.size(); ++i)
    scenery.look[i].rough = rough(coarse[i].mesh);
}

Scenery make_scenery(const Motion& motion,
                     const BodySpec& body,
                     const ThemeSpec& theme_spec,
                     const ShowSpec& show,
                     int segments,
                     const std::optional<Scale>& scale) {
  const Theme theme = make_theme(theme_spec);
  const auto shared = [](Mesh mesh) {
    return std::make_shared<const Mesh>(std::move(mesh));
  };
  Scenery scenery{motion, theme};
  scenery.options = show;
  scenery.segments = scenery.body_segments = segments;
  make_look(scenery, body, segments);
  scenery.ball = shared(unit_sphere(std::max(16, segments / 4)));
  // what surrounds the body may be as large as the frame, and bends in two directions
  const int large = segments * 3 / 2;
  scenery.sphere = shared(unit_sphere(large));
  scenery.gimbal = shared(torus(1.0, kGimbalTube, large));
  scenery.rough_gimbal = shared(torus(1.0, kGimbalTube, kRoughSegments));
  scenery.disc = shared(unit_disc(large));
  // lines thinner than pixels would be dashed; `segments` are those of a circle of this radius
  const double pixels = std::pow(segments / kPi, 2);
  scenery.dial_line = std::max(kDialLine, kDialPixels / pixels);
  scenery.dial = shared(dial(kDialSegments, scenery.dial_line));
  scenery.ring = shared(torus(1.0, 0.006, large));
  scenery.hull_B = hull_of(scenery.look);
  scenery.field_points_B = spread(scenery.hull_B, kFieldPoints);
  double radius = body_radius(scenery.look, motion.model());
  for (const std::vector<Vec3>* points : {&show.points, &show.trail_points}) {
    for (const Vec3& point : *points)
      radius = std::max(radius, (point - motion.model().reference_B()).norm());
  }
  scenery.stand_height = stand_height(scenery, scale ? scale->body : radius);
  scenery.scale = scale ? *scale : make_scale(scenery, radius);
  scenery.stand = shared(stand_mesh(scenery.stand_height, segments));
  scenery.rough_stand = shared(stand_mesh(scenery.stand_height, kRoughSegments));
  measure_table(scenery);
  for (const int axis : {0, 1, 2})
    scenery.axis_lengths[static_cast<std::size_t>(axis)] = axis_length(scenery, axis);
  scenery.paths = make_paths(scenery);
  return scenery;
}

Scale common_scale(const std::vector<Scale>& scales) {
  Scale common = scales.front();
  for (const Scale& one : scales) {
    common.body = std::max(common.body, one.body);
    common.weight = std::max(common.weight, one.weight);
  }
  // a quantity that one picture does not have says nothing
  const auto least = [&](double Scale::*member) {
    double found = 0.0;
    for (const Scale& one : scales) {
      const double here = one.*member * common.body / one.body;
      if (here > 0.0 && (found == 0.0 || here < found)) found = here;
    }
    common.*member = found;
  };
  for (const auto member : {&Scale::slip,
                            &Scale::omega,
                            &Scale::momentum,
                            &Scale::velocity,
                            &Scale::force,
                            &Scale::torque})
    least(member);
  return common;
}

Vec3 omega_tip(const Scenery& scenery, const Sample& sample) {
  return drawn_tip(
      scenery, sample.reference_S, sample.reference_S + scenery.scale.omega * sample.w_S);
}

Vec3 momentum_tip(const Scenery& scenery, const Sample& sample) {
  return drawn_tip(
      scenery, sample.reference_S, sample.reference_S + scenery.scale.momentum * sample.L_S);
}

}  // namespace polhode
