// SPDX-License-Identifier: MIT
#include "frame/film.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/motions.h"

namespace polhode {
namespace {

// the same body and camera for other motions: what differs between panels is the motion alone
TEST(Film, PanelsShareCameraAndScale) {
  const BodySpec body = test::prolate_body();
  const Motion one = test::moving(body, test::wobbling());
  MotionSpec faster = test::wobbling();
  faster.spin.body = Vec3(2.2, 0.8, 4.0);
  const Composer first(one, body, CameraSpec{}, {}, {}, {320, 180});
  const Composer second(first, test::moving(body, faster));
  const Vec3 point(0.1, 0.05, 0.2);
  EXPECT_EQ(first.camera().project(point), second.camera().project(point));
  EXPECT_EQ(first.scenery().scale.omega, second.scenery().scale.omega);
  const Sample now = second.scenery().motion.at(0.0);
  EXPECT_NEAR((omega_tip(second.scenery(), now) - now.reference_S).norm(),
              2.0 * (omega_tip(first.scenery(), one.at(0.0)) - one.at(0.0).reference_S).norm(),
              1e-9);
}

// a motion that blows up is drawn as far as single precision goes
TEST(Film, TipsOfVectorsStayDrawable) {
  const BodySpec body = test::prolate_body();
  MotionSpec wild = test::wobbling();
  *wild.spin.body *= 1e9;
  wild.duration = 1e-12;
  const Composer tame(test::moving(body, test::wobbling()), body, CameraSpec{}, {}, {}, {320, 180});
  const Composer picture(tame, test::moving(body, wild));
  const Sample now = picture.scenery().motion.at(0.0);
  const double size = picture.scenery().scale.body;
  for (const Vec3& tip : {omega_tip(picture.scenery(), now), momentum_tip(picture.scenery(), now)})
    EXPECT_NEAR((tip - now.reference_S).norm(), 50.0 * size, 1e-9 * size);
  for (const Cone& cone : picture.glyphs_at(now).cones)
    EXPECT_NEAR(cone.slant, 50.0 * size, 1e-9 * size);
}

// two panels side by side, with everything that can be laid over them
Film two_panels() {
  const BodySpec body = test::prolate_body();
  FilmText text;
  text.title = "Title";
  text.caption = "Words";
  std::vector<FilmPanel> panels;
  for (const PixelBox& place : frame_areas(text, {640, 180}, 2, 0).panels) {
    FilmPanel panel;
    panel.place = place;
    panel.composer = std::make_shared<const Composer>(test::moving(body, test::wobbling()),
                                                      body,
                                                      CameraSpec{},
                                                      ShowSpec{},
                                                      ThemeSpec{},
                                                      PictureSize{place.width, place.height});
    panel.end = 4.0;
    panels.push_back(panel);
  }
  return {panels, text, {640, 180}};
}

TEST(Film, ABarePictureIsThePictureWithoutStamps) {
  const Film film = two_panels();
  const Picture whole = film.at(1.3);
  const Picture bare = film.bare_at(1.3);
  EXPECT_FALSE(whole.stamps.empty());
  EXPECT_TRUE(bare.stamps.empty());
  ASSERT_EQ(bare.panels.size(), whole.panels.size());
  for (std::size_t i = 0; i < bare.panels.size(); ++i) {
    const DrawList& a = whole.panels[i].list;
    const DrawList& b = bare.panels[i].list;
    EXPECT_EQ(bare.panels[i].place, whole.panels[i].place);
    EXPECT_EQ(b.view.clip_from_world, a.view.clip_from_world);
    EXPECT_EQ(b.background, a.background);
    ASSERT_EQ(b.opaque.size(), a.opaque.size());
    ASSERT_EQ(b.translucent.size(), a.translucent.size());
    for (std::size_t k = 0; k < a.opaque.size(); ++k)
      EXPECT_EQ(b.opaque[k].world_from_mesh, a.opaque[k].world_from_mesh);
  }
}

// the same bytes of text for a frame drawn alone, or after all those before it
TEST(Film, TextIsNoFunctionOfWhatWasDrawnBefore) {
  const Film film = two_panels();
  for (double t = 0.0; t < 2.0; t += 1.0 / 60.0)
    static_cast<void>(film.at(t));
  const Picture after = film.at(2.0);
  const Picture alone = two_panels().at(2.0);
  ASSERT_EQ(after.stamps.size(), alone.stamps.size());
  for (std::size_t i = 0; i < alone.stamps.size(); ++i) {
    EXPECT_EQ(after.stamps[i].x, alone.stamps[i].x);
    EXPECT_EQ(after.stamps[i].y, alone.stamps[i].y);
    EXPECT_EQ(after.stamps[i].sprite->width, alone.stamps[i].sprite->width);
    EXPECT_EQ(after.stamps[i].sprite->pixels, alone.stamps[i].sprite->pixels);
  }
}

// behind its end a panel stands still while the clock goes on
TEST(Film, APanelStandsStillBehindItsEnd) {
  const BodySpec body = test::prolate_body();
  FilmPanel panel;
  panel.place = {0, 0, 320, 180};
  panel.composer = std::make_shared<const Composer>(test::moving(body, test::wobbling()),
                                                    body,
                                                    CameraSpec{},
                                                    ShowSpec{},
                                                    ThemeSpec{},
                                                    PictureSize{320, 180});
  panel.end = 1.0;
  panel.rows = {true, true, true, 0};
  panel.notes = [](double t) {
    return PanelNotes{"a <b>", "line", {}, t > 1.0 ? "ended" : ""};
  };
  const Film film({panel}, FilmText{}, {320, 180});
  const Picture at_end = film.at(1.0);
  const Picture later = film.at(2.0);
  for (std::size_t i = 0; i < at_end.panels[0].list.opaque.size(); ++i) {
    EXPECT_EQ(at_end.panels[0].list.opaque[i].world_from_mesh,
              later.panels[0].list.opaque[i].world_from_mesh);
  }
  EXPECT_EQ(later.stamps.size(), at_end.stamps.size() + 2);  // a badge and its words
}

// a film by a camera that looks beside the body, above which it stands
Film beside_the_body(bool with_notes) {
  const BodySpec body = test::prolate_body();
  CameraSpec camera;
  camera.eye = Vec3(5, 0, 0);
  camera.target = Vec3(0, 0, -4);
  FilmPanel panel;
  panel.place = {0, 0, 640, 360};
  panel.composer = std::make_shared<const Composer>(test::moving(body, test::wobbling()),
                                                    body,
                                                    camera,
                                                    ShowSpec{},
                                                    ThemeSpec{},
                                                    PictureSize{640, 360});
  panel.end = 4.0;
  if (with_notes) {
    panel.rows.name = true;
    panel.notes = [](double) {
      return PanelNotes{"name", {}, {}, {}};
    };
  }
  return {{panel}, FilmText{}, {640, 360}};
}

TEST(Film, AChevronPointsToABodyOutsideThePicture) {
  const Film film = beside_the_body(false);
  const std::optional<Vec2> way = film.panels()[0].composer->camera_view(1.0, 4.0).way_to_body;
  ASSERT_TRUE(way);
  EXPECT_LT(way->y(), -0.99);
  const PlacedPage page = film.placed(1.0);
  const auto chevrons =
      std::count_if(page.rooms.begin(), page.rooms.end(), [](const TextRoom& room) {
        return std::abs(room.center().x() - 320.0) < 5.0 && room.top > 0.0 && room.bottom < 60.0;
      });
  EXPECT_EQ(chevrons, 1);
  for (const PlacedText& text : page.texts)
    EXPECT_NE(text.role, TextRole::note) << "a film by itself has no notes";
}

TEST(Film, APanelSaysThatItsBodyIsOut) {
  const Film film = beside_the_body(true);
  const PlacedPage page = film.placed(1.0);
  std::vector<PlacedText> notes;
  for (const PlacedText& text : page.texts)
    if (text.role == TextRole::note) notes.push_back(text);
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[1].markup, "the body is out of the picture");
  EXPECT_GE(notes[1].style.size, 28.0 / 1080.0 * 360.0);
  for (std::size_t i = 0; i < page.rooms.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(overlap(page.rooms[i], page.rooms[j])) << i << ' ' << j;
  }
}

TEST(Film, ABodyInThePictureNeedsNoChevron) {
  EXPECT_FALSE(two_panels().panels()[0].composer->camera_view(1.0, 4.0).way_to_body);
}

}  // namespace
}  // namespace polhode
