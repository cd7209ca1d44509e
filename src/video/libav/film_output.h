// SPDX-License-Identifier: MIT
// The destination of a film's bytes: a file that appears when it is complete, or standard output.
#pragma once

#include <optional>
#include <string>

#include "base/system/atomic_file.h"

struct AVIOContext;

namespace polhode {

// Invariant: without finish(), no file remains. Writes block if nobody reads the pipe, until a
// signal interrupts them.
class FilmOutput {
 public:
  // `output`: a file name, or "-" for standard output. Throws Error as AtomicFile does, (input),
  // without a place, if standard output is a terminal, and (environment) if libav cannot open it.
  explicit FilmOutput(const std::string& output);
  ~FilmOutput();
  FilmOutput(const FilmOutput&) = delete;
  FilmOutput& operator=(const FilmOutput&) = delete;

  // The stream that libav writes to, owned by this object and open until finish(), and the URL of
  // its file; url() is empty for standard output.
  AVIOContext* stream() const { return stream_; }
  const std::string& url() const { return url_; }

  // Closes the file, appends a seal with that text (video/seal.h) if given, and gives the file its
  // name; for standard output it only flushes. Called once. Throws Error (environment) if writing
  // fails, as seal_file does, and (interrupted) as check_libav (video/libav/libav.h) does.
  void finish(const std::optional<std::string>& seal = std::nullopt);

 private:
  std::optional<AtomicFile> file_;
  std::string url_;
  AVIOContext* stream_ = nullptr;  // owned
};

}  // namespace polhode
