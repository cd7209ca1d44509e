// SPDX-License-Identifier: MIT
// Films: the first frames, and the comment.
#include "base/error.h"
#include "fuzz/harness.h"
#include "video/film_joiner.h"
#include "video/film_reader.h"

namespace polhode {

void run_harness(const std::string& bytes) {
  const FileInMemory file(bytes);
  try {
    comment_of_film(file.name());
  } catch (const Error&) {
    // the reader of frames judges by itself
  }
  FilmReader reader(file.name());
  constexpr int kLargest = 1 << 18, kMostFrames = 4;
  const FilmInfo& info = reader.info();
  if (info.height > kLargest / info.width) return;
  Image frame;
  double time = 0.0;
  for (int i = 0; i < kMostFrames && reader.next(frame, time); ++i) {
    promise(frame.width == info.width && frame.height == info.height, "frames have one size");
  }
}

}  // namespace polhode
