// SPDX-License-Identifier: MIT
#include "lecture/deck/pandoc.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/json.h"
#include "support/in_child.h"
#include "support/run.h"

namespace polhode {
namespace {

using Tree = Json;

TEST(Pandoc, IsNamedWithItsVersionOrIsToBeInstalled) {
  EXPECT_EQ(find_pandoc().version.rfind("pandoc ", 0), 0U) << find_pandoc().why_not;
  EXPECT_NO_THROW(require_pandoc());
  EXPECT_EQ(test::exit_code_in_child([] {
              setenv("PATH", "/nowhere", 1);
              if (find_pandoc().installed) return 1;
              try {
                require_pandoc();
              } catch (const Error& error) {
                return error.fault() == Fault::environment ? 0 : 2;
              }
              return 3;
            }),
            0);
}

// pages, TeX and macros of others are words
TEST(Pandoc, ReadsMarkdownWithoutRawParts) {
  const Tree tree = read_markdown("# A head\n\n<b>bold</b> \\newcommand{\\a}{b} 'quoted' [@key]\n");
  EXPECT_EQ(tree.at("blocks").at(0).at("t"), "Header");
  const std::string text = tree.dump();
  for (const char* type : {"RawInline", "RawBlock", "Quoted", "\"Cite\""})
    EXPECT_EQ(text.find(type), std::string::npos) << type;
  EXPECT_NE(text.find("<b>bold</b>"), std::string::npos);
}

TEST(Pandoc, WritesDocumentsAndTellsFormulasThatItCannotRead) {
  const Tree tree = read_markdown("$x^2$, $\\frac{1}$ and $\\foo{a}{b}$\n");
  const Written written = write_document(tree, {"-t", "html5", "--mathml"});
  EXPECT_NE(written.text.find("<msup>"), std::string::npos);
  ASSERT_FALSE(written.bad_formulas.empty());
  EXPECT_EQ(written.bad_formulas[0].rfind("\\frac{1}", 0), 0U) << written.bad_formulas[0];
  const Tree good = read_markdown("$x^2$\n");
  EXPECT_TRUE(write_document(good, {"-t", "html5", "--mathml"}).bad_formulas.empty());
}

TEST(Pandoc, TakesNoTemplatesOfTheUser) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "pandoc/templates");
  test::write_text(folder / "pandoc/templates/default.latex", "MINE $body$");
  EXPECT_EQ(test::exit_code_in_child([&] {
              setenv("XDG_DATA_HOME", folder.path().c_str(), 1);
              const Written written =
                  write_document(read_markdown("# A head\n"), {"-s", "-t", "latex"}, false);
              return written.text.find("MINE") == std::string::npos ? 0 : 1;
            }),
            0);
}

// another version of pandoc may write other trees
TEST(Pandoc, ATreeOfAnUnknownKindIsRefused) {
  const auto tree = [](const std::string& meta, const std::string& blocks) {
    return R"({"pandoc-api-version":[1,22],"meta":)" + meta + R"(,"blocks":)" + blocks + "}";
  };
  EXPECT_NO_THROW(
      parse_tree(tree("{}", R"([{"t":"Para","c":[{"t":"Str","c":"a"}]},{"t":"New","c":1}])")));
  const std::string bad[] = {
      "no JSON",
      "[]",
      R"({"blocks":[]})",
      tree("[]", "[]"),
      tree(R"({"lang":"en"})", "[]"),
      tree("{}", "{}"),
      tree("{}", R"([{"t":1}])"),
      tree("{}", R"([{"t":"Para"}])"),
      tree("{}", R"([{"t":"Para","c":[{"t":"Str","c":7}]}])"),
      tree("{}", R"([{"t":"Para","c":[{"c":"a"}]}])"),
      tree("{}", R"([{"t":"Para","c":[{"t":"Image","c":[["",[],[]],[],["a.png"]]}]}])"),
      tree("{}", R"([{"t":"Header","c":[1,["",[],[["key"]]],[]]}])"),
  };
  for (const std::string& text : bad) {
    try {
      parse_tree(text);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.fault(), Fault::environment) << text;
      EXPECT_NE(error.message().find("unknown kind"), std::string::npos) << error.message();
    }
  }
}

TEST(Pandoc, DeepNestingIsRefused) {
  EXPECT_NO_THROW(read_markdown(std::string(50, '>') + " word\n"));
  try {
    read_markdown(std::string(1000, '>') + " word\n");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.fault(), Fault::input);
    EXPECT_NE(error.message().find("nested deeper"), std::string::npos) << error.message();
  }
}

TEST(Pandoc, WhatItRefusesIsAnErrorOfTheEnvironment) {
  try {
    write_document(read_markdown("a\n"), {"-t", "nothing"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.fault(), Fault::environment) << error.what();
  }
}

}  // namespace
}  // namespace polhode
