// SPDX-License-Identifier: MIT
#include "app/render_film.h"

#include <chrono>
#include <memory>

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "app/film_target.h"
#include "app/frame_crew.h"
#include "app/report.h"
#include "base/atomic_file.h"
#include "base/console.h"
#include "video/film_output.h"

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
void refuse_overwriting(const RenderJob& job, const FilmOrder& order) {
  const std::string& output = order.sink.output;
  refuse_same_file(output, "the output", job.scene);
  refuse_same_file(job.report, "--report", job.scene);
  if (output == kStandardOutput && job.report == kStandardOutput) {
    throw input_error("the film goes to standard output already; name a file")
        .at({{}, 0, "--report"});
  }
  refuse_same_file(job.report, "--report", output);
  if (!order.story.empty()) refuse_same_file(job.report, "--report", captions_beside(output));
}

FilmFacts facts_of(const FilmOrder& order, const FilmBasis& film, FilmTarget& target) {
  FilmFacts facts;
  facts.output = order.sink.output;
  facts.frames = target.range().count;
  facts.from_s = film.frames.from;
  facts.to_s = film.frames.to;
  facts.transparent = order.sink.transparent;
  facts.text = order.text;
  facts.still = order.sink.still;
  facts.resume = order.resume;
  if (order.shard) facts.shard = fmt::format("{}/{}", order.shard->number, order.shard->of);
  facts.first_frame = target.range().first;
  facts.jobs = order.jobs;
  for (const StoryStep& step : order.story) {
    facts.captions.push_back(step.caption);
  }
  facts.hashes = target.hashes();
  facts.encoder = order.sink.encoder;
  facts.times.simulate = film.solved.simulate_time;
  facts.times.convert = target.sink().times().convert;
  facts.times.encode = target.sink().times().encode;
  return facts;
}

void add_makers_facts(const FrameMaker& maker, FilmFacts& facts) {
  const MakingTimes times = maker.times();
  facts.renderer = maker.info();
  facts.times.compose = times.compose;
  facts.times.draw = times.render.draw;
  facts.times.read_back = times.render.read_back;
  facts.times.smooth = times.render.smooth;
}

std::string report_text(const FilmBasis& film, const FilmFacts& facts) {
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
  const FilmOrder order = settle_order(job);
  refuse_overwriting(job, order);
  const bool reported = !job.report.empty();
  std::unique_ptr<AtomicFile> report_file;
  if (reported && job.report != "-") report_file = std::make_unique<AtomicFile>(job.report);
  FilmTarget target(order, reported);

  // simulate and plan; open the drawing side, other processes before there is any text here
  const FilmBasis basis = find_basis(order);
  target.begin(basis);
  std::unique_ptr<FrameMaker> maker;
  if (order.jobs > 1) maker = make_crew(order, basis, target.frames());
  const PlannedFilm film(order, basis);
  film.warn();
  if (maker == nullptr) maker = make_drawer(film, order.backend, order.sink.transparent);

  // draw here, convert and encode behind the queue
  Progress progress(job.progress, target.range().count, "frames", target.there());
  fill_target(target, *maker, [&](const PipelineStep& step) {
    progress.show(step.done, target.limit(step));
  });

  // report
  Made made;
  made.output = order.sink.output;
  made.frames = target.range().count;
  made.from_earlier = target.there();
  made.is_picture = order.sink.still;
  if (!reported) return made;
  FilmFacts facts = facts_of(order, basis, target);
  add_makers_facts(*maker, facts);
  maker.reset();  // its processes are reaped, and their time is counted
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
