// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>

#include <fmt/ranges.h>

#include "app/compare/golden_run.h"
#include "app/compare/golden_show.h"
#include "app/compare/golden_update.h"
#include "base/error.h"
#include "base/nearest.h"
#include "base/system/console.h"
#include "cli/command.h"
#include "cli/shared_options.h"

namespace polhode {
namespace {

struct GoldenAction {
  const char* name;
  GoldenResult (*run)(const GoldenJob&);
};
constexpr GoldenAction kActions[] = {
    {"run", golden_run}, {"update", golden_update}, {"show", golden_show}};

const GoldenAction& find_action(const std::string& name) {
  for (const GoldenAction& action : kActions) {
    if (name == action.name) return action;
  }
  throw input_error("unknown action '{}'{}", name, suggestion(name, golden_actions()))
      .at({{}, 0, "golden"});
}

// options that another action would take, and this one would leave unread
void refuse_others(const std::string& action, const GoldenJob& job) {
  const struct {
    bool given;
    const char* option;
    std::vector<std::string> actions;
  } options[] = {{!job.html.empty(), "--html", {"run"}},
                 {job.output != GoldenJob{}.output, "--output", {"run"}},
                 {!job.cause.empty(), "--cause", {"update"}},
                 {job.all, "--all", {"update"}},
                 {job.allow_dirty, "--allow-dirty", {"update"}},
                 {job.jobs != GoldenJob{}.jobs, "--jobs", {"run", "update"}},
                 {job.backend != GoldenJob{}.backend, "--backend", {"run", "update"}}};
  for (const auto& one : options) {
    const auto& of = one.actions;
    if (!one.given || std::find(of.begin(), of.end(), action) != of.end()) continue;
    throw input_error("is for golden {}, not for golden {}", fmt::join(of, " and "), action)
        .at({{}, 0, one.option});
  }
}

}  // namespace

std::vector<std::string> golden_actions() {
  std::vector<std::string> names;
  for (const GoldenAction& action : kActions)
    names.emplace_back(action.name);
  return names;
}

Action define_golden(CLI::App& command) {
  auto job = std::make_shared<GoldenJob>();
  auto action = std::make_shared<std::string>();
  auto progress = std::make_shared<ProgressOptions>();
  auto jobs = std::make_shared<std::optional<int>>();
  command.add_option("action", *action, "run, update or show")->required()->type_name("ACTION");
  command.add_option("folder", job->folder, "folder with cases.toml, see docs/golden.md")
      ->required()
      ->type_name("DIR");
  add_text(command, "--cases", job->cases, "only these, separated by commas")->type_name("NAMES");
  add_text(command, "--backend", job->backend, "OpenGL from osmesa, egl or auto")
      ->type_name("BACKEND");
  add_whole_number(command, "--jobs", *jobs, "cases at a time (default: one per processor)")
      ->type_name("N");
  command.add_flag("--json", job->json, "as JSON");
  add_text(
      command, "--html", job->html, "run: write an HTML report of the failures, DIR/index.html")
      ->type_name("DIR");
  add_text(command, "--output", job->output, "run: folder for the pictures of failed cases")
      ->type_name("DIR");
  add_text(command, "--cause", job->cause, "update: write NAME.CAUSE.png beside NAME.png")
      ->type_name("CAUSE");
  command.add_flag("--all", job->all, "update: also cases that pass within their thresholds");
  command.add_flag(
      "--allow-dirty", job->allow_dirty, "update: even if the git tree has uncommitted changes");
  add_progress(command, *progress);
  return [=] {
    const GoldenAction& chosen = find_action(*action);
    if (*jobs && **jobs < 1) {
      throw input_error("must be at least 1, got {}", **jobs).at({{}, 0, "--jobs"});
    }
    job->jobs = jobs->value_or(0);
    refuse_others(*action, *job);
    job->progress = progress_of(*progress);
    const GoldenResult result = chosen.run(*job);
    print_out(result.text);
    return result.exit_code;
  };
}

}  // namespace polhode
