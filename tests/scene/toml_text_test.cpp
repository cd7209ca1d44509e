// SPDX-License-Identifier: MIT
#include "scene/toml_text.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/scene_file.h"
#include "scene/scene_texts.h"

namespace polhode {
namespace {

// the error of a text, "" when there is none
std::string error_of(const std::string& text) {
  try {
    parse_scene(text, "t");
  } catch (const Error& error) {
    EXPECT_EQ(error.fault(), Fault::input);
    return error.what();
  }
  return "";
}

TEST(Text, NamesTheLineOfASyntaxError) {
  struct Case {
    std::string text, start;
  };
  const std::vector<Case> cases = {
      {"a =\n", "t:1: not valid TOML: "},
      {"a = 1\nb = 2\na = 3\n", "t:3: not valid TOML: "},
      {"\n[body\n", "t:2: not valid TOML: "},
      {"\n\ntitle = \"open\n", "t:3: not valid TOML: "},
      {"format = 99999999999999999999\n", "t:1: not valid TOML: decimal integer"},
      {"a = 1e999\n", "t:1: not valid TOML: floating-point"},
      {"= 1\n", "t:1: not valid TOML: "},
      {kBody + "mass = 1,5\n", "t:3: not valid TOML: "},
      {kBody + "[body]\n", "t:3: not valid TOML: "},
      {std::string("a = \"\0\"\n", 8), "t:1: byte 0x00 is not UTF-8"},
  };
  for (const Case& c : cases) {
    const std::string error = error_of(c.text);
    EXPECT_EQ(error.substr(0, c.start.size()), c.start) << error;
    EXPECT_LT(error.size(), 300u);
  }
}

TEST(Text, RefusesWhatIsNotUtf8) {
  for (const char* bytes : {"\xff",
                            "\x80",
                            "\xc3",
                            "\xc0\xaf",
                            "\xe0\x80\x80",
                            "\xed\xa0\x80",
                            "\xf0\x80\x80\x80",
                            "\xf4\x90\x80\x80",
                            "\xf8\x88\x80\x80\x80",
                            "\xe2\x82"}) {
    const std::string error = error_of("# one\n# two " + std::string(bytes));
    EXPECT_EQ(error.substr(0, 10), "t:2: byte ") << error;
    EXPECT_NE(error.find("not UTF-8"), std::string::npos) << error;
  }
  EXPECT_EQ(error_of(kBody + "# \xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80\n"), "");
}

TEST(Text, RefusesEmptiness) {
  for (const char* text : {"", " ", "\r\n\t\n"}) {
    EXPECT_EQ(error_of(text), "t: is empty; a scene needs at least a [body] table");
  }
  EXPECT_NE(error_of("# only a comment\n").find("body: this table is missing"), std::string::npos);
}

TEST(Text, RefusesDeepNestingOfEveryKind) {
  const std::size_t deep = 500000;
  const std::string deeper = "nested deeper than 32 levels";
  for (const std::string& text : {"a = " + repeated("[", deep),
                                  "a = " + repeated("[", deep) + repeated("]", deep),
                                  "a = " + repeated("{ a = ", deep),
                                  repeated("a.", deep) + "a = 1",
                                  "[" + repeated("a.", deep) + "a]",
                                  "[[" + repeated("\"a\" . ", deep) + "a]]",
                                  // behind strings that end in quotes of their own
                                  "x = {s = \"\"\"a\"\"\"\", " + repeated("a.", deep) + "a = 1}",
                                  "x = {s = \"\"\"\"\"\"\"\", " + repeated("a.", deep) + "a = 1}",
                                  "x = {s = '''a''''', " + repeated("a.", deep) + "a = 1}"}) {
    EXPECT_NE(error_of(text).find(deeper), std::string::npos);
  }
  // brackets and dots in strings and comments are no nesting
  const std::string many = repeated("[.{", 100);
  EXPECT_EQ(error_of("title = \"" + many + "\\\"" + many + "\" # " + many + "\n" + kBody), "");
  EXPECT_EQ(error_of("title = '" + many + "'\n" + kBody), "");
  EXPECT_EQ(error_of("title = \"\"\"\n" + many + "\n\"" + many + "\"\"\"\n" + kBody), "");
  EXPECT_EQ(error_of("title = '''\n" + many + "\n'" + many + "'''\n" + kBody), "");
  // many shallow brackets are fine
  EXPECT_EQ(error_of("[body]\nsolid = { kind = \"lathe\", profile = [" +
                     repeated("[0.1, 0.2],\n", 5000) + "] }"),
            "");
}

TEST(Text, RefusesTooMuch) {
  const std::string error = error_of(kBody + "#" + std::string(kLargestScene, ' '));
  EXPECT_NE(error.find("is larger than 16000000 bytes"), std::string::npos) << error;
}

TEST(Text, RefusesWordsThatFillNoPicture) {
  EXPECT_EQ(error_of("title = \"" + std::string(2000, 'a') + "\"\n" + kBody), "");
  const std::string error = error_of("title = \"" + std::string(2001, 'a') + "\"\n" + kBody);
  EXPECT_NE(error.find("title: is a text of 2001 bytes; at most 2000"), std::string::npos) << error;
}

}  // namespace
}  // namespace polhode
