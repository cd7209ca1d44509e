// SPDX-License-Identifier: MIT
#include "film/report/film_report.h"

#include <gtest/gtest.h>

#include "film/drawn_frames.h"
#include "film/output/open_output.h"
#include "film/small_films.h"
#include "scene/canonical.h"
#include "video/plain_sinks.h"

namespace polhode {
namespace {

using test::NumberedFrames;
using test::plan_of;
using test::small_scene;

// a film that has been drawn by hand
FilmReport record_of_film(const RenderPlan& plan) {
  const PreparedFilm film(plan);
  const std::unique_ptr<RenderOutput> output = open_output(plan, true);
  output->begin(film);
  NumberedFrames renderer({64, 48});
  render_frames(*output, renderer, [](const PipelineStep&) {});
  return film_report(plan, film, *output, renderer);
}

TEST(FilmReport, TellsWhatWasAskedForAndWhatWasMade) {
  const RenderPlan plan = plan_of(small_scene());
  const FilmReport record = record_of_film(plan);
  EXPECT_EQ(record.output, "null");
  EXPECT_EQ(record.scene_file, "scene.toml");
  EXPECT_EQ(record.title, "test");
  EXPECT_EQ(record.scene_hash, scene_hash(plan.scene));
  EXPECT_EQ(record.scene, scene_to_json(plan.scene));
  EXPECT_EQ(record.versions, versions());
  EXPECT_EQ(record.motion.method, "exact");
  EXPECT_EQ(record.frames, 10);
  EXPECT_EQ(record.first_frame, 0);
  EXPECT_EQ(record.size.width, 64);
  EXPECT_EQ(record.size.height, 48);
  EXPECT_EQ(record.fps, (FrameRate{10, 1}));
  EXPECT_EQ(record.from_s, 0.0);
  EXPECT_EQ(record.to_s, 1.0);
  EXPECT_FALSE(record.text);
  EXPECT_FALSE(record.shard);
  EXPECT_FALSE(record.compare);
  EXPECT_FALSE(record.loop);
  ASSERT_EQ(record.frame_hashes.size(), 10U);
  Image seventh;
  NumberedFrames({64, 48}).render(7, seventh);
  EXPECT_EQ(record.frame_hashes[7], frame_hash(seventh));
}

TEST(FilmReport, TellsWhatDrewItAndHowLongThatTook) {
  const FilmReport record = record_of_film(plan_of(small_scene()));
  EXPECT_EQ(record.backend, "paper");
  EXPECT_EQ(record.gl_renderer, "by hand");
  EXPECT_EQ(record.gl_version, "0.1");
  EXPECT_EQ(record.samples, 3);
  EXPECT_EQ(record.edges, "outlines");
  EXPECT_EQ(record.stages.compose.wall_s, 10.0);
  EXPECT_EQ(record.stages.draw.cpu_s, 40.0);
  EXPECT_EQ(record.stages.read_back.wall_s, 50.0);
  EXPECT_EQ(record.stages.smooth.wall_s, 70.0);
  EXPECT_GT(record.stages.simulate.wall_s, 0.0);
}

TEST(FilmReport, HasWhatIsSpecialAboutAFilm) {
  RenderPlan plan =
      plan_of(small_scene("loop = true\n[[story]]\nat = 0\ncaption = \"one\"\n[[story]]\nat = 0.5\n"
                          "[numerics]\ncompare = [\"rk4\", \"exact\"]\nstep = 0.01\n"));
  plan.scene.motion.spin.body = Vec3(0.0, 0.0, 2.0 * kPi / 0.8);
  plan.shard = Shard{2, 4};
  plan.setup.jobs = 3;
  plan.sink.encoder.codec = "h264";
  plan.sink.encoder.crf = 0;
  const FilmReport record = record_of_film(plan);
  EXPECT_EQ(record.shard, "2/4");
  EXPECT_EQ(record.first_frame, 2);
  EXPECT_EQ(record.frames, 2);
  EXPECT_EQ(record.jobs, 3);
  ASSERT_EQ(record.captions.size(), 2U);
  EXPECT_EQ(record.captions[0], "one");
  EXPECT_FALSE(record.captions[1]);
  ASSERT_TRUE(record.compare);
  EXPECT_EQ(record.compare->size(), 2U);
  ASSERT_TRUE(record.loop);
  EXPECT_NEAR(record.loop->duration, 0.8, 1e-6);
  EXPECT_EQ(record.encoder.codec, "h264");
  EXPECT_FALSE(record.encoder.crf) << "this encoder takes none";
}

// the report is read by the list of fields that has written it
TEST(FilmReport, IsReadBackAsItWasWritten) {
  RenderPlan plan = plan_of(small_scene("[[story]]\nat = 0\ncaption = \"one\"\n"));
  plan.sink.fps = plan.scene.video.fps = {30000, 1001};
  const FilmReport record = record_of_film(plan);
  const Json json = json_of(record);
  EXPECT_EQ(json.at("fps"), "30000/1001");
  EXPECT_EQ(json.at("width"), 64);
  EXPECT_TRUE(json.at("shard").is_null());
  EXPECT_FALSE(json.contains("loop"));
  EXPECT_EQ(json.at("method"), "exact") << "the motion's keys stand beside the film's";
  EXPECT_EQ(json.at("stages").at("draw").at("wall_s"), record.stages.draw.wall_s);
  FilmReport read;
  read_json(Json::parse(json.dump()), read);
  EXPECT_EQ(json_of(read), json);
  EXPECT_EQ(read.fps, record.fps);
}

}  // namespace
}  // namespace polhode
