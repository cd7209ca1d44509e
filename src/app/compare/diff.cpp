// SPDX-License-Identifier: MIT
#include "app/compare/diff.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/commands/render.h"
#include "app/compare/diff_page.h"
#include "app/compare/frame_pairs.h"
#include "base/json.h"
#include "base/system/output_folder.h"
#include "base/system/overwriting.h"
#include "base/system/scratch_folder.h"
#include "film/overrides.h"
#include "image/png.h"
#include "video/film_reader.h"

namespace polhode {
namespace {

constexpr std::size_t kShownFrames = 3;  // the worst, on the page
constexpr int kShownApart = 30;          // frames from one of them to the next

bool is_scene(const std::string& name) {
  return name.ends_with(".toml");
}

// What a scene must become to be comparable with the other side.
struct Counterpart {
  SourceInfo info;
  int width = 0, height = 0;  // pixels; 0: not known
  bool transparent = false;
};

Counterpart counterpart(const std::string& name) {
  Counterpart found;
  // another scene: each by its own size
  if (is_scene(name)) return found;
  const std::unique_ptr<FrameSource> source = open_frames(name);
  found.info = source->info();
  SourceFrame frame;
  if (!source->next(frame)) throw input_error("contains no frames").at({name, 0, {}});
  found.width = frame.image.width;
  found.height = frame.image.height;
  found.transparent = found.info.kind != SourceKind::film && !is_opaque(frame.image);
  return found;
}

// Draws the scene as a picture, a film or numbered pictures, whichever the other side is; returns
// the name of what was drawn.
std::string rendered(const std::string& scene,
                     const Counterpart& other,
                     const DiffJob& job,
                     const std::string& stem) {
  RenderJob render;
  render.scene = scene;
  render.overrides = job.overrides;
  render.backend = job.backend;
  render.text = job.text;
  render.transparent = other.transparent;
  render.progress = ProgressKind::none;
  if (!render.overrides.size && other.width > 0) {
    render.overrides.size = fmt::format("{}x{}", other.width, other.height);
  }
  const bool film = other.info.kind == SourceKind::film;
  if (other.info.kind == SourceKind::picture) {
    render.still = job.still.value_or(0.0);
    render.output = stem + ".png";
  } else if (job.still) {
    throw input_error("draws one picture; leave it out to compare with a film or a sequence")
        .at({{}, 0, "--still"});
  } else {
    render.output = stem + (film ? ".mp4" : "_%05d.png");
  }
  if (film && !render.overrides.fps) {
    const FrameRate& fps = other.info.fps;
    render.overrides.fps = fmt::format("{}/{}", fps.numerator, fps.denominator);
  }
  try {
    render_film(render);
  } catch (const Error& error) {
    // nothing was compared
    if (error.fault() != Fault::check_failed) throw;
    throw Error(Fault::input, error.message(), error.place());
  }
  return render.output;
}

// Both sides as files; what is drawn lives as long as the scratch folder.
struct Sides {
  std::string actual, reference;  // files
  bool by_order = false;
};

Sides prepare(const DiffJob& job, const ScratchFolder& scratch) {
  Sides sides{job.actual, job.reference, false};
  for (const std::string* name : {&job.actual, &job.reference}) {
    if (is_scene(*name)) refuse_unless_file(*name);
  }
  if (!is_scene(job.actual) && !is_scene(job.reference)) {
    for (const auto& [given, option] : {std::pair{job.still.has_value(), "--still"},
                                        {job.overrides.size.has_value(), "--size"},
                                        {job.overrides.fps.has_value(), "--fps"},
                                        {!job.text, "--no-text"},
                                        {job.backend != DiffJob{}.backend, "--backend"}}) {
      if (given)
        throw input_error("is for scenes, but neither side is a scene").at({{}, 0, option});
    }
    return sides;
  }
  sides.by_order = true;
  if (is_scene(job.actual))
    sides.actual = rendered(job.actual, counterpart(job.reference), job, scratch / "actual");
  if (is_scene(job.reference)) {
    sides.reference = rendered(job.reference, counterpart(job.actual), job, scratch / "reference");
  }
  return sides;
}

// The worst frames with their pixels, worst first. Of frames that follow each other more closely
// than `apart` only the worst is kept: neighbours in a film show the same.
class WorstFrames {
 public:
  WorstFrames(std::size_t most, int apart) : most_(most), apart_(apart) {}

