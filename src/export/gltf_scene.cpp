// SPDX-License-Identifier: MIT
#include "export/gltf_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>

#include "base/error.h"
#include "base/version.h"
#include "export/gltf_looks.h"
#include "export/gltf_tracks.h"
#include "film/frame_times.h"
#include "film/stage.h"
#include "math/so3.h"
#include "model/figure_axis.h"

namespace polhode {
namespace {

using nlohmann::json;

constexpr double kPictureHeight = 1080.0;  // in which pixels of accuracy are counted
constexpr int kAroundTube = 20;            // pieces of a circle of shafts and rods
constexpr int kAroundHead = 36;            // of heads of arrows
constexpr int kPiecesOfArc = 32;
constexpr std::size_t kFewestPieces = 24, kMostPieces = 240, kPointsOfPiece = 6;  // of a path
constexpr double kPiecesOfTail = 8.0, kMostPiecesOfTails = 4000.0;  // of what is seen of it
constexpr double kSmallestScene = 1e-3, kLargestScene = 1e3;        // m; others are scaled to 1 m

json list_of(const Vec3& v) {
  return json::array({v.x(), v.y(), v.z()});
}

// a pose as seen from a frame that moves
Pose seen_from(const Pose& frame, const Pose& pose) {
  const Quat back = frame.turn.conjugate();
  return {back * Vec3(pose.at - frame.at), back * pose.turn, pose.size};
}

// The document while it is put together.
class Export {
 public:
  Export(const Solved& solved, const Composer& composer, const ExportPlan& plan)
      : solved_(solved),
        composer_(composer),
        plan_(plan),
        motion_(composer.scenery().motion),
        observer_(composer, composer.scenery().segments),
        origin_(motion_.at(0.0).reference_S),
        arrows_(arrow_meshes(kAroundTube, kAroundHead)) {
    clock_.from = plan.from.value_or(0.0);
    clock_.to = plan.to.value_or(motion_.duration());
    clock_.scale = solved.scene.video.time_scale;
    first_ = first_times(motion_, clock_);
    measure_pictures();
    const double size = composer.scenery().scale.body;
    report_.tolerance =
        plan.radians ? *plan.radians * size : plan.pixels / report_.pixels_per_metre;
    // single precision has seven digits
    report_.tolerance = std::max(report_.tolerance, kFinestPlayback * size);
    unit_ = size >= kSmallestScene && size <= kLargestScene ? 1.0 : 1.0 / size;
    refuse_long_table();
    for (const double played : first_)
      observer_.at(clock_.motion_time(played));
  }

  ExportedScene make() {
    add_frames();
    add_things();
    add_trails();
    add_cameras();
    // what goes with the body is rounded, and so is the camera from which players see it
    constexpr double kRounding = std::numeric_limits<float>::epsilon();
    report_.error += kRounding * (report_.farthest + 2.0 * composer_.scenery().scale.body);
    describe();
    return {std::move(document_), report_};
  }

 private:
  Pose body_frame(double t) const {
    const Sample sample = motion_.at(t);
    Pose pose;
    pose.turn = sample.q_SB;
    pose.at = sample.reference_S - sample.q_SB * motion_.model().reference_B();
    pose.size = Vec3::Ones();
    return pose;
  }

  // what stands for the body where its frame is looked at
  Thing body_thing() const {
    Thing solid;
    solid.high = Vec3::Constant(composer_.scenery().scale.body);
    solid.low = -solid.high;
    return solid;
  }

  // how large the film's cameras see what they see
  void measure_pictures() {
    const double height = solved_.scene.video.size.height;
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < first_.size(); i += 1 + first_.size() / 64) {
      const double t = clock_.motion_time(first_[i]);
      const Sample sample = motion_.at(t);
      const Camera camera = composer_.camera_at(composer_.timeline().film_time(t));
      points = {sample.reference_S};
      add_extent(composer_.glyphs_at(sample), points);
      for (const Vec3& point : points) {
        if (!camera.sees(point)) continue;
        report_.pixels_per_metre = std::max(
            report_.pixels_per_metre, camera.pixels_per_metre(point) * kPictureHeight / height);
      }
    }
    // where cameras see nothing, the body fills the picture
    if (!(report_.pixels_per_metre > 0.0))
      report_.pixels_per_metre = kPictureHeight / (2.0 * composer_.scenery().scale.body);
  }

