// SPDX-License-Identifier: MIT
// What stands at the head of a film file: container, tags, chapters. Not for other libraries.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "video/encoders.h"
#include "video/frame_sink.h"
#include "video/libav/film_output.h"
#include "video/libav/libav.h"

namespace polhode {

// The container of that format, which writes to that output. Throws Error (environment).
Owned<AVFormatContext> open_container(const FilmFormat& format, const FilmOutput& output);

// Metadata; empty texts are left out.
void add_notes(AVFormatContext& muxer,
               const std::vector<std::pair<const char*, std::string>>& notes);

// A chapter from each start to the next. Frames become times by the rate.
void add_chapters(AVFormatContext& muxer, const FilmMetadata& metadata, const FrameRate& fps);

// Writes the header, with the format's own options.
void begin_film(AVFormatContext& muxer, const FilmFormat& format);

}  // namespace polhode