  void offer(const FrameScore& score, const SourceFrame& actual, const SourceFrame& reference) {
    if (most_ == 0) return;
    const auto near = std::find_if(shown_.begin(), shown_.end(), [&](const ShownFrame& one) {
      return score.index - one.score.index < apart_;
    });
    if (near != shown_.end()) {
      if (near->score.badness >= score.badness) return;
      shown_.erase(near);
    }
    const auto place = std::find_if(shown_.begin(), shown_.end(), [&](const ShownFrame& one) {
      return one.score.badness < score.badness;
    });
    if (place == shown_.end() && shown_.size() == most_) return;
    shown_.insert(place, {score, reference.image, actual.image, {}, {}});
    if (shown_.size() > most_) shown_.pop_back();
  }
  // Frames that are the same say nothing beside one that is not.
  std::vector<ShownFrame> take() {
    while (shown_.size() > 1 && shown_.back().score.reason.empty())
      shown_.pop_back();
    return std::move(shown_);
  }

 private:
  std::size_t most_;
  int apart_;
  std::vector<ShownFrame> shown_;
};

Json maybe(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json metrics_json(const Difference& values,
                  const std::optional<double>& ssim,
                  const std::optional<double>& flip) {
  const double ratio = psnr(values.rms);
  return {{"largest", values.largest},
          {"mean", values.mean},
          {"rmse", values.rms},
          {"psnr_db", std::isfinite(ratio) ? Json(ratio) : nullptr},
          {"fraction_over", values.fraction_over},
          {"ssim", maybe(ssim)},
          {"flip", maybe(flip)}};
}

const char* kind_name(SourceKind kind) {
  switch (kind) {
    case SourceKind::picture:
      return "picture";
    case SourceKind::numbered:
      return "sequence";
    case SourceKind::folder:
      return "folder";
    case SourceKind::film:
      return "film";
  }
  return "";
}

// All that is known when the last pair has been seen.
struct Outcome {
  SourceKind kind = SourceKind::picture;
  int width = 0, height = 0;  // pixels
  std::vector<FrameScore> scores;
  std::vector<ShownFrame> shown;
};

std::string reason_of(const Outcome& outcome, const DiffSummary& summary) {
  const FrameScore& worst = outcome.scores[summary.worst];
  if (outcome.scores.size() == 1 || summary.different == 0) return worst.reason;
  return fmt::format("{} of {} frames; in the worst, {}, {}",
                     summary.different,
                     outcome.scores.size(),
                     frame_name(worst, outcome.kind == SourceKind::film),
                     worst.reason);
}

std::string as_json(const DiffJob& job, const Outcome& outcome, const DiffSummary& summary) {
  const Thresholds& t = job.thresholds;
  Json json;
  json["same"] = summary.different == 0;
  json["reason"] = reason_of(outcome, summary);
  json["actual"] = job.actual;
  json["reference"] = job.reference;
  json["kind"] = kind_name(outcome.kind);
  json["width"] = outcome.width;
  json["height"] = outcome.height;
  json["values_per_pixel"] = summary.values.values;
  json["thresholds"] = {{"max", t.max},
                        {"fraction", t.fraction},
                        {"limit", t.limit},
                        {"ssim", maybe(t.ssim)},
                        {"flip", maybe(t.flip)}};
  json.update(metrics_json(summary.values, summary.ssim, summary.flip));
  json["frames"] = outcome.scores.size();
  json["different_frames"] = summary.different;
  if (outcome.scores.size() > 1) {
    json["worst_frame"] = summary.worst;
    json["per_frame"] = Json::array();
    for (const FrameScore& score : outcome.scores) {
      Json row = {{"index", score.index}, {"label", score.label}};
      if (outcome.kind == SourceKind::film) row["time_s"] = score.time;
      row["same"] = score.reason.empty();
      row.update(metrics_json(score.values, score.ssim, score.flip));
      json["per_frame"].push_back(std::move(row));
    }
  }
  // names are bytes, and JSON wants UTF-8
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string as_words(const DiffJob& job, const Outcome& outcome, const DiffSummary& summary) {
  const Difference& d = summary.values;
  const Thresholds& t = job.thresholds;
  const bool many = outcome.scores.size() > 1;
  std::string text = summary.different == 0
                         ? "same\n"
                         : fmt::format("different: {}\n", reason_of(outcome, summary));
  text += fmt::format("  compared       {}x{} pixels{}\n",
                      outcome.width,
                      outcome.height,
                      many ? fmt::format(", {} frames", outcome.scores.size()) : "");
  text +=
      fmt::format("  largest        {} levels of 255 (limit {})\n", d.largest, largest_allowed(t));
  text += fmt::format("  over {:<3} levels {} of the pixels{} (allowed {})\n",
                      t.max,
                      percent(d.fraction_over),
                      many ? " on average" : "",
                      percent(t.fraction));
  text += fmt::format("  mean, RMSE     {:.4g}, {:.4g} levels\n", d.mean, d.rms);
  const double ratio = psnr(d.rms);
  text += std::isfinite(ratio) ? fmt::format("  PSNR           {:.2f} dB\n", ratio)
                               : std::string("  PSNR           infinite: no value differs\n");
  if (summary.ssim) {
    text += fmt::format("  SSIM           {:.6f}{}{}\n",
                        *summary.ssim,
                        many ? " in the worst frame" : "",
                        t.ssim ? fmt::format(" (at least {})", *t.ssim) : "");
  }
  if (summary.flip) {
    text += fmt::format("  FLIP           {:.6f}{}{}\n",
                        *summary.flip,
                        many ? " in the worst frame" : "",
                        t.flip ? fmt::format(" (at most {})", *t.flip) : "");
  }
  return text;
}

// one pair after the other
Outcome compare_all(const DiffJob& job, const Sides& sides) {
  std::unique_ptr<FrameSource> actual = open_frames(sides.actual);
  std::unique_ptr<FrameSource> reference = open_frames(sides.reference);
  Outcome outcome;
  outcome.kind = actual->info().kind;
  FramePairs pairs(
      job.actual, std::move(actual), job.reference, std::move(reference), sides.by_order);
  // a picture has time for SSIM; of a film only what is asked is measured
  const Measures also{outcome.kind == SourceKind::picture, false};
  WorstFrames worst(job.html.empty() ? 0 : kShownFrames,
                    outcome.kind == SourceKind::folder ? 0 : kShownApart);
  Progress progress(job.progress, pairs.count());
  SourceFrame a, b;
  while (pairs.next(a, b)) {
    const Verdict verdict = judge(b.image, a.image, job.thresholds, also);
    FrameScore score;
    score.index = static_cast<int>(outcome.scores.size());
    score.label = a.label;
    score.time = a.time;
    score.values = verdict.values;
    score.ssim = verdict.ssim;
    if (verdict.flip) score.flip = verdict.flip->mean;
    score.reason = verdict.reason;
    score.badness = badness(verdict, job.thresholds);
    worst.offer(score, a, b);
    outcome.width = a.image.width;
    outcome.height = a.image.height;
    outcome.scores.push_back(std::move(score));
    if (pairs.count() > 1) progress.show(static_cast<int>(outcome.scores.size()));
  }
  if (outcome.scores.empty()) throw input_error("contains no frames").at({job.actual, 0, {}});
  outcome.shown = worst.take();
  for (ShownFrame& shown : outcome.shown) {
    shown.title = frame_name(shown.score, outcome.kind == SourceKind::film);
    shown.flip = flip(shown.reference, shown.actual);
    shown.score.flip = shown.flip.mean;
    if (!shown.score.ssim) {
      shown.score.ssim = judge(shown.reference, shown.actual, job.thresholds, {true, false}).ssim;
    }
  }
  return outcome;
}

// the page lands on nothing that is compared
void refuse_overwriting(const DiffJob& job) {
  std::vector<std::filesystem::path> needed;
  for (const std::string* name : {&job.actual, &job.reference}) {
    needed.emplace_back(*name);
    if (!is_scene(*name)) continue;
    const std::vector<std::filesystem::path> files = input_files(load_with_overrides(*name, {}));
    needed.insert(needed.end(), files.begin(), files.end());
  }
  refuse_same_file(std::filesystem::path(job.html) / "index.html", "--html", needed);
}

}  // namespace

DiffResult diff(const DiffJob& job) {
  check_thresholds(job.thresholds);
  std::unique_ptr<OutputFolder> folder;
  if (!job.html.empty()) {
    refuse_overwriting(job);
    folder =
        std::make_unique<OutputFolder>(job.html, std::vector<std::string>{"index.html"}, "--html");
  }
  const ScratchFolder scratch;
  const Outcome outcome = compare_all(job, prepare(job, scratch));
  const DiffSummary summary = summarise(outcome.scores);
  const bool same = summary.different == 0;
  if (folder) {
    const std::string reason = reason_of(outcome, summary);
    folder->commit({diff_page({job.actual,
                               job.reference,
                               same,
                               reason,
                               job.thresholds,
                               summary,
                               outcome.scores,
                               outcome.shown,
                               outcome.kind == SourceKind::film})});
  }
  return {same, job.json ? as_json(job, outcome, summary) : as_words(job, outcome, summary)};
}

}  // namespace polhode
