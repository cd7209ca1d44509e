// SPDX-License-Identifier: MIT
// Frames that wait on disk until the film is known. Not for other libraries.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>

#include "video/libav/libav.h"

namespace polhode {

// Lossless (FFV1) in a file that has no name, so that it vanishes with the process however that
// ends. First all frames are pushed, then all are taken, in order. All throw Error (environment).
class FrameSpool {
 public:
  // In that folder; frames of bgra or bgr0.
  FrameSpool(const std::filesystem::path& folder,
             int width,
             int height,
             AVPixelFormat format,
             int threads);

  void push(const AVFrame& frame);
  // No more will be pushed.
  void rewind();
  // The next frame, which holds until the next call; null after the last.
  AVFrame* take();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void encode(const AVFrame* frame);
  bool read_packet();

  std::unique_ptr<std::FILE, Close> file_;
  Owned<AVCodecContext> encoder_;
  Owned<AVCodecContext> decoder_;
  Owned<AVPacket> packet_;
  Owned<AVFrame> frame_;
};

}  // namespace polhode
