// SPDX-License-Identifier: MIT
#include "base/system/kept_rows.h"

#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::TemporaryFolder;
using Lines = std::vector<std::string>;

// what a run that was asked for `words` takes up, if it takes up to `most` rows
Lines taken_up(KeptRows& rows, std::size_t most = 100) {
  Lines lines;
  rows.load([&](const std::string& line) {
    if (lines.size() == most) return false;
    lines.push_back(line);
    return true;
  });
  return lines;
}

TEST(KeptRows, AreTakenUpByTheNextRunOfTheSameWords) {
  const TemporaryFolder folder;
  KeptRows first(folder / "rows", "map 64x64");
  first.add("1,2");
  first.add("3,4");
  first.save();
  KeptRows next(folder / "rows", "map 64x64");
  EXPECT_EQ(taken_up(next), (Lines{"1,2", "3,4"}));
}

// they wait beside those of other words until their own are asked for again
TEST(KeptRows, OfOtherWordsAreSetAside) {
  const TemporaryFolder folder;
  KeptRows first(folder / "rows", "map 64x64");
  first.add("1,2");
  KeptRows other(folder / "rows", "map 64x6");
  EXPECT_EQ(taken_up(other), Lines{});
  other.add("7");
  KeptRows again(folder / "rows", "map 64x64");
  EXPECT_EQ(taken_up(again), Lines{"1,2"});
  again.remove();
  KeptRows last(folder / "rows", "map 64x6");
  EXPECT_EQ(taken_up(last), Lines{"7"});
  EXPECT_EQ(folder.entries(), 1);
}

TEST(KeptRows, ThatWereChangedAreNotBelieved) {
  const TemporaryFolder folder;
  KeptRows first(folder / "rows", "words");
  for (const char* row : {"1,2.5", "2,3.5", "3,4.5"})
    first.add(row);
  first.save();
  std::string text = test::read_text(folder / "rows");
  text.replace(text.find("3.5"), 3, "3.6");
  test::write_text(folder / "rows", text);
  KeptRows next(folder / "rows", "words");
  EXPECT_EQ(taken_up(next), Lines{"1,2.5"});
}

TEST(KeptRows, WithoutAFileThereAreNone) {
  const TemporaryFolder folder;
  KeptRows rows(folder / "rows", "words");
  EXPECT_EQ(taken_up(rows), Lines{});
  EXPECT_EQ(folder.entries(), 0);
}

// rows that were taken up are saved again with the new ones; a refused one and what follows are not
TEST(KeptRows, AddedOnesStandBehindThoseTakenUp) {
  const TemporaryFolder folder;
  KeptRows first(folder / "rows", "words");
  for (const char* row : {"a", "b", "broken", "c"})
    first.add(row);
  first.save();
  KeptRows rows(folder / "rows", "words");
  EXPECT_EQ(taken_up(rows, 2), (Lines{"a", "b"}));
  rows.add("d");
  rows.save();
  KeptRows next(folder / "rows", "words");
  EXPECT_EQ(taken_up(next), (Lines{"a", "b", "d"}));
}

TEST(KeptRows, AreRemovedWithTheirFile) {
  const TemporaryFolder folder;
  KeptRows rows(folder / "rows", "words");
  rows.add("a");
  rows.save();
  EXPECT_EQ(folder.entries(), 1);
  rows.remove();
  EXPECT_EQ(folder.entries(), 0);
  EXPECT_NO_THROW(rows.remove());
}

TEST(KeptRows, TheFirstIsWrittenAtOnce) {
  const TemporaryFolder folder;
  KeptRows rows(folder / "rows", "words");
  rows.add("a");
  EXPECT_EQ(test::read_text(folder / "rows").substr(0, 8), "words\na ");
}

TEST(KeptRows, AFolderThatIsMissingIsAnError) {
  const TemporaryFolder folder;
  KeptRows rows(folder / "nowhere/rows", "words");
  EXPECT_NO_THROW(rows.save()) << "there is nothing to keep";
  EXPECT_THROW(rows.add("a"), Error);
}

// any number of runs make parts, each into a file of its own; the whole finds them and removes them
TEST(KeptRows, OfPartsMeetInTheWhole) {
  const TemporaryFolder folder;
  KeptRows first(folder / "rows", "words", "1-of-2"), second(folder / "rows", "words", "2-of-2");
  first.add("1");
  second.add("2");
  EXPECT_EQ(folder.entries(), 2);
  KeptRows again(folder / "rows", "words", "1-of-2");
  EXPECT_EQ(taken_up(again), Lines{"1"}) << "a part reads no others";
  KeptRows other(folder / "rows", "other words");
  EXPECT_EQ(taken_up(other), Lines{});
  KeptRows whole(folder / "rows", "words");
  EXPECT_EQ(taken_up(whole), (Lines{"1", "2"}));
  whole.add("3");
  whole.remove();
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace polhode