  // Some of the intervals tell before they all are looked at.
  void refuse_long_table() {
    constexpr double kSurely = 1.1 * kMostKeys;  // few intervals err
    double keys = 0.0;
    const auto expected = [&](const Thing& thing, const auto& pose_at) {
      return expected_keys(thing, pose_at, first_, clock_, report_.tolerance, kSurely - keys);
    };
    keys += expected(body_thing(), [&](double t) { return body_frame(t); });
    Observer few(composer_, composer_.scenery().segments);
    few.at(clock_.from);
    for (std::size_t i = 0; i < few.things().size() && keys <= kSurely; ++i) {
      const Thing thing = few.things()[i];
      const double in_body =
          expected(thing, [&](double t) { return seen_from(body_frame(t), few.pose(i, t)); });
      // what moves in the body as well is written down in space
      const bool stays = in_body == 1.0;
      keys += stays ? 1.0 : expected(thing, [&](double t) { return few.pose(i, t); });
    }
    if (keys > kSurely) require_few_keys(static_cast<std::size_t>(keys));
  }

  int add_node(GltfNode node) {
    std::string name = node.name;
    for (int i = 2; !names_.insert(name).second; ++i)
      name = fmt::format("{}.{}", node.name, i);
    node.name = name;
    document_.nodes.push_back(std::move(node));
    return static_cast<int>(document_.nodes.size()) - 1;
  }

  int add_group(const std::string& name, int parent) {
    GltfNode node;
    node.name = name;
    node.parent = parent;
    return add_node(node);
  }

  void set_poses(const Thing& thing, const KeyedPoses& keys, const Vec3& from, GltfNode& node) {
    tracks_.set_poses(thing, keys, from, node);
    if (keys.still) return;
    report_.keys += keys.poses.size();
    require_few_keys(report_.keys);
    report_.error = std::max(report_.error, keys.error);
  }

  // the root, space, the body axes, and directions to look along
  void add_frames() {
    GltfNode root;
    root.name = "world";
    root.rotation = Quat(Eigen::AngleAxisd(-0.5 * kPi, Vec3::UnitX()));  // Z up becomes Y up
    root_ = add_node(root);
    GltfNode space;
    space.name = "space";
    space.parent = root_;
    space.scale = Vec3::Constant(unit_);
    space_ = add_node(space);

    GltfNode body;
    body.name = "body_frame";
    body.parent = space_;
    const Thing solid = body_thing();
    const KeyedPoses keys = keyed(
        solid, [&](double t) { return body_frame(t); }, first_, clock_, report_.tolerance);
    set_poses(solid, keys, origin_, body);
    body_ = add_node(body);
    for (const Pose& pose : keys.poses)
      report_.farthest = std::max(report_.farthest, (pose.at - origin_).norm());

    add_direction("along_omega", [](const Sample& now) { return now.w_S; });
    add_direction("along_momentum", [](const Sample& now) { return now.L_S; });
    const Vec3 axis_B = figure_axis_B(composer_.scenery().motion.model());
    add_direction("along_axis", [=](const Sample& now) { return Vec3(now.q_SB * axis_B); });
  }

