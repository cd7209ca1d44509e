// SPDX-License-Identifier: MIT
// Key frames, chapters and captions of a story, in frames of the film.
#include "film/film_metadata.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

StoryStep step(double at, double hold, const std::optional<std::string>& caption) {
  StoryStep made;
  made.at = at;
  made.hold = hold;
  made.caption = caption;
  return made;
}

struct Case {
  Scene scene;
  FrameTimes frames;

  explicit Case(const std::vector<StoryStep>& story, double first = 0.0, int count = 70) {
    scene.title = "Title";
    scene.story = story;
    frames.timeline = Timeline(story, 4.0, 1.0);
    frames.rate = 10.0;
    frames.first = first;
    frames.count = count;
  }
  Case& with_shot_at(double at) {
    ShotSpec shot;
    shot.name = "From above";
    shot.at = at;
    scene.shots = {shot};
    return *this;
  }
  FilmMetadata metadata() const { return film_metadata(scene, scene.story, frames); }
};

// 4 s of motion, held for 2 s at 1 s and for 1 s at 3 s
const std::vector<StoryStep> kStory = {
    step(0.0, 0.0, "One"), step(1.0, 2.0, "Two\nlines"), step(2.0, 0.0, ""), step(3.0, 1.0, {})};

TEST(FilmMetadata, KeyFramesWhereTheStoryPausesGoesOnAndSpeaks) {
  const FilmMetadata metadata = Case(kStory).metadata();
  EXPECT_EQ(metadata.frames, 70);
  EXPECT_EQ(metadata.key_frames, (std::vector<int>{10, 30, 50, 60}));
}

TEST(FilmMetadata, ChaptersAreStepsAndNamedShots) {
  const FilmMetadata metadata = Case(kStory).with_shot_at(2.0).metadata();
  ASSERT_EQ(metadata.chapters.size(), 4u);
  EXPECT_EQ(metadata.chapters[0].title, "One");
  EXPECT_EQ(metadata.chapters[1].start, 10);
  EXPECT_EQ(metadata.chapters[1].title, "Two lines");
  EXPECT_EQ(metadata.chapters[2].start, 40);
  EXPECT_EQ(metadata.chapters[2].title, "From above");
  EXPECT_EQ(metadata.chapters[3].start, 50);
  EXPECT_EQ(metadata.chapters[3].title, "Pause at 3 s");
}

// a shot begins behind the pause at its time, and has its chapter there
TEST(FilmMetadata, AShotAtAPauseFollowsIt) {
  const FilmMetadata metadata = Case(kStory).with_shot_at(1.0).metadata();
  ASSERT_EQ(metadata.chapters.size(), 4u);
  EXPECT_EQ(metadata.chapters[1].title, "Two lines");
  EXPECT_EQ(metadata.chapters[2].start, 30);
  EXPECT_EQ(metadata.chapters[2].title, "From above");
}

// of several words in one frame those are the chapter's that are seen
// of shots that begin before the next frame the last one is seen, whatever their order in the scene
TEST(FilmMetadata, ChaptersAreOfShotsThatAreSeen) {
  const auto titles = [](const std::vector<std::pair<double, std::string>>& shots) {
    Case one({});
    for (const auto& [at, name] : shots) {
      ShotSpec shot;
      shot.at = at;
      shot.name = name;
      one.scene.shots.push_back(shot);
    }
    std::string all;
    for (const FilmMetadata::Chapter& chapter : one.metadata().chapters)
      all += fmt::format("{} {}|", chapter.start, chapter.title);
    return all;
  };
  EXPECT_EQ(titles({{1.01, "side"}, {1.02, "top"}, {2.0, "end"}}), "0 Title|11 top|20 end|");
  EXPECT_EQ(titles({{1.0, "one"}, {1.0, "two"}}), "0 Title|10 two|");
  EXPECT_EQ(titles({{1.02, ""}, {1.01, "side"}, {2.0, "end"}}), "0 Title|20 end|");
}

TEST(FilmMetadata, ChaptersHaveTheWordsOfTheirFrame) {
  const auto titles = [](const std::vector<StoryStep>& story) {
    std::vector<std::string> found;
    for (const FilmMetadata::Chapter& chapter : Case(story).metadata().chapters)
      found.push_back(chapter.title);
    return found;
  };
  using Titles = std::vector<std::string>;
  EXPECT_EQ(titles({step(1.0, 0.0, "first"), step(1.0, 0.0, "second")}),
            (Titles{"Title", "second"}));
  EXPECT_EQ(titles({step(0.92, 0.0, "first"), step(0.95, 0.0, "second")}),
            (Titles{"Title", "second"}));
  EXPECT_EQ(titles({step(1.0, 0.0, "first"), step(1.0, 0.0, "")}), Titles{});
  EXPECT_EQ(titles({step(1.0, 0.0, "first"), step(1.0, 0.5, "")}),
            (Titles{"Title", "Pause at 1 s"}));
  EXPECT_EQ(titles({step(1.0, 0.0, "  \n")}), Titles{});
}

TEST(FilmMetadata, CaptionsLastUntilTheNextWords) {
  const FilmMetadata metadata = Case(kStory).metadata();
  ASSERT_EQ(metadata.captions.size(), 2u);
  EXPECT_EQ(metadata.captions[0].start, 0);
  EXPECT_EQ(metadata.captions[0].end, 10);
  EXPECT_EQ(metadata.captions[1].words, "Two\nlines");
  EXPECT_EQ(metadata.captions[1].end, 40) << "empty words end them";
}

// a piece from the middle keeps what holds at its start
TEST(FilmMetadata, APieceCountsFromItsOwnFirstFrame) {
  const FilmMetadata metadata = Case(kStory, 2.0, 30).metadata();
  ASSERT_EQ(metadata.captions.size(), 1u);
  EXPECT_EQ(metadata.captions[0].start, 0);
  EXPECT_EQ(metadata.captions[0].end, 20);
  EXPECT_EQ(metadata.key_frames, (std::vector<int>{10}));
  ASSERT_EQ(metadata.chapters.size(), 1u);
  EXPECT_EQ(metadata.chapters[0].start, 0);
  EXPECT_EQ(metadata.chapters[0].title, "Two lines");
}

TEST(FilmMetadata, WithoutAStoryThereIsNothing) {
  const FilmMetadata metadata = Case({}, 0.0, 40).metadata();
  EXPECT_TRUE(metadata.key_frames.empty());
  EXPECT_TRUE(metadata.chapters.empty());
  EXPECT_TRUE(metadata.captions.empty());
}

}  // namespace
}  // namespace polhode
