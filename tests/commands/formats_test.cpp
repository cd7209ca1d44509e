// SPDX-License-Identifier: MIT
// The real program in every format: good runs, full disks, closed pipes, signals, encoders that
// will not open. Whatever happens, no broken file stays behind.
#include <algorithm>
#include <array>
#include <climits>
#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <sys/stat.h>

#include "support/background.h"

namespace polhode {
namespace {

using test::Ran;
using test::run_polhode;
using test::TemporaryFolder;
using test::write_text;

struct Way {
  const char* name;     // of the output
  const char* options;  // besides
};
const Way kWays[] = {{"a.mp4", ""},
                     {"a.mp4", "--codec hevc"},
                     {"a.mp4", "--codec av1"},
                     {"a.webm", ""},
                     {"a.webm", "--transparent"},
                     {"a.mov", "--transparent"},
                     {"a.gif", ""},
                     {"a.apng", ""},
                     {"a.y4m", ""},
                     {"f_%03d.png", ""},
                     {"a.hash", ""}};

// with captions, so that there is a .vtt to leave behind
std::string story_scene(const std::string& scene = test::kSmallScene) {
  return scene +
         "[[story]]\nat = 0\ncaption = \"It turns & <turns>\"\n"
         "[[story]]\nat = 0.5\nhold = 1\ncaption = \"It stands\"\n";
}

bool has_captions(const Way& way) {
  const std::string name = way.name;
  return name.ends_with(".mp4") || name.ends_with(".webm") || name.ends_with(".mov");
}

class Formats : public ::testing::Test {
 protected:
  Formats() { write_text(folder_ / "scene.toml", story_scene()); }

  std::string render(const std::string& output, const std::string& options = "") const {
    return "render '" + (folder_ / "scene.toml") + "' -o '" +
           (output == "-" ? output : folder_ / output) + "' " + options;
  }
  // only the scene is there, nothing hidden either
  void expect_nothing_left(const std::string& what) const {
    EXPECT_EQ(folder_.entries(), 1) << what;
  }
  // warnings are lines of their own
  static long errors_in(const std::string& err) {
    long lines = std::count(err.begin(), err.end(), '\n');
    for (std::size_t at = err.find("polhode: warning"); at != std::string::npos;
         at = err.find("polhode: warning", at + 1)) {
      --lines;
    }
    return lines;
  }

