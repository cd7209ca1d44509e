// SPDX-License-Identifier: MIT
// `polhode lecture` as a user calls it, on decks so small that they take a second.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/background.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;
using test::Ran;
using test::read_text;
using test::run_polhode;
using test::TemporaryFolder;
using test::write_text;

constexpr const char* kDeck =
    "---\ntitle: A <b>bold</b> \"title\" & more\n---\n\n# One\n\n## Two\n\n"
    "The rate is {inspect:scene.toml#precession_rate}.\n\n$$x = \\frac{1}{2}$$\n\n"
    "![A caption](scene.toml){.film to=0.5}\n\n![](scene.toml){.inspect keys=kind}\n";

class Lecture : public ::testing::Test {
 protected:
  Lecture() {
    fs::create_directory(folder_ / "deck");
    write_text(folder_ / "deck/scene.toml", test::kSmallScene);
    write_text(folder_ / "deck/deck.md", kDeck);
  }
  Ran lecture(const std::string& options = "--to html", const std::string& before = "") const {
    return run_polhode(fmt::format("lecture '{}' -o '{}' --size 64x36 {}",
                                   folder_ / "deck/deck.md",
                                   folder_ / "out",
                                   options),
                       before);
  }
  std::string page() const { return read_text(folder_ / "out/index.html"); }
  bool has(const std::string& words) const { return page().find(words) != std::string::npos; }

  TemporaryFolder folder_;
};

TEST_F(Lecture, MakesPageSlidesAndData) {
  const Ran ran = lecture("--to html,pptx,beamer,data");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(has("A &lt;b&gt;bold&lt;/b&gt; &quot;title&quot; &amp; more"));
  EXPECT_TRUE(has("<video data-film=\"scene\""));
  EXPECT_TRUE(has("rad/s"));
  EXPECT_TRUE(has("<mfrac>"));
  EXPECT_TRUE(has("symmetric prolate"));
  EXPECT_TRUE(has("Content-Security-Policy"));
  EXPECT_FALSE(has("{inspect:"));
  EXPECT_FALSE(has("src=\"http"));
  EXPECT_EQ(read_text(folder_ / "out/slides.pptx").substr(0, 2), "PK");
  EXPECT_NE(read_text(folder_ / "out/slides.tex").find("\\includegraphics"), std::string::npos);
  const auto manifest = nlohmann::json::parse(read_text(folder_ / "out/data/manifest.json"));
  EXPECT_EQ(manifest["scenes"][0]["motion"], "motions/scene.csv");
  for (const auto& file : manifest["files"])
    EXPECT_EQ(fs::file_size(folder_ / ("out/data/" + file["name"].get<std::string>())),
              file["bytes"]);
  for (const auto& picture : manifest["pictures"]) {
    for (const auto& file : picture["files"])
      EXPECT_EQ(fs::file_size(folder_ / ("out/media/" + file["name"].get<std::string>())),
                file["bytes"]);
  }
  EXPECT_EQ(read_text(folder_ / "out/data/source/scene.toml"), test::kSmallScene);
}

TEST_F(Lecture, TellsTheLicencesOfWhatItContains) {
  fs::create_directories(folder_ / "reveal/dist");
  write_text(folder_ / "reveal/dist/reveal.js", "// script");
  write_text(folder_ / "reveal/dist/reveal.css", "/* style */");
  write_text(folder_ / "reveal/LICENSE", "the notice of reveal.js\n");
  const std::string reveal = "POLHODE_REVEAL='" + (folder_ / "reveal") + "'";
  const auto told = [&] {
    return read_text(folder_ / "out/LICENCES.txt");
  };
  // slides contain reveal.js, a page does not; what has no page inside needs no notice
  ASSERT_EQ(lecture("--to beamer", reveal).code, 0);
  EXPECT_EQ(told(), "");
  ASSERT_EQ(lecture("--to html", reveal).code, 0);
  EXPECT_NE(told().find("Permission is hereby granted"), std::string::npos);
  EXPECT_EQ(told().find("reveal.js"), std::string::npos);
  ASSERT_EQ(lecture("--to slides", reveal).code, 0);
  EXPECT_NE(told().find("the notice of reveal.js"), std::string::npos);
  // the font is named exactly when it is inside
  const bool inside =
      read_text(folder_ / "out/slides.html").find("@font-face") != std::string::npos;
  EXPECT_EQ(told().find("GUST Font License") != std::string::npos, inside);
}

