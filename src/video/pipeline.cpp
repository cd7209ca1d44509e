// SPDX-License-Identifier: MIT
#include "video/pipeline.h"

#include <exception>
#include <thread>
#include <utility>

#include "base/system/bounded_queue.h"
#include "base/system/interrupt.h"

namespace polhode {
namespace {

constexpr std::size_t kFramesAhead = 4;

struct Frame {
  Image image;
  Retouch retouch;
};
using FrameQueue = BoundedQueue<Frame>;

// Which thread keeps the other waiting; what is long ago counts less.
class Waits {
 public:
  // Has the writer waited at least as long as the maker?
  bool writer_waits(FrameQueue& queue) {
    constexpr double kFading = 0.95;  // per frame
    const auto [maker, writer] = queue.take_waits();
    maker_ = maker_ * kFading + maker;
    writer_ = writer_ * kFading + writer;
    return writer_ >= maker_;
  }

 private:
  FrameQueue::Duration maker_{}, writer_{};
};

// the writing thread; joined on every way out
class Writer {
 public:
  Writer(FrameQueue& queue, FrameSink& sink)
      : queue_(queue), thread_([this, &sink] { run(sink); }) {}
  ~Writer() {
    if (!thread_.joinable()) return;
    queue_.stop();
    thread_.join();
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  // Waits for the last frame; throws what stopped the thread.
  void join() {
    thread_.join();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void run(FrameSink& sink) {
    try {
      Frame frame;
      while (queue_.pop(frame)) {
        if (frame.retouch) frame.retouch(frame.image);
        frame.retouch = {};
        sink.push(frame.image);
        queue_.give_back(std::move(frame));
      }
    } catch (...) {
      failure_ = std::current_exception();
      queue_.stop();
    }
  }

  FrameQueue& queue_;
  std::exception_ptr failure_;
  std::thread thread_;  // last, so that it starts when all else is there
};

}  // namespace

void run_pipeline(int frames,
                  const Produce& produce,
                  FrameSink& sink,
                  const std::function<void(const PipelineStep&)>& on_frame) {
  FrameQueue queue(kFramesAhead);
  Waits waits;
  Writer writer(queue, sink);
  for (int index = 0; index < frames; ++index) {
    stop_if_interrupted();
    Frame frame;
    if (!queue.wait_for_place(frame)) break;
    frame.retouch = produce(index, frame.image);
    queue.push(std::move(frame));
    on_frame({index + 1, waits.writer_waits(queue)});
  }
  queue.end();
  writer.join();
  stop_if_interrupted();
  sink.finish();
}

}  // namespace polhode
