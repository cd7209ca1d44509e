// SPDX-License-Identifier: MIT
// verify, preview and progress, with the real program.
#include <algorithm>

#include <fmt/format.h>

#include "base/json.h"
#include "image/png.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::Ran;
using test::read_text;
using test::run_polhode;
using test::TemporaryFolder;
using test::write_text;
class Verify : public ::testing::Test {
 protected:
  Verify() {
    write_text(folder_ / "scene.toml",
               std::string(test::kSmallScene) +
                   "[[story]]\nat = 0\ncaption = \"It turns\"\n"
                   "[[story]]\nat = 0.5\nhold = 0.5\ncaption = \"It stands\"\n");
  }
  std::string at(const std::string& name) const { return fmt::format("'{}'", folder_ / name); }
  void render(const std::string& output, const std::string& options = "") const {
    const Ran ran = run_polhode(fmt::format(
        "render {} -o {} --report {} {}", at("scene.toml"), at(output), at("r.json"), options));
    ASSERT_EQ(ran.code, 0) << ran.err;
  }
  Ran verify(const std::string& output) const {
    return run_polhode(fmt::format("verify {} --report {}", at(output), at("r.json")));
  }
  void expect(const std::string& output, int code, const std::string& says) const {
    const Ran ran = verify(output);
    const std::string words = ran.out + ran.err;
    EXPECT_EQ(ran.code, code) << words;
    EXPECT_EQ(std::count(words.begin(), words.end(), '\n'), 1) << words;
    EXPECT_NE(words.find(says), std::string::npos) << words;
  }

  // the report becomes that one, changed
  template <class Change>
  void write_changed(Json report, const Change& change) const {
    change(report);
    write_text(folder_ / "r.json", report.dump());
  }

  TemporaryFolder folder_;
};

TEST_F(Verify, WhatWasMadeIsTheSame) {
  const struct {
    const char* output;
    const char* options;
    const char* says;
  } cases[] = {{"a.mp4", "", "all 15 frames are the same"},
               {"a.mp4", "--no-text --quality draft", "all 15"},
               {"a.mp4", "--resume --jobs 2", "all 15"},
               {"p.mp4", "--resume --pieces 3", "all 15"},
               {"a.mp4", "--shard 2/3", "all 5"},
               {"a.webm", "--transparent", "all 15"},
               {"a.mov", "--from 0.3 --to 0.6", "all 8"},
               {"a.apng", "", "all 15"},
               {"a.y4m", "", "all 15"},
               {"f_%d.png", "", "all 15"},
               {"a.png", "--still 0.5", "the frame is the same"},
               {"a.hash", "", "all 15"}};
  for (const auto& one : cases) {
    SCOPED_TRACE(std::string(one.output) + one.options);
    render(one.output, one.options);
    expect(one.output, 0, one.says);
  }
}

TEST_F(Verify, TheReportStandsBesideByDefault) {
  const std::string line =
      fmt::format("render {} -o {} --report {}", at("scene.toml"), at("a.mp4"), at("a.json"));
  ASSERT_EQ(run_polhode(line).code, 0);
  EXPECT_EQ(run_polhode(fmt::format("verify {}", at("a.mp4"))).code, 0);
}

TEST_F(Verify, AFilmThatWasTamperedWithIsFound) {
  render("a.mp4");
  const std::string film = read_text(folder_ / "a.mp4");
  // another film under its name: brighter, shorter, longer
  const struct {
    const char* options;
    const char* says;
  } others[] = {{"--crf 40", "frame 0 (0.000 s) differs"},
                {"--to 0.4", "a.mp4: frame "},
                {"--fps 20", "a.mp4: frame "}};
  for (const auto& other : others) {
    const std::string line =
        fmt::format("render {} -o {} {}", at("scene.toml"), at("a.mp4"), other.options);
    ASSERT_EQ(run_polhode(line).code, 0);
    expect("a.mp4", 1, other.says);
  }
  write_text(folder_ / "a.mp4", film.substr(0, film.size() * 2 / 3));
  expect("a.mp4", 1, "is damaged");
  write_text(folder_ / "a.mp4", "writes no file");
  expect("a.mp4", 1, "is not a readable film");
  write_text(folder_ / "a.mp4", film);
  write_text(folder_ / "a.vtt", "WEBVTT\n");
  expect("a.mp4", 1, "its captions, ");
  std::filesystem::remove(folder_ / "a.vtt");
  expect("a.mp4", 1, "are missing");
}

