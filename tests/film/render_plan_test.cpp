// SPDX-License-Identifier: MIT
#include "film/render_plan.h"

#include <set>

#include <gtest/gtest.h>

#include "base/version.h"
#include "support/expect_error.h"
#include "support/in_child.h"
#include "support/run.h"
#include "video/encoders.h"

namespace polhode {
namespace {

class PlanOfARender : public ::testing::Test {
 protected:
  PlanOfARender() {
    test::write_text(folder_ / "top.toml",
                     std::string(test::kSmallScene) +
                         "[show]\ncaption = \"below\"\ntitle = true\n"
                         "[[story]]\nat = 0.5\ncaption = \"now\"\n");
  }
  RenderJob job(const std::string& output) const {
    RenderJob job;
    job.scene = folder_ / "top.toml";
    job.output = folder_ / output;
    return job;
  }
  void expect_refused(const RenderJob& job, const char* option, const char* words) const {
    test::expect_input_error([&] { plan_render(job); }, option, words);
  }

  test::TemporaryFolder folder_;
};

TEST_F(PlanOfARender, TellsTheSinkWhatTheSceneSays) {
  const RenderPlan plan = plan_render(job("a.mp4"));
  EXPECT_EQ(plan.sink.output, folder_ / "a.mp4");
  EXPECT_EQ(plan.sink.width, 128);
  EXPECT_EQ(plan.sink.height, 72);
  EXPECT_EQ(plan.sink.fps, (FrameRate{10, 1}));
  EXPECT_EQ(plan.sink.title, "test");
  EXPECT_EQ(plan.sink.comment,
            "polhode " + program_version() + ", scene " + scene_hash(plan.scene));
  EXPECT_TRUE(plan.sink.captions);
  EXPECT_FALSE(plan.sink.still);
  EXPECT_FALSE(plan.range.one_picture);
  EXPECT_FALSE(plan.shard);
  EXPECT_EQ(plan.setup.backend, "auto");
  EXPECT_EQ(plan.setup.jobs, 1);
}

TEST_F(PlanOfARender, PassesOnWhatIsAsked) {
  RenderJob asked = job("a.webm");
  asked.from = 0.25;
  asked.to = 0.75;
  asked.transparent = true;
  asked.crf = 33;
  asked.backend = "osmesa";
  asked.jobs = 64;
  asked.shard = "2/3";
  asked.overrides.size = "64x48";
  const RenderPlan plan = plan_render(asked);
  EXPECT_EQ(plan.range.from, 0.25);
  EXPECT_EQ(plan.range.to, 0.75);
  EXPECT_TRUE(plan.sink.transparent);
  EXPECT_TRUE(plan.setup.transparent);
  EXPECT_EQ(plan.sink.encoder.crf, 33);
  EXPECT_EQ(plan.sink.encoder.codec, "vp9");
  EXPECT_EQ(plan.setup.backend, "osmesa");
  EXPECT_EQ(plan.setup.jobs, 64);
  ASSERT_TRUE(plan.shard);
  EXPECT_EQ(plan.shard->number, 2);
  EXPECT_EQ(plan.sink.width, 64);
  EXPECT_EQ(plan.scene.video.size.height, 48);
}

// what is laid over a slide has a floor only if the scene asks for one
TEST_F(PlanOfARender, WithoutBackgroundThereIsNoFloorByDefault) {
  RenderJob asked = job("a.webm");
  EXPECT_FALSE(plan_render(asked).scene.show["floor"].has_value());
  asked.transparent = true;
  EXPECT_EQ(plan_render(asked).scene.show["floor"], false);
  asked.overrides.settings = {{"show.floor", "true"}};
  EXPECT_EQ(plan_render(asked).scene.show["floor"], true);
}

// the size is halved and stays even, the encoder hurries
TEST_F(PlanOfARender, ADraftIsSmallAndFast) {
  RenderJob asked = job("a.mp4");
  asked.quality = "draft";
  asked.overrides.size = "130x70";
  const RenderPlan draft = plan_render(asked);
  EXPECT_EQ(draft.sink.width, 64);
  EXPECT_EQ(draft.sink.height, 34);
  EXPECT_EQ(draft.sink.encoder.preset, "ultrafast");
  asked.overrides.size = "20x20";
  EXPECT_EQ(plan_render(asked).sink.width, 16) << "no smaller than pictures may be";
  asked.quality = "lecture";
  EXPECT_EQ(plan_render(asked).sink.width, 20);
  const int lecture = plan_render(asked).sink.encoder.crf;
  EXPECT_GT(draft.sink.encoder.crf, lecture);
  asked.quality = "archive";
  EXPECT_LT(plan_render(asked).sink.encoder.crf, lecture);
  asked.quality = "lectrue";
  expect_refused(asked, "--quality", "did you mean 'lecture'?");
}

TEST(Qualities, HavePresetsThatEncodersKnow) {
  const std::vector<std::string>& presets = encoder_presets();
  std::set<std::string> names;
  for (const Quality& row : qualities()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_NE(std::find(presets.begin(), presets.end(), row.preset), presets.end()) << row.name;
    EXPECT_GE(row.shrink, 1) << row.name;
    EXPECT_FALSE(row.doc.empty()) << row.name;
  }
}

// the picture has no words, and the film's captions and chapters still have theirs
TEST_F(PlanOfARender, WithoutTextThePictureAloneIsSilent) {
  RenderJob asked = job("a.mp4");
  EXPECT_EQ(plan_render(asked).scene.show.caption, "below");
  asked.text = false;
  const RenderPlan plan = plan_render(asked);
  EXPECT_FALSE(plan.text);
  EXPECT_FALSE(plan.scene.show.labels);
  EXPECT_FALSE(plan.scene.show.title);
  EXPECT_FALSE(plan.scene.show.clock);
  EXPECT_EQ(plan.scene.show.caption, "");
  ASSERT_EQ(plan.story.size(), 1U);
  EXPECT_EQ(plan.story[0].caption, "now");
  EXPECT_FALSE(plan.scene.story[0].caption);
}

TEST_F(PlanOfARender, APngWithoutANumberIsOnePicture) {
  RenderPlan plan = plan_render(job("a.png"));
  EXPECT_TRUE(plan.sink.still);
  EXPECT_TRUE(plan.range.one_picture);
  EXPECT_FALSE(plan_render(job("a_%03d.png")).sink.still);
  RenderJob asked = job("a.png");
  asked.output = "hash:" + asked.output;
  EXPECT_FALSE(plan_render(asked).sink.still) << "a list of hashes, whatever it is called";
  asked.still = 0.5;
  plan = plan_render(asked);
  EXPECT_TRUE(plan.sink.still);
  EXPECT_EQ(plan.range.still, 0.5);
}

TEST_F(PlanOfARender, OnePictureIsNoFilmAndNoSequence) {
  RenderJob asked = job("a_%03d.png");
  asked.still = 0.5;
  expect_refused(asked, "--still", "leave out the %");
  asked.output.clear();
  asked.scene = folder_ / "%d.toml";
  std::filesystem::copy_file(folder_ / "top.toml", asked.scene);
  expect_refused(asked, "--output", "name the picture");
  asked = job("a.mp4");
  asked.still = 0.5;
  expect_refused(asked, "--still", "name a .png");
  asked = job("a.png");
  asked.still = 1.5;
  expect_refused(asked, "--still", "0 to 1 s");
}

// what it cannot show is not drawn, and no report counts it
TEST_F(PlanOfARender, AGifIsSlowEnough) {
  RenderJob asked = job("a.gif");
  asked.overrides.fps = "60";
  EXPECT_EQ(plan_render(asked).scene.video.fps, (FrameRate{30, 1}));
  EXPECT_EQ(plan_render(asked).sink.fps, (FrameRate{30, 1}));
  asked.overrides.fps = "25";
  EXPECT_EQ(plan_render(asked).sink.fps, (FrameRate{25, 1}));
  asked = job("a.mp4");
  asked.overrides.fps = "60";
  EXPECT_EQ(plan_render(asked).sink.fps, (FrameRate{60, 1}));
}

TEST_F(PlanOfARender, PiecesAreOfFilmsSequencesAndHashes) {
  for (const char* output : {"a.mp4", "a.webm", "a.mov", "a_%d.png", "a.hash"}) {
    RenderJob asked = job(output);
    asked.shard = "1/2";
    EXPECT_TRUE(plan_render(asked).shard) << output;
  }
  for (const char* output : {"a.gif", "a.apng", "a.png", "a.y4m"}) {
    RenderJob asked = job(output);
    asked.shard = "1/2";
    expect_refused(asked, "--shard", "cannot be made in pieces");
  }
  for (const char* output : {"a.gif", "a_%d.png", "a.hash"}) {
    RenderJob asked = job(output);
    asked.resume = true;
    expect_refused(asked, "--resume", "cannot be resumed");
  }
  RenderJob both = job("a.mp4");
  both.resume = true;
  EXPECT_TRUE(plan_render(both).resume);
  both.shard = "1/2";
  EXPECT_TRUE(plan_render(both).resume && plan_render(both).shard);
}

TEST_F(PlanOfARender, PiecesAreAtLeastOne) {
  RenderJob asked = job("a.mp4");
  asked.pieces = 4;
  expect_refused(asked, "--pieces", "of --resume");
  asked.resume = true;
  EXPECT_EQ(plan_render(asked).pieces, 4);
  for (const int pieces : {0, -3}) {
    asked.pieces = pieces;
    expect_refused(asked, "--pieces", fmt::format("got {}", pieces).c_str());
  }
}

TEST_F(PlanOfARender, JobsAreOneToSixtyFour) {
  RenderJob asked = job("a.mp4");
  for (const int jobs : {-1, 0}) {
    asked.jobs = jobs;
    expect_refused(asked, "--jobs", "at least 1");
  }
  asked.jobs = 65;
  expect_refused(asked, "--jobs", "at most 64");
}

// beside where the program runs, in a folder that is made
TEST_F(PlanOfARender, WithoutANameTheOutputIsCalledAsItsScene) {
  EXPECT_EQ(test::exit_code_in_child([&] {
              std::filesystem::current_path(folder_.path());
              RenderJob asked = job("");
              asked.output.clear();
              const bool film = plan_render(asked).sink.output == "output/top.mp4";
              asked.still = 0.5;
              const bool still = plan_render(asked).sink.output == "output/top.png";
              return film && still && std::filesystem::is_directory("output") ? 0 : 1;
            }),
            0);
}

}  // namespace
}  // namespace polhode
