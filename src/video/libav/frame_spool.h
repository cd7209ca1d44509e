// SPDX-License-Identifier: MIT
// Stores frames on disk until all are known. Private to video/.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>

#include "video/libav/libav.h"

namespace polhode {

// Frames are stored losslessly (FFV1) in a file without a name, so that it disappears with the
// process in any case. First all frames are pushed, then all are taken, in order. Not thread-safe.
// All members throw Error (environment).
class FrameSpool {
 public:
  // The file is in `folder`, which must be writable. Sizes in pixels; format: AV_PIX_FMT_BGRA or
  // AV_PIX_FMT_BGR0; threads: of the codec.
  FrameSpool(const std::filesystem::path& folder,
             int width,
             int height,
             AVPixelFormat format,
             int threads);

  // Stores a frame of that size and format.
  void push(const AVFrame& frame);
  // Ends pushing; take() starts at the first frame.
  void rewind();
  // The next frame, owned by this object and valid until the next call; null after the last.
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
