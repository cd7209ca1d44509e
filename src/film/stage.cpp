// SPDX-License-Identifier: MIT
#include "film/stage.h"

#include <algorithm>

namespace polhode {

FilmText text_of(const Scene& scene, bool with_text) {
  FilmText text = film_text(scene.show, scene.title, scene.video.time_scale);
  text.captions =
      with_text && std::any_of(scene.story.begin(), scene.story.end(), [](const auto& step) {
        return step.caption && !step.caption->empty();
      });
  return text;
}

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

Staging staging_of(const Scene& scene, const Stage& stage) {
  return {scene.camera, scene.shots, stage.timeline, stage.margins};
}

Staging seen_from(const std::string& view, Staging staging) {
  if (view == "body") {
    staging.camera.follow = "body";
    for (ShotSpec& shot : staging.shots)
      shot.camera.follow = "body";
  }
  return staging;
}

std::shared_ptr<const Composer> composer_of(const Solved& solved,
                                            const Staging& staging,
                                            const PixelBox& place,
                                            Shared shared) {
  shared.ensemble = solved.ensemble;
  return std::make_shared<const Composer>(solved.simulation.motion,
                                          solved.scene.body,
                                          staging,
                                          solved.scene.show,
                                          solved.scene.theme,
                                          PictureSize{place.width, place.height},
                                          shared);
}

std::shared_ptr<const Composer> composer_alone(const Solved& solved, const Timeline& timeline) {
  const Scene& scene = solved.scene;
  const PictureSize size = scene.video.size;
  const FilmText text = text_of(scene, true);
  const std::vector<PixelBox> places = frame_areas(text, size, 1, 0).panels;
  const Stage stage{timeline, common_margins(text, places, size, {}), {}};
  const Staging staging = seen_from(scene.show.views.front(), staging_of(scene, stage));
  return composer_of(solved, staging, places.front());
}

}  // namespace polhode
