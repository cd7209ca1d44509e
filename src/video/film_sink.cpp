// SPDX-License-Identifier: MIT
#include "video/film_sink.h"

#include <set>

#include "base/at_place.h"
#include "base/check.h"
#include "video/libav/converter.h"
#include "video/libav/film_writer.h"
#include "video/plain_sinks.h"

namespace polhode {
namespace {

class FilmSink final : public FrameSink {
 public:
  explicit FilmSink(const SinkJob& job)
      : job_(job), writer_(job), converter_(job.width, job.height, writer_.pixels()) {}

  void describe(const FilmMetadata& metadata) override {
    key_frames_.insert(metadata.key_frames.begin(), metadata.key_frames.end());
    writer_.describe(metadata);
  }

  void push(const Image& frame) override {
    CHECK(frame.width == job_.width && frame.height == job_.height);
    AVFrame* converted = nullptr;
    at_place({job_.output, 0, {}}, [&] {
      const StageTimer timer(times_.convert);
      converted = converter_.convert(frame);
    });
    const StageTimer timer(times_.encode);
    if (job_.segment) hashes_ += frame_hash(frame) + "\n";
    converted->pts = next_;
    writer_.write(*converted, key_frames_.contains(next_));
    ++next_;
  }

  void finish() override {
    const StageTimer timer(times_.encode);
    if (job_.segment) writer_.seal_with(hashes_);
    // the thread that looks ahead ends with the last frame, the others with the encoder
    ThreadClocks clocks(writer_.threads());
    clocks.read();
    writer_.finish();
    clocks.read();
    times_.encode.cpu_s += clocks.total();
  }

  SinkTimes times() const override { return times_; }

 private:
  SinkJob job_;
  FilmWriter writer_;
  Converter converter_;
  std::set<int> key_frames_;
  int next_ = 0;        // index of the next frame
  std::string hashes_;  // of a piece, a line per frame
  SinkTimes times_;
};

}  // namespace

std::unique_ptr<FrameSink> make_film_sink(const SinkJob& job) {
  return std::make_unique<FilmSink>(job);
}

std::string libav_version() {
  return av_version_info();
}

std::string libav_parts() {
  const auto part = [](const char* name, unsigned version) {
    return fmt::format("{} {}.{}.{}",
                       name,
                       AV_VERSION_MAJOR(version),
                       AV_VERSION_MINOR(version),
                       AV_VERSION_MICRO(version));
  };
  return fmt::format("{}, {}, {}, {}",
                     part("libavcodec", avcodec_version()),
                     part("libavformat", avformat_version()),
                     part("libavutil", avutil_version()),
                     part("libswscale", swscale_version()));
}

}  // namespace polhode
