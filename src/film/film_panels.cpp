// SPDX-License-Identifier: MIT
#include "film/film_panels.h"

#include <algorithm>
#include <utility>

#include "film/film_plots.h"

namespace polhode {
namespace {

// the margins that serve all panels, so that they can share a camera
FrameMargins common_margins(const FilmText& text,
                            const std::vector<PixelBox>& places,
                            PictureSize size,
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
  const std::vector<PixelBox> places = panel_places(size, static_cast<int>(count));
  const int lines = !with_text ? 0 : compared ? Comparison::kNoteLines : views.size() > 1 ? 1 : 0;
  FrameMargins margins = common_margins(text, places, size, lines);
  if (count > 1 && !scene.show.plots.empty()) {
    throw input_error("plots need a film with a single panel; remove them, or show one view")
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
    panel.composer =
        std::make_shared<const Composer>(solved.simulation.motion,
                                         scene.body,
                                         staging,
                                         scene.show,
                                         scene.theme,
                                         PictureSize{places[i].width, places[i].height});
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
