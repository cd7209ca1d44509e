// SPDX-License-Identifier: MIT
#include "film/frame_workers.h"

#include <algorithm>

#include "base/check.h"
#include "film/drawing_process.h"
#include "film/local_renderer.h"

namespace polhode {
namespace {

class FrameWorkers final : public FrameRenderer {
 public:
  FrameWorkers(const PreparedFilm& film, const RenderSetup& setup, const std::vector<int>& frames)
      : frames_(frames) {
    const auto count =
        std::min(static_cast<std::size_t>(setup.jobs), std::max<std::size_t>(1, frames.size()));
    const auto open = [&] {
      return open_local_renderer(film, setup);
    };
    for (std::size_t k = 0; k < count; ++k) {
      std::vector<int> share;
      for (std::size_t i = k; i < frames.size(); i += count) {
        share.push_back(frames[i]);
      }
      members_.push_back(
          std::make_unique<DrawingProcess>(film.solved().scene.video.size, share, open));
    }
  }

  void render(int index, Image& image) override {
    CHECK(made_ < frames_.size() && frames_[made_] == index);
    members_[made_ % members_.size()]->next(image);
    ++made_;
  }
  const RendererInfo& info() const override { return members_.front()->info(); }
  DrawingTimes times() const override {
    DrawingTimes sum;
    for (const std::unique_ptr<DrawingProcess>& member : members_) {
      const DrawingTimes& times = member->times();
      sum.compose += times.compose;
      sum.render.draw += times.render.draw;
      sum.render.read_back += times.render.read_back;
      sum.render.smooth += times.render.smooth;
    }
    return sum;
  }

 private:
  std::vector<int> frames_;
  std::vector<std::unique_ptr<DrawingProcess>> members_;
  std::size_t made_ = 0;  // frames
};

}  // namespace

std::unique_ptr<FrameRenderer> open_frame_renderer(const PreparedFilm& film,
                                                   const RenderSetup& setup,
                                                   const std::vector<int>& frames) {
  if (setup.jobs == 1) return open_local_renderer(film, setup);
  return std::make_unique<FrameWorkers>(film, setup, frames);
}

}  // namespace polhode