TEST_F(Lecture, RendersOnlyWhatChanged) {
  ASSERT_EQ(lecture().code, 0);
  std::string text = kDeck;
  write_text(folder_ / "deck/deck.md", text + "\nOther words.\n");
  EXPECT_NE(lecture().out.find(" 0 made now"), std::string::npos);
  EXPECT_TRUE(has("Other words"));
  // comments change nothing, numbers do
  std::string scene = test::kSmallScene;
  write_text(folder_ / "deck/scene.toml", "# words\n" + scene);
  EXPECT_NE(lecture().out.find(" 0 made now"), std::string::npos);
  const std::string before = page();
  write_text(folder_ / "deck/scene.toml", scene.replace(scene.find("[1, 0, 3]"), 9, "[2, 0, 3]"));
  EXPECT_NE(lecture().out.find(" 2 made now"), std::string::npos);
  EXPECT_NE(page(), before);
  // what nothing shows any more is gone
  const auto films =
      std::count_if(fs::directory_iterator(folder_ / "out/media"), {}, [](const auto& entry) {
        return entry.path().extension() == ".mp4";
      });
  EXPECT_EQ(films, 1);
}

// a picture of the deck's own that has changed leaves no old copy
// a picture that cannot be trusted is told in every run, with its line of the deck, not only in
// that which makes it
TEST_F(Lecture, WarningsComeWithKeptPicturesToo) {
  write_text(folder_ / "deck/deck.md",
             "## A\n\n![](scene.toml){.film to=0.5 method=rk4 step=0.4 fps=4}\n");
  const Ran first = lecture("--to html,data"), second = lecture("--to html,data");
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_NE(second.out.find(" 0 made now"), std::string::npos) << second.out;
  EXPECT_NE(first.err.find("deck.md:3: "), std::string::npos) << first.err;
  EXPECT_EQ(first.err, second.err);
  EXPECT_EQ(first.err.find("--"), std::string::npos) << first.err;
  const std::string manifest = read_text(folder_ / "out/data/manifest.json");
  EXPECT_NE(manifest.find("cannot be trusted"), std::string::npos) << first.err;
}

TEST_F(Lecture, CopiesOfPicturesAreForgottenToo) {
  write_text(folder_ / "deck/deck.md", "# One\n\n![A drawing](own.svg)\n");
  const auto copies = [&](const char* drawing) {
    write_text(folder_ / "deck/own.svg", drawing);
    EXPECT_EQ(lecture().code, 0);
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_ / "out/media")) {
      if (entry.path().extension() == ".svg") found.push_back(entry.path().filename());
    }
    return found;
  };
  const std::vector<std::string> first = copies("<svg xmlns='http://www.w3.org/2000/svg'/>");
  ASSERT_EQ(first.size(), 1U);
  EXPECT_TRUE(has("media/" + first[0]));
  const std::vector<std::string> second =
      copies("<svg xmlns='http://www.w3.org/2000/svg' id='a'/>");
  ASSERT_EQ(second.size(), 1U);
  EXPECT_NE(second, first);
}

// slides that are not made again keep their films, and are told
TEST_F(Lecture, WhatOlderDocumentsShowIsKept) {
  ASSERT_EQ(lecture("--to html,pptx").code, 0);
  const std::string scene = test::kSmallScene;
  std::string other = scene;
  write_text(folder_ / "deck/scene.toml", other.replace(other.find("[1, 0, 3]"), 9, "[2, 0, 3]"));
  const Ran ran = lecture("--to html");
  ASSERT_EQ(ran.code, 0);
  EXPECT_NE(ran.err.find("slides.pptx is from an earlier run"), std::string::npos) << ran.err;
  const auto films = [&] {
    return std::count_if(fs::directory_iterator(folder_ / "out/media"), {}, [](const auto& entry) {
      return entry.path().extension() == ".mp4";
    });
  };
  EXPECT_EQ(films(), 2);
  const Ran all = lecture("--to html,pptx");
  EXPECT_EQ(all.err.find("earlier run"), std::string::npos) << all.err;
  EXPECT_EQ(films(), 1);
}

