// SPDX-License-Identifier: MIT
#include "video/sink_kinds.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/nearest.h"
#include "video/captions.h"
#include "video/encoders.h"
#include "video/film_sink.h"
#include "video/frame_sink.h"
#include "video/gif_sink.h"
#include "video/plain_sinks.h"
#include "video/png_sink.h"

namespace polhode {
namespace {

bool has_hash_prefix(const std::string& output) {
  return output.starts_with(kHashPrefix);
}

bool accepts(const SinkKind& kind, const std::string& output) {
  if (kind.accepts != nullptr) return kind.accepts(output);
  // behind "hash:" any ending may stand
  return output.ends_with(kind.ending) && !has_hash_prefix(output);
}

// ".mp4" alone is a hidden file without a name
void refuse_nameless(const std::string& output) {
  const std::string name = output.substr(output.find_last_of('/') + 1);
  for (const SinkKind& kind : sink_kinds()) {
    if (kind.ending.empty() || name != kind.ending) continue;
    throw input_error("the ending needs a name before it, such as film{}", kind.ending)
        .at({output, 0, {}});
  }
}

std::string alpha_formats() {
  std::string names;
  for (const SinkKind& kind : sink_kinds()) {
    if (kind.alpha) names += (names.empty() ? "" : ", ") + kind.name;
  }
  return names;
}

// endings of pictures that other programs write; one of ours is near by chance only
bool is_of_a_picture(const std::string& ending) {
  constexpr std::array kEndings = {
      ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".ppm", ".tga", ".exr", ".svg", ".pdf"};
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

Error unknown_ending(const std::string& output, bool still) {
  const std::size_t dot = output.find_last_of("./");
  const bool has_ending = dot != std::string::npos && output[dot] == '.';
  const std::string ending = has_ending ? output.substr(dot) : "";
  std::vector<std::string> endings;
  for (const SinkKind& kind : sink_kinds()) {
    if (!kind.ending.empty()) endings.push_back(kind.ending);
  }
  const bool picture = still || is_of_a_picture(ending);
  return input_error("no format has the ending '{}'{}",
                     ending,
                     picture ? " (did you mean '.png'?)" : suggestion(ending, endings))
      .at({output, 0, {}});
}

}  // namespace

// Long, because it is one table: a row for each.
const std::vector<SinkKind>& sink_kinds() {
  static const std::vector<SinkKind> kinds = {
      {"mp4",
       ".mp4",
       "film for everything: H.264; HEVC or AV1 with --codec, NAME.mp4",
       false,
       true,
       nullptr,
       make_film_sink},
      {"webm", ".webm", "film for web pages: VP9, NAME.webm", true, true, nullptr, make_film_sink},
      {"mov",
       ".mov",
       "film for video editors: ProRes 4444, NAME.mov",
       true,
       true,
       nullptr,
       make_film_sink},
      {"gif",
       ".gif",
       "256 colours, at most 50 frames/s, alpha of one bit, NAME.gif",
       true,
       true,
       nullptr,
       make_gif_sink},
      {"apng", ".apng", "lossless animated PNG, NAME.apng", true, true, nullptr, make_film_sink},
      {"y4m",
       ".y4m",
       "raw frames for other programs (YUV4MPEG2), NAME.y4m, or - for standard output",
       false,
       true,
       [](const std::string& output) {
         return output == kStandardOutput || (output.ends_with(".y4m") && !has_hash_prefix(output));
       },
       make_film_sink},
      {"png sequence",
       "",
       "numbered pictures, NAME_%05d.png",
       true,
       false,
       [](const std::string& output) {
         return output.ends_with(".png") && has_percent(output) && !has_hash_prefix(output);
       },
       make_png_sequence_sink},
      {"png", ".png", "one picture, NAME.png", true, false, nullptr, make_png_sink},
      {"hash",
       ".hash",
       "a line per frame: index, size, hash of its pixels, NAME.hash or hash:NAME",
       true,
       false,
       [](const std::string& output) {
         return output.ends_with(".hash") || has_hash_prefix(output);
       },
       make_hash_sink},
      {"null",
       "",
       "nothing is written, for timing; the name is null",
       true,
       false,
       [](const std::string& output) { return output == "null"; },
       make_null_sink},
  };
  return kinds;
}

const SinkKind& find_sink_kind(const std::string& output, bool still) {
  for (const SinkKind& kind : sink_kinds()) {
    if (accepts(kind, output)) return kind;
  }
  throw unknown_ending(output, still);
}

std::unique_ptr<FrameSink> make_sink(const SinkJob& job) {
  refuse_nameless(job.output);
  const SinkKind& kind = find_sink_kind(job.output);
  const Place place{job.output, 0, {}};
  if (kind.film && has_frame_number(job.output)) {
    throw input_error("a film is a single file; names with % are for numbered .png pictures")
        .at(place);
  }
  if (kind.film && job.still) {
    throw input_error("one picture (--still) is written as .png, not as a film").at(place);
  }
  if (job.transparent && !kind.alpha) {
    throw input_error(
        "{} has no alpha channel; for a transparent picture use {}", kind.name, alpha_formats())
        .at(place);
  }
  std::unique_ptr<FrameSink> sink = kind.make(job);
  if (captions_beside(job.output).empty()) return sink;
  return with_captions(std::move(sink), job);
}

}  // namespace polhode
