// SPDX-License-Identifier: MIT
// Work that several runs do together (--shard K/N), and what `submit` says without Slurm.
#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/background.h"

namespace polhode {
namespace {

using test::Ran;
using test::read_text;
using test::run_polhode;
using test::TemporaryFolder;
using test::write_text;

constexpr const char* kBrick =
    "format = 1\n[body]\n"
    "solid = { kind = \"box\", size_cm = [24, 11.5, 7], mass = 3 }\n"
    "pivot_cm = [12, 5.75, 3.5]\n"
    "[motion]\nhold = \"pivot\"\nduration = 1\n"
    "attitude = { zxz_deg = [20, 100, 30] }\nspin = { body = [6, 12, -4] }\n";

class Parts : public ::testing::Test {
 protected:
  Parts() { write_text(folder_ / "scene.toml", kBrick); }
  std::string at(const std::string& name) const { return fmt::format("'{}'", folder_ / name); }
  Ran run(const std::string& command, const std::string& out, const std::string& options) const {
    return run_polhode(fmt::format("{} {} -o {} {}", command, at("scene.toml"), at(out), options));
  }
  // the same made whole and in parts, in any order
  void make_both(const std::string& command, const std::string& options, int of) const {
    const Ran whole = run(command, "whole", options);
    ASSERT_EQ(whole.code, 0) << whole.err;
    for (int k = of; k >= 1; --k) {
      const Ran part = run(command, "parts", fmt::format("{} --shard {}/{}", options, k, of));
      ASSERT_EQ(part.code, 0) << part.err;
      EXPECT_TRUE(part.out.starts_with(fmt::format("part {}/{}: ", k, of))) << part.out;
    }
    const Ran collected = run(command, "parts", options);
    ASSERT_EQ(collected.code, 0) << collected.err;
    EXPECT_EQ(collected.out, whole.out);
  }
  void expect_same(const std::string& file) const {
    EXPECT_TRUE(read_text(folder_ / ("whole/" + file)) == read_text(folder_ / ("parts/" + file)))
        << file;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "parts"))
      EXPECT_EQ(entry.path().string().find(".resume"), std::string::npos) << entry.path();
  }

  TemporaryFolder folder_;
};

TEST_F(Parts, OfMapsMakeTheSameTable) {
  make_both("stability", "--methods rk4,gauss6 --cells 5x7 --turns 5", 3);
  expect_same("stability.csv");
}

TEST_F(Parts, OfMapsOverTwoKeysMakeTheSameTable) {
  make_both("stability",
            "--methods rk4,rk2 --cells 4x5 --turns 3 --x motion.spin.body[2] --y body.solid.mass",
            2);
  expect_same("stability.csv");
}

TEST_F(Parts, OfSectionsMakeTheSameTable) {
  make_both("section", "--starts 6 --crossings 15", 3);
  expect_same("section.csv");
  make_both(
      "section", "--x motion.spin.body[1] --y motion.spin.body[0] --cells 3x4 --crossings 10", 4);
  expect_same("section_map.csv");
}

// the points, but for the times and for how far fast machines go
TEST_F(Parts, OfChartsMakeTheSamePoints) {
  for (int k = 1; k <= 2; ++k) {
    const Ran part = run("chart", "parts", fmt::format("--methods rk4,gauss6 --shard {}/2", k));
    ASSERT_EQ(part.code, 0) << part.err;
  }
  const std::string folder = folder_ / "parts";
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 2);
  const Ran collected = run("chart", "parts", "--methods rk4,gauss6 --progress json");
  ASSERT_EQ(collected.code, 0) << collected.err;
  // nothing was left to be measured; drawing may take its time
  EXPECT_TRUE(collected.err.empty() || collected.err == "{\"doing\":\"drawing the pictures\"}\n")
      << collected.err;
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 4);
  const std::string table = read_text(folder + "/chart.csv");
  EXPECT_NE(table.find("\nscene,rk4,"), std::string::npos);
  EXPECT_NE(table.find("\nscene,gauss6,"), std::string::npos);
}

TEST_F(Parts, OfFilmsMakeTheSameFilm) {
  const std::string options = "--resume --pieces 5 --size 96x54 --fps 12";
  ASSERT_EQ(run("render", "whole.mp4", options).code, 0);
  for (const char* shard : {"2/3", "1/3", "3/3"}) {
    const Ran part = run("render", "film.mp4", fmt::format("{} --shard {}", options, shard));
    ASSERT_EQ(part.code, 0) << part.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "film.mp4"));
  }
  const Ran joined = run("render", "film.mp4", options);
  ASSERT_EQ(joined.code, 0) << joined.err;
  EXPECT_NE(joined.err.find("5 of 5 pieces are already complete"), std::string::npos) << joined.err;
  EXPECT_TRUE(read_text(folder_ / "whole.mp4") == read_text(folder_ / "film.mp4"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / ".film.mp4.parts"));
}

