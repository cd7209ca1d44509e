// SPDX-License-Identifier: MIT
// PNG pictures and sequences, hashes, and the pipeline between two threads.
#include <csignal>
#include <thread>

#include "base/error.h"
#include "base/system/interrupt.h"
#include "image/png.h"
#include "support/full_disk.h"
#include "support/run.h"
#include "video/pipeline.h"
#include "video/png_sink.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace {

using test::TemporaryFolder;

Image frame(int index) {
  Image image(8, 6);
  for (std::uint8_t& value : image.pixels)
    value = static_cast<std::uint8_t>(index * 7 + 1);
  return image;
}

SinkJob job_for(const std::string& output) {
  SinkJob job;
  job.output = output;
  job.width = 8;
  job.height = 6;
  job.transparent = true;
  return job;
}

TEST(NumberedName, OneNumberAndNothingElse) {
  EXPECT_EQ(parse_numbered_name("a_%05d.png").of(42), "a_00042.png");
  EXPECT_EQ(parse_numbered_name("%d.png").of(42), "42.png");
  EXPECT_EQ(parse_numbered_name("a_%01d.png").of(1234567), "a_1234567.png");
  for (const char* pattern : {"a.png",
                              "%s.png",
                              "%d%d.png",
                              "%n.png",
                              "%999999d.png",
                              "%5d.png",
                              "%%d.png",
                              "%05d%.png",
                              "%0d.png",
                              "%-5d.png",
                              "%05ld.png",
                              "%x.png",
                              "%*d.png",
                              "%"}) {
    EXPECT_THROW(parse_numbered_name(pattern), Error) << pattern;
  }
}

TEST(PngSequence, WritesEveryFrameAndRemovesThemIfAbandoned) {
  const TemporaryFolder folder;
  {
    const auto sink = make_sink(job_for(folder / "f_%03d.png"));
    for (int i = 0; i < 4; ++i)
      sink->push(frame(i));
    EXPECT_EQ(folder.entries(), 4);
  }
  EXPECT_EQ(folder.entries(), 0) << "not finished";
  const auto sink = make_sink(job_for(folder / "f_%03d.png"));
  for (int i = 0; i < 4; ++i)
    sink->push(frame(i));
  sink->finish();
  EXPECT_EQ(folder.entries(), 4);
  EXPECT_EQ(read_png(folder / "f_003.png").pixels, frame(3).pixels);
}

// a run that fails must not take the frames of the last one with it
TEST(PngSequence, AbandonedKeepsTheOldFrames) {
  const TemporaryFolder folder;
  test::write_text(folder / "f_001.png", "an older frame");
  {
    const auto sink = make_sink(job_for(folder / "f_%03d.png"));
    for (int i = 0; i < 4; ++i)
      sink->push(frame(i));
    EXPECT_FALSE(std::filesystem::exists(folder / "f_000.png")) << "before finish()";
  }
  EXPECT_EQ(folder.entries(), 1);
  EXPECT_EQ(test::read_text(folder / "f_001.png"), "an older frame");
}

TEST(PngSequence, AFrameThatCannotBeWrittenRemovesTheOthers) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "f_002.png");
  const auto make = [&] {
    const auto sink = make_sink(job_for(folder / "f_%03d.png"));
    for (int i = 0; i < 4; ++i)
      sink->push(frame(i));
  };
  EXPECT_THROW(make(), Error);
  EXPECT_EQ(folder.entries(), 1) << "only the folder in the way";
}

TEST(PlainSinks, AFullDiskIsAnErrorAndLeavesNothing) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "f_%d.png", "a.hash"}) {
    SinkJob job = job_for(folder / name);
    job.still = std::string(name) == "a.png";
    const auto make = [&] {
      const auto sink = make_sink(job);
      sink->push(frame(0));
      if (!job.still) sink->push(frame(1));
      sink->finish();
    };
    EXPECT_EQ(test::with_full_disk(20, make), test::Outcome::environment) << name;
    EXPECT_EQ(folder.entries(), 0) << name;
    EXPECT_EQ(test::with_full_disk(100000, make), test::Outcome::done) << name;
    EXPECT_GT(folder.entries(), 0) << name;
    for (const auto& made : std::filesystem::directory_iterator(folder.path()))
      std::filesystem::remove(made.path());
  }
}

TEST(Still, IsWrittenAtTheEndAndKeepsAlpha) {
  const TemporaryFolder folder;
  SinkJob job = job_for(folder / "a.png");
  job.still = true;
  const auto sink = make_sink(job);
  sink->push(frame(1));
  EXPECT_FALSE(std::filesystem::exists(job.output));
  sink->finish();
  EXPECT_EQ(folder.entries(), 1);
  EXPECT_EQ(read_png(job.output).pixels, frame(1).pixels);
}

TEST(Png, NeedsToKnowThatItIsOnePicture) {
  const TemporaryFolder folder;
  try {
    make_sink(job_for(folder / "a.png"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("name_%05d.png"), std::string::npos);
  }
  EXPECT_EQ(folder.entries(), 0);
}

TEST(Hash, OneLinePerFrameThatDependsOnEveryByte) {
  const TemporaryFolder folder;
  const auto lines_of = [&](const std::vector<Image>& frames) {
    const auto sink = make_sink(job_for(folder / "a.hash"));
    for (const Image& image : frames)
      sink->push(image);
    sink->finish();
    return test::read_text(folder / "a.hash");
  };
  Image changed = frame(1);
  changed.pixels.back() ^= 1;
  const std::string first = lines_of({frame(0), frame(1)});
  EXPECT_EQ(first, lines_of({frame(0), frame(1)}));
  EXPECT_NE(first, lines_of({frame(0), changed}));
  EXPECT_EQ(first.rfind("0 8x6 ", 0), 0u);
  EXPECT_NE(first.find("\n1 8x6 "), std::string::npos);
}

TEST(Hash, HasAFormWithoutEnding) {
  const TemporaryFolder folder;
  for (const char* name : {"frames.txt", "frames.mp4", "frames.png", "frames"}) {
    const auto sink = make_sink(job_for("hash:" + (folder / name)));
    sink->push(frame(0));
    sink->finish();
    EXPECT_EQ(test::read_text(folder / name).rfind("0 8x6 ", 0), 0u) << name;
  }
  EXPECT_THROW(make_sink(job_for("hash:")), Error);
}

TEST(Null, WritesNothing) {
  const auto sink = make_sink(job_for("null"));
  sink->push(frame(0));
  sink->finish();
  EXPECT_FALSE(std::filesystem::exists("null"));
}

// a sink that remembers and can fail
class TestSink final : public FrameSink {
 public:
  explicit TestSink(int fail_at) : fail_at_(fail_at) {}
  void push(const Image& image) override {
    if (static_cast<int>(seen.size()) == fail_at_) throw environment_error("sink failed");
    seen.push_back(image.pixels[0]);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
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
      [](int i, Image& image) { image = frame(i); },
      sink,
      [&](const PipelineStep& step) { last = step.done; });
  ASSERT_EQ(sink.seen.size(), 30u);
  for (int i = 0; i < 30; ++i)
    EXPECT_EQ(sink.seen[static_cast<std::size_t>(i)], (i * 7 + 1) & 255);
  EXPECT_TRUE(sink.finished);
  EXPECT_EQ(last, 30);
}

TEST(Pipeline, AFailingSinkStopsTheMakerAndIsHeard) {
  TestSink sink(3);
  int made = 0;
  try {
    run_pipeline(
        1000,
        [&](int i, Image& image) {
          image = frame(i);
          ++made;
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

}  // namespace
}  // namespace polhode
