// SPDX-License-Identifier: MIT
#include "app/compare/golden_update.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>

#include "app/compare/golden_results.h"
#include "base/json.h"
#include "base/system/atomic_file.h"
#include "base/system/child_process.h"
#include "base/system/files.h"
#include "base/system/overwriting.h"
#include "image/png.h"

namespace polhode {
namespace fs = std::filesystem;
namespace {

// What git says of the folder.
std::string ask_git(const GoldenJob& job, const std::vector<std::string>& question) {
  // the tree of this folder, whatever another one is named in the environment
  std::vector<std::string> words = {
      "env", "-u", "GIT_DIR", "-u", "GIT_WORK_TREE", "git", "-C", job.folder};
  words.insert(words.end(), question.begin(), question.end());
  const ChildResult said = run_child(words, "");
  if (said.signal != 0 || !said.exceeded.empty()) {
    throw environment_error("git {}", how_it_ended(said));
  }
  if (said.status != 0) {
    throw input_error(
        "git does not track this folder, or cannot say what has changed in it (it {}), so that "
        "an update could not be reviewed or undone; give --allow-dirty to update anyway",
        how_it_ended(said))
        .at({job.folder, 0, {}});
  }
  return said.out;
}

// What has changed: everywhere in what git knows, and new files in the folder itself.
void refuse_dirty(const GoldenJob& job) {
  std::string changed = ask_git(job, {"status", "--porcelain", "--untracked-files=no"});
  if (changed.empty())
    changed = ask_git(job, {"status", "--porcelain", "--untracked-files=all", "--", "."});
  if (changed.empty()) return;
  const std::string first = changed.substr(0, changed.find('\n'));
  throw input_error(
      "the git tree has uncommitted changes ({}{}); commit them first, so that the update can be "
      "reviewed by itself, or give --allow-dirty",
      first.size() > 3 ? first.substr(3) : first,
      std::count(changed.begin(), changed.end(), '\n') > 1 ? " and others" : "")
      .at({job.folder, 0, {}});
}

// What git does not look at could not be brought back.
void refuse_ignored(const GoldenJob& job, const std::vector<LoadedCase>& cases) {
  const std::string known = '\0' + ask_git(job, {"ls-files", "-z", "--", "."});
  const auto look_at = [&](const fs::path& file) {
    const std::string name = file.filename().string();
    if (!is_there(file) || known.find('\0' + name + '\0') != std::string::npos) return;
    throw input_error(
        "git ignores this file, so that an update could not be undone; add it to git (git add -f), "
        "or give --allow-dirty")
        .at({file.string(), 0, {}});
  };
  for (const LoadedCase& one : cases) {
    for (const Reference& reference : one.references) {
      look_at(reference.file);
      look_at(sidecar_file(reference.file));
    }
  }
}

// What an update does with one case.
struct Change {
  std::string words;  // what is printed
  bool picture = false, sidecar = false;
  std::vector<const Reference*> rules = {};  // whose thresholds alone are written
};

// References have the thresholds of their cases from now on, whatever the files beside them say.
// Returns those whose files say something else.
std::set<fs::path> take_new_rules(std::vector<LoadedCase>& cases) {
  std::set<fs::path> changed;
  for (LoadedCase& one : cases) {
    for (Reference& reference : one.references) {
      if (reference.has_sidecar && same_rule(reference.sidecar.verdict, one.verdict)) continue;
      changed.insert(reference.file);
      reference.sidecar.verdict = one.verdict;
    }
  }
  return changed;
}

Change change_of(const GoldenJob& job,
                 const LoadedCase& one,
                 const CaseResult& result,
                 const std::set<fs::path>& new_rules) {
  const auto target = std::find_if(one.references.begin(),
                                   one.references.end(),
                                   [&](const Reference& r) { return r.cause == job.cause; });
  if (target == one.references.end()) {
    // another cause is not needed where a reference matches already
    if (result.same() && !job.all)
      return {fmt::format("kept: matches {}", result.best->file.filename().string())};
    return {"new", true, true};
  }
  const Image before = [&] {
    try {
      return read_png(target->file);
    } catch (const Error& error) {
      throw Error(
          error.fault(), error.message() + "; delete it, and it is drawn anew", error.place());
    }
  }();
  const Image& now = result.drawn->image;
  const bool rule_changed = new_rules.contains(target->file);
  const std::string rule = rule_changed ? "; thresholds written" : "";
  if (before.width != now.width || before.height != now.height) {
    return {fmt::format("changed: was {}x{} pixels, is {}x{}",
                        before.width,
                        before.height,
                        now.width,
                        now.height),
            true,
            true};
  }
  const Verdict verdict = judge(before, now, one.verdict.thresholds);
  if (verdict.values.largest == 0) return {"unchanged" + rule, false, rule_changed};
  const std::string how = fmt::format("largest {}, {} of the pixels over {} levels",
                                      verdict.values.largest,
                                      percent(verdict.values.fraction_over),
                                      one.verdict.thresholds.max);
  if (!job.all && verdict.same()) {
    // what drew a picture is not known where nothing tells it
    const bool write = rule_changed && target->has_sidecar;
    return {fmt::format("kept: the same within its thresholds ({}){}", how, write ? rule : ""),
            false,
            write};
  }
  if (!job.all && result.same() && result.best != &*target) {
    return {fmt::format("kept: matches {}", result.best->file.filename().string())};
  }
  return {fmt::format("changed: {}", how), true, true};
}

// thresholds of references that else stay as they are
void add_rules(const GoldenJob& job,
               const LoadedCase& one,
               const std::set<fs::path>& new_rules,
               Change& change) {
  for (const Reference& reference : one.references) {
    if (!reference.has_sidecar || !new_rules.contains(reference.file)) continue;
    if (reference.cause == job.cause && change.sidecar) continue;
    change.rules.push_back(&reference);
    change.words += fmt::format("; thresholds of {} written", reference.file.filename().string());
  }
}

// A scene may have the name of a picture, or of what is told of it; pictures may be links.
void refuse_overwriting(const GoldenJob& job, const std::vector<LoadedCase>& cases) {
  const std::vector<fs::path> needed = scene_files(job.folder, cases);
  std::map<fs::path, std::string> written_by;  // of other cases
  for (const LoadedCase& one : cases) {
    const fs::path picture = reference_file(job.folder, one.spec.name, job.cause);
    const std::string what = fmt::format("the reference of '{}'", one.spec.name);
    for (const fs::path& written : {picture, sidecar_file(picture)}) {
      refuse_needed_file(written, what, needed);
      const auto [other, is_new] = written_by.emplace(fs::weakly_canonical(written), one.spec.name);
      if (!is_new) {
        throw input_error("{} is that of '{}' by a link; remove the link", what, other->second)
            .at({written.string(), 0, {}});
      }
    }
  }
}

// all at once, after all could be drawn
void write_references(const GoldenJob& job,
                      const std::vector<LoadedCase>& cases,
                      const std::vector<CaseResult>& results,
                      const std::vector<Change>& changes) {
  struct Pending {
    std::unique_ptr<AtomicFile> picture, sidecar;
    std::string text;
  };
  std::vector<Pending> pending;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (const Reference* kept : changes[i].rules) {
      pending.push_back({nullptr,
                         std::make_unique<AtomicFile>(sidecar_file(kept->file)),
                         sidecar_text(kept->sidecar)});
    }
    if (!changes[i].picture && !changes[i].sidecar) continue;
    const fs::path file = reference_file(job.folder, cases[i].spec.name, job.cause);
    const fs::path beside = sidecar_file(file);
    Pending one;
    GoldenSidecar sidecar = results[i].drawn->sidecar;
    if (changes[i].picture) {
      const Image& image = results[i].drawn->image;
      one.picture = std::make_unique<AtomicFile>(file);
      write_png(*one.picture, image, !is_opaque(image));
    } else if (is_there(beside)) {
      // the old picture was drawn by what its sidecar says
      sidecar = load_golden_sidecar(beside);
    }
    sidecar.cause = job.cause;
    sidecar.verdict = cases[i].verdict;
    one.text = sidecar_text(sidecar);
    one.sidecar = std::make_unique<AtomicFile>(beside);
    pending.push_back(std::move(one));
  }
  for (Pending& one : pending) {
    if (one.picture) one.picture->commit();
    one.sidecar->commit_with(one.text);
  }
}

}  // namespace