TEST_F(Parts, OfLecturesAreUsedByTheWhole) {
  write_text(folder_ / "deck.md",
             "# T\n\n![a](scene.toml){.still size=96x54}\n\n![b](scene.toml){.inspect}\n");
  const auto lecture = [&](const std::string& out, const std::string& options) {
    return run_polhode(
        fmt::format("lecture {} -o {} --to html {}", at("deck.md"), at(out), options));
  };
  ASSERT_EQ(lecture("whole", "").code, 0);
  for (int k = 1; k <= 2; ++k)
    ASSERT_EQ(lecture("parts", fmt::format("--shard {}/2", k)).code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "parts/index.html"));
  const Ran ran = lecture("parts", "");
  EXPECT_NE(ran.out.find("2 pictures, 0 made now"), std::string::npos) << ran.out << ran.err;
  expect_same("index.html");
}

TEST_F(Parts, MoreThanPiecesAreRefused) {
  const std::pair<const char*, const char*> cases[] = {
      {"stability", "--cells 4x4 --methods rk4 --shard 1/5"},
      {"section", "--starts 3 --shard 5/5"},
      {"chart", "--methods rk4 --shard 1/2"}};
  for (const auto& [command, options] : cases) {
    const Ran ran = run(command, "parts", options);
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find("--shard: there are only "), std::string::npos) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "parts")) << command;
  }
}

// what others have made counts, but not what is damaged
TEST_F(Parts, ThatAreDamagedAreMadeAgain) {
  const std::string options = "--methods rk4 --cells 6x6 --turns 5";
  ASSERT_EQ(run("stability", "whole", options).code, 0);
  ASSERT_EQ(run("stability", "parts", options + " --shard 1/2").code, 0);
  ASSERT_EQ(run("stability", "parts", options + " --shard 2/2").code, 0);
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "parts")) {
    std::string text = read_text(entry.path());
    const std::size_t digit = text.find_first_of("123456789", text.size() / 2);
    text[digit] = text[digit] == '1' ? '2' : '1';
    write_text(entry.path(), text);
  }
  ASSERT_EQ(run("stability", "parts", options).code, 0);
  expect_same("stability.csv");
}

class Submit : public Parts {
 protected:
  // A program that runs instead of Slurm's of that name, behind in_bin(); asked for its version, it
  // only answers.
  void write_program(const std::string& name, const std::string& script) const {
    const std::string file = folder_ / ("bin/" + name);
    std::filesystem::create_directories(folder_ / "bin");
    write_text(file,
               "#!/bin/sh\n[ \"$1\" = --version ] && { echo slurm; exit; }\n" + script + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }
  std::string in_bin() const { return "PATH=" + at("bin") + ":$PATH"; }
  std::string map_in_two_tasks() const {
    return fmt::format("submit --tasks 2 stability {} -o {} --cells 4x4 --methods rk4 --turns 3",
                       at("scene.toml"),
                       at("maps"));
  }
};

TEST_F(Submit, ShowsItsScriptsWithoutSlurm) {
  const Ran ran = run_polhode(
      fmt::format("submit --dry-run --partition=long --tasks 3 stability {} -o {} --cells 4x6 "
                  "--methods rk4 --turns 3",
                  at("scene.toml"),
                  at("maps")),
      "PATH=/usr/bin");
  ASSERT_EQ(ran.code, 0) << ran.err;
  for (const char* line : {"#SBATCH --partition=long",
                           "--shard \"$task/3\" --submitted ",
                           "status --finished \"$job\" || fail",
                           "sbatch --parsable --array=1-3 ",
                           "--dependency=afterany:JOB ",
                           "6 rows in 3 tasks of about ",
                           "on    1 node: ",
                           "on    3 nodes:"})
    EXPECT_NE(ran.out.find(line), std::string::npos) << line << "\n" << ran.out;
  EXPECT_EQ(folder_.entries(), 1);
}

// a task has others
TEST_F(Submit, TakesNoFileThatAProcessHasOpen) {
  write_program("sbatch", "echo 12");
  const Ran ran = run_polhode(
      fmt::format("submit stability /dev/fd/7 -o {} --cells 4x4 --methods rk4 --turns 3 7<{}",
                  at("maps"),
                  at("scene.toml")),
      in_bin());
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("/dev/fd/7: is not the same in a task"), std::string::npos) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "maps.job"));
}

