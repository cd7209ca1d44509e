// SPDX-License-Identifier: MIT
// From a story to what a player can use: where to stop, chapters, captions.
#pragma once

#include <vector>

#include "film/frame_times.h"
#include "video/frame_sink.h"

namespace polhode {

// Key frames where a pause begins and ends and where a chapter starts; a chapter for each step of
// the story that pauses or says something and for each shot with a name; a caption for each words
// of the story. All of `frames`, counted from its first. `story` is the scene's, with its words.
FilmMetadata film_metadata(const Scene& scene,
                           const std::vector<StoryStep>& story,
                           const FrameTimes& frames);

}  // namespace polhode
