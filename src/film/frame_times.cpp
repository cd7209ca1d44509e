// SPDX-License-Identifier: MIT
#include "film/frame_times.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"

namespace polhode {
namespace {

constexpr double kMostFrames = 1e7;

double time_option(const char* option,
                   const std::optional<double>& value,
                   double fallback,
                   double duration) {
  const double t = up_to(duration, value.value_or(fallback));
  if (std::isfinite(t) && t >= 0.0 && t <= duration) return t;
  throw input_error("must be a time within the motion, 0 to {} s, got {}", duration, t)
      .at({{}, 0, option});
}

void refuse_too_many_frames(double count) {
  if (count > kMostFrames) {
    throw input_error(
        "the film would have {:.3g} frames; choose a shorter range or a larger video.time_scale",
        count);
  }
}

Error behind(const Loop& loop, double time) {
  return input_error(
      "the loop closes after {:.6g} s of the motion, so the film never shows {} s; choose an "
      "earlier time, or make the film without a loop",
      loop.duration,
      time);
}

// a story that the whole motion could tell
void refuse_steps_behind(const Loop& loop, const Scene& scene) {
  for (std::size_t i = 0; i < scene.story.size(); ++i) {
    const double at = scene.story[i].at;
    if (at <= loop.duration || at > scene.motion.duration) continue;
    throw behind(loop, at).at({{}, 0, fmt::format("story[{}].at", i)});
  }
}

}  // namespace

int FrameTimes::frame_at(double film) const {
  const double frame = std::ceil((film - kFilmRounding - first) * rate);
  return static_cast<int>(std::clamp(frame, -1e9, static_cast<double>(count)));
}

std::vector<StoryStep> story_of_film(const Scene& scene, const std::vector<StoryStep>& story) {
  for (std::size_t i = 0; scene.in_turn && i < story.size(); ++i) {
    if (up_to(scene.motion.duration, story[i].at) <= scene.motion.duration) continue;
    throw input_error("must be a time within each panel's motion, 0 to {} s, got {}",
                      scene.motion.duration,
                      story[i].at)
        .at({{}, 0, fmt::format("story[{}].at", i)});
  }
  std::vector<StoryStep> whole = story;
  for (std::size_t i = 1; scene.in_turn && !story.empty() && i < scene.panels.size(); ++i) {
    StoryStep begins;  // without the words of the panel before
    begins.at = static_cast<double>(i) * scene.motion.duration;
    begins.caption = "";
    whole.push_back(begins);
    for (StoryStep step : story) {
      step.at += static_cast<double>(i) * scene.motion.duration;
      whole.push_back(step);
    }
  }
  return whole;
}

void check_time_range(const Scene& scene, const TimeRange& range) {
  const double duration = shown_duration(scene);
  const double from = time_option("--from", range.from, 0.0, duration);
  const double to = time_option("--to", range.to, duration, duration);
  if (range.one_picture) {
    time_option("--still", range.still, from, duration);
    if (range.to) throw input_error("a picture shows one time; omit it").at({{}, 0, "--to"});
    if (range.still && range.from)
      throw input_error("--still says which time a picture shows; omit it").at({{}, 0, "--from"});
    return;
  }
  if (to <= from)
    throw input_error("must be later than --from ({} s), got {}", from, to).at({{}, 0, "--to"});
  const double count = (to - from) / scene.video.time_scale * scene.video.fps.value();
  refuse_too_many_frames(count);
}

// times that only the whole motion has
void refuse_times_behind(const Loop& loop, const TimeRange& range) {
  constexpr double kRounding = 1e-9;
  const auto refuse = [&](const char* option, const std::optional<double>& time) {
    if (time && *time > loop.duration * (1.0 + kRounding))
      throw behind(loop, *time).at({{}, 0, option});
  };
  refuse("--from", range.from);
  refuse("--still", range.still);
  refuse("--to", range.to);
}

FrameTimes plan_frame_times(const Solved& solved, const TimeRange& range) {
  const Scene& scene = solved.scene;
  FrameTimes frames;
  frames.rate = scene.video.fps.value();
  double duration = shown_duration(scene);
  double time_scale = scene.video.time_scale;
  if (scene.video.loop) {
    // a whole number of frames, the last one step before the first
    frames.loop = find_loop(solved.simulation.motion, duration, scene.video.loop_residual);
    refuse_steps_behind(*frames.loop, scene);
    refuse_times_behind(*frames.loop, range);
    duration = frames.loop->duration;
    const double count = std::max(1.0, std::round(duration / time_scale * frames.rate));
    time_scale = duration * frames.rate / count;
  }
  frames.timeline = Timeline(story_of_film(scene, scene.story), duration, time_scale);
  frames.from = std::min(range.from.value_or(0.0), duration);
  frames.to = std::min(range.to.value_or(duration), duration);
  if (range.one_picture) {
    frames.from = frames.to = std::min(range.still.value_or(frames.from), duration);
    frames.first = frames.timeline.film_time(frames.from);
    return frames;
  }
  frames.first = frames.timeline.first_film_time(frames.from);
  const double end = frames.to < duration ? frames.timeline.first_film_time(frames.to)
                                          : frames.timeline.film_duration();
  const double count = std::ceil((end - frames.first) * frames.rate - 1e-6);
  refuse_too_many_frames(count);
  frames.count = std::max(1, static_cast<int>(count));
  return frames;
}

Solved shown_part(Solved solved, const FrameTimes& frames) {
  if (!frames.loop) return solved;
  const double end = frames.loop->duration;
  solved.simulation.motion = solved.simulation.motion.until(end);
  for (Motion& member : solved.ensemble)
    member = member.until(end);
  return solved;
}

}  // namespace polhode