TEST_F(Lecture, OneBadSceneLeavesTheRest) {
  write_text(folder_ / "deck/bad.toml", "format = 1\n[body]\nmoments = [1, 1, 9]\n");
  write_text(folder_ / "deck/deck.md",
             std::string(kDeck) + "\n![](bad.toml){.film}\n\n{inspect:scene.toml#nothing}\n");
  const Ran ran = lecture();
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("deck.md:17: "), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("bad.toml:3"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("deck.md:19: "), std::string::npos) << ran.err;
  EXPECT_TRUE(has("<video"));
  EXPECT_TRUE(has("could not be made"));
}

// a mistake that will be mended costs no film
TEST_F(Lecture, MistakesLoseNothing) {
  ASSERT_EQ(lecture().code, 0);
  const std::string before = page();
  const auto films = [&] {
    return std::count_if(fs::directory_iterator(folder_ / "out/media"), {}, [](const auto& entry) {
      return entry.path().extension() == ".mp4";
    });
  };
  ASSERT_EQ(films(), 1);
  for (const char* wrong : {"--theme ligth", "--fps 0", "--quality x"}) {
    const Ran ran = lecture(std::string("--to html ") + wrong);
    EXPECT_EQ(ran.code, 2);
    EXPECT_TRUE(ran.err.starts_with("polhode: --")) << ran.err;
    EXPECT_EQ(page(), before);
  }
  write_text(folder_ / "deck/scene.toml", std::string(test::kSmallScene) + "\n[vdieo]\n");
  EXPECT_EQ(lecture().code, 2);
  EXPECT_EQ(films(), 1);
  write_text(folder_ / "deck/scene.toml", test::kSmallScene);
  EXPECT_EQ(lecture().code, 0);
  EXPECT_EQ(page(), before);
}

TEST_F(Lecture, NothingLeavesTheFolder) {
  write_text(folder_ / "scene.toml", test::kSmallScene);
  write_text(folder_ / "deck/deck.md",
             "![](../scene.toml){.still}\n\n![](/etc/passwd)\n\n{inspect:../scene.toml#kind}\n");
  const Ran ran = lecture();
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("deck.md:1: '../scene.toml' leaves the deck's folder"), std::string::npos)
      << ran.err;
  EXPECT_NE(ran.err.find("deck.md:5: "), std::string::npos) << ran.err;
  EXPECT_EQ(page().find("root:x:"), std::string::npos);
  write_text(folder_ / "deck/deck.md",
             "![](../scene.toml){.still}\n\n{inspect:../scene.toml#kind}\n");
  const Ran trusted = lecture("--to html --allow-outside");
  EXPECT_EQ(trusted.code, 0) << trusted.err;
}

TEST_F(Lecture, HostileTextRunsNothing) {
  const std::string name = "$(touch x) \"<img src=q onerror=alert(1)>.toml";
  std::string scene = test::kSmallScene;
  scene.replace(scene.find("\"test\""), 6, "'</script><script>alert(1)</script>'");
  write_text(folder_ / "deck/a.toml", scene);
  write_text(folder_ / "deck/deck.md",
             "---\ntitle: '</title><script>alert(1)</script>'\nlicence: "
             "'<script>alert(1)</script>'\n---\n\n# `<script>`{=html} <script>alert(1)</script>\n\n"
             "![<script>alert(1)</script>](a.toml){.compare with=a.toml to=0.2 alt=\"x' "
             "onload='alert(1)\"}\n\n"
             "![](<" +
                 name + ">){.film}\n\n$\\href{javascript:alert(1)}{x}$ [x](javascript:alert(1))\n");
  const Ran ran = lecture("--to html,beamer,data");
  EXPECT_EQ(ran.code, 2);
  const std::string text = page();
  EXPECT_EQ(text.find("<script>"), std::string::npos);
  EXPECT_EQ(text.find("onerror=alert"),
            text.find("onerror=alert(1)&gt;") == std::string::npos
                ? std::string::npos
                : text.find("onerror=alert(1)&gt;"));
  EXPECT_EQ(text.find("href=\"javascript"), std::string::npos);
  EXPECT_EQ(text.find("' onload='"), std::string::npos);
  EXPECT_EQ(read_text(folder_ / "out/slides.tex").find("\\href{javascript"), std::string::npos);
  EXPECT_FALSE(fs::exists("x"));
}

