// SPDX-License-Identifier: MIT
#include "lecture/documents/office_slides.h"

#include <gtest/gtest.h>

#include "lecture/decks.h"
#include "lecture/documents/office_lists.h"

namespace polhode {
namespace {

using test::deck_of;

constexpr const char* kTable = "| a | b |\n|---|---|\n| c | d |\n";

// "2" for a title of that level, "-" for a rule, "w" for words, "f" for a picture or a table, and
// columns as (wf)
std::string shape_of(const Json& blocks) {
  std::string shape;
  for (const Json& block : blocks) {
    const std::string type = block["t"];
    if (type == "Header") {
      shape += std::to_string(block["c"][0].get<int>());
    } else if (type == "HorizontalRule") {
      shape += "-";
    } else if (is_div(block, "columns")) {
      shape += "(";
      for (const Json& column : block["c"][1])
        shape += shape_of(column["c"][1]);
      shape += ")";
    } else {
      shape +=
          type == kPictureNode || type == "Table" || block.dump().find("Image") < 200 ? "f" : "w";
    }
  }
  return shape;
}

std::string shape(const std::string& text) {
  Deck deck = deck_of(text);
  // in place of a file
  for_each_node(deck.blocks, [](Json& node) {
    if (node["t"] != "Str" || node["c"] != "IMAGE") return;
    node = {
        {"t", "Image"},
        {"c",
         {Json::array({"", Json::array(), Json::array()}), Json::array(), {"media/a.png", ""}}}};
  });
  return shape_of(office_slides(deck).blocks);
}

TEST(OfficeSlides, HaveWordsBesideOneFigure) {
  const std::string picture = "![Cap](s.toml){.still}\n\n", table = kTable + std::string("\n");
  EXPECT_EQ(shape("# Part\n\n## One\n\nWords.\n\n" + picture), "12(wf)");
  EXPECT_EQ(shape("## One\n\n" + picture + "Words.\n"), "2(wf)");
  EXPECT_EQ(shape("## One\n\n" + picture), "2f");
  EXPECT_EQ(shape("## One\n\n" + picture + table + "Words.\n"), "2f2(wf)");
  EXPECT_EQ(shape("## One\n\n" + table + "Words.\n\n" + picture + "More.\n"), "2(wf)2(wf)");
  EXPECT_EQ(shape("## One\n\n### Two\n\nWords.\n"), "23w");
  EXPECT_EQ(shape("# Part\n\n" + picture + picture), "12f2f");
  EXPECT_EQ(shape(picture + picture), "f-f");
}

TEST(OfficeSlides, HaveTwoColumns) {
  const std::string one = "::: column\nA\n:::\n\n",
                    mixed = "::: column\nA\n\n![Cap](s.toml){.still}\n:::\n\n";
  EXPECT_EQ(shape("## One\n\n:::: columns\n" + one + one + "::::\n"), "2(ww)");
  EXPECT_EQ(shape("## One\n\n:::: columns\n" + one + one + one + "::::\n"), "2(ww)2w");
  EXPECT_EQ(shape("## One\n\n:::: {.columns .fragment}\n" + one +
                  "::: {.column .incremental}\nB\n:::\n\n" + one + "::::\n"),
            "2(ww)2w");
  EXPECT_EQ(shape("## One\n\n:::: columns\n::: column\n" + std::string(kTable) + ":::\n::::\n"),
            "2f");
  EXPECT_EQ(shape("## One\n\n:::: columns\n" + one + "::: column\nA\n\n* * *\n\nB\n:::\n::::\n"),
            "2ww-w");
  const std::string image = "::: column\nIMAGE\n:::\n\n";
  EXPECT_EQ(shape("## One\n\n:::: columns\n" + image + image + "::::\n"), "2(ff)");
  EXPECT_EQ(shape("## One\n\nB\n\n:::: columns\n" + one + one + "::::\n\nC\n"), "2w2(ww)2w");
  EXPECT_EQ(shape("## One\n\n:::: columns\n" + mixed + one + "::::\n"), "2(wwf)");
}

// where PowerPoint would have their captions alone
TEST(OfficeSlides, HavePicturesOutOfListsAndQuotations) {
  for (const char* around :
       {"- A\n\n  ![Cap](s.toml){.still}\n", "> A\n>\n> ![Cap](s.toml){.still}\n"})
    EXPECT_EQ(shape("## One\n\n" + std::string(around)), "2(wf)") << around;
  EXPECT_EQ(shape("## One\n\n::: box\nA\n\n![Cap](s.toml){.still}\n:::\n"), "2w2f");
}

TEST(OfficeSlides, HaveTablesAndTitlesOutOfWhatIsAround) {
  EXPECT_EQ(shape("## One\n\n- A\n\n  | a | b |\n  |---|---|\n  | c | d |\n"), "2(wf)");
  EXPECT_EQ(shape("## IMAGE\n\nB\n"), "-(wf)");
  EXPECT_EQ(shape("## A IMAGE\n\nB\n"), "2(wf)");
  EXPECT_EQ(shape("# {#a}\n\n[B](#a)\n"), "-w");
  EXPECT_EQ(shape("## One\n\n![Cap](s.toml){.still}\n\n### Two\n\n![Cap](s.toml){.still}\n"),
            "2f2(3f)");
  EXPECT_EQ(shape("## One\n\n::: box\n![Cap](s.toml){.still}\n:::\n"), "2f");
  EXPECT_EQ(shape("## One\n\n| a | b |\n|---|---|\n| IMAGE | d |\n"), "2f2f");
}

// the blocks of a deck as PowerPoint gets them, "1" to "9" for the first number of a list, "_" for
// an empty line, "w" for other words, and what is in a box in brackets
std::string numbers_of(const Json& blocks) {
  std::string numbers;
  for (const Json& block : blocks) {
    const std::string type = block["t"];
    if (type == "OrderedList") {
      numbers += std::to_string(block["c"][0][0].get<int>());
      for (const Json& item : block["c"][1])
        numbers += item.size() > 1 ? "(" + numbers_of(item) + ")" : "";
    } else if (type == "Div") {
      numbers += "[" + numbers_of(block["c"][1]) + "]";
    } else if (type == "BlockQuote") {
      numbers += ">" + numbers_of(block["c"]);
    } else if (type != "Header") {
      numbers += plain_text(block["c"]) == "\u00a0" ? "_" : "w";
    }
  }
  return numbers;
}

// PowerPoint counts on where paragraphs with numbers follow each other
TEST(OfficeSlides, HaveListsThatBeginAgain) {
  const auto numbers = [](const std::string& text) {
    Json blocks = office_slides(deck_of("## A\n\n" + text)).blocks;
    settle_numbers_of_lists(blocks);
    return numbers_of(blocks);
  };
  const std::string list = "1. a\n2. b\n\n";
  EXPECT_EQ(numbers(list + "c\n\n" + list), "1w1");
  EXPECT_EQ(numbers(list + "::: notes\nd\n:::\n\n" + list), "1_1[w]");
  EXPECT_EQ(numbers(list + "![e](s.toml){.still}\n\n" + list),
            "[[1_1]["
            "w]]");
  EXPECT_EQ(numbers("> 1. a\n> 2. b\n\n" + list), ">1_1");
  EXPECT_EQ(numbers("::: incremental\n" + list + ":::\n\n" + list), "[1]_1");
  EXPECT_EQ(numbers(list + "::: incremental\n" + list + "\n\nc\n\n" + list + ":::\n\n"), "1_[1w1]");
  EXPECT_EQ(numbers(list + "::: notes\nd\n:::\n\n3. c\n"), "13[w]");
  EXPECT_EQ(numbers("1. a\n\n    1. b\n\n    c\n\n    1. d\n2. e\n"), "1(w1w1)");
  const std::string columns = "::: column\n" + list + ":::\n";
  EXPECT_EQ(numbers(":::: columns\n" + columns + columns + "::::\n"), "[[1][1]]");
}

TEST(OfficeSlides, HaveNumbersThatPowerPointDoesNotCount) {
  const auto words = [](const std::string& text) {
    Json blocks = office_slides(deck_of(text)).blocks;
    settle_numbers_of_lists(blocks);
    std::string all;
    for_each_node(blocks, [&](const Json& node) {
      if (node["t"] == "Para" || node["t"] == "Plain") all += plain_text(node["c"]) + "|";
      if (node["t"] == "OrderedList" || node["t"] == "BulletList") all += "#";
    });
    return all;
  };
  EXPECT_EQ(words("0. a\n1. b\n"), "0. a|1. b|");
  EXPECT_EQ(words("32768) a\n"), "32768) a|");
  EXPECT_EQ(words("32767. a\n"), "#a|");
  EXPECT_EQ(words("| b |\n|---|\n| c^[0. a] |\n"), "b|c0. a|0. a|");
  // items without words of their own
  EXPECT_EQ(words("1. a\n2. - b\n3. c\n"), "1. a|2. |#b|3. c|");
  EXPECT_EQ(words("1.\n2.\n3. c\n"), "1. |2. |3. c|");
  std::string deep;
  for (int level = 0; level < 11; ++level)
    deep += std::string(static_cast<std::size_t>(4 * level), ' ') + "- a\n";
  EXPECT_EQ(words(deep), "#a|#a|#a|#a|#a|#a|#a|#a|#a|• a|• a|");
  EXPECT_EQ(words("::: notes\n3. a\n4. b\n\n   c) d\n:::\n"), "3. a|4. b|c) d|");
  EXPECT_EQ(words("::: notes\n(xiv) a\n(xv) b\n:::\n"), "(xiv) a|(xv) b|");
  EXPECT_EQ(words("::: notes\nZ.  a\nAA. b\n:::\n"), "Z. a AA. b|");
}

TEST(OfficeSlides, HaveNotesOutOfLists) {
  const OfficeSlides slides =
      office_slides(deck_of("## One\n\n- A\n\n  ::: notes\n  Say this.\n  :::\n"));
  ASSERT_EQ(slides.blocks.size(), 3U) << slides.blocks.dump();
  EXPECT_EQ(slides.blocks[2]["c"][0][1], Json::array({"notes"}));
  EXPECT_EQ(slides.blocks[1].dump().find("Say"), std::string::npos);
}

// the inner ones follow the outer
TEST(OfficeSlides, HaveNoColumnsInColumns) {
  EXPECT_EQ(shape("## One\n\n:::::: columns\n::::: column\nA\n\n:::: columns\n::: column\nB\n:::\n"
                  "::: column\nC\n:::\n::::\n\nD\n:::::\n::::: column\nE\n:::::\n::::::\n"),
            "2w2(ww)2ww");
}

TEST(OfficeSlides, AreWhereLinksToTheirPlacesLead) {
  const OfficeSlides slides =
      office_slides(deck_of("## One\n\n![A](s.toml){#a .still}\n\n![B](s.toml){#b .still}\n\n"
                            "## Two\n\n![C](s.toml){#c .still}\n\n- [words]{#d}\n"));
  EXPECT_EQ(slides.titles.at("a"), "one");
  EXPECT_EQ(slides.titles.at("b"), "slide-again-1");
  EXPECT_EQ(slides.titles.at("c"), "two");
  EXPECT_EQ(slides.titles.at("d"), "two");
}

// around pictures and tables, which pandoc takes out of boxes
TEST(OfficeSlides, AreWhereLinksToTheirBoxesLead) {
  const OfficeSlides slides = office_slides(deck_of(
      "## One\n\nWords.\n\n::: {#a}\n![A](s.toml){.still}\n\n" + std::string(kTable) +
      "\n:::\n\n## Two\n\n::::: {.columns #b}\n:::: {.column #c}\n" + kTable + "\n" + kTable +
      "\n::::\n:::: {.column #d}\nWords.\n::::\n:::::\n\n"
      "::: {#e}\n::: notes\nN\n:::\n:::\n\n## Three\n\nEnd.\n"));
  const std::map<std::string, std::string> wanted = {{"a", "one"},
                                                     {"s", "one"},
                                                     {"b", "two"},
                                                     {"c", "two"},
                                                     {"d", "slide-again-2"},
                                                     {"e", "slide-again-2"}};
  EXPECT_EQ(slides.titles, wanted);
}

}  // namespace
}  // namespace polhode
