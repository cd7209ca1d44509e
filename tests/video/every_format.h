// SPDX-License-Identifier: MIT
// Every kind of film that can be written, and a small film of each: a new row
// of the tables in video/encoders.h is tested by being there.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "support/run.h"
#include "video/decoded_film.h"
#include "video/encoders.h"
#include "video/frame_sink.h"
#include "video/sink_kinds.h"

namespace polhode::test {

// A way to make a film: an ending with one of its codecs.
struct Way {
  const FilmFormat* format;
  const FilmEncoder* encoder;

  std::string name() const { return encoder->codec + format->ending; }
  bool lossless() const { return encoder->codec == "apng"; }
};

inline std::vector<Way> all_ways() {
  std::vector<Way> ways;
  for (const FilmFormat& format : film_formats()) {
    for (const std::string& codec : format.codecs) {
      ways.push_back({&format, &find_encoder(format, codec)});
    }
  }
  return ways;
}

inline SinkJob job_for(const TemporaryFolder& folder, const Way& way, FrameRate fps = {25, 1}) {
  SinkJob job;
  job.output = folder / ("a" + way.format->ending);
  job.width = 64;
  job.height = 48;
  job.fps = fps;
  job.encoder.codec = way.encoder->codec;
  job.encoder.crf = way.encoder->crf[1];
  job.title = "A <title> & \"quotes\" ü";
  job.comment = "what made it";
  return job;
}

inline void paint(Image& image, int x, int y, int r, int g, int b, int a) {
  std::uint8_t* pixel = image.at(x, y);
  pixel[0] = static_cast<std::uint8_t>(r);
  pixel[1] = static_cast<std::uint8_t>(g);
  pixel[2] = static_cast<std::uint8_t>(b);
  pixel[3] = static_cast<std::uint8_t>(a);
}

// an orange square of 16 pixels that walks over blue; the ground is clear when there is alpha
inline Image walking(const SinkJob& job, int index) {
  Image image(job.width, job.height);
  for (int y = 0; y < job.height; ++y) {
    for (int x = 0; x < job.width; ++x) {
      const bool inside = y >= 16 && y < 32 && (x - 2 * index + 640) % 64 < 16;
      if (inside) {
        paint(image, x, y, 240, 165, 30, 255);
      } else {
        paint(image, x, y, 20, 60, 140, job.transparent ? 0 : 255);
      }
    }
  }
  return image;
}

inline void write_film(const SinkJob& job, int frames, const FilmMetadata& metadata = {}) {
  const std::unique_ptr<FrameSink> sink = make_sink(job);
  sink->describe(metadata);
  for (int i = 0; i < frames; ++i) {
    sink->push(walking(job, i));
  }
  sink->finish();
}

inline FilmMetadata some_metadata() {
  FilmMetadata metadata;
  metadata.frames = 40;
  metadata.key_frames = {7, 18, 33};
  metadata.chapters = {{0, "First <one>"}, {18, "Second & last ü"}};
  metadata.captions = {{0, 18, "Words"}};
  return metadata;
}

}  // namespace polhode::test