  TemporaryFolder folder_;
};

TEST_F(Formats, EachIsMadeWithItsCaptionsBeside) {
  for (const Way& way : kWays) {
    const TemporaryFolder folder;
    write_text(folder / "scene.toml", story_scene());
    const Ran ran = run_polhode("render '" + (folder / "scene.toml") + "' -o '" +
                                (folder / way.name) + "' " + way.options + " --size 64x64");
    EXPECT_EQ(ran.code, 0) << way.name << ran.err;
    EXPECT_EQ(ran.out, "") << way.name;
    EXPECT_EQ(std::filesystem::exists(folder / "a.vtt"), has_captions(way)) << way.name;
    if (has_captions(way)) {
      EXPECT_EQ(test::read_text(folder / "a.vtt"),
                "WEBVTT - captions by polhode\n"
                "\n00:00:00.000 --> 00:00:00.500\nIt turns &amp; &lt;turns&gt;\n"
                "\n00:00:00.500 --> 00:00:02.000\nIt stands\n");
    }
  }
}

TEST_F(Formats, WhatWasChangedIsToldInOneLine) {
  const Ran gif = run_polhode(render("a.gif", "--fps 60 --quiet"));
  EXPECT_EQ(gif.code, 0);
  EXPECT_EQ(std::count(gif.err.begin(), gif.err.end(), '\n'), 1) << gif.err;
  EXPECT_NE(gif.err.find("30 frames/s instead of 60"), std::string::npos) << gif.err;
  const Ran clear = run_polhode(render("a.gif", "--transparent"));
  EXPECT_NE(clear.err.find("either clear or solid"), std::string::npos) << clear.err;
}

// words for the picture are one thing, captions beside it another
TEST_F(Formats, CaptionsStayWhenThePictureHasNoText) {
  EXPECT_EQ(run_polhode(render("a.mp4", "--no-text")).code, 0);
  EXPECT_NE(test::read_text(folder_ / "a.vtt").find("It stands"), std::string::npos);
}

TEST_F(Formats, AFullDiskIsOneLineAndLeavesNothing) {
  for (const Way& way : kWays) {
    // one block of 512 bytes (sh) is less than any of them; stdout and stderr stay below it
    const Ran ran =
        run_polhode(render(way.name, std::string(way.options) + " --size 64x64"), "ulimit -f 1;");
    EXPECT_EQ(ran.code, 3) << way.name << ran.err;
    EXPECT_EQ(errors_in(ran.err), 1) << way.name << ran.err;
    expect_nothing_left(way.name);
  }
}

// a disk of 16 kB, in a name space that ends with the shell; where that may not be made the limit
// of the file's size above has to do
TEST_F(Formats, ASmallFileSystemIsFull) {
  const std::string disk = folder_ / "disk";
  std::filesystem::create_directory(disk);
  const std::string enter = "unshare -m sh -c 'mount -t tmpfs -o size=16k none \"" + disk + "\"";
  if (std::system((enter + "' 2>/dev/null").c_str()) != 0) GTEST_SKIP() << "no right to mount";
  for (const Way& way : kWays) {
    const std::string name = way.name;
    if (name == "a.hash") continue;  // is smaller
    const bool crf = has_captions(way) && !name.ends_with(".mov");
    const std::string run = fmt::format(
        "{} || exit 9; \"{}\" render \"{}\" -o \"{}/{}\" --fps 30 --size 320x180 {} {} "
        "2>\"{}\"; echo $? $(ls -A \"{}\" | wc -l) >\"{}\"'",
        enter,
        POLHODE_BINARY,
        folder_ / "scene.toml",
        disk,
        name,
        way.options,
        crf ? "--crf 1" : "",
        folder_ / "err",
        disk,
        folder_ / "out");
    ASSERT_EQ(std::system(run.c_str()), 0);
    EXPECT_EQ(test::read_text(folder_ / "out"), "3 0\n") << name << way.options;
    const std::string err = test::read_text(folder_ / "err");
    EXPECT_EQ(errors_in(err), 1) << err;
    EXPECT_NE(err.find("No space left"), std::string::npos) << err;
  }
}

TEST_F(Formats, SignalsLeaveNothing) {
  write_text(folder_ / "scene.toml", story_scene(test::long_scene()));
  int turn = 0;
  for (const Way& way : kWays) {
    const int signal = std::array{SIGINT, SIGTERM, SIGHUP}[static_cast<std::size_t>(turn++ % 3)];
    std::vector<std::string> arguments = {
        "render", folder_ / "scene.toml", "-o", folder_ / way.name};
    for (const std::string& word :
         test::words_of(std::string(way.options) + " --size 64x64 --progress json"))
      arguments.push_back(word);
    test::Background run(arguments);
    run.await_progress();
    const Ran ran = run.end(signal);
    EXPECT_EQ(ran.code, 130) << way.name << ran.err;
    EXPECT_EQ(errors_in(ran.err), 1) << way.name << ran.err;
    expect_nothing_left(way.name);
  }
}

TEST_F(Formats, AnEncoderThatWillNotOpenIsOneLine) {
  // its pictures want more memory than there is; x264 then writes a line of its own, x265 crashes
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer itself needs terabytes of addresses";
#endif
  for (const Way& way : {Way{"a.webm", ""}, {"a.webm", "--transparent"}}) {
    const Ran ran = run_polhode(render(way.name, std::string(way.options) + " --size 8192x8192"),
                                "ulimit -v 500000;");
    EXPECT_EQ(ran.code, 3) << way.options << ran.err;
    EXPECT_EQ(errors_in(ran.err), 1) << way.options << ran.err;
    expect_nothing_left(way.name);
  }
}

// captions go beside the film, but not over what somebody else has written
TEST_F(Formats, CaptionsReplaceOnlyTheirOwn) {
  write_text(folder_ / "a.vtt", "my own file\n");
  const Ran ran = run_polhode(render("a.mp4"));
  EXPECT_EQ(ran.code, 2) << ran.err;
  EXPECT_NE(ran.err.find("a.vtt: the captions of the film go there"), std::string::npos) << ran.err;
  EXPECT_EQ(test::read_text(folder_ / "a.vtt"), "my own file\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.mp4"));
  std::filesystem::remove(folder_ / "a.vtt");
  EXPECT_EQ(run_polhode(render("a.mp4")).code, 0);
  EXPECT_EQ(run_polhode(render("a.mp4")).code, 0) << "those of an earlier film are replaced";
}

// an FFmpeg that was built without them
TEST_F(Formats, AMissingEncoderIsNamedWithWhatToInstall) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer wants to be loaded first";
#endif
  const std::string without = "POLHODE_LACKS=encoders LD_PRELOAD='" POLHODE_LACKING "'";
  const struct {
    Way way;
    const char* says;
  } cases[] = {{{"a.mp4", ""}, "lacks libx264; install"},
               {{"a.mp4", "--codec hevc"}, "lacks libx265; install"},
               {{"a.mp4", "--codec av1"}, "lacks libaom-av1 and libsvtav1; install"},
               {{"a.webm", ""}, "lacks libvpx-vp9; install"},
               {{"a.mov", ""}, "lacks prores_ks; install"},
               {{"a.gif", ""}, "lacks gif; install"},
               {{"a.apng", ""}, "lacks apng; install"}};
  for (const auto& [way, says] : cases) {
    const Ran ran = run_polhode(render(way.name, way.options), without);
    EXPECT_EQ(ran.code, 3) << way.name << ran.err;
    EXPECT_EQ(errors_in(ran.err), 1) << ran.err;
    EXPECT_NE(ran.err.find(says), std::string::npos) << ran.err;
    expect_nothing_left(way.name);
  }
  const Ran doctor = run_polhode("doctor", without);
  EXPECT_EQ(doctor.code, 3);
  EXPECT_NE(doctor.out.find("missing: install an FFmpeg that has it"), std::string::npos);
  EXPECT_EQ(run_polhode(render("f_%03d.png"), without).code, 0) << "pictures need none";
}

