// SPDX-License-Identifier: MIT
#include "film/render_output.h"

#include <numeric>

#include "film/film_metadata.h"
#include "video/plain_sinks.h"

namespace polhode {

RenderOutput::RenderOutput(const RenderPlan& plan, bool with_hashes) : plan_(plan) {
  if (plan.resume) {
    auto resumed = std::make_unique<ResumedFilm>(plan);
    resumed_ = resumed.get();
    sink_ = std::move(resumed);
    return;
  }
  SinkJob job = plan.sink;
  job.segment = plan.shard.has_value();
  sink_ = make_sink(job);
  if (with_hashes) sink_ = polhode::with_hashes(std::move(sink_), hashes_);
}

void RenderOutput::begin(const PreparedFilm& film) {
  const FilmMetadata metadata = film_metadata(film.solved.scene, plan_.story, film.frames);
  range_ = {0, metadata.frames};
  if (resumed_ != nullptr) {
    resumed_->begin(film, metadata);
    frames_ = resumed_->missing();
    there_ = metadata.frames - static_cast<int>(frames_.size());
    return;
  }
  if (plan_.shard) {
    range_ = range_of(*plan_.shard, metadata.frames);
    FilmMetadata piece = metadata_of_segment(metadata, range_);
    piece.comment = comment_with(record_of(plan_, film, metadata, *plan_.shard));
    sink_->describe(piece);
  } else {
    sink_->describe(metadata);
  }
  frames_.resize(static_cast<std::size_t>(range_.count));
  std::iota(frames_.begin(), frames_.end(), range_.first);
}

std::string RenderOutput::limit(const PipelineStep& step) const {
  if (step.writer_waits) return "drawing";
  return plan_.sink.encoder.codec.empty() || plan_.sink.encoder.codec == "raw" ? "writing"
                                                                               : "encoding";
}

Error RenderOutput::explained(const Error& error) const {
  if (resumed_ == nullptr) return error;
  if (error.fault() == Fault::interrupted) {
    return {error.fault(), fmt::format("interrupted; {}", resumed_->kept())};
  }
  if (error.fault() != Fault::environment) return error;
  return {error.fault(), fmt::format("{}; {}", error.message(), resumed_->kept()), error.place()};
}

void fill_output(RenderOutput& target,
                 FrameRenderer& renderer,
                 const std::function<void(const PipelineStep&)>& on_frame) {
  const std::vector<int>& frames = target.frames();
  const auto produce = [&](int index, Image& image) {
    renderer.make(frames[static_cast<std::size_t>(index)], image);
  };
  try {
    run_pipeline(static_cast<int>(frames.size()), produce, target.sink(), on_frame);
  } catch (const Error& error) {
    throw target.explained(error);
  }
}

}  // namespace polhode
