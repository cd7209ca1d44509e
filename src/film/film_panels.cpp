// SPDX-License-Identifier: MIT
#include "film/film_panels.h"

#include <algorithm>
#include <utility>

namespace polhode {
namespace {

// the margins that serve all panels, so that they can share a camera
FrameMargins common_margins(const FilmText& text,
                            const std::vector<PixelBox>& places,
                            PictureSize size,
                            const NoteRows& rows) {
  FrameMargins margins;
  for (const PixelBox& place : places) {
    const FrameMargins needed = text_margins(text, place, size, rows);
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

Film make_film(const Solved& solved,
               const Timeline& timeline,
               const Comparison* comparison,
               const std::vector<FilmPlot>& plots,
               bool with_text) {
  const Scene& scene = solved.scene;
  const PictureSize size = scene.video.size;
  FilmText text = film_text(scene.show, scene.title, scene.video.time_scale);
  text.captions =
      with_text && std::any_of(scene.story.begin(), scene.story.end(), [](const auto& step) {
        return step.caption && !step.caption->empty();
      });
  const std::vector<std::string>& views = scene.show.views;
  const bool compared = comparison != nullptr;
  const std::size_t count = compared ? comparison->contenders().size() : views.size();
  const FrameAreas areas =
      frame_areas(text, size, static_cast<int>(count), static_cast<int>(plots.size()));
  const std::vector<PixelBox>& places = areas.panels;
  NoteRows rows;
  if (with_text && compared) rows = Comparison::note_rows(scene.show.details.value_or(false));
  if (with_text && !compared) rows.name = views.size() > 1;
  const FrameMargins margins = common_margins(text, places, size, rows);
  if (compared && !plots.empty()) {
    throw input_error("plots show one motion, not several that are compared; remove them")
        .at({{}, 0, "show.plots"});
  }

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
    panel.composer =
        std::make_shared<const Composer>(solved.simulation.motion,
                                         scene.body,
                                         staging,
                                         scene.show,
                                         scene.theme,
                                         PictureSize{places[i].width, places[i].height});
    panel.end = scene.motion.duration;
    panel.rows = rows;
    if (compared) {
      const Contender& one = comparison->contenders()[i];
      panel.composer = std::make_shared<const Composer>(*panel.composer, one.motion);
      panel.end = one.end;
      if (with_text) {
        panel.notes = [comparison, &one, rows](double t) {
          return comparison->notes(one, t, rows.details > 0);
        };
      }
    } else if (rows.name) {
      panel.notes = [heading = heading_of(views[i])](double) {
        PanelNotes notes;
        notes.name = heading;
        return notes;
      };
    }
    panels.push_back(std::move(panel));
  }
  return {std::move(panels), text, size, plots};
}

}  // namespace polhode
