// SPDX-License-Identifier: MIT
#include "video/gif_sink.h"

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "base/at_place.h"
#include "base/check.h"
#include "base/system/interrupt.h"
#include "base/system/log.h"
#include "video/libav/converter.h"
#include "video/libav/film_writer.h"
#include "video/libav/filter_graph.h"
#include "video/libav/frame_spool.h"

namespace polhode {
namespace {

constexpr int kFastest = 50;      // frames per second; players slow faster ones down to 10
constexpr int kPaletteSide = 16;  // pixels of libavfilter's picture of a palette
constexpr const char* kDither = "paletteuse=dither=bayer:bayer_scale=3:diff_mode=rectangle";

AVPixelFormat pixels_of(const SinkJob& job) {
  return job.transparent ? AV_PIX_FMT_BGRA : AV_PIX_FMT_BGR0;
}

std::filesystem::path folder_of(const SinkJob& job) {
  const std::filesystem::path file(job.output);
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

// what is not as the scene wants it, in one line
void tell_changes(const SinkJob& job) {
  std::string changes = "256 colours";
  if (job.transparent) changes += ", pixels either clear or solid";
  if (job.asked_fps) {
    changes +=
        fmt::format(", {:.5g} frames/s instead of {:.5g}", job.fps.value(), job.asked_fps->value());
  }
  const std::int64_t hundredths = std::int64_t{100} * job.fps.denominator;
  if (hundredths % job.fps.numerator != 0) changes += ", times rounded to hundredths of a second";
  spdlog::warn("a GIF has limits: {}", changes);
}

class GifSink final : public FrameSink {
 public:
  explicit GifSink(const SinkJob& job)
      : job_(job),
        writer_(job),
        converter_(job.width, job.height, pixels_of(job)),
        palette_("[in]palettegen=stats_mode=diff:reserve_transparent=" +
                     std::string(job.transparent ? "1" : "0") + "[out]",
                 {{"in", job.width, job.height, pixels_of(job)}}),
        spool_(folder_of(job), job.width, job.height, pixels_of(job), job.encoder.threads) {
    CHECK(gif_rate(job.fps) == job.fps);
    tell_changes(job);
  }

  void push(const Image& frame) override {
    CHECK(frame.width == job_.width && frame.height == job_.height);
    at_place({job_.output, 0, {}}, [&] {
      AVFrame* converted = nullptr;
      {
        const StageTimer timer(times_.convert);
        converted = converter_.convert(frame);
      }
      const StageTimer timer(times_.encode);
      converted->pts = time_of(count_++);
      spool_.push(*converted);
      palette_.push(0, converted);
    });
  }

  // the palette is known only now
  void finish() override {
    const StageTimer timer(times_.encode);
    at_place({job_.output, 0, {}}, [&] {
      palette_.push(0, nullptr);
      AVFrame* palette = palette_.pull();
      CHECK(palette != nullptr);
      FilterGraph painter(fmt::format("[in][palette]{}[out]", kDither),
                          {{"in", job_.width, job_.height, pixels_of(job_)},
                           {"palette", kPaletteSide, kPaletteSide, AV_PIX_FMT_BGRA}});
      palette->pts = 0;
      painter.push(1, palette);
      painter.push(1, nullptr);
      spool_.rewind();
      int next = 0;
      while (AVFrame* frame = spool_.take()) {
        stop_if_interrupted();
        frame->pts = time_of(next);
        painter.push(0, frame);
        write_painted(painter);
        ++next;
      }
      painter.push(0, nullptr);
      write_painted(painter);
      // the film lasts as long as its frames would have
      const std::int64_t last = time_of(count_ - 1);
      writer_.set_at_end("final_delay", std::max<std::int64_t>(2, time_of(count_) - last));
    });
    writer_.finish();
  }

  SinkTimes times() const override { return times_; }

 private:
  // of a frame of the film, in hundredths of a second
  std::int64_t time_of(int index) const {
    return av_rescale_q(index, {job_.fps.denominator, job_.fps.numerator}, {1, 100});
  }
  void write_painted(FilterGraph& painter) {
    while (AVFrame* painted = painter.pull()) {
      writer_.write(*painted, false);
    }
  }

  SinkJob job_;
  FilmWriter writer_;
  Converter converter_;
  FilterGraph palette_;
  FrameSpool spool_;
  int count_ = 0;
  SinkTimes times_;
};

}  // namespace

FrameRate gif_rate(const FrameRate& fps) {
  const std::int64_t most = std::int64_t{kFastest} * fps.denominator;
  const std::int64_t step = (fps.numerator + most - 1) / most;
  const std::int64_t whole = fps.denominator * step;
  const std::int64_t common = std::gcd(std::int64_t{fps.numerator}, whole);
  return {static_cast<int>(fps.numerator / common), static_cast<int>(whole / common)};
}

std::unique_ptr<FrameSink> make_gif_sink(const SinkJob& job) {
  return std::make_unique<GifSink>(job);
}

}  // namespace polhode