TEST_F(Verify, RawFramesAreComparedOneByOne) {
  render("a.y4m");
  const std::string film = read_text(folder_ / "a.y4m");
  const std::size_t frame = (film.size() - film.find('\n') - 1) / 15;
  std::string changed = film;
  changed[film.size() - 8 * frame + 100] ^= 1;
  write_text(folder_ / "a.y4m", changed);
  expect("a.y4m", 1, "a.y4m: frame 7 (0.700 s) differs");
  write_text(folder_ / "a.y4m", film.substr(0, film.size() - frame - 10));
  expect("a.y4m", 1, "frame 13 (1.300 s) is missing");
  write_text(folder_ / "a.y4m", film + film.substr(film.size() - frame));
  expect("a.y4m", 1, "frame 15 (1.500 s) is one too many");
  write_text(folder_ / "a.y4m", "");
  expect("a.y4m", 1, "its first line differs");
}

TEST_F(Verify, OnePixelIsEnough) {
  render("f_%d.png");
  Image image = read_png(folder_ / "f_7.png");
  image.at(3, 4)[1] ^= 1;
  write_png(folder_ / "f_7.png", image, false);
  expect("f_%d.png", 1, "frame 7 (0.700 s) differs");
  std::filesystem::copy_file(folder_ / "f_3.png", folder_ / "f_15.png");
  render("f_%d.png");
  expect("f_%d.png", 1, "frame 15 (1.500 s) is one too many");
  std::filesystem::remove(folder_ / "f_5.png");
  expect("f_%d.png", 1, "frame 5 (0.500 s)");
  render("a.hash");
  std::string list = read_text(folder_ / "a.hash");
  list[list.find("\n3 ") + 12] ^= 1;
  write_text(folder_ / "a.hash", list);
  expect("a.hash", 1, "frame 3 (0.300 s) differs");
}

// a shorter sequence leaves the pictures of a longer one, which is told
TEST_F(Verify, PicturesBehindASequenceAreTold) {
  render("f_%d.png");
  const Ran shorter =
      run_polhode(fmt::format("render {} -o {} --to 0.5 -q", at("scene.toml"), at("f_%d.png")));
  EXPECT_EQ(shorter.code, 0);
  EXPECT_NE(shorter.err.find("are pictures of an earlier film"), std::string::npos) << shorter.err;
  render("g_%d.png");
  EXPECT_EQ(run_polhode(fmt::format("render {} -o {} -q", at("scene.toml"), at("g_%d.png"))).err,
            "");
}

// shards of numbered pictures lie beside each other
TEST_F(Verify, ShardsOfASequenceStandTogether) {
  const auto make = [&](int shard, const std::string& options) {
    return run_polhode(fmt::format("render {} -o {} --shard {}/3 --report {} -q {}",
                                   at("scene.toml"),
                                   at("s_%d.png"),
                                   shard,
                                   at(fmt::format("s{}.json", shard)),
                                   options));
  };
  const auto verdict = [&](int shard) {
    return run_polhode(
        fmt::format("verify {} --report {}", at("s_%d.png"), at(fmt::format("s{}.json", shard))));
  };
  for (int shard : {1, 2, 3})
    EXPECT_EQ(make(shard, "").err, "");
  for (int shard : {1, 2, 3}) {
    const Ran ran = verdict(shard);
    EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
  }

  // but what lies behind the whole film is one too many, and the last shard tells of it
  for (int shard : {1, 2, 3})
    EXPECT_EQ(make(shard, "--to 0.9").err.find("of an earlier film") != std::string::npos,
              shard == 3);
  const Ran longer = verdict(3);
  EXPECT_EQ(longer.code, 1);
  EXPECT_NE((longer.out + longer.err).find("frame 14 (1.400 s) is one too many"), std::string::npos)
      << longer.out << longer.err;
}

