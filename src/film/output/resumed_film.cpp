// SPDX-License-Identifier: MIT
#include "film/output/resumed_film.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "base/check.h"
#include "base/one_line.h"
#include "base/system/console.h"
#include "base/system/files.h"
#include "base/system/log.h"
#include "base/system/system_error.h"
#include "film/film_metadata.h"
#include "video/seal.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace fs = std::filesystem;
namespace {

constexpr double kSegmentSeconds = 5.0;  // of film: at most so much is lost
const std::string kScratch = "work-";    // begins the names of the folders of runs

StageTime sum(const StageTime& a, const StageTime& b) {
  return {a.wall_s + b.wall_s, a.cpu_s + b.cpu_s};
}

// the output as a whole is refused now, if it must be
const std::string& examined(const RenderPlan& plan) {
  make_sink(plan.sink);
  return plan.sink.output;
}

}  // namespace

std::string folder_of_pieces(const std::string& output) {
  const fs::path path(output);
  return (path.parent_path() / fmt::format(".{}.parts", path.filename().string())).string();
}

ResumedFilm::ResumedFilm(const RenderPlan& plan)
    : plan_(plan),
      folder_(folder_of_pieces(plan.sink.output)),
      ending_(fs::path(plan.sink.output).extension().string()) {
  if (!plan.shard) joiner_ = std::make_unique<FilmJoiner>(examined(plan));
}

// an empty folder is no use to the next run; a link to one stays, a file that is in its way, and
// what other runs work in
ResumedFilm::~ResumedFilm() {
  segment_.reset();
  std::error_code ignored;
  const bool is_folder = fs::symlink_status(folder_, ignored).type() == fs::file_type::directory;
  if (joiner_ && is_folder) fs::remove(folder_, ignored);
}

std::string ResumedFilm::file_of(int number) const {
  return (fs::path(folder_) / fmt::format("{:05}{}", number, ending_)).string();
}

void ResumedFilm::begin(const PreparedFilm& film) {
  metadata_ = film_metadata(film.solved().scene, plan_.story, film.frames());
  segments_ = plan_.pieces;
  if (segments_ == 0) {
    const double frames = std::max(1.0, std::round(kSegmentSeconds * plan_.sink.fps.value()));
    segments_ = static_cast<int>(std::ceil(metadata_.frames / frames));
  } else if (segments_ > metadata_.frames) {
    throw input_error("the film has only {} frames; make at most that many pieces, not {}",
                      metadata_.frames,
                      segments_)
        .at({{}, 0, "--pieces"});
  }
  record_ = record_of(plan_, film, metadata_, {1, segments_});
  for (const long piece : pieces_of(plan_.shard, segments_, "pieces"))
    numbers_.push_back(static_cast<int>(piece) + 1);
  for (const int number : numbers_)
    look_at_old_segment(number);
  if (plan_.shard) refuse_other_film();
  const std::size_t whole = seals_.size();
  make_folder(folder_, {{}, 0, "--resume"});
  range_ = {};
  for (const int number : numbers_) {
    const FrameRange range = range_of({number, segments_}, metadata_.frames);
    range_.count += range.count;
    for (int i = 0; i < range.count && !seals_.contains(number); ++i)
      frames_.push_back(range.first + i);
  }
  if (!joiner_ && !frames_.empty())
    scratch_ = std::make_unique<ScratchFolder>(fs::path(folder_) / (kScratch + "XXXXXX"));
  if (whole > 0 && plan_.progress != ProgressKind::none) {
    print_err(fmt::format("polhode: {}: {} of {} pieces are already complete\n",
                          one_line(plan_.sink.output),
                          whole,
                          numbers_.size()));
  }
}

// One that cannot be read or is not as it was sealed is made again. Hours of work on another film
// are not thrown away for a slip of the keyboard.
void ResumedFilm::look_at_old_segment(int number) {
  const std::string file = file_of(number);
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return;
  if (!fs::is_regular_file(file, ignored)) {
    throw input_error("is no piece of a film; remove it").at({file, 0, {}});
  }
  std::string difference;
  try {
    if (const std::optional<std::string> text = sealed_text(file)) {
      const SegmentRecord record = record_in(file);
      difference = difference_between(record_, record);
      if (difference.empty() && record.shard.number == number) {
        seals_.emplace(number, *text);
        return;
      }
    }
  } catch (const Error& error) {
    if (error.fault() == Fault::interrupted) throw;
  }
  if (difference.empty()) {
    spdlog::warn("{}: is damaged and made again", file);
    return;
  }
  throw other_film(difference);
}

