// SPDX-License-Identifier: MIT
#include "base/system/output_folder.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/full_disk.h"
#include "support/run.h"

namespace polhode::test {
namespace {

namespace fs = std::filesystem;

TEST(OutputFolder, IsMadeWithItsParentsAndFilledOnCommit) {
  const TemporaryFolder folder;
  const fs::path inner = folder.path() / "a" / "b";
  OutputFolder files(inner, {"x.txt", "y.txt"});
  EXPECT_FALSE(fs::exists(inner / "x.txt"));
  files.commit({"of x", "of y"});
  EXPECT_EQ(read_text(inner / "x.txt"), "of x");
  EXPECT_EQ(read_text(inner / "y.txt"), "of y");
  EXPECT_EQ(std::distance(fs::directory_iterator(inner), {}), 2);
}

TEST(OutputFolder, KeepsWhatWasThereUntilCommit) {
  const TemporaryFolder folder;
  write_text(folder / "x.txt", "old");
  write_text(folder / "stranger", "stays");
  { const OutputFolder abandoned(folder.path(), {"x.txt", "y.txt"}); }
  EXPECT_EQ(read_text(folder / "x.txt"), "old");
  EXPECT_EQ(folder.entries(), 2);
  OutputFolder(folder.path(), {"x.txt"}).commit({"new"});
  EXPECT_EQ(read_text(folder / "x.txt"), "new");
  EXPECT_EQ(read_text(folder / "stranger"), "stays");
}

TEST(OutputFolder, AFullDiskKeepsAllOldFiles) {
  const TemporaryFolder folder;
  write_text(folder / "x.txt", "old");
  const auto work = [&] {
    OutputFolder(folder.path(), {"x.txt", "y.txt"}).commit({"new", std::string(100000, 'y')});
  };
  EXPECT_EQ(with_full_disk(50000, work), Outcome::environment);
  EXPECT_EQ(read_text(folder / "x.txt"), "old");
  EXPECT_EQ(folder.entries(), 1);
  EXPECT_EQ(with_full_disk(200000, work), Outcome::done);
  EXPECT_EQ(read_text(folder / "x.txt"), "new");
}

TEST(OutputFolder, RefusesASecondRunOnTheSameFiles) {
  const TemporaryFolder folder;
  OutputFolder first(folder.path(), {"x.txt", "y.txt"});
  expect_input_error([&] { OutputFolder(folder.path(), {"y.txt"}); }, "", "another run");
  first.commit({"whole", "whole"});
  EXPECT_EQ(read_text(folder / "y.txt"), "whole");
}

TEST(OutputFolder, NamesTheOptionOfAFolderThatCannotBe) {
  const TemporaryFolder folder;
  write_text(folder / "file", "");
  expect_input_error(
      [&] { OutputFolder(folder.path() / "file", {}); }, "--output", "cannot make the folder");
  expect_input_error([&] { OutputFolder(folder.path() / "file" / "below", {}, "--page"); },
                     "--page",
                     "cannot make the folder");
}

TEST(FolderOrDefault, IsWhatIsAskedElseNamedByTheScene) {
  EXPECT_EQ(folder_or_default("here", "scenes/top.toml", "chart"), "here");
  EXPECT_EQ(folder_or_default("", "scenes/top.toml", "chart"), "output/top_chart");
}

TEST(RefuseSameStem, NamesBoth) {
  EXPECT_NO_THROW(refuse_same_stem({"a/top.toml", "a/body.toml"}));
  expect_input_error(
      [] {
        refuse_same_stem({"a/top.toml", "c.toml", "b/top.toml"});
      },
      "",
      "a/top.toml and b/top.toml are both called 'top'");
}

}  // namespace
}  // namespace polhode::test
