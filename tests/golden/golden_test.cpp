// SPDX-License-Identifier: MIT
// Our own golden pictures, drawn by every back end with every number of workers; and proofs that
// the net holds: what must fail fails, what must pass passes, and no failure touches a reference.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "image/png.h"
#include "scene/golden_file.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::Ran;
using test::run_polhode;
using test::TemporaryFolder;
using test::write_text;

const std::string kGoldens = POLHODE_SOURCE_DIR "/tests/golden";

struct Workers {
  std::string backend;
  int jobs;
};

// how a failing test names its workers
void PrintTo(const Workers& workers, std::ostream* out) {
  *out << workers.backend << " " << workers.jobs;
}

class Golden : public ::testing::TestWithParam<Workers> {};

TEST_P(Golden, PicturesLookAsTheyDid) {
  const auto& [backend, jobs] = GetParam();
  // a folder for each, since tests run at the same time
  const std::string output =
      fmt::format("{}/output/golden/{}_{}", POLHODE_SOURCE_DIR, backend, jobs);
  const Ran ran = run_polhode(fmt::format(
      "golden run '{}' --backend {} --jobs {} --output '{}'", kGoldens, backend, jobs, output));
  if (ran.code == 3 && backend != "osmesa") GTEST_SKIP() << ran.err;
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err
                         << "if the new pictures are right: cmake --build --preset golden-update";
}
INSTANTIATE_TEST_SUITE_P(Everywhere,
                         Golden,
                         ::testing::Values(Workers{"osmesa", 1},
                                           Workers{"osmesa", 2},
                                           Workers{"osmesa", 4},
                                           Workers{"egl", 1},
                                           Workers{"egl", 2},
                                           Workers{"egl", 4}),
                         [](const auto& row) {
                           return fmt::format("{}_{}", row.param.backend, row.param.jobs);
                         });

// small, so that a checkout stays small; one picture and one sidecar for each case
TEST(GoldenFolder, IsSmallAndWhole) {
  const GoldenFile file = load_golden_file(kGoldens + "/cases.toml");
  std::uintmax_t bytes = 0;
  for (const GoldenCase& one : file.cases) {
    SCOPED_TRACE(one.name);
    EXPECT_LE(one.size.width, 480);
    EXPECT_LE(one.size.height, 270);
    EXPECT_FALSE(one.guards.empty());
    bytes += std::filesystem::file_size(kGoldens + "/" + one.name + ".png");
    const GoldenSidecar sidecar = load_golden_sidecar(kGoldens + "/" + one.name + ".png.toml");
    EXPECT_FALSE(sidecar.renderer.empty());
    EXPECT_GT(sidecar.samples, 0);
    EXPECT_FALSE(sidecar.verdict.reason.empty());
  }
  EXPECT_LT(bytes, 1'500'000U);
}

// One case in a folder of its own, with the reference that this machine draws.
class Net : public ::testing::Test {
 protected:
  Net() {
    std::filesystem::create_directory(folder_ / "g");
    write_scene("");
    write_text(folder_ / "g/cases.toml",
               "format = 1\n[verdict]\nreason = \"ours\"\n[[case]]\nname = \"top\"\n"
               "scene = \"top.toml\"\nstill = 0.5\n");
    const Ran ran = golden("update", "--allow-dirty");
    EXPECT_EQ(ran.code, 0) << ran.err;
    image_ = read_png(folder_ / "g/top.png");
  }

  void write_scene(const std::string& show) const {
    write_text(folder_ / "g/top.toml",
               std::string(test::kSmallScene) + "[show]\nspace_axes = false\n" + show);
  }
  Ran golden(const std::string& action, const std::string& options = "") const {
    return run_polhode(fmt::format("golden {} '{}' {}", action, folder_ / "g", options),
                       fmt::format("cd '{}';", folder_.path().string()));
  }
  Ran run(const std::string& options = "") const { return golden("run", options); }
  // the reference, with every pixel changed by `change`
  template <class Change>
  void alter(const Change& change, const std::string& name = "g/top.png") const {
    Image altered = image_;
    for (int y = 0; y < altered.height; ++y) {
      for (int x = 0; x < altered.width; ++x)
        change(x, y, altered.at(x, y));
    }
    write_png(folder_ / name, altered, false);
  }

