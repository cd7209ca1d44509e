// SPDX-License-Identifier: MIT
#include "app/compare/frame_pairs.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <set>
#include <thread>

#include "base/error.h"
#include "base/system/interrupt.h"

namespace polhode {

// Invariant: at most kAhead frames are ready; an error waits behind the frames before it.
class FramePairs::Prefetcher {
 public:
  explicit Prefetcher(std::unique_ptr<FrameSource> source)
      : source_(std::move(source)), thread_([this] { read_all(); }) {}
  ~Prefetcher() {
    {
      const std::lock_guard lock(mutex_);
      stopped_ = true;
    }
    changed_.notify_all();
  }
  Prefetcher(const Prefetcher&) = delete;
  Prefetcher& operator=(const Prefetcher&) = delete;

  bool next(SourceFrame& frame) {
    std::unique_lock lock(mutex_);
    // an interrupt must not wait for a slow source
    while (!changed_.wait_for(lock, kPatience, [&] { return !ready_.empty() || ended_; }))
      stop_if_interrupted();
    if (ready_.empty()) {
      if (error_) std::rethrow_exception(error_);
      return false;
    }
    spare_.push_back(std::move(frame));
    frame = std::move(ready_.front());
    ready_.pop_front();
    lock.unlock();
    changed_.notify_all();
    return true;
  }

 private:
  static constexpr std::size_t kAhead = 3;
  static constexpr std::chrono::milliseconds kPatience{100};

  void read_all() {
    try {
      while (read_one()) {
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      error_ = std::current_exception();
    }
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
    }
    changed_.notify_all();
  }

  bool read_one() {
    SourceFrame frame;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return ready_.size() < kAhead || stopped_; });
      if (stopped_) return false;
      if (!spare_.empty()) {
        frame = std::move(spare_.back());
        spare_.pop_back();
      }
    }
    if (!source_->next(frame)) return false;
    {
      const std::lock_guard lock(mutex_);
      ready_.push_back(std::move(frame));
    }
    changed_.notify_all();
    return true;
  }

  std::unique_ptr<FrameSource> source_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<SourceFrame> ready_;
  std::vector<SourceFrame> spare_;  // buffers to be used again
  std::exception_ptr error_;
  bool ended_ = false, stopped_ = false;
  std::jthread thread_;
};

namespace {

const char* what(SourceKind kind) {
  return kind == SourceKind::numbered ? "number" : "picture";
}

// the first label that only one of them has
void refuse_unpaired(const std::string& name_a,
                     const SourceInfo& a,
                     const std::string& name_b,
                     const SourceInfo& b) {
  const auto missing = [](const SourceInfo& from, const SourceInfo& in) {
    const std::set<std::string> there(in.labels.begin(), in.labels.end());
    return std::find_if(from.labels.begin(), from.labels.end(), [&](const std::string& label) {
      return there.count(label) == 0;
    });
  };
  const auto refuse =
      [&](const std::string& label, const std::string& there, const std::string& not_here) {
        return input_error("has no {} '{}', which {} has", what(a.kind), label, there)
            .at({not_here, 0, {}});
      };
  if (const auto it = missing(a, b); it != a.labels.end()) throw refuse(*it, name_a, name_b);
  if (const auto it = missing(b, a); it != b.labels.end()) throw refuse(*it, name_b, name_a);
}

Error different_counts(const std::string& fewer, int count, const std::string& more) {
  return input_error("has {} frame{}, {} has more", count, count == 1 ? "" : "s", more)
      .at({fewer, 0, {}});
}

}  // namespace

FramePairs::FramePairs(const std::string& name_a,
                       std::unique_ptr<FrameSource> a,
                       const std::string& name_b,
                       std::unique_ptr<FrameSource> b,
                       bool by_order)
    : name_a_(name_a), name_b_(name_b) {
  const SourceInfo& one = a->info();
  const SourceInfo& other = b->info();
  const bool alike = one.kind == other.kind && !by_order;
  if (alike && (one.kind == SourceKind::numbered || one.kind == SourceKind::folder)) {
    refuse_unpaired(name_a, one, name_b, other);
  } else if (one.kind != SourceKind::film && other.kind != SourceKind::film &&
             one.labels.size() != other.labels.size()) {
    const bool first = one.labels.size() < other.labels.size();
    throw different_counts(first ? name_a : name_b,
                           static_cast<int>(std::min(one.labels.size(), other.labels.size())),
                           first ? name_b : name_a);
  }
  if (alike && one.kind == SourceKind::film) {
    apart_ = 0.5 / std::max(one.fps.value(), other.fps.value());
  }
  count_ = std::max(one.frames, other.frames);
  a_ = std::make_unique<Prefetcher>(std::move(a));
  b_ = std::make_unique<Prefetcher>(std::move(b));
}

FramePairs::~FramePairs() = default;

void FramePairs::refuse_unlike(const SourceFrame& a, const SourceFrame& b) const {
  if (apart_ > 0.0 && std::abs(a.time - b.time) > apart_) {
    const bool first = a.time < b.time;
    throw input_error("shows a frame at {:.4f} s, {} shows none then",
                      std::min(a.time, b.time),
                      first ? name_b_ : name_a_)
        .at({first ? name_a_ : name_b_, 0, {}});
  }
  if (a.image.width != b.image.width || a.image.height != b.image.height) {
    throw input_error("is {}x{} pixels, {} is {}x{}",
                      a.image.width,
                      a.image.height,
                      name_b_,
                      b.image.width,
                      b.image.height)
        .at({name_a_, 0, {}});
  }
}

bool FramePairs::next(SourceFrame& a, SourceFrame& b) {
  stop_if_interrupted();
  const bool more_a = a_->next(a);
  const bool more_b = b_->next(b);
  if (more_a != more_b) {
    throw different_counts(more_a ? name_b_ : name_a_, given_, more_a ? name_a_ : name_b_);
  }
  if (!more_a) return false;
  ++given_;
  refuse_unlike(a, b);
  return true;
}

}  // namespace polhode
