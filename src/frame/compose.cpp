// SPDX-License-Identifier: MIT
#include "frame/compose.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/error.h"
#include "base/numbers.h"
#include "base/units.h"
#include "math/so3.h"
#include "motion/deviation.h"

namespace polhode {
namespace {

constexpr double kFarTable = 5.0;  // its radius at most, in that of the body and of where it goes
// Of a body that is always smaller, in the height of the picture, arrows are thicker, up to so many
// times: from the last row they would be hairs.
constexpr double kLeastRadius = 0.18;
constexpr double kThickest = 2.5;
constexpr int kRoughArrow = 8;  // pieces of a full circle of arrows that throw shadows

// Does a camera turn with the body or with L? A floor would turn about it.
bool turns(const Staging& staging) {
  const auto turning = [](const CameraSpec& camera) {
    return camera.follow != "auto" && camera.follow != "none" && camera.follow != "center";
  };
  return turning(staging.camera) ||
         std::any_of(staging.shots.begin(), staging.shots.end(), [&](const ShotSpec& shot) {
           return turning(shot.camera);
         });
}

// what a scene shows, with every default resolved
std::map<std::string, bool> resolve(const ShowSpec& spec,
                                    const Scenery& scenery,
                                    const Staging& staging) {
  std::map<std::string, bool> shown;
  for (const Element& element : elements()) {
    const auto found = spec.asked.find(element.name);
    const std::optional<bool> asked = found == spec.asked.end() ? std::nullopt : found->second;
    shown[element.name] = asked ? *asked : element.by_default(scenery);
    if (!asked && element.name == "floor" && turns(staging)) shown[element.name] = false;
    if (!asked.value_or(false)) continue;
    const std::string wrong = element.why_not(scenery);
    if (!wrong.empty()) throw input_error("{}", wrong).at({{}, 0, "show." + element.name});
  }
  const bool cones = shown["space_cone"] || shown["body_cone"] || shown["precession_cone"];
  if (spec.body_opacity < 1.0 && cones) {
    throw input_error("a translucent body cannot be combined with cones; set the cones to false")
        .at({{}, 0, "show.body_opacity"});
  }
  return shown;
}

Scenery scenery_with(const Motion& motion,
                     const BodySpec& body,
                     const ThemeSpec& theme,
                     const ShowSpec& show,
                     PictureSize size,
                     const Shared& shared) {
  Scenery scenery =
      make_scenery(motion, body, theme, show, circle_segments(0.5 * size.height), shared.scale);
  scenery.ensemble = shared.ensemble;
  return scenery;
}

DrawingFrame make_drawing_frame(const Scenery& scenery) {
  const Vec3 origin = scenery.motion.at(0.0).reference_S;
  const double size = scenery.scale.body;
  constexpr double kDigits = 1e-10;  // of double precision that a picture can spare
  if (size < kDigits * origin.norm()) {
    throw input_error("the body is too small ({:.3g} m) to be drawn {:.3g} m from the origin",
                      size,
                      origin.norm())
        .at({{}, 0, "motion.position"});
  }
  return {origin, size};
}

// the margins with those of the scene instead of the usual ones; text keeps its room, and a tenth
// of the picture is left
FrameMargins with_margin(const FrameMargins& margins, double margin, PictureSize size) {
  const FrameMargins usual;
  const auto sum = [](double text, double wanted) {
    return std::clamp(text + wanted, 0.0, 0.45);
  };
  const double across = margin * size.height / size.width;
  return {sum(margins.left - usual.left, across),
          sum(margins.right - usual.right, across),
          sum(margins.top - usual.top, margin),
          sum(margins.bottom - usual.bottom, margin)};
}

// does the reference point go farther than the body is large?
bool travels(const Scenery& scenery) {
  if (scenery.motion.model().on_pivot) return false;
  const Vec3 start = scenery.motion.at(0.0).reference_S;
  const std::vector<double> times = framing_times(scenery.motion);
  return std::any_of(times.begin(), times.end(), [&](double t) {
    return (scenery.motion.at(t).reference_S - start).norm() > 2.0 * scenery.scale.body;
  });
}

Camera make_camera(const CameraSpec& spec,
                   const std::vector<Vec3>& points,
                   PictureSize size,
                   const FrameMargins& text_margins) {
  if (!spec.eye) {
    const Vec3 direction = spec.direction.value_or(kDefaultDirection);
    if (direction.stableNorm() == 0.0) {
      throw input_error("must not be zero").at({{}, 0, "camera.direction"});
    }
    const FrameMargins margins =
        spec.margin ? with_margin(text_margins, *spec.margin, size) : text_margins;
    return framing_camera(points, spec.target, direction, spec.fov, size, margins)
        .zoomed(spec.zoom);
  }

  // the scene's own camera; the ball of what is drawn sets the clip planes
  const auto [center, radius] = ball_around(points);
  const Vec3 target = spec.target.value_or(center);
  if ((*spec.eye - target).norm() < 1e-9 * (radius + target.norm())) {
    throw input_error("the camera is at its own target").at({{}, 0, "camera.eye"});
  }
  return Camera(*spec.eye, target, spec.fov, size, center, radius).zoomed(spec.zoom);
}

}  // namespace

Composer::Composer(const Motion& motion,
                   const BodySpec& body,
                   const Staging& staging,
                   const ShowSpec& show,
                   const ThemeSpec& theme,
                   PictureSize size,
                   const Shared& shared)
    : scenery_(scenery_with(motion, body, theme, show, size, shared)),
      shown_(resolve(show, scenery_, staging)),
      drawing_(make_drawing_frame(scenery_)),
      staging_(staging),
      beside_(shared.beside),
      rigs_(make_rigs(size)) {
  if (scenery_.motion.model().table) {
    scenery_.table_goes_along = std::any_of(
        rigs_.begin(), rigs_.end(), [](const Rig& rig) { return rig.spec.follow != "none"; });
    // its path is as thick as it is near
    if (scenery_.table_goes_along) scenery_.paths = make_paths(scenery_);
  }
  // now that the cameras are known: no triangle smaller than a pixel needs
  Largest largest = largest_on_screen();
  scenery_.thickness = std::clamp(kLeastRadius * size.height / largest.body, 1.0, kThickest);
  if (scenery_.thickness > 1.0) largest = largest_on_screen();
  const int most = circle_segments(0.5 * size.height);
  // finer than edges need: a limb bends in two directions, and the eye sees its corners
  scenery_.body_segments = std::min(most, circle_segments(largest.body));
  make_look(scenery_, body, 5 * scenery_.body_segments / 4);
  body_B_ = ball_around(scenery_.hull_B);
  // their rims bend before the eye as broad lines
  meshes_.cones = cone_meshes(std::min(most, 3 * circle_segments(largest.cone) / 2), largest.cones);
  // twice as fine: what is off at the base of a head puts its tip elsewhere
  const int for_heads = 2 * circle_segments(largest.head);
  meshes_.arrows =
      arrow_meshes(std::min(most, circle_segments(largest.tube)), std::min(most, for_heads));
  meshes_.rough_arrows = arrow_meshes(kRoughArrow, kRoughArrow);
}

Composer::Composer(const Motion& motion,
                   const BodySpec& body,
                   const CameraSpec& camera,
                   const ShowSpec& show,
                   const ThemeSpec& theme,
                   PictureSize size)
    : Composer(motion,
               body,
               Staging{camera, {}, Timeline({}, motion.duration(), 1.0)},
               show,
               theme,
               size) {}

Composer::Composer(const Composer& other, const Motion& motion, std::optional<double> fails)
    : Composer(other) {
  fails_ = fails;
  scenery_.motion = motion;
  scenery_.paths = make_paths(scenery_);
}

Glyphs Composer::glyphs_at(const Sample& sample) const {
  return glyphs_at(sample, staging_.timeline.film_time(sample.t));
}

Glyphs Composer::glyphs_at(const Sample& sample, double film) const {
  return glyphs_of(sample, film);
}

Glyphs Composer::glyphs_of(const Sample& sample,
                           std::optional<double> film,
                           bool for_framing) const {
  Glyphs glyphs;
  glyphs.middle = sample.reference_S;
  glyphs.for_framing = for_framing;
  for (const Element& element : elements()) {
    if (!shows(element.name)) continue;
    const double presence = film ? staging_.timeline.presence(element.name, *film) : 1.0;
    if (presence <= 0.0) continue;
    const GlyphCounts before(glyphs);
    element.add(scenery_, sample, glyphs);
    if (presence < 1.0) fade_new(glyphs, before, presence);
  }
  add_points(scenery_, sample, shows("fixed_frame"), glyphs);
  add_point_trails(scenery_, sample, glyphs);
  add_tip_trails(scenery_, sample, glyphs);
  if (film && fails_ && staging_.timeline.motion_time(*film) >= *fails_) mark_as_ended(glyphs);
  return glyphs;
}

DrawList Composer::at(double t) const {
  return camera_view(staging_.timeline.film_time(t), scenery_.motion.duration()).list;
}

CameraView Composer::camera_view(double film, double end) const {
  CameraView seen_now;
  const double t = std::min(staging_.timeline.motion_time(film), end);
  const Sample sample = scenery_.motion.at(t);
  const Glyphs glyphs = glyphs_of(sample, film, false);
  const Camera camera = camera_at(film);
  seen_now.list.view = camera.view(drawing_);
  seen_now.list.background = scenery_.theme.background;
  seen_now.list.view.light_ground = is_light(scenery_.theme.background);
  add_items(glyphs, meshes_, drawing_, camera.eye(), seen_now.list);
  seen_now.names = seen_labels(glyphs, camera, scenery_);
  seen_now.way_to_body = way_to_body(sample, film, camera);
  return seen_now;
}

std::optional<Vec2> Composer::way_to_body(const Sample& sample,
                                          double film,
                                          const Camera& camera) const {
  if (!shows("body") || staging_.timeline.presence("body", film) <= 0.0) return {};
  const Vec3 middle = point_position(scenery_.motion.model(), sample, body_B_.center);
  return camera.way_to({middle, body_B_.radius});
}

LabelView Composer::label_view(double film, double end) const {
  const double t = std::min(staging_.timeline.motion_time(film), end);
  const Sample sample = scenery_.motion.at(t);
  const Camera camera = camera_at(film);
  LabelView view = seen_labels(glyphs_of(sample, film, false), camera, scenery_);
  const bool any_circle =
      std::any_of(view.labels.begin(), view.labels.end(), [](const SeenLabel& label) {
        return label.circle.has_value();
      });
  if (any_circle && shows("body")) {
    std::vector<Vec3> hull_S;
    hull_S.reserve(scenery_.hull_B.size());
    for (const Vec3& point_B : scenery_.hull_B)
      hull_S.push_back(point_position(scenery_.motion.model(), sample, point_B));
    view.body = seen_outline(hull_S, camera);
  }
  return view;
}

// does anything that is shown stand in space, so that a camera should too?
bool Composer::keeps_place_in_space() const {
  const ShowSpec& show = scenery_.options;
  const bool whole_path =
      shows("trail") || !show.trail_points.empty() || show.trail_tips.has_value();
  const std::vector<Load>& loads = scenery_.motion.model().loads.listed;
  const bool spring = std::any_of(
      loads.begin(), loads.end(), [](const Load& load) { return load.kind == Load::Kind::spring; });
  return shows("fixed_frame") || shows("floor") || (whole_path && !show.trail_s) ||
         (shows("forces") && spring);
}

// does an automatic camera that moves with the body come nearer than one that stands? What stays
// behind, as ghosts do, may take more room around a body that moves on.
bool Composer::is_larger_followed(CameraSpec spec, PictureSize size) const {
  const auto pixels_per_metre = [&](const char* follow) {
    spec.follow = follow;
    const Camera camera = make_camera(spec, points_to_frame(spec), size, staging_.margins);
    double sum = 0.0;
    for (const double film : film_times()) {
      const Sample sample = scenery_.motion.at(staging_.timeline.motion_time(film));
      sum += camera.moved(rig_from_space(spec, film)).pixels_per_metre(sample.reference_S);
    }
    return sum;
  };
  return pixels_per_metre("center") > 1.1 * pixels_per_metre("none");
}

// would a camera that stands at the whole path on a table leave the body small?
bool Composer::is_small_on_table(CameraSpec spec, PictureSize size) const {
  constexpr double kSmall = 1.0 / 3.0;  // of the height of the picture
  spec.follow = "none";
  const Camera camera = make_camera(spec, points_to_frame(spec), size, staging_.margins);
  double sum = 0.0;
  const std::vector<double> times = film_times();
  for (const double film : times) {
    const Sample sample = scenery_.motion.at(staging_.timeline.motion_time(film));
    sum += 2.0 * scenery_.scale.body *
           camera.moved(rig_from_space(spec, film)).pixels_per_metre(sample.reference_S);
  }
  return sum < kSmall * size.height * static_cast<double>(times.size());
}

std::string Composer::follow_of(const CameraSpec& spec, PictureSize size) const {
  if (spec.follow != "auto") return spec.follow;
  if (spec.eye || spec.target) return "none";
  if (scenery_.motion.model().table) {
    // cameras of all panels go along if one of the bodies does
    const bool any_travels =
        travels(scenery_) || std::any_of(beside_.begin(), beside_.end(), [](const auto& other) {
          return travels(other->scenery_);
        });
    const bool follows = any_travels && !shows("fixed_frame") && is_small_on_table(spec, size) &&
                         is_larger_followed(spec, size);
    return follows ? "center" : "none";
  }
  if (!spec.direction && (shows("plane") || shows("herpolhode"))) return "upright";
  const bool follows =
      travels(scenery_) && !keeps_place_in_space() && is_larger_followed(spec, size);
  return follows ? "center" : "none";
}

// Where the rig of a camera stands still: space for most, turned or moved for those that go along.
Eigen::Isometry3d Composer::rig_from_space(const CameraSpec& spec, double film) const {
  Eigen::Isometry3d rig = Eigen::Isometry3d::Identity();
  if (spec.follow == "none" && spec.orbit == 0.0) return rig;
  const Sample start = scenery_.motion.at(staging_.timeline.motion_time(0.0));
  const Sample now = scenery_.motion.at(staging_.timeline.motion_time(film));
  if (spec.follow != "none") {
    Mat3 turn = Mat3::Identity();
    if (spec.follow == "body") {
      turn = (start.q_SB * now.q_SB.conjugate()).toRotationMatrix();
    } else if (spec.follow == "momentum" && now.L_S.norm() > 0.0 && start.L_S.norm() > 0.0) {
      turn = turn_between(now.L_S, start.L_S).toRotationMatrix();
    } else if (spec.follow == "upright" && now.L_S.norm() > 0.0 && start.L_S.norm() > 0.0) {
      // up or down, whichever is nearer
      const Vec3 vertical = start.L_S.z() < 0.0 ? Vec3(-Vec3::UnitZ()) : Vec3(Vec3::UnitZ());
      turn = turn_between(now.L_S, vertical).toRotationMatrix();
    }
    rig.linear() = turn;
    rig.translation() = start.reference_S - turn * now.reference_S;
    // along a table, not up and down
    if (spec.follow == "center" && scenery_.motion.model().table) rig.translation().z() = 0.0;
  }
  if (spec.orbit != 0.0) {
    const Vec3 center = spec.target.value_or(start.reference_S);
    const Eigen::AngleAxisd back(-spec.orbit * film, Vec3::UnitZ());
    rig = Eigen::Translation3d(center) * back * Eigen::Translation3d(-center) * rig;
  }
  return rig;
}

std::vector<Composer::Rig> Composer::make_rigs(PictureSize size) const {
  std::vector<Rig> rigs;
  const auto add =
      [&](CameraSpec spec, double begins, double move, std::optional<std::size_t> shot = {}) {
        spec.follow = follow_of(spec, size);
        // looking along L means from the side that it points to
        const Vec3 L = scenery_.motion.at(staging_.timeline.motion_time(0.0)).L_S;
        if (spec.follow == "momentum" && !spec.eye && !spec.direction && L.norm() > 0.0)
          spec.direction = L.normalized();
        Camera camera = make_camera(spec, points_to_frame(spec), size, staging_.margins);
        // a table reaches farther than what is framed
        if (scenery_.motion.model().table && shows("floor"))
          camera = camera.seeing_farther(kFarTable * (scenery_.scale.body + scenery_.table_reach));
        rigs.push_back({spec, begins, move, camera, shot});
      };
  add(staging_.camera, 0.0, 0.0);
  for (std::size_t i = 0; i < staging_.shots.size(); ++i) {
    const ShotSpec& shot = staging_.shots[i];
    try {
      const double end = staging_.timeline.motion_time(staging_.timeline.film_duration());
      if (up_to(end, shot.at) > end) {
        throw input_error("must be a time within the motion, 0 to {} s, got {}", end, shot.at)
            .at({{}, 0, fmt::format("shots[{}].at", i)});
      }
      add(shot.camera, staging_.timeline.film_time(shot.at), shot.move, i);
    } catch (const Error& error) {
      // "camera.eye" of this shot
      const std::string key = error.place().key.substr(error.place().key.find('.') + 1);
      throw Error(error.fault(), error.message(), {{}, 0, fmt::format("shots[{}].{}", i, key)});
    }
  }
  std::stable_sort(
      rigs.begin() + 1, rigs.end(), [](const Rig& a, const Rig& b) { return a.begins < b.begins; });
  return rigs;
}

Camera Composer::placed(const Rig& rig, double film) const {
  return rig.camera.moved(rig_from_space(rig.spec, film));
}

// The turn from one camera to the next one while both go along with something: it goes on as it
// began. The shortest one would leap to the other side where it passes half a turn. (Near a whole
// turn its axis swings round; a move that long is left to who asks for it.)
Vec3 Composer::turn_between_rigs(const Rig& from, const Rig& to, double film) const {
  constexpr double kMostOfMove = 2000.0;
  const double step = std::max(1.0 / 60.0, to.move / kMostOfMove);  // s of film
  Vec3 turn = Vec3::Zero();
  const auto go_on_at = [&](double time) {
    turn = placed(from, time).turn_to(placed(to, time), turn);
  };
  for (int k = 0; to.begins + k * step < film; ++k)
    go_on_at(to.begins + k * step);
  go_on_at(film);
  return turn;
}

std::size_t Composer::rig_at(double film) const {
  std::size_t last = 0;
  while (last + 1 < rigs_.size() && reached(film, rigs_[last + 1].begins))
    ++last;
  return last;
}

Camera Composer::camera_at(double film) const {
  const std::size_t last = rig_at(film);
  const Rig& rig = rigs_[last];
  if (last == 0 || rig.move <= 0.0 || film >= rig.begins + rig.move) return placed(rig, film);
  const Vec3 focus = scenery_.motion.at(staging_.timeline.motion_time(film)).reference_S;
  return Camera::between(placed(rigs_[last - 1], film),
                         placed(rig, film),
                         eased((film - rig.begins) / rig.move),
                         focus,
                         turn_between_rigs(rigs_[last - 1], rig, film));
}

Camera Composer::camera_at(double film, std::size_t index) const {
  return placed(rigs_.at(index), film);
}

double Composer::next_cut(double film) const {
  const auto cut = std::find_if(rigs_.begin() + 1, rigs_.end(), [&](const Rig& rig) {
    return !reached(film, rig.begins) && rig.move <= 0.0;
  });
  return cut == rigs_.end() ? std::numeric_limits<double>::infinity() : cut->begins;
}

std::vector<double> Composer::film_times() const {
  constexpr int kTimes = 240;
  std::vector<double> times;
  const double duration = staging_.timeline.film_duration();
  for (int i = 0; i <= kTimes; ++i)
    times.push_back(duration * i / kTimes);
  const Motion& motion = scenery_.motion;
  for (const double t : times_after_switches(motion.model().loads.switches, motion.duration()))
    times.push_back(std::min(staging_.timeline.film_time(t), duration));
  std::sort(times.begin(), times.end());
  return times;
}

std::vector<Vec3> Composer::points_to_frame(const CameraSpec& spec) const {
  std::vector<Vec3> points = own_points(spec);
  for (const std::shared_ptr<const Composer>& other : beside_) {
    const std::vector<Vec3> more = other->own_points(spec);
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

std::vector<Vec3> Composer::own_points(const CameraSpec& spec) const {
  std::vector<Vec3> points;
  for (const double film : film_times()) {
    const Sample sample = scenery_.motion.at(staging_.timeline.motion_time(film));
    std::vector<Vec3> now = {sample.reference_S};
    // all that will ever be shown: nothing jumps when it comes
    add_extent(glyphs_of(sample, {}), now);
    const Eigen::Isometry3d rig = rig_from_space(spec, film);
    if (points.empty()) points.reserve(now.size() * (film_times().size() + 1));
    for (const Vec3& point : now)
      points.push_back(rig * point);
  }
  return points;
}

Composer::Largest Composer::largest_on_screen() const {
  Largest largest;
  for (const double film : film_times()) {
    const Sample sample = scenery_.motion.at(staging_.timeline.motion_time(film));
    const Camera camera = camera_at(film);
    // the radius, m, of a ball that holds a thing about a point; infinite from inside
    const auto pixels = [&](const Vec3& middle, double reach, double radius) {
      const Vec3 to_eye = camera.eye() - middle;
      if (to_eye.norm() <= 1.5 * reach) return std::numeric_limits<double>::infinity();
      return radius * camera.pixels_per_metre(middle + reach * to_eye.normalized());
    };
    const double body = scenery_.scale.body;
    largest.body = std::max(largest.body, pixels(sample.reference_S, body, body));
    const Glyphs glyphs = glyphs_at(sample, film);
    largest.cones.insert(largest.cones.end(), glyphs.cones.begin(), glyphs.cones.end());
    for (const Cone& cone : glyphs.cones) {
      const double rim = cone.slant * std::sin(cone.half_angle);
      largest.cone = std::max(largest.cone, pixels(cone.apex, cone.slant, rim));
    }
    const auto along = [&](const Vec3& from, const Vec3& to, double radius) {
      return pixels(0.5 * (from + to), 0.5 * (to - from).norm(), radius);
    };
    for (const ArrowGlyph& arrow : glyphs.arrows) {
      const auto& [shaft, head, length] = arrow.shape;
      largest.tube = std::max(largest.tube, along(arrow.from, arrow.tip, shaft));
      largest.head = std::max(largest.head, along(arrow.from, arrow.tip, head));
    }
    for (const RodGlyph& rod : glyphs.rods)
      largest.tube = std::max(largest.tube, along(rod.from, rod.to, rod.radius));
    for (const ArcGlyph& arc : glyphs.arcs)
      largest.tube = std::max(largest.tube, pixels(arc.center, arc.radius, arc.tube_radius));
  }
  return largest;
}

// a shot may leave no time for what comes before it
std::vector<Error> Composer::warnings_of_shots() const {
  std::vector<Error> found;
  for (std::size_t i = 0; i < staging_.shots.size(); ++i) {
    const ShotSpec& shot = staging_.shots[i];
    const double begins = staging_.timeline.film_time(shot.at);
    double ends = staging_.timeline.film_duration();
    bool is_hidden = false;
    for (std::size_t k = 0; k < staging_.shots.size(); ++k) {
      const double other = staging_.timeline.film_time(staging_.shots[k].at);
      if (other > begins) ends = std::min(ends, other);
      is_hidden = is_hidden || (other == begins && k > i);
    }
    const auto warn = [&](const char* key, const std::string& words) {
      found.push_back(input_error("{}", words).at({{}, 0, fmt::format("shots[{}].{}", i, key)}));
    };
    if (is_hidden) {
      warn("at", "another shot begins at the same time, so that this one is never seen");
    } else if (begins + shot.move > ends + 1e-9) {
      warn("move",
           fmt::format("the camera needs {:.4g} s to get there, but has {:.4g} s",
                       shot.move,
                       ends - begins));
    }
  }
  return found;
}

std::vector<Error> Composer::warnings() const {
  std::vector<Error> found = warnings_of_shots();
  const Paths& paths = scenery_.paths;
  const auto is_coarse = [](const Trail& trail) {
    return trail.coarse();
  };
  const auto any_coarse = [&](const std::vector<Trail>& trails) {
    return std::any_of(trails.begin(), trails.end(), is_coarse);
  };
  if (is_coarse(paths.axis) || is_coarse(paths.omega_tip) || is_coarse(paths.momentum_tip) ||
      is_coarse(paths.herpolhode) || any_coarse(paths.points) || any_coarse(paths.contact) ||
      any_coarse(paths.contact_on_body)) {
    found.push_back(input_error("the motion is too long for its path, which is drawn with corners "
                                "from some time on; shorten it")
                        .at({{}, 0, "motion.duration"}));
  }
  if (const std::optional<Error> unseen = warning_of_unseen()) found.push_back(*unseen);
  return found;
}

std::optional<Error> Composer::warning_of_unseen() const {
  for (const char* element : {"contact", "slip"}) {
    if (!asks_for(scenery_, element)) continue;
    if (scenery_.motion.contact_at(0.0)) continue;
    return input_error("shows nothing: only the method dop853 tells what touches the table")
        .at({{}, 0, fmt::format("show.{}", element)});
  }
  std::vector<bool> seen(rigs_.size(), false), used(rigs_.size(), false);
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t nearest_rig = 0;
  std::vector<double> largest(rigs_.size(), 0.0);  // pixels
  double body = 0.0;  // how far it reaches from its reference point, m; points shown may be farther
  for (const Vec3& point_B : scenery_.hull_B)
    body = std::max(body, (point_B - scenery_.motion.model().reference_B()).norm());
  for (const double film : film_times()) {
    const Sample sample = scenery_.motion.at(staging_.timeline.motion_time(film));
    const Camera camera = camera_at(film);
    const std::size_t rig = rig_at(film);
    std::vector<Vec3> points;
    add_extent(glyphs_at(sample, film), points);
    points.push_back(sample.reference_S);
    used[rig] = true;
    seen[rig] = seen[rig] || std::any_of(points.begin(), points.end(), [&](const Vec3& point) {
                  return camera.sees(point);
                });
    const Vec3& middle = sample.reference_S;
    if (const double away = (camera.eye() - middle).norm(); away < nearest) {
      nearest = away;
      nearest_rig = rig;
    }
    // by the camera where it comes to rest: on its way there it may be nearer
    const Camera own = camera_at(film, rig);
    if (own.sees(middle))
      largest[rig] = std::max(largest[rig], body * own.pixels_per_metre(middle));
  }
  const auto key_of = [&](std::size_t rig) {
    return rigs_[rig].shot ? fmt::format("shots[{}].eye", *rigs_[rig].shot) : "camera.eye";
  };
  for (std::size_t rig = 0; rig < rigs_.size(); ++rig) {
    if (seen[rig] || !used[rig]) continue;
    return input_error(
               "the camera does not see the scene; without an eye it frames the film by itself")
        .at({{}, 0, key_of(rig)});
  }
  if (!shows("body")) return {};
  if (nearest < body) {
    return input_error(
               "the camera comes within {:.3g} m of the body's middle, but the body "
               "reaches {:.3g} m; move it away",
               nearest,
               body)
        .at({{}, 0, key_of(nearest_rig)});
  }
  for (std::size_t rig = 0; rig < rigs_.size(); ++rig) {
    if (largest[rig] == 0.0 || largest[rig] >= 1.0) continue;
    const std::optional<std::size_t>& shot = rigs_[rig].shot;
    return input_error(
               "the body, {:.3g} m, is never as large as a pixel; the motion or the points "
               "shown go too far, or the camera is too far away",
               body)
        .at({{}, 0, shot ? fmt::format("shots[{}]", *shot) : "camera"});
  }
  return {};
}

}  // namespace polhode
