// SPDX-License-Identifier: MIT
#include "app/commands/export.h"

#include <optional>

#include "base/error.h"
#include "base/system/atomic_file.h"
#include "base/system/console.h"
#include "base/system/log.h"
#include "base/system/overwriting.h"
#include "export/gltf_file.h"
#include "export/mark_picture.h"
#include "film/error_places.h"
#include "film/frame_times.h"
#include "film/solved_scene.h"
#include "film/unused_settings.h"

namespace polhode {
namespace {

void refuse_unless_glb(const std::string& output) {
  if (output == "-" || std::filesystem::path(output).extension() == ".glb") return;
  throw input_error("the scene is written as binary glTF; name a .glb").at({output, 0, {}});
}

}  // namespace

GlbFile glb_of_scene(const Scene& scene, const ExportJob& job) {
  // before any work
  TimeRange range;
  range.from = job.from;
  range.to = job.to;
  check_time_range(scene, range);
  ExportPlan plan;
  plan.from = job.from;
  plan.to = job.to;
  plan.author = job.author;
  plan.licence = job.licence;
  plan.paint = mark_picture;
  if (job.overrides.accuracy) {
    const Accuracy& accuracy = scene.numerics.accuracy;
    if (accuracy.pixels) {
      plan.pixels = accuracy.value;
    } else {
      plan.radians = accuracy.value;
    }
  }
  warn_of_unused_in_motion(scene);
  if (!scene.numerics.compare.empty()) {
    const Error warning =
        input_error("models have the one motion of the scene, not those compared");
    spdlog::warn("{}", placed(scene, warning.at({{}, 0, "numerics.compare"})).what());
  }
  const Solved solved = solve(scene, job.progress);
  Waiting waiting(job.progress);
  plan.tell = [&](const std::string& words) {
    waiting.show(words);
  };
  const ExportedScene exported = with_place(scene, [&] { return export_scene(solved, plan); });
  return {glb_of(exported.document), exported.report};
}

Exported write_glb(const ExportJob& job) {
  const Scene scene = load_single(job.scene, job.overrides);
  refuse_same_file(job.output, "the output", input_files(scene));
  refuse_unless_glb(job.output);
  std::optional<AtomicFile> file;
  if (job.output != "-") file.emplace(job.output);
  const GlbFile made = glb_of_scene(scene, job);
  if (file) {
    file->commit_with(made.bytes);
  } else {
    write_out(made.bytes);
  }
  return {job.output, made.bytes.size(), made.report};
}

}  // namespace polhode