// a GIF keeps every other frame of a film of 60 a second
TEST_F(Verify, CountsTheFramesThatAGifHas) {
  write_text(folder_ / "scene.toml",
             "format = 1\n[body]\nmoments = [1, 2, 2.5]\n[motion]\nduration = 0.15\n"
             "spin = { body = [1, 8, 2] }\n[video]\nsize = \"64x36\"\nfps = 60\n");
  render("a.gif");
  const Ran ran = verify("a.gif");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("all 5 frames are the same"), std::string::npos) << ran.out;
  // its last delay, in hundredths of a second, stands before its last picture
  std::string bytes = read_text(folder_ / "a.gif");
  bytes[bytes.rfind("\x21\xF9\x04") + 5] = 3;
  write_text(folder_ / "a.gif", bytes);
  const Ran longer = verify("a.gif");
  EXPECT_EQ(longer.code, 1);
  EXPECT_NE((longer.out + longer.err).find("the film ends at"), std::string::npos) << longer.out;
}

// the same pixels, with other colours on a screen
TEST_F(Verify, TagsOfColoursAreCompared) {
  render("a.mp4");
  std::string bytes = read_text(folder_ / "a.mp4");
  const std::size_t transfer = bytes.find("nclx") + 7;
  ASSERT_EQ(bytes[transfer], 1) << "BT.709";
  bytes[transfer] = 16;
  write_text(folder_ / "a.mp4", bytes);
  expect("a.mp4", 1, "its frames are shown as '");
  render("a.png", "--still 0");
  bytes = read_text(folder_ / "a.png");
  constexpr std::size_t kBehindHeader = 33;
  bytes.insert(kBehindHeader, std::string("\0\0\0\4gAMA\0\1\x86\xA0\x31\xE8\x96\x5F", 16));
  write_text(folder_ / "a.png", bytes);
  expect("a.png", 1, "frame 0 (0.000 s) is shown otherwise: it has other tags");
  render("a.apng");
  bytes = read_text(folder_ / "a.apng");
  bytes.insert(kBehindHeader, std::string("\0\0\0\4gAMA\0\1\x86\xA0\x31\xE8\x96\x5F", 16));
  write_text(folder_ / "a.apng", bytes);
  expect("a.apng", 1, "it has other tags");
}

// a WebM says how long it is
TEST_F(Verify, TheLengthOfAWebmIsCompared) {
  render("a.webm");
  std::string bytes = read_text(folder_ / "a.webm");
  const std::size_t length = bytes.find("\x44\x89\x88");
  ASSERT_NE(length, std::string::npos);
  bytes[length + 4] ^= 1;  // of the high bytes of a double
  write_text(folder_ / "a.webm", bytes);
  expect("a.webm", 1, " s long, and not ");
}

