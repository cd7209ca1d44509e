// SPDX-License-Identifier: MIT
// Reports of `render`, which `verify` reads. Those of other versions are refused at once, so every
// report is made one of this version.
#include "film/report/motion_report.h"
#include "film/report/reported_film.h"
#include "fuzz/harness.h"
#include "scene/scene.h"

namespace polhode {

void run_harness(const std::string& bytes) {
  constexpr int kDeepest = 100;
  bool deep = false;
  const auto look = [&](int depth, Json::parse_event_t, Json&) {
    deep = deep || depth > kDeepest;
    return !deep;
  };
  Json report = Json::parse(bytes, look, false);
  std::string text = bytes;
  if (report.is_object() && !deep) {
    report["versions"] = versions();
    text = report.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  const FileInMemory file(text);
  const ReportedFilm film = read_report(file.name());
  promise(film.broken || !scene_hash(film.plan.scene).empty(), "a report has a scene");
}

}  // namespace polhode
