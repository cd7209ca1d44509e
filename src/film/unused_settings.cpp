// SPDX-License-Identifier: MIT
#include "film/unused_settings.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/ranges.h>

#include "base/system/log.h"
#include "film/error_places.h"

namespace polhode {
namespace {

// A key that changes only how some elements are drawn.
struct Modifier {
  std::string_view key;
  std::vector<std::string> elements;  // names of elements; any of them has a use for it
};

constexpr std::string_view kVectorLength = "show.vector_length";

const std::vector<Modifier>& modifiers() {
  static const std::vector<Modifier> table = {
      {"show.body_opacity", {"body"}},
      {"show.material", {"body", "ghosts", "ensemble"}},
      {"show.ghost_count", {"ghosts"}},
      {"show.ghost_interval", {"ghosts"}},
      {kVectorLength,
       {"omega",
        "momentum",
        "torque",
        "omega_components",
        "euler_rates",
        "sum",
        "space_cone",
        "body_cone",
        "precession_cone",
        "ellipsoid",
        "plane",
        "polhode",
        "polhodes",
        "herpolhode",
        "binet"}},
  };
  return table;
}

// A name that a scene may give, and the elements that have it.
struct GivenName {
  const char* key;
  std::optional<std::string> VectorNames::*name;
  std::vector<std::string> elements;
};

const std::vector<GivenName>& given_names() {
  static const std::vector<GivenName> table = {
      {"show.names.omega", &VectorNames::omega, {"omega"}},
      {"show.names.momentum", &VectorNames::momentum, {"momentum"}},
      {"show.names.torque", &VectorNames::torque, {"torque"}},
      {"show.names.gravity", &VectorNames::gravity, {"gravity"}},
      {"show.names.frame_rotation", &VectorNames::frame_rotation, {"frame_rotation"}},
      {"show.names.x", &VectorNames::x, {"space_axes", "fixed_frame"}},
      {"show.names.y", &VectorNames::y, {"space_axes", "fixed_frame"}},
      {"show.names.z", &VectorNames::z, {"space_axes", "fixed_frame"}},
  };
  return table;
}

// whether the torque on a body is more than round-off at any time
bool has_torque(const Motion& motion) {
  constexpr double kRounding = 1e-12;  // of twice the energy of turning
  for (const double t : framing_times(motion)) {
    const Sample now = motion.at(t);
    const std::optional<Vec3> torque_S = torque_at(motion, t);
    if (torque_S && torque_S->norm() > kRounding * now.w_S.dot(now.L_S)) return true;
  }
  return false;
}

// whether a path leads nowhere
bool stays(const Trail& trail, const Scenery& scenery) {
  constexpr double kNowhere = 1e-3;  // of the body's radius
  const std::vector<Vec3>& points = trail.path().points;
  return std::all_of(points.begin(), points.end(), [&](const Vec3& point) {
    return (point - points.front()).norm() < kNowhere * scenery.scale.body;
  });
}

bool is_given(const Scene& scene, std::string_view key) {
  const std::string name(key);
  return scene.lines.contains(name) || scene.options.contains(name);
}

using Composers = std::vector<std::shared_ptr<const Composer>>;

// Looks for unused settings of a scene.
class Search {
 public:
  Search(const Scene& scene, const Composers& composers, const std::vector<std::string>& views)
      : scene_(scene), composers_(composers), views_(views) {}

  std::vector<Error> found() {
    for (const auto& composer : composers_)
      end_ = std::max(end_, composer->scenery().motion.duration());
    found_ = unused_in_motion(scene_, end_);
    look_at_modifiers();
    look_at_names();
    look_at_paths();
    look_at_torque();
    look_at_curves();
    look_at_companions();
    look_at_cameras();
    look_at_story();
    return std::move(found_);
  }

