// SPDX-License-Identifier: MIT
// Whether the last row of a lecture hall can read the films: sizes and places of all text at 1080
// lines, over whole films.
#include <map>

#include <gtest/gtest.h>

#include "film/prepared_film.h"
#include "film/small_films.h"
#include "motion/recorded.h"
#include "scene/scene_file.h"
#include "support/scenes.h"

namespace polhode {
namespace {

using test::scene_names;
using test::scene_path;

constexpr double kLeastType = 28.0;   // px, of 1080 lines
constexpr double kLeastClock = 24.0;  // px
constexpr double kFarthest = 1.5;     // heights of a capital between a name and its tip or leader
constexpr double kLook = 0.1;         // s of film between looks

RenderPlan plan_with_text(Scene scene) {
  scene.video.size = {1920, 1080};
  RenderPlan plan = test::plan_of(scene);
  plan.text = true;
  return plan;
}

void expect_large(const std::vector<PlacedText>& texts) {
  for (const PlacedText& text : texts) {
    const double least = text.role == TextRole::clock ? kLeastClock : kLeastType;
    EXPECT_GE(text.style.size, least) << text.markup;
  }
}

// names keep off arrow heads and stand by their tips, or have a line to them in their own panel
void expect_names_by_their_tips(const PreparedFilm& prepared, const PlacedPage& page) {
  const Typesetter typesetter;
  for (const PlacedText& text : page.texts) {
    if (text.role != TextRole::label) continue;
    for (const TextRoom& mark : page.marks)
      EXPECT_FALSE(overlap(text.room, mark)) << text.markup << " over the head of an arrow";
    if (!text.tip) continue;
    const double letter = typesetter.measure("L", text.style).ink_height();
    if (distance(text.room, *text.tip) <= kFarthest * letter) continue;
    ASSERT_TRUE(text.leader) << text.markup << " is far from its tip";
    EXPECT_EQ(text.leader->opacity, 1.0);
    EXPECT_LT(distance(text.room, text.leader->from), 1.0);
    EXPECT_EQ(text.leader->to, *text.tip);
    for (const FilmPanel& panel : prepared.film().panels()) {
      const PixelBox& place = panel.place;
      const TextRoom around{
          1.0 * place.x, 1.0 * place.y, 1.0 * place.right(), 1.0 * place.bottom()};
      if (!overlap(around, text.room)) continue;
      EXPECT_LT(distance(around, *text.tip), 1e-6) << text.markup << " has its line elsewhere";
    }
  }
}

// the names at some moment, each with its number among equal ones
using Names = std::map<std::string, PlacedText>;
Names names_at(const PreparedFilm& prepared, double now) {
  Names names;
  for (const PlacedText& text : prepared.film().placed(now).texts) {
    if (text.role == TextRole::label && text.tip)
      names[fmt::format("{} {}", text.markup, names.count(text.markup))] = text;
  }
  return names;
}

// from one frame to the next, names stay beside their tips: where they change sides, nobody sees
// them
void expect_no_jump(const Names& before, const Names& here) {
  constexpr double kJump = 25.0;     // px
  constexpr double kVisible = 0.25;  // opacity
  constexpr double kFlies = 30.0;    // px that a tip goes in a frame
  for (const auto& [name, text] : here) {
    const auto found = before.find(name);
    if (found == before.end()) continue;
    const PlacedText& old = found->second;
    const Vec2 flown = *text.whole_tip - *old.whole_tip;
    const Vec2 moved = text.room.center() - old.room.center() - flown;
    // nobody can read what flies
    if (moved.norm() <= kJump || flown.norm() > kFlies) continue;
    EXPECT_LT(std::min(text.opacity, old.opacity), kVisible)
        << name << " by " << moved.norm() << " px";
  }
}

// how many names are pale because they change sides, of those whose vectors are seen
struct Paleness {
  int pale = 0, names = 0;
};
void count_pale(const PreparedFilm& prepared, double now, Paleness& count) {
  constexpr float kSeen = 0.5f;      // opacity that a vector gives its name
  constexpr double kReadable = 0.6;  // part of that
  std::vector<float> given;
  for (const FilmPanel& panel : prepared.film().panels()) {
    for (const SeenLabel& label : panel.composer->label_view(now, panel.end).labels)
      given.push_back(label.fade);
  }
  std::size_t index = 0;
  for (const PlacedText& text : prepared.film().placed(now).texts) {
    if (text.role != TextRole::label) continue;
    ASSERT_LT(index, given.size());
    const float fade = given[index++];
    if (fade < kSeen) continue;
    ++count.names;
    if (text.opacity < kReadable * fade) ++count.pale;
  }
}

class LegibleFilm : public ::testing::TestWithParam<std::string> {};

TEST_P(LegibleFilm, TextIsLargeAndNamesStayByTheirTips) {
  constexpr double kSeconds = 6.0;  // of film, frame by frame
  const Scene scene = load_scene(scene_path(GetParam()));
  const PreparedFilm prepared(plan_with_text(scene));
  const double end = prepared.frames().timeline.film_duration();
  // panels in turn follow one another by cuts
  const double shot = scene.in_turn ? end / static_cast<double>(scene.panels.size()) : end;
  for (double now = 0.0; now <= end; now += kLook) {
    SCOPED_TRACE(testing::Message() << now << " s");
    const PlacedPage page = prepared.film().placed(now);
    expect_large(page.texts);
    expect_names_by_their_tips(prepared, page);
  }
  Names before;
  for (double now = 0.0; now <= std::min(kSeconds, end); now += 1.0 / 60.0) {
    SCOPED_TRACE(testing::Message() << now << " s");
    Names here = names_at(prepared, now);
    const bool cut = std::floor((now + 1e-9) / shot) > std::floor((now - 1.0 / 60.0 + 1e-9) / shot);
    if (!cut) expect_no_jump(before, here);
    before = std::move(here);
  }
}

// a still at any moment shows its names
TEST_P(LegibleFilm, NamesAreSeldomPale) {
  constexpr double kMostPale = 0.1;
  const Scene scene = load_scene(scene_path(GetParam()));
  if (scene.in_turn) GTEST_SKIP() << "its panels follow one another";
  const PreparedFilm prepared(plan_with_text(scene));
  Paleness count;
  for (double now = 0.0; now <= prepared.frames().timeline.film_duration(); now += kLook)
    count_pale(prepared, now, count);
  EXPECT_LE(count.pale, kMostPale * count.names) << count.pale << " of " << count.names;
}

INSTANTIATE_TEST_SUITE_P(Scenes,
                         LegibleFilm,
                         ::testing::ValuesIn(scene_names()),
                         [](const auto& row) { return row.param; });

// They stand around their rims, where they do not cover the body, and do not jump.
TEST(LegibleCones, NamesStandBesideTheBody) {
  constexpr double kMostOver = 0.05;
  constexpr double kJump = 25.0;     // px
  constexpr double kVisible = 0.25;  // opacity
  for (const char* name : {"feynman_plate", "free_symmetric_top", "free_symmetric_top_oblate"}) {
    const PreparedFilm prepared(plan_with_text(load_scene(scene_path(name))));
    const FilmPanel& panel = prepared.film().panels().front();
    std::map<std::string, PlacedText> before;
    int names = 0, over = 0;
    const double end = std::min(6.0, prepared.frames().timeline.film_duration());
    for (double now = 0.0; now <= end; now += 1.0 / 60.0) {
      const LabelView view = panel.composer->label_view(now, panel.end);
      ASSERT_FALSE(view.body.empty()) << name;
      for (const PlacedText& text : prepared.film().placed(now).texts) {
        if (text.role != TextRole::label || !text.markup.ends_with("cone")) continue;
        ++names;
        if (overlap(text.room, view.body)) ++over;
        const auto found = before.find(text.markup);
        if (found != before.end() &&
            (found->second.room.center() - text.room.center()).norm() > kJump) {
          EXPECT_LT(std::min(text.opacity, found->second.opacity), kVisible) << name << ' ' << now;
        }
        before[text.markup] = text;
      }
    }
    EXPECT_GT(names, 100) << name;
    EXPECT_LE(over, kMostOver * names) << name;
  }
}

// each quantity alone, and as many plots as fit, six
TEST(LegiblePlots, TextIsLarge) {
  std::vector<std::vector<std::string>> stacks;
  for (const std::string& name : recorded_names())
    stacks.push_back({name});
  for (std::size_t count = 2; count <= 6; ++count)
    stacks.emplace_back(count, "energy");
  stacks.push_back({"polhode_map"});
  stacks.push_back({"polhode_map", "polhode_map"});
  stacks.push_back({"polhode_map", "energy", "omega"});
  const Solved small = solve(test::small_scene());
  for (const std::vector<std::string>& plots : stacks) {
    SCOPED_TRACE(testing::Message() << plots.size() << " of " << plots.front());
    const Recorded* quantity = find_recorded(plots.front());
    const bool of_a_table =
        quantity != nullptr && !why_not(*quantity, small.simulation.motion).empty();
    Scene scene = of_a_table ? load_scene(test::scene_path("billiard_ball")) : test::small_scene();
    scene.show.plots = plots;
    expect_large(PreparedFilm(plan_with_text(scene)).film().placed(0.5).texts);
  }
}

}  // namespace
}  // namespace polhode
