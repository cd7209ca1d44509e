// SPDX-License-Identifier: MIT
#include "app/compare/golden_cases.h"

#include <cctype>
#include <fstream>
#include <set>

#include <nlohmann/json.hpp>

#include "app/commands/render.h"
#include "base/name_list.h"
#include "base/system/atomic_file.h"
#include "base/system/files.h"
#include "base/version.h"
#include "film/overrides.h"
#include "image/png.h"

namespace polhode {
namespace fs = std::filesystem;
namespace {

// every NAME.png and NAME.CAUSE.png of one case
std::vector<Reference> references_of(const fs::path& folder, const std::string& name) {
  std::vector<Reference> found;
  const auto add = [&](const std::string& cause) {
    Reference one{cause, reference_file(folder, name, cause), false, {}};
    const fs::path sidecar = sidecar_file(one.file);
    one.has_sidecar = is_there(sidecar);
    if (one.has_sidecar) one.sidecar = load_golden_sidecar(sidecar);
    found.push_back(std::move(one));
  };
  std::set<std::string> causes;
  const std::string start = name + ".";
  for (const fs::path& entry : entries_of(folder)) {
    const std::string file = entry.filename().string();
    if (!file.starts_with(start) || !file.ends_with(".png")) continue;
    if (file == name + ".png") {
      causes.insert("");
      continue;
    }
    const std::string cause = file.substr(start.size(), file.size() - start.size() - 4);
    if (is_plain_name(cause)) causes.insert(cause);
  }
  for (const std::string& cause : causes)
    add(cause);
  return found;
}

std::set<std::string> chosen_names(const std::string& names, const GoldenFile& file) {
  std::vector<std::string> known;
  for (const GoldenCase& one : file.cases)
    known.push_back(one.name);
  return known_names(names, known, "case", "--cases");
}

// "llvmpipe (LLVM 15.0.6, 256 bits)" -> "15.0.6"
std::string llvm_of(const std::string& renderer) {
  constexpr std::string_view kMark = "LLVM ";
  const std::size_t at = renderer.find(kMark);
  if (at == std::string::npos) return {};
  const std::size_t start = at + kMark.size();
  return renderer.substr(start, renderer.find_first_not_of("0123456789.", start) - start);
}

// what the processor calls its maker; low bits of square roots differ between them
std::string cpu_vendor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("vendor_id") && !line.starts_with("CPU implementer")) continue;
    const std::size_t colon = line.find(':');
    if (colon != std::string::npos && colon + 2 < line.size()) return line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

fs::path sidecar_file(const fs::path& reference) {
  return reference.string() + ".toml";
}

fs::path reference_file(const fs::path& folder, const std::string& name, const std::string& cause) {
  return folder / (cause.empty() ? name + ".png" : fmt::format("{}.{}.png", name, cause));
}

std::vector<LoadedCase> load_cases(const fs::path& folder, const std::string& names) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    throw input_error("{}", is_there(folder) ? "is no folder" : "the folder does not exist")
        .at({folder.string(), 0, {}});
  }
  const fs::path list = folder / "cases.toml";
  if (!is_there(list)) {
    throw input_error("has no cases.toml; docs/golden.md describes it")
        .at({folder.string(), 0, {}});
  }
  const GoldenFile file = load_golden_file(list);
  const std::set<std::string> chosen = chosen_names(names, file);
  std::vector<LoadedCase> cases;
  for (const GoldenCase& one : file.cases) {
    if (!chosen.empty() && chosen.count(one.name) == 0) continue;
    cases.push_back({one, one.verdict.value_or(file.verdict), references_of(folder, one.name)});
  }
  return cases;
}

std::vector<fs::path> scene_files(const fs::path& folder, const std::vector<LoadedCase>& cases) {
  std::vector<fs::path> all;
  for (const LoadedCase& one : cases) {
    try {
      const std::vector<fs::path> files =
          input_files(load_with_overrides(folder / one.spec.scene, {}));
      all.insert(all.end(), files.begin(), files.end());
    } catch (const Error&) {
      all.push_back(folder / one.spec.scene);  // what is wrong is told when it is drawn
    }
  }
  return all;
}

DrawnCase draw_case(const fs::path& folder,
                    const GoldenCase& one,
                    const std::string& backend,
                    const ScratchFolder& scratch) {
  RenderJob job;
  job.scene = folder / one.scene;
  job.output = scratch / (one.name + ".png");
  job.overrides.size = fmt::format("{}x{}", one.size.width, one.size.height);
  job.still = one.still;
  job.text = one.text;
  job.transparent = one.transparent;
  job.backend = backend;
  job.progress = ProgressKind::none;
  job.report = scratch / (one.name + ".json");
  try {
    render_film(job);
  } catch (const Error& error) {
    // nobody gave this option
    if (error.place().key != "--still") throw;
    throw Error(error.fault(),
                error.message(),
                {(folder / "cases.toml").string(), 0, fmt::format("{}.still", one.name)});
  }

  DrawnCase drawn;
  drawn.image = read_png(job.output);
  const auto report = nlohmann::json::parse(read_file(job.report));
  drawn.sidecar.polhode = program_version();
  drawn.sidecar.backend = report.at("backend");
  drawn.sidecar.renderer = report.at("gl_renderer");
  drawn.sidecar.opengl = report.at("gl_version");
  drawn.sidecar.llvm = llvm_of(drawn.sidecar.renderer);
  drawn.sidecar.cpu_vendor = cpu_vendor();
  drawn.sidecar.samples = report.at("samples");
  return drawn;
}

}  // namespace polhode
