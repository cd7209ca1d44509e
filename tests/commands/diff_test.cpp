// SPDX-License-Identifier: MIT
// `polhode diff` as a user, a program and a hostile user call it.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "image/png.h"
#include "support/background.h"
#include "support/flat_image.h"
#include "video/frame_sink.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace {

using test::Ran;
using test::run_polhode;
using test::TemporaryFolder;
using test::write_text;

Image flat(int level, int width = 64, int height = 48) {
  return test::flat_image(width, height, level, level, level);
}

class Diff : public ::testing::Test {
 protected:
  Ran diff(const std::string& a,
           const std::string& b,
           const std::string& options = "",
           const std::string& before = "") const {
    return run_polhode(fmt::format("diff '{}' '{}' {}", folder_ / a, folder_ / b, options), before);
  }
  void picture(const std::string& name, const Image& image) const {
    write_png(folder_ / name, image, false);
  }
  // `frames` levels of grey
  void film(const std::string& name,
            const std::vector<int>& levels,
            FrameRate fps = {25, 1}) const {
    SinkJob job;
    job.output = folder_ / name;
    job.width = 64;
    job.height = 48;
    job.fps = fps;
    const std::unique_ptr<FrameSink> sink = make_sink(job);
    for (const int level : levels)
      sink->push(flat(level));
    sink->finish();
  }
  void refuses(const Ran& ran, const std::string& says) const {
    EXPECT_EQ(ran.code, 2) << ran.out << ran.err;
    EXPECT_NE(ran.err.find(says), std::string::npos) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_EQ(ran.out, "");
  }

  TemporaryFolder folder_;
};

TEST_F(Diff, PicturesSameAndDifferent) {
  picture("a.png", flat(100));
  picture("b.png", flat(103));
  picture("c.png", flat(104));
  const Ran same = diff("a.png", "a.png");
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_EQ(same.out.substr(0, 5), "same\n");
  EXPECT_EQ(diff("a.png", "b.png").code, 0);
  const Ran different = diff("a.png", "c.png");
  EXPECT_EQ(different.code, 1);
  EXPECT_EQ(different.err, "");
  EXPECT_NE(different.out.find("100% of the pixels differ by more than 3"), std::string::npos)
      << different.out;
  EXPECT_EQ(diff("a.png", "c.png", "--max 4").code, 0);
  EXPECT_EQ(diff("a.png", "c.png", "--fraction 1").code, 0);
  EXPECT_EQ(diff("a.png", "c.png", "--fraction 1 --limit 3").code, 1);
  EXPECT_EQ(diff("a.png", "b.png", "--max 0 --fraction 0 --limit 0").code, 1);
  EXPECT_EQ(diff("a.png", "b.png", "--ssim 0.999999").code, 1);
  EXPECT_EQ(diff("a.png", "b.png", "--flip 0.01").code, 1);
  EXPECT_EQ(diff("a.png", "b.png", "--flip 0.2 --ssim 0.9").code, 0);
}

TEST_F(Diff, JsonHasEveryNumber) {
  picture("a.png", flat(100));
  picture("c.png", flat(110));
  const Ran ran = diff("a.png", "c.png", "--json --flip 0.5");
  EXPECT_EQ(ran.code, 1);
  const auto json = nlohmann::json::parse(ran.out);
  EXPECT_EQ(json.at("same"), false);
  EXPECT_EQ(json.at("largest"), 10);
  EXPECT_DOUBLE_EQ(json.at("mean"), 10.0);
  EXPECT_DOUBLE_EQ(json.at("rmse"), 10.0);
  EXPECT_DOUBLE_EQ(json.at("fraction_over"), 1.0);
  EXPECT_NEAR(json.at("psnr_db"), 28.13, 0.01);
  EXPECT_GT(json.at("flip"), 0.05);
  EXPECT_LT(json.at("ssim"), 1.0);
  EXPECT_EQ(json.at("thresholds").at("limit"), 70);
  EXPECT_EQ(nlohmann::json::parse(diff("a.png", "a.png", "--json").out).at("psnr_db"), nullptr);
}

