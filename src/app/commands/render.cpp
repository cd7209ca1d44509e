// SPDX-License-Identifier: MIT
#include "app/commands/render.h"

#include <chrono>
#include <memory>

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "base/system/atomic_file.h"
#include "base/system/console.h"
#include "film/frame_workers.h"
#include "film/render_output.h"
#include "film/report.h"
#include "video/libav/film_output.h"

namespace polhode {
namespace {

// of this process and of those that have ended
double process_cpu_seconds() {
  double sum = 0.0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    for (const timeval& t : {usage.ru_utime, usage.ru_stime}) {
      sum += static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    }
  }
  return sum;
}

// no output lands on what is needed, or on another output
void refuse_overwriting(const RenderJob& job, const RenderPlan& plan) {
  const std::string& output = plan.sink.output;
  refuse_same_file(output, "the output", job.scene);
  refuse_same_file(job.report, "--report", job.scene);
  if (output == kStandardOutput && job.report == kStandardOutput) {
    throw input_error("the film goes to standard output already; name a file")
        .at({{}, 0, "--report"});
  }
  refuse_same_file(job.report, "--report", output);
  if (!plan.story.empty()) refuse_same_file(job.report, "--report", captions_beside(output));
}

FilmFacts facts_of(const RenderPlan& plan, const PreparedFilm& film, RenderOutput& target) {
  FilmFacts facts;
  facts.output = plan.sink.output;
  facts.frames = target.range().count;
  facts.from_s = film.frames.from;
  facts.to_s = film.frames.to;
  facts.transparent = plan.sink.transparent;
  facts.text = plan.text;
  facts.still = plan.sink.still;
  facts.resume = plan.resume;
  if (plan.shard) facts.shard = fmt::format("{}/{}", plan.shard->number, plan.shard->of);
  facts.first_frame = target.range().first;
  facts.jobs = plan.jobs;
  for (const StoryStep& step : plan.story) {
    facts.captions.push_back(step.caption);
  }
  facts.hashes = target.hashes();
  facts.encoder = plan.sink.encoder;
  facts.times.simulate = film.solved.simulate_time;
  facts.times.convert = target.sink().times().convert;
  facts.times.encode = target.sink().times().encode;
  return facts;
}

void add_renderer_facts(const FrameRenderer& renderer, FilmFacts& facts) {
  const DrawingTimes times = renderer.times();
  facts.renderer = renderer.info();
  facts.times.compose = times.compose;
  facts.times.draw = times.render.draw;
  facts.times.read_back = times.render.read_back;
  facts.times.smooth = times.render.smooth;
}

std::string report_text(const PreparedFilm& film, const FilmFacts& facts) {
  nlohmann::ordered_json told = film_report(film.solved, facts);
  if (film.comparison != nullptr) told["compare"] = film.comparison->report();
  if (film.frames.loop) {
    told["loop"] = {{"duration_s", film.frames.loop->duration},
                    {"residual_rad", film.frames.loop->residual}};
  }
  return told.dump(2) + "\n";
}

}  // namespace

Made render_film(const RenderJob& job) {
  const auto wall_start = std::chrono::steady_clock::now();

  // load and check everything that can be checked before work begins
  const RenderPlan plan = plan_render(job);
  refuse_overwriting(job, plan);
  const bool reported = !job.report.empty();
  std::unique_ptr<AtomicFile> report_file;
  if (reported && job.report != "-") report_file = std::make_unique<AtomicFile>(job.report);
  RenderOutput target(plan, reported);

  // simulate and plan; open the drawing side, other processes before there is any text here
  const PreparedFilm basis = prepare_film(plan);
  target.begin(basis);
  std::unique_ptr<FrameRenderer> renderer;
  if (plan.jobs > 1) renderer = start_frame_workers(plan, basis, target.frames());
  const FilmFrames film(plan, basis);
  film.warn();
  if (renderer == nullptr)
    renderer = make_frame_renderer(film, plan.backend, plan.sink.transparent);

  // draw here, convert and encode behind the queue
  Progress progress(job.progress, target.range().count, "frames", target.there());
  fill_output(target, *renderer, [&](const PipelineStep& step) {
    progress.show(step.done, target.limit(step));
  });

  // report
  Made made;
  made.output = plan.sink.output;
  made.frames = target.range().count;
  made.every = target.sink().keeps_every();
  made.from_earlier = target.there();
  made.is_picture = plan.sink.still;
  if (!reported) return made;
  FilmFacts facts = facts_of(plan, basis, target);
  add_renderer_facts(*renderer, facts);
  renderer.reset();  // its processes are reaped, and their time is counted
  facts.times.total.wall_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
  facts.times.total.cpu_s = process_cpu_seconds();
  const std::string report = report_text(basis, facts);
  if (report_file == nullptr) {
    print_out(report);
  } else {
    report_file->commit_with(report);
  }
  return made;
}

}  // namespace polhode
