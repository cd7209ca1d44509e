// SPDX-License-Identifier: MIT
// Writes films with libavcodec, libavformat and libswscale.
#pragma once

#include "video/frame_sink.h"

namespace polhode {

// A sink for a film in the format of the ending of job.output (video/encoders.h): BT.709,
// converted and tagged, for YUV pixel formats; constant frame rate; closed groups of pictures of
// at most a second; key frames where the metadata ask for them (but libsvtav1 sets none there);
// the index before the data in MP4 and MOV; straight alpha. Throws Error as FilmWriter
// (video/libav/film_writer.h) does: (input) as AtomicFile (base/system/atomic_file.h) does, for a
// codec that the format does not allow, if a side is odd and the format has subsampled colour, and
// for standard output that is a terminal; (environment) if the encoder is missing or does not
// open. push() and finish() throw Error (environment) if the disk is full or the pipe is closed,
// and (interrupted).
std::unique_ptr<FrameSink> make_film_sink(const SinkJob& job);

// FFmpeg's version as the installed libraries report it.
std::string libav_version();
// The versions of libavcodec, libavformat, libavutil and libswscale found at run time, as in
// "libavcodec 59.37.100", separated by commas.
std::string libav_parts();

}  // namespace polhode
