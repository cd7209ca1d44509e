// SPDX-License-Identifier: MIT
// Films that follow each other become one, without being encoded again.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "video/frame_sink.h"

namespace polhode {

// Claims the name of a film, and later fills it from pieces.
class FilmJoiner {
 public:
  // Throws Error (input) as AtomicFile does, and for an ending that is no film's.
  explicit FilmJoiner(const std::string& output);
  ~FilmJoiner();
  FilmJoiner(const FilmJoiner&) = delete;
  FilmJoiner& operator=(const FilmJoiner&) = delete;

  struct Part {
    std::string file;
    int frames = 0;  // that it must hold
  };
  // Copies the packets of all parts, in that order, each frame one step of the rate behind the one
  // before; title, comment and chapters are those given. Then the film has its name, and its
  // captions are beside it. Throws Error (input) when a part cannot be read, holds another number
  // of frames, or was encoded otherwise than the first; (environment) when it cannot be written.
  void join(const std::vector<Part>& parts,
            const FrameRate& fps,
            const std::string& title,
            const std::string& comment,
            const FilmMetadata& metadata);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

// The comment in a film's metadata; empty if there is none. Throws Error (input) when the file is
// missing or no film.
std::string comment_of_film(const std::string& file);

}  // namespace polhode
