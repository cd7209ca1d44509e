// SPDX-License-Identifier: MIT
#include "export/observer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.h"
#include "base/system/interrupt.h"
#include "frame/shadow.h"
#include "math/so3.h"

namespace polhode {
namespace {

constexpr double kSmallestSize = 1e-300;   // what divides must not be zero
constexpr double kTubeStep = 0.1;          // of the logarithm of a tube in its ring
constexpr std::size_t kMostKept = 50'000;  // times; more are computed again

// an affine map as turn and factors along the axes of the mesh
Pose pose_of(const Placement& place) {
  Pose pose;
  pose.at = place.translation();
  const Mat3 linear = place.linear();
  Mat3 turn;
  for (int i = 0; i < 3; ++i) {
    pose.size[i] = linear.col(i).norm();
    turn.col(i) = linear.col(i) / std::max(pose.size[i], kSmallestSize);
  }
  pose.turn = Quat(turn).normalized();
  return pose;
}

Pose standing_pose(const Vec3& from, const Vec3& along, const Vec3& size) {
  Pose pose;
  pose.at = from;
  pose.turn = turn_between(Vec3::UnitZ(), along);
  pose.size = size;
  return pose;
}

void measure(Thing& thing) {
  if (!thing.mesh || thing.mesh->vertices.empty()) return;
  thing.low = thing.high = to_eigen(thing.mesh->vertices.front().position);
  for (const Vertex& vertex : thing.mesh->vertices) {
    thing.low = thing.low.cwiseMin(to_eigen(vertex.position));
    thing.high = thing.high.cwiseMax(to_eigen(vertex.position));
  }
}

Vec3 box_size(const Mesh& mesh) {
  Thing thing;
  thing.mesh = std::make_shared<const Mesh>(mesh);
  measure(thing);
  return thing.high - thing.low;
}

// points of a thing in its own coordinates before its size, that move as far as any
std::vector<Vec3> points_of(const Thing& thing) {
  std::vector<Vec3> points;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 point;
    for (int i = 0; i < 3; ++i)
      point[i] = (corner >> i & 1) != 0 ? thing.high[i] : thing.low[i];
    points.push_back(point);
  }
  return points;
}

Vec3 axis_of(const Pose& pose) {
  return pose.turn * Vec3::UnitZ();
}

// Does a round thing look the same upside down? A ring does, and a cone that is flat.
bool is_flat(const Thing& thing, const Pose& pose) {
  if (thing.kind != ThingKind::mesh) return false;
  if (thing.low.z() == -thing.high.z()) return true;
  return std::abs(thing.high.z() * pose.size.z()) < 1e-4 * thing.high.x() * pose.size.x();
}

// of a thing that is round about z: how far from `at` it reaches
double reach_of(const Thing& thing, const Pose& pose) {
  if (thing.kind != ThingKind::mesh) return pose.size.z();
  const Vec3 far = thing.high.cwiseAbs().cwiseMax(thing.low.cwiseAbs()).cwiseProduct(pose.size);
  return far.maxCoeff();
}

// what is no element of the table
constexpr const char *kPoints = "points", *kTrails = "trails";

const Element& find_element(const std::string& name) {
  const std::vector<Element>& all = elements();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Element& one) { return one.name == name; });
  CHECK(found != all.end());
  return *found;
}

double distance_of_arcs(const Pose& a, const Pose& b) {
  double most = 0.0;
  for (const double part : {0.0, 0.5, 1.0}) {
    const auto point = [&](const Pose& pose) {
      const double angle = part * pose.size.z();
      return Vec3(pose.at +
                  pose.size.x() * (pose.turn * Vec3(std::cos(angle), std::sin(angle), 0.0)));
    };
    most = std::max(most, (point(a) - point(b)).norm());
  }
  return most;
}

}  // namespace

Observer::Observer(const Composer& composer, int segments)
    : composer_(composer),
      segments_(segments),
      shell_(std::make_shared<const Mesh>(unit_cone_shell(segments))),
      floor_(floor_mesh({})) {}

