// SPDX-License-Identifier: MIT
// Captions of a story as WebVTT beside a film.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "video/frame_sink.h"

namespace polhode {

// A WebVTT file (W3C candidate recommendation, 2019): a cue for each caption, its times those of
// its frames, its words escaped.
std::string web_vtt(const std::vector<FilmMetadata::Caption>& captions, const FrameRate& fps);

// The file of captions beside a film of that name, NAME.vtt; empty where none is written.
std::string captions_beside(const std::string& output);

// The same sink, which also writes captions_beside(job.output) when the film has captions. The two
// files get their names together, the film first; without the film there are no captions.
std::unique_ptr<FrameSink> with_captions(std::unique_ptr<FrameSink> film, const SinkJob& job);

}  // namespace polhode
