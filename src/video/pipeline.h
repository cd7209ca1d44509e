// SPDX-License-Identifier: MIT
// Runs rendering and writing of frames on two threads.
#pragma once

#include <functional>

#include "image/image.h"
#include "video/frame_sink.h"

namespace polhode {

// Renders frame `index` into `image`, which is empty or holds an earlier frame, but for a rest.
using Produce = std::function<Retouch(int index, Image& image)>;

// Progress of the pipeline.
struct PipelineStep {
  int done = 0;  // frames rendered
  // recently the writer waited for frames at least as long as rendering waited for the writer
  bool writer_waits = true;
};

// Calls produce(0), produce(1), … on the calling thread; a second thread does the rest of the work
// on each frame and passes it to the sink. At most four frames wait between them. Then it calls
// sink.finish() on the calling thread. on_frame is called on the calling thread after each frame.
// sink.describe() must have been called before, if at all. on_frame must not be empty. An error on
// either thread stops the other and is thrown here without sink.finish(); if both fail, that of the
// calling thread is. Throws Error (interrupted) too.
void run_pipeline(int frames,
                  const Produce& produce,
                  FrameSink& sink,
                  const std::function<void(const PipelineStep&)>& on_frame);

}  // namespace polhode
