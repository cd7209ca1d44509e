// SPDX-License-Identifier: MIT
#include "frame/diagram_picture.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/motions.h"

namespace polhode {
namespace {

struct Drawn {
  Motion motion;
  Typesetter typesetter;
  Diagram diagram;
  DiagramPicture picture;

  explicit Drawn(const char* kind, bool free = false, const PixelBox& room = {1094, 95, 826, 470})
      : motion(free ? test::moving(test::brick_body(), test::wobbling())
                    : test::moving(test::cone_body(), test::spinning_on_pivot())),
        diagram(find_diagram(kind)->make(motion)),
        picture(diagram, room, 32.0, make_theme({}), typesetter) {}

  Image at(double t) const {
    Image image;
    image.wipe(1920, 1080, {16, 20, 28, 255}, {});
    std::vector<Stamp> stamps;
    picture.draw(t, stamps);
    for (const Stamp& stamp : stamps)
      lay_over(image, stamp);
    return image;
  }
};

bool is_orange(const Image& image, const LinePoint& at) {
  const std::uint8_t* pixel = image.at(static_cast<int>(at.x), static_cast<int>(at.y));
  return pixel[0] > 200 && pixel[1] > 120 && pixel[1] < 190 && pixel[2] < 80;
}

// half a pixel
TEST(DiagramPicture, PointsAreWhereTheAxesSay) {
  const Drawn drawn("polhode_map", true);
  const PixelBox& axes = drawn.picture.axes();
  const LinePoint middle = drawn.picture.pixel({0.0, 0.0});
  EXPECT_NEAR(middle.x, axes.x + 0.5 * axes.width, 0.5);
  EXPECT_NEAR(middle.y, axes.y + 0.5 * axes.height, 0.5);
  const LinePoint quarter = drawn.picture.pixel({-90.0, 0.5});
  EXPECT_NEAR(quarter.x, axes.x + 0.25 * axes.width, 0.5);
  EXPECT_NEAR(quarter.y, axes.y + 0.25 * axes.height, 0.5);
}

TEST(DiagramPicture, TheDotIsWhereTheMotionIs) {
  for (const char* kind : {"potential", "phase", "polhode_map"}) {
    const Drawn drawn(kind, kind == std::string("polhode_map"));
    for (const double t : {0.0, 0.31, 0.77})
      EXPECT_TRUE(is_orange(drawn.at(t), drawn.picture.pixel(drawn.diagram.now(t)))) << kind << t;
  }
}

// the walls of the valley go up beside the names of the turning points
TEST(DiagramPicture, TheCurveOfThePotentialGoesThroughNoName) {
  for (const PixelBox& room : {PixelBox{1094, 95, 826, 940}, PixelBox{380, 30, 260, 160}}) {
    const Drawn drawn("potential", false, room);
    int names = 0;
    for (const PlacedText& text : drawn.picture.texts()) {
      if (text.markup.rfind("\u03b8", 0) != 0) continue;
      ++names;
      for (const DiagramCurve& curve : drawn.diagram.curves) {
        if (curve.kind != DiagramCurve::Kind::potential) continue;
        for (const Vec2& point : curve.points) {
          const LinePoint at = drawn.picture.pixel(point);
          EXPECT_GT(distance(text.room, {at.x, at.y}), 0.0) << text.markup;
        }
      }
    }
    EXPECT_EQ(names, 2);
  }
}

// also where two points are nearer to each other than their names are long
TEST(DiagramPicture, NamesStandNearestToTheirOwnPoints) {
  const Drawn drawn("potential");
  Diagram narrow = drawn.diagram;
  ASSERT_EQ(narrow.marks.size(), 2U);
  for (int i = 0; i < 12; ++i) {
    narrow.across.high += 10.0;  // and the valley is narrower
    narrow.up.high += 0.1 * (drawn.diagram.up.high - drawn.diagram.up.low);
    const DiagramPicture picture(
        narrow, {1094, 95, 826, 470}, 32.0, make_theme({}), drawn.typesetter);
    for (const PlacedText& text : picture.texts()) {
      const auto away = [&](const DiagramMark& mark) {
        const LinePoint at = picture.pixel(mark.at);
        return distance(text.room, {at.x, at.y});
      };
      for (const int own : {0, 1}) {
        if (text.markup != narrow.marks[own].name) continue;
        EXPECT_LT(away(narrow.marks[own]), away(narrow.marks[1 - own])) << text.markup << ' ' << i;
      }
    }
  }
}

TEST(DiagramPicture, TextStaysInItsRoomAndOffOtherText) {
  for (const int height : {940, 470, 310}) {
    for (const char* kind : {"potential", "phase", "polhode_map"}) {
      const PixelBox room{1094, 95, 826, height};
      const Drawn drawn(kind, kind == std::string("polhode_map"), room);
      const std::vector<PlacedText>& texts = drawn.picture.texts();
      ASSERT_GT(texts.size(), 5U);
      for (std::size_t a = 0; a < texts.size(); ++a) {
        const TextRoom& one = texts[a].room;
        EXPECT_TRUE(one.left >= room.x && one.right <= room.right() && one.top >= room.y &&
                    one.bottom <= room.bottom())
            << kind << ' ' << height << ": " << texts[a].markup;
        for (std::size_t b = a + 1; b < texts.size(); ++b)
          EXPECT_FALSE(overlap(one, texts[b].room))
              << kind << ' ' << height << ": " << texts[a].markup << " and " << texts[b].markup;
      }
    }
  }
}

}  // namespace
}  // namespace polhode
