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

// One producer, one consumer. Consumed items can be given back, so that the memory of large ones
// is used again. Invariant: at most `most` items wait; an error waits behind the items before it.
template <class T>
class BoundedQueue {
 public:
  using Duration = std::chrono::duration<double>;  // s

  explicit BoundedQueue(std::size_t most) : most_(most) {}

  // For the producer: waits for a free place, and makes `item` one that was given back, or a new
  // one if there is none. False: the queue was stopped.
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
  void push(T&& item) {
    const std::lock_guard lock(mutex_);
    ready_.push_back(std::move(item));
    changed_.notify_all();
  }
  // No more items will come, because there are none or because of an error.
  void end(std::exception_ptr error = nullptr) {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    error_ = std::move(error);
    changed_.notify_all();
  }

  // For the consumer: the next item; false when there is none left or the queue was stopped. Throws
  // the producer's error, and Error (interrupted) if the program is interrupted while it waits.
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
  void give_back(T&& item) {
    const std::lock_guard lock(mutex_);
    spare_.push_back(std::move(item));
  }

  // For both: neither side continues, and items that wait are lost.
  void stop() {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    changed_.notify_all();
  }

  // How long the producer and the consumer have waited for each other since the last call.
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
