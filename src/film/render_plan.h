// SPDX-License-Identifier: MIT
// From what the user asked of `render` to what is to be made: all that is settled before any work.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/system/progress.h"
#include "film/frame_times.h"
#include "film/output/shard.h"
#include "film/overrides.h"
#include "video/frame_sink.h"

namespace polhode {

// Named settings of picture and encoder.
struct Quality {
  std::string name;
  std::string doc;
  int shrink = 1;                // the picture's sides are divided by this
  std::string preset;            // effort, one of encoder_presets()
  Grade grade = Grade::lecture;  // the codec's own constant rate factor and pixels
};
const std::vector<Quality>& qualities();

struct RenderJob {
  std::filesystem::path scene;
  std::string output;  // empty: output/SCENE.mp4
  Overrides overrides;
  std::optional<double> from;   // s of the motion; absent: 0
  std::optional<double> to;     // s; absent: the whole motion
  std::optional<double> still;  // s; one picture
  std::string quality = "lecture";
  std::optional<std::string> codec;
  std::optional<std::string> preset;
  std::optional<int> crf;
  std::string backend = "auto";
  bool transparent = false;
  int jobs = 1;                      // processes that draw
  bool resume = false;               // keep what is done, and go on from it
  std::optional<std::string> shard;  // "K/N"
  bool text = true;                  // false: no labels, clock, title or caption
  std::string report;                // file for the JSON report; empty: none
  ProgressKind progress = ProgressKind::automatic;
};

// How frames are drawn.
struct RenderSetup {
  std::string backend = "auto";  // of open_context
  bool transparent = false;
  int jobs = 1;  // processes that draw; 1: the calling thread draws
};

// A film that is to be made.
struct RenderPlan {
  Scene scene;                   // with the options' words and size
  std::vector<StoryStep> story;  // with its captions, whatever the picture shows
  TimeRange range;               // of the motion
  SinkJob sink;                  // output and encoder
  std::optional<Shard> shard;    // absent: the whole film
  bool resume = false;
  bool text = true;
  RenderSetup setup;
};

// The sink of a film of that scene: its size, rate, title and comment.
SinkJob sink_of(const Scene& scene,
                const std::string& output,
                const EncoderSettings& encoder,
                bool transparent,
                bool still);

// The comment in a whole film's container: version and hash of the scene.
std::string film_comment(const std::string& version, const std::string& scene_hash);

// Throws Error (input) for all that can be refused before any work.
RenderPlan plan_render(const RenderJob& job);

}  // namespace polhode