  TemporaryFolder folder_;
  Image image_;
};

TEST_F(Net, LetsTheSameThrough) {
  const Ran ran = run();
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "output"));
}

TEST_F(Net, CatchesAnAlteredReference) {
  // a patch of 8x8 pixels
  alter([](int x, int y, std::uint8_t* p) {
    if (x / 8 == 20 && y / 8 == 10) p[0] = static_cast<std::uint8_t>(p[0] ^ 0x20);
  });
  const std::string before = test::read_text(folder_ / "g/top.png");
  const Ran ran = run();
  EXPECT_EQ(ran.code, 1) << ran.out;
  EXPECT_NE(ran.out.find("different"), std::string::npos) << ran.out;
  // the reference is as it was, the actual picture and the difference are there for a person
  EXPECT_EQ(test::read_text(folder_ / "g/top.png"), before);
  EXPECT_EQ(read_png(folder_ / "output/golden/top.actual.png").pixels, image_.pixels);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "output/golden/top.difference.png"));
  // and go away when all is well again
  alter([](int, int, std::uint8_t*) {});
  EXPECT_EQ(run().code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "output/golden/top.actual.png"));
}

TEST_F(Net, CatchesAShiftByOnePixel) {
  alter(
      [&](int x, int y, std::uint8_t* p) { std::copy_n(image_.at(std::max(0, x - 1), y), 4, p); });
  EXPECT_EQ(run().code, 1);
}

TEST_F(Net, CatchesAColourByFourLevels) {
  for (const int channel : {0, 1, 2}) {
    alter([&](int, int, std::uint8_t* p) {
      p[channel] = static_cast<std::uint8_t>(p[channel] > 250 ? p[channel] - 4 : p[channel] + 4);
    });
    EXPECT_EQ(run().code, 1) << channel;
  }
}

TEST_F(Net, CatchesAMissingArrow) {
  write_scene("omega = false\n");
  EXPECT_EQ(run().code, 1);
  write_scene("momentum = false\n");
  EXPECT_EQ(run().code, 1);
  write_scene("");
  EXPECT_EQ(run().code, 0);
}

TEST_F(Net, LetsNoiseOfOneLevelThrough) {
  alter([](int x, int y, std::uint8_t* p) {
    for (int c = 0; c < 3; ++c) {
      const int noise = (x * 7 + y * 13 + c * 5) % 3 - 1;
      p[c] = static_cast<std::uint8_t>(std::clamp(p[c] + noise, 0, 255));
    }
  });
  const Ran ran = run();
  EXPECT_EQ(ran.code, 0) << ran.out;
}

// another machine's picture, named by its cause: the best match counts
TEST_F(Net, TakesAnyAcceptedReference) {
  const auto brighter = [](int, int, std::uint8_t* p) {
    p[1] = static_cast<std::uint8_t>(p[1] / 2 + 60);
  };
  alter(brighter);
  EXPECT_EQ(run().code, 1);
  const Ran updated = golden("update", "--allow-dirty --cause mesa-25");
  EXPECT_EQ(updated.code, 0) << updated.err;
  EXPECT_NE(updated.out.find("top.mesa-25.png"), std::string::npos) << updated.out;
  const Ran ran = run();
  EXPECT_EQ(ran.code, 0) << ran.out;
  EXPECT_NE(ran.out.find("top.mesa-25.png"), std::string::npos) << ran.out;
  const GoldenSidecar sidecar = load_golden_sidecar(folder_ / "g/top.mesa-25.png.toml");
  EXPECT_EQ(sidecar.cause, "mesa-25");
  EXPECT_EQ(sidecar.verdict.reason, "ours");
  EXPECT_NE(sidecar.renderer, "");
  EXPECT_NE(golden("show").out.find("mesa-25"), std::string::npos);
}

