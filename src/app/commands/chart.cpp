// SPDX-License-Identifier: MIT
#include "app/commands/chart.h"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "app/commands/able_methods.h"
#include "base/error.h"
#include "base/nearest.h"
#include "base/system/output_folder.h"
#include "base/system/overwriting.h"
#include "chart/plot_work_precision.h"
#include "film/error_places.h"
#include "film/solved_scene.h"
#include "motion/solution_method.h"
#include "motion/stepper_table.h"

namespace polhode {
namespace {

// A scene as a problem to measure, with its panel still without points.
struct Task {
  Scene scene;
  WorkProblem problem;
  std::vector<const StepperInfo*> methods;  // those that can take it
  WorkPanel panel;
};

Task make_task(const std::filesystem::path& file,
               const ChartJob& job,
               const std::vector<const StepperInfo*>& methods) {
  Task task;
  task.scene = load_single(file, job.overrides);
  const Scene& scene = task.scene;
  with_place(scene, [&] {
    const BodyModel model = with_needed_degrees(make_model(scene.body, scene.motion));
    const State start = start_state(model, scene.motion);
    task.problem = {model, start, scene.motion.duration};
    task.methods = able_methods(methods, job.methods, model, file.string());
    task.panel.accuracy_rad = accuracy_in_radians(scene, model);
    task.panel.free_body = model.chi_P.isZero() && !model.loads.turn_body();
  });
  task.panel.scene = file.stem().string();
  task.panel.title = scene.title.empty() ? task.panel.scene : scene.title;
  task.panel.accuracy_why = scene.numerics.accuracy.pixels
                                ? fmt::format("{:g} px", scene.numerics.accuracy.value)
                                : "accuracy";
  return task;
}

// what a person wants to know first
std::string summary(const WorkPanel& panel) {
  std::string text = fmt::format("{}: reference: {}; the scene needs {:.2g} rad ({})\n",
                                 panel.scene,
                                 panel.reference,
                                 panel.accuracy_rad,
                                 panel.accuracy_why);
  std::set<double> asked = {panel.accuracy_rad, 1e-3, 1e-6, 1e-9, 1e-12};
  for (auto accuracy = asked.rbegin(); accuracy != asked.rend(); ++accuracy) {
    const WorkPoint* best = cheapest(panel.points, *accuracy);
    if (best == nullptr) continue;
    text += fmt::format("  within {:<8.2g} rad: {:<20} {} {:<9.3g} {:>9.3g} us\n",
                        *accuracy,
                        best->method,
                        find_stepper(best->method).adaptive ? "tolerance" : "step     ",
                        best->step,
                        best->time_us);
  }
  return text;
}

}  // namespace

std::string chart(const ChartJob& job) {
  const std::vector<const StepperInfo*> methods = parse_methods(job.methods);
  refuse_same_stem(job.scenes);
  std::vector<Task> tasks;
  int runs = 0;
  for (const std::filesystem::path& file : job.scenes) {
    tasks.push_back(make_task(file, job, methods));
    runs += static_cast<int>(tasks.back().methods.size());
  }
  require_gnuplot();
  const std::filesystem::path where = folder_or_default(job.output, job.scenes.front(), "chart");
  const std::vector<std::string> names = {"chart.csv", "chart.svg", "chart.png", "chart.pdf"};
  refuse_same_files(where, names, {job.scenes.begin(), job.scenes.end()});
  OutputFolder folder(where, names);

  // one after the other: what is timed has the machine to itself
  Progress progress(job.progress, runs, "methods");
  int done = 0;
  std::vector<WorkPanel> panels;
  std::string text;
  for (Task& task : tasks) {
    const ReferenceSolution reference(
        task.problem.model, task.problem.start, task.problem.duration);
    task.panel.reference = reference.source();
    for (const StepperInfo* method : task.methods) {
      const std::vector<WorkPoint> points = work_precision(*method, task.problem, reference);
      task.panel.points.insert(task.panel.points.end(), points.begin(), points.end());
      progress.show(++done);
    }
    text += summary(task.panel);
    panels.push_back(std::move(task.panel));
  }
  folder.commit({work_precision_csv(panels),
                 plot_work_precision(panels, PlotFormat::svg),
                 plot_work_precision(panels, PlotFormat::png),
                 plot_work_precision(panels, PlotFormat::pdf)});
  return text;
}

}  // namespace polhode
