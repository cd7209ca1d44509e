// SPDX-License-Identifier: MIT
#include "film/unused_settings.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/ranges.h>

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
      {"show.names.omega", {"omega"}},
      {"show.names.momentum", {"momentum"}},
      {"show.names.torque", {"torque"}},
      {"show.names.gravity", {"gravity"}},
      {"show.names.frame_rotation", {"frame_rotation"}},
      {"show.names.x", {"space_axes", "fixed_frame"}},
      {"show.names.y", {"space_axes", "fixed_frame"}},
      {"show.names.z", {"space_axes", "fixed_frame"}},
  };
  return table;
}

bool is_given(const Scene& scene, const std::string& key) {
  return scene.lines.contains(key) || scene.options.contains(key);
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

bool has_paths(const Paths& paths) {
  return !paths.points.empty() || !paths.omega_tip.empty() || !paths.momentum_tip.empty();
}

}  // namespace

std::vector<Error> unused_settings(const Scene& scene,
                                   const std::vector<std::shared_ptr<const Composer>>& composers) {
  std::vector<Error> unused;
  const auto tell = [&](const std::string& key, const std::string& words) {
    unused.push_back(input_error("{}", words).at({{}, 0, key}));
  };
  const auto shows_any = [&](const std::vector<std::string>& elements) {
    return std::any_of(composers.begin(), composers.end(), [&](const auto& composer) {
      return std::any_of(elements.begin(), elements.end(), [&](const std::string& name) {
        return composer->shows(name);
      });
    });
  };
  for (const auto& [key, elements] : modifiers()) {
    if (!is_given(scene, std::string(key)) || shows_any(elements)) continue;
    if (key == kVectorLength && scene.show.trail_tips) continue;  // their ends are those of vectors
    tell(std::string(key),
         fmt::format("changes nothing here: the film shows no {}", fmt::join(elements, ", ")));
  }
  const bool any_path = shows_any({"trail", "herpolhode", "contact_trail"}) ||
                        std::any_of(composers.begin(), composers.end(), [](const auto& composer) {
                          return has_paths(composer->scenery().paths);
                        });
  if (is_given(scene, "show.trail_length") && !any_path)
    tell("show.trail_length", "changes nothing here: the film shows no paths");
  const auto torque = scene.show.asked.find("torque");
  if (torque != scene.show.asked.end() && torque->second.value_or(false) &&
      std::none_of(composers.begin(), composers.end(), [](const auto& composer) {
        return has_torque(composer->scenery().motion);
      })) {
    tell("show.torque", "shows nothing: no torque acts, or the method does not tell it (table)");
  }
  const std::vector<std::string>& compared = scene.numerics.compare;
  if (!compared.empty() && is_given(scene, "numerics.method"))
    tell("numerics.method", "changes nothing here: numerics.compare names the methods");
  if (scene.show.details && compared.empty())
    tell("show.details", "changes nothing here: it belongs to numerics.compare");
  if (scene.show.title && scene.title.empty())
    tell("show.title", "shows nothing: the scene has no title");
  if (is_given(scene, "video.loop_residual") && !scene.video.loop)
    tell("video.loop_residual", "changes nothing here: it belongs to video.loop");
  // a view from the body turns with it, whatever the camera follows
  const std::vector<std::string>& views = scene.show.views;
  if (std::find(views.begin(), views.end(), "space") != views.end()) return unused;
  const auto look_at_camera = [&](const CameraSpec& camera, const std::string& key) {
    if (camera.follow != "auto" && camera.follow != "body")
      tell(key, "changes nothing here: all views are from the body (show.views)");
  };
  look_at_camera(scene.camera, "camera.follow");
  for (std::size_t i = 0; i < scene.shots.size(); ++i)
    look_at_camera(scene.shots[i].camera, fmt::format("shots[{}].follow", i));
  return unused;
}

}  // namespace polhode
