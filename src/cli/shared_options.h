// SPDX-License-Identifier: MIT
// How options become values, and the options that several commands take. Values are read here and
// not by the parser of the line, so that a wrong one is told as a wrong value of a scene is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/compare/diff.h"
#include "base/system/progress.h"
#include "film/overrides.h"

namespace polhode {

// `names` as CLI11 wants them, "-o,--output"; the last one names the option in errors. `target`
// must outlive the parse; it is left alone when the option is absent, and the last of several
// holds. Throw Error (input) for text that is no finite number, and for empty text.
CLI::Option* add_number(CLI::App& command,
                        const std::string& names,
                        std::optional<double>& target,
                        const std::string& doc);
CLI::Option* add_whole_number(CLI::App& command,
                              const std::string& names,
                              std::optional<int>& target,
                              const std::string& doc);
CLI::Option* add_text(CLI::App& command,
                      const std::string& names,
                      std::string& target,
                      const std::string& doc);
CLI::Option* add_text(CLI::App& command,
                      const std::string& names,
                      std::optional<std::string>& target,
                      const std::string& doc);

// The scene file, which every command on a scene needs.
void add_scene(CLI::App& command, std::filesystem::path& scene);

// One or more of them.
void add_scenes(CLI::App& command, std::vector<std::filesystem::path>& scenes);

// --progress and --quiet, as they were given
struct ProgressOptions {
  std::string progress = "auto";
  bool quiet = false;
};
void add_progress(CLI::App& command, ProgressOptions& options);
// --quiet alone, for commands that end with a line but show no progress
void add_quiet(CLI::App& command, ProgressOptions& options);
// Throws Error (input).
ProgressKind progress_of(const ProgressOptions& options);

// --method, --step, --tolerance, --accuracy
void add_numerics_options(CLI::App& command, Overrides& overrides);

// --max, --fraction, --limit, --ssim, --flip, as they were given
struct ThresholdOptions {
  std::optional<int> max, limit;  // levels of 255
  std::optional<double> fraction, ssim, flip;
};
void add_thresholds(CLI::App& command, ThresholdOptions& given);

// The defaults with what was given in their place. Throws Error (input) for a number out of range.
Thresholds thresholds_of(const ThresholdOptions& given);

}  // namespace polhode
