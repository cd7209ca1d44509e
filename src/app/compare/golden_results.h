// SPDX-License-Identifier: MIT
// Renders golden cases and compares them with their references, for `golden run` and
// `golden update`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/compare/golden_cases.h"
#include "app/compare/golden_job.h"
#include "base/json.h"
#include "image/verdict.h"

namespace polhode {

// The result of one case.
struct CaseResult {
  std::optional<DrawnCase> drawn;  // absent with an error
  // Why the case cannot be rendered or a reference cannot be read; empty if all went well. With an
  // error, `drawn` and `verdict` are absent and `best` is null.
  std::string error;
  const Reference* best = nullptr;  // in the LoadedCase; null: none
  // (the most similar reference of the picture's size, else the first of another size)
  Image reference;                 // pixels of `best`; only valid with a verdict
  std::optional<Verdict> verdict;  // absent: no reference, or only ones of another size
  GoldenVerdict rule;  // the thresholds that were applied; without references, the case's
  std::string note;    // why there is no verdict; only valid without verdict and error

  // Whether the case passes.
  bool same() const { return verdict && verdict->same(); }
  // "same", "different", "no reference" or "error".
  std::string outcome() const {
    if (!drawn) return "error";
    if (best == nullptr) return "no reference";
    return same() ? "same" : "different";
  }
  // Why the case fails; empty if it passes.
  std::string reason() const {
    if (!drawn) return error;
    return verdict ? verdict->reason : note;
  }
};

// Renders all cases, job.jobs at a time, and compares each with all its references. The results are
// in the order of `cases` and point into it, so it must outlive them. Error (input) and
// (check_failed) that a case causes become its result. Throws Error (input), with --backend as key,
// for an unknown back end; (environment) if pictures cannot be drawn or written; (interrupted).
std::vector<CaseResult> draw_cases(const GoldenJob& job, const std::vector<LoadedCase>& cases);

// Whether thresholds and reason are equal.
bool same_rule(const GoldenVerdict& a, const GoldenVerdict& b);

// The value as indented JSON; bytes that are not UTF-8 (in file names) are replaced.
std::string json_text(const Json& json);

}  // namespace polhode
