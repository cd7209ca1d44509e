// SPDX-License-Identifier: MIT
// A queue of limited length between a thread that produces items and one that consumes them.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <utility>
#include <vector>

#include "base/system/interrupt.h"

namespace polhode {

// For one producer thread and one consumer thread; T is default-constructible and movable. The
// consumer can give items back, so that the memory of large ones is used again. Invariant: at
// most `most` items wait, if the producer calls wait_for_place() before each push(); an error
// is delivered after the items that were pushed before it. The queue must outlive its use by
// both threads.
template <class T>
class BoundedQueue {
 public:
  using Duration = std::chrono::duration<double>;  // s

  // `most`: the largest number of waiting items, at least 1.
  explicit BoundedQueue(std::size_t most) : most_(most) {}

  // For the producer: waits for a free place and sets `item` to one that was given back, or to T{}
  // if there is none. Returns false, at once, if the queue was stopped.
  bool wait_for_place(T& item) {
    std::unique_lock lock(mutex_);
    const Clock::time_point start = Clock::now();
    changed_.wait(lock, [&] { return ready_.size() < most_ || stopped_; });
    producer_waited_ += Clock::now() - start;
    if (stopped_) return false;
    item = T{};
    if (!spare_.empty()) {
      item = std::move(spare_.back());
      spare_.pop_back();
    }
    return true;
  }
  // For the producer: adds an item. Does not wait.
  void push(T&& item) {
    const std::lock_guard lock(mutex_);
    ready_.push_back(std::move(item));
    changed_.notify_all();
  }
  // For the producer: no more items will come, because there are none or because of an error, which
  // pop() then throws in the consumer.
  void end(std::exception_ptr error = nullptr) {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    error_ = std::move(error);
    changed_.notify_all();
  }

  // For the consumer: waits for the next item and moves it into `item`. Returns false if none is
  // left after end(), or if the queue was stopped. Throws the exception that was given to end()
  // when no item is left, and Error (interrupted) if the program is interrupted while it waits.
  bool pop(T& item) {
    constexpr std::chrono::milliseconds kPatience{100};
    std::unique_lock lock(mutex_);
    const Clock::time_point start = Clock::now();
    while (!changed_.wait_for(
        lock, kPatience, [&] { return !ready_.empty() || ended_ || stopped_; })) {
      stop_if_interrupted();
    }
    consumer_waited_ += Clock::now() - start;
    if (stopped_) return false;
    if (ready_.empty()) {
      if (error_) std::rethrow_exception(error_);
      return false;
    }
    item = std::move(ready_.front());
    ready_.pop_front();
    changed_.notify_all();
    return true;
  }
  // For the consumer: hands a used item to a later wait_for_place().
  void give_back(T&& item) {
    const std::lock_guard lock(mutex_);
    spare_.push_back(std::move(item));
  }

  // For both: wakes the other side; from now on wait_for_place() and pop() return false, and
  // waiting items are lost.
  void stop() {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    changed_.notify_all();
  }

  // For any thread: how long the producer (first) and the consumer (second) have waited since the
  // last call, in waits that have ended.
  std::pair<Duration, Duration> take_waits() {
    const std::lock_guard lock(mutex_);
    return {std::exchange(producer_waited_, {}), std::exchange(consumer_waited_, {})};
  }

 private:
  using Clock = std::chrono::steady_clock;
  const std::size_t most_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<T> ready_;
  std::vector<T> spare_;
  std::exception_ptr error_;
  bool ended_ = false, stopped_ = false;
  Duration producer_waited_{}, consumer_waited_{};
};

}  // namespace polhode
