// SPDX-License-Identifier: MIT
#include "video/pipeline.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "base/system/interrupt.h"

namespace polhode {
namespace {

constexpr std::size_t kFramesAhead = 4;

// A bounded queue of frames, with the used buffers on their way back.
class FrameQueue {
 public:
  // A buffer to draw into; waits while the queue is full. False when the writer has stopped.
  bool take_buffer(Image& buffer) {
    std::unique_lock lock(mutex_);
    const Clock::time_point start = Clock::now();
    changed_.wait(lock, [&] { return full_.size() < kFramesAhead || stopped_; });
    maker_waited_ += Clock::now() - start;
    if (stopped_) return false;
    if (!used_.empty()) {
      buffer = std::move(used_.back());
      used_.pop_back();
    }
    return true;
  }
  void push(Image&& frame) {
    const std::lock_guard lock(mutex_);
    full_.push_back(std::move(frame));
    changed_.notify_all();
  }
  // The next frame; false when there will be none.
  bool pop(Image& frame) {
    std::unique_lock lock(mutex_);
    const Clock::time_point start = Clock::now();
    changed_.wait(lock, [&] { return !full_.empty() || ended_ || stopped_; });
    writer_waited_ += Clock::now() - start;
    if (full_.empty() || stopped_) return false;
    frame = std::move(full_.front());
    full_.pop_front();
    changed_.notify_all();
    return true;
  }
  void give_back(Image&& buffer) {
    const std::lock_guard lock(mutex_);
    used_.push_back(std::move(buffer));
  }
  // Has the writer waited more than the maker? What is long ago counts less.
  bool writer_waits() {
    constexpr double kFading = 0.95;  // a frame
    const std::lock_guard lock(mutex_);
    const bool longer = writer_waited_ >= maker_waited_;
    writer_waited_ *= kFading;
    maker_waited_ *= kFading;
    return longer;
  }
  // No more frames will come; the rest is still written.
  void end() {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }
  // Neither side goes on.
  void stop() {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    changed_.notify_all();
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Image> full_;
  std::deque<Image> used_;
  bool ended_ = false;
  bool stopped_ = false;
  std::chrono::duration<double> maker_waited_{}, writer_waited_{};
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
      Image frame;
      while (queue_.pop(frame)) {
        sink.push(frame);
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
  FrameQueue queue;
  Writer writer(queue, sink);
  for (int index = 0; index < frames; ++index) {
    stop_if_interrupted();
    Image image;
    if (!queue.take_buffer(image)) break;
    produce(index, image);
    queue.push(std::move(image));
    on_frame({index + 1, queue.writer_waits()});
  }
  queue.end();
  writer.join();
  stop_if_interrupted();
  sink.finish();
}

}  // namespace polhode