 private:
  void tell(std::string_view key, const std::string& words) {
    found_.push_back(input_error("{}", words).at({{}, 0, std::string(key)}));
  }
  void tell_unshown(std::string_view key, const std::vector<std::string>& elements) {
    tell(key, fmt::format("changes nothing here: the film shows no {}", fmt::join(elements, ", ")));
  }
  // in any panel
  bool shows(const std::vector<std::string>& elements) const {
    return std::any_of(composers_.begin(), composers_.end(), [&](const auto& composer) {
      return std::any_of(elements.begin(), elements.end(), [&](const std::string& name) {
        return composer->shows(name);
      });
    });
  }

  bool asks_for(const std::string& element) const {
    return polhode::asks_for(composers_.front()->scenery(), element);
  }

  void look_at_modifiers() {
    for (const auto& [key, elements] : modifiers()) {
      if (!is_given(scene_, key) || shows(elements)) continue;
      // their ends are those of vectors
      if (key == kVectorLength && scene_.show.trail_tips) continue;
      tell_unshown(key, elements);
    }
  }

  void look_at_names() {
    if (!scene_.show.names) return;
    // without any text nobody expects them
    if (!scene_.show.labels) {
      if (!is_given(scene_, "show.labels")) return;
      tell("show.names", "changes nothing here: no names are shown (show.labels)");
      return;
    }
    for (const auto& [key, name, elements] : given_names()) {
      if ((*scene_.show.names.*name) && !shows(elements)) tell_unshown(key, elements);
    }
  }

  void look_at_paths() {
    const bool any = shows({"trail", "herpolhode", "contact_trail"}) ||
                     !scene_.show.trail_points.empty() || scene_.show.trail_tips;
    if (is_given(scene_, "show.trail_length") && !any)
      tell("show.trail_length", "changes nothing here: the film shows no paths");
    if (any && scene_.show.trail_s.value_or(0.0) > end_) {
      tell("show.trail_length",
           fmt::format("changes nothing here: all of what is shown takes {:.4g} s", end_));
    }
    if (shows({"ghosts"}) && scene_.show.ghost_s.value_or(0.0) >= end_) {
      tell("show.ghost_interval",
           fmt::format("no ghost is ever seen: all of what is shown takes {:.4g} s", end_));
    }
  }

  void look_at_torque() {
    if (!asks_for("torque")) return;
    const bool any = std::any_of(composers_.begin(), composers_.end(), [](const auto& composer) {
      return has_torque(composer->scenery().motion);
    });
    if (!any)
      tell("show.torque", "shows nothing: no torque acts, or the method does not tell it (table)");
  }

  // what stands still has no path
  void look_at_curves() {
    const auto look_at = [&](const char* element, const auto& is_point) {
      if (!asks_for(element)) return;
      const bool all = std::all_of(composers_.begin(), composers_.end(), [&](const auto& composer) {
        return is_point(composer->scenery());
      });
      if (all)
        tell(fmt::format("show.{}", element), "shows nothing: in this motion it is a single point");
    };
    look_at("trail", [](const Scenery& scenery) { return stays(scenery.paths.axis, scenery); });
    look_at("herpolhode",
            [](const Scenery& scenery) { return stays(scenery.paths.herpolhode, scenery); });
    look_at("polhode", [](const Scenery& scenery) { return scenery.paths.polhode == nullptr; });
  }

  // keys that belong to others
  void look_at_companions() {
    const bool compares = !scene_.numerics.compare.empty();
    if (compares && is_given(scene_, "numerics.method"))
      tell("numerics.method", "changes nothing here: numerics.compare names the methods");
    if (!compares && scene_.show.details)
      tell("show.details", "changes nothing here: it belongs to numerics.compare");
    if (scene_.motion.ensemble && !shows({"ensemble"}))
      tell("motion.ensemble", "changes nothing here: the film does not show it (show.ensemble)");
    if (!scene_.video.loop && is_given(scene_, "video.loop_residual"))
      tell("video.loop_residual", "changes nothing here: it belongs to video.loop");
  }

