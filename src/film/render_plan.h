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
  std::string name;              // "draft", "lecture" or "archive"
  std::string doc;               // one phrase: its purpose
  int shrink = 1;                // divides the sides of the picture, to even numbers of pixels
  std::string preset;            // effort of the encoder: encoder_presets() in video/video_spec.h
  Grade grade = Grade::lecture;  // selects the codec's constant rate factor and pixel format
};
// All values of --quality.
const std::vector<Quality>& qualities();
// Throws Error (input), with --quality as key, if there is none of that name.
const Quality& find_quality(const std::string& name);

// The options of `render` as the user gave them, not yet checked. Values: sink_kinds() in
// video/sink_kinds.h, encoder_presets() in video/video_spec.h, film_formats() in video/encoders.h,
// backend_names() in render/context.h.
struct RenderJob {
  std::filesystem::path scene;
  std::string output;  // as sink_kinds() says; empty: output/SCENE.mp4, or .png with `still`
  Overrides overrides;
  std::optional<double> from;   // s of motion; absent: 0
  std::optional<double> to;     // s of motion; absent: the end
  std::optional<double> still;  // s of motion: make a single picture; absent: a film, unless the
                                // output is a .png without a number in its name
  std::string quality = "lecture";    // one of qualities()
  std::optional<std::string> codec;   // one of the format; absent: the default of the format
  std::optional<std::string> preset;  // one of encoder_presets(); absent: that of the quality
  std::optional<int> crf;             // constant rate factor; absent: that of the quality
  std::string backend = "auto";       // one of backend_names()
  bool transparent = false;           // without background
  int jobs = 1;                       // processes that draw, 1 to 64
  bool resume = false;                // work in segments, and continue an earlier run
  std::optional<int> pieces;          // of --resume; absent: one for each five seconds of film
  std::optional<std::string> shard;   // "K/N": make the K-th of N parts only; absent: everything
  std::string submitted;  // hash of words_of_film() (film/output/segments.h) of the film that was
                          // meant; empty: whatever it is now
  bool text = true;       // false: no labels, clock, title or caption
  std::string report;     // file for the JSON report, "-": stdout; empty: none
  ProgressKind progress = ProgressKind::automatic;
};

// How frames are rendered.
struct RenderSetup {
  std::string backend = "auto";  // for open_context() in render/context.h
  bool transparent = false;      // the background has alpha 0
  int jobs = 1;                  // processes that render; 1: the calling thread renders
};

// A film to be made.
struct RenderPlan {
  Scene scene;                   // with the options applied
  std::vector<StoryStep> story;  // of the scene, with captions even if the picture shows no text
  TimeRange range;               // part of the motion
  SinkJob sink;                  // output and encoder
  std::optional<Shard> shard;    // part of the film to make; absent: the whole film. With resume it
                                 // is a part of the segments, which are kept for the run that joins
  bool resume = false;           // work in segments, and continue an earlier run
  int pieces = 0;                // number of these; 0: one for each five seconds of film
  bool text = true;              // false: the picture shows no text
  RenderSetup setup;
  ProgressKind progress = ProgressKind::none;  // of what comes before the first frame
};

// The job for make_sink() (video/sink_kinds.h) for a film of that scene: the arguments, and size,
// rate, title and comment from the scene. still: a single picture.
SinkJob sink_of(const Scene& scene,
                const std::string& output,
                const EncoderSettings& encoder,
                bool transparent,
                bool still);

// The comment in the container of a whole film: "polhode VERSION, scene HASH".
std::string film_comment(const std::string& version, const std::string& scene_hash);

// Loads the scene and makes the plan. Without job.output it creates the folder output/. Throws
// Error (input) as load_with_overrides, check_time_range, settle_encoder (video/encoders.h) and
// find_sink_kind do, and with --quality, --still, --shard, --resume or --jobs as key for values
// that are invalid or do not suit the output; (environment) as settle_encoder does.
RenderPlan plan_render(const RenderJob& job);

}  // namespace polhode
