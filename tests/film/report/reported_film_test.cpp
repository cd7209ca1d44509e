// SPDX-License-Identifier: MIT
#include "film/report/reported_film.h"

#include <gtest/gtest.h>

#include "film/drawn_frames.h"
#include "film/output/open_output.h"
#include "film/report/film_report.h"
#include "film/small_films.h"
#include "video/encoders.h"

namespace polhode {
namespace {

using test::NumberedFrames;

// A report of a small film, and copies of it that have been altered.
class ReportOfAFilm : public ::testing::Test {
 protected:
  ReportOfAFilm() {
    plan_ = test::plan_of(test::small_scene("[[story]]\nat = 0.2\ncaption = \"one\"\n"),
                          folder_ / "a.mp4");
    plan_.sink.encoder = settle_encoder(plan_.sink.output, {Grade::archive, "slow", {}, {}, 21});
    plan_.range.from = 0.3;
    plan_.range.to = 0.8;
    const PreparedFilm film(plan_);
    const std::unique_ptr<RenderOutput> output = open_output(plan_, true);
    output->begin(film);
    NumberedFrames renderer({64, 48});
    render_frames(*output, renderer, [](const PipelineStep&) {});
    json_ = json_of(film_report(plan_, film, *output, renderer));
  }
  ReportedFilm read(const Json& json) const {
    test::write_text(folder_ / "r.json", json.dump());
    return read_report(folder_ / "r.json");
  }
  void expect_refused(const Json& json, const std::string& words) const {
    try {
      read(json);
      ADD_FAILURE() << "was taken; expected " << words;
    } catch (const Error& error) {
      EXPECT_EQ(error.fault(), Fault::input);
      EXPECT_EQ(error.place().file, folder_ / "r.json");
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
  std::string broken(const Json& json) const { return read(json).broken.value_or(""); }

  test::TemporaryFolder folder_;
  RenderPlan plan_;
  Json json_;
};

TEST_F(ReportOfAFilm, GivesThePlanBack) {
  const ReportedFilm film = read(json_);
  EXPECT_FALSE(film.broken) << *film.broken;
  EXPECT_EQ(film.gl_renderer, "by hand");
  EXPECT_EQ(film.hashes.size(), 5U);
  EXPECT_EQ(film.plan.sink.output, plan_.sink.output);
  EXPECT_EQ(scene_hash(film.plan.scene), scene_hash(plan_.scene));
  EXPECT_EQ(film.plan.sink.width, 64);
  EXPECT_EQ(film.plan.sink.fps, plan_.sink.fps);
  EXPECT_EQ(film.plan.sink.comment, plan_.sink.comment);
  EXPECT_EQ(film.plan.sink.encoder.codec, plan_.sink.encoder.codec);
  EXPECT_EQ(film.plan.sink.encoder.preset, "slow");
  EXPECT_EQ(film.plan.sink.encoder.crf, 21);
  EXPECT_TRUE(film.plan.sink.encoder.finest);
  EXPECT_EQ(film.plan.sink.encoder.threads, plan_.sink.encoder.threads);
  EXPECT_EQ(film.plan.range.from, 0.3);
  EXPECT_EQ(film.plan.range.to, 0.8);
  EXPECT_FALSE(film.plan.range.one_picture);
  EXPECT_FALSE(film.plan.text);
  EXPECT_EQ(film.plan.setup.backend, "paper") << "what drew it then";
  ASSERT_EQ(film.plan.story.size(), 1U);
  EXPECT_EQ(film.plan.story[0].caption, "one");
}

TEST_F(ReportOfAFilm, OfOnePictureNamesItsMoment) {
  json_["still"] = true;
  json_["to_s"] = json_["from_s"];
  json_["output"] = "a.png";
  for (const char* key : {"codec", "preset", "crf"})
    json_["encoder"][key] = nullptr;
  json_["encoder"]["finest"] = false;
  const ReportedFilm film = read(json_);
  EXPECT_TRUE(film.plan.range.one_picture);
  EXPECT_EQ(film.plan.range.still, 0.3);
  EXPECT_FALSE(film.plan.range.from);
}

TEST_F(ReportOfAFilm, KnowsItsShard) {
  json_["shard"] = "2/3";
  const ReportedFilm film = read(json_);
  ASSERT_TRUE(film.plan.shard);
  EXPECT_EQ(film.plan.shard->number, 2);
  json_["shard"] = "4/3";
  expect_refused(json_, "K from 1 to N");
}

TEST_F(ReportOfAFilm, TellsWhatContradictsItself) {
  Json other = json_;
  other["scene"]["motion"]["duration"] = 0.9;
  EXPECT_NE(broken(other).find("has the hash " + scene_hash([&] {
                                 Scene scene = plan_.scene;
                                 scene.motion.duration = 0.9;
                                 return scene;
                               }())),
            std::string::npos)
      << broken(other);
  other = json_;
  other["frame_hashes"].erase(0);
  EXPECT_EQ(broken(other), "it has 4 hashes of 5 frames");
}

TEST_F(ReportOfAFilm, OfOtherVersionsIsRefused) {
  for (const char* what : {"polhode", "compiler", "eigen", "ffmpeg"}) {
    Json other = json_;
    other["versions"][what] = "0.0.1";
    expect_refused(other, std::string("made with ") + what + " \"0.0.1\"");
  }
  json_["versions"]["mesa"] = "1";
  expect_refused(json_, "made with mesa \"1\", this is null");
}

TEST_F(ReportOfAFilm, WithValuesThatNobodyCouldAskForIsRefused) {
  const auto refused_with = [&](const char* key, const Json& value, const char* words) {
    Json other = json_;
    other["encoder"][key] = value;
    expect_refused(other, words);
  };
  refused_with("threads", 0, "encoder.threads must be 1 to 64, got 0");
  refused_with("threads", 65, "encoder.threads must be 1 to 64, got 65");
  refused_with("crf", 99, "--crf");
  refused_with("crf", 4'294'967'314, "crf: 4294967314 is out of range");  // cut off, it would be 18
  refused_with("codec", "h265", "--codec");
  Json other = json_;
  other["captions"].push_back("two");
  expect_refused(other, "has 2 captions for the 1 steps");
  other = json_;
  other["from_s"] = 0.9;
  expect_refused(other, "--to");
}

// scenes in a report are named from where the film was rendered
TEST_F(ReportOfAFilm, FindsMeshesBesideItsScenesWhereverItIsMovedWithThem) {
  std::filesystem::create_directories(folder_ / "scenes");
  test::write_text(folder_ / "scenes/a.toml", "");
  test::write_text(folder_ / "scenes/a.obj",
                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  Json moved = json_;
  moved["scene_file"] = "scenes/a.toml";
  moved["scene"]["body"]["solid"] = {{"kind", "mesh"}, {"file", "a.obj"}, {"mass", 1.0}};
  EXPECT_NE(broken(moved).find("has the hash"), std::string::npos) << broken(moved);
  moved["scene_file"] = "elsewhere/a.toml";
  expect_refused(moved, "a.obj");
}

TEST_F(ReportOfAFilm, OtherFilesAreNoReports) {
  for (const char* key : {"scene", "versions", "frame_hashes", "encoder", "output"}) {
    Json other = json_;
    other.erase(key);
    expect_refused(other, "is not a report of `polhode render --report`");
  }
  expect_refused(Json::array(), "is not a report");
  test::write_text(folder_ / "r.json", "{");
  EXPECT_THROW(read_report(folder_ / "r.json"), Error);
  EXPECT_THROW(read_report(folder_ / "none.json"), Error);
}

}  // namespace
}  // namespace polhode
