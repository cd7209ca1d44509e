// SPDX-License-Identifier: MIT
#include "film/film_panels.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "film/error_places.h"
#include "film/stage.h"

namespace polhode {
namespace {

// "space" and "body" as headings
std::string heading_of(const std::string& view) {
  return view == "body" ? "In body axes" : "In space";
}

std::function<PanelNotes(double)> heading(const std::string& text) {
  return [text](double) {
    PanelNotes notes;
    notes.name = text;
    return notes;
  };
}

std::vector<FilmPanel> panels_of_views(const Solved& solved,
                                       const Stage& stage,
                                       const std::vector<PixelBox>& places) {
  const Scene& scene = solved.scene;
  std::vector<FilmPanel> panels;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string& view = scene.show.views[i];
    const Staging staging = seen_from(view, staging_of(scene, stage));
    panels.push_back({places[i], composer_of(solved, staging, places[i]), scene.motion.duration});
    if (stage.rows.name) panels.back().notes = heading(heading_of(view));
  }
  return panels;
}

std::vector<FilmPanel> panels_of_methods(const Solved& solved,
                                         const Comparison& comparison,
                                         const Stage& stage,
                                         const std::vector<PixelBox>& places) {
  const Scene& scene = solved.scene;
  const Staging staging = seen_from(scene.show.views.front(), staging_of(scene, stage));
  std::vector<FilmPanel> panels;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Contender& one = comparison.contenders()[i];
    const auto exact = composer_of(solved, staging, places[i]);
    const auto fails = one.failure.empty() ? std::nullopt : std::optional(one.end);
    const Motion motion = one.motion.until(solved.simulation.motion.duration());
    panels.push_back({places[i], std::make_shared<const Composer>(*exact, motion, fails), one.end});
    if (!stage.rows.name) continue;
    const bool with_details = stage.rows.details > 0;
    panels.back().notes = [&comparison, &one, with_details](double t) {
      return comparison.notes(one, t, with_details);
    };
  }
  return panels;
}

// the scale that serves all
Scale scale_of(const std::vector<Solved>& solved) {
  constexpr int kCoarse = 24;  // pieces of a circle, which scales do not depend on
  std::vector<Scale> scales;
  for (const Solved& one : solved) {
    const Scene& scene = one.scene;
    scales.push_back(
        make_scenery(one.simulation.motion, scene.body, scene.theme, scene.show, kCoarse).scale);
  }
  return common_scale(scales);
}

std::vector<FilmPanel> panels_of_scenes(const std::vector<Solved>& solved,
                                        const Stage& stage,
                                        const std::vector<PixelBox>& places) {
  const Scene& first = solved.front().scene;
  Shared shared;
  if (first.same_scales) shared.scale = scale_of(solved);
  std::vector<FilmPanel> panels;
  const auto composer = [&](std::size_t i) {
    const Scene& scene = solved[i].scene;
    return with_place(scene, [&] {
      const Staging staging = seen_from(scene.show.views.front(),
                                        staging_of(first.same_cameras ? first : scene, stage));
      return composer_of(solved[i], staging, places[i], shared);
    });
  };
  for (std::size_t i = 0; i < solved.size(); ++i) {
    panels.push_back({places[i], composer(i), solved[i].scene.motion.duration});
    if (stage.rows.name) panels.back().notes = heading(first.panels[i].caption);
  }
  if (!first.same_cameras) return panels;
  // once more, by cameras that show the bodies of all panels
  std::vector<std::shared_ptr<const Composer>> alone;
  alone.reserve(panels.size());
  for (const FilmPanel& panel : panels)
    alone.push_back(panel.composer);
  for (std::size_t i = 0; i < solved.size(); ++i) {
    shared.beside = alone;
    shared.beside.erase(shared.beside.begin() + static_cast<std::ptrdiff_t>(i));
    panels[i].composer = composer(i);
  }
  return panels;
}

}  // namespace

Film make_film(const std::vector<Solved>& solved,
               const Timeline& timeline,
               const Comparison* comparison,
               const FilmCharts& charts,
               bool with_text) {
  const Scene& scene = solved.front().scene;
  // panels in turn have a clock each, and the film one of all
  const Timeline own = scene.in_turn
                           ? Timeline(scene.story, scene.motion.duration, scene.video.time_scale)
                           : timeline;
  const PictureSize size = scene.video.size;
  const FilmText text = text_of(scene, with_text);
  if (comparison != nullptr && charts.count() > 0) {
    throw input_error("plots show one motion, not several that are compared; remove them")
        .at({{}, 0, "show.plots"});
  }
  if (comparison != nullptr && scene.show.views.size() > 1)
    throw input_error("methods are compared from one view").at({{}, 0, "show.views"});
  const std::size_t count = solved.size() > 1       ? solved.size()
                            : comparison != nullptr ? comparison->contenders().size()
                                                    : scene.show.views.size();
  const std::size_t beside = scene.in_turn ? 1 : count;
  FrameAreas areas = frame_areas(text, size, static_cast<int>(beside), charts.count());
  areas.panels.resize(count, areas.panels.front());
  NoteRows rows;
  if (with_text && comparison != nullptr) {
    rows = Comparison::note_rows(scene.show.details.value_or(false));
  } else {
    rows.name = with_text && count > 1;
  }
  const Stage stage{own, common_margins(text, areas.panels, size, rows), rows};
  std::vector<FilmPanel> panels =
      solved.size() > 1       ? panels_of_scenes(solved, stage, areas.panels)
      : comparison != nullptr ? panels_of_methods(solved.front(), *comparison, stage, areas.panels)
                              : panels_of_views(solved.front(), stage, areas.panels);
  for (FilmPanel& panel : panels)
    panel.rows = rows;
  return {std::move(panels),
          text,
          size,
          charts,
          scene.in_turn ? std::optional(timeline) : std::nullopt};
}

}  // namespace polhode
