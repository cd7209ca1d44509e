// SPDX-License-Identifier: MIT
#include "film/output/segments.h"

#include <array>
#include <cstdint>

#include "base/at_place.h"
#include "base/json.h"
#include "base/version.h"
#include "video/film_joiner.h"
#include "video/film_sink.h"

namespace polhode {
namespace {

constexpr std::string_view kBegin = "; piece ";

std::map<std::string, std::string> settings_of(const SinkJob& sink,
                                               const std::string& from,
                                               const std::string& to) {
  return {{"codec", sink.encoder.codec},
          {"preset", sink.encoder.preset},
          {"crf", fmt::format("{}", sink.encoder.crf)},
          {"finest", fmt::format("{}", sink.encoder.finest)},
          {"threads", fmt::format("{}", sink.encoder.threads)},
          {"size", fmt::format("{}x{}", sink.width, sink.height)},
          {"fps", fmt::format("{}/{}", sink.fps.numerator, sink.fps.denominator)},
          {"from", from},
          {"to", to},
          {"transparent", fmt::format("{}", sink.transparent)}};
}

Json chapters_json(const FilmMetadata& metadata) {
  Json all = Json::array();
  for (const FilmMetadata::Chapter& chapter : metadata.chapters) {
    all.push_back({chapter.start, chapter.title});
  }
  return all;
}

Json captions_json(const FilmMetadata& metadata) {
  Json all = Json::array();
  for (const FilmMetadata::Caption& caption : metadata.captions) {
    all.push_back({caption.start, caption.end, caption.words});
  }
  return all;
}

Error missing(const std::string& key) {
  return input_error("its record lacks '{}'; make the piece again with --shard", key);
}

// the keys of comment_with() and settings_of()
constexpr std::array kKeys = {"polhode",
                              "ffmpeg",
                              "scene",
                              "title",
                              "settings",
                              "shard",
                              "first",
                              "count",
                              "frames",
                              "chapters",
                              "captions"};
constexpr std::array kSettings = {
    "codec", "preset", "crf", "finest", "threads", "size", "fps", "from", "to", "transparent"};

SegmentRecord record_from(const Json& json) {
  for (const char* key : kKeys) {
    if (!json.contains(key)) throw missing(key);
  }
  SegmentRecord record;
  json.at("polhode").get_to(record.version);
  json.at("ffmpeg").get_to(record.ffmpeg);
  json.at("scene").get_to(record.scene);
  json.at("title").get_to(record.title);
  json.at("settings").get_to(record.settings);
  for (const char* key : kSettings) {
    if (!record.settings.contains(key)) throw missing(fmt::format("settings.{}", key));
  }
  parse_frame_rate(record.settings.at("fps"));
  record.shard = {json.at("shard").at(0), json.at("shard").at(1)};
  record.range = {json.at("first"), json.at("count")};
  json.at("frames").get_to(record.film.frames);
  for (const Json& chapter : json.at("chapters")) {
    record.film.chapters.push_back({chapter.at(0), chapter.at(1)});
  }
  for (const Json& caption : json.at("captions")) {
    record.film.captions.push_back({caption.at(0), caption.at(1), caption.at(2)});
  }
  return record;
}

// a record that contradicts itself was not written by us
bool consistent(const SegmentRecord& record) {
  const Shard& shard = record.shard;
  if (shard.number < 1 || shard.number > shard.of || record.film.frames < shard.of) return false;
  const FrameRange range = range_of(shard, record.film.frames);
  return range.first == record.range.first && range.count == record.range.count;
}

}  // namespace

std::string words_of_film(const RenderPlan& plan) {
  const auto time = [](const std::optional<double>& t) {
    return t ? fmt::format("{}", *t) : "";
  };
  return fmt::format(
      "polhode {} {} {} {} {} {}",
      program_version(),
      libav_version(),
      scene_hash(plan.scene),
      Json(settings_of(plan.sink, time(plan.range.from), time(plan.range.to))).dump(),
      plan.setup.backend,
      Json(plan.sink.title).dump());
}

SegmentRecord record_of(const RenderPlan& plan,
                        const PreparedFilm& film,
                        const FilmMetadata& metadata,
                        const Shard& shard) {
  return {
      program_version(),
      libav_version(),
      scene_hash(film.solved().scene),
      plan.sink.title,
      settings_of(
          plan.sink, fmt::format("{}", film.frames().from), fmt::format("{}", film.frames().to)),
      shard,
      range_of(shard, metadata.frames),
      metadata};
}

std::string comment_with(const SegmentRecord& record) {
  const Json json = {{"polhode", record.version},
                     {"ffmpeg", record.ffmpeg},
                     {"scene", record.scene},
                     {"title", record.title},
                     {"settings", record.settings},
                     {"shard", {record.shard.number, record.shard.of}},
                     {"first", record.range.first},
                     {"count", record.range.count},
                     {"frames", record.film.frames},
                     {"chapters", chapters_json(record.film)},
                     {"captions", captions_json(record.film)}};
  std::string comment =
      fmt::format("{}{}{}", film_comment(record.version, record.scene), kBegin, json.dump());
  // what a tag of a .mov can hold
  constexpr std::size_t kMost = 60000;  // bytes
  if (comment.size() > kMost) {
    throw input_error("the story has too much text for a piece to carry; render the film whole");
  }
  return comment;
}

SegmentRecord parse_record(const std::string& comment) {
  const std::size_t begin = comment.find(kBegin);
  const Error none =
      input_error("is not a piece of a film; `polhode render SCENE --shard K/N` makes them");
  if (begin == std::string::npos) throw none;
  try {
    const Json json = parse_foreign_json(comment.substr(begin + kBegin.size()));
    if (json.is_null()) throw none;
    SegmentRecord record = record_from(json);
    if (!consistent(record)) throw none;
    return record;
  } catch (const Json::exception&) {
    throw none;
  }
}

SegmentRecord record_in(const std::string& file) {
  return at_place({file, 0, {}}, [&] { return parse_record(comment_of_film(file)); });
}

std::string difference_between(const SegmentRecord& a, const SegmentRecord& b) {
  if (a.version != b.version) {
    return fmt::format("versions differ (Polhode {} and {})", a.version, b.version);
  }
  if (a.ffmpeg != b.ffmpeg) {
    return fmt::format("versions differ (FFmpeg {} and {})", a.ffmpeg, b.ffmpeg);
  }
  if (a.scene != b.scene) return "scenes differ, or options that change them";
  for (const auto& [key, value] : a.settings) {
    const auto other = b.settings.find(key);
    if (other == b.settings.end()) return fmt::format("settings differ ({})", key);
    if (value != other->second) {
      return fmt::format("settings differ ({} {} and {})", key, value, other->second);
    }
  }
  if (a.shard.of != b.shard.of) {
    return fmt::format("one is of {} pieces, the other of {}", a.shard.of, b.shard.of);
  }
  if (a.film.frames != b.film.frames) return "films differ in length";
  return "";
}

FilmMetadata metadata_of_segment(const FilmMetadata& film, const FrameRange& range) {
  FilmMetadata metadata;
  metadata.first = range.first;
  metadata.frames = range.count;
  for (const int frame : film.key_frames) {
    const int inside = frame - range.first;
    if (inside > 0 && inside < range.count) metadata.key_frames.push_back(inside);
  }
  return metadata;
}

}  // namespace polhode