  // a view from the body turns with it, whatever the camera follows
  void look_at_cameras() {
    if (std::find(views_.begin(), views_.end(), "space") != views_.end()) return;
    const auto look_at = [&](const CameraSpec& camera, const std::string& key) {
      if (camera.follow != "auto" && camera.follow != "body")
        tell(key, "changes nothing here: all views are from the body (show.views)");
    };
    look_at(scene_.camera, "camera.follow");
    for (std::size_t i = 0; i < scene_.shots.size(); ++i)
      look_at(scene_.shots[i].camera, fmt::format("shots[{}].follow", i));
  }

  // what is replaced, or taken away without ever being there
  void look_at_story() {
    const bool cut =
        std::any_of(scene_.shots.begin(), scene_.shots.end(), [](const ShotSpec& shot) {
          return shot.at <= 0.0 && shot.move <= 0.0;
        });
    const bool pauses =
        std::any_of(scene_.story.begin(), scene_.story.end(), [](const StoryStep& step) {
          return step.at <= 0.0 && step.hold > 0.0;
        });
    if (const std::optional<std::string> key = first_given_in("camera."); cut && !pauses && key)
      tell(*key, "changes nothing here: a shot at 0 takes the place of this camera");
    for (std::size_t i = 0; i < scene_.story.size(); ++i) {
      const StoryStep& step = scene_.story[i];
      if (step.at <= 0.0 && step.caption && !scene_.show.caption.empty())
        tell("show.caption", "is never seen: a step of the story at 0 has another");
      for (const std::string& name : step.hide) {
        if (shows({name})) continue;
        tell(fmt::format("story[{}].hide", i),
             fmt::format("'{}' is not shown, so there is nothing to hide", name));
      }
    }
  }
  // of the keys of a table
  std::optional<std::string> first_given_in(std::string_view table) const {
    const auto in = [&](const auto& places) -> std::optional<std::string> {
      for (const auto& [key, place] : places) {
        if (key.starts_with(table)) return key;
      }
      return {};
    };
    const std::optional<std::string> by_option = in(scene_.options);
    return by_option ? by_option : in(scene_.lines);
  }

  const Scene& scene_;
  const Composers& composers_;
  const std::vector<std::string>& views_;
  double end_ = 0.0;  // s of motion: how far any panel goes
  std::vector<Error> found_;
};

}  // namespace

std::vector<Error> unused_in_motion(const Scene& scene, double end) {
  std::vector<Error> unused;
  const auto tell = [&](const std::string& key, const std::string& words) {
    unused.push_back(input_error("{}", words).at({{}, 0, key}));
  };
  // without hold = "pivot" it was perhaps meant to hold the body
  if (is_given(scene, "body.pivot") && scene.motion.hold != "pivot" &&
      scene.body.about != "pivot") {
    tell("body.pivot",
         fmt::format("changes nothing here: motion.hold is \"{}\", not \"pivot\"",
                     scene.motion.hold));
  }
  const auto method = scene.options.find("numerics.method");
  if (method != scene.options.end() && method->second.key == "--method") {
    const auto tell_left_out = [&](const std::string& name, const std::optional<double>& value) {
      if (value || !is_given(scene, "numerics." + name)) return;
      tell("numerics." + name,
           fmt::format("is left out, for --method names another method; --{} gives that one a {}",
                       name,
                       name));
    };
    tell_left_out("step", scene.numerics.step);
    tell_left_out("tolerance", scene.numerics.tolerance);
  }
  for (std::size_t i = 0; i < scene.motion.torque.size(); ++i) {
    if (scene.motion.torque[i].from.value_or(0.0) < end) continue;
    tell(fmt::format("motion.torque[{}].from", i),
         fmt::format("the motion ends before it, at {:.4g} s", end));
  }
  return unused;
}

void warn_of_unused_in_motion(const Scene& scene) {
  for (const Error& unused : unused_in_motion(scene, scene.motion.duration))
    spdlog::warn("{}", placed(scene, unused).what());
}

std::vector<Error> unused_settings(const Scene& scene,
                                   const std::vector<std::shared_ptr<const Composer>>& composers,
                                   const std::vector<std::string>& views) {
  return Search(scene, composers, views).found();
}

}  // namespace polhode
