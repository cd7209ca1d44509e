// SPDX-License-Identifier: MIT
#include "scene/text.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/scene.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

const std::string kBody = "[body]\nmoments = [1, 2, 3]\n";

std::string repeated(const std::string& piece, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i)
    text += piece;
  return text;
}

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

TEST(Text, names_the_line_of_a_syntax_error) {
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
      {std::string("a = \"\0\"\n", 8), "t:1: not valid TOML: "},
  };
  for (const Case& c : cases) {
    const std::string error = error_of(c.text);
    EXPECT_EQ(error.substr(0, c.start.size()), c.start) << error;
    EXPECT_LT(error.size(), 300u);
  }
}

TEST(Text, refuses_what_is_not_utf8) {
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

TEST(Text, refuses_emptiness) {
  for (const char* text : {"", " ", "\r\n\t\n"}) {
    EXPECT_EQ(error_of(text), "t: is empty; a scene needs at least a [body] table");
  }
  EXPECT_NE(error_of("# only a comment\n").find("body: this table is missing"), std::string::npos);
}

TEST(Text, refuses_deep_nesting_of_every_kind) {
  const std::size_t deep = 500000;
  const std::string deeper = "nested deeper than 32 levels";
  for (const std::string& text : {"a = " + repeated("[", deep),
                                  "a = " + repeated("[", deep) + repeated("]", deep),
                                  "a = " + repeated("{ a = ", deep),
                                  repeated("a.", deep) + "a = 1",
                                  "[" + repeated("a.", deep) + "a]",
                                  "[[" + repeated("\"a\" . ", deep) + "a]]"}) {
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

TEST(Text, refuses_too_much) {
  const std::string error = error_of(kBody + "#" + std::string(kLargestScene, ' '));
  EXPECT_NE(error.find("holds more than 16000000 bytes"), std::string::npos) << error;
}

TEST(Text, cuts_between_characters) {
  EXPECT_EQ(cut("abc", 3), "abc");
  EXPECT_EQ(cut("abcd", 3), "abc...");
  EXPECT_EQ(cut("ab\xC3\xA9", 3), "ab...");
  EXPECT_EQ(cut("\xF0\x9F\x98\x80", 3), "...");
}

// A folder of its own for each test.
class LoadScene : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::string error_of_file(const fs::path& path) {
    try {
      load_scene(path);
    } catch (const Error& error) {
      EXPECT_EQ(error.fault(), Fault::input);
      EXPECT_EQ(error.place().file, path.string());
      return error.message();
    }
    return "";
  }
  const fs::path folder_ =
      fs::path(::testing::TempDir()) / ("polhode_load_" + std::to_string(getpid()));
};

TEST_F(LoadScene, reads_a_file_and_remembers_its_name) {
  const fs::path file = folder_ / "scene.toml";
  std::ofstream(file) << kBody;
  EXPECT_EQ(load_scene(file).file, file.string());
}

TEST_F(LoadScene, says_what_is_wrong_with_the_file) {
  EXPECT_EQ(error_of_file(folder_ / "none.toml"), "no such file");
  EXPECT_EQ(error_of_file(folder_), "is a folder; give a file");
  std::ofstream(folder_ / "empty.toml").close();
  EXPECT_NE(error_of_file(folder_ / "empty.toml").find("is empty"), std::string::npos);
  EXPECT_NE(error_of_file("/dev/zero").find("is not a regular file"), std::string::npos);
}

TEST_F(LoadScene, says_that_a_file_cannot_be_read) {
  // nobody may read the first byte of this one
  EXPECT_NE(error_of_file("/proc/self/mem").find("cannot be read"), std::string::npos);
  if (geteuid() == 0) return;  // root may read everything else
  const fs::path file = folder_ / "secret.toml";
  std::ofstream(file) << kBody;
  fs::permissions(file, fs::perms::none);
  EXPECT_NE(error_of_file(file).find("cannot be read"), std::string::npos);
}

// every scene that ships must be read
TEST(ShippedScenes, are_read) {
  const fs::path scenes = fs::path(POLHODE_SOURCE_DIR) / "scenes";
  if (!fs::exists(scenes)) GTEST_SKIP() << "no scenes yet";
  for (const fs::directory_entry& entry : fs::directory_iterator(scenes)) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_NO_THROW(load_scene(entry.path())) << entry.path();
  }
}

}  // namespace
}  // namespace polhode
