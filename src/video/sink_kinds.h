// SPDX-License-Identifier: MIT
// The table of what can be written.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "video/frame_sink.h"

namespace polhode {

// One row per kind of output: how it is recognised and made.
struct SinkKind {
  std::string name;                                      // "mp4"
  std::string ending;                                    // ".mp4"; empty when recognised otherwise
  std::string doc;                                       // one phrase for `list formats`
  bool alpha = false;                                    // can keep transparency
  bool film = false;                                     // one file of many frames, for people
  bool (*accepts)(const std::string& output) = nullptr;  // null: by the ending
  std::unique_ptr<FrameSink> (*make)(const SinkJob&) = nullptr;
};

// All kinds, in the order in which they are tried.
const std::vector<SinkKind>& sink_kinds();

// The kind of that output. Throws Error (input) for an unknown ending (naming the nearest).
const SinkKind& find_sink_kind(const std::string& output);

// The sink for job.output. Throws Error (input) for an unknown ending (naming the nearest), odd
// film sizes, a folder that cannot be written; (environment) for a missing encoder.
std::unique_ptr<FrameSink> make_sink(const SinkJob& job);

}  // namespace polhode
