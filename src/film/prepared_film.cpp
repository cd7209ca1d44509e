// SPDX-License-Identifier: MIT
#include "film/prepared_film.h"

#include <algorithm>
#include <cmath>

#include "base/system/log.h"
#include "film/film_plots.h"

namespace polhode {
namespace {

// the wheels of coaches in films
void warn_of_backward_turning(const Scene& scene, const Motion& motion, const FrameTimes& frames) {
  constexpr double kBlurring = kPi;  // an angle of the shutter beyond which nothing seems to turn
  if (frames.count < 2 || scene.video.shutter >= kBlurring) return;
  double fastest = 0.0;
  const int looks = std::min(frames.count, 200);
  for (int i = 0; i < looks; ++i) {
    const double t = frames.from + (frames.to - frames.from) * i / looks;
    fastest = std::max(fastest, motion.at(t).w_B.norm());
  }
  const std::optional<std::string> words =
      turns_backwards(fastest, scene.video.time_scale / frames.rate);
  if (!words) return;
  const Error warning = input_error(
      "{}: take a higher video.fps, a smaller video.time_scale, or blur it with "
      "video.shutter_deg = 360",
      *words);
  spdlog::warn("{}", placed(scene, warning.at({{}, 0, "video.fps"})).what());
}

void warn_of_missing_fonts() {
  for (const FontFound& font : examine_fonts()) {
    if (font.there) continue;
    spdlog::warn("the font {} is missing, {} serves instead; install {}",
                 font.wanted,
                 font.found.empty() ? "another" : font.found,
                 font.package);
  }
}

// as many as leave no gaps: the body turns by a few degrees from one to the next
int moments_of_shutter(const Motion& motion, const Scene& scene, double open) {
  constexpr double kTurn = 0.06;  // rad
  constexpr int kMost = 48;
  if (open <= 0.0) return 1;
  double fastest = 0.0;
  for (const double t : framing_times(motion))
    fastest = std::max(fastest, motion.at(t).w_B.norm());
  const double turned = fastest * open * scene.video.time_scale;
  return std::clamp(static_cast<int>(std::ceil(turned / kTurn)), 4, kMost);
}

void warn_of_open_loop(const Scene& scene, const FrameTimes& frames) {
  if (!frames.loop || frames.loop->residual <= scene.video.loop_residual) return;
  const Error warning = input_error(
      "the motion comes back to its start only to {:.2g} degrees (after {:.4g} s); give it a "
      "longer motion.duration to look in",
      frames.loop->residual * 180.0 / kPi,
      frames.loop->duration);
  spdlog::warn("{}", placed(scene, warning.at({{}, 0, "video.loop"})).what());
}

}  // namespace

PreparedFilm prepare_film(const RenderPlan& plan) {
  PreparedFilm basis{solve(plan.scene), {}};
  const Scene& scene = basis.solved.scene;
  basis.frames = with_place(scene, [&] { return plan_frame_times(basis.solved, plan.range); });
  if (!scene.numerics.compare.empty()) {
    basis.comparison = std::make_unique<const Comparison>(
        basis.solved, scene.video.time_scale / basis.frames.rate);
  }
  basis.plots = make_plots(basis.solved);
  return basis;
}

FilmFrames::FilmFrames(const RenderPlan& plan, const PreparedFilm& basis)
    : basis_(basis),
      text_(plan.text),
      film_(with_place(basis.solved.scene,
                       [&] {
                         return make_film(basis.solved,
                                          basis.frames.timeline,
                                          basis.comparison.get(),
                                          basis.plots,
                                          plan.text);
                       })),
      open_(basis.solved.scene.video.shutter / (2.0 * kPi) / basis.frames.rate),
      moments_(moments_of_shutter(basis.solved.simulation.motion, basis.solved.scene, open_)) {}

void FilmFrames::warn() const {
  const Scene& scene = basis_.solved.scene;
  if (text_) warn_of_missing_fonts();
  warn_of_open_loop(scene, basis_.frames);
  for (const Error& warning : film_.panels().front().composer->warnings()) {
    spdlog::warn("{}", placed(scene, warning).what());
  }
  warn_of_backward_turning(scene, basis_.solved.simulation.motion, basis_.frames);
}

}  // namespace polhode
