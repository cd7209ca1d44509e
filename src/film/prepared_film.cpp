// SPDX-License-Identifier: MIT
#include "film/prepared_film.h"

#include <utility>

#include "base/system/progress.h"
#include "film/error_places.h"
#include "film/film_panels.h"
#include "film/film_plots.h"
#include "film/film_warnings.h"
#include "film/stage.h"

namespace polhode {

PreparedFilm::PreparedFilm(const RenderPlan& plan) : text_(plan.text) {
  solved_.push_back(solve(plan.scene, plan.progress));
  for (std::size_t i = 1; i < plan.scene.panels.size(); ++i)
    solved_.push_back(solve(plan.scene.panels[i].scene, plan.progress));
  const Busy busy(plan.progress, "preparing the film");
  frames_ = with_place(plan.scene, [&] { return plan_frame_times(solved(), plan.range); });
  solved_.front() = shown_part(std::move(solved_.front()), frames_);
  const Scene& scene = solved().scene;
  if (!scene.numerics.compare.empty()) {
    comparison_ = std::make_unique<const Comparison>(solved(), frames_.motion_step());
  }
  const FilmCharts charts = with_place(scene, [&] { return make_charts(solved_); });
  film_ = with_place(scene, [&] {
    return std::make_unique<const Film>(
        make_film(solved_, frames_.timeline, comparison_.get(), charts, text_));
  });
  const double open_s = scene.video.shutter / (2.0 * kPi) / frames_.rate;
  shutter_ = Shutter(film_->panels(), frames_, open_s);
}

void PreparedFilm::warn() const {
  if (text_) {
    warn_of_missing_fonts();
    warn_of_missing_letters(solved_);
  }
  warn_of_film(solved_, frames_, *film_);
}

void check_film(Solved solved) {
  ShowSpec& show = solved.scene.show;
  for (const char* path : {"trail", "herpolhode", "contact_trail"})
    show.asked[path] = false;
  show.trail_points.clear();
  show.trail_tips = {};
  const std::vector<Solved> alone = {std::move(solved)};
  const Scene& scene = alone.front().scene;
  // of one picture: a motion may be too long for a film
  TimeRange one;
  one.one_picture = true;
  const FrameTimes frames = with_place(scene, [&] { return plan_frame_times(alone.front(), one); });
  with_place(scene, [&] { return composer_alone(alone.front(), frames.timeline); });
  check_charts(alone);
}

void check_charts(const std::vector<Solved>& panels) {
  with_place(panels.front().scene, [&] { return make_charts(panels); });
}

}  // namespace polhode
