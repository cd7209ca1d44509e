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

// The functions throw Error (environment) without memory, if libav lacks the container or one of
// its options, and otherwise as check_libav does.

// A muxer of that format that writes to `output`, which must outlive it.
Owned<AVFormatContext> open_container(const FilmFormat& format, const FilmOutput& output);

// Adds metadata, pairs of libav's key and a text; empty texts are left out.
void add_notes(AVFormatContext& muxer,
               const std::vector<std::pair<const char*, std::string>>& notes);

// Adds the chapters. Each lasts until the next one starts, the last until metadata.frames; fps
// converts frames to times.
void add_chapters(AVFormatContext& muxer, const FilmMetadata& metadata, const FrameRate& fps);

// Writes the header with the options of the format.
void begin_film(AVFormatContext& muxer, const FilmFormat& format);

}  // namespace polhode
