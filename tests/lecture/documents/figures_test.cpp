// SPDX-License-Identifier: MIT
#include "lecture/documents/figures.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

DeckPicture picture_of(PictureKind kind, const std::string& alt) {
  DeckPicture picture;
  picture.kind = kind;
  picture.name = "n";
  picture.scenes = {"s.toml"};
  picture.settings["alt"] = alt;
  return picture;
}

// pandoc writes titles of pictures into PowerPoint as their descriptions
TEST(Figures, PicturesInOfficeAreDescribed) {
  const DeckPicture picture = picture_of(PictureKind::still, "A top that leans");
  const Json facts = {{"poster", "p.png"}, {"paper", "q.png"}, {"poster_at", 0.0}};
  const Json blocks = office_blocks({&picture, facts, ""});
  const Json target = blocks[0]["c"][0]["c"][2];
  EXPECT_EQ(target, Json::array({"media/p.png", "A top that leans"})) << blocks.dump();
  // in notes, which are words, it stands beside a caption
  EXPECT_EQ(blocks[0]["c"][0]["c"][0][2], Json::array({Json::array({"alt", "A top that leans"})}));
}

TEST(Figures, HostileWordsAreEscaped) {
  const DeckPicture picture = picture_of(PictureKind::film, "\"><script>alert(1)</script>");
  const Json facts = {{"film", "a\"b.mp4"},
                      {"poster", "p<.png"},
                      {"paper", "q<.png"},
                      {"poster_at", 0.0},
                      {"stills", Json::array()},
                      {"vtt", "WEBVTT\n\n<script>"},
                      {"pauses", Json::array()},
                      {"frames", 10},
                      {"fps", 30.0},
                      {"width", 64},
                      {"height", 36},
                      {"title", "</p><script>x</script>"}};
  const Figure figure{&picture, facts, ""};
  for (const Json& blocks : {page_blocks(figure), slide_blocks(figure), handout_blocks(figure)}) {
    const std::string text = blocks.dump();
    EXPECT_EQ(text.find("<script"), std::string::npos) << text;
    EXPECT_EQ(text.find("p<.png"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace polhode