  // a node at the reference point whose z points along a vector
  template <class Vector>
  void add_direction(const std::string& name, const Vector& vector) {
    Thing line;
    line.kind = ThingKind::rod;
    line.round = true;
    const double length = composer_.scenery().scale.body;
    const auto pose_at = [&](double t) {
      const Sample now = motion_.at(t);
      const Vec3 along = vector(now);
      Pose pose;
      pose.at = now.reference_S;
      pose.size = Vec3(0.0, 0.0, length);
      if (along.norm() > 0.0) pose.turn = turn_between(Vec3::UnitZ(), along);
      return pose;
    };
    GltfNode node;
    node.name = name;
    node.parent = space_;
    set_poses(line, keyed(line, pose_at, first_, clock_, report_.tolerance), origin_, node);
    add_node(node);
  }

  // the group of an element, in space or in the body
  int group_of(const std::string& element, bool in_body, const glm::vec3& color) {
    const auto [found, added] = groups_.emplace(std::make_pair(element, in_body), 0);
    if (added) {
      GltfNode node;
      node.name = element;
      node.parent = in_body ? body_ : space_;
      node.extras = {{"element", element}, {"color", hex(color)}};
      found->second = add_node(node);
    }
    return found->second;
  }

  bool keeps_place_in_body(std::size_t index, const Thing& thing) {
    const auto seen = [&](double played) {
      const double t = clock_.motion_time(played);
      return seen_from(body_frame(t), observer_.pose(index, t));
    };
    const Pose start = seen(first_.front());
    return std::all_of(first_.begin(), first_.end(), [&](double played) {
      return distance(thing, start, seen(played)) <= 1e-3 * report_.tolerance;
    });
  }

  void add_things() {
    // those that are seen later are added while others are looked at
    for (std::size_t i = 0; i < observer_.things().size(); ++i) {
      const Thing thing = observer_.things()[i];
      const auto in_space = [&](double t) {
        if (plan_.tell)
          plan_.tell(fmt::format("following {} through the motion: {:.3g} s", thing.element, t));
        return observer_.pose(i, t);
      };
      KeyedPoses keys = keyed(thing, in_space, first_, clock_, report_.tolerance);
      const bool in_body = !keys.still && keeps_place_in_body(i, thing);
      if (in_body) {
        const double t = clock_.motion_time(first_.front());
        keys = {{first_.front()}, {seen_from(body_frame(t), in_space(t))}, 0.0, true};
      }
      const bool is_label = thing.kind == ThingKind::label;
      const glm::vec3& color = is_label ? thing.label.color : thing.material.color;
      const int group = group_of(thing.element, in_body, color);
      // an element is known by the colour of its surface
      if (thing.both_sides)
        document_.nodes[static_cast<std::size_t>(group)].extras["color"] = hex(color);
      add_thing(thing, keys, group, in_body ? Vec3::Zero() : origin_);
    }
  }

  void add_thing(const Thing& thing, const KeyedPoses& keys, int group, const Vec3& from) {
    constexpr std::array<const char*, 5> kWords = {"mesh", "arrow", "rod", "arc", "label"};
    GltfNode node;
    node.name = fmt::format("{}.{}", thing.element, kWords[static_cast<std::size_t>(thing.kind)]);
    node.parent = group;
    set_poses(thing, keys, from, node);
    if (thing.kind == ThingKind::label) {
      node.extras = {
          {"label", thing.label.markup},
          {"color", hex(readable(thing.label.color, composer_.scenery().theme.background))},
          {"size", thing.label.size},
          {"of_arrow", thing.label.of_arrow}};
      tracks_.set_size(
          keys, [](const Pose& pose) { return pose.size; }, node);
      add_node(node);
      return;
    }
    const int material = material_in(document_, thing.material, thing.both_sides, thing.element);
    if (thing.kind == ThingKind::mesh) {
      node.mesh = mesh_in(document_, thing.mesh, material, plan_.paint);
      tracks_.set_size(
          keys, [](const Pose& pose) { return pose.size; }, node);
      add_node(node);
      return;
    }
    if (thing.kind == ThingKind::rod) {
      node.mesh = mesh_in(document_, arrows_.shaft, material, plan_.paint);
      tracks_.set_size(
          keys, [](const Pose& pose) { return pose.size; }, node);
      add_node(node);
      return;
    }
    const int index = add_node(node);
    if (thing.kind == ThingKind::arc) {
      add_arc(keys, material, index);
    } else {
      add_arrow(thing, keys, material, index);
    }
  }