TEST_F(Diff, SequencesArePairedByNumberAndFoldersByName) {
  std::filesystem::create_directory(folder_ / "one");
  std::filesystem::create_directory(folder_ / "two");
  for (int i = 0; i < 12; ++i) {
    picture(fmt::format("one/f_{:05}.png", i), flat(10 * i));
    picture(fmt::format("two/f_{:05}.png", i), flat(10 * i + (i == 7 ? 50 : 0)));
  }
  const Ran numbered = diff("one/f_%05d.png", "two/f_%05d.png", "--json");
  EXPECT_EQ(numbered.code, 1) << numbered.err;
  const auto json = nlohmann::json::parse(numbered.out);
  EXPECT_EQ(json.at("frames"), 12);
  EXPECT_EQ(json.at("different_frames"), 1);
  EXPECT_EQ(json.at("worst_frame"), 7);
  EXPECT_EQ(json.at("per_frame").at(7).at("largest"), 50);
  const Ran folders = diff("one", "two");
  EXPECT_EQ(folders.code, 1);
  EXPECT_NE(folders.out.find("f_00007.png"), std::string::npos) << folders.out;
  EXPECT_EQ(diff("one", "one").code, 0);
  std::filesystem::remove(folder_ / "two/f_00003.png");
  refuses(diff("one", "two"), "has no picture 'f_00003.png'");
  refuses(diff("one/f_%05d.png", "two/f_%05d.png"), "has no number '3'");
  refuses(diff("one/g_%05d.png", "two/f_%05d.png"), "the picture does not exist");
}

TEST_F(Diff, FilmsArePairedByTime) {
  std::vector<int> levels(30);
  for (int i = 0; i < 30; ++i)
    levels[static_cast<std::size_t>(i)] = 40 + 4 * i;
  film("a.mp4", levels);
  levels[20] += 60;
  film("b.mp4", levels);
  EXPECT_EQ(diff("a.mp4", "a.mp4").code, 0);
  const Ran ran = diff("a.mp4", "b.mp4", "--json");
  EXPECT_EQ(ran.code, 1) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  EXPECT_EQ(json.at("frames"), 30);
  EXPECT_EQ(json.at("worst_frame"), 20);
  EXPECT_NEAR(json.at("per_frame").at(20).at("time_s"), 0.8, 1e-6);
  levels.pop_back();
  film("short.mp4", levels);
  refuses(diff("a.mp4", "short.mp4"), "has 29 frames");
  film("slow.mp4", levels, {12, 1});
  refuses(diff("slow.mp4", "a.mp4"), "shows none then");
}

TEST_F(Diff, AFilmAgainstItsPictures) {
  std::filesystem::create_directory(folder_ / "frames");
  film("a.mp4", {50, 60, 70});
  for (int i = 0; i < 3; ++i)
    picture(fmt::format("frames/{}.png", i), flat(50 + 10 * i));
  const Ran ran = diff("a.mp4", "frames");
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
}

TEST_F(Diff, ScenesAreRenderedAtTheSizeOfTheReference) {
  write_text(folder_ / "scene.toml", test::kSmallScene);
  const auto render = [&](const std::string& out, const std::string& options) {
    const Ran ran = run_polhode(
        fmt::format("render '{}' -o '{}' {}", folder_ / "scene.toml", folder_ / out, options));
    ASSERT_EQ(ran.code, 0) << ran.err;
  };
  render("ref.png", "--still 0.5 --size 160x90");
  EXPECT_EQ(diff("scene.toml", "ref.png", "--still 0.5").code, 0);
  EXPECT_EQ(diff("ref.png", "scene.toml", "--still 0.5").code, 0);
  EXPECT_EQ(diff("scene.toml", "ref.png", "--still 0.9").code, 1);
  EXPECT_EQ(diff("scene.toml", "ref.png", "--still 0.5 --no-text").code, 1);
  render("clear.png", "--still 0.5 --transparent");
  EXPECT_EQ(diff("scene.toml", "clear.png", "--still 0.5").code, 0);
  render("ref.mp4", "--fps 8");
  const Ran film = diff("scene.toml", "ref.mp4");
  EXPECT_EQ(film.code, 0) << film.out << film.err;
  render("f_%03d.png", "");
  EXPECT_EQ(diff("scene.toml", "f_%03d.png").code, 0);
  refuses(diff("scene.toml", "ref.mp4", "--still 0.5"), "--still");
  refuses(diff("ref.png", "ref.png", "--still 0.5"), "neither side is a scene");
  refuses(diff("nowhere.toml", "ref.png"), "file does not exist");
}

// what cannot be drawn was not found different
TEST_F(Diff, ASceneThatFailsIsNotComparable) {
  picture("a.png", flat(100));
  write_text(
      folder_ / "edge.toml",
      "format = 1\n[body]\nsolid = { kind = \"cylinder\", radius_cm = 2, height_cm = 6, mass_g "
      "= 100 }\n[motion]\nhold = \"table\"\nduration = 1\nfriction = { kind = \"coulomb\", mu "
      "= 0.3 }\nattitude = { zxz_deg = [0, 40, 0] }\nspin = { rates = [30, 0, -40] }\n");
  refuses(diff("edge.toml", "a.png"), "comes down on the table");
}

