// SPDX-License-Identifier: MIT
#include "video/png_sink.h"

#include <deque>
#include <filesystem>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "base/check.h"
#include "base/error.h"
#include "base/system/atomic_file.h"
#include "base/system/unfinished.h"
#include "image/png.h"

namespace polhode {
namespace {

class PngSink final : public FrameSink {
 public:
  explicit PngSink(const SinkJob& job) : file_(job.output), with_alpha_(job.transparent) {
    if (!job.still) {
      throw input_error(
          "one picture needs --still T; a sequence needs a numbered name such as "
          "name_%05d.png")
          .at({job.output, 0, {}});
    }
  }

  void push(const Image& frame) override {
    const StageTimer timer(times_.encode);
    write_png(file_, frame, with_alpha_);
    written_ = true;
  }
  void finish() override {
    CHECK(written_);
    file_.commit();
  }
  SinkTimes times() const override { return times_; }

 private:
  AtomicFile file_;  // claims the name before work begins
  bool with_alpha_;
  bool written_ = false;
  SinkTimes times_;
};

class PngSequenceSink final : public FrameSink {
 public:
  explicit PngSequenceSink(const SinkJob& job)
      : name_(parse_numbered_name(job.output)), with_alpha_(job.transparent) {
    // tells an unwritable folder before any frame is drawn
    const AtomicFile probe(name_.of(0));
  }
  void describe(const FilmMetadata& metadata) override { first_ = metadata.first; }
  void push(const Image& frame) override {
    const StageTimer timer(times_.encode);
    files_.emplace_back(name_.of(first_ + static_cast<int>(files_.size())));
    write_png(files_.back(), frame, with_alpha_);
    // the first frame's lock stands for the whole sequence
    if (files_.size() > 1) files_.back().unlock();
  }
  // all frames get their names together or none, so that older ones stay until the new ones are
  // whole
  void finish() override {
    const StageTimer timer(times_.encode);
    const Unbroken together;
    std::size_t named = 0;
    try {
      for (; named < files_.size(); ++named)
        files_[named].commit_for_now();
    } catch (const Error&) {
      while (named > 0)
        files_[--named].withdraw();
      throw;
    }
    files_.clear();
  }
  SinkTimes times() const override { return times_; }

 private:
  NumberedName name_;
  bool with_alpha_;
  int first_ = 0;  // number of the first frame
  std::deque<AtomicFile> files_;
  SinkTimes times_;
};

// A %d or %05d: how many characters it takes, and how many digits it asks for.
struct Number {
  std::size_t length = 2;
  int width = 0;
};

std::optional<Number> number_at(const std::string& pattern, std::size_t percent) {
  const std::string rest = pattern.substr(percent + 1, 3);
  if (rest.starts_with("d")) return Number{};
  const bool padded = rest.size() == 3 && rest[0] == '0' && rest[1] >= '1' && rest[1] <= '9';
  if (!padded || rest[2] != 'd') return std::nullopt;
  return Number{4, rest[1] - '0'};
}

// folders may have any name
std::size_t start_of_name(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? 0 : slash + 1;
}

}  // namespace

std::string NumberedName::of(int index) const {
  return fmt::format("{}{:0{}d}{}", before, index, width, after);
}

bool has_percent(const std::string& output) {
  return output.find('%', start_of_name(output)) != std::string::npos;
}

bool has_frame_number(const std::string& pattern) {
  std::size_t at = pattern.find('%', start_of_name(pattern));
  for (; at != std::string::npos; at = pattern.find('%', at + 1)) {
    if (number_at(pattern, at)) return true;
  }
  return false;
}

NumberedName parse_numbered_name(const std::string& pattern) {
  // never handed to printf: the name is somebody's text
  const Error wrong =
      input_error("a numbered name has exactly one %d or %05d, such as name_%05d.png")
          .at({pattern, 0, {}});
  const std::size_t percent = pattern.find('%', start_of_name(pattern));
  if (percent == std::string::npos || pattern.find('%', percent + 1) != std::string::npos)
    throw wrong;

  const std::optional<Number> number = number_at(pattern, percent);
  if (!number) throw wrong;
  return {pattern.substr(0, percent), pattern.substr(percent + number->length), number->width};
}

std::unique_ptr<FrameSink> make_png_sink(const SinkJob& job) {
  return std::make_unique<PngSink>(job);
}

std::unique_ptr<FrameSink> make_png_sequence_sink(const SinkJob& job) {
  return std::make_unique<PngSequenceSink>(job);
}

}  // namespace polhode
