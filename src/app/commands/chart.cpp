// SPDX-License-Identifier: MIT
#include "app/commands/chart.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <set>

#include <fmt/format.h>

#include "app/commands/able_methods.h"
#include "app/folder_work.h"
#include "base/error.h"
#include "base/json.h"
#include "base/nearest.h"
#include "base/system/output_folder.h"
#include "base/version.h"
#include "chart/plot_work_precision.h"
#include "film/error_places.h"
#include "film/solved_scene.h"
#include "motion/solution_method.h"
#include "motion/stepper_table.h"
#include "scene/canonical.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

const std::vector<std::string> kChartFiles = {"chart.csv", "chart.svg", "chart.png", "chart.pdf"};
constexpr const char* kKeptPoints = "chart.resume";  // of finished methods, until all are there

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
    refuse_numerics(scene, "for charts of methods", {"numerics.accuracy"});
    refuse_given(scene, "motion.ensemble", "is not for charts of methods, of one motion each");
    const BodyModel model = with_needed_degrees(make_model(scene.body, scene.motion));
    const State start = start_state(model, scene.motion);
    task.problem = {model, start, scene.motion.duration};
    task.methods = able_methods(methods, job.methods, model, file.string(), why_not);
    task.panel.accuracy_rad = accuracy_in_radians(scene, model);
    task.panel.free_body = model.chi_P.isZero(0.0) && !model.loads.turn_body();
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

// everything that a point depends on but the machine
std::string words_of_chart(const std::vector<Task>& tasks) {
  std::string words = fmt::format("polhode {}", program_version());
  for (const Task& task : tasks) {
    words += fmt::format(" {} {:.17g}", scene_hash(task.scene), task.panel.accuracy_rad);
    for (const StepperInfo* method : task.methods)
      words += fmt::format(" {}", method->name);
  }
  return words;
}

// The methods of all scenes, with the points of those that have been measured.
class ChartPieces {
 public:
  explicit ChartPieces(std::vector<Task>& tasks) : tasks_(tasks) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      for (std::size_t method = 0; method < tasks[i].methods.size(); ++method)
        owners_.emplace_back(i, method);
    }
    points_.resize(owners_.size());
  }
  long count() const { return static_cast<long>(owners_.size()); }

  void make(long piece) {
    const auto [i, method] = owners_[static_cast<std::size_t>(piece)];
    Task& task = tasks_[i];
    points_[static_cast<std::size_t>(piece)] =
        work_precision(*task.methods[method], task.problem, reference_of(i));
  }

  // a row for each point: its numbers, with null for those that are none, and its status
  std::string line_of(long piece) const {
    Json line = {piece, tasks_[owners_[static_cast<std::size_t>(piece)].first].panel.reference};
    for (const WorkPoint& p : points_[static_cast<std::size_t>(piece)]) {
      line.push_back({p.order,
                      p.step,
                      p.evaluations,
                      p.time_us,
                      p.error_rad,
                      p.energy_drift,
                      p.momentum_drift,
                      p.status});
    }
    return line.dump();
  }

  std::optional<long> take_up(const std::string& text) {
    try {
      const Json line = parse_foreign_json(text);
      const long piece = line.at(0);
      if (piece < 0 || piece >= count()) return {};
      const auto [i, method] = owners_[static_cast<std::size_t>(piece)];
      std::vector<WorkPoint> points;
      for (std::size_t k = 2; k < line.size(); ++k)
        points.push_back(point_of(line[k], tasks_[i].methods[method]->name));
      tasks_[i].panel.reference = line.at(1);
      points_[static_cast<std::size_t>(piece)] = std::move(points);
      return piece;
    } catch (const Json::exception&) {
      return {};
    }
  }

  // hands the points over to the panels, in the order of the methods
  void fill_panels() {
    for (std::size_t piece = 0; piece < owners_.size(); ++piece) {
      std::vector<WorkPoint>& all = tasks_[owners_[piece].first].panel.points;
      all.insert(all.end(), points_[piece].begin(), points_[piece].end());
    }
  }

 private:
  static WorkPoint point_of(const Json& row, const std::string& method) {
    const auto number = [&](std::size_t k) {
      return row.at(k).is_null() ? std::numeric_limits<double>::quiet_NaN()
                                 : row.at(k).get<double>();
    };
    return {method,
            row.at(0),
            number(1),
            row.at(2),
            number(3),
            number(4),
            number(5),
            number(6),
            row.at(7)};
  }

  const ReferenceSolution& reference_of(std::size_t i) {
    if (reference_ == nullptr || reference_of_ != i) {
      Task& task = tasks_[i];
      reference_ = std::make_unique<ReferenceSolution>(
          task.problem.model, task.problem.start, task.problem.duration);
      reference_of_ = i;
      task.panel.reference = reference_->source();
    }
    return *reference_;
  }

  std::vector<Task>& tasks_;
  std::vector<std::pair<std::size_t, std::size_t>> owners_;  // scene and method of each piece
  std::vector<std::vector<WorkPoint>> points_;
  std::unique_ptr<ReferenceSolution> reference_;  // of the scene at hand
  std::size_t reference_of_ = 0;
};