TEST_F(Verify, AReportThatWasTamperedWithIsFound) {
  render("a.mp4");
  const Json report = Json::parse(read_text(folder_ / "r.json"));
  const auto with = [&](const auto& change) {
    write_changed(report, change);
  };
  with([](Json& r) { r["frame_hashes"][7] = std::string(32, '0'); });
  expect("a.mp4", 1, "frame 7 (0.700 s) is not what the report says");
  with([](Json& r) { r["frame_hashes"].erase(0); });
  expect("a.mp4", 1, "was altered: it has 14 hashes of 15 frames");
  with([](Json& r) { r["scene"]["motion"]["duration"] = 0.9; });
  expect("a.mp4", 1, "was altered: its scene");
  for (const char* key : {"width", "samples", "first_frame"}) {
    with([&](Json& r) { r[key] = 7; });
    expect("a.mp4", 1, fmt::format("was altered: {} is {}, and not 7", key, report[key].dump()));
  }
  with([](Json& r) { r["width"] = r["width"].get<int>() + 1; });
  expect("a.mp4", 1, "was altered: width is ");
  with([](Json& r) { r["captions"][1] = "It falls"; });
  expect("a.mp4", 1, "was altered: captions[1] is not that of its scene");
  with([](Json& r) { r["still"] = true; });
  expect("a.mp4", 1, "was altered: one picture (--still) is written as .png");
  with([](Json& r) { r["trusted"] = !r["trusted"]; });
  expect("a.mp4", 1, "was altered: trusted is ");
  with([](Json& r) { r["doubts"].push_back("bad"); });
  expect("a.mp4", 1, "was altered: doubts is []");
  with([](Json& r) { r["verdict"] = "exact"; });
  expect("a.mp4", 1, "was altered: verdict is nothing that it tells");
  with([](Json& r) { r["stages"]["draw"]["gpu_s"] = 1; });
  expect("a.mp4", 1, "was altered: stages.draw.gpu_s is nothing");
  write_text(folder_ / "r.json", "{\"trusted\": false, " + report.dump().substr(1));
  expect("a.mp4", 2, "is not a report");
  with([](Json& r) { r["accuracy_rad"] = 1.0; });
  expect("a.mp4", 1, "was altered: accuracy_rad is ");
  with([](Json& r) { r.erase("edges"); });
  expect("a.mp4", 2, "is not a report");
  // nothing to compare with
  with([](Json& r) { r["versions"].erase("ffmpeg"); });
  expect("a.mp4", 2, "does not say with which ffmpeg");
  with([](Json& r) { r["versions"]["polhode"] = "0.0.1"; });
  expect("a.mp4", 2, "made with polhode \"0.0.1\"");
  with([](Json& r) { r["gl_renderer"] = "another"; });
  expect("a.mp4", 2, "was drawn by another");
  with([](Json& r) { r["encoder"]["crf"] = 99; });
  expect("a.mp4", 2, "--crf");
  with([](Json& r) { r["encoder"]["threads"] = 0; });
  expect("a.mp4", 2, "encoder.threads");
  for (const char* other : {"null", "x", ""}) {
    with([&](Json& r) { r["output"] = other; });
    expect("a.mp4", 2, "is the report of ");
  }
  with([](Json& r) { r.erase("scene"); });
  expect("a.mp4", 2, "is not a report");
  write_text(folder_ / "r.json", "[");
  expect("a.mp4", 2, "is not a report");
  std::filesystem::remove(folder_ / "r.json");
  expect("a.mp4", 2, "file does not exist");
  expect("b.mp4", 2, "the file does not exist");
  EXPECT_EQ(run_polhode("verify -").code, 2);
  EXPECT_EQ(run_polhode("verify null").code, 2);
}

// the rows of a comparison say whom to trust
TEST_F(Verify, AComparisonThatWasTamperedWithIsFound) {
  write_text(folder_ / "scene.toml",
             "format = 1\n[body]\nmoments = [1, 2, 2.5]\n[motion]\nduration = 0.4\n"
             "spin = { body = [1, 8, 2] }\n[numerics]\nstep = 0.02\n"
             "compare = [\"rk4\", \"explicit_euler\"]\n[video]\nsize = \"192x108\"\nfps = 5\n");
  render("a.mp4");
  const Json report = Json::parse(read_text(folder_ / "r.json"));
  const auto with = [&](const auto& change) {
    write_changed(report, change);
  };
  expect("a.mp4", 0, "all 2");
  with([](Json& r) { r["compare"][1]["trusted"] = true; });
  expect("a.mp4", 1, "was altered: compare[1].trusted is false, and not true");
  with([](Json& r) { r["compare"][0]["method"] = "rk5"; });
  expect("a.mp4", 1, "was altered: compare[0].method is ");
  with([](Json& r) { r["compare"][0]["steps"] = 21; });
  expect("a.mp4", 1, "was altered: compare[0].steps is 20, and not 21");
  with([](Json& r) { r["compare"][0]["step_s"] = 0.0201; });
  expect("a.mp4", 1, "was altered: compare[0].step_s is 0.02, and not 0.0201");
  with([](Json& r) { r["compare"].erase(1); });
  expect("a.mp4", 1, "was altered: compare is ");
  with([](Json& r) { r["compare"][1]["doubts"][0] = "nothing at all"; });
  expect("a.mp4", 1, "was altered: compare[1].doubts[0] is ");
  with([](Json& r) {
    std::string words = r["compare"][1]["doubts"][0];
    const std::size_t digit = words.find_first_of("123456789");
    words[digit] = words[digit] == '9' ? '1' : '9';
    r["compare"][1]["doubts"][0] = words;
  });
  expect("a.mp4", 1, "was altered: compare[1].doubts[0] is ");
  with([](Json& r) { r["energy_drift"] = 0.5; });
  expect("a.mp4", 1, "was altered: energy_drift is ");
  with([](Json& r) { r["conditioning"]["exceeds_accuracy"] = true; });
  expect("a.mp4", 1, "was altered: conditioning.exceeds_accuracy is ");
}

