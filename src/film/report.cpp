// SPDX-License-Identifier: MIT
#include "film/report.h"

#include <nlohmann/json.hpp>

#include "base/version.h"
#include "scene/canonical.h"
#include "video/film_sink.h"

namespace polhode {
namespace {

nlohmann::ordered_json stage(const StageTime& time) {
  return {{"wall_s", time.wall_s}, {"cpu_s", time.cpu_s}};
}

// absent numbers are null, so that every report has every key
nlohmann::ordered_json maybe(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

// what the format has none of is null
nlohmann::ordered_json encoder_json(const EncoderSettings& encoder) {
  nlohmann::ordered_json told = {{"codec", nullptr},
                                 {"preset", nullptr},
                                 {"crf", nullptr},
                                 {"threads", encoder.threads},
                                 {"finest", encoder.finest}};
  if (!encoder.codec.empty()) told["codec"] = encoder.codec;
  if (!encoder.preset.empty()) told["preset"] = encoder.preset;
  if (encoder.crf > 0) told["crf"] = encoder.crf;
  return told;
}

}  // namespace

nlohmann::ordered_json versions() {
  return {{"polhode", program_version()},
          {"compiler", __VERSION__},
          {"eigen",
           fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"ffmpeg", libav_version()}};
}

nlohmann::ordered_json motion_report(const SimulationReport& report) {
  return {{"model", report.model},
          {"model_reason", report.model_reason},
          {"method", report.method},
          {"method_reason", report.method_reason},
          {"step_s", maybe(report.step)},
          {"tolerance", maybe(report.tolerance)},
          {"steps", report.record.steps},
          {"rejected_steps", report.record.rejected},
          {"evaluations", report.record.evaluations},
          {"accuracy_rad", report.accuracy_rad},
          {"error_estimate_rad", maybe(report.error_estimate_rad)},
          {"energy_drift", maybe(report.record.drift.energy)},
          {"momentum_drift", maybe(report.record.drift.momentum)},
          {"attitude_error_rad", maybe(report.reliability.attitude_error_rad)},
          {"trusted", report.reliability.doubts.empty()},
          {"doubts", report.reliability.doubts}};
}

nlohmann::ordered_json film_report(const Solved& solved, const FilmFacts& facts) {
  nlohmann::ordered_json report;
  report["output"] = facts.output;
  report["scene_file"] = solved.scene.file;
  report["title"] = solved.scene.title;
  report["scene_hash"] = scene_hash(solved.scene);
  report["versions"] = versions();
  report["backend"] = facts.renderer.backend;
  report["gl_renderer"] = facts.renderer.gl_renderer;
  report["gl_version"] = facts.renderer.gl_version;
  report["samples"] = facts.renderer.samples;
  report["edges"] = facts.renderer.by_outlines ? "outlines" : "samples";
  report.update(motion_report(solved.simulation.report));
  const VideoSpec& video = solved.scene.video;
  report["frames"] = facts.frames;
  report["width"] = video.size.width;
  report["height"] = video.size.height;
  report["fps"] = fmt::format("{}/{}", video.fps.numerator, video.fps.denominator);
  report["from_s"] = facts.from_s;
  report["to_s"] = facts.to_s;
  report["transparent"] = facts.transparent;
  report["text"] = facts.text;
  report["still"] = facts.still;
  report["resume"] = facts.resume;
  report["shard"] = nullptr;
  if (!facts.shard.empty()) report["shard"] = facts.shard;
  report["first_frame"] = facts.first_frame;
  report["jobs"] = facts.jobs;
  report["captions"] = nlohmann::ordered_json::array();
  for (const std::optional<std::string>& caption : facts.captions) {
    report["captions"].push_back(nullptr);
    if (caption) report["captions"].back() = *caption;
  }
  report["encoder"] = encoder_json(facts.encoder);
  report["stages"] = {{"simulate", stage(facts.times.simulate)},
                      {"compose", stage(facts.times.compose)},
                      {"draw", stage(facts.times.draw)},
                      {"read_back", stage(facts.times.read_back)},
                      {"smooth", stage(facts.times.smooth)},
                      {"convert", stage(facts.times.convert)},
                      {"encode", stage(facts.times.encode)}};
  report["total"] = stage(facts.times.total);
  report["scene"] = scene_to_json(solved.scene);
  report["frame_hashes"] = facts.hashes;
  return report;
}

}  // namespace polhode