// What is to be done, checked. Its address is part of its work.
struct PlannedChart {
  explicit PlannedChart(const ChartJob& job)
      : tasks(make_tasks(job)),
        pieces(tasks),
        work{folder_or_default(job.output, job.scenes.front(), "chart"),
             kChartFiles,
             kKeptPoints,
             words_of_chart(tasks),
             {}} {
    refuse_own_input(work, {job.scenes.begin(), job.scenes.end()});
    Piecewise& methods = work.pieces;
    methods.pieces = pieces.count();
    methods.things = "methods";
    methods.take_up = [this](const std::string& line) {
      return pieces.take_up(line);
    };
    methods.make = [this](long piece) {
      pieces.make(piece);
    };
    methods.line_of = [this](long piece) {
      return pieces.line_of(piece);
    };
  }
  PlannedChart(const PlannedChart&) = delete;
  PlannedChart& operator=(const PlannedChart&) = delete;

  static std::vector<Task> make_tasks(const ChartJob& job) {
    const std::vector<const StepperInfo*> methods = parse_methods(job.methods);
    refuse_same_stem(job.scenes);
    std::vector<Task> made;
    for (const std::filesystem::path& file : job.scenes)
      made.push_back(make_task(file, job, methods));
    return made;
  }

  std::vector<Task> tasks;
  ChartPieces pieces;
  FolderWork work;
};

constexpr int kOneAtATime = 1;  // what is timed has the machine to itself

}  // namespace

std::string chart(const ChartJob& job) {
  PlannedChart plan(job);
  return make_folder_work(plan.work, job.part, kOneAtATime, job.progress, [&] {
    plan.pieces.fill_panels();
    std::vector<WorkPanel> panels;
    std::string text;
    for (Task& task : plan.tasks) {
      text += summary(task.panel);
      panels.push_back(std::move(task.panel));
    }
    return FolderResult{{work_precision_csv(panels),
                         plot_work_precision(panels, PlotFormat::svg),
                         plot_work_precision(panels, PlotFormat::png),
                         plot_work_precision(panels, PlotFormat::pdf)},
                        text};
  });
}

DividedWork divided_chart(const ChartJob& job) {
  require_gnuplot();
  const double start_s = seconds_of([&] { PlannedChart{job}; });
  PlannedChart plan(job);
  DividedWork work = divided(plan.work);
  work.start_s = start_s;
  work.has_jobs = false;
  work.alone = true;
  work.piece_s = mean_seconds([&](int k) { plan.pieces.make(spread_over(k, work.pieces)); });
  return work;
}

}  // namespace polhode
