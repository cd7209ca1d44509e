// SPDX-License-Identifier: MIT
#include "film/local_renderer.h"

#include <algorithm>
#include <set>

#include "image/average.h"

namespace polhode {
namespace {

class LocalRenderer final : public FrameRenderer {
 public:
  LocalRenderer(const PreparedFilm& film, const RenderSetup& setup) : film_(film) {
    // the threads that start here are the rasteriser's
    const std::set<int> before = thread_ids();
    context_ = open_context(setup.backend);
    const PictureSize& size = film.solved().scene.video.size;
    renderer_ = std::make_unique<Renderer>(
        *context_, RenderSettings{size.width, size.height, 4, setup.transparent});
    rasteriser_ = thread_ids();
    for (const int id : before) {
      rasteriser_.erase(id);
    }
  }

  void render(int index, Image& image) override {
    const double time = film_.frames().film_time(index);
    const Picture picture = composed(time);
    const int moments = film_.shutter().moments();
    if (moments == 1) {
      renderer_->draw(picture, image);
      return;
    }
    // what moves while the shutter is open, which ends with the shot; the text stands still
    const double shot = film_.film().next_cut(time) - time;
    const double part = std::min(1.0, shot / film_.shutter().open_s());
    for (int k = 0; k < moments; ++k) {
      renderer_->draw(film_.film().bare_at(time + part * film_.shutter().moment(k)), image);
      blurred_.add(image);
    }
    blurred_.mean(image);
    for (const Stamp& stamp : picture.stamps) {
      lay_over(image, stamp);
    }
  }

  const RendererInfo& info() const override { return renderer_->info(); }
  DrawingTimes times() const override {
    DrawingTimes times{compose_time_, renderer_->times()};
    ThreadClocks clocks(rasteriser_);
    clocks.read();
    times.render.draw.cpu_s += clocks.total();
    return times;
  }

 private:
  Picture composed(double film_time) {
    const StageTimer timer(compose_time_);
    return film_.film().at(film_time);
  }

  const PreparedFilm& film_;
  std::unique_ptr<Context> context_;
  std::unique_ptr<Renderer> renderer_;
  std::set<int> rasteriser_;  // threads
  AveragePicture blurred_;
  StageTime compose_time_;
};

}  // namespace

std::unique_ptr<FrameRenderer> open_local_renderer(const PreparedFilm& film,
                                                   const RenderSetup& setup) {
  return std::make_unique<LocalRenderer>(film, setup);
}

}  // namespace polhode
