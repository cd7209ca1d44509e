// SPDX-License-Identifier: MIT
#include "app/commands/verify.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <regex>

#include "base/one_line.h"
#include "base/system/atomic_file.h"
#include "base/system/files.h"
#include "base/system/interrupt.h"
#include "base/system/scratch_folder.h"
#include "film/frame_workers.h"
#include "film/output/open_output.h"
#include "film/report/film_report.h"
#include "film/report/reported_film.h"
#include "image/png.h"
#include "video/captions.h"
#include "video/film_reader.h"
#include "video/frame_sink.h"
#include "video/plain_sinks.h"
#include "video/png_sink.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace fs = std::filesystem;
namespace {

// What was made again, and where it stands beside what is judged.
struct Again {
  std::string kind;          // of sink_kinds()
  std::string judged, made;  // outputs, as names of files
  int first = 0;             // number of the first frame
  int count = 0;             // frames
  int film_end = 0;          // number of frames of the whole film, of which this may be a shard
  FrameRate fps;

  std::string frame(int number) const {
    return fmt::format("frame {} ({:.3f} s)", number, number / fps.value());
  }
};

constexpr double kRoundOff = 1e-9;  // rad; below it, errors are not compared

// whether times in units of their containers are the same, s
bool is_same_time(double a, double b) {
  constexpr double kSame = 1e-9;
  return std::abs(a - b) <= kSame;
}

// empty: there is none
using DifferenceInWords = std::string;

bool same_bytes(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return fs::file_size(a, ignored) == fs::file_size(b, ignored) && read_file(a) == read_file(b);
}

bool same_pixels(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height && a.pixels == b.pixels;
}

// when the last frame ends, by itself and by what the container says
DifferenceInWords compare_ends(const FilmReader& judged, const FilmReader& made) {
  if (!is_same_time(judged.end(), made.end()))
    return fmt::format("the film ends at {} s, and not {}", judged.end(), made.end());
  const double says = judged.info().length, is = made.info().length;
  return is_same_time(says, is) ? "" : fmt::format("the film is {} s long, and not {}", says, is);
}

DifferenceInWords compare_films(const Again& again) {
  FilmReader made(again.made);
  Image expected, found;
  double expected_time = 0.0, found_time = 0.0;
  int number = again.first;
  try {
    FilmReader judged(again.judged);
    if (judged.info().shown != made.info().shown) {
      return fmt::format(
          "its frames are shown as '{}', and not '{}'", judged.info().shown, made.info().shown);
    }
    if (again.kind == "apng" && png_tags(again.judged) != png_tags(again.made))
      return "it has other tags";
    for (;; ++number) {
      stop_if_interrupted();
      const bool more = made.next(expected, expected_time);
      if (judged.next(found, found_time) != more) {
        return fmt::format("{} {}", again.frame(number), more ? "is missing" : "is one too many");
      }
      if (!more) return compare_ends(judged, made);
      if (!same_pixels(expected, found)) return fmt::format("{} differs", again.frame(number));
      if (judged.frame_shown() != made.frame_shown()) {
        return fmt::format("{} is shown as '{}', and not '{}'",
                           again.frame(number),
                           judged.frame_shown(),
                           made.frame_shown());
      }
      if (!is_same_time(expected_time, found_time))
        return fmt::format("{} has another time", again.frame(number));
    }
  } catch (const Error& error) {
    if (error.fault() != Fault::input) throw;
    return fmt::format("{}: {}", again.frame(number), error.message());
  }
}

// a picture behind the last one of the film would be taken for one of it
DifferenceInWords compare_count(const Again& again) {
  if (!is_there(parse_numbered_name(again.judged).of(again.film_end))) return {};
  return fmt::format("{} is one too many", again.frame(again.film_end));
}

DifferenceInWords compare_pictures(const Again& again, bool numbered) {
  for (int number = again.first; number < again.first + again.count; ++number) {
    stop_if_interrupted();
    const auto name = [&](const std::string& output) {
      return numbered ? parse_numbered_name(output).of(number) : output;
    };
    try {
      if (same_bytes(name(again.judged), name(again.made))) continue;
      if (same_pixels(read_png(name(again.judged)), read_png(name(again.made)))) {
        if (png_tags(name(again.judged)) == png_tags(name(again.made))) continue;
        return fmt::format("{} is shown otherwise: it has other tags", again.frame(number));
      }
    } catch (const Error& error) {
      if (error.fault() != Fault::input) throw;
      return fmt::format("{}: {}", again.frame(number), error.what());
    }
    return fmt::format("{} differs", again.frame(number));
  }
  return numbered ? compare_count(again) : "";
}

DifferenceInWords compare_lists(const Again& again) {
  std::istringstream judged(read_file(again.judged)), made(read_file(again.made));
  std::string expected, found;
  for (int number = again.first;; ++number) {
    const bool more = static_cast<bool>(std::getline(made, expected));
    const bool there = static_cast<bool>(std::getline(judged, found));
    if (!more && !there) return {};
    if (more && there && expected == found) continue;
    return fmt::format("{} {}",
                       again.frame(number),
                       !there ? "is missing"
                       : more ? "differs"
                              : "is one too many");
  }
}

// frames of one size behind a line that says what they are
DifferenceInWords compare_raw(const Again& again) {
  const std::string made = read_file(again.made), judged = read_file(again.judged);
  const auto [in_made, in_judged] =
      std::mismatch(made.begin(), made.end(), judged.begin(), judged.end());
  const auto same = static_cast<std::size_t>(in_made - made.begin());
  const std::size_t head = made.find('\n') + 1;
  if (same < head) return "its first line differs";
  const std::size_t frame = (made.size() - head) / static_cast<std::size_t>(again.count);
  return fmt::format("{} {}",
                     again.frame(again.first + static_cast<int>((same - head) / frame)),
                     in_judged == judged.end() ? "is missing"
                     : in_made == made.end()   ? "is one too many"
                                               : "differs");
}

DifferenceInWords compare_outputs(const Again& again) {
  const std::string& kind = again.kind;
  if (kind == "png") return compare_pictures(again, false);
  if (kind == "png sequence") return compare_pictures(again, true);
  if (same_bytes(again.judged, again.made)) return {};
  if (kind == "hash") return compare_lists(again);
  return kind == "y4m" ? compare_raw(again) : compare_films(again);
}

DifferenceInWords compare_captions(const Again& again) {
  const std::string made = captions_beside(again.made);
  const std::string judged = captions_beside(again.judged);
  std::error_code ignored;
  if (made.empty() || !fs::exists(made, ignored)) return {};
  if (!fs::exists(judged, ignored)) return fmt::format("its captions, {}, are missing", judged);
  return same_bytes(judged, made) ? "" : fmt::format("its captions, {}, differ", judged);
}

DifferenceInWords compare_hashes(const Again& again,
                                 const std::vector<std::string>& reported,
                                 const std::vector<std::string>& made) {
  for (std::size_t i = 0; i < std::min(reported.size(), made.size()); ++i) {
    if (reported[i] == made[i]) continue;
    return fmt::format("{} is not what the report says",
                       again.frame(again.first + static_cast<int>(i)));
  }
  if (reported.size() == made.size()) return {};
  return fmt::format(
      "the report tells of {} frames, the scene makes {}", reported.size(), made.size());
}

// How far a number of a report may be from what it is here: other machines round otherwise. The
// numbers of steps and evaluations depend on that only where steps are chosen as one goes.
double allowed_deviation(const std::string& name, double value, bool fixed_step) {
  const auto is_one_of = [&](std::initializer_list<const char*> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (is_one_of({"samples", "frames", "width", "height", "first_frame"})) return 0.0;
  if (fixed_step && name == "steps") return 0.0;
  if (is_one_of({"accuracy_rad", "step_s", "tolerance"})) return 1e-9 * std::abs(value);
  return 0.1 * std::abs(value) + kRoundOff;
}

// a text and the numbers in it
struct Told {
  std::string words;
  std::vector<double> numbers;
};
Told told_by(const std::string& text) {
  static const std::regex number(R"([-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?)");
  Told told{std::regex_replace(text, number, "#"), {}};
  for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end; ++i)
    told.numbers.push_back(std::strtod(i->str().c_str(), nullptr));
  return told;
}

// doubts name times and sizes, which may differ as far as the numbers beside them
bool tell_the_same(const std::string& says, const std::string& is) {
  const Told one = told_by(says), other = told_by(is);
  return one.words == other.words &&
         std::ranges::equal(one.numbers, other.numbers, [](double a, double b) {
           return std::abs(a - b) <= allowed_deviation("", b, false);
         });
}

// The first value that differs, with its path. `name` is its key in the object around it, which has
// a fixed step or not.
DifferenceInWords compare_values(const std::string& path,
                                 const std::string& name,
                                 const Json& says,
                                 const Json& is,
                                 bool fixed_step = false) {
  // JSON has no infinite numbers: they are written as null
  const bool is_without_end = is.is_number() && !std::isfinite(is.get<double>());
  if (is_without_end && says.is_null()) return {};
  if (says.is_number() && is.is_number() && !is_without_end) {
    const double value = is.get<double>();
    const double allowed = allowed_deviation(name, value, fixed_step);
    if (std::abs(says.get<double>() - value) <= allowed) return {};
  } else if (says.is_object() && is.is_object()) {
    const bool fixed = is.value("tolerance", Json()).is_null();
    for (const auto& [inside, value] : is.items()) {
      DifferenceInWords found =
          compare_values(fmt::format("{}{}{}", path, path.empty() ? "" : ".", inside),
                         inside,
                         says.value(inside, Json()),
                         value,
                         fixed);
      if (!found.empty()) return found;
    }
    return {};
  } else if (says.is_array() && is.is_array() && says.size() == is.size()) {
    for (std::size_t i = 0; i < is.size(); ++i) {
      DifferenceInWords found =
          compare_values(fmt::format("{}[{}]", path, i), name, says[i], is[i]);
      if (!found.empty()) return found;
    }
    return {};
  } else if (says.is_string() && is.is_string() && path.find("doubts[") != std::string::npos) {
    if (tell_the_same(says, is)) return {};
  } else if (says == is) {
    return {};
  }
  constexpr std::size_t kShown = 200;
  const auto shown = [](const Json& value) {
    return cut(one_line(value.dump()), kShown);
  };
  return fmt::format("{} is {}, and not {}", path, shown(is), shown(says));
}

// A key that a report has and the one of the same film has not; scenes are held against their hash.
DifferenceInWords unknown_key(const std::string& path, const Json& says, const Json& is) {
  if (says.is_array() && is.is_array() && says.size() == is.size()) {
    for (std::size_t i = 0; i < is.size(); ++i) {
      DifferenceInWords found = unknown_key(fmt::format("{}[{}]", path, i), says[i], is[i]);
      if (!found.empty()) return found;
    }
  }
  if (!says.is_object() || !is.is_object()) return {};
  for (const auto& [key, value] : says.items()) {
    if (key == "scene") continue;
    const std::string inside = fmt::format("{}{}{}", path, path.empty() ? "" : ".", key);
    if (!is.contains(key)) return fmt::format("{} is nothing that it tells", cut(one_line(inside)));
    DifferenceInWords found = unknown_key(inside, value, is.at(key));
    if (!found.empty()) return found;
  }
  return {};
}

// what a report says of its film and what cannot be another now; the frames, the scene and the
// versions are held against each other elsewhere
DifferenceInWords compare_reports(const Json& reported, const Json& made) {
  Json says, is;
  for (const char* key : {"title",
                          "samples",
                          "edges",
                          "model",
                          "model_reason",
                          "method",
                          "method_reason",
                          "step_s",
                          "tolerance",
                          "steps",
                          "rejected_steps",
                          "evaluations",
                          "accuracy_rad",
                          "error_estimate_rad",
                          "attitude_error_rad",
                          "energy_drift",
                          "momentum_drift",
                          "conditioning",
                          "trusted",
                          "doubts",
                          "frames",
                          "width",
                          "height",
                          "fps",
                          "first_frame",
                          "compare",
                          "film",
                          "loop"}) {
    says[key] = reported.value(key, Json());
    is[key] = made.value(key, Json());
  }
  DifferenceInWords difference = compare_values("", "", says, is);
  return difference.empty() ? unknown_key("", reported, made) : difference;
}

// there must be something to compare
void refuse_nothing(const std::string& kind, const std::string& output) {
  const Place place{output, 0, {}};
  if (kind == "null" || output == kStandardOutput) {
    throw input_error("writes no file that could be verified").at(place);
  }
  if (kind == "png sequence") return;
  refuse_unless_file(output);
}

bool is_of_kind(const SinkJob& sink, const std::string& kind) {
  try {
    return find_sink_kind(sink.output, sink.still).name == kind;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

Verified verify(const VerifyJob& job) {
  const std::string& kind = find_sink_kind(job.output).name;
  const std::size_t prefix = job.output.starts_with(kHashPrefix) ? kHashPrefix.size() : 0;
  const std::string output = job.output.substr(prefix);
  refuse_nothing(kind, output);
  const std::string report_file =
      job.report.empty() ? fs::path(output).replace_extension(".json").string() : job.report;
  ReportedFilm reported = read_report(report_file);
  if (reported.broken) {
    return {false, fmt::format("{}: was altered: {}", report_file, *reported.broken)};
  }

  if (!is_of_kind(reported.plan.sink, kind)) {
    throw input_error("is the report of '{}', not of {}; name another with --report",
                      reported.plan.sink.output,
                      output)
        .at({report_file, 0, {}});
  }

  // make it again, elsewhere
  const ScratchFolder scratch;
  RenderPlan& plan = reported.plan;
  const std::string made = scratch / fs::path(output).filename().string();
  plan.sink.output = job.output.substr(0, prefix) + made;
  std::unique_ptr<RenderOutput> remade;
  try {
    remade = open_output(plan, true);
  } catch (const Error& error) {
    // what render refuses, it has not reported
    if (error.fault() != Fault::input) throw;
    return {false, fmt::format("{}: was altered: {}", report_file, error.message())};
  }
  const PreparedFilm film(plan);
  remade->begin(film);
  const std::unique_ptr<FrameRenderer> renderer =
      open_frame_renderer(film, plan.setup, remade->frames());
  film.warn();
  if (renderer->info().gl_renderer != reported.gl_renderer) {
    throw input_error("cannot be compared: it was drawn by {}, this is {}",
                      reported.gl_renderer,
                      renderer->info().gl_renderer)
        .at({report_file, 0, {}});
  }
  render_with_progress(plan, *remade, *renderer, job.progress);

  // hold the report against it, and it against the report and the output
  const DifferenceInWords altered =
      compare_reports(reported.record, json_of(film_report(plan, film, *remade, *renderer)));
  if (!altered.empty()) return {false, fmt::format("{}: was altered: {}", report_file, altered)};
  const FrameRange& range = remade->range();
  const Again again{
      kind, output, made, range.first, range.count, film.frames().count, plan.sink.fps};
  DifferenceInWords difference = compare_hashes(again, reported.hashes, remade->hashes());
  if (difference.empty()) difference = compare_outputs(again);
  if (difference.empty()) difference = compare_captions(again);
  if (!difference.empty()) return {false, fmt::format("{}: {}", output, difference)};
  const std::string frames =
      again.count == 1 ? "the frame is" : fmt::format("all {} frames are", again.count);
  return {true, fmt::format("{}: {} the same", output, frames)};
}

}  // namespace polhode