TEST_F(Submit, SaysWhatToInstall) {
  std::filesystem::create_directory(folder_ / "bin");
  std::filesystem::create_symlink("/usr/bin/gnuplot", folder_ / "bin/gnuplot");
  const Ran ran = run_polhode(fmt::format("submit stability {} -o {} --cells 4x4 --methods rk4 "
                                          "--turns 3",
                                          at("scene.toml"),
                                          at("maps")),
                              "PATH=" + at("bin"));
  EXPECT_EQ(ran.code, 3);
  EXPECT_NE(ran.err.find("sbatch is not installed"), std::string::npos) << ran.err;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "maps.job"));
}

TEST_F(Submit, LeavesNothingWhereNothingCanBeQueued) {
  write_program("sbatch", "echo 'sbatch: error: no partition of this name' >&2; exit 1");
  const Ran ran = run_polhode(map_in_two_tasks(), in_bin());
  EXPECT_EQ(ran.code, 3);
  EXPECT_NE(ran.err.find("no partition of this name"), std::string::npos) << ran.err;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "maps.job"));
}

// the array was queued, its collection was not, and scancel does not work or is not there
TEST_F(Submit, NamesAJobThatItCannotTakeBack) {
  write_program("sbatch",
                fmt::format("[ -e {0} ] && {{ echo 'sbatch: error: too many jobs' >&2; exit 1; }}\n"
                            "touch {0}; echo 12",
                            at("queued")));
  for (const bool has_scancel : {false, true}) {
    if (has_scancel) write_program("scancel", "exit 1");
    std::filesystem::remove(folder_ / "queued");
    const Ran ran = run_polhode(map_in_two_tasks(), in_bin());
    EXPECT_EQ(ran.code, 3);
    for (const char* words : {"too many jobs", "job 12 is still queued", "scancel 12"})
      EXPECT_NE(ran.err.find(words), std::string::npos) << words << "\n" << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "maps.job"));
  }
}

TEST_F(Submit, LeavesTheScriptsOfOthers) {
  write_program("sbatch", "echo 12");
  std::filesystem::create_directory(folder_ / "maps.job");
  test::write_text(folder_ / "maps.job/tasks.sh", "my own");
  const Ran ran = run_polhode(map_in_two_tasks(), in_bin());
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("tasks.sh: was not written by `polhode submit`"), std::string::npos)
      << ran.err;
  EXPECT_EQ(test::read_text(folder_ / "maps.job/tasks.sh"), "my own");
}

// while Slurm gives no answer, nothing is known to be over: nothing is queued twice, nothing left
TEST_F(Submit, DoesNotTakeSilenceForTheEnd) {
  const std::string submitted = folder_ / "submitted";
  write_program("sbatch", fmt::format("echo x >>{}; echo 12", submitted));
  write_program("scancel", "exit 0");
  write_program("scontrol",
                "echo 'slurm_load_jobs error: Unable to contact slurm controller' >&2; exit 1");
  ASSERT_EQ(run_polhode(map_in_two_tasks(), in_bin()).code, 0);
  for (const std::string& command :
       {map_in_two_tasks(), "status " + at("maps"), "cancel " + at("maps")}) {
    SCOPED_TRACE(command);
    const Ran ran = run_polhode(command, in_bin());
    EXPECT_EQ(ran.code, 3);
    EXPECT_NE(ran.err.find("Unable to contact slurm controller"), std::string::npos) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  }
  EXPECT_EQ(std::filesystem::file_size(submitted), 4u) << "two jobs, once";
  // a job that it does not know any more is over
  write_program("scontrol", "echo 'slurm_load_jobs error: Invalid job id specified' >&2; exit 1");
  EXPECT_EQ(run_polhode("status " + at("maps"), in_bin()).code, 0);
  const Ran over = run_polhode("cancel " + at("maps"), in_bin());
  EXPECT_NE(over.out.find("nothing is queued"), std::string::npos) << over.out << over.err;
}

