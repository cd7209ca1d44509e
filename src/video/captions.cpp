// SPDX-License-Identifier: MIT
#include "video/captions.h"

#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "base/error.h"
#include "video/encoders.h"

namespace polhode {
namespace {

// behind the first word any text may stand: ours is known again by it
constexpr std::string_view kHead = "WEBVTT - captions by polhode\n";

bool is_ours(const std::string& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored) &&
         head_of_file(file, kHead.size()) == kHead;
}

// another film that stands beside this one and has its captions in the same file; empty if none
std::string other_film(const std::string& film) {
  const FilmFormat* own = find_film_format(film);
  const std::string stem = film.substr(0, film.size() - own->ending.size());
  for (const FilmFormat& format : film_formats()) {
    std::error_code ignored;
    if (format.keeps_metadata && format.ending != own->ending &&
        std::filesystem::exists(stem + format.ending, ignored))
      return stem + format.ending;
  }
  return {};
}

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
      : captions_(job.output, job.captions && !job.segment),
        fps_(job.fps),
        film_(std::move(film)) {}

  // written now, so that a full disk is told before the film has its name
  void describe(const FilmMetadata& metadata) override {
    film_->describe(metadata);
    captions_.write(metadata.captions, fps_);
  }
  void push(const Image& frame) override { film_->push(frame); }
  void finish() override {
    film_->finish();
    try {
      captions_.commit();
    } catch (const Error& error) {
      throw Error(error.fault(), error.message() + "; the film is complete", error.place());
    }
  }
  SinkTimes times() const override { return film_->times(); }

 private:
  CaptionFile captions_;
  FrameRate fps_;
  std::unique_ptr<FrameSink> film_;
};

}  // namespace

std::string captions_beside(const std::string& output) {
  const FilmFormat* format = find_film_format(output);
  if (format == nullptr || !format->keeps_metadata) return {};
  return output.substr(0, output.size() - format->ending.size()) + ".vtt";
}

std::string web_vtt(const std::vector<FilmMetadata::Caption>& captions, const FrameRate& fps) {
  std::string text(kHead);
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

CaptionFile::CaptionFile(const std::string& film, bool expected)
    : film_(film), name_(captions_beside(film)) {
  if (expected) claim();
}

// what somebody else has written under that name is not ours to replace
void CaptionFile::claim() {
  std::error_code ignored;
  if (std::filesystem::exists(name_, ignored) && std::filesystem::file_size(name_, ignored) > 0 &&
      !is_ours(name_)) {
    throw input_error(
        "the captions of the film go there, and it is no file of captions by polhode; "
        "move it, or give the film another name")
        .at({name_, 0, {}});
  }
  file_.emplace(name_);
}

void CaptionFile::write(const std::vector<FilmMetadata::Caption>& captions, const FrameRate& fps) {
  if (captions.empty()) return;
  if (!file_) claim();
  text_ = web_vtt(captions, fps);
  file_->write(text_);
}

void CaptionFile::commit() {
  const bool had_ours = is_ours(name_);
  const std::string other = had_ours ? other_film(film_) : std::string();
  if (!text_.empty()) {
    if (!other.empty() && read_file(name_) != text_)
      spdlog::warn("{} had the captions of {} and has those of {} now", name_, other, film_);
    file_->commit();
    return;
  }
  if (!had_ours) return;
  if (!other.empty()) {
    spdlog::warn("{} stays, for it may be of {}: {} has no captions", name_, other, film_);
    return;
  }
  std::error_code failed;
  std::filesystem::remove(name_, failed);
  if (failed) {
    throw environment_error("cannot remove the captions of an earlier film: {}", failed.message())
        .at({name_, 0, {}});
  }
}

std::unique_ptr<FrameSink> with_captions(std::unique_ptr<FrameSink> film, const SinkJob& job) {
  return std::make_unique<CaptionedSink>(std::move(film), job);
}

}  // namespace polhode
