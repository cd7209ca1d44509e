// SPDX-License-Identifier: MIT
#include "film/report/film_report.h"

#include "scene/canonical.h"

namespace polhode {
namespace {

EncoderRecord record_of(const EncoderSettings& encoder) {
  EncoderRecord record;
  if (!encoder.codec.empty()) record.codec = encoder.codec;
  if (!encoder.preset.empty()) record.preset = encoder.preset;
  if (encoder.crf > 0) record.crf = encoder.crf;
  record.threads = encoder.threads;
  record.finest = encoder.finest;
  return record;
}

FilmTimes times_of(const PreparedFilm& film, const SinkTimes& sink, const DrawingTimes& drawing) {
  return {.simulate = film.solved().simulate_time,
          .compose = drawing.compose,
          .draw = drawing.render.draw,
          .read_back = drawing.render.read_back,
          .smooth = drawing.render.smooth,
          .convert = sink.convert,
          .encode = sink.encode};
}

Json several_scenes(const PreparedFilm& film) {
  const Scene& first = film.solved().scene;
  Json list = Json::array();
  for (std::size_t i = 0; i < first.panels.size(); ++i) {
    const ScenePanel& panel = first.panels[i];
    Json row = {{"caption", panel.caption},
                {"scene_file", panel.scene.file},
                {"scene_hash", scene_hash(panel.scene)}};
    row.update(json_of(film.all_solved()[i].simulation.report));
    row["scene"] = scene_to_json(panel.scene);
    list.push_back(row);
  }
  return {{"file", first.film_file},
          {"arrange", first.in_turn ? "in_turn" : "side_by_side"},
          {"cameras", first.same_cameras ? "same" : "own"},
          {"scales", first.same_scales ? "same" : "own"},
          {"panels", list}};
}

// what can be said of all motions of a film
void add_doubts(const PreparedFilm& film, SimulationReport& report) {
  const std::vector<ScenePanel>& panels = film.solved().scene.panels;
  for (std::size_t i = 1; i < panels.size(); ++i) {
    for (const std::string& doubt : film.all_solved()[i].simulation.report.reliability.doubts)
      report.reliability.doubts.push_back(fmt::format("{}: {}", panels[i].caption, doubt));
  }
}

}  // namespace

FilmReport film_report(const RenderPlan& plan,
                       const PreparedFilm& film,
                       const RenderOutput& output,
                       const FrameRenderer& renderer) {
  const Scene& scene = film.solved().scene;
  const RendererInfo& drawn_by = renderer.info();
  FilmReport record;
  record.output = plan.sink.output;
  record.scene_file = scene.file;
  record.title = scene.title;
  record.scene_hash = scene_hash(scene);
  record.versions = versions();
  record.backend = drawn_by.backend;
  record.gl_renderer = drawn_by.gl_renderer;
  record.gl_version = drawn_by.gl_version;
  record.samples = drawn_by.samples;
  record.edges = drawn_by.by_outlines ? "outlines" : "samples";
  record.motion = film.solved().simulation.report;
  add_doubts(film, record.motion);
  record.frames = output.range().count;
  record.size = scene.video.size;
  record.fps = scene.video.fps;
  record.from_s = film.frames().from;
  record.to_s = film.frames().to;
  record.transparent = plan.sink.transparent;
  record.text = plan.text;
  record.still = plan.sink.still;
  record.resume = plan.resume;
  if (plan.pieces != 0) record.pieces = plan.pieces;
  if (plan.shard) record.shard = name_of(*plan.shard);
  record.first_frame = output.range().first;
  record.jobs = plan.setup.jobs;
  for (const StoryStep& step : plan.story)
    record.captions.push_back(step.caption);
  record.encoder = record_of(plan.sink.encoder);
  record.stages = times_of(film, output.times(), renderer.times());
  record.scene = scene_to_json(scene);
  record.frame_hashes = output.hashes();
  if (film.comparison() != nullptr) record.compare = film.comparison()->report();
  if (!scene.panels.empty()) record.film = several_scenes(film);
  record.loop = film.frames().loop;
  return record;
}

}  // namespace polhode
