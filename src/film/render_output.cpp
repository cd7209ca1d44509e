// SPDX-License-Identifier: MIT
#include "film/render_output.h"

#include <numeric>

#include "film/film_metadata.h"
#include "video/plain_sinks.h"

namespace polhode {

FilmTarget::FilmTarget(const FilmOrder& order, bool with_hashes) : order_(order) {
  if (order.resume) {
    auto resumed = std::make_unique<ResumedFilm>(order);
    resumed_ = resumed.get();
    sink_ = std::move(resumed);
    return;
  }
  SinkJob job = order.sink;
  job.piece = order.shard.has_value();
  sink_ = make_sink(job);
  if (with_hashes) sink_ = polhode::with_hashes(std::move(sink_), hashes_);
}

void FilmTarget::begin(const FilmBasis& film) {
  const FilmMarks marks = film_marks(film.solved.scene, order_.story, film.frames);
  range_ = {0, marks.frames};
  if (resumed_ != nullptr) {
    resumed_->begin(film, marks);
    frames_ = resumed_->missing();
    there_ = marks.frames - static_cast<int>(frames_.size());
    return;
  }
  if (order_.shard) {
    range_ = range_of(*order_.shard, marks.frames);
    FilmMarks piece = marks_of_piece(marks, range_);
    piece.comment = comment_with(record_of(order_, film, marks, *order_.shard));
    sink_->describe(piece);
  } else {
    sink_->describe(marks);
  }
  frames_.resize(static_cast<std::size_t>(range_.count));
  std::iota(frames_.begin(), frames_.end(), range_.first);
}

std::string FilmTarget::limit(const PipelineStep& step) const {
  if (step.writer_waits) return "drawing";
  return order_.sink.encoder.codec.empty() || order_.sink.encoder.codec == "raw" ? "writing"
                                                                                 : "encoding";
}

Error FilmTarget::explained(const Error& error) const {
  if (resumed_ == nullptr) return error;
  if (error.fault() == Fault::interrupted) {
    return {error.fault(), fmt::format("interrupted; {}", resumed_->kept())};
  }
  if (error.fault() != Fault::environment) return error;
  return {error.fault(), fmt::format("{}; {}", error.message(), resumed_->kept()), error.place()};
}

void fill_target(FilmTarget& target,
                 FrameMaker& maker,
                 const std::function<void(const PipelineStep&)>& on_frame) {
  const std::vector<int>& frames = target.frames();
  const auto produce = [&](int index, Image& image) {
    maker.make(frames[static_cast<std::size_t>(index)], image);
  };
  try {
    run_pipeline(static_cast<int>(frames.size()), produce, target.sink(), on_frame);
  } catch (const Error& error) {
    throw target.explained(error);
  }
}

}  // namespace polhode