  void add_arrow(const Thing& thing, const KeyedPoses& keys, int material, int parent) {
    const ArrowShape shape = thing.shape;
    const auto head_length = [=](const Pose& pose) {
      return shape.head_length * pose.size.x();
    };
    GltfNode shaft, head;
    const std::string& name = document_.nodes[static_cast<std::size_t>(parent)].name;
    shaft.name = name + ".shaft";
    head.name = name + ".head";
    shaft.parent = head.parent = parent;
    shaft.mesh = mesh_in(document_, arrows_.shaft, material, plan_.paint);
    // its parts are not dashed
    Material whole = thing.material;
    whole.dashes = 0.0f;
    head.mesh = mesh_in(document_,
                        arrows_.head,
                        material_in(document_, whole, thing.both_sides, thing.element),
                        plan_.paint);
    const auto length = [=](const Pose& pose) {
      return pose.size.z() - head_length(pose);
    };
    tracks_.set_size(
        keys,
        [=](const Pose& pose) {
          const double radius = shape.shaft_radius * pose.size.x();
          return Vec3(radius, radius, length(pose));
        },
        shaft);
    tracks_.set_size(
        keys,
        [=](const Pose& pose) {
          const double radius = shape.head_radius * pose.size.x();
          return Vec3(radius, radius, head_length(pose));
        },
        head);
    head.translation = Vec3(0.0, 0.0, length(keys.poses.front()));
    if (!keys.still) {
      head.translated = tracks_.track(
          keys, 3, [&](const Pose& pose, int i) { return i == 2 ? length(pose) : 0.0; });
    }
    add_node(shaft);
    add_node(head);
  }

  // a chain of joints, each turned by the same part of the angle about the middle, with a piece of
  // tube on each
  void add_arc(const KeyedPoses& keys, int material, int parent) {
    const auto part = [](const Pose& pose) {
      return pose.size.z() / kPiecesOfArc;
    };
    GltfNode joint, piece;
    const std::string name = document_.nodes[static_cast<std::size_t>(parent)].name;
    joint.name = name + ".joint";
    piece.name = name + ".piece";
    piece.mesh = mesh_in(document_, arrows_.shaft, material, plan_.paint);
    const Pose& start = keys.poses.front();
    joint.rotation = Quat(Eigen::AngleAxisd(part(start), Vec3::UnitZ()));
    // from one joint to the next, along the tangent; a little longer, so that no gap opens outside
    piece.rotation = Quat(Eigen::AngleAxisd(-0.5 * kPi, Vec3::UnitX()));
    piece.translation = Vec3(start.size.x(), 0.0, 0.0);
    tracks_.set_size(
        keys,
        [=](const Pose& pose) {
          return Vec3(pose.size.y(),
                      pose.size.y(),
                      pose.size.x() * part(pose) + 0.3 * pose.size.y() * (pose.size.x() > 0.0));
        },
        piece);
    if (!keys.still) {
      joint.rotated = tracks_.track(keys, 4, [&](const Pose& pose, int i) {
        return Quat(Eigen::AngleAxisd(part(pose), Vec3::UnitZ())).coeffs()[i];
      });
      piece.translated = tracks_.track(
          keys, 3, [&](const Pose& pose, int i) { return i == 0 ? pose.size.x() : 0.0; });
    }
    for (int i = 0; i < kPiecesOfArc; ++i) {
      piece.parent = parent;
      add_node(piece);
      joint.parent = parent;
      if (i + 1 < kPiecesOfArc) parent = add_node(joint);
    }
  }

