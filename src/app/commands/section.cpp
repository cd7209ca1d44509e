// SPDX-License-Identifier: MIT
#include "app/commands/section.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "app/commands/section_map.h"
#include "base/error.h"
#include "base/system/kept_rows.h"
#include "base/system/output_folder.h"
#include "base/system/overwriting.h"
#include "base/version.h"
#include "chart/plot_section.h"
#include "film/error_places.h"
#include "film/overrides.h"
#include "motion/convoy.h"
#include "scene/canonical.h"

namespace polhode {
namespace {

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

// the motions, on every processor; those of an earlier run are taken up
std::vector<SectionOrbit> trace_all(const SectionSurface& surface,
                                    const std::vector<State>& starts,
                                    const SectionJob& job,
                                    KeptRows& kept) {
  std::vector<SectionOrbit> orbits(starts.size());
  std::set<long> done;
  kept.load([&](const std::string& line) {
    const std::optional<long> index = take_up_orbit(line, orbits);
    if (index) done.insert(*index);
    return index.has_value();
  });
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < starts.size(); ++i)
    if (!done.contains(static_cast<long>(i))) left.push_back(i);
  Progress progress(
      job.progress, static_cast<int>(starts.size()), "motions", static_cast<int>(done.size()));
  std::mutex lock;
  int count = 0;
  try {
    parallel_in_convoys(static_cast<long>(left.size()), job.jobs, [&](long i) {
      const std::size_t index = left[static_cast<std::size_t>(i)];
      SectionOrbit orbit = trace_section(surface, starts[index], job.crossings);
      const std::lock_guard guard(lock);
      kept.add(line_of_orbit(static_cast<long>(index), orbit));
      orbits[index] = std::move(orbit);
      progress.show(++count);
    });
  } catch (...) {
    kept.save();
    throw;
  }
  return orbits;
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
  text += fmt::format("{} motions: {} regular, {} chaotic, {} undecided; {} crossings\n",
                      orbits.size(),
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

}  // namespace

std::string section(const SectionJob& job) {
  constexpr int kMostStarts = 10000, kMostCrossings = 100000;
  constexpr double kMostOfAll = 1e7;
  check_range(job.starts, kMostStarts, "--starts");
  check_range(job.crossings, kMostCrossings, "--crossings");
  if (job.map) return section_map(job);
  if (static_cast<double>(job.starts) * job.crossings > kMostOfAll) {
    throw input_error("{} starts with {} crossings each are more than {:g} in all",
                      job.starts,
                      job.crossings,
                      kMostOfAll)
        .at({{}, 0, "--crossings"});
  }
  Overrides overrides;
  overrides.settings = job.settings;
  const Scene scene = load_single(job.scene, overrides);
  const auto [model, start] = with_place(scene, [&] { return start_of_section(scene); });
  require_gnuplot();
  const SectionSurface surface(model, start);
  std::vector<State> starts = {start};
  for (const Vec2& at : surface.spread(job.starts))
    starts.push_back(surface.state_at(at.x(), at.y()).value());

  const std::filesystem::path where = folder_or_default(job.output, job.scene, "section");
  const std::vector<std::string> names = {"section.csv", "section.png"};
  refuse_same_files(where, names, input_files(scene));
  refuse_same_files(where, {"section.resume"}, input_files(scene));
  OutputFolder folder(where, names);
  KeptRows kept(
      where / "section.resume",
      fmt::format(
          "polhode {} {} {} {}", program_version(), scene_hash(scene), job.starts, job.crossings));
  SectionChart chart;
  chart.title = scene.title.empty() ? job.scene.stem().string() : scene.title;
  chart.borders = borders_of(surface);
  chart.orbits = trace_all(surface, starts, job, kept);
  folder.commit({section_csv(chart), plot_section(chart, PlotFormat::png)});
  kept.remove();
  return summary_of(surface, chart.orbits);
}

}  // namespace polhode
