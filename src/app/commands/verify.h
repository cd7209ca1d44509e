// SPDX-License-Identifier: MIT
// The use case `verify`: is a film still what its report says?
#pragma once

#include <string>

#include "base/system/progress.h"

namespace polhode {

struct VerifyJob {
  std::string output;
  std::string report;  // empty: the output's name with the ending .json
  ProgressKind progress = ProgressKind::automatic;
};

struct Verified {
  bool same = false;
  std::string text;  // one line: what was found, with the first frame that differs and its time
};

// Makes all frames again from the report alone, holds their hashes against the report's, encodes
// them with the same settings, and compares what is decoded from both, value by value. Throws Error
// (input) when there is nothing to compare with: no output, no report, other versions of what the
// pixels depend on.
Verified verify(const VerifyJob& job);

}  // namespace polhode
