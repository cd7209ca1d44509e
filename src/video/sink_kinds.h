// SPDX-License-Identifier: MIT
// The table of output kinds, and the choice of a sink by the name of the output.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "video/frame_sink.h"

namespace polhode {

// A kind of output. To add one: a row in sink_kinds().
struct SinkKind {
  std::string name;                                      // "mp4"
  std::string ending;                                    // ".mp4"; empty if `accepts` recognises it
  std::string doc;                                       // one phrase for `list formats`
  bool alpha = false;                                    // supports transparency
  bool film = false;                                     // a single file that players show
  bool (*accepts)(const std::string& output) = nullptr;  // null: recognised by the ending
  std::unique_ptr<FrameSink> (*make)(const SinkJob&) = nullptr;  // opens the sink
};

// All kinds, in the order in which they are tried; the table exists until the program ends.
const std::vector<SinkKind>& sink_kinds();

// The kind of an output. Throws Error (input), with the output as place, for an unknown ending; the
// message suggests the nearest.
const SinkKind& find_sink_kind(const std::string& output);

// Opens the sink for job.output, with a caption file beside it where the format has one. Throws
// Error (input) as find_sink_kind and AtomicFile do, and for a job that the kind cannot do:
// transparency, a still as a film, one picture without job.still, odd sizes, a wrong codec (naming
// --codec); (environment) for a missing encoder.
std::unique_ptr<FrameSink> make_sink(const SinkJob& job);

}  // namespace polhode
