// SPDX-License-Identifier: MIT
// The command `verify`: checks that a film is what its report says.
#pragma once

#include <string>

#include "base/system/progress.h"

namespace polhode {

// The options of `verify`.
struct VerifyJob {
  std::string output;
  std::string report;  // empty: the name of the output with the ending .json
  ProgressKind progress = ProgressKind::automatic;
};

// Whether the film is the same, and what the command prints.
struct Verified {
  bool same = false;
  std::string text;  // one line: the result, with the first frame that differs and its time
};

// Renders all frames again from the report alone, compares their hashes with those of the report,
// encodes them with the same settings, and compares the decoded frames of both films value by
// value. Throws Error (input), with the file as place, if output or report is missing, or if the
// report was written with other versions of what pixels depend on; (environment); (interrupted).
Verified verify(const VerifyJob& job);

}  // namespace polhode
