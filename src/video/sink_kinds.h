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
  std::string name;    // "mp4"
  std::string ending;  // ".mp4", also for suggestions in errors; empty: none of its own
  std::string doc;     // one phrase for `list formats`
  bool alpha = false;  // supports transparency
  bool film = false;   // a single file that players show
  // Whether an output is of this kind; null: if it has the ending and no prefix "hash:".
  bool (*accepts)(const std::string& output) = nullptr;
  std::unique_ptr<FrameSink> (*make)(const SinkJob&) = nullptr;  // opens the sink
};

// All kinds, in the order in which they are tried; the table exists until the program ends.
const std::vector<SinkKind>& sink_kinds();

// The kind of an output. Throws Error (input), with the output as place, for an unknown ending; the
// message suggests the nearest or, for one picture (still) and for endings of pictures, .png.
const SinkKind& find_sink_kind(const std::string& output, bool still = false);

// Opens the sink for job.output, with a caption file beside it where the format has one (not for
// segments). Throws Error (input), with the output as place, for a job that the kind cannot do:
// transparency, a still as a film, one picture without job.still, odd sizes, an ending without a
// name before it (".mp4"), "hash:" without a name, a film with a frame number (%d) in its name;
// (input) also as find_sink_kind, AtomicFile (base/system/atomic_file.h) and parse_numbered_name
// (video/png_sink.h) do, with --codec as key for a wrong codec, and without a place for a film to a
// terminal; (environment) for a missing encoder and, for a GIF, a missing libavfilter.
std::unique_ptr<FrameSink> make_sink(const SinkJob& job);

}  // namespace polhode
