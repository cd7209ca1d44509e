// SPDX-License-Identifier: MIT
// Frames of 8 by 6 pixels, and the job of a sink that takes them.
#pragma once

#include <cstdint>
#include <string>

#include "image/image.h"
#include "video/frame_sink.h"

namespace polhode::test {

// a frame of one value that is another for each of the first 36
inline Image small_frame(int index) {
  Image image(8, 6);
  for (std::uint8_t& value : image.pixels)
    value = static_cast<std::uint8_t>(index * 7 + 1);
  return image;
}

inline SinkJob small_job(const std::string& output) {
  SinkJob job;
  job.output = output;
  job.width = 8;
  job.height = 6;
  job.transparent = true;
  return job;
}

}  // namespace polhode::test
