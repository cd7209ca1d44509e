// SPDX-License-Identifier: MIT
// Writes the captions of a story to a WebVTT file beside a film.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "video/frame_sink.h"

namespace polhode {

// The text of a WebVTT file (W3C Candidate Recommendation, 2019): one cue per caption that is not
// blank and has at least one frame, from the time of its first frame to that of the frame after its
// last, with its text escaped.
std::string web_vtt(const std::vector<FilmMetadata::Caption>& captions, const FrameRate& fps);

// The name of the caption file of an output, NAME.vtt; empty for formats without captions, which
// are all but .mp4, .webm and .mov.
std::string captions_beside(const std::string& output);

// Wraps a film sink (not null) so that it also writes captions_beside(job.output), which must not
// be empty, if the film has captions. The caption file gets its name right after the film;
// describe() claims it and throws Error (input) as AtomicFile does and (environment) if it cannot
// be written, finish() (environment) if it cannot be renamed.
std::unique_ptr<FrameSink> with_captions(std::unique_ptr<FrameSink> film, const SinkJob& job);

}  // namespace polhode
