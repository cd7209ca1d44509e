// SPDX-License-Identifier: MIT
#include "lecture/documents/mathml.h"

#include <gtest/gtest.h>

#include "lecture/deck/pandoc.h"
#include "lecture/decks.h"
#include "support/words.h"

namespace polhode {
namespace {

using test::deck_of;
using test::has;

TEST(Mathml, HasUprightLettersOneByOne) {
  EXPECT_EQ(
      formulas_for_browsers("<p><mi>a</mi></p><math><mi>a</mi><mstyle mathvariant=\"normal\">"
                            "<mi>b</mi><mstyle><mi>c</mi></mstyle></mstyle><mi>d</mi></math>"),
      "<p><mi>a</mi></p><math><mi>a</mi><mstyle mathvariant=\"normal\"><mi "
      "mathvariant=\"normal\">b</mi><mstyle><mi "
      "mathvariant=\"normal\">c</mi></mstyle></mstyle><mi>d</mi></math>");
}

TEST(Mathml, HasBarsAndArrowsAsLongAsWhatIsBelow) {
  const auto drawn = [](const std::string& tex) {
    const Deck deck = deck_of("$" + tex + "$\n");
    return formulas_for_browsers(
        write_document(deck.tree(deck.blocks), {"-t", "html5", "--mathml"}).text);
  };
  for (const auto& [tex, has_it] :
       {std::pair{"\\overline{a+b}", "border-top:"},
        {"\\underline{abc}", "border-bottom:"},
        {"\\overrightarrow{AB}", "<mover><mrow><mi>A</mi><mi>B</mi></mrow><mo stretchy=\"true\">→"},
        {"\\underrightarrow{AB}",
         "<munder><mrow><mi>A</mi><mi>B</mi></mrow><mo stretchy=\"true\">→</mo></munder>"},
        {"\\overline{x^2}", "border-top:"},
        {"\\overline{\\text{mean}}", "border-top:"},
        {"\\overline{12}", "border-top:"},
        {"\\underline{I}", "border-bottom:"},
        {"\\overline{\\sqrt v}", "border-top:"},
        {"\\overline{\\overline{ab}+c}", "style=\"border"}})
    EXPECT_TRUE(has(drawn(tex), has_it)) << drawn(tex);
  for (const char* tex : {"\\bar a", "\\bar\\omega", "\\overline{1}", "\\bar{\\mathbf{x}}"})
    EXPECT_EQ(drawn(tex).find("style=\"border"), std::string::npos) << tex;
  EXPECT_EQ(drawn("\\overline{\\overline{ab}+c}").find("accent"), std::string::npos);
}

}  // namespace
}  // namespace polhode
