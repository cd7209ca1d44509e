// SPDX-License-Identifier: MIT
// Frames are made on one thread and written on another.
#pragma once

#include <functional>

#include "image/image.h"
#include "video/frame_sink.h"

namespace polhode {

// Fills `image` with frame `index`; the buffer is one that was used before, or empty.
using Produce = std::function<void(int index, Image& image)>;

// How far the work is.
struct PipelineStep {
  int done = 0;              // frames made
  bool writer_waits = true;  // of late the writer has waited for frames more than they for it
};

// Calls produce(0), produce(1), … on the calling thread and hands each frame to the sink on
// another, at most four frames ahead; then sink.finish(). on_frame is called on the calling
// thread. An error on either side stops the other and is thrown here; so is an interrupt.
void run_pipeline(int frames,
                  const Produce& produce,
                  FrameSink& sink,
                  const std::function<void(const PipelineStep&)>& on_frame);

}  // namespace polhode
