// SPDX-License-Identifier: MIT
#include "app/commands/simulate.h"

#include <cmath>

#include "base/error.h"
#include "base/system/atomic_file.h"
#include "base/system/console.h"
#include "base/system/interrupt.h"
#include "base/system/overwriting.h"
#include "base/system/progress.h"
#include "film/solved_scene.h"

namespace polhode {
namespace {

constexpr const char* kHeader = "t,qw,qx,qy,qz,wx,wy,wz,Lx,Ly,Lz,x,y,z,energy\n";
constexpr double kMostRows = 1e7;

void append_row(std::string& text, const Sample& s) {
  const double row[] = {s.t,
                        s.q_SB.w(),
                        s.q_SB.x(),
                        s.q_SB.y(),
                        s.q_SB.z(),
                        s.w_B[0],
                        s.w_B[1],
                        s.w_B[2],
                        s.L_S[0],
                        s.L_S[1],
                        s.L_S[2],
                        s.center_S[0],
                        s.center_S[1],
                        s.center_S[2],
                        s.energy};
  const char* separator = "";
  for (const double value : row) {
    // adding zero turns -0 into 0
    fmt::format_to(std::back_inserter(text), "{}{:.17g}", separator, value + 0.0);
    separator = ",";
  }
  text += '\n';
}

// The rows, which leave the memory a megabyte at a time.
class MotionTable {
 public:
  // a file, or "-" for standard output
  explicit MotionTable(const std::string& output) : text_(kHeader) {
    if (output != "-") {
      file_.emplace(output);
      file_->write("");
    }
  }
  void add(const Sample& sample) {
    append_row(text_, sample);
    if (text_.size() > kMegabyte) pass_on();
  }
  void finish() {
    pass_on();
    if (file_) file_->commit();
  }

 private:
  static constexpr std::size_t kMegabyte = 1 << 20;
  void pass_on() {
    if (file_) {
      file_->append(text_);
    } else {
      print_out(text_);
    }
    text_.clear();
  }

  std::optional<AtomicFile> file_;
  std::string text_;
};

// a table under the name of something else cannot be opened
void refuse_other_ending(const std::string& output) {
  const std::string ending = std::filesystem::path(output).extension().string();
  if (ending.empty() || ending == ".csv") return;
  throw input_error("the motion is written as CSV; name a .csv, not '{}'", ending)
      .at({output, 0, {}});
}

}  // namespace

void write_csv(const SimulateJob& job) {
  const Scene scene = load_single(job.scene, job.overrides);
  refuse_same_file(job.output, "the output", input_files(scene));
  refuse_other_ending(job.output);
  const double rate = job.rate.value_or(scene.video.fps.value());
  if (!std::isfinite(rate) || rate <= 0.0) {
    throw input_error("must be a number of rows per second greater than 0, got {}", rate)
        .at({{}, 0, "--rate"});
  }
  const double last = std::floor(scene.motion.duration * rate * (1.0 + 1e-12));
  if (last > kMostRows) {
    throw input_error("{:.3g} rows, {:g} a second, are too many; give fewer a second", last, rate)
        .at({{}, 0, "--rate"});
  }

  MotionTable table(job.output);
  const Solved solved = solve_alone(scene, ProgressKind::automatic);
  Waiting waiting(ProgressKind::automatic);
  for (long row = 0; row <= static_cast<long>(last); ++row) {
    if (row % 4096 == 0) {
      stop_if_interrupted();
      waiting.show(fmt::format("writing rows: {:.0f} %", 100.0 * static_cast<double>(row) / last));
    }
    const double t = std::min(static_cast<double>(row) / rate, scene.motion.duration);
    table.add(solved.simulation.motion.at(t));
  }
  table.finish();
}

}  // namespace polhode
