// SPDX-License-Identifier: MIT
#include "export/recomputed.h"

#include <exception>
#include <optional>

#include "base/error.h"
#include "base/json.h"
#include "export/gltf_file.h"
#include "export/gltf_scene.h"
#include "export/viewer_data.h"
#include "film/error_places.h"
#include "film/overrides.h"
#include "film/solving.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

template <class Value>
std::optional<Value> given(const Json& request, const char* key) {
  const auto found = request.find(key);
  if (found == request.end() || found->is_null()) return {};
  return found->get<Value>();
}

Overrides overrides_in(const Json& request) {
  Overrides overrides;
  for (const Json& setting : request.at("settings"))
    overrides.settings.push_back({setting.at(0), setting.at(1)});
  overrides.method = given<std::string>(request, "method");
  overrides.size = given<std::string>(request, "size");
  overrides.fps = given<std::string>(request, "fps");
  overrides.theme = given<std::string>(request, "theme");
  overrides.step = given<double>(request, "step");
  return overrides;
}

std::string framed(const Json& about, const std::string& glb) {
  const std::string text = about.dump(-1, ' ', true, Json::error_handler_t::replace);
  std::string answer;
  for (int i = 0; i < 4; ++i)
    answer += static_cast<char>((text.size() >> (8 * i)) & 0xffu);
  return answer + text + glb;
}

std::string answer_to(const Json& request) {
  const Scene scene = parse_with_overrides(request.at("scene").get<std::string>(),
                                           request.at("name").get<std::string>(),
                                           overrides_in(request));
  Json about = {{"doubts", Json::array()}};
  const auto note = [&](const Error& doubt) {
    about["doubts"].push_back(doubt.what());
  };
  const Solved solved = solve_watched(scene, {note, {}});
  ExportPlan plan;
  plan.from = given<double>(request, "from");
  plan.to = given<double>(request, "to");
  plan.author = given<std::string>(request, "author").value_or("");
  plan.licence = given<std::string>(request, "licence").value_or("");
  const ExportedScene exported = with_place(scene, [&] { return export_scene(solved, plan); });
  about["viewer"] =
      viewer_data(solved, plan.from.value_or(0.0), plan.to.value_or(scene.motion.duration));
  return framed(about, glb_of(exported.document));
}

}  // namespace

std::string recomputed(std::string_view request) {
  try {
    return answer_to(Json::parse(request));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return framed({{"error", error.what()}}, "");
  }
}

}  // namespace polhode
