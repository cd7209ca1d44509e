// SPDX-License-Identifier: MIT
#include "lecture/documents/notices.h"

#include <gtest/gtest.h>

#include "base/version.h"
#include "support/words.h"

namespace polhode {
namespace {

using test::has;

TEST(Notices, PagesAreWhatABrowserShowsOrPrints) {
  for (const char* page : {"html", "slides", "handout"}) {
    EXPECT_TRUE(has_pages({page})) << page;
    EXPECT_TRUE(has_pages({"pptx", page, "data"})) << page;
  }
  EXPECT_FALSE(has_pages({}));
  EXPECT_FALSE(has_pages({"pptx", "beamer", "data"}));
}

// whose code is in a page, under which licence
TEST(Notices, OurOwnStylesAreUnderTheMitLicence) {
  const std::string text = notices({"html"}, {}, false);
  const std::string heading = "Polhode " + program_version() + ": styles and scripts of the pages";
  EXPECT_TRUE(has(text, "\n" + heading + "\n" + std::string(heading.size(), '-') + "\n"));
  EXPECT_TRUE(has(text, "the Polhode authors"));
  EXPECT_TRUE(has(text, "Permission is hereby granted, free of charge"));
  EXPECT_FALSE(has(text, "reveal.js"));
  EXPECT_FALSE(has(text, "GUST"));
}

TEST(Notices, RevealIsNamedWhereSlidesContainIt) {
  const Reveal reveal{"4.6.1", "", "", "its own notice\n"};
  const std::string text = notices({"html", "slides"}, reveal, false);
  EXPECT_TRUE(has(text, "reveal.js 4.6.1, inside slides.html"));
  EXPECT_TRUE(has(text, "its own notice"));
  EXPECT_FALSE(has(notices({"html"}, reveal, false), "reveal.js"));
  EXPECT_FALSE(has(notices({"slides"}, {}, false), "reveal.js"));
}

// as its licence asks, also where its file was not installed
TEST(Notices, RevealWithoutALicenceFileHasTheMitLicence) {
  const std::string text = notices({"slides"}, Reveal{"4.6.1", "", "", ""}, false);
  EXPECT_TRUE(has(text, "Hakim El Hattab"));
  EXPECT_NE(text.find("Permission is hereby granted"), text.rfind("Permission is hereby granted"))
      << "ours and theirs";
}

TEST(Notices, TheFontOfFormulasIsNamedWhereItIsInside) {
  EXPECT_TRUE(has(notices({"html"}, {}, true), "GUST Font License"));
}

// documents of an earlier run contain them still
TEST(Notices, OfAnEarlierRunStay) {
  const Reveal reveal{"5.1.0", "css", "js", "Licence of reveal\n"};
  const std::string slides = notices({"slides"}, reveal, true), page = notices({"html"}, {}, false);
  const std::string both = with_earlier_notices(page, slides);
  EXPECT_TRUE(both.starts_with(page));
  for (const char* words :
       {"reveal.js 5.1.0, inside slides.html\n---", "Licence of reveal\n", "GUST Font License"})
    EXPECT_NE(both.find(words), std::string::npos) << words;
  EXPECT_EQ(with_earlier_notices(both, slides), both);
  EXPECT_EQ(with_earlier_notices(page, both), both);
  EXPECT_EQ(with_earlier_notices(page, page), page);
}

}  // namespace
}  // namespace polhode
