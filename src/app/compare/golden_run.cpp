// SPDX-License-Identifier: MIT
#include "app/compare/golden_run.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/compare/diff_page.h"
#include "app/compare/golden_results.h"
#include "base/json.h"
#include "base/system/files.h"
#include "base/system/output_folder.h"
#include "base/system/overwriting.h"
#include "image/png.h"

namespace polhode {
namespace fs = std::filesystem;
namespace {

// what fails leaves pictures where no reference is looked for
void refuse_folder_of_references(const GoldenJob& job) {
  std::error_code ignored;
  const fs::path output = fs::weakly_canonical(job.output, ignored);
  if (output == fs::weakly_canonical(job.folder, ignored))
    throw input_error("is the folder of the references; choose another").at({{}, 0, "--output"});
  // pictures of what fails now are removed there when it passes
  if (!fs::exists(output / "cases.toml", ignored)) return;
  throw input_error("is a folder of references, with its own cases.toml; choose another")
      .at({{}, 0, "--output"});
}

// pictures of failures, for a person; of what passes none are left
void leave_pictures(const fs::path& folder, const LoadedCase& one, const CaseResult& result) {
  const fs::path actual = folder / (one.spec.name + ".actual.png");
  const fs::path difference = folder / (one.spec.name + ".difference.png");
  std::error_code ignored;
  fs::remove(actual, ignored);
  fs::remove(difference, ignored);
  if (!result.drawn || result.same()) return;
  make_folder(folder, {{}, 0, "--output"});
  const Image& image = result.drawn->image;
  write_png(actual, image, !is_opaque(image));
  if (result.verdict) {
    write_png(difference, difference_picture(result.reference, image, kDifferenceGain), false);
  }
}

std::string row(const LoadedCase& one, const CaseResult& result) {
  std::string text = fmt::format("{:<28} {:<15}", one.spec.name, result.outcome());
  if (result.verdict) {
    text += fmt::format(" {:>7} {:>9}  {}",
                        result.verdict->values.largest,
                        percent(result.verdict->values.fraction_over),
                        result.best->file.filename().string());
  }
  if (!result.reason().empty()) text += fmt::format("  {}", result.reason());
  return text + "\n";
}

Json json_of(const LoadedCase& one, const CaseResult& result) {
  Json json = {
      {"name", one.spec.name},
      {"outcome", result.outcome()},
      {"reason", result.reason()},
      {"reference", result.best == nullptr ? Json(nullptr) : Json(result.best->file.string())}};
  if (result.verdict) {
    const Difference& d = result.verdict->values;
    json["largest"] = d.largest;
    json["fraction_over"] = d.fraction_over;
    json["mean"] = d.mean;
    json["rmse"] = d.rms;
    if (result.verdict->ssim) json["ssim"] = *result.verdict->ssim;
    if (result.verdict->flip) json["flip"] = result.verdict->flip->mean;
  }
  if (result.drawn) {
    json["renderer"] = result.drawn->sidecar.renderer;
    json["backend"] = result.drawn->sidecar.backend;
  }
  return json;
}

std::string page_of(const GoldenJob& job,
                    const std::vector<LoadedCase>& cases,
                    const std::vector<CaseResult>& results) {
  std::vector<GoldenSection> sections;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const CaseResult& result = results[i];
    GoldenSection section{cases[i].spec.name,
                          result.outcome(),
                          result.same(),
                          result.reason(),
                          result.rule.thresholds,
                          {}};
    if (result.verdict && !result.same()) {
      const Verdict verdict =
          judge(result.reference, result.drawn->image, result.rule.thresholds, {true, true});
      FrameScore score;
      score.values = verdict.values;
      score.ssim = verdict.ssim;
      score.flip = verdict.flip->mean;
      score.reason = verdict.reason;
      section.shown.push_back(
          {score, result.reference, result.drawn->image, *verdict.flip, cases[i].spec.name});
    }
    sections.push_back(std::move(section));
  }
  return golden_page(fmt::format("Golden pictures of {}", job.folder), sections);
}

int exit_code_of(const std::vector<CaseResult>& results) {
  int code = 0;
  for (const CaseResult& result : results)
    code = std::max(code, !result.drawn ? 2 : result.same() ? 0 : 1);
  return code;
}

}  // namespace

GoldenResult golden_run(const GoldenJob& job) {
  const std::vector<LoadedCase> cases = load_cases(job.folder, job.cases);
  refuse_folder_of_references(job);
  std::unique_ptr<OutputFolder> page;
  if (!job.html.empty()) {
    std::vector<fs::path> needed = scene_files(job.folder, cases);
    for (const LoadedCase& one : cases) {
      for (const Reference& reference : one.references)
        needed.insert(needed.end(), {reference.file, sidecar_file(reference.file)});
    }
    refuse_same_file(fs::path(job.html) / "index.html", "--html", needed);
    page =
        std::make_unique<OutputFolder>(job.html, std::vector<std::string>{"index.html"}, "--html");
  }
  const std::vector<CaseResult> results = draw_cases(job, cases);
  for (std::size_t i = 0; i < cases.size(); ++i)
    leave_pictures(job.output, cases[i], results[i]);
  if (page) page->commit({page_of(job, cases, results)});

  const auto same = std::count_if(
      results.begin(), results.end(), [](const CaseResult& result) { return result.same(); });
  const bool good = same == static_cast<long>(cases.size());
  if (job.json) {
    Json json = {{"folder", job.folder}, {"same", good}, {"cases", Json::array()}};
    for (std::size_t i = 0; i < cases.size(); ++i)
      json["cases"].push_back(json_of(cases[i], results[i]));
    return {exit_code_of(results), json_text(json)};
  }
  std::string text = fmt::format(
      "{:<28} {:<15} {:>7} {:>9}  {}\n", "case", "", "largest", "over max", "reference");
  for (std::size_t i = 0; i < cases.size(); ++i)
    text += row(cases[i], results[i]);
  const bool pictures = std::any_of(results.begin(), results.end(), [](const CaseResult& result) {
    return result.drawn && !result.same();
  });
  text += good ? (cases.size() == 1 ? "the case is the same\n"
                                    : fmt::format("all {} cases are the same\n", cases.size()))
               : fmt::format("{} of {} cases failed{}\n",
                             static_cast<long>(cases.size()) - same,
                             cases.size(),
                             pictures ? "; pictures of what differs are in " + job.output : "");
  return {exit_code_of(results), text};
}

}  // namespace polhode
