// SPDX-License-Identifier: MIT
// Renders golden cases and compares them with their references, for `golden run` and `golden
// update`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/compare/golden_cases.h"
#include "app/compare/golden_job.h"
#include "image/verdict.h"

namespace polhode {

// The result of one case.
struct CaseResult {
  std::optional<DrawnCase> drawn;   // absent if it cannot be rendered
  std::string error;                // why it cannot
  const Reference* best = nullptr;  // the most similar reference; null: there is none
  Image reference;                  // its pixels
  std::optional<Verdict> verdict;   // absent: no reference, or only ones of another size
  GoldenVerdict rule;               // the rule that was applied
  std::string note;                 // why there is no verdict

  bool same() const { return verdict && verdict->same(); }
  // "same", "different", "no reference" or "error".
  std::string outcome() const {
    if (!drawn) return "error";
    if (best == nullptr) return "no reference";
    return same() ? "same" : "different";
  }
  // Why it failed; empty if it is the same.
  std::string reason() const {
    if (!drawn) return error;
    return verdict ? verdict->reason : note;
  }
};

// Renders all cases, job.jobs at a time. An error in a case becomes its result. Throws Error
// (input), naming --backend, for an unknown back end; (environment); (interrupted). The results
// point into `cases`, which must outlive them.
std::vector<CaseResult> draw_cases(const GoldenJob& job, const std::vector<LoadedCase>& cases);

// Whether thresholds and reason are equal.
bool same_rule(const GoldenVerdict& a, const GoldenVerdict& b);

// Indented JSON; bytes that are not UTF-8 (in file names) are replaced.
std::string json_text(const nlohmann::ordered_json& json);

}  // namespace polhode
