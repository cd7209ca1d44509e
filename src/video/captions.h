// SPDX-License-Identifier: MIT
// Writes the captions of a story to a WebVTT file beside a film.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/system/atomic_file.h"
#include "video/frame_sink.h"

namespace polhode {

// The text of a WebVTT file (W3C Candidate Recommendation, 2019): a first line that says that
// polhode wrote it, and one cue per caption that is not blank and has at least one frame, from the
// time of its first frame to that of the frame after its last, with its text escaped.
std::string web_vtt(const std::vector<FilmMetadata::Caption>& captions, const FrameRate& fps);

// The name of the caption file of an output, NAME.vtt; empty for formats without captions, which
// are all but .mp4, .webm and .mov.
std::string captions_beside(const std::string& output);

// The caption file of a film, captions_beside(film), which must not be empty. Claimed as an
// AtomicFile (base/system/atomic_file.h); without commit() nothing changes.
class CaptionFile {
 public:
  // Claims the file now if captions are expected, else when they are written. Throws Error (input)
  // as AtomicFile does, and if the name belongs to a file that polhode has not written.
  CaptionFile(const std::string& film, bool expected);
  // Writes the captions; without any, the film will have no caption file. Throws Error (input) as
  // AtomicFile does, if captions were not expected, and (environment) if writing fails.
  void write(const std::vector<FilmMetadata::Caption>& captions, const FrameRate& fps);
  // Gives the file its name; call it once, when the film has its own. If no captions were written,
  // removes those that polhode wrote for an earlier film of this name; a file that polhode did not
  // write is left alone, as is one beside a film of another format. A warning tells when that film
  // has other captions now, or may have those that stay. Throws Error (environment) if that fails.
  void commit();

 private:
  void claim();
  std::string film_, name_;
  std::optional<AtomicFile> file_;
  std::string text_;  // empty until it is written
};

// Wraps a film sink (not null) so that it also has a CaptionFile beside job.output, claimed now if
// job.captions says so and it is no segment, which has no captions. Throws Error (input) as
// CaptionFile does; describe() throws Error as CaptionFile::write() does, finish() as
// CaptionFile::commit().
std::unique_ptr<FrameSink> with_captions(std::unique_ptr<FrameSink> film, const SinkJob& job);

}  // namespace polhode
