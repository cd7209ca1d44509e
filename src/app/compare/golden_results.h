// SPDX-License-Identifier: MIT
// Cases of golden pictures, drawn and held against their references: what `run` tells and `update`
// mends.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/compare/golden_cases.h"
#include "app/compare/golden_job.h"
#include "image/verdict.h"

namespace polhode {

// A case, drawn and held against its references.
struct CaseResult {
  std::optional<DrawnCase> drawn;   // absent when it cannot be drawn
  std::string error;                // why not
  const Reference* best = nullptr;  // the reference that it is most like
  Image reference;                  // its pixels
  std::optional<Verdict> verdict;   // absent: no reference, or one of another size
  GoldenVerdict rule;               // what it was judged by
  std::string note;                 // why there is no verdict

  bool same() const { return verdict && verdict->same(); }
  std::string outcome() const {
    if (!drawn) return "error";
    if (best == nullptr) return "no reference";
    return same() ? "same" : "different";
  }
  std::string reason() const {
    if (!drawn) return error;
    return verdict ? verdict->reason : note;
  }
};

// Draws all cases, several at a time. What is wrong with a case is its result; what is wrong with
// the machine, and an interrupt, ends the run as an Error. The results point into `cases`.
std::vector<CaseResult> draw_cases(const GoldenJob& job, const std::vector<LoadedCase>& cases);

// Are numbers and reason the same?
bool same_rule(const GoldenVerdict& a, const GoldenVerdict& b);

// As text; names are bytes, and JSON wants UTF-8.
std::string json_text(const nlohmann::ordered_json& json);

}  // namespace polhode