TEST_F(Formats, StandardOutputCarriesFramesAndNothingElse) {
  const Ran ran = run_polhode(render("-", "--progress json"));
  EXPECT_EQ(ran.code, 0) << ran.err;
  const std::string frame = "FRAME\n";
  const std::size_t header = ran.out.find('\n') + 1;
  EXPECT_TRUE(ran.out.starts_with("YUV4MPEG2 W128 H72 F10:1 ")) << ran.out.substr(0, header);
  EXPECT_NE(ran.out.substr(0, header).find("C420mpeg2"), std::string::npos);
  EXPECT_NE(ran.out.substr(0, header).find("XCOLORRANGE=LIMITED"), std::string::npos);
  EXPECT_EQ(ran.out.size(), header + 20 * (frame.size() + 128UL * 72 * 3 / 2));
  expect_nothing_left("-");

  const Ran fine = run_polhode(render("-", "--quality archive"));
  const std::size_t fine_header = fine.out.find('\n') + 1;
  EXPECT_NE(fine.out.substr(0, fine_header).find("C444"), std::string::npos);
  EXPECT_EQ(fine.out.size(), fine_header + 20 * (frame.size() + 128UL * 72 * 3));
}

TEST_F(Formats, AnotherProgramReadsThePipe) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg here";
  const Ran ran =
      run_polhode(render("-") + "| ffmpeg -v error -i - -f framehash - | grep -c '^0,' #", "");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(run_polhode(render("a.y4m")).code, 0);
  const TemporaryFolder other;
  const std::string count = other / "count";
  const std::string pipe = "'" POLHODE_BINARY "' " + render("-") +
                           " | ffmpeg -v error -i - -f framehash - | grep -c '^0,' >'" + count +
                           "'";
  EXPECT_EQ(std::system(pipe.c_str()), 0);
  EXPECT_EQ(test::read_text(count), "20\n");
}

TEST_F(Formats, AReportCannotShareStandardOutput) {
  const Ran ran = run_polhode(render("-", "--report -"));
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_NE(ran.err.find("--report"), std::string::npos) << ran.err;
}

// the name would go from what the shell writes to what the command writes
TEST_F(Formats, AReportCannotReplaceTheFileOfStandardOutput) {
  const std::string file = folder_ / "both";
  for (const auto& [output, report] :
       {std::pair<std::string, std::string>{"-", file}, {"a.mp4", "-"}}) {
    const std::string taken = output == "-" ? file : folder_ / output;
    const Ran ran = run_polhode(render(output, "--report '" + report + "'") + " >'" + taken +
                                "' 2>'" + (folder_ / "err") + "' #");
    EXPECT_EQ(ran.code, 2) << output;
    EXPECT_NE(test::read_text(folder_ / "err").find("/dev/stdout"), std::string::npos) << output;
  }
}

