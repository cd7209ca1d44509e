// SPDX-License-Identifier: MIT
// The pipeline between the thread that makes frames and the one that writes them.
#include "video/pipeline.h"

#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <thread>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/system/interrupt.h"

namespace polhode {
namespace {

Image frame(int index) {
  Image image(8, 6);
  for (std::uint8_t& value : image.pixels)
    value = static_cast<std::uint8_t>(index * 7 + 1);
  return image;
}

// a sink that remembers and can fail
class TestSink final : public FrameSink {
 public:
  explicit TestSink(int fail_at) : fail_at_(fail_at) {}
  void push(const Image& image) override {
    if (static_cast<int>(seen.size()) == fail_at_) throw environment_error("sink failed");
    seen.push_back(image.pixels[0]);
  }
  void finish() override { finished = true; }
  SinkTimes times() const override { return {}; }

  std::vector<int> seen;
  bool finished = false;

 private:
  int fail_at_;
};

TEST(Pipeline, EveryFrameOnceAndInOrder) {
  TestSink sink(-1);
  int last = 0;
  run_pipeline(
      30,
      [](int i, Image& image) {
        image = frame(i);
        return Retouch{};
      },
      sink,
      [&](const PipelineStep& step) { last = step.done; });
  ASSERT_EQ(sink.seen.size(), 30u);
  for (int i = 0; i < 30; ++i)
    EXPECT_EQ(sink.seen[static_cast<std::size_t>(i)], (i * 7 + 1) & 255);
  EXPECT_TRUE(sink.finished);
  EXPECT_EQ(last, 30);
}

// the rest of the work on a frame is done before it is written, on the other thread
TEST(Pipeline, FramesAreRetouchedOnceBeforeTheyAreWritten) {
  TestSink sink(-1);
  const std::thread::id maker = std::this_thread::get_id();
  run_pipeline(
      30,
      [&](int i, Image& image) -> Retouch {
        image = frame(i);
        if (i % 3 == 0) return {};
        return [maker](Image& made) {
          EXPECT_NE(std::this_thread::get_id(), maker);
          made.pixels[0] = static_cast<std::uint8_t>(made.pixels[0] + 100);
        };
      },
      sink,
      [](const PipelineStep&) {});
  ASSERT_EQ(sink.seen.size(), 30u);
  for (int i = 0; i < 30; ++i)
    EXPECT_EQ(sink.seen[static_cast<std::size_t>(i)], (i * 7 + (i % 3 == 0 ? 1 : 101)) & 255);
}

TEST(Pipeline, AFailingRetouchStopsTheMakerAndIsHeard) {
  TestSink sink(-1);
  const auto produce = [](int i, Image& image) -> Retouch {
    image = frame(i);
    return [i](Image&) {
      if (i == 3) throw environment_error("retouch failed");
    };
  };
  EXPECT_THROW(run_pipeline(1000, produce, sink, [](const PipelineStep&) {}), Error);
  EXPECT_EQ(sink.seen.size(), 3u);
  EXPECT_FALSE(sink.finished);
}

TEST(Pipeline, AFailingSinkStopsTheMakerAndIsHeard) {
  TestSink sink(3);
  int made = 0;
  try {
    run_pipeline(
        1000,
        [&](int i, Image& image) {
          ++made;
          image = frame(i);
          return Retouch{};
        },
        sink,
        [](const PipelineStep&) {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.message(), "sink failed");
  }
  EXPECT_FALSE(sink.finished);
  EXPECT_LT(made, 30) << "bounded queue";
}

TEST(Pipeline, AFailingMakerStopsTheSinkAndIsHeard) {
  TestSink sink(-1);
  const auto produce = [](int i, Image& image) {
    if (i == 5) throw environment_error("maker failed");
    image = frame(i);
    return Retouch{};
  };
  EXPECT_THROW(run_pipeline(1000, produce, sink, [](const PipelineStep&) {}), Error);
  EXPECT_FALSE(sink.finished);
  EXPECT_LE(sink.seen.size(), 5u);
}

TEST(Pipeline, AnInterruptIsAnErrorOfItsOwn) {
  EXPECT_EXIT(
      {
        watch_for_interrupt();
        TestSink sink(-1);
        const auto produce = [](int i, Image& image) {
          if (i == 5) std::raise(SIGTERM);
          image = frame(i);
          return Retouch{};
        };
        try {
          run_pipeline(1000, produce, sink, [](const PipelineStep&) {});
        } catch (const Error& error) {
          std::exit(error.fault() == Fault::interrupted && !sink.finished ? 42 : 1);
        }
        std::exit(2);
      },
      ::testing::ExitedWithCode(42),
      "");
}

// A sink that takes no frame before the maker is as far ahead of it as it may be.
class SlowSink final : public FrameSink {
 public:
  explicit SlowSink(int frames) : frames_(frames) {}
  void made_one() {
    const std::lock_guard lock(mutex_);
    ++made_;
    changed_.notify_all();
  }
  void push(const Image&) override {
    std::unique_lock lock(mutex_);
    // one frame is here, four wait
    const int most = std::min(frames_, ++taken_ + 4);
    changed_.wait(lock, [&] { return made_ >= most; });
    farthest = std::max(farthest, made_ - taken_);
  }
  void finish() override {}
  SinkTimes times() const override { return {}; }

  int farthest = 0;  // frames ahead of the one that is written

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int frames_;
  int made_ = 0, taken_ = 0;
};

TEST(Pipeline, TheMakerIsAtMostFourFramesAhead) {
  constexpr int kFrames = 40;
  SlowSink sink(kFrames);
  run_pipeline(
      kFrames,
      [&](int i, Image& image) {
        sink.made_one();
        image = frame(i);
        return Retouch{};
      },
      sink,
      [](const PipelineStep&) {});
  EXPECT_EQ(sink.farthest, 4);
}

// buffers that have been written come back to be drawn into
TEST(Pipeline, BuffersAreUsedAgain) {
  TestSink sink(-1);
  int fresh = 0;
  run_pipeline(
      100,
      [&](int i, Image& image) {
        fresh += image.pixels.empty() ? 1 : 0;
        image = frame(i);
        return Retouch{};
      },
      sink,
      [](const PipelineStep&) {});
  EXPECT_LE(fresh, 6) << "four wait, one is written, one is made";
}

}  // namespace
}  // namespace polhode