TEST_F(Diff, WhatCannotBeComparedIsSaidInOneLine) {
  picture("a.png", flat(100));
  picture("wide.png", flat(100, 65, 48));
  write_text(folder_ / "text.png", "not a picture");
  write_text(folder_ / "notes.txt", "text");
  const std::string bytes = test::read_text(folder_ / "a.png");
  write_text(folder_ / "cut.png", bytes.substr(0, bytes.size() / 2));
  std::filesystem::create_directory(folder_ / "empty");
  refuses(diff("a.png", "wide.png"), "is 64x48 pixels");
  refuses(diff("a.png", "missing.png"), "missing.png: the file does not exist");
  refuses(diff("a.png", "text.png"), "not a PNG");
  refuses(diff("a.png", "cut.png"), "cut.png");
  refuses(diff("a.png", "notes.txt"), "is not a picture");
  refuses(diff("a.png", "empty"), "no .png files");
  refuses(diff("a.png", "a.png", "--max 300"), "--max");
  refuses(diff("a.png", "a.png", "--fraction -1"), "--fraction");
  refuses(diff("a.png", "a.png", "--ssim x"), "--ssim");
  film("a.mp4", {50, 60, 70});
  refuses(diff("a.mp4", "a.png"), "a.png: has 1 frame, ");
  const std::string film_bytes = test::read_text(folder_ / "a.mp4");
  write_text(folder_ / "cut.mp4", film_bytes.substr(0, film_bytes.size() * 9 / 10));
  refuses(diff("a.mp4", "cut.mp4"), "damaged");
  refuses(run_polhode("diff one"), "");
}

TEST_F(Diff, ThePageIsOneFileWithEverythingEscaped) {
  std::filesystem::create_directory(folder_ / "<b>");
  picture("a.png", flat(100));
  picture("<b>/x.png", flat(100));
  const Ran ran = run_polhode(fmt::format(
      "diff '{}' '{}' --html '{}'", folder_ / "a.png", folder_ / "<b>/x.png", folder_ / "page"));
  EXPECT_EQ(ran.code, 0) << ran.err;
  const std::string page = test::read_text(folder_ / "page/index.html");
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;"), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos) << "no page may need a network";
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "page"), {}), 1);
  // a label in a folder of pictures
  std::filesystem::create_directory(folder_ / "one");
  std::filesystem::create_directory(folder_ / "two");
  for (const std::string& name : {std::string("b<i>.png"), std::string("c.png")}) {
    picture("one/" + name, flat(100));
    picture("two/" + name, flat(200));
  }
  EXPECT_EQ(diff("one", "two", "--html '" + (folder_ / "page") + "'").code, 1);
  const std::string folders = test::read_text(folder_ / "page/index.html");
  EXPECT_EQ(folders.find("<i>."), std::string::npos);
  EXPECT_NE(folders.find("b&lt;i&gt;.png"), std::string::npos);
  EXPECT_NE(folders.find("<svg"), std::string::npos);
}

TEST_F(Diff, FullDisksAndUnwritableFoldersAreTold) {
  picture("a.png", flat(100));
  const std::string a = folder_ / "a.png";
  const Ran full =
      run_polhode(fmt::format("diff '{0}' '{0}' --json", a), "sh -c '\"$@\" >/dev/full' sh");
  EXPECT_EQ(full.code, 3) << full.out << full.err;
  refuses(diff("a.png", "a.png", "--html /proc/nowhere"), "--html");
  write_text(folder_ / "file", "");
  refuses(diff("a.png", "a.png", "--html '" + (folder_ / "file") + "'"), "--html");
}

TEST_F(Diff, ThePageTakesTheNameOfNoPicture) {
  for (const char* name : {"a/x_1.png", "b/x_1.png"}) {
    std::filesystem::create_directories((folder_.path() / name).parent_path());
    picture(name, flat(name[0] == 'a' ? 100 : 200));
  }
  const std::string before = test::read_text(folder_ / "b/x_1.png");
  std::filesystem::create_directory(folder_ / "page");
  std::filesystem::create_symlink("../b/x_1.png", folder_ / "page/index.html");
  const std::string html = "--html '" + (folder_ / "page") + "'";
  refuses(diff("a", "b", html), "would overwrite");
  refuses(diff("a/x_%d.png", "b/x_%d.png", html), "would overwrite");
  EXPECT_EQ(test::read_text(folder_ / "b/x_1.png"), before);
}

TEST_F(Diff, AnInterruptEndsIt) {
  film("a.mp4", std::vector<int>(40'000, 90));
  const std::string a = folder_ / "a.mp4";
  test::Background run({"diff", a, a, "--html", folder_ / "page", "--progress", "json"});
  run.await_progress();
  const Ran ran = run.end(SIGINT);
  EXPECT_EQ(ran.code, 130) << ran.out << ran.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "page/index.html"));
}

}  // namespace
}  // namespace polhode
