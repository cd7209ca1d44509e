// SPDX-License-Identifier: MIT
#include "film/reported_film.h"

#include <nlohmann/json.hpp>

#include "base/system/atomic_file.h"
#include "base/version.h"
#include "film/report.h"
#include "film/segments.h"
#include "scene/canonical.h"
#include "video/encoders.h"

namespace polhode {
namespace {

using Json = nlohmann::ordered_json;

// pixels depend on all of them
void refuse_other_versions(const Json& report) {
  const Json now = versions();
  for (const auto& [what, version] : report.at("versions").items()) {
    const Json here = now.value(what, Json());
    if (here == version) continue;
    throw input_error("cannot be compared: it was made with {} {}, this is {}",
                      what,
                      version.dump(),
                      here.dump());
  }
}

// settings that a user could have asked for
EncoderSettings encoder_from(const std::string& output, const Json& json) {
  EncoderWish wish;
  wish.grade = json.at("finest") ? Grade::archive : Grade::lecture;
  if (!json.at("codec").is_null()) wish.codec = json.at("codec").get<std::string>();
  if (!json.at("preset").is_null()) wish.forced = json.at("preset").get<std::string>();
  if (!json.at("crf").is_null()) wish.crf = json.at("crf").get<int>();
  EncoderSettings encoder = settle_encoder(output, wish);
  constexpr int kMostThreads = 64;
  encoder.threads = json.at("threads");
  if (encoder.threads < 1 || encoder.threads > kMostThreads) {
    throw input_error("encoder.threads must be 1 to {}, got {}", kMostThreads, encoder.threads);
  }
  return encoder;
}

std::vector<StoryStep> story_from(const Json& captions, std::vector<StoryStep> story) {
  for (std::size_t i = 0; i < story.size(); ++i) {
    const Json& caption = captions.at(i);
    story[i].caption.reset();
    if (!caption.is_null()) story[i].caption = caption.get<std::string>();
  }
  return story;
}

RenderPlan order_from(const Json& report) {
  RenderPlan plan;
  plan.scene = scene_from_json(report.at("scene"), report.at("scene_file"));
  plan.story = story_from(report.at("captions"), plan.scene.story);
  const bool still = report.at("still");
  const double from = report.at("from_s"), to = report.at("to_s");
  if (still) {
    plan.range = {{}, {}, from, true};
  } else {
    plan.range = {from, to, {}, false};
  }
  SinkJob& sink = plan.sink;
  sink.output = report.at("output");
  sink.width = plan.scene.video.size.width;
  sink.height = plan.scene.video.size.height;
  sink.fps = plan.scene.video.fps;
  sink.encoder = encoder_from(sink.output, report.at("encoder"));
  sink.transparent = report.at("transparent");
  sink.still = still;
  sink.title = plan.scene.title;
  sink.comment = film_comment(program_version(), scene_hash(plan.scene));
  if (!report.at("shard").is_null()) plan.shard = parse_shard(report.at("shard"));
  plan.resume = report.at("resume");
  plan.text = report.at("text");
  plan.backend = report.at("backend");
  return plan;
}

std::optional<std::string> contradiction(const Json& report, const ReportedFilm& film) {
  const std::string hash = scene_hash(film.plan.scene);
  if (report.at("scene_hash") != hash) {
    return fmt::format("its scene, or a file that the scene names, has the hash {} and not {}",
                       hash,
                       report.at("scene_hash").get<std::string>());
  }
  if (report.at("frames") != film.hashes.size()) {
    return fmt::format(
        "it has {} hashes of {} frames", film.hashes.size(), report.at("frames").dump());
  }
  return std::nullopt;
}

}  // namespace

ReportedFilm read_report(const std::string& file) {
  constexpr std::size_t kLargest = std::size_t{1} << 30;  // bytes
  const std::string text = read_file(file, kLargest);
  const Place place{file, 0, {}};
  try {
    const Json report = Json::parse(text);
    refuse_other_versions(report);
    ReportedFilm film;
    film.plan = order_from(report);
    film.gl_renderer = report.at("gl_renderer");
    film.first_frame = report.at("first_frame");
    report.at("frame_hashes").get_to(film.hashes);
    film.broken = contradiction(report, film);
    if (!film.broken) check_time_range(film.plan.scene, film.plan.range);
    return film;
  } catch (const Json::exception&) {
    throw input_error("is no report of `polhode render --report`").at(place);
  } catch (const Error& error) {
    throw Error(error.fault(), fmt::format("{}", error.what()), place);
  }
}

}  // namespace polhode
