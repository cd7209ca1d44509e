// SPDX-License-Identifier: MIT
// Shards, joining, and films that go on after a kill, with the real program.
#include <algorithm>

#include <fmt/format.h>
#include <sys/stat.h>

#include "base/hash.h"
#include "support/background.h"
#include "video/film_reader.h"

namespace polhode {
namespace {

using test::Background;
using test::Ran;
using test::read_text;
using test::run_polhode;
using test::TemporaryFolder;
using test::write_text;

// a line for each decoded frame: time and hash
std::vector<std::string> frames_of(const std::string& file, bool with_times = true) {
  FilmReader reader(file);
  std::vector<std::string> frames;
  Image image;
  for (double time = 0.0; reader.next(image, time);) {
    const std::string hash = content_hash(image.pixels.data(), image.pixels.size());
    frames.push_back(with_times ? fmt::format("{:.6f} {}", time, hash) : hash);
  }
  return frames;
}

std::vector<std::string> times_of(const std::string& file) {
  std::vector<std::string> times = frames_of(file);
  for (std::string& line : times) {
    line = line.substr(0, line.find(' '));
  }
  return times;
}

class Segments : public ::testing::Test {
 protected:
  Segments() {
    write_text(folder_ / "scene.toml",
               std::string(test::kSmallScene) +
                   "[[story]]\nat = 0\ncaption = \"It turns\"\n"
                   "[[story]]\nat = 0.5\nhold = 1.5\ncaption = \"It \\\"stands\\\"; piece {\"\n");
  }
  // folder/NAME in quotes
  std::string at(const std::string& name) const { return fmt::format("'{}'", folder_ / name); }
  Ran render(const std::string& output, const std::string& options = "") const {
    return run_polhode(
        fmt::format("render {} -o {} --size 64x64 {}", at("scene.toml"), at(output), options));
  }
  void make_shards(int of, const std::string& ending, const std::string& options = "") const {
    for (int k = 1; k <= of; ++k) {
      const Ran ran =
          render(fmt::format("p{}{}", k, ending), fmt::format("--shard {}/{} {}", k, of, options));
      ASSERT_EQ(ran.code, 0) << ran.err;
    }
  }
  void expect_one_line(const Ran& ran, int code, const std::string& says) const {
    EXPECT_EQ(ran.code, code) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_NE(ran.err.find(says), std::string::npos) << ran.err;
  }

  TemporaryFolder folder_;
};

struct FilmKind {
  const char* ending;
  const char* options;
};

TEST_F(Segments, JoinToExactlyTheirFrames) {
  for (const FilmKind& way : {FilmKind{".mp4", ""},
                              {".mp4", "--fps 30000/1001 --to 0.3"},
                              {".mp4", "--codec hevc"},
                              {".mp4", "--codec av1"},
                              {".webm", "--transparent"},
                              {".mov", ""}}) {
    SCOPED_TRACE(std::string(way.ending) + way.options);
    const std::string e = way.ending;
    ASSERT_EQ(render("whole" + e, way.options).code, 0);
    make_shards(3, e, way.options);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "p1.vtt"));
    const Ran ran = run_polhode(fmt::format(
        "join {} {} {} -o {}", at("p3" + e), at("p1" + e), at("p2" + e), at("joined" + e)));
    ASSERT_EQ(ran.code, 0) << ran.err;
    std::vector<std::string> pieces;
    for (int k = 1; k <= 3; ++k) {
      const std::vector<std::string> one = frames_of(folder_ / fmt::format("p{}{}", k, e), false);
      pieces.insert(pieces.end(), one.begin(), one.end());
    }
    EXPECT_EQ(frames_of(folder_ / ("joined" + e), false), pieces);
    EXPECT_EQ(times_of(folder_ / ("joined" + e)), times_of(folder_ / ("whole" + e)));
    EXPECT_EQ(read_text(folder_ / "joined.vtt"), read_text(folder_ / "whole.vtt"));
  }
}

