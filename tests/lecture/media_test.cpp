// SPDX-License-Identifier: MIT
#include "lecture/media.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "base/hash.h"
#include "base/json.h"
#include "base/system/log.h"
#include "support/expect_error.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::TemporaryFolder;
using test::write_text;

TEST(Media, KeepsWhatIsWholeAndMakesTheRest) {
  const TemporaryFolder folder;
  int made = 0;
  const auto product = [&](const std::string& key) {
    return Product{"one", key, [&](const std::filesystem::path& where, const std::string& stem) {
                     ++made;
                     write_text((where / (stem + ".txt")).string(), "content");
                     return Json{{"text", stem + ".txt"}};
                   }};
  };
  const auto obtain = [&](const std::string& key) {
    Media media(folder.path());
    return media.obtain(product(key))["text"].get<std::string>();
  };
  const std::string file = obtain("a");
  obtain("a");
  EXPECT_EQ(made, 1);
  EXPECT_NE(obtain("b"), file);
  EXPECT_EQ(made, 2);
  // cut short, changed, gone: made again
  write_text(folder / file, "conten");
  obtain("a");
  EXPECT_EQ(made, 3);
  std::filesystem::remove(folder / file);
  obtain("a");
  EXPECT_EQ(made, 4);
  // also the card of another product, and one that somebody has written
  const std::string card = folder / (std::filesystem::path(file).stem().string() + ".json");
  const std::string ours = test::read_text(card);
  const std::string other = test::read_text(folder / (Media::stem_of(product("b")) + ".json"));
  for (const std::string& text : {other,
                                  ours + " ",
                                  ours.substr(0, 9) + "x" + ours.substr(9),
                                  std::string("{}"),
                                  std::string(R"({"files":[]})")}) {
    const int before = made;
    write_text(card, text);
    EXPECT_EQ(obtain("a"), file);
    EXPECT_EQ(made, before + (text == ours + " " ? 0 : 1)) << text;
    EXPECT_EQ(test::read_text(card), text == ours + " " ? text : ours);
  }
  // what nobody asked for goes, what is not ours stays
  write_text(folder / "mine.json", "{}");
  write_text(folder / "evil.json", R"({"files":[{"name":"mine.json"}]})");
  write_text(folder / "odd.json", R"({"files":[{"name":7},7]})");
  std::filesystem::create_directory(folder / "folder.json");
  Media media(folder.path());
  media.obtain(product("a"));
  media.forget_the_rest();
  EXPECT_TRUE(std::filesystem::exists(folder / file));
  EXPECT_TRUE(std::filesystem::exists(folder / "mine.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / (Media::stem_of(product("b")) + ".txt")));
}

// shards may work in the folder that another run has finished
TEST(Media, ForgetsNothingWhileOthersAreAtWork) {
  const TemporaryFolder folder;
  write_text(folder / "old-1.json", R"({"files":[]})");
  std::filesystem::create_directory(folder / ".work-killed");
  Media media(folder.path());
  const auto files = [&] {
    const std::filesystem::directory_iterator all(folder.path());
    return std::distance(begin(all), end(all));
  };
  {
    const Media other(folder.path());
    media.forget_the_rest();
    EXPECT_FALSE(std::filesystem::exists(folder / ".work-killed"));
    EXPECT_EQ(files(), 3);
  }
  media.forget_the_rest();
  EXPECT_EQ(files(), 1);
}

// a product of one file
Product text_product(const std::string& name, const std::string& key, const std::string& content) {
  return {name, key, [content](const std::filesystem::path& where, const std::string& stem) {
            write_text((where / (stem + ".txt")).string(), content);
            return Json{{"text", stem + ".txt"}};
          }};
}

// whoever reruns a lecture of somebody else would give files away
TEST(Media, CardsNameNoFilesFromElsewhere) {
  const TemporaryFolder folder;
  const Product product = text_product("one", "a", "12345");
  const std::string stem = Media::stem_of(product);
  write_text(folder / "secret", "words");
  for (Json card : {Json{{"csv", "../../etc/hostname"}, {"files", Json::array()}},
                    Json{{"stills", {{{"file", "secret"}}}}, {"files", Json::array()}},
                    Json{{"poster", "secret"},
                         {"files", {{{"name", "secret"}, {"hash", content_hash("words")}}}}}}) {
    card["hash"] = content_hash(stem + "\n" + card.dump());
    write_text(folder / (stem + ".json"), card.dump());
    EXPECT_EQ(Media(folder.path()).obtain(product).at("text"), stem + ".txt") << card.dump();
  }
}

// no deep card is walked over
TEST(Media, CardsThatAreNestedDeeplyAreMadeAgain) {
  const TemporaryFolder folder;
  const Product product = text_product("one", "a", "12345");
  const std::string stem = Media::stem_of(product);
  constexpr std::size_t kDeep = 300'000;
  const std::string deep = std::string(kDeep, '[') + std::string(kDeep, ']');
  write_text(folder / (stem + ".json"), R"({"files":[],"hash":"x","x":)" + deep + "}");
  EXPECT_EQ(Media(folder.path()).obtain(product).at("text"), stem + ".txt");
}

TEST(Media, FactsListTheFilesWithTheirSizes) {
  const TemporaryFolder folder;
  Media media(folder.path());
  const Product product = text_product("one", "a", "12345");
  const Json facts = media.obtain(product);
  const std::string file = Media::stem_of(product) + ".txt";
  EXPECT_EQ(facts.at("text"), file);
  ASSERT_EQ(facts.at("files").size(), 1U);
  EXPECT_EQ(facts.at("files").at(0).at("name"), file);
  EXPECT_EQ(facts.at("files").at(0).at("bytes"), 5);
  EXPECT_EQ(test::read_text(folder / file), "12345");
  EXPECT_EQ(media.made(), 1);
  EXPECT_EQ(media.obtain(product), facts) << "found again as it was made";
  EXPECT_EQ(media.made(), 1);
}

// what is given away does not tell where it was made
TEST(Media, WarningsNameFilesRelativeToTheDeck) {
  const TemporaryFolder folder;
  const std::filesystem::path deck = folder / "deck";
  spdlog::drop("polhode");
  start_log(false);
  Media media(folder / "media", deck);
  const Product product = {"one", "a", [&](const std::filesystem::path&, const std::string&) {
                             spdlog::warn("{}/top.toml:3: it shakes", deck.string());
                             spdlog::warn("elsewhere");
                             return Json::object();
                           }};
  const Json expected = {"top.toml:3: it shakes", "elsewhere"};
  EXPECT_EQ(media.obtain(product).at("warnings"), expected);
  EXPECT_EQ(media.obtain(product).at("warnings"), expected) << "kept";
}

// a program that removes its own folder, as far as one can know
TEST(Media, AFolderThatIsGoneIsNamed) {
  const TemporaryFolder folder;
  Media media(folder.path());
  const Product product = {"one", "a", [](const std::filesystem::path& where, const std::string&) {
                             std::filesystem::remove(where);
                             return Json{{"kind", "film"}};
                           }};
  test::expect_error([&] { media.obtain(product); }, Fault::environment, "", "cannot be read: ");
}

// nothing of it is there, and the next run makes it
TEST(Media, AProductThatFailsLeavesNothing) {
  const TemporaryFolder folder;
  {
    Media media(folder.path());
    const Product broken{
        "one", "a", [](const std::filesystem::path& where, const std::string& stem) -> Json {
          write_text((where / stem).string(), "half");
          throw input_error("no such scene");
        }};
    test::expect_input_error([&] { media.obtain(broken); }, "", "no such scene");
    EXPECT_EQ(media.made(), 0);
  }
  EXPECT_EQ(folder.entries(), 0);
}

TEST(Media, StemsTellTheNameAndTheKey) {
  const Product one = text_product("one", "a", "");
  EXPECT_EQ(Media::stem_of(one).rfind("one-", 0), 0U);
  EXPECT_EQ(Media::stem_of(one).size(), 4U + 16U);
  EXPECT_NE(Media::stem_of(one), Media::stem_of(text_product("one", "b", "")));
  EXPECT_EQ(Media::stem_of(one), Media::stem_of(text_product("one", "a", "other")));
}

TEST(Media, AFolderThatCannotBeMadeIsTheUsersError) {
  const TemporaryFolder folder;
  write_text(folder / "file", "");
  test::expect_input_error([&] { Media media(folder / "file/in"); }, "--output", "cannot write");
}

TEST(Media, TheProgramsIdentityIsTheSameAllTheTime) {
  EXPECT_EQ(program_identity(), program_identity());
  EXPECT_GT(program_identity().size(), 40U);
}

}  // namespace
}  // namespace polhode
