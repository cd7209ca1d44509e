// SPDX-License-Identifier: MIT
// Joins films to one film without re-encoding.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "video/frame_sink.h"

namespace polhode {

// Claims the name of a film, and later writes it from parts. Not thread-safe.
class FilmJoiner {
 public:
  // Throws Error (input) as AtomicFile does, and, with the output as place, for an ending other
  // than .mp4, .webm and .mov; (environment) if libav cannot open the file.
  explicit FilmJoiner(const std::string& output);
  ~FilmJoiner();
  FilmJoiner(const FilmJoiner&) = delete;
  FilmJoiner& operator=(const FilmJoiner&) = delete;

  struct Part {
    std::string file;
    int frames = 0;  // number of frames that it must contain
  };
  // Copies the packets of all parts in this order, with timestamps that increase by one frame each,
  // and adds title, comment and chapters. Then gives the film and, if there are captions, the
  // caption file their names. Called once, with at least one part. fps: of the film; title,
  // comment: stored in it; metadata: its chapters, captions and number of frames are used. Throws
  // Error (input), with the part as place, if a part cannot be read, has another number of frames
  // or a second track, or was encoded differently from the first, and as AtomicFile does for the
  // caption file; (environment), with the file as place, if the film or the caption file cannot be
  // written; (interrupted).
  void join(const std::vector<Part>& parts,
            const FrameRate& fps,
            const std::string& title,
            const std::string& comment,
            const FilmMetadata& metadata);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

// The comment in the metadata of a film; empty if there is none. Throws Error (input), with the
// file as place, if it is missing or not a film.
std::string comment_of_film(const std::string& file);

}  // namespace polhode
