// SPDX-License-Identifier: MIT
#include "lecture/products.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "frame/theme.h"
#include "image/png.h"
#include "lecture/deck_scenes.h"
#include "support/expect_error.h"
#include "video/film_reader.h"

namespace polhode {
namespace {

using test::DeckSceneFolder;
using test::TemporaryFolder;

DeckPicture picture_of(PictureKind kind, const std::map<std::string, std::string>& settings = {}) {
  DeckPicture picture;
  picture.kind = kind;
  picture.scenes = {"top.toml"};
  picture.settings = settings;
  return picture;
}

LectureSettings small_settings() {
  LectureSettings settings;
  settings.size = "64x48";
  settings.quality = "lecture";
  return settings;
}

// makes it in a folder of its own
struct MadeProduct {
  explicit MadeProduct(const Product& product) : facts(product.make(folder.path(), "stem")) {}
  bool has(const std::string& name) const { return std::filesystem::exists(folder / name); }

  TemporaryFolder folder;
  Json facts;
};

std::string key_of_film(const DeckPicture& picture,
                        const DeckScene& scene,
                        const LectureSettings& settings = small_settings()) {
  return film_product(picture, scene, settings).key;
}

// everything that the pixels depend on, and nothing else
TEST(Products, KeysAreWhatTheFilesDependOn) {
  const DeckSceneFolder folder, other("[show]\ntrail = true\n");
  const DeckPicture film = picture_of(PictureKind::film);
  const std::string key = key_of_film(film, folder.scene);
  EXPECT_EQ(key_of_film(film, folder.scene), key);
  EXPECT_NE(key_of_film(film, other.scene), key);
  EXPECT_NE(key_of_film(picture_of(PictureKind::loop), folder.scene), key);
  EXPECT_NE(key_of_film(picture_of(PictureKind::film, {{"to", "0.5"}}), folder.scene), key);
  EXPECT_EQ(key_of_film(picture_of(PictureKind::film, {{"alt", "words"}}), folder.scene), key);
  EXPECT_EQ(key_of_film(picture_of(PictureKind::film, {{"with", "b.toml"}}), folder.scene), key);
  LectureSettings large = small_settings();
  large.size = "128x96";
  EXPECT_NE(key_of_film(film, folder.scene, large), key);
  LectureSettings draft = small_settings();
  draft.quality = "draft";
  EXPECT_NE(key_of_film(film, folder.scene, draft), key);
  EXPECT_NE(key.find(folder.scene.hash), std::string::npos);
  EXPECT_NE(key.find(program_identity()), std::string::npos);
}

TEST(Products, NamesAreOfLettersThatEveryFileSystemHas) {
  const DeckSceneFolder folder("", "a b\xC3\xA9.toml");
  EXPECT_EQ(inspect_product(folder.scene).name, "a-b---inspect");
  EXPECT_EQ(motion_product(folder.scene).name, "a-b---motion");
  EXPECT_EQ(film_product(picture_of(PictureKind::loop), folder.scene, {}).name, "a-b---loop");
}

// before any work
TEST(Products, NumbersThatAreNoneAreToldAtOnce) {
  const DeckSceneFolder folder;
  for (const char* key : {"from", "to", "at", "stills", "step"}) {
    const DeckPicture picture = picture_of(PictureKind::film, {{key, "1,5"}});
    test::expect_input_error([&] { film_product(picture, folder.scene, {}); },
                             "",
                             std::string(key) + " must be a number, such as 2.5; found '1,5'");
  }
  test::expect_input_error(
      [&] {
        still_product(picture_of(PictureKind::still, {{"at", "now"}}), folder.scene, {});
      },
      "",
      "at must be a number");
  for (const char* key : {"from", "to", "at", "stills"}) {
    const DeckPicture picture = picture_of(PictureKind::film, {{key, "5000"}});
    test::expect_input_error([&] { film_product(picture, folder.scene, {}); },
                             key,
                             "must be a time within the motion, 0 to");
  }
  const DeckPicture back = picture_of(PictureKind::film, {{"from", "0.2"}, {"to", "0.1"}});
  test::expect_input_error([&] { film_product(back, folder.scene, {}); },
                           "to",
                           "must be later than from (0.2 s), got 0.1");
  const DeckPicture map = picture_of(PictureKind::stability, {{"turns", "0"}});
  test::expect_input_error(
      [&] { stability_product(map, folder.scene); }, "", "turns must be greater than 0");
}

using Pixel = std::array<int, 3>;

Pixel color_of_pixel(const Image& picture, int x, int y) {
  const std::uint8_t* pixel = picture.at(x, y);
  return {pixel[0], pixel[1], pixel[2]};
}

Pixel ground_of_theme(const std::string& name) {
  const glm::vec3 color = 255.0f * find_theme(name).background;
  return {static_cast<int>(std::lround(color.r)),
          static_cast<int>(std::lround(color.g)),
          static_cast<int>(std::lround(color.b))};
}

// ten frames of motion, and the pause of the story where the lecture will stop
TEST(Products, AFilmHasItsPosterAndItsPauses) {
  const DeckSceneFolder folder("[[story]]\nat = 0.3\nhold = 0.5\ncaption = \"It stands\"\n");
  const MadeProduct made(film_product(
      picture_of(PictureKind::film, {{"from", "0.2"}}), folder.scene, small_settings()));
  const Json& facts = made.facts;
  EXPECT_EQ(facts.at("kind"), "film");
  EXPECT_EQ(facts.at("film"), "stem.mp4");
  EXPECT_EQ(facts.at("title"), "test");
  EXPECT_EQ(facts.at("frames"), 13) << "eight of motion, five of pause";
  EXPECT_EQ(facts.at("fps"), 10.0);
  EXPECT_EQ(facts.at("width"), 64);
  EXPECT_NEAR(facts.at("duration"), 1.3, 1e-12);
  ASSERT_EQ(facts.at("pauses").size(), 1U);
  EXPECT_NEAR(facts.at("pauses").at(0).at(0), 0.1, 1e-12) << "of this film";
  EXPECT_NEAR(facts.at("pauses").at(0).at(1), 0.6, 1e-12);
  EXPECT_NE(facts.at("vtt").get<std::string>().find("It stands"), std::string::npos);
  // the handout shows the pause, with its words
  EXPECT_EQ(facts.at("poster_at"), 0.3);
  ASSERT_EQ(facts.at("stills").size(), 1U);
  EXPECT_EQ(facts.at("stills").at(0).at("file"), "stem-paper.png");
  EXPECT_EQ(facts.at("stills").at(0).at("caption"), "It stands");
  EXPECT_EQ(FilmReader(made.folder / "stem.mp4").info().frames, 13);
  EXPECT_EQ(read_png(made.folder / "stem-poster.png").width, 64);
  EXPECT_FALSE(made.has("stem.report"));
}

// each panel in turn tells the story, and has times of its own
TEST(Products, AFilmOfPanelsInTurnHasThePausesOfAll) {
  const DeckSceneFolder folder("[[story]]\nat = 0.3\nhold = 0.5\ncaption = \"It stands\"\n");
  test::write_text(folder / "turns.toml",
                   "arrange = \"in_turn\"\n[[panel]]\nscene = \"top.toml\"\n"
                   "[[panel]]\nscene = \"top.toml\"\n");
  const Scene turns = load_scene(folder / "turns.toml");
  const DeckScene film{"turns.toml", folder / "turns.toml", turns, scene_hash(turns)};
  const MadeProduct made(film_product(picture_of(PictureKind::film, {}), film, small_settings()));
  ASSERT_EQ(made.facts.at("pauses").size(), 2U);
  EXPECT_NEAR(made.facts.at("pauses").at(1).at(0), 1.8, 1e-12);
  ASSERT_EQ(made.facts.at("stills").size(), 2U);
  EXPECT_EQ(made.facts.at("poster_at"), 1.3);
  const MadeProduct still(
      still_product(picture_of(PictureKind::still, {{"at", "1.6"}}), film, small_settings()));
  EXPECT_EQ(still.facts.at("poster_at"), 1.6);
}

TEST(Products, AFilmShowsTheStillsThatAreAskedFor) {
  const DeckSceneFolder folder;
  const MadeProduct made(film_product(
      picture_of(PictureKind::film, {{"stills", "0.1 0.9"}, {"at", "0.9"}, {"size", "96x54"}}),
      folder.scene,
      small_settings()));
  EXPECT_EQ(made.facts.at("width"), 96) << "the picture's own size";
  ASSERT_EQ(made.facts.at("stills").size(), 2U);
  EXPECT_EQ(made.facts.at("stills").at(0).at("file"), "stem-still-1.png");
  EXPECT_EQ(made.facts.at("stills").at(1).at("file"), "stem-paper.png");
  EXPECT_NE(read_png(made.folder / "stem-still-1.png").pixels,
            read_png(made.folder / "stem-paper.png").pixels);
  EXPECT_TRUE(made.facts.at("pauses").empty());
  // without a story and stills the poster is a third of the way
  const MadeProduct plain(
      film_product(picture_of(PictureKind::film, {{"to", "0.6"}}), folder.scene, small_settings()));
  EXPECT_NEAR(plain.facts.at("poster_at"), 0.2, 1e-12);
  EXPECT_TRUE(plain.facts.at("stills").empty());
}

// stills are for the handout; a poster shows a moment of its film
TEST(Products, ThePosterIsThatOfTheFilm) {
  const DeckSceneFolder folder("[[story]]\nat = 0.3\nhold = 0.5\n");
  const MadeProduct made(film_product(
      picture_of(PictureKind::film, {{"stills", "0.1 0.9"}}), folder.scene, small_settings()));
  EXPECT_EQ(made.facts.at("poster_at"), 0.3);
  const DeckPicture late = picture_of(PictureKind::film, {{"to", "0.4"}, {"at", "0.5"}});
  test::expect_input_error([&] { film_product(late, folder.scene, {}); },
                           "at",
                           "must be a time of the film, 0 to 0.4 s, got 0.5");
}

TEST(Products, AStillIsOnePictureAtItsTime) {
  const DeckSceneFolder folder;
  const MadeProduct made(still_product(
      picture_of(PictureKind::still, {{"at", "0.5"}}), folder.scene, small_settings()));
  EXPECT_EQ(made.facts.at("kind"), "still");
  EXPECT_EQ(made.facts.at("poster"), "stem.png");
  EXPECT_EQ(made.facts.at("poster_at"), 0.5);
  EXPECT_EQ(made.folder.entries(), 2);
  const MadeProduct start(
      still_product(picture_of(PictureKind::still), folder.scene, small_settings()));
  EXPECT_EQ(start.facts.at("poster_at"), 0.0);
  EXPECT_NE(read_png(start.folder / "stem.png").pixels, read_png(made.folder / "stem.png").pixels);
}

// what is printed is white, unless the deck or the command line asks for other colours
TEST(Products, PicturesOnPaperAreInkOnWhite) {
  const DeckSceneFolder folder("[[story]]\nat = 0.3\nhold = 0.5\ncaption = \"It stands\"\n");
  const auto ground = [](const MadeProduct& made, const std::string& key) {
    const Image picture = read_png(made.folder / made.facts.at(key).get<std::string>());
    return color_of_pixel(picture, 0, 0);
  };
  for (const PictureKind kind : {PictureKind::still, PictureKind::film}) {
    const auto product = [&](const DeckPicture& picture, const LectureSettings& settings) {
      return kind == PictureKind::still ? still_product(picture, folder.scene, settings)
                                        : film_product(picture, folder.scene, settings);
    };
    const MadeProduct made(product(picture_of(kind), small_settings()));
    EXPECT_EQ(ground(made, "poster"), ground_of_theme("dark"));
    EXPECT_EQ(ground(made, "paper"), ground_of_theme("print"));
    LectureSettings light = small_settings();
    light.theme = "light";
    for (const Product& one : {product(picture_of(kind, {{"theme", "light"}}), small_settings()),
                               product(picture_of(kind), light)}) {
      EXPECT_NE(one.key, product(picture_of(kind), small_settings()).key);
      const MadeProduct other(one);
      EXPECT_EQ(ground(other, "poster"), ground_of_theme("light"));
      EXPECT_EQ(other.facts.at("paper"), other.facts.at("poster"));
    }
  }
}

TEST(Products, AComparisonIsOneFilm) {
  const DeckSceneFolder folder, other("[show]\ntrail = true\n");
  const DeckPicture picture = picture_of(PictureKind::compare);
  const auto product = [&](const std::vector<DeckScene>& scenes) {
    return compare_product(picture, scenes, small_settings());
  };
  const Product both = product({folder.scene, other.scene});
  EXPECT_NE(both.key, product({other.scene, folder.scene}).key);
  EXPECT_NE(both.key, product({folder.scene, folder.scene}).key);
  const MadeProduct made(both);
  EXPECT_EQ(made.facts.at("kind"), "film");
  EXPECT_EQ(made.facts.at("film"), "stem.mp4");
  EXPECT_TRUE(made.has("stem.mp4"));
  EXPECT_FALSE(made.has("stem.toml")) << "the film file is removed";
  FilmReader film((made.folder / "stem.mp4"));
  EXPECT_EQ(film.info().width, 64);
}

TEST(Products, NumbersAndMotionsAreThoseOfTheScene) {
  const DeckSceneFolder folder;
  const MadeProduct numbers(inspect_product(folder.scene));
  EXPECT_EQ(numbers.facts.at("inspection").at("kind"), "symmetric prolate");
  EXPECT_EQ(numbers.folder.entries(), 0);
  const MadeProduct motion(motion_product(folder.scene));
  EXPECT_EQ(motion.facts.at("csv"), "stem.csv");
  EXPECT_EQ(test::read_text(motion.folder / "stem.csv").rfind("t,qw,", 0), 0U);
}

TEST(Products, ChartsAndMapsArePicturesAndTables) {
  const DeckSceneFolder folder;
  const MadeProduct chart(
      chart_product(picture_of(PictureKind::chart, {{"methods", "rk4"}}), folder.scene));
  const MadeProduct map(stability_product(
      picture_of(PictureKind::stability, {{"methods", "rk4"}, {"cells", "4x3"}, {"turns", "2"}}),
      folder.scene));
  EXPECT_EQ(chart.facts.at("kind"), "chart");
  EXPECT_EQ(map.facts.at("kind"), "stability");
  for (const MadeProduct* made : {&chart, &map}) {
    for (const char* ending : {"svg", "png", "csv"}) {
      EXPECT_EQ(made->facts.at(ending), std::string("stem.") + ending);
      EXPECT_TRUE(made->has(std::string("stem.") + ending));
    }
    EXPECT_EQ(made->folder.entries(), 3);
    EXPECT_NE(made->facts.at("summary").get<std::string>().find("rk4"), std::string::npos);
  }
  const std::string table = test::read_text(map.folder / "stem.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 4 * 3);
}

// the key was made from what the file said before
TEST(Products, ASceneThatChangesDuringTheRunIsAnError) {
  const DeckSceneFolder folder;
  const Product product = inspect_product(folder.scene);
  test::write_text(folder / "top.toml", std::string(test::kSmallScene) + "[show]\ntitle = true\n");
  test::expect_input_error([&] { MadeProduct made(product); }, "", "changed during the run");
}

}  // namespace
}  // namespace polhode
