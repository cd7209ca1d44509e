// SPDX-License-Identifier: MIT
// Opens the container of a film and writes its header: tags and chapters. Private to video/.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "video/encoders.h"
#include "video/frame_sink.h"
#include "video/libav/film_output.h"
#include "video/libav/libav.h"

namespace polhode {

// A muxer of that format that writes to `output`. Throws Error (environment).
Owned<AVFormatContext> open_container(const FilmFormat& format, const FilmOutput& output);

// Adds metadata, {key, text}; empty texts are left out.
void add_notes(AVFormatContext& muxer,
               const std::vector<std::pair<const char*, std::string>>& notes);

// Adds the chapters. Each lasts until the next one starts; fps converts frames to times. Throws
// Error (environment) without memory.
void add_chapters(AVFormatContext& muxer, const FilmMetadata& metadata, const FrameRate& fps);

// Writes the header with the options of the format. Throws Error (environment).
void begin_film(AVFormatContext& muxer, const FilmFormat& format);

}  // namespace polhode
