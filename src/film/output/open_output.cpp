// SPDX-License-Identifier: MIT
#include "film/output/open_output.h"

#include <numeric>
#include <optional>
#include <utility>

#include "film/film_metadata.h"
#include "film/output/resumed_film.h"
#include "film/output/segments.h"
#include "video/plain_sinks.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace {

// Every frame into one output.
class WholeOutput : public RenderOutput {
 public:
  WholeOutput(const RenderPlan& plan, bool with_hashes) : plan_(plan) {
    SinkJob job = plan.sink;
    job.segment = plan.shard.has_value();
    sink_ = make_sink(job);
    if (with_hashes) sink_ = polhode::with_hashes(std::move(sink_), hashes_);
  }

  void begin(const PreparedFilm& film) override {
    const FilmMetadata metadata = film_metadata(film.solved().scene, plan_.story, film.frames());
    set_range({0, metadata.frames});
    sink_->describe(metadata);
  }
  FrameSink& sink() override { return *sink_; }
  SinkTimes times() const override { return sink_->times(); }
  const std::vector<std::string>& hashes() const override { return hashes_; }

 protected:
  void set_range(const FrameRange& range) {
    range_ = range;
    frames_.resize(static_cast<std::size_t>(range.count));
    std::iota(frames_.begin(), frames_.end(), range.first);
  }

  const RenderPlan& plan_;
  std::vector<std::string> hashes_;
  std::unique_ptr<FrameSink> sink_;
};

// The frames of one shard, with the record by which it can be joined.
class ShardOutput final : public WholeOutput {
 public:
  using WholeOutput::WholeOutput;

  void begin(const PreparedFilm& film) override {
    const FilmMetadata metadata = film_metadata(film.solved().scene, plan_.story, film.frames());
    set_range(range_of(*plan_.shard, metadata.frames));
    FilmMetadata own = metadata_of_segment(metadata, range_);
    own.comment = comment_with(record_of(plan_, film, metadata, *plan_.shard));
    sink_->describe(own);
  }
};

}  // namespace

std::unique_ptr<RenderOutput> open_output(const RenderPlan& plan, bool with_hashes) {
  if (plan.resume) return std::make_unique<ResumedFilm>(plan);
  if (plan.shard) return std::make_unique<ShardOutput>(plan, with_hashes);
  return std::make_unique<WholeOutput>(plan, with_hashes);
}

std::string limiting_stage(const RenderPlan& plan, const PipelineStep& step) {
  if (step.writer_waits) return "drawing";
  const std::string& codec = plan.sink.encoder.codec;
  return codec.empty() || codec == "raw" ? "writing" : "encoding";
}

void render_frames(RenderOutput& output,
                   FrameRenderer& renderer,
                   const std::function<void(const PipelineStep&)>& on_frame) {
  const std::vector<int>& frames = output.frames();
  const auto produce = [&](int index, Image& image) {
    return renderer.begin(frames[static_cast<std::size_t>(index)], image);
  };
  try {
    run_pipeline(static_cast<int>(frames.size()), produce, output.sink(), on_frame);
  } catch (const Error& error) {
    throw output.explained(error);
  }
}

void render_with_progress(const RenderPlan& plan,
                          RenderOutput& output,
                          FrameRenderer& renderer,
                          ProgressKind kind) {
  // the places of names are found with the first frame
  std::optional<Busy> busy(std::in_place, kind, "preparing the first frame");
  Progress progress(kind, output.range().count, "frames", output.already_there());
  render_frames(output, renderer, [&](const PipelineStep& step) {
    busy.reset();
    progress.show(step.done, limiting_stage(plan, step));
  });
}

}  // namespace polhode
