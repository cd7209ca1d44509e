// SPDX-License-Identifier: MIT
#include "film/local_renderer.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/system/bounded_queue.h"
#include "base/system/interrupt.h"
#include "image/average.h"

namespace polhode {
namespace {

// Composes the picture of the frame that probably comes next on a thread of its own, while another
// one is drawn.
class ComposedAhead {
 public:
  explicit ComposedAhead(const PreparedFilm& film) : film_(film) {}
  ~ComposedAhead() {
    tasks_.stop();
    if (thread_.joinable()) thread_.join();
  }
  ComposedAhead(const ComposedAhead&) = delete;
  ComposedAhead& operator=(const ComposedAhead&) = delete;

  // The picture of a frame. Adds what it took, on whichever thread, to `time`. Throws what
  // composing throws, and Error (interrupted).
  Picture picture(int index, StageTime& time) {
    Made made = next_ == index ? awaited() : composed(index);
    time += made.time;
    begin(2 * index - last_.value_or(index));  // frames come in equal steps
    last_ = index;
    return std::move(made.picture);
  }

 private:
  struct Made {
    Picture picture;
    StageTime time;
  };
  using Task = std::packaged_task<Made()>;

  Made composed(int index) const {
    Made made;
    {
      const StageTimer timer(made.time);
      made.picture = film_.film().at(film_.frames().film_time(index));
    }
    return made;
  }

  Made awaited() {
    constexpr std::chrono::milliseconds kPatience{100};
    while (future_.wait_for(kPatience) != std::future_status::ready)
      stop_if_interrupted();
    return future_.get();
  }

  void begin(int index) {
    next_.reset();
    if (index == last_.value_or(index) || index < 0 || index >= film_.frames().count) return;
    if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
    Task task;
    if (!tasks_.wait_for_place(task)) return;
    task = Task([this, index] { return composed(index); });
    future_ = task.get_future();
    tasks_.push(std::move(task));
    next_ = index;
  }

  void run() {
    try {
      Task task;
      while (tasks_.pop(task))
        task();
    } catch (const Error& error) {
      CHECK(error.fault() == Fault::interrupted);
      tasks_.stop();
    }
  }

  const PreparedFilm& film_;
  std::optional<int> last_, next_;
  std::future<Made> future_;  // of next_
  BoundedQueue<Task> tasks_{1};
  std::thread thread_;  // last, so that it starts when all else is there
};

class LocalRenderer final : public FrameRenderer {
 public:
  LocalRenderer(const PreparedFilm& film, const RenderSetup& setup) : film_(film), composed_(film) {
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
    if (const Retouch retouch = begin(index, image)) retouch(image);
  }

  Retouch begin(int index, Image& image) override {
    const double time = film_.frames().film_time(index);
    const Picture picture = composed_.picture(index, compose_time_);
    const int moments = film_.shutter().moments();
    if (moments == 1) return renderer_->begin(picture, image);
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
    return {};
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
  const PreparedFilm& film_;
  std::unique_ptr<Context> context_;
  std::unique_ptr<Renderer> renderer_;
  std::set<int> rasteriser_;  // threads
  AveragePicture blurred_;
  ComposedAhead composed_;
  StageTime compose_time_;
};

}  // namespace

std::unique_ptr<FrameRenderer> open_local_renderer(const PreparedFilm& film,
                                                   const RenderSetup& setup) {
  return std::make_unique<LocalRenderer>(film, setup);
}

}  // namespace polhode