// tags and chapters as FFmpeg's own program sees them
TEST_F(Segments, JoinToAFilmWithTheSameHead) {
  if (std::system("ffprobe -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no ffprobe here";
  ASSERT_EQ(render("whole.mp4").code, 0);
  make_shards(2, ".mp4");
  ASSERT_EQ(
      run_polhode(fmt::format("join {} {} -o {}", at("p1.mp4"), at("p2.mp4"), at("j.mp4"))).code,
      0);
  for (const std::string name : {"whole.mp4", "j.mp4"}) {
    const std::string probe = fmt::format(
        "ffprobe -v error -show_entries stream:format=duration,nb_streams:format_tags:"
        "chapter=start,end:chapter_tags {} | grep -v 'bit_rate\\|extradata' >{}",
        at(name),
        at(name + ".txt"));
    ASSERT_EQ(std::system(probe.c_str()), 0);
  }
  const std::string head = read_text(folder_ / "whole.mp4.txt");
  EXPECT_NE(head.find("It \"stands\"; piece {"), std::string::npos) << head;
  EXPECT_EQ(head, read_text(folder_ / "j.mp4.txt"));
}

TEST_F(Segments, OfHashesAndPicturesHaveTheirNumbersInTheWhole) {
  ASSERT_EQ(render("whole.hash").code, 0);
  make_shards(4, ".hash");
  EXPECT_EQ(read_text(folder_ / "p1.hash") + read_text(folder_ / "p2.hash") +
                read_text(folder_ / "p3.hash") + read_text(folder_ / "p4.hash"),
            read_text(folder_ / "whole.hash"));
  ASSERT_EQ(render("f_%d.png", "--shard 2/5").code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "f_5.png"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "f_9.png"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "f_4.png"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "f_10.png"));
}

TEST_F(Segments, ThatDoNotFitAreNamedWithWhatDiffers) {
  make_shards(5, ".mp4");
  const auto join = [&](const std::string& names) {
    std::string line = "join";
    std::istringstream list(names);
    for (std::string name; list >> name;) {
      line += fmt::format(" {}", at(name));
    }
    const Ran ran = run_polhode(fmt::format("{} -o {}", line, at("out.mp4")));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out.mp4")) << names;
    return ran;
  };
  expect_one_line(join("p1.mp4 p3.mp4 p4.mp4"), 2, "shards 2 and 5 of 5 are missing");
  expect_one_line(join("p1.mp4"), 2, "shards 2, 3, 4 and 5 of 5 are missing");
  expect_one_line(join("p1.mp4 p2.mp4 p3.mp4 p4.mp4"), 2, "shard 5 of 5 is missing");
  expect_one_line(join("p1.mp4 p2.mp4 p1.mp4"), 2, "is shard 1, and so is");

  ASSERT_EQ(render("crf.mp4", "--shard 2/5 --crf 30").code, 0);
  expect_one_line(join("p1.mp4 crf.mp4"), 2, "settings differ (crf 18 and 30)");
  ASSERT_EQ(render("from.mp4", "--shard 2/5 --from 0.1").code, 0);
  expect_one_line(join("p1.mp4 from.mp4"), 2, "settings differ (from 0 and 0.1)");
  ASSERT_EQ(render("text.mp4", "--shard 2/5 --no-text").code, 0);
  expect_one_line(join("p1.mp4 text.mp4"), 2, "scenes differ");
  ASSERT_EQ(render("of.mp4", "--shard 2/4").code, 0);
  expect_one_line(join("p1.mp4 of.mp4"), 2, "one is of 5 pieces, the other of 4");

  std::string bytes = read_text(folder_ / "p2.mp4");
  const std::size_t version = bytes.find("{\"polhode\":\"");
  ASSERT_NE(version, std::string::npos);
  write_text(folder_ / "cut.mp4", bytes.substr(0, bytes.size() - 100));
  expect_one_line(join("p1.mp4 cut.mp4"), 2, "is damaged");
  bytes[bytes.size() / 2] ^= 1;
  write_text(folder_ / "bit.mp4", bytes);
  expect_one_line(join("p1.mp4 bit.mp4"), 2, "is damaged");

  ASSERT_EQ(render("whole.mp4").code, 0);
  expect_one_line(join("p1.mp4 whole.mp4"), 2, "is not a piece of a film");
  expect_one_line(join("scene.toml"), 2, "is not a readable film");
  expect_one_line(join("nowhere.mp4"), 2, "the file does not exist");
  expect_one_line(
      run_polhode(fmt::format("join {} -o {}", at("p1.mp4"), at("p1.mp4"))), 2, "would overwrite");
}

TEST_F(Segments, WrongWishesAreOneLine) {
  const struct {
    const char* output;
    const char* options;
    const char* says;
  } cases[] = {{"a.mp4", "--shard 0/3", "K from 1 to N, got 0/3"},
               {"a.mp4", "--shard 4/3", "K from 1 to N, got 4/3"},
               {"a.mp4", "--shard a/b", "must be K/N"},
               {"a.mp4", "--shard 3", "must be K/N"},
               {"a.mp4", "--shard 1/1000", "the film has only 25 frames"},
               {"a.gif", "--shard 1/2", "cannot be made in pieces"},
               {"a.png", "--shard 1/2", "cannot be made in pieces"},
               {"a.gif", "--resume", "cannot be resumed"},
               {"a.hash", "--resume", "cannot be resumed"},
               {"a.mp4", "--resume --shard 1/2", "there are only 1 pieces; make at most"},
               {"a.mp4", "--resume --pieces 26", "--pieces: the film has only 25 frames"},
               {"a.mp4", "--resume --pieces 0", "--pieces: must be from 1"},
               {"a.mp4", "--pieces 2", "--pieces: is the number of pieces of --resume"}};
  for (const auto& one : cases) {
    expect_one_line(render(one.output, one.options), 2, one.says);
  }
  EXPECT_EQ(folder_.entries(), 1);
}

class SegmentsResumed : public Segments {
 protected:
  // four pieces of five seconds
  SegmentsResumed() {
    std::string text = test::kSmallScene;
    text.replace(text.find("duration = 1"), 12, "duration = 20");
    text.replace(text.find("fps = 10"), 8, "fps = 40");
    write_text(folder_ / "scene.toml", text);
  }
  // starts a film and stops it when two pieces are there
  Ran stop_amid(int signal) {
    Background run(
        {"render", folder_ / "scene.toml", "-o", folder_ / "a.mp4", "--size", "64x64", "--resume"});
    EXPECT_TRUE(test::becomes([&] { return std::filesystem::exists(piece(2)); }));
    return run.end(signal);
  }
  std::string piece(int number) const {
    return folder_ / fmt::format(".a.mp4.parts/{:05}.mp4", number);
  }
};

TEST_F(SegmentsResumed, AKilledFilmGoesOnAndIsTheSame) {
  ASSERT_EQ(stop_amid(SIGKILL).code, 128 + SIGKILL);
  EXPECT_TRUE(std::filesystem::exists(piece(1)));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.mp4"));

  // another film does not get its pieces
  expect_one_line(render("a.mp4", "--resume --crf 30"), 2, "settings differ (crf 30 and 18)");
  // a piece that was changed, and one in another's place, are made again
  std::string bytes = read_text(piece(1));
  bytes[bytes.size() / 2] ^= 1;
  std::filesystem::copy_file(piece(2), piece(4), std::filesystem::copy_options::overwrite_existing);
  write_text(piece(1), bytes);

  const Ran ran = render("a.mp4", fmt::format("--resume --report {}", at("a.json")));
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("00001.mp4: is damaged and made again"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("of 4 pieces are already complete"), std::string::npos) << ran.err;
  EXPECT_EQ(folder_.entries(), 3) << "the folder of pieces is gone";
  ASSERT_EQ(render("b.mp4", "--resume").code, 0);
  EXPECT_EQ(frames_of(folder_ / "a.mp4"), frames_of(folder_ / "b.mp4"));
  EXPECT_EQ(frames_of(folder_ / "a.mp4").size(), 800u);
  // the report knows the hashes of pieces that an earlier run made
  ASSERT_EQ(render("b.hash").code, 0);
  const std::string report = read_text(folder_ / "a.json");
  std::istringstream lines(read_text(folder_ / "b.hash"));
  std::size_t found = 0;
  for (std::string line; std::getline(lines, line);) {
    found += report.find(line.substr(line.rfind(' ') + 1)) != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(found, 800u);
}

// a pipe in a piece's place is not waited for, and what is not the program's is not removed
TEST_F(SegmentsResumed, OtherFilesAmongThePiecesStay) {
  const std::string notes = folder_ / ".a.mp4.parts/notes.txt";
  std::filesystem::create_directories(folder_ / ".a.mp4.parts/more");
  write_text(notes, "mine");
  ASSERT_EQ(mkfifo(piece(3).c_str(), 0600), 0);
  expect_one_line(render("a.mp4", "--resume -q"), 2, "00003.mp4: is no piece of a film");
  std::filesystem::remove(piece(3));
  ASSERT_EQ(render("a.mp4", "--resume -q").code, 0);
  EXPECT_FALSE(std::filesystem::exists(piece(1)));
  EXPECT_EQ(read_text(notes), "mine");
  EXPECT_TRUE(std::filesystem::exists(folder_ / ".a.mp4.parts/more"));
  expect_one_line(render("b.mp4", fmt::format("--resume --report {}", at(".b.mp4.parts"))),
                  2,
                  "--report would overwrite");
}

TEST_F(SegmentsResumed, AFileInThePlaceOfTheirFolderStays) {
  write_text(folder_ / ".a.mp4.parts", "mine");
  expect_one_line(render("a.mp4", "--resume -q"), 2, "a.mp4.parts': there is a file of that name");
  EXPECT_EQ(read_text(folder_ / ".a.mp4.parts"), "mine");
}

TEST_F(SegmentsResumed, AnInterruptKeepsPiecesAndSaysHowToGoOn) {
  expect_one_line(stop_amid(SIGINT), 130, "pieces; the same command goes on from there");
  EXPECT_TRUE(std::filesystem::exists(piece(1)));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.mp4.part"));
}

}  // namespace
}  // namespace polhode
