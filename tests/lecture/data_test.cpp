// SPDX-License-Identifier: MIT
#include "lecture/data.h"

#include <gtest/gtest.h>

#include "base/hash.h"
#include "lecture/deck_scenes.h"
#include "scene/scene_file.h"
#include "support/expect_error.h"

namespace polhode {
namespace {

using test::read_text;
using test::TemporaryFolder;
using test::write_text;

// A deck with a scene in a folder beside it, and the folder of its lecture.
class DataOfALecture : public ::testing::Test {
 protected:
  DataOfALecture() {
    std::filesystem::create_directories(folder_ / "deck/in");
    std::filesystem::create_directories(folder_ / "out/media");
    write_text(folder_ / "deck/in/top.toml", test::kSmallScene);
    write_text(folder_ / "deck/photo.png", "a photo");
    write_text(folder_ / "out/media/motion.csv", "t,qw\n");
    deck_.file = folder_ / "deck/talk.md";
    deck_.root = {folder_ / "deck", false};
    deck_.images = {"photo.png"};
    data_.deck = &deck_;
    data_.deck_text = "# The deck\n";
    data_.outputs = {"html", "data"};
    data_.scenes = {{scene("in/top.toml"), "motion.csv"}};
    data_.products = {
        {"top-film-1", {{"kind", "film"}, {"files", {"a.mp4"}}, {"warnings", {"it shakes"}}}}};
  }
  std::shared_ptr<DeckScene> scene(const std::string& name) const {
    auto made = std::make_shared<DeckScene>();
    made->name = name;
    made->file = folder_ / ("deck/" + name);
    made->scene = load_scene(made->file);
    made->hash = scene_hash(made->scene);
    return made;
  }
  Json manifest() const {
    DataFolder(data_, folder_ / "out").commit();
    return Json::parse(read_text(folder_ / "out/data/manifest.json"));
  }
  bool has(const std::string& name) const {
    return std::filesystem::exists(folder_ / ("out/data/" + name));
  }

  TemporaryFolder folder_;
  Deck deck_;
  LectureData data_;
};

// so that the deck finds them where it names them
TEST_F(DataOfALecture, FilesStandWhereTheyStood) {
  const Json json = manifest();
  EXPECT_EQ(read_text(folder_ / "out/data/source/talk.md"), "# The deck\n");
  EXPECT_EQ(read_text(folder_ / "out/data/source/in/top.toml"), test::kSmallScene);
  EXPECT_EQ(read_text(folder_ / "out/data/source/photo.png"), "a photo");
  EXPECT_EQ(read_text(folder_ / "out/data/motions/top.csv"), "t,qw\n");
  ASSERT_EQ(json.at("files").size(), 4U);
  for (const Json& file : json.at("files")) {
    const std::string bytes =
        read_text(folder_ / ("out/data/" + file.at("name").get<std::string>()));
    EXPECT_EQ(file.at("bytes"), bytes.size());
    EXPECT_EQ(file.at("hash"), content_hash(bytes));
  }
}

// also where the file has changed since it was read
TEST_F(DataOfALecture, PicturesAreThoseThatAreShown) {
  write_text(folder_ / "out/media/picture-1.png", "what is shown");
  data_.images = {{"photo.png", "media/picture-1.png"}};
  manifest();
  EXPECT_EQ(read_text(folder_ / "out/data/source/photo.png"), "what is shown");
}

// what fails later leaves the files of the run before
TEST_F(DataOfALecture, NothingHasItsNameBeforeAllIsWritten) {
  manifest();
  data_.deck_text = "# Another deck\n";
  { const DataFolder abandoned(data_, folder_ / "out"); }
  EXPECT_EQ(read_text(folder_ / "out/data/source/talk.md"), "# The deck\n");
}

// where a link leads out of the folder, what it leads to is not ours to delete
TEST_F(DataOfALecture, FilesBehindLinksStay) {
  manifest();
  std::filesystem::remove_all(folder_ / "out/data/source");
  std::filesystem::create_directory_symlink(folder_ / "deck", folder_ / "out/data/source");
  deck_.images.clear();
  test::expect_input_error([&] { manifest(); }, "", "would overwrite");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "deck/photo.png"));
}

// the pictures would not be of the scene that is kept
TEST_F(DataOfALecture, ASceneThatHasChangedIsRefused) {
  std::string text = test::kSmallScene;
  text.replace(text.find("test"), 4, "other");
  write_text(folder_ / "deck/in/top.toml", text);
  test::expect_input_error([&] { manifest(); }, "", "changed during the run");
  EXPECT_FALSE(has("manifest.json"));
}

TEST_F(DataOfALecture, TheManifestTellsHowToMakeItAgain) {
  const Json json = manifest();
  EXPECT_EQ(json.at("deck"), "source/talk.md");
  EXPECT_EQ(json.at("deck_hash"), content_hash("# The deck\n"));
  EXPECT_EQ(json.at("rebuild"),
            "cd data/source && polhode lecture talk.md -o ../../again --to html,data");
  data_.settings.size = "320x180";
  data_.settings.quality = "draft";
  EXPECT_EQ(
      manifest().at("rebuild"),
      "cd data/source && polhode lecture talk.md -o ../../again --to html,data --size 320x180 "
      "--quality draft");
  EXPECT_EQ(json.at("scenes").at(0).at("scene"), "source/in/top.toml");
  EXPECT_EQ(json.at("scenes").at(0).at("title"), "test");
  EXPECT_EQ(json.at("scenes").at(0).at("scene_hash"), data_.scenes[0].scene->hash);
  EXPECT_EQ(json.at("scenes").at(0).at("motion"), "motions/top.csv");
  EXPECT_EQ(json.at("pictures").at(0).at("name"), "top-film-1");
  EXPECT_EQ(json.at("pictures").at(0).at("kind"), "film");
  EXPECT_EQ(json.at("pictures").at(0).at("files"), Json::array({"a.mp4"}));
  EXPECT_EQ(json.at("pictures").at(0).at("warnings"), Json::array({"it shakes"}));
}

