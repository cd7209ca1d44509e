// SPDX-License-Identifier: MIT
#include "video/frame_sink.h"

#include "base/error.h"
#include "base/nearest.h"
#include "video/film_sink.h"
#include "video/plain_sinks.h"
#include "video/png_sink.h"

namespace polhode {
namespace {

bool has_hash_prefix(const SinkJob& job) {
  return job.output.starts_with(kHashPrefix);
}

// behind "hash:" any ending may stand
bool ends_with(const SinkJob& job, const char* ending) {
  return job.output.ends_with(ending) && !has_hash_prefix(job);
}

// ".mp4" alone is a hidden file without a name
void refuse_nameless(const SinkJob& job) {
  const std::string name = job.output.substr(job.output.find_last_of('/') + 1);
  for (const SinkKind& kind : sink_kinds()) {
    if (kind.ending.empty() || name != kind.ending) continue;
    throw input_error("a name belongs before the ending, such as film{}", kind.ending)
        .at({job.output, 0, {}});
  }
}

bool is_sequence(const SinkJob& job) {
  return job.output.find('%') != std::string::npos;
}

std::string alpha_formats() {
  std::string names;
  for (const SinkKind& kind : sink_kinds()) {
    if (kind.alpha) names += (names.empty() ? "" : ", ") + kind.name;
  }
  return names;
}

Error unknown_ending(const SinkJob& job) {
  const std::size_t dot = job.output.find_last_of("./");
  const bool has_ending = dot != std::string::npos && job.output[dot] == '.';
  std::vector<std::string> endings;
  for (const SinkKind& kind : sink_kinds()) {
    if (!kind.ending.empty()) endings.push_back(kind.ending);
  }
  const std::string ending = has_ending ? job.output.substr(dot) : "";
  return input_error("no format has the ending '{}'{}", ending, suggestion(ending, endings))
      .at({job.output, 0, {}});
}

}  // namespace

const std::vector<SinkKind>& sink_kinds() {
  static const std::vector<SinkKind> kinds = {
      {"mp4",
       ".mp4",
       "H.264 film, NAME.mp4",
       false,
       [](const SinkJob& job) { return ends_with(job, ".mp4"); },
       make_film_sink},
      {"png sequence",
       "",
       "numbered pictures, NAME_%05d.png",
       true,
       [](const SinkJob& job) { return ends_with(job, ".png") && is_sequence(job); },
       make_png_sequence_sink},
      {"png",
       ".png",
       "one picture, NAME.png",
       true,
       [](const SinkJob& job) { return ends_with(job, ".png"); },
       make_png_sink},
      {"hash",
       ".hash",
       "a line per frame: index, size, hash of its pixels, NAME.hash or hash:NAME",
       true,
       [](const SinkJob& job) { return ends_with(job, ".hash") || has_hash_prefix(job); },
       make_hash_sink},
      {"null",
       "",
       "nothing is written, for timing; the name is null",
       true,
       [](const SinkJob& job) { return job.output == "null"; },
       make_null_sink},
  };
  return kinds;
}

std::unique_ptr<FrameSink> make_sink(const SinkJob& job) {
  refuse_nameless(job);
  if (has_frame_number(job.output) && ends_with(job, ".mp4")) {
    throw input_error("a film is one file; a name with % is for numbered .png pictures")
        .at({job.output, 0, {}});
  }
  for (const SinkKind& kind : sink_kinds()) {
    if (!kind.accepts(job)) continue;
    if (job.transparent && !kind.alpha) {
      throw input_error(
          "{} keeps no alpha; for a transparent picture use {}", kind.name, alpha_formats())
          .at({job.output, 0, {}});
    }
    return kind.make(job);
  }
  throw unknown_ending(job);
}

}  // namespace polhode
