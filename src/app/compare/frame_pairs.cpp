// SPDX-License-Identifier: MIT
#include "app/compare/frame_pairs.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <set>
#include <thread>
#include <utility>

#include "base/error.h"
#include "base/system/bounded_queue.h"
#include "base/system/interrupt.h"

namespace polhode {

// Reads the frames of a source in a thread of its own, a few ahead.
class FramePairs::Prefetcher {
 public:
  explicit Prefetcher(std::unique_ptr<FrameSource> source)
      : source_(std::move(source)), thread_([this] { read_all(); }) {}
  ~Prefetcher() { queue_.stop(); }
  Prefetcher(const Prefetcher&) = delete;
  Prefetcher& operator=(const Prefetcher&) = delete;

  // The next frame; false after the last. The memory of the one before is used again.
  bool next(SourceFrame& frame) {
    SourceFrame next;
    if (!queue_.pop(next)) return false;
    queue_.give_back(std::exchange(frame, std::move(next)));
    return true;
  }

 private:
  static constexpr std::size_t kAhead = 3;

  void read_all() {
    try {
      SourceFrame frame;
      while (queue_.wait_for_place(frame) && source_->next(frame))
        queue_.push(std::move(frame));
      queue_.end();
    } catch (...) {
      queue_.end(std::current_exception());
    }
  }

  std::unique_ptr<FrameSource> source_;
  BoundedQueue<SourceFrame> queue_{kAhead};
  std::jthread thread_;  // last, so that it starts when all else is there
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
