// SPDX-License-Identifier: MIT
#include "app/commands/new_scene.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "film/prepared_film.h"
#include "support/expect_error.h"
#include "support/full_disk.h"
#include "support/run.h"

namespace polhode {

// how a kind is called in the names of its tests
void PrintTo(const NewKind& kind, std::ostream* out) {
  *out << kind.name;
}

namespace {

class NewScene : public ::testing::TestWithParam<NewKind> {
 protected:
  test::TemporaryFolder folder_;
};

// a scene that somebody begins with must be right: trusted, complete, without a warning
TEST_P(NewScene, CanBeFilmedAsItIs) {
  const std::string first =
      folder_ / ("a" + std::filesystem::path(GetParam().files[0]).extension().string());
  const std::string next = write_new(GetParam().name, first);
  EXPECT_NE(next.find("next: polhode "), std::string::npos);
  EXPECT_EQ(folder_.entries(), static_cast<long>(GetParam().files.size()));
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
    if (entry.path().extension() != ".toml") continue;
    RenderJob job;
    job.scene = entry.path();
    job.output = folder_ / "a.png";
    job.still = 1.0;
    const PreparedFilm film(plan_render(job));
    EXPECT_TRUE(film.solved().simulation.report.reliability.doubts.empty());
    for (const FilmPanel& panel : film.film().panels())
      EXPECT_TRUE(panel.composer->warnings().empty());
  }
}

// each key that is commented out may be put in; but moments stand for the solid before them
TEST_P(NewScene, WhatItProposesIsTaken) {
  const std::string& text = template_files().at(GetParam().files[0]);
  if (!std::string_view(GetParam().files[0]).ends_with(".toml")) return;
  write_new(GetParam().name, folder_ / "first.toml");
  for (std::size_t at = 0; (at = text.find("\n# ", at)) != std::string::npos; ++at) {
    const std::size_t key = at + 3;
    const std::size_t end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", key);
    if (text.compare(end, 3, " = ") != 0 || text.substr(key, end - key) == "moments") continue;
    SCOPED_TRACE(text.substr(key, text.find('\n', key) - key));
    test::write_text(folder_ / "a.toml", text.substr(0, at + 1) + text.substr(key));
    RenderJob job;
    job.scene = folder_ / "a.toml";
    job.output = folder_ / "a.png";
    job.still = 0.0;
    EXPECT_NO_THROW(PreparedFilm(plan_render(job)));
  }
}

TEST_P(NewScene, NothingIsReplaced) {
  const std::string ending = std::filesystem::path(GetParam().files[0]).extension().string();
  const std::string first = folder_ / ("mine" + ending);
  test::write_text(first, "my own");
  test::expect_input_error(
      [&] { write_new(GetParam().name, first); }, "--output", "is already there");
  EXPECT_EQ(test::read_text(first), "my own");
  EXPECT_EQ(folder_.entries(), 1);
}

// a disk that is full after the first of two files
TEST(NewKinds, AllFilesOrNone) {
  const test::TemporaryFolder folder;
  constexpr rlim_t kMoreThanTheFirst = 1024;
  EXPECT_EQ(
      test::with_full_disk(kMoreThanTheFirst, [&] { write_new("film", folder / "film.toml"); }),
      test::Outcome::environment);
  EXPECT_EQ(folder.entries(), 0);
}

// a name that polhode would not take, or that the scene beside it needs; and a scene that was there
TEST(NewKinds, NamesThatDoNotGo) {
  const test::TemporaryFolder folder;
  const auto refused = [&](const char* kind, const char* name, const char* words) {
    test::expect_input_error([&] { write_new(kind, folder / name); }, "--output", words);
  };
  refused("deck", "deck.toml", "the name of a deck ends in .md");
  refused("heavy_top", "-", "the name of a heavy_top ends in .toml");
  refused("film", "heavy_top.toml", "the scene of the film is called heavy_top.toml");
  EXPECT_EQ(folder.entries(), 0);
  write_new("deck", folder / "deck.md");
  EXPECT_NE(write_new("film", folder / "a film.toml")
                .find("heavy_top.toml that was there); next: polhode render '"),
            std::string::npos);
  // what the film says would not be true of another scene
  test::write_text(folder / "heavy_top.toml", "my own");
  refused("film", "film.toml", "is not the scene that the film needs");
  EXPECT_EQ(folder.entries(), 3);
}

INSTANTIATE_TEST_SUITE_P(Kinds, NewScene, ::testing::ValuesIn(new_kinds()), [](const auto& row) {
  return std::string(row.param.name);
});

TEST(NewKinds, AnUnknownOneGetsTheNearestName) {
  test::expect_input_error([] { write_new("hevy_top", ""); }, "new", "did you mean 'heavy_top'?");
}

TEST(NewKinds, HaveAllTemplates) {
  std::size_t used = 0;
  for (const auto& [name, text] : template_files()) {
    const bool is_used =
        std::any_of(new_kinds().begin(), new_kinds().end(), [&, file = name](const NewKind& kind) {
          return std::find(kind.files.begin(), kind.files.end(), file) != kind.files.end();
        });
    EXPECT_TRUE(is_used) << name;
    used += is_used ? 1 : 0;
  }
  EXPECT_GT(used, 0u);
}

}  // namespace
}  // namespace polhode