std::size_t Observer::index_of(const std::string& key, const Thing& thing) {
  const auto [found, added] = indices_.emplace(key, things_.size());
  if (added) {
    Together& together = of_element_[thing.element];
    places_.emplace_back(&together, together.things.size());
    together.things.push_back(things_.size());
    things_.push_back(thing);
    measure(things_.back());
  }
  return found->second;
}

void Observer::put(std::size_t index, const Pose& pose, std::vector<Pose>& poses) const {
  if (poses.size() <= index) poses.resize(things_.size());
  poses[index] = pose;
}

void Observer::add_paths(const std::string& element, const std::vector<PathGlyph>& paths) {
  for (const PathGlyph& path : paths) {
    of_element_[element];  // it has been seen, though it has no thing
    const auto found = std::find_if(
        trails_.begin(), trails_.end(), [&](const auto& one) { return one.trail == path.trail; });
    ObservedTrail& trail = found != trails_.end()
                               ? *found
                               : trails_.emplace_back(ObservedTrail{
                                     element, path.trail, path.material, 0.0, path.on_body});
    trail.length = std::max(trail.length, path.to - path.from);
  }
}

// Glyphs with the same mesh are told apart by their number, counted from the last: of ghosts, that
// is the latest. A mesh that nobody else has was made for this moment, as a spring is: the one that
// was seen first is then stretched to the box of each later one.
void Observer::add_meshes(const std::string& element,
                          const char* kind,
                          const std::vector<MeshGlyph>& glyphs,
                          bool both_sides,
                          std::vector<Pose>& poses) {
  std::map<const Mesh*, int> counts;
  for (auto glyph = glyphs.rbegin(); glyph != glyphs.rend(); ++glyph) {
    const bool made_anew = glyph->mesh.use_count() == 1;
    const Mesh* mesh = made_anew ? nullptr : glyph->mesh.get();
    const std::string key =
        fmt::format("{} {} {} {}", element, kind, static_cast<const void*>(mesh), counts[mesh]++);
    Thing thing;
    thing.element = element;
    thing.mesh = glyph->mesh;
    thing.material = glyph->material;
    thing.both_sides = both_sides;
    thing.round =
        mesh != nullptr &&
        (mesh == composer_.scenery().ring.get() || mesh == composer_.scenery().gimbal.get() ||
         mesh == composer_.scenery().disc.get() || mesh == composer_.scenery().ball.get());
    const std::size_t index = index_of(key, thing);
    Pose pose = pose_of(glyph->space_from_mesh);
    if (made_anew) {
      const Vec3 first = things_[index].high - things_[index].low;
      pose.size = pose.size.cwiseProduct(
          box_size(*glyph->mesh).cwiseQuotient(first.cwiseMax(kSmallestSize)));
    }
    put(index, pose, poses);
  }
}

void Observer::add_cones(const std::string& element,
                         const std::vector<Cone>& cones,
                         std::vector<Pose>& poses) {
  for (std::size_t i = 0; i < cones.size(); ++i) {
    const ConePlaces places = cone_places(cones[i]);
    Thing thing;
    thing.element = element;
    thing.round = true;
    thing.material = cones[i].material;
    thing.mesh = shell_;
    thing.both_sides = true;
    put(index_of(fmt::format("{} shell {}", element, i), thing), pose_of(places.shell), poses);
    // A ring grows with its cone and its tube does not: rings of other tubes take turns.
    const std::string name = fmt::format("{} rim {}", element, i);
    const double first = tubes_.emplace(name, places.tube).first->second;
    const auto step = std::lround(std::log(places.tube / first) / kTubeStep);
    const std::string key = fmt::format("{} {}", name, step);
    if (indices_.count(key) == 0) {
      const double tube = first * std::exp(kTubeStep * static_cast<double>(step));
      thing.mesh = std::make_shared<const Mesh>(torus(1.0, tube, segments_));
    }
    thing.material.alpha = 1.0f;
    thing.both_sides = false;
    put(index_of(key, thing), pose_of(places.rim), poses);
  }
}

