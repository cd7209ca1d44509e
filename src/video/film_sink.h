// SPDX-License-Identifier: MIT
// Writes films with libavcodec, libavformat and libswscale.
#pragma once

#include "video/frame_sink.h"

namespace polhode {

// A sink for a film in the format of the ending of job.output (video/encoders.h): BT.709, converted
// and tagged; constant frame rate; closed groups of pictures of at most a second; key frames where
// the metadata ask for them; index before the data; straight alpha. Throws Error as FilmWriter
// does, with the output as place: (input) as AtomicFile does, for a codec that the format does not
// allow, and if a side is odd and the format has subsampled colour; (environment) if the encoder is
// missing or does not open. Its members throw Error (environment) if the disk is full or the pipe
// is closed.
std::unique_ptr<FrameSink> make_film_sink(const SinkJob& job);

// FFmpeg's version as it reports it.
std::string libav_version();
// The versions of FFmpeg's libraries found at run time: "libavcodec 59.37.100, …".
std::string libav_parts();

}  // namespace polhode