TEST_F(Net, ASidecarsRuleCounts) {
  alter([](int x, int, std::uint8_t* p) {
    if (x > 60) p[1] = static_cast<std::uint8_t>(p[1] ^ 0x10);
  });
  EXPECT_EQ(run().code, 1);
  GoldenSidecar sidecar = load_golden_sidecar(folder_ / "g/top.png.toml");
  sidecar.verdict = {{16, 0.0, 16, {}, {}}, "so \"large\"\nfor a test"};
  write_text(folder_ / "g/top.png.toml", sidecar_text(sidecar));
  EXPECT_EQ(run().code, 0);
  EXPECT_EQ(load_golden_sidecar(folder_ / "g/top.png.toml").verdict.reason,
            "so \"large\"\nfor a test");
}

TEST_F(Net, UpdateSaysWhatItChangesAndKeepsTheRest) {
  const Ran unchanged = golden("update", "--allow-dirty");
  EXPECT_NE(unchanged.out.find("unchanged"), std::string::npos) << unchanged.out;
  // within its thresholds a reference is kept, unless all are asked for
  alter([](int, int, std::uint8_t* p) { p[0] = static_cast<std::uint8_t>(p[0] ^ 1); });
  const std::string noisy = test::read_text(folder_ / "g/top.png");
  EXPECT_NE(golden("update", "--allow-dirty").out.find("kept"), std::string::npos);
  EXPECT_EQ(test::read_text(folder_ / "g/top.png"), noisy);
  EXPECT_NE(golden("update", "--allow-dirty --all").out.find("changed"), std::string::npos);
  EXPECT_EQ(read_png(folder_ / "g/top.png").pixels, image_.pixels);
  write_scene("omega = false\n");
  const Ran changed = golden("update", "--allow-dirty");
  EXPECT_NE(changed.out.find("changed: largest"), std::string::npos) << changed.out;
  EXPECT_NE(changed.out.find("1 of 1 references written"), std::string::npos) << changed.out;
  EXPECT_EQ(run().code, 0);
}

// thresholds of cases.toml reach the sidecar by an update, and the picture when it no longer suits
TEST_F(Net, TighterThresholdsRenewTheReference) {
  alter([](int, int, std::uint8_t* p) { p[0] = static_cast<std::uint8_t>(p[0] ^ 1); });
  write_text(folder_ / "g/cases.toml",
             "format = 1\n[verdict]\nmax = 0\nfraction = 0.0\nlimit = 0\n[[case]]\nname = \"top\"\n"
             "scene = \"top.toml\"\nstill = 0.5\n");
  EXPECT_EQ(run().code, 0) << "the sidecar rules until it is updated";
  const Ran updated = golden("update", "--allow-dirty");
  EXPECT_NE(updated.out.find("changed"), std::string::npos) << updated.out;
  EXPECT_EQ(read_png(folder_ / "g/top.png").pixels, image_.pixels);
  EXPECT_EQ(load_golden_sidecar(folder_ / "g/top.png.toml").verdict.thresholds.max, 0);
  EXPECT_EQ(run().code, 0);
}

TEST_F(Net, UpdateRefusesADirtyTree) {
  Ran ran = golden("update");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("git does not track"), std::string::npos) << ran.err;
  const std::string git = fmt::format("git -C '{}' -c user.name=t -c user.email=t@example.org ",
                                      folder_.path().string());
  ASSERT_EQ(std::system((git + "init -q").c_str()), 0);
  EXPECT_EQ(golden("update").code, 2) << "new files are changes too";
  const std::string commit = git + "add g && " + git + "commit -q -m all";
  ASSERT_EQ(std::system(commit.c_str()), 0);
  ran = golden("update");
  EXPECT_EQ(ran.code, 0) << ran.err;
  write_scene("omega = false\n");
  ran = golden("update");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("top.toml"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("--allow-dirty"), std::string::npos) << ran.err;
  EXPECT_EQ(read_png(folder_ / "g/top.png").pixels, image_.pixels);
}

