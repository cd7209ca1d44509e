// SPDX-License-Identifier: MIT
#include "film/frame_renderer.h"

#include <set>

#include "image/average.h"

namespace polhode {
namespace {

class Drawer final : public FrameRenderer {
 public:
  Drawer(const FilmFrames& film, const std::string& backend, bool transparent) : film_(film) {
    // the threads that start here are the rasteriser's
    const std::set<int> before = thread_ids();
    context_ = open_context(backend);
    const PictureSize& size = film.basis().solved.scene.video.size;
    renderer_ = std::make_unique<Renderer>(*context_,
                                           RenderSettings{size.width, size.height, 4, transparent});
    rasteriser_ = thread_ids();
    for (const int id : before) {
      rasteriser_.erase(id);
    }
  }

  void make(int index, Image& image) override {
    const double time = film_.basis().frames.film_time(index);
    const Picture picture = composed(time);
    const int moments = film_.moments();
    if (moments == 1) {
      renderer_->draw(picture, image);
      return;
    }
    // what moves while the shutter is open; the text stands still
    for (int k = 0; k < moments; ++k) {
      renderer_->draw(film_.film().bare_at(time + film_.open() * (k + 0.5) / moments), image);
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

  const FilmFrames& film_;
  std::unique_ptr<Context> context_;
  std::unique_ptr<Renderer> renderer_;
  std::set<int> rasteriser_;  // threads
  AveragePicture blurred_;
  StageTime compose_time_;
};

}  // namespace

std::unique_ptr<FrameRenderer> make_frame_renderer(const FilmFrames& film,
                                                   const std::string& backend,
                                                   bool transparent) {
  return std::make_unique<Drawer>(film, backend, transparent);
}

}  // namespace polhode
