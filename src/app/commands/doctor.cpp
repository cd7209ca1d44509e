// SPDX-License-Identifier: MIT
#include "app/commands/doctor.h"

#include <filesystem>
#include <memory>
#include <thread>

#include "base/error.h"
#include "base/json.h"
#include "base/system/atomic_file.h"
#include "base/system/scratch_folder.h"
#include "base/text_table.h"
#include "chart/gnuplot.h"
#include "film/report/motion_report.h"
#include "render/context.h"
#include "render/renderer.h"
#include "text/typesetter.h"
#include "video/encoders.h"

namespace polhode {
namespace {

struct BackendState {
  bool works = false;
  std::string line;
};

// what comes of really opening a back end and its framebuffers
BackendState examine_backend(const Backend& backend) {
  try {
    const std::unique_ptr<Context> context = backend.open();
    const Renderer renderer(*context, {64, 64, 4, false, Edges::samples});
    return {true,
            fmt::format("ok, {}, OpenGL {}, {} samples",
                        renderer.info().gl_renderer,
                        renderer.info().gl_version,
                        renderer.info().samples)};
  } catch (const Error& error) {
    return {false, fmt::format("missing: {}", error.what())};
  }
}

// where sequences, lectures and charts are made
std::string state_of_temporary_folder() {
  try {
    constexpr std::size_t kEnough = 4U << 20U;  // bytes, for a handout
    const ScratchFolder folder;
    write_file(folder / "probe", std::string(kEnough, ' '));
    return "ok, " + std::filesystem::path(folder / "").parent_path().parent_path().string();
  } catch (const Error& error) {
    return fmt::format("fails: {}", error.what());
  }
}

}  // namespace

std::string state_of_program(const ProgramFound& program, const std::string& advice) {
  if (program.why_not.empty()) return "ok, " + program.version;
  return program.installed ? "fails: " + program.why_not : "missing: " + advice;
}

Diagnosis examine(const std::vector<ExternalNeed>& needs) {
  std::vector<TextRow> rows;
  bool draws = false;
  const Json all = versions();
  for (const auto& [key, value] : all.items()) {
    rows.push_back({key, value.get<std::string>()});
  }
  settle_mesa();
  for (const Backend& backend : backends()) {
    const BackendState state = examine_backend(backend);
    rows.push_back({"back end " + backend.name, state.line});
    draws = draws || state.works;
  }
  rows.push_back({"charts", state_of_program(find_gnuplot(), "install gnuplot-nox")});
  for (const ExternalNeed& need : needs)
    rows.push_back({need.name, need.state});
  for (const FontFound& font : examine_fonts()) {
    const std::string there = font.there ? "ok"
                                         : fmt::format("missing: {} serves instead; install {}",
                                                       font.found.empty() ? "nothing" : font.found,
                                                       font.package);
    rows.push_back(
        {"font " + font.wanted,
         font.damaged
             ? fmt::format("damaged: {} cannot be read; install {} again", font.found, font.package)
             : there});
  }
  for (const FilmEncoder& encoder : film_encoders()) {
    rows.push_back({"encoder " + encoder.name,
                    fmt::format("{}, {}: {}",
                                has_encoder(encoder.name)
                                    ? "ok"
                                    : "missing: install an FFmpeg that has it (Debian: " +
                                          codec_package() + ")",
                                encoder.title,
                                encoder.doc)});
  }
  rows.push_back({"temporary files", state_of_temporary_folder()});
  const bool encodes = has_encoder("libx264");
  rows.push_back({"threads", std::to_string(std::thread::hardware_concurrency())});
  return {aligned(rows), draws && encodes};
}

}  // namespace polhode