// the panels of a film of several scenes share what stands at the top of its report
TEST_F(Verify, AFilmOfScenesThatWasTamperedWithIsFound) {
  write_text(folder_ / "one.toml", test::kSmallScene);
  write_text(folder_ / "scene.toml",
             "format = 1\n[sweep]\nscene = \"one.toml\"\nkey = \"body.solid.mass\"\n"
             "values = [1, 2]\n[motion]\nduration = 0.2\n");
  render("a.mp4");
  const Json report = Json::parse(read_text(folder_ / "r.json"));
  const auto with = [&](const auto& change) {
    write_changed(report, change);
  };
  expect("a.mp4", 0, "all 2");
  with([](Json& r) { r["scene"]["body"]["solid"]["mass"] = 1.000001; });
  expect("a.mp4", 1, "was altered: its scene");
  with([](Json& r) { r["film"]["panels"][1]["scene"]["body"]["solid"]["mass"] = 2.000001; });
  expect("a.mp4", 1, "was altered: its scene");
}

// a method that blows up drifts without end, which JSON cannot write
TEST_F(Verify, AComparisonMayDriftWithoutEnd) {
  write_text(folder_ / "scene.toml",
             "format = 1\n[body]\nsolid = { kind = \"box\", size_cm = [10, 20, 30], mass = 1 }\n"
             "[motion]\nhold = \"pivot\"\nduration = 5\nattitude = { zxz_deg = [0, 30, 0] }\n"
             "spin = { rates = [44, 0, 92] }\n"
             "[numerics]\ncompare = [\"explicit_euler\", \"exact\"]\nstep = 0.05\naccuracy = 0.1\n"
             "[video]\nsize = \"192x108\"\nfps = 60\n");
  render("a.mp4", "--to 0.5");
  EXPECT_NE(read_text(folder_ / "r.json").find("\"energy_drift\": null"), std::string::npos);
  expect("a.mp4", 0, "all ");
  const Json report = Json::parse(read_text(folder_ / "r.json"));
  for (const double finite : {0.0, 1e300}) {
    Json changed = report;
    changed["compare"][0]["energy_drift"] = finite;
    write_text(folder_ / "r.json", changed.dump());
    expect("a.mp4", 1, "was altered: compare[0].energy_drift is null, and not ");
  }
}

TEST_F(Verify, APreviewIsASheetOfTwelve) {
  const Ran ran = run_polhode(fmt::format("preview {} -o {}", at("scene.toml"), at("sheet.png")));
  ASSERT_EQ(ran.code, 0) << ran.err;
  const Image sheet = read_png(folder_ / "sheet.png");
  EXPECT_EQ(sheet.width, 4 * 480 + 5 * 16);
  EXPECT_EQ(run_polhode(fmt::format("preview {} -o {}", at("scene.toml"), at("a.mp4"))).code, 2);
  EXPECT_EQ(folder_.entries(), 2);
}

TEST_F(Verify, ProgressIsJsonLineByLine) {
  const Ran ran =
      run_polhode(fmt::format("render {} -o {} --progress json", at("scene.toml"), at("a.mp4")));
  ASSERT_EQ(ran.code, 0);
  std::istringstream lines(ran.err);
  Json last;
  for (std::string line; std::getline(lines, line);) {
    last = Json::parse(line);
    if (last.contains("output")) break;    // the closing line
    if (last.contains("doing")) continue;  // on a slow machine
    EXPECT_TRUE(last["limit"] == "drawing" || last["limit"] == "encoding") << line;
    const double rate = last["frames_per_s"], left = last["seconds_left"];  // to 0.01 and 0.1
    const int done = last["done"];
    EXPECT_EQ(rate > 0.0, done > 0) << line;
    if (done > 0) {
      EXPECT_NEAR(left, (15 - done) / rate, 0.06 + 0.01 * left) << line;
    }
  }
  EXPECT_EQ(last["done"], 15);
  EXPECT_EQ(last["total"], 15);
  const Ran bar =
      run_polhode(fmt::format("render {} -o {} --progress bar", at("scene.toml"), at("f_%d.png")));
  EXPECT_NE(bar.err.find("15/15 frames"), std::string::npos) << bar.err;
  EXPECT_NE(bar.err.find(" limits"), std::string::npos) << bar.err;
}

}  // namespace
}  // namespace polhode