TEST_F(DataOfALecture, TheManifestTellsTheLicences) {
  const auto licences = [&] {
    return manifest().at("licences").dump();
  };
  EXPECT_NE(licences().find("not told by the deck"), std::string::npos);
  EXPECT_EQ(licences().find("reveal.js"), std::string::npos);
  EXPECT_EQ(licences().find("GUST"), std::string::npos);
  data_.licence = "CC0";
  data_.reveal_version = "4.6.1";
  data_.formula_font = true;
  EXPECT_NE(licences().find("\"CC0\""), std::string::npos);
  EXPECT_NE(licences().find("reveal.js 4.6.1"), std::string::npos);
  EXPECT_NE(licences().find("GUST Font License"), std::string::npos);
}

TEST_F(DataOfALecture, ASceneWithoutAMotionIsStillThere) {
  data_.scenes[0].csv = "";
  EXPECT_FALSE(manifest().at("scenes").at(0).contains("motion"));
  EXPECT_TRUE(has("source/in/top.toml"));
}

// two scenes of one name have motions of two names
TEST_F(DataOfALecture, MotionsHaveNamesOfTheirOwn) {
  write_text(folder_ / "deck/top.toml", test::kSmallScene);
  data_.scenes.push_back({scene("top.toml"), "motion.csv"});
  const Json json = manifest();
  EXPECT_EQ(json.at("scenes").at(1).at("motion"), "motions/top_.csv");
  EXPECT_TRUE(has("motions/top_.csv"));
}

// what a trusted deck takes from elsewhere is kept by its name
TEST_F(DataOfALecture, FilesFromElsewhereStandBesideTheDeck) {
  write_text(folder_ / "elsewhere.png", "far");
  deck_.root.allow_outside = true;
  deck_.images = {"../elsewhere.png", folder_ / "elsewhere.png"};
  // where the deck does not find it
  EXPECT_TRUE(manifest().at("rebuild").is_null());
  EXPECT_EQ(read_text(folder_ / "out/data/source/elsewhere.png"), "far");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/data/elsewhere.png"));
}

// two files of one name stay two, and a scene from elsewhere has its mesh beside it
TEST_F(DataOfALecture, FilesOfOneNameFromElsewhereStayApart) {
  deck_.root.allow_outside = true;
  const std::string mesh =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  const std::string text =
      "format = 1\n[body]\nsolid = { kind = \"mesh\", file = \"m.obj\", mass = 1 }\n"
      "[motion]\nspin = { body = [1, 0, 3] }\nduration = 1\n";
  for (const std::string where : {"first", "second", "third/in"}) {
    std::filesystem::create_directories(folder_ / where);
    write_text(folder_ / (where + "/photo.png"), where);
    write_text(folder_ / (where + "/m.obj"), "# " + where + "\n" + mesh);
  }
  write_text(folder_ / "first/a.toml", text);
  write_text(folder_ / "second/b.toml", text);
  // "photo.png" of the deck's own folder keeps its name, and so does the folder "in"
  deck_.images = {"../first/photo.png", "photo.png", folder_ / "third/in/photo.png"};
  data_.scenes.push_back({scene("../first/a.toml"), ""});
  data_.scenes.push_back({scene("../second/b.toml"), ""});
  const Json json = manifest();
  EXPECT_EQ(json.at("scenes").at(1).at("scene"), "source/first/a.toml");
  EXPECT_EQ(json.at("scenes").at(2).at("scene"), "source/b.toml");
  const std::pair<const char*, const char*> files[] = {{"photo.png", "a photo"},
                                                       {"first/photo.png", "first"},
                                                       {"in/photo.png", "third/in"},
                                                       {"first/a.toml", text.c_str()},
                                                       {"b.toml", text.c_str()}};
  for (const auto& [name, content] : files)
    EXPECT_EQ(read_text(folder_ / ("out/data/source/" + std::string(name))), content) << name;
  EXPECT_TRUE(read_text(folder_ / "out/data/source/first/m.obj").starts_with("# first\n"));
  EXPECT_TRUE(read_text(folder_ / "out/data/source/m.obj").starts_with("# second\n"));
}

// the old manifest says what was ours; what is not, or is not listed, stays
TEST_F(DataOfALecture, FilesOfAnEarlierVersionGo) {
  manifest();
  write_text(folder_ / "out/data/source/mine.txt", "mine");
  write_text(folder_ / "out/keep.txt", "keep");
  deck_.images.clear();
  manifest();
  EXPECT_FALSE(has("source/photo.png"));
  EXPECT_TRUE(has("source/mine.txt"));
  write_text(
      folder_ / "out/data/manifest.json",
      R"({"files": [{"name": "source/../../keep.txt"}, {"name": "../keep.txt"}, {"name": 7}, 7]})");
  manifest();
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/keep.txt"));
  write_text(folder_ / "out/data/manifest.json", "no JSON");
  EXPECT_EQ(manifest().at("deck"), "source/talk.md");
}

}  // namespace
}  // namespace polhode
