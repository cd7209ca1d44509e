// SPDX-License-Identifier: MIT
#include "video/captions.h"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/system/atomic_file.h"
#include "video/encoders.h"

namespace polhode {
namespace {

// "00:01:02.345"
std::string time_text(int frame, const FrameRate& fps) {
  const long long ms = std::llround(1000.0 * frame * fps.denominator / fps.numerator);
  return fmt::format(
      "{:02}:{:02}:{:02}.{:03}", ms / 3600000, ms / 60000 % 60, ms / 1000 % 60, ms % 1000);
}

// a cue ends at an empty line, and < and & begin metadata
std::string escaped(const std::string& words) {
  std::string text;
  for (const char c : words) {
    if (c == '&') {
      text += "&amp;";
    } else if (c == '<') {
      text += "&lt;";
    } else if (c == '>') {
      text += "&gt;";
    } else if (c == '\n' || c == '\r') {
      if (!text.empty() && text.back() != '\n') text += '\n';
    } else if (c != '\0') {
      text += c;
    }
  }
  return text;
}

class CaptionedSink final : public FrameSink {
 public:
  CaptionedSink(std::unique_ptr<FrameSink> film, const SinkJob& job)
      : name_(captions_beside(job.output)), fps_(job.fps), film_(std::move(film)) {}

  // written now, so that a full disk is told before the film has its name
  void describe(const FilmMetadata& metadata) override {
    film_->describe(metadata);
    if (metadata.captions.empty()) return;
    captions_.emplace(name_);
    captions_->write(web_vtt(metadata.captions, fps_));
  }
  void push(const Image& frame) override { film_->push(frame); }
  void finish() override {
    film_->finish();
    if (captions_) captions_->commit();
  }
  int keeps_every() const override { return film_->keeps_every(); }
  SinkTimes times() const override { return film_->times(); }

 private:
  std::string name_;
  FrameRate fps_;
  std::optional<AtomicFile> captions_;
  std::unique_ptr<FrameSink> film_;
};

}  // namespace

std::string captions_beside(const std::string& output) {
  const FilmFormat* format = find_film_format(output);
  if (format == nullptr || !format->keeps_metadata) return {};
  return output.substr(0, output.size() - format->ending.size()) + ".vtt";
}

std::string web_vtt(const std::vector<FilmMetadata::Caption>& captions, const FrameRate& fps) {
  std::string text = "WEBVTT\n";
  for (const FilmMetadata::Caption& caption : captions) {
    const std::string words = escaped(caption.words);
    if (words.find_first_not_of(" \t\n") == std::string::npos || caption.end <= caption.start) {
      continue;
    }
    text += fmt::format("\n{} --> {}\n{}{}",
                        time_text(caption.start, fps),
                        time_text(caption.end, fps),
                        words,
                        words.ends_with('\n') ? "" : "\n");
  }
  return text;
}

std::unique_ptr<FrameSink> with_captions(std::unique_ptr<FrameSink> film, const SinkJob& job) {
  return std::make_unique<CaptionedSink>(std::move(film), job);
}

}  // namespace polhode
