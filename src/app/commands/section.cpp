// SPDX-License-Identifier: MIT
#include "app/commands/section.h"

#include <algorithm>
#include <array>
#include <sstream>

#include <fmt/format.h>

#include "app/commands/section_map.h"
#include "app/folder_work.h"
#include "base/error.h"
#include "base/system/output_folder.h"
#include "base/version.h"
#include "chart/plot_section.h"
#include "film/error_places.h"
#include "film/overrides.h"
#include "scene/canonical.h"

namespace polhode {
namespace {

const std::vector<std::string> kSectionFiles = {"section.csv", "section.png"};
constexpr const char* kKeptMotions = "section.resume";  // until all are there

// a finished motion as a line of text
std::string line_of_orbit(long index, const SectionOrbit& orbit) {
  std::string line = fmt::format("{} {} {:.17g} {:.17g} {:.17g}",
                                 index,
                                 static_cast<int>(orbit.verdict),
                                 orbit.growth,
                                 orbit.duration,
                                 orbit.energy_drift);
  for (const Vec2& point : orbit.points)
    fmt::format_to(std::back_inserter(line), " {:.17g} {:.17g}", point.x(), point.y());
  return line;
}

// puts such a line into its place; absent: it is not ours
std::optional<long> take_up_orbit(const std::string& line, std::vector<SectionOrbit>& orbits) {
  std::istringstream in(line);
  long index = -1;
  int verdict = -1;
  SectionOrbit orbit;
  in >> index >> verdict >> orbit.growth >> orbit.duration >> orbit.energy_drift;
  if (!in || index < 0 || index >= static_cast<long>(orbits.size())) return {};
  if (verdict < 0 || verdict > static_cast<int>(SectionVerdict::chaotic)) return {};
  orbit.verdict = static_cast<SectionVerdict>(verdict);
  Vec2 point;
  while (in >> point.x() >> point.y())
    orbit.points.push_back(point);
  if (!in.eof()) return {};
  orbits[static_cast<std::size_t>(index)] = std::move(orbit);
  return index;
}

void check_range(int value, int most, const char* option) {
  if (value >= 1 && value <= most) return;
  throw input_error("must be a whole number from 1 to {}, got {}", most, value).at({{}, 0, option});
}

// the motions, each by itself
Piecewise motions_of(const SectionSurface& surface,
                     const std::vector<State>& starts,
                     int crossings,
                     std::vector<SectionOrbit>& orbits) {
  orbits.resize(starts.size());
  Piecewise work;
  work.pieces = static_cast<long>(starts.size());
  work.things = "motions";
  work.in_convoys = true;
  work.take_up = [&orbits](const std::string& line) {
    return take_up_orbit(line, orbits);
  };
  work.make = [&surface, &starts, crossings, &orbits](long i) {
    const auto index = static_cast<std::size_t>(i);
    orbits[index] = trace_section(surface, starts[index], crossings);
  };
  work.line_of = [&orbits](long i) {
    return line_of_orbit(i, orbits[static_cast<std::size_t>(i)]);
  };
  return work;
}

// what became of the motions, and how well their energy was kept
std::string summary_of(const SectionSurface& surface, const std::vector<SectionOrbit>& orbits) {
  std::array<int, 3> count = {};
  std::size_t crossings = 0;
  double drift = 0.0;
  for (const SectionOrbit& orbit : orbits) {
    ++count[static_cast<std::size_t>(orbit.verdict)];
    crossings += orbit.points.size();
    drift = std::max(drift, orbit.energy_drift);
  }
  std::string text = fmt::format("energy {:.6g} J, vertical momentum {:.6g} kg m^2/s\n",
                                 surface.energy(),
                                 surface.vertical_momentum());
  text += fmt::format("{} motion{}: {} regular, {} chaotic, {} undecided; {} crossings\n",
                      orbits.size(),
                      orbits.size() == 1 ? "" : "s",
                      count[0],
                      count[2],
                      count[1],
                      crossings);
  text += fmt::format("that of the scene: {}, {} crossings, Lyapunov exponent {}{:.3g}/s\n",
                      name_of(orbits.front().verdict),
                      orbits.front().points.size(),
                      orbits.front().verdict == SectionVerdict::chaotic ? "" : "at most ",
                      orbits.front().exponent());
  return text + fmt::format("energy kept within {:.2g} of its scale\n", drift);
}

// What is to be done, checked. Its address is part of its motions.
struct PlannedSection {
  explicit PlannedSection(const SectionJob& job)
      : scene(scene_of(job)),
        surface(std::make_from_tuple<SectionSurface>(
            with_place(scene, [&] { return start_of_section(scene); }))),
        work{folder_or_default(job.output, job.scene, "section"),
             kSectionFiles,
             kKeptMotions,
             fmt::format("polhode {} {} {} {}",
                         program_version(),
                         scene_hash(scene),
                         job.starts,
                         job.crossings),
             {}} {
    starts = {with_place(scene, [&] { return start_of_section(scene); }).second};
    for (const Vec2& at : surface.spread(job.starts))
      starts.push_back(surface.state_at(at.x(), at.y()).value());
    refuse_own_input(work, input_files(scene));
    chart.title = scene.title.empty() ? job.scene.stem().string() : scene.title;
    work.pieces = motions_of(surface, starts, job.crossings, chart.orbits);
  }
  PlannedSection(const PlannedSection&) = delete;
  PlannedSection& operator=(const PlannedSection&) = delete;

  static Scene scene_of(const SectionJob& job) {
    constexpr double kMostOfAll = 1e7;
    if (static_cast<double>(job.starts) * job.crossings > kMostOfAll) {
      throw input_error("{} starts with {} crossings each are more than {:g} in all",
                        job.starts,
                        job.crossings,
                        kMostOfAll)
          .at({{}, 0, "--crossings"});
    }
    Overrides overrides;
    overrides.settings = job.settings;
    return load_single(job.scene, overrides);
  }

  Scene scene;
  SectionSurface surface;
  FolderWork work;
  std::vector<State> starts;
  SectionChart chart;
};

void check_counts(const SectionJob& job) {
  constexpr int kMostStarts = 10000, kMostCrossings = 100000;
  check_range(job.starts, kMostStarts, "--starts");
  check_range(job.crossings, kMostCrossings, "--crossings");
}

}  // namespace

std::string section(const SectionJob& job) {
  check_counts(job);
  if (job.map) return section_map(job);
  PlannedSection plan(job);
  return make_folder_work(plan.work, job.part, job.jobs, job.progress, [&] {
    plan.chart.borders = borders_of(plan.surface);
    return FolderResult{{section_csv(plan.chart), plot_section(plan.chart, PlotFormat::png)},
                        summary_of(plan.surface, plan.chart.orbits)};
  });
}

DividedWork divided_section(const SectionJob& job) {
  check_counts(job);
  if (job.map) return divided_section_map(job);
  require_gnuplot();
  const double start_s = seconds_of([&] { PlannedSection{job}; });
  const PlannedSection plan(job);
  DividedWork work = divided(plan.work);
  work.start_s = start_s;
  const int few = std::min(job.crossings, kSampledCrossings);
  work.piece_s = job.crossings / static_cast<double>(few) * mean_seconds([&](int k) {
                   const long start = spread_over(k, work.pieces);
                   trace_section(plan.surface, plan.starts[static_cast<std::size_t>(start)], few);
                 });
  return work;
}

}  // namespace polhode
