// SPDX-License-Identifier: MIT
// Turns a story into the metadata of a film: key frames, chapters, captions.
#pragma once

#include <vector>

#include "film/frame_times.h"
#include "video/frame_sink.h"

namespace polhode {

// The metadata: key frames at the beginning and end of pauses and at chapters; a chapter for each
// story step with a pause or a caption and for each named shot; one caption per story step that has
// one, until the next. Of several chapters that start at one frame, the first is kept; if none
// starts at frame 0, one with the scene's title, or "Start", is put before the others. Frame
// numbers count from the first of `frames`; a chapter or caption that began before it starts at 0.
// FilmMetadata::comment and first are left unset. `story` is the scene's story with its captions,
// which `scene` itself lacks if the picture shows no text.
FilmMetadata film_metadata(const Scene& scene,
                           const std::vector<StoryStep>& story,
                           const FrameTimes& frames);

}  // namespace polhode