TEST_F(Net, SaysWhatCannotBeCompared) {
  write_png(folder_ / "g/top.png", Image(64, 36), false);
  Ran ran = run();
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.out.find("64x36"), std::string::npos) << ran.out;
  std::filesystem::remove(folder_ / "g/top.png");
  ran = run();
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.out.find("no reference"), std::string::npos) << ran.out;
  // a case that cannot be drawn does not hide the others, and updates nothing
  std::filesystem::remove(folder_ / "g/top.toml");
  ran = run();
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.out.find("error"), std::string::npos) << ran.out;
  EXPECT_EQ(golden("update", "--allow-dirty").code, 2);
}

TEST_F(Net, BadFoldersAndFilesAreToldInOneLine) {
  const auto refused = [&](const std::string& words, const std::string& says) {
    const Ran ran = run_polhode(words);
    EXPECT_EQ(ran.code, 2) << words << ran.out;
    EXPECT_NE(ran.err.find(says), std::string::npos) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  };
  const std::string g = folder_ / "g";
  refused("golden run '" + (folder_ / "nowhere") + "'", "folder does not exist");
  refused("golden run '" + folder_.path().string() + "'", "cases.toml");
  refused("golden rum '" + g + "'", "did you mean 'run'");
  refused("golden run '" + g + "' --cases tpo", "did you mean 'top'");
  refused("golden run '" + g + "' --jobs 0", "--jobs");
  refused("golden run '" + g + "' --backend osmsea", "did you mean 'osmesa'");
  refused("golden update '" + g + "' --cause ../../x", "--cause");
  refused("golden update '" + g + "' --cause actual", "--cause");
  // pictures of failures are removed when a case passes: never among references
  std::filesystem::create_directory(folder_ / "other");
  write_text(folder_ / "other/cases.toml", "[[case]]\nname = \"a\"\nscene = \"t\"\n");
  refused("golden run '" + g + "' --output '" + (folder_ / "other") + "'", "folder of references");
  for (const auto& [text, says] :
       {std::pair{"[[case]]\nname = \"../x\"\nscene = \"top.toml\"\n", "case[0].name"},
        {"[[case]]\nname = \"a\"\nscene = \"t\"\n[[case]]\nname = \"a\"\nscene = \"t\"\n",
         "two cases"},
        {"[[case]]\nname = \"a\"\n", "scene"},
        {"[[cases]]\nname = \"a\"\n", "did you mean 'case'"},
        {"[verdict]\nmax = 300\n[[case]]\nname = \"a\"\nscene = \"t\"\n", "verdict.max"}}) {
    write_text(folder_ / "g/cases.toml", text);
    refused("golden run '" + g + "'", says);
  }
}

TEST_F(Net, JsonAndPageTellTheSame) {
  write_scene("omega = false\n");
  const Ran ran = run("--json --html page");
  EXPECT_EQ(ran.code, 1) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  EXPECT_FALSE(json.at("same"));
  EXPECT_EQ(json.at("cases").at(0).at("outcome"), "different");
  EXPECT_GT(json.at("cases").at(0).at("largest"), 70);
  const std::string page = test::read_text(folder_ / "page/index.html");
  EXPECT_NE(page.find("1 of 1 cases failed"), std::string::npos);
  EXPECT_EQ(page.find("http:"), std::string::npos) << "no page may need a network";
  EXPECT_EQ(page.find("https:"), std::string::npos);
}

}  // namespace
}  // namespace polhode
