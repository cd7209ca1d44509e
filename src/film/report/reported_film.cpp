// SPDX-License-Identifier: MIT
#include "film/report/reported_film.h"

#include <filesystem>

#include "base/system/atomic_file.h"
#include "base/system/files.h"
#include "film/report/film_report.h"
#include "scene/canonical.h"
#include "video/encoders.h"

namespace polhode {
namespace fs = std::filesystem;
namespace {

// pixels depend on all of them
void refuse_other_versions(const Json& made_with) {
  const Json now = versions();
  for (const auto& [what, version] : made_with.items()) {
    const Json here = now.value(what, Json());
    if (here == version) continue;
    throw input_error("cannot be compared: it was made with {} {}, this is {}",
                      what,
                      version.dump(),
                      here.dump());
  }
  for (const auto& [what, here] : now.items()) {
    if (made_with.contains(what)) continue;
    throw input_error("cannot be compared: it does not say with which {} it was made; this is {}",
                      what,
                      here.dump());
  }
}

// settings that a user could have asked for
EncoderSettings encoder_from(const std::string& output, const EncoderRecord& record) {
  EncoderWish wish;
  wish.grade = record.finest ? Grade::archive : Grade::lecture;
  wish.codec = record.codec;
  wish.forced = record.preset;
  wish.crf = record.crf;
  EncoderSettings encoder = settle_encoder(output, wish);
  constexpr int kMostThreads = 64;
  encoder.threads = record.threads;
  if (encoder.threads < 1 || encoder.threads > kMostThreads) {
    throw input_error("encoder.threads must be 1 to {}, got {}", kMostThreads, encoder.threads);
  }
  return encoder;
}

// A file that a report names: from where the film was rendered or, of films that were moved
// together with their scenes, from the folder of the report.
std::string found_file(const std::string& named, const fs::path& folder) {
  const fs::path beside = folder / named;
  return !is_there(named) && is_there(beside) ? beside.string() : named;
}

// The scene without lines: those of its text in the report are not those of its file.
Scene scene_of_text(const Json& text, const std::string& file) {
  Scene scene = scene_from_json(text, file);
  scene.lines.clear();
  return scene;
}

Scene scene_from(const FilmReport& record, const fs::path& folder) {
  Scene scene = scene_of_text(record.scene, found_file(record.scene_file, folder));
  if (!record.film) return scene;
  const Json& film = *record.film;
  scene.film_file = film.at("file");
  scene.in_turn = film.value("arrange", "") == "in_turn";
  scene.same_cameras = film.at("cameras") == "same";
  scene.same_scales = film.at("scales") == "same";
  for (const Json& row : film.at("panels")) {
    scene.panels.push_back(
        {row.at("caption"),
         scene_of_text(row.at("scene"), found_file(row.at("scene_file"), folder))});
  }
  if (scene.panels.empty()) throw input_error("has a film without panels");
  return scene;
}

RenderPlan plan_from(const FilmReport& record, const fs::path& folder) {
  RenderPlan plan;
  plan.scene = scene_from(record, folder);
  plan.story = plan.scene.story;
  if (record.captions.size() != plan.story.size()) {
    throw input_error(
        "has {} captions for the {} steps of its story", record.captions.size(), plan.story.size());
  }
  for (std::size_t i = 0; i < plan.story.size(); ++i)
    plan.story[i].caption = record.captions.at(i);
  if (record.still) {
    plan.range = {{}, {}, record.from_s, true};
  } else {
    plan.range = {record.from_s, record.to_s, {}, false};
  }
  plan.sink = sink_of(plan.scene,
                      record.output,
                      encoder_from(record.output, record.encoder),
                      record.transparent,
                      record.still);
  if (record.shard) plan.shard = parse_shard(*record.shard);
  plan.resume = record.resume;
  plan.pieces = record.pieces.value_or(0);
  plan.text = record.text;
  // the number of processes does not show
  plan.setup = {record.backend, record.transparent, 1};
  return plan;
}

std::optional<std::string> contradiction(const FilmReport& record, const ReportedFilm& film) {
  const std::string hash = scene_hash(film.plan.scene);
  if (record.scene_hash != hash) {
    return fmt::format("its scene, or a file that the scene names, has the hash {} and not {}",
                       hash,
                       record.scene_hash);
  }
  if (record.frames != static_cast<int>(film.hashes.size())) {
    return fmt::format("it has {} hashes of {} frames", film.hashes.size(), record.frames);
  }
  // a scene whose film shows no text does not say which it has
  const std::vector<StoryStep>& story = film.plan.scene.story;
  for (std::size_t i = 0; record.text && i < story.size(); ++i) {
    if (story[i].caption != record.captions[i])
      return fmt::format("captions[{}] is not that of its scene", i);
  }
  return std::nullopt;
}

}  // namespace

ReportedFilm read_report(const std::string& file) {
  constexpr std::size_t kLargest = std::size_t{1} << 30;  // bytes
  const std::string text = read_file(file, kLargest);
  const Place place{file, 0, {}};
  try {
    Json report = parse_foreign_json(text);
    refuse_other_versions(report.at("versions"));
    FilmReport record;
    read_json(report, record);
    ReportedFilm film{plan_from(record, fs::path(file).parent_path()),
                      record.gl_renderer,
                      std::move(record.frame_hashes),
                      {},
                      {}};
    film.broken = contradiction(record, film);
    if (!film.broken) check_time_range(film.plan.scene, film.plan.range);
    film.record = std::move(report);
    return film;
  } catch (const Json::exception&) {
    throw input_error("is not a report of `polhode render --report`").at(place);
  } catch (const Error& error) {
    throw Error(error.fault(), fmt::format("{}", error.what()), place);
  }
}

}  // namespace polhode