  // pieces that appear when the point has passed them, and vanish as their beginning becomes too
  // old
  void add_trails() {
    for (const ObservedTrail& one : observer_.trails()) {
      const Trail& trail = *one.trail;
      const int material = material_in(document_, one.material, false, one.element);
      const int group = group_of(one.element, one.on_body, one.material.color);
      GltfNode path;
      path.name = one.element + ".path";
      path.parent = group;
      path.translation = trail.place().translation() - (one.on_body ? Vec3(Vec3::Zero()) : origin_);
      path.scale = Vec3::Constant(trail.place().linear()(0, 0));
      const int parent = add_node(path);
      const bool vanishes = one.length < 0.999 * clock_.to;
      const double begin = vanishes ? std::max(0.0, clock_.from - one.length) : 0.0;
      const std::size_t count = pieces_of(one, clock_.to - begin, vanishes);
      const auto end_of = [&](std::size_t pieces) {
        return begin +
               (clock_.to - begin) * static_cast<double>(pieces) / static_cast<double>(count);
      };
      for (std::size_t i = 0; i < count; ++i) {
        const Span span = {end_of(i), end_of(i + 1)};
        add_piece(trail, span, vanishes ? one.length : 2.0 * clock_.to, material, parent);
      }
    }
  }

  // Into how many pieces `duration` (s) of a path is cut.
  static std::size_t pieces_of(const ObservedTrail& one, double duration, bool vanishes) {
    const std::size_t count =
        std::clamp(one.trail->path().points.size() / kPointsOfPiece, kFewestPieces, kMostPieces);
    if (!vanishes) return count;
    const double needed = kPiecesOfTail * duration / one.length;
    if (needed > kMostPiecesOfTails) {
      throw input_error(
          "{:g} s are too short for {:g} s of motion: give at least {:.2g} s, or export less "
          "(--from, "
          "--to)",
          one.length,
          duration,
          kPiecesOfTail / kMostPiecesOfTails * duration)
          .at({{}, 0, "show.trail_length"});
    }
    return std::max(count, static_cast<std::size_t>(std::ceil(needed)));
  }

  struct Span {
    double from, to;  // s of motion
  };
  void add_piece(const Trail& trail, const Span& span, double lasts, int material, int parent) {
    const double comes = (span.to - clock_.from) / clock_.scale;
    const double goes = (span.from + lasts - clock_.from) / clock_.scale;
    if (goes <= 0.0) return;
    auto times = std::make_shared<std::vector<float>>();
    auto values = std::make_shared<std::vector<float>>();
    const auto add_step = [&](double time, float value) {
      times->push_back(static_cast<float>(time));
      values->insert(values->end(), 3, value);
    };
    add_step(0.0, comes > 0.0 ? 0.0f : 1.0f);
    if (comes > 0.0) add_step(comes, 1.0f);
    if (goes < clock_.duration() && goes > comes) add_step(goes, 0.0f);
    const std::string name = document_.nodes[static_cast<std::size_t>(parent)].name;
    for (const MeshPtr& mesh : trail.part(span.from, span.to)) {
      GltfNode node;
      node.name = name + ".piece";
      node.parent = parent;
      node.mesh = mesh_in(document_, mesh, material, plan_.paint);
      if (comes > 0.0) node.scale = Vec3::Zero();
      if (times->size() > 1) node.scaled = {times, values, true};
      add_node(node);
    }
  }

