// SPDX-License-Identifier: MIT
// Where the bytes of a film go: a file that appears when it is whole, or standard output.
#pragma once

#include <optional>
#include <string>

#include "base/system/atomic_file.h"

struct AVIOContext;

namespace polhode {

// The name of standard output as an output.
inline constexpr const char* kStandardOutput = "-";

// Invariant: without finish() a file leaves nothing behind. Writes to a pipe that nobody reads
// wait, but give up when the user interrupts.
class FilmOutput {
 public:
  // Throws Error as AtomicFile does, (input) when standard output is a terminal.
  explicit FilmOutput(const std::string& output);
  ~FilmOutput();
  FilmOutput(const FilmOutput&) = delete;
  FilmOutput& operator=(const FilmOutput&) = delete;

  // What libav writes to, and its name; empty for standard output.
  AVIOContext* stream() const { return stream_; }
  const std::string& url() const { return url_; }

  // All has been written: closes it, seals it with that text (video/seal.h), and gives it its name.
  // Throws Error (environment).
  void finish(const std::optional<std::string>& seal = std::nullopt);

 private:
  std::optional<AtomicFile> file_;
  std::string url_;
  AVIOContext* stream_ = nullptr;  // owned
};

}  // namespace polhode