// One is enough, because each was looked at so before it was made: a thousand tasks must not read a
// thousand pieces each. Whoever makes it sees to it that it is whole.
void ResumedFilm::refuse_other_film() const {
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, none)) {
    if (entry.path().extension() != ending_ || !entry.is_regular_file(none)) continue;
    std::string difference;
    try {
      difference = difference_between(record_, record_in(entry.path().string()));
    } catch (const Error& error) {
      if (error.fault() == Fault::interrupted) throw;
      continue;  // a damaged one says nothing
    }
    if (!difference.empty()) throw other_film(difference);
    return;
  }
}

Error ResumedFilm::other_film(const std::string& difference) const {
  return input_error(
             "'{}' holds pieces of another film: {}; delete it to start again, or choose another "
             "output",
             folder_,
             difference)
      .at({{}, 0, "--resume"});
}

void ResumedFilm::open_segment(int frame) {
  int number = 1;
  FrameRange range = range_of({number, segments_}, metadata_.frames);
  while (frame >= range.first + range.count) {
    range = range_of({++number, segments_}, metadata_.frames);
  }
  CHECK(frame == range.first);
  number_ = number;
  SinkJob job = plan_.sink;
  job.output = scratch_ ? *scratch_ / fs::path(file_of(number)).filename() : file_of(number);
  job.segment = true;
  segment_ = make_sink(job);
  SegmentRecord record = record_;
  record.shard.number = number;
  record.range = range;
  FilmMetadata metadata = metadata_of_segment(metadata_, range);
  metadata.comment = comment_with(record);
  segment_->describe(metadata);
  left_in_segment_ = range.count;
}

void ResumedFilm::push(const Image& frame) {
  if (!segment_) open_segment(frames_[pushed_]);
  segment_->push(frame);
  ++pushed_;
  if (--left_in_segment_ > 0) return;
  segment_->finish();
  times_ = times();
  segment_.reset();
  const std::string file = file_of(number_);
  if (scratch_) move_file(*scratch_ / fs::path(file).filename(), file);
  const std::optional<std::string> text = sealed_text(file);
  if (!text) throw environment_error("{}: changed while the film was being made", file);
  seals_.emplace(number_, *text);
}

SinkTimes ResumedFilm::times() const {
  if (!segment_) return times_;
  const SinkTimes open = segment_->times();
  return {sum(times_.convert, open.convert), sum(times_.encode, open.encode)};
}

void ResumedFilm::collect_hashes() {
  for (const int number : numbers_) {
    std::istringstream lines(seals_.at(number));
    for (std::string line; std::getline(lines, line);) {
      hashes_.push_back(line);
    }
  }
}

void ResumedFilm::finish() {
  collect_hashes();
  if (!joiner_) return;
  std::vector<FilmJoiner::Part> parts;
  for (const int number : numbers_) {
    parts.push_back({file_of(number), range_of({number, segments_}, metadata_.frames).count});
  }
  joiner_->join(parts, plan_.sink.fps, plan_.sink.title, plan_.sink.comment, metadata_);
  // what else somebody keeps in the folder is not ours
  for (const int number : numbers_) {
    remove_file(file_of(number));
  }
  for (const fs::path& entry : entries_of(folder_)) {
    if (entry.filename().string().starts_with(kScratch)) remove_file(entry);
  }
}

Error ResumedFilm::explained(const Error& error) const {
  if (error.fault() == Fault::interrupted) {
    return {error.fault(), fmt::format("interrupted; {}", kept())};
  }
  if (error.fault() != Fault::environment) return error;
  return {error.fault(), fmt::format("{}; {}", error.message(), kept()), error.place()};
}

std::string ResumedFilm::kept() const {
  if (seals_.empty()) return "no piece was whole yet, so nothing is kept";
  return fmt::format("kept in {}: {} of {} pieces; the same command goes on from there",
                     folder_,
                     seals_.size(),
                     numbers_.size());
}

}  // namespace polhode