GoldenResult golden_update(const GoldenJob& job) {
  if (!job.cause.empty() && !is_plain_name(job.cause)) {
    throw input_error("must be letters, digits, _ and -, such as mesa-25; found '{}'", job.cause)
        .at({{}, 0, "--cause"});
  }
  if (job.cause == "actual" || job.cause == "difference") {
    throw input_error("'{}' is what the pictures of failures are called; take another name",
                      job.cause)
        .at({{}, 0, "--cause"});
  }
  std::vector<LoadedCase> cases = load_cases(job.folder, job.cases);
  refuse_overwriting(job, cases);
  const std::set<fs::path> new_rules = take_new_rules(cases);
  if (!job.allow_dirty) {
    refuse_dirty(job);
    refuse_ignored(job, cases);
  }
  const std::vector<CaseResult> results = draw_cases(job, cases);
  for (const CaseResult& result : results) {
    if (!result.drawn) throw input_error("nothing was updated: {}", result.error);
  }
  std::vector<Change> changes;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    changes.push_back(change_of(job, cases[i], results[i], new_rules));
    add_rules(job, cases[i], new_rules, changes.back());
  }
  write_references(job, cases, results, changes);

  Json json = {{"folder", job.folder}, {"cases", Json::array()}};
  std::string text;
  long written = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::string file =
        reference_file(job.folder, cases[i].spec.name, job.cause).filename().string();
    written += changes[i].picture ? 1 : 0;
    text += fmt::format("{:<32} {}\n", file, changes[i].words);
    json["cases"].push_back(
        {{"reference", file}, {"written", changes[i].picture}, {"what", changes[i].words}});
  }
  text += fmt::format("{} of {} references written\n", written, cases.size());
  return {0, job.json ? json_text(json) : text};
}

}  // namespace polhode