void Observer::add_lines(const std::string& element,
                         const Glyphs& glyphs,
                         std::vector<Pose>& poses) {
  const auto add = [&](ThingKind kind,
                       std::size_t i,
                       const Material& material,
                       const auto& pose,
                       const ArrowShape& shape = {}) {
    Thing thing;
    thing.element = element;
    thing.kind = kind;
    thing.round = kind != ThingKind::arc;
    thing.material = material;
    thing.shape = shape;
    const std::string key = fmt::format("{} line {} {}", element, static_cast<int>(kind), i);
    put(index_of(key, thing), pose, poses);
  };
  for (std::size_t i = 0; i < glyphs.arrows.size(); ++i) {
    const ArrowGlyph& arrow = glyphs.arrows[i];
    const Vec3 along = arrow.tip - arrow.from;
    const double length = along.norm();
    Pose pose;
    if (arrow_places(arrow.from, arrow.tip, arrow.shape)) {
      const double shrink = fitting(arrow.shape, length).head_length / arrow.shape.head_length;
      pose = standing_pose(arrow.from, along, {shrink, shrink, length});
    }
    add(ThingKind::arrow, i, arrow.material, pose, arrow.shape);
  }
  for (std::size_t i = 0; i < glyphs.rods.size(); ++i) {
    const RodGlyph& rod = glyphs.rods[i];
    const Vec3 along = rod.to - rod.from;
    const double length = along.norm();
    Pose pose;
    if (length > 0.0) pose = standing_pose(rod.from, along, {rod.radius, rod.radius, length});
    add(ThingKind::rod, i, rod.material, pose);
  }
  for (std::size_t i = 0; i < glyphs.arcs.size(); ++i) {
    const ArcGlyph& arc = glyphs.arcs[i];
    Mat3 axes;
    axes.col(0) = arc.from;
    axes.col(1) = (arc.to - arc.to.dot(arc.from) * arc.from).normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    Pose pose;
    pose.at = arc.center;
    pose.turn = Quat(axes).normalized();
    pose.size = {arc.radius, arc.tube_radius, angle_between(arc.from, arc.to)};
    add(ThingKind::arc, i, arc.material, pose);
  }
}

void Observer::add_labels(const std::string& element,
                          const Glyphs& glyphs,
                          std::vector<Pose>& poses) {
  std::map<std::string, int> counts;
  for (const LabelGlyph& label : glyphs.labels) {
    Thing thing;
    thing.element = element;
    thing.kind = ThingKind::label;
    thing.round = true;
    thing.label = label;
    const std::string key =
        fmt::format("{} label {} {}", element, counts[label.markup]++, label.markup);
    const Vec3 away = label.away.norm() > 0.0 ? label.away : Vec3(Vec3::UnitZ());
    put(index_of(key, thing), standing_pose(label.at, away, Vec3::Ones()), poses);
  }
}

void Observer::add_glyphs(const std::string& element,
                          const Glyphs& glyphs,
                          std::vector<Pose>& poses) {
  add_paths(element, glyphs.paths);
  add_meshes(element, "solid", glyphs.meshes, false, poses);
  add_meshes(element, "ghost", glyphs.ghosts, true, poses);
  add_meshes(element, "shell", glyphs.shells, true, poses);
  std::vector<MeshGlyph> sheets, floors;
  for (const SheetGlyph& sheet : glyphs.sheets)
    sheets.push_back(sheet.mesh);
  for (const FloorGlyph& floor : glyphs.floors) {
    floors.push_back({floor_, floor.place, floor.material});
    if (floor.dial.mesh != nullptr) floors.push_back(floor.dial);
  }
  add_meshes(element, "sheet", sheets, true, poses);
  add_meshes(element, "floor", floors, false, poses);
  add_cones(element, glyphs.cones, poses);
  add_lines(element, glyphs, poses);
  add_labels(element, glyphs, poses);
}

