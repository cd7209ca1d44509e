// SPDX-License-Identifier: MIT
#include "film/render_plan.h"

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "base/nearest.h"
#include "base/system/files.h"
#include "base/version.h"
#include "film/overrides.h"
#include "video/encoders.h"
#include "video/frame_sink.h"
#include "video/gif_sink.h"
#include "video/plain_sinks.h"
#include "video/png_sink.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace {

// a .png without a number in its name is one picture, and only that takes --still
bool is_still(const RenderJob& job, const std::string& output) {
  const bool numbered = has_percent(output);
  const bool picture = output.ends_with(".png") && !numbered && !output.starts_with(kHashPrefix);
  if (job.still && output.ends_with(".png") && numbered) {
    throw input_error("makes one picture, but '{}' is a numbered sequence; leave out the %", output)
        .at({{}, 0, "--still"});
  }
  if (job.still && find_sink_kind(output, true).film) {
    throw input_error("makes one picture, but '{}' is a film; name a .png", output)
        .at({{}, 0, "--still"});
  }
  return job.still || picture;
}

// the default name; its folder is made if need be
std::string output_of(const RenderJob& job) {
  if (!job.output.empty()) return job.output;
  const std::string stem = job.scene.stem().string();
  if (job.still && stem.find('%') != std::string::npos) {
    throw input_error("name the picture: after '{}', whose % would number it, it cannot be named",
                      job.scene.string())
        .at({{}, 0, "--output"});
  }
  make_folder("output");
  return "output/" + stem + (job.still ? ".png" : ".mp4");
}

void remove_text(Scene& scene) {
  scene.show.labels = false;
  scene.show.title = false;
  scene.show.clock = false;
  scene.show.caption.clear();
  for (StoryStep& step : scene.story)
    step.caption.reset();
}

void shrink(Scene& scene, int factor) {
  // even sides stay even
  PictureSize& size = scene.video.size;
  if (factor > 1) {
    size.width = std::max(kSmallestSide, size.width / (2 * factor) * 2);
    size.height = std::max(kSmallestSide, size.height / (2 * factor) * 2);
  }
}

// a piece is of a film, or of numbered pictures or hashes
void check_shard(const RenderPlan& plan, const std::optional<int>& pieces) {
  const std::string& output = plan.sink.output;
  const FilmFormat* format = find_film_format(output);
  const bool numbered = find_sink_kind(output).name == "png sequence";
  const bool hashes = find_sink_kind(output).name == "hash";
  const bool film = format != nullptr && format->keeps_metadata;
  if (plan.shard && (plan.sink.still || !(film || numbered || hashes))) {
    throw input_error(
        "'{}' cannot be made in pieces: choose a .mp4, .webm, .mov, numbered .png or "
        ".hash",
        output)
        .at({{}, 0, "--shard"});
  }
  if (plan.resume && !film) {
    throw input_error("'{}' cannot be resumed: choose a .mp4, .webm or .mov{}",
                      output,
                      numbered || hashes ? ", or use --shard" : "")
        .at({{}, 0, "--resume"});
  }
  constexpr int kMostPieces = 100000;
  if (!pieces) return;
  if (!plan.resume)
    throw input_error("is the number of pieces of --resume").at({{}, 0, "--pieces"});
  if (*pieces < 1 || *pieces > kMostPieces) {
    throw input_error("must be from 1 to {}, got {}", kMostPieces, *pieces).at({{}, 0, "--pieces"});
  }
}

// What a GIF cannot show is not drawn. Returns the rate that was asked for, where it is another.
std::optional<FrameRate> slow_down_for_gif(Scene& scene) {
  const FrameRate asked = scene.video.fps;
  const FrameRate shown = gif_rate(asked);
  if (shown == asked) return {};
  for_each_scene(scene, [&](Scene& one) { one.video.fps = shown; });
  return asked;
}

}  // namespace

const Quality& find_quality(const std::string& name) {
  std::vector<std::string> names;
  for (const Quality& row : qualities()) {
    if (row.name == name) return row;
    names.push_back(row.name);
  }
  throw input_error("unknown quality '{}'{}", name, suggestion(name, names))
      .at({{}, 0, "--quality"});
}

const std::vector<Quality>& qualities() {
  static const std::vector<Quality> table = {
      {"draft", "half size, fast", 2, "ultrafast", Grade::draft},
      {"lecture", "for projection", 1, "veryfast", Grade::lecture},
      {"archive", "for keeping, slow", 1, "slow", Grade::archive},
  };
  return table;
}

SinkJob sink_of(const Scene& scene,
                const std::string& output,
                const EncoderSettings& encoder,
                bool transparent,
                bool still) {
  SinkJob sink;
  sink.output = output;
  sink.width = scene.video.size.width;
  sink.height = scene.video.size.height;
  sink.fps = scene.video.fps;
  sink.encoder = encoder;
  sink.transparent = transparent;
  sink.still = still;
  sink.title = scene.title;
  sink.comment = film_comment(program_version(), scene_hash(scene));
  return sink;
}

std::string film_comment(const std::string& version, const std::string& scene_hash) {
  return fmt::format("polhode {}, scene {}", version, scene_hash);
}

RenderPlan plan_render(const RenderJob& job) {
  const Quality& quality = find_quality(job.quality);
  RenderPlan plan;
  plan.scene = load_with_overrides(job.scene, job.overrides);
  plan.story = plan.scene.story;
  for_each_scene(plan.scene, [&](Scene& scene) {
    if (!job.text) remove_text(scene);
    shrink(scene, quality.shrink);
    // laid over something else, a floor would be a patch
    std::optional<bool>& floor = scene.show["floor"];
    if (job.transparent && !floor) floor = false;
  });
  const std::string output = output_of(job);
  const bool still = is_still(job, output);
  std::optional<FrameRate> asked_fps;
  if (!still && find_sink_kind(output).name == "gif") asked_fps = slow_down_for_gif(plan.scene);
  plan.range = {job.from, job.to, job.still, still};
  check_time_range(plan.scene, plan.range);
  const EncoderSettings encoder =
      settle_encoder(output, {quality.grade, quality.preset, job.codec, job.preset, job.crf});
  plan.sink = sink_of(plan.scene, output, encoder, job.transparent, still);
  plan.sink.asked_fps = asked_fps;
  plan.sink.captions = std::any_of(plan.story.begin(), plan.story.end(), [](const StoryStep& step) {
    return step.caption && !step.caption->empty();
  });
  if (job.shard) plan.shard = parse_shard(*job.shard);
  plan.resume = job.resume;
  check_shard(plan, job.pieces);
  plan.pieces = job.pieces.value_or(0);
  plan.text = job.text;
  plan.progress = job.progress;
  if (job.jobs < 1) throw input_error("must be at least 1, got {}", job.jobs).at({{}, 0, "--jobs"});
  constexpr int kMostJobs = 64;
  if (job.jobs > kMostJobs) {
    throw input_error("must be at most {}, got {}", kMostJobs, job.jobs).at({{}, 0, "--jobs"});
  }
  plan.setup = {job.backend, job.transparent, job.jobs};
  return plan;
}

}  // namespace polhode
