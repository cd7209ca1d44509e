// SPDX-License-Identifier: MIT
// Turns the options of `render` into a plan, and checks everything that can be checked before any
// work is done.
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

// A value of --quality: named settings of picture and encoder.
struct Quality {
  std::string name;
  std::string doc;
  int shrink = 1;                // divides the sides of the picture
  std::string preset;            // effort, one of encoder_presets()
  Grade grade = Grade::lecture;  // selects the codec's constant rate factor and pixel format
};
// All values of --quality.
const std::vector<Quality>& qualities();

// The options of `render` as the user gave them.
struct RenderJob {
  std::filesystem::path scene;
  std::string output;  // empty: output/SCENE.mp4
  Overrides overrides;
  std::optional<double> from;   // s of motion; absent: 0
  std::optional<double> to;     // s of motion; absent: the end
  std::optional<double> still;  // s of motion: make a single picture
  std::string quality = "lecture";
  std::optional<std::string> codec;
  std::optional<std::string> preset;
  std::optional<int> crf;
  std::string backend = "auto";
  bool transparent = false;
  int jobs = 1;                      // processes that draw
  bool resume = false;               // work in segments, and continue an earlier run
  std::optional<std::string> shard;  // "K/N"
  bool text = true;                  // false: no labels, clock, title or caption
  std::string report;                // file for the JSON report; empty: none
  ProgressKind progress = ProgressKind::automatic;
};

// How frames are rendered.
struct RenderSetup {
  std::string backend = "auto";  // for open_context()
  bool transparent = false;
  int jobs = 1;  // processes that render; 1: the calling thread renders
};

// A film to be made.
struct RenderPlan {
  Scene scene;                   // with the options applied
  std::vector<StoryStep> story;  // with its captions, even if the picture shows no text
  TimeRange range;               // part of the motion
  SinkJob sink;                  // output and encoder
  std::optional<Shard> shard;    // absent: the whole film
  bool resume = false;
  bool text = true;
  RenderSetup setup;
};

// The job for make_sink() for a film of that scene: size, rate, title and comment.
SinkJob sink_of(const Scene& scene,
                const std::string& output,
                const EncoderSettings& encoder,
                bool transparent,
                bool still);

// The comment in the container of a whole film: version of the program and hash of the scene.
std::string film_comment(const std::string& version, const std::string& scene_hash);

// Makes the plan. Throws Error (input) as load_with_overrides, check_time_range, settle_encoder and
// find_sink_kind do, and naming --quality, --still, --shard, --resume or --jobs.
RenderPlan plan_render(const RenderJob& job);

}  // namespace polhode