  void add_cameras() {
    const PictureSize size = solved_.scene.video.size;
    std::vector<ShotSpec> shots = solved_.scene.shots;
    std::stable_sort(
        shots.begin(), shots.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
    for (std::size_t i = 0; i < composer_.cameras(); ++i) {
      const Camera camera = composer_.camera_at(0.0, i);
      const std::string name =
          i == 0 || shots[i - 1].name.empty() ? "camera" : "camera." + shots[i - 1].name;
      document_.cameras.push_back({name,
                                   1.0 * size.width / size.height,
                                   camera.field_of_view(),
                                   unit_ * camera.nearest(),
                                   unit_ * camera.farthest()});
      GltfNode node;
      node.name = name;
      node.parent = root_;
      node.camera = static_cast<int>(i);
      Thing seen;  // what is as far away as the body
      const double depth = (camera.eye() - motion_.at(0.0).reference_S).norm();
      seen.high = Vec3::Constant(depth * unit_);
      seen.low = -seen.high;
      const auto pose_at = [&](double t) {
        const Eigen::Isometry3d place =
            composer_.camera_at(composer_.timeline().film_time(t), i).space_from_camera();
        return Pose{unit_ * (place.translation() - origin_), Quat(place.linear()), Vec3::Ones()};
      };
      set_poses(seen,
                keyed(seen, pose_at, first_, clock_, unit_ * report_.tolerance),
                Vec3::Zero(),
                node);
      const int index = add_node(node);
      if (i == 0) add_lights(index);
    }
  }

  // those of the film travel with the camera (View in frame/draw_list.h); light from everywhere is
  // no part of glTF
  void add_lights(int camera) {
    const View view = composer_.camera_at(0.0, 0).view();
    const Mat3 R_CS = composer_.camera_at(0.0, 0).space_from_camera().linear().transpose();
    const auto add = [&](const char* name, const glm::vec3& to_light, double intensity) {
      GltfNode node;
      node.name = name;
      node.parent = camera;
      node.rotation = turn_between(Vec3::UnitZ(), R_CS * to_eigen(to_light));
      node.light = static_cast<int>(document_.lights.size());
      document_.lights.push_back({name, intensity});
      add_node(node);
    };
    add("key_light", view.key_light, 2.0);
    add("fill_light", view.fill_light, 0.5);
  }

  void describe() {
    const Scene& scene = solved_.scene;
    document_.title = scene.title.empty() ? "polhode" : scene.title;
    document_.generator = "polhode " + program_version();
    std::string rights = plan_.author;
    if (!plan_.licence.empty()) rights += (rights.empty() ? "" : ", ") + plan_.licence;
    document_.copyright = rights;
    document_.extras = {
        {"title", scene.title},
        {"author", plan_.author},
        {"licence", plan_.licence},
        {"scene", scene_hash(scene)},
        {"from", clock_.from},
        {"to", clock_.to},
        {"time_scale", clock_.scale},
        {"origin", list_of(origin_)},
        {"units_per_metre", unit_},
        {"body_radius", composer_.scenery().scale.body},
        {"dashes",
         {{"length", kDashLength * composer_.scenery().scale.body}, {"breadth", kDashBreadth}}},
        {"background", hex(composer_.scenery().theme.background)},
        {"light_ground", is_light(composer_.scenery().theme.background)},
        {"accuracy",
         {{"asked_m", report_.tolerance},
          {"measured_m", report_.error},
          {"measured_pixels", report_.error * report_.pixels_per_metre}}},
    };
  }

  const Solved& solved_;
  const Composer& composer_;
  const ExportPlan& plan_;
  const Motion& motion_;
  Observer observer_;
  Vec3 origin_;  // S, m
  ArrowMeshes arrows_;
  AnimationClock clock_;
  std::vector<double> first_;  // s of animation
  double unit_ = 1.0;          // units of the file per metre
  GltfDocument document_;
  ExportReport report_;
  std::set<std::string> names_;
  std::map<std::pair<std::string, bool>, int> groups_;
  TrackMaker tracks_;
  int root_ = -1, space_ = -1, body_ = -1;
};

}  // namespace

ExportedScene export_scene(const Solved& solved, const ExportPlan& plan) {
  TimeRange range;
  range.from = plan.from;
  range.to = plan.to;
  check_time_range(solved.scene, range);
  range.one_picture = true;  // there is no limit to its frames
  const FrameTimes frames = plan_frame_times(solved, range);
  const Solved shown = shown_part(solved, frames);
  return Export(shown, *composer_alone(shown, frames.timeline), plan).make();
}

}  // namespace polhode
