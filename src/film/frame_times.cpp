// SPDX-License-Identifier: MIT
#include "film/frame_times.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "film/film_plots.h"

namespace polhode {
namespace {

constexpr double kMostFrames = 1e7;

double time_option(const char* option,
                   const std::optional<double>& value,
                   double fallback,
                   double duration) {
  const double t = value.value_or(fallback);
  if (std::isfinite(t) && t >= 0.0 && t <= duration) return t;
  throw input_error("must be a time within the motion, 0 to {} s, got {}", duration, t)
      .at({{}, 0, option});
}

void refuse_too_many_frames(double count) {
  if (count > kMostFrames) {
    throw input_error(
        "the film would have {:.3g} frames; take a shorter range or a larger video.time_scale",
        count);
  }
}

// the margins that serve all panels, so that they can share a camera
FrameMargins common_margins(const FilmText& text,
                            const std::vector<PixelBox>& places,
                            FrameSize size,
                            int note_lines) {
  FrameMargins margins;
  for (const PixelBox& place : places) {
    const FrameMargins needed = text_margins(text, place, size, note_lines);
    margins.left = std::max(margins.left, needed.left);
    margins.right = std::max(margins.right, needed.right);
    margins.top = std::max(margins.top, needed.top);
    margins.bottom = std::max(margins.bottom, needed.bottom);
  }
  return margins;
}

// "space" and "body" as headings
std::string heading_of(const std::string& view) {
  return view == "body" ? "In body axes" : "In space";
}

}  // namespace

void check_time_range(const Scene& scene, const TimeRange& range) {
  const double duration = scene.motion.duration;
  const double from = time_option("--from", range.from, 0.0, duration);
  const double to = time_option("--to", range.to, duration, duration);
  if (range.one_picture) {
    time_option("--still", range.still, from, duration);
    return;
  }
  if (to <= from)
    throw input_error("must be later than --from ({} s), got {}", from, to).at({{}, 0, "--to"});
  const double count = (to - from) / scene.video.time_scale * scene.video.fps.value();
  refuse_too_many_frames(count);
}

FrameTimes plan_frame_times(const Solved& solved, const TimeRange& range) {
  const Scene& scene = solved.scene;
  FrameTimes frames;
  frames.rate = scene.video.fps.value();
  double duration = scene.motion.duration;
  double time_scale = scene.video.time_scale;
  if (scene.video.loop) {
    // a whole number of frames, the last one step before the first
    frames.loop = find_loop(solved.simulation.motion, duration, scene.video.loop_residual);
    duration = frames.loop->duration;
    const double count = std::max(1.0, std::round(duration / time_scale * frames.rate));
    time_scale = duration * frames.rate / count;
  }
  frames.timeline = Timeline(scene.story, duration, time_scale);
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

Film make_film(const Solved& solved,
               const Timeline& timeline,
               const Comparison* comparison,
               const std::vector<FilmPlot>& plots,
               bool with_text) {
  const Scene& scene = solved.scene;
  const FrameSize size = frame_size(scene);
  FilmText text = film_text(scene.show, scene.title, scene.video.time_scale);
  text.captions =
      with_text && std::any_of(scene.story.begin(), scene.story.end(), [](const auto& step) {
        return step.caption && !step.caption->empty();
      });
  const std::vector<std::string>& views = scene.show.views;
  const bool compared = comparison != nullptr;
  const std::size_t count = compared ? comparison->contenders().size() : views.size();
  const std::vector<PixelBox> places = panel_places(size, static_cast<int>(count));
  const int lines = !with_text ? 0 : compared ? Comparison::kNoteLines : views.size() > 1 ? 1 : 0;
  FrameMargins margins = common_margins(text, places, size, lines);
  if (count > 1 && !scene.show.plots.empty()) {
    throw input_error("plots stand beside a single picture; leave them out, or show one view")
        .at({{}, 0, "show.plots"});
  }
  margins.right += width_of_plots(scene.show);

  std::vector<FilmPanel> panels;
  for (std::size_t i = 0; i < count; ++i) {
    Staging staging{scene.camera, scene.shots, timeline, margins};
    if (!compared && views[i] == "body") {
      staging.camera.follow = "body";
      for (ShotSpec& shot : staging.shots)
        shot.camera.follow = "body";
    }
    FilmPanel panel;
    panel.place = places[i];
    panel.composer = std::make_shared<const Composer>(solved.simulation.motion,
                                                      scene.body,
                                                      staging,
                                                      scene.show,
                                                      scene.theme,
                                                      FrameSize{places[i].width, places[i].height});
    panel.end = scene.motion.duration;
    if (compared) {
      const Contender& one = comparison->contenders()[i];
      panel.composer = std::make_shared<const Composer>(*panel.composer, one.motion);
      panel.end = one.end;
      if (with_text) {
        panel.notes = [comparison, &one](double t) {
          return comparison->notes(one, t);
        };
      }
    } else if (lines > 0) {
      panel.notes = [heading = heading_of(views[i])](double) {
        return PanelNotes{{heading}, ""};
      };
    }
    panels.push_back(std::move(panel));
  }
  return {std::move(panels), text, size, plots};
}

}  // namespace polhode
