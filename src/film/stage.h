// SPDX-License-Identifier: MIT
// What the pictures of a solved scene are composed with: cameras, time, and the margins that text
// needs.
#pragma once

#include <memory>
#include <vector>

#include "film/solving.h"
#include "frame/compose.h"
#include "frame/layout.h"

namespace polhode {

// What all panels of a film have in common. The timeline must outlive it.
struct Stage {
  const Timeline& timeline;
  FrameMargins margins;
  NoteRows rows;
};

// The text of a film of that scene; with_text: with captions.
FilmText text_of(const Scene& scene, bool with_text);

// The margins that serve all panels, so that they can share a camera.
FrameMargins common_margins(const FilmText& text,
                            const std::vector<PixelBox>& places,
                            PictureSize size,
                            const NoteRows& rows);

Staging staging_of(const Scene& scene, const Stage& stage);

// The same seen from space or from the body: `view` is one of ShowSpec::views.
Staging seen_from(const std::string& view, Staging staging);

// The composer of one panel. Throws Error (input) as Composer does.
std::shared_ptr<const Composer> composer_of(const Solved& solved,
                                            const Staging& staging,
                                            const PixelBox& place,
                                            Shared shared = {});

// The composer of a film of the scene alone: in the first of its views, with the camera and the
// scales that `render` has, without plots. timeline: of the film. Throws Error (input) likewise.
std::shared_ptr<const Composer> composer_alone(const Solved& solved, const Timeline& timeline);

}  // namespace polhode