const Sample& Observer::sample_at(double t) {
  const auto kept = samples_.find(t);
  if (kept != samples_.end()) return kept->second;
  if (samples_.size() >= kMostKept) samples_.clear();
  return samples_.emplace(t, composer_.scenery().motion.at(t)).first->second;
}

void Observer::look_at(const std::string& name, double t, std::vector<Pose>& poses) {
  const Scenery& scenery = composer_.scenery();
  const Sample& sample = sample_at(t);
  Glyphs glyphs;
  if (name == kPoints) {
    add_points(scenery, sample, composer_.shows("fixed_frame"), glyphs);
  } else if (name == kTrails) {
    add_point_trails(scenery, sample, glyphs);
    add_tip_trails(scenery, sample, glyphs);
  } else {
    find_element(name).add(scenery, sample, glyphs);
  }
  add_glyphs(name, glyphs, poses);
}

const std::vector<Pose>& Observer::at(double t) {
  const auto kept = moments_.find(t);
  if (kept != moments_.end()) return kept->second;
  stop_if_interrupted();
  std::vector<Pose> poses(things_.size());
  for (const Element& element : elements()) {
    if (composer_.shows(element.name)) look_at(element.name, t, poses);
  }
  look_at(kPoints, t, poses);
  look_at(kTrails, t, poses);
  return moments_.emplace(t, std::move(poses)).first->second;
}

// most times are looked at for the sake of one thing, and the rest of the picture is not needed
Pose Observer::pose(std::size_t thing, double t) {
  stop_if_interrupted();
  const auto whole = moments_.find(t);
  if (whole != moments_.end()) return thing < whole->second.size() ? whole->second[thing] : Pose{};
  const auto [together, place] = places_[thing];
  if (together->seen.size() >= kMostKept) together->seen.clear();
  const auto [kept, added] = together->seen.try_emplace(t);
  if (added) {
    std::vector<Pose> poses(things_.size());
    look_at(std::string(things_[thing].element), t, poses);
    // what has not been seen yet may come now
    for (const Element& element : elements()) {
      if (composer_.shows(element.name) && of_element_.count(element.name) == 0)
        look_at(element.name, t, poses);
    }
    for (const std::size_t i : together->things)
      kept->second.push_back(i < poses.size() ? poses[i] : Pose{});
  }
  return place < kept->second.size() ? kept->second[place] : Pose{};
}

Vec3 nearer_axis(const Thing& thing, const Pose& a, const Pose& b) {
  const Vec3 axis = axis_of(b);
  const bool turned = axis.dot(axis_of(a)) < 0.0 && is_flat(thing, a) && is_flat(thing, b);
  return turned ? Vec3(-axis) : axis;
}

Pose between(const Thing& thing, const Pose& a, const Pose& b, double part) {
  Pose pose;
  pose.at = a.at + part * (b.at - a.at);
  pose.size = a.size + part * (b.size - a.size);
  if (thing.round) {
    const Quat turn = turn_between(axis_of(a), nearer_axis(thing, a, b));
    pose.turn = Quat::Identity().slerp(part, turn) * a.turn;
  } else {
    pose.turn = a.turn.slerp(part, b.turn);
  }
  return pose;
}

double distance(const Thing& thing, const Pose& a, const Pose& b) {
  if (thing.kind == ThingKind::label) return (a.at - b.at).norm();
  if (thing.kind == ThingKind::arc) return distance_of_arcs(a, b);
  if (thing.round) {
    const double other = thing.kind == ThingKind::mesh ? 0.0 : std::abs(a.size.z() - b.size.z());
    const double tips = (a.at + reach_of(thing, a) * axis_of(a) - b.at -
                         reach_of(thing, b) * nearer_axis(thing, a, b))
                            .norm();
    return std::max({(a.at - b.at).norm(), tips, other});
  }
  double most = 0.0;
  for (const Vec3& point : points_of(thing)) {
    const Vec3 apart =
        a.at + a.turn * a.size.cwiseProduct(point) - b.at - b.turn * b.size.cwiseProduct(point);
    most = std::max(most, apart.norm());
  }
  return most;
}

}  // namespace polhode
