// SPDX-License-Identifier: MIT
#include "video/plain_sinks.h"

#include <cstdio>

#include <fmt/format.h>

#include "base/error.h"
#include "base/hash.h"
#include "base/system/atomic_file.h"

namespace polhode {
namespace {

// "hash:FILE", or a name with the ending
std::string hash_file(const SinkJob& job) {
  if (!job.output.starts_with(kHashPrefix)) return job.output;
  std::string name = job.output.substr(kHashPrefix.size());
  if (name.empty() || name == kStandardOutput) {
    throw input_error("hash: needs a file name, such as hash:frames.txt").at({job.output, 0, {}});
  }
  return name;
}

class HashSink final : public FrameSink {
 public:
  explicit HashSink(const SinkJob& job) : file_(hash_file(job)) {}

  void describe(const FilmMetadata& metadata) override { index_ = metadata.first; }
  void push(const Image& frame) override {
    const StageTimer timer(times_.encode);
    lines_ += fmt::format("{} {}x{} {}\n", index_++, frame.width, frame.height, frame_hash(frame));
  }
  void finish() override { file_.commit_with(lines_); }
  SinkTimes times() const override { return times_; }

 private:
  AtomicFile file_;  // claims the name before work begins
  std::string lines_;
  int index_ = 0;
  SinkTimes times_;
};

class NullSink final : public FrameSink {
 public:
  void push(const Image&) override {}
  void finish() override {}
  SinkTimes times() const override { return {}; }
};

class ListingSink final : public FrameSink {
 public:
  ListingSink(std::unique_ptr<FrameSink> sink, std::vector<std::string>& hashes)
      : sink_(std::move(sink)), hashes_(hashes) {}

  void describe(const FilmMetadata& metadata) override { sink_->describe(metadata); }
  void push(const Image& frame) override {
    hashes_.push_back(frame_hash(frame));
    sink_->push(frame);
  }
  void finish() override { sink_->finish(); }
  SinkTimes times() const override { return sink_->times(); }

 private:
  std::unique_ptr<FrameSink> sink_;
  std::vector<std::string>& hashes_;
};

}  // namespace

std::string frame_hash(const Image& frame) {
  return content_hash(frame.pixels.data(), frame.pixels.size());
}

std::unique_ptr<FrameSink> with_hashes(std::unique_ptr<FrameSink> sink,
                                       std::vector<std::string>& hashes) {
  return std::make_unique<ListingSink>(std::move(sink), hashes);
}

std::unique_ptr<FrameSink> make_hash_sink(const SinkJob& job) {
  return std::make_unique<HashSink>(job);
}

std::unique_ptr<FrameSink> make_null_sink(const SinkJob&) {
  return std::make_unique<NullSink>();
}

}  // namespace polhode