TEST_F(Formats, AReaderWhoGoesEndsTheFilm) {
  const std::string line = "('" POLHODE_BINARY "' " + render("-") + " 2>'" + (folder_ / "err") +
                           "'; echo $? >'" + (folder_ / "code") + "') | head -c 1000 >/dev/null";
  EXPECT_EQ(std::system(line.c_str()), 0);
  EXPECT_EQ(test::read_text(folder_ / "code"), "3\n");
  const std::string err = test::read_text(folder_ / "err");
  EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
  EXPECT_NE(err.find("the program that reads it has ended"), std::string::npos) << err;
}

TEST_F(Formats, AFullOrClosedStandardOutputIsAFailure) {
  for (const std::string closed : {"1>/dev/full", "1>&-"}) {
    const Ran ran = run_polhode(render("-") + closed + " 2>'" + (folder_ / "err") + "' #");
    EXPECT_EQ(ran.code, 3) << closed;
    const std::string err = test::read_text(folder_ / "err");
    EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
  }
}

// a reader who holds the pipe and does not read must not keep the program from ending
TEST_F(Formats, AnInterruptEndsAWriteThatNobodyReads) {
  const std::string pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  test::Background run({"render", folder_ / "scene.toml", "-o", "-", "--size", "640x360"}, pipe);
  // until nothing more goes into the pipe
  EXPECT_TRUE(test::becomes([&] {
    int waiting = 0;
    return ioctl(reader, FIONREAD, &waiting) == 0 &&
           waiting > fcntl(reader, F_GETPIPE_SZ) - PIPE_BUF;
  }));
  const Ran ran = run.end(SIGINT);
  close(reader);
  EXPECT_EQ(ran.code, 130);
  EXPECT_EQ(ran.err, "polhode: interrupted\n");
}

struct BadFormat {
  const char* output;
  const char* options;
  const char* says;
};
const BadFormat kBadFormats[] = {
    {"a.webp", "", "did you mean '.webm'?"},
    {"a.mp4",
     "--transparent",
     "mp4 has no alpha channel; for a transparent picture use webm, mov, gif"},
    {"a.mp4", "--codec hevc --transparent", "no alpha channel"},
    {"a.y4m", "--transparent", "no alpha channel"},
    {"-", "--transparent", "no alpha channel"},
    {"a.mp4", "--codec h265", "--codec: .mp4 films take no codec 'h265'"},
    {"a.webm", "--codec av1", "--codec: .webm films take no codec 'av1'"},
    {"a.mp4", "--codec ''", "--codec: must not be empty"},
    {"a.gif", "--crf 20", "--crf: this format has none"},
    {"a.mov", "--preset slow", "--preset: this format has none"},
    {"a.webm", "--crf 64", "--crf: must be 1 (best) to 63 for VP9, got 64"},
    {"a.mp4", "--codec hevc --crf 52", "to 51 for HEVC, got 52"},
    {"a.webm", "--size 127x72", "VP9 needs even sides: use 128x72"},
    {"a.mp4", "--codec av1 --size 128x71", "use 128x72"},
    {"a.y4m", "--size 127x71", "use 128x72"},
    {"a.gif", "--still 0.5", "--still: makes one picture"},
    {"-", "--still 0.5", "--still: makes one picture"},
    {".webm", "", "the ending needs a name before it"},
    {"a%03d.gif", "", "a film is a single file"},
    {"a.mp4", "--report DIR/a.vtt", "would overwrite"},
};

TEST_F(Formats, EachWrongWishIsOneLine) {
  for (const BadFormat& bad : kBadFormats) {
    SCOPED_TRACE(std::string(bad.output) + " " + bad.options);
    std::string options = bad.options;
    if (const std::size_t at = options.find("DIR"); at != std::string::npos) {
      options.replace(at, 3, folder_.path().string());
    }
    const Ran ran = run_polhode(render(bad.output, options));
    EXPECT_EQ(ran.code, 2) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_NE(ran.err.find(bad.says), std::string::npos) << ran.err;
    EXPECT_EQ(ran.out, "");
    expect_nothing_left(bad.output);
  }
}

}  // namespace
}  // namespace polhode