// from the folders where it keeps what it makes, files of earlier runs are removed
TEST_F(Lecture, ItsSourcesAreNotItsOutput) {
  ASSERT_EQ(lecture("--to html,data").code, 0);
  const fs::path source = folder_ / "out/data/source";
  const auto again = [&](const std::string& deck) {
    return run_polhode(fmt::format("lecture '{}' -o '{}' --to html", deck, folder_ / "out"));
  };
  const Ran ran = again(source / "deck.md");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("lies in the folder 'data' of the output"), std::string::npos) << ran.err;
  EXPECT_TRUE(fs::exists(source / "scene.toml"));
  write_text(folder_ / "out/deck.md", "![](data/source/scene.toml){.still}\n");
  EXPECT_EQ(again(folder_ / "out/deck.md").code, 2);
  write_text(folder_ / "out/deck.md", "![](media/x.png)\n");
  EXPECT_EQ(again(folder_ / "out/deck.md").code, 2);
  // named by a film, or by a number
  write_text(folder_ / "out/film.toml", "[[panel]]\nscene = \"data/source/scene.toml\"\n");
  for (const char* names :
       {"![](film.toml){.still}\n", "{inspect:data/source/scene.toml#kind}\n"}) {
    write_text(folder_ / "out/deck.md", names);
    const Ran indirect = again(folder_ / "out/deck.md");
    EXPECT_EQ(indirect.code, 2) << names;
    EXPECT_NE(indirect.err.find("lies in the folder 'data'"), std::string::npos) << indirect.err;
  }
  // what was changed since stays, whatever names it
  write_text(source / "scene.toml", read_text(source / "scene.toml") + "# mine\n");
  write_text(folder_ / "deck/deck.md", "# One\n");
  ASSERT_EQ(lecture("--to html,data").code, 0);
  EXPECT_TRUE(fs::exists(source / "scene.toml"));
}

TEST_F(Lecture, BadUseIsOneLine) {
  EXPECT_NE(lecture("--to htlm").err.find("did you mean 'html'?"), std::string::npos);
  EXPECT_EQ(lecture("--jobs 0").code, 2);
  EXPECT_EQ(run_polhode("lecture /nowhere.md").code, 2);
  const Ran ran = lecture("--to html", "PATH=/nowhere");
  EXPECT_EQ(ran.code, 3);
  EXPECT_NE(ran.err.find("pandoc"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "out/index.html"));
  const Ran slides = lecture("--to slides", "HOME=/nowhere XDG_DATA_HOME=/nowhere");
  EXPECT_TRUE(slides.code == 3 || slides.code == 0) << slides.err;  // where it is installed for all
}

TEST_F(Lecture, AnInterruptLeavesTheLastVersion) {
  ASSERT_EQ(lecture().code, 0);
  const std::string before = page();
  write_text(folder_ / "deck/scene.toml", test::long_scene());
  write_text(folder_ / "deck/deck.md", "# New\n\n![](scene.toml){.film fps=60}\n");
  test::Background run({"lecture",
                        folder_ / "deck/deck.md",
                        "-o",
                        folder_ / "out",
                        "--to",
                        "html",
                        "--size",
                        "640x360",
                        "--progress",
                        "json"});
  // until a film has been begun
  EXPECT_TRUE(test::becomes([&] {
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "out"))
      if (entry.path().filename().string().ends_with(".part")) return true;
    return false;
  }));
  const Ran ran = run.end(SIGINT);
  EXPECT_EQ(ran.code, 130) << ran.err;
  EXPECT_EQ(page(), before);
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "out")) {
    EXPECT_FALSE(entry.path().filename().string().ends_with(".part")) << entry.path();
    EXPECT_FALSE(entry.path().filename().string().starts_with(".work")) << entry.path();
  }
  // every film of that version is still there
  const std::size_t at = before.find("media/scene-film");
  EXPECT_TRUE(fs::exists(folder_ / ("out/" + before.substr(at, before.find('"', at) - at))));
}

}  // namespace
}  // namespace polhode