// of later versions
TEST_F(Submit, TakesUnknownStatesForNoFailures) {
  write_program("sbatch", "echo 12");
  ASSERT_EQ(run_polhode(map_in_two_tasks(), in_bin()).code, 0);
  const auto status = [&](const std::string& state) {
    write_program("scontrol", fmt::format("echo JobId=12 ArrayTaskId=1-2 JobState={}", state));
    return run_polhode("status " + at("maps"), in_bin());
  };
  for (const char* state : {"PENDING", "EXPEDITING", "COMPLETING", "POWER_UP_NODE", "NEW_STATE"})
    EXPECT_EQ(status(state).code, 0) << state;
  for (const char* state : {"TIMEOUT", "REVOKED", "LAUNCH_FAILED"})
    EXPECT_EQ(status(state).code, 1) << state;
}

// a number of a job and nothing else
TEST_F(Submit, TakesNoOddAnswerForAJob) {
  for (const char* answer : {"0", "12; rm", "123456789012345678901234567890", "twelve", ""}) {
    SCOPED_TRACE(answer);
    write_program("sbatch", fmt::format("echo '{}'", answer));
    const Ran ran = run_polhode(map_in_two_tasks(), in_bin());
    EXPECT_EQ(ran.code, 3);
    EXPECT_NE(ran.err.find("instead of the number of a job"), std::string::npos) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "maps.job"));
  }
}

// a controller that is busy lets sbatch wait
TEST_F(Submit, SaysThatItWaits) {
  write_program("sbatch", "sleep 1.5; echo 12");
  const std::string submit = "submit --progress json" + map_in_two_tasks().substr(6);
  const Ran ran = run_polhode(submit, in_bin());
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find(R"({"doing":"waiting for Slurm to take the job"})"), std::string::npos)
      << ran.err;
}

// tasks would stop at pieces of the film as it was before
TEST_F(Submit, RefusesPiecesOfAnotherFilm) {
  write_program("sbatch", "echo 12");
  write_program("scontrol", "echo 'slurm_load_jobs error: Invalid job id specified' >&2; exit 1");
  const auto submit = [&](int rate) {
    return run_polhode(
        fmt::format("submit --tasks 2 render {} -o {} --size 96x54 --fps {} --resume "
                    "--pieces 2",
                    at("scene.toml"),
                    at("film.mp4"),
                    rate),
        in_bin());
  };
  ASSERT_EQ(submit(10).code, 0);
  std::filesystem::create_directory(folder_ / ".film.mp4.parts");
  write_text(folder_ / ".film.mp4.parts/00001.mp4", "");
  EXPECT_EQ(submit(10).code, 0) << "the same film goes on";
  const Ran other = submit(12);
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find(".film.mp4.parts: holds pieces of the film as it was before; delete it"),
            std::string::npos)
      << other.err;
  std::filesystem::remove_all(folder_ / ".film.mp4.parts");
  EXPECT_EQ(submit(12).code, 0);
}

TEST_F(Submit, TellsBadInputBeforeAnythingIsQueued) {
  write_text(folder_ / "bad.toml", "format = 1\n[bdy]\n");
  const std::string scene = at("scene.toml");
  const std::pair<std::string, const char*> cases[] = {
      {"submit render " + at("bad.toml"), "bad.toml:2"},
      {"submit render " + scene + " --fsp 30", "render has no option --fsp"},
      {"submit --tme 3 render " + scene, "submit has no option --tme"},
      {"submit rendr " + scene, "'rendr' is no work that can be divided"},
      {"submit", "work"},
      {"submit simulate " + scene, "'simulate' is no work that can be divided (known: "},
      {"submit render " + scene + " -o a.png", "--output: 'a.png' cannot be divided into tasks"},
      {"submit render " + scene + " --still 1", "--still: a single picture cannot be divided"},
      {"submit render " + scene + " -o a.png --resume", "--resume: 'a.png' cannot be resumed"},
      {"submit render " + scene + " --shard 1/2", "--shard: is given by submit"},
      {"submit --partition 'a b' render " + scene, "--partition: must be one word"},
      {"submit --tasks 0 render " + scene, "--tasks: must be greater than 0"},
      {"submit --dry-run --tasks 9 section " + scene + " --starts 3 -o " + at("s"),
       "--tasks: must be at most the number of motions, 4"},
      {"submit chart --pictures " + scene, "--pictures: cannot be divided"},
      {"status " + at("nothing"), "is not the folder of a job"},
      {"cancel " + at("nothing"), "is not the folder of a job"}};
  for (const auto& [words, says] : cases) {
    const Ran ran = run_polhode(words);
    EXPECT_EQ(ran.code, 2) << words;
    EXPECT_NE(ran.err.find(says), std::string::npos) << words << "\n" << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  }
}

TEST_F(Submit, LeavesHelpToTheCommand) {
  const Ran ran = run_polhode("submit render --help");
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.out.find("--theme"), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace polhode
