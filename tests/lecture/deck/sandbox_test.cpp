// SPDX-License-Identifier: MIT
#include "lecture/deck/sandbox.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::TemporaryFolder;
using test::write_text;

TEST(Sandbox, FilesStayInTheFolderOfTheDeck) {
  const TemporaryFolder outer;
  std::filesystem::create_directories(outer / "deck/in");
  write_text(outer / "secret.toml", "x");
  write_text(outer / "deck/a.toml", "x");
  write_text(outer / "deck/in/b.toml", "x");
  std::filesystem::create_symlink("../secret.toml", outer / "deck/link.toml");
  std::filesystem::create_directory_symlink("..", outer / "deck/up");
  std::filesystem::create_symlink("a.toml", outer / "deck/fine.toml");
  const DeckRoot root{outer / "deck", false};
  const auto asked = [&](const std::string& name) {
    return [&root, name] {
      trusted_file(root, root.folder, name);
    };
  };
  EXPECT_NO_THROW(asked("a.toml")());
  EXPECT_NO_THROW(asked("in/b.toml")());
  EXPECT_NO_THROW(asked("fine.toml")());
  for (const std::string name : {"../secret.toml",
                                 "in/../../secret.toml",
                                 "link.toml",
                                 "up/secret.toml",
                                 "in",
                                 "none.toml",
                                 "",
                                 "a\n.toml"})
    EXPECT_THROW(asked(name)(), Error) << name;
  EXPECT_THROW(asked(outer / "secret.toml")(), Error);
  EXPECT_NO_THROW(trusted_file({outer / "deck", true}, outer / "deck", "../secret.toml"));
}

TEST(Sandbox, MeshesOfScenesStayThereToo) {
  const TemporaryFolder outer;
  std::filesystem::create_directory(outer / "deck");
  write_text(outer / "m.obj", "v 0 0 0\n");
  write_text(outer / "deck/s.toml",
             "format = 1\n[body]\nsolid = { kind = \"mesh\", file = \"../m.obj\", mass = 1 }\n");
  try {
    trusted_scene({outer / "deck", false}, "s.toml");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("leaves the deck's folder"), std::string::npos);
  }
  // through another folder of the deck
  std::filesystem::create_directory(outer / "deck/a");
  write_text(outer / "deck/m.obj", "v 0 0 0\n");
  std::filesystem::rename(outer / "deck/s.toml", outer / "deck/a/s.toml");
  try {
    trusted_scene({outer / "deck", false}, "a/s.toml");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'../m.obj' has '..'; put the file"),
              std::string::npos)
        << error.what();
  }
  EXPECT_NO_THROW(trusted_scene({outer / "deck", true}, "a/s.toml"));
}

TEST(Sandbox, NamesAreEncodedForAddresses) {
  EXPECT_EQ(percent_encoded("a b\"<é>.png"), "a%20b%22%3C%C3%A9%3E.png");
  EXPECT_EQ(percent_decoded("a%20b%zz%2"), "a b%zz%2");
}

TEST(Sandbox, EncodedNamesAreReadBack) {
  std::string bytes;
  for (int c = 1; c < 256; ++c)
    bytes += static_cast<char>(c);
  EXPECT_EQ(percent_decoded(percent_encoded(bytes)), bytes);
  EXPECT_EQ(percent_encoded("aZ09-_./"), "aZ09-_./");
  EXPECT_EQ(percent_decoded("%4a%4A%"), "JJ%");
}

TEST(Sandbox, LinksGoToPagesMailAndPlaces) {
  for (const char* target :
       {"https://example.org", "http://example.org/a#b", "mailto:a@example.org", "#film=a&t=2"})
    EXPECT_NO_THROW(check_link(target)) << target;
  for (const char* target : {"javascript:alert(1)",
                             "data:text/html,x",
                             "file:///etc/passwd",
                             "//example.org",
                             "page.html",
                             " https://example.org",
                             "HTTPS://example.org",
                             "https://a\nb",
                             ""}) {
    SCOPED_TRACE(target);
    test::expect_input_error([&] { check_link(target); }, "", "must be https:, http:, mailto:");
  }
}

// what reads, writes, defines or runs, wherever it stands; words that begin alike are fine
TEST(Sandbox, FormulasAreMathematics) {
  for (const char* tex :
       {"x^2", "\\frac{a}{b}", "\\left( \\letter \\defined \\inputs", "a\\\\b", "\\", "x\ny\tz"})
    EXPECT_NO_THROW(check_formula(tex)) << tex;
  for (const char* tex : {"\\input{a}",
                          "x\\def\\y{1}",
                          "\\let\\a",
                          "{\\write18{ls}}",
                          "\\href{a}{b}",
                          "\\renewenvironment{sin}{a}{}",
                          "\\newenvironment{a}{b}{c}",
                          "\\DeclareMathOperator*{\\a}{b}",
                          "a\\,\\csname x"}) {
    SCOPED_TRACE(tex);
    test::expect_input_error([&] { check_formula(tex); }, "", "is not allowed in a formula");
  }
  for (const std::string& tex : {std::string("^^5c"), std::string("a\0b", 3), std::string("\x1B")})
    test::expect_input_error([&] { check_formula(tex); }, "", "control characters");
}

}  // namespace
}  // namespace polhode
