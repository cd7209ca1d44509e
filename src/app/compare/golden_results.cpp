// SPDX-License-Identifier: MIT
#include "app/compare/golden_results.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

#include "base/json.h"
#include "base/nearest.h"
#include "base/system/interrupt.h"
#include "base/system/parallel.h"
#include "base/system/progress.h"
#include "image/png.h"
#include "render/context.h"

namespace polhode {
namespace {

const GoldenVerdict& rule_of(const Reference& reference, const LoadedCase& one) {
  return reference.has_sidecar ? reference.sidecar.verdict : one.verdict;
}

// against every reference; the one that it is most like counts
void hold_against_references(const LoadedCase& one, CaseResult& result) {
  double least = 0.0;
  for (const Reference& reference : one.references) {
    Image pixels = read_png(reference.file);
    const Image& actual = result.drawn->image;
    const bool first = result.best == nullptr;
    if (pixels.width != actual.width || pixels.height != actual.height) {
      if (!first) continue;
      result.best = &reference;
      result.rule = rule_of(reference, one);
      result.note = fmt::format("the reference is {}x{} pixels, the picture {}x{}",
                                pixels.width,
                                pixels.height,
                                actual.width,
                                actual.height);
      continue;
    }
    const GoldenVerdict& rule = rule_of(reference, one);
    Verdict verdict = judge(pixels, actual, rule.thresholds, {}, 1);
    const double bad = badness(verdict, rule.thresholds);
    if (result.verdict && bad >= least) continue;
    least = bad;
    result.best = &reference;
    result.reference = std::move(pixels);
    result.verdict = std::move(verdict);
    result.rule = rule;
  }
  if (one.references.empty()) result.note = "`polhode golden update` makes one";
}

}  // namespace

std::vector<CaseResult> draw_cases(const GoldenJob& job, const std::vector<LoadedCase>& cases) {
  // a wrong name is the user's fault, not every case's
  const std::vector<std::string> names = backend_names();
  if (std::find(names.begin(), names.end(), job.backend) == names.end()) {
    throw input_error("unknown back end '{}'{}", job.backend, suggestion(job.backend, names))
        .at({{}, 0, "--backend"});
  }
  std::vector<CaseResult> results(cases.size());
  const ScratchFolder scratch;
  std::atomic<int> done = 0;
  std::mutex showing;
  Progress progress(job.progress, static_cast<int>(cases.size()), "cases");
  parallel_for(static_cast<long>(cases.size()), job.jobs, [&](long i) {
    stop_if_interrupted();
    const LoadedCase& one = cases[static_cast<std::size_t>(i)];
    CaseResult& kept = results[static_cast<std::size_t>(i)];
    kept.rule = one.verdict;
    try {
      CaseResult result;
      result.rule = one.verdict;
      result.drawn = draw_case(job.folder, one.spec, job.backend, scratch);
      hold_against_references(one, result);
      kept = std::move(result);
    } catch (const Error& error) {
      if (error.fault() == Fault::environment || error.fault() == Fault::interrupted) throw;
      // an unreadable reference, too, leaves nothing that could pass for a result
      kept.error = error.what();
    }
    const std::lock_guard lock(showing);
    progress.show(++done);
  });
  return results;
}

bool same_rule(const GoldenVerdict& a, const GoldenVerdict& b) {
  const Thresholds& s = a.thresholds;
  const Thresholds& t = b.thresholds;
  return a.reason == b.reason && s.max == t.max && s.fraction == t.fraction && s.limit == t.limit &&
         s.ssim == t.ssim && s.flip == t.flip;
}

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace polhode
