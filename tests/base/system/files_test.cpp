// SPDX-License-Identifier: MIT
#include "base/system/files.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/run.h"

namespace polhode::test {
namespace {

namespace fs = std::filesystem;

TEST(Files, AreListedInTheOrderOfTheirNames) {
  const TemporaryFolder folder;
  EXPECT_TRUE(entries_of(folder.path()).empty());
  for (const char* name : {"b", "a", "c"})
    write_text(folder / name, "");
  EXPECT_EQ(entries_of(folder.path()),
            (std::vector<fs::path>{folder / "a", folder / "b", folder / "c"}));
}

TEST(Files, OfAFolderThatCannotBeReadAreAnErrorOfTheFolder) {
  const TemporaryFolder folder;
  write_text(folder / "file", "");
  for (const Fault fault : {Fault::input, Fault::environment}) {
    for (const char* name : {"file", "none"}) {
      expect_error([&] { entries_of(folder / name, fault); }, fault, "", "cannot be read: ");
      try {
        entries_of(folder / name, fault);
      } catch (const Error& error) {
        EXPECT_EQ(error.place().file, folder / name);
      }
    }
  }
}

TEST(Files, FoldersAreMadeWithThoseAboveThem) {
  const TemporaryFolder folder;
  make_folder(folder / "a/b");
  make_folder(folder / "a/b");
  EXPECT_TRUE(fs::is_directory(folder / "a/b"));
  write_text(folder / "file", "");
  for (const char* name : {"file", "file/c"}) {
    expect_error(
        [&] {
          make_folder(folder / name, {{}, 0, "--output"});
        },
        Fault::input,
        "--output",
        "cannot make the folder");
  }
}

TEST(Files, AreThereOrNotOrCannotBeLookedAt) {
  const TemporaryFolder folder;
  write_text(folder / "file", "");
  fs::create_symlink("loop", folder / "loop");
  fs::create_symlink("nowhere", folder / "broken");
  EXPECT_TRUE(is_there(folder / "file"));
  EXPECT_TRUE(is_there(folder.path()));
  EXPECT_FALSE(is_there(folder / "none"));
  EXPECT_FALSE(is_there(folder / "broken"));
  EXPECT_FALSE(is_there(folder / "file/below"));
  expect_input_error([&] { is_there(folder / "loop"); }, "", "cannot be looked at: ");
}

TEST(Files, AreMovedAndRemoved) {
  const TemporaryFolder folder;
  write_text(folder / "a", "new");
  write_text(folder / "b", "old");
  move_file(folder / "a", folder / "b");
  EXPECT_EQ(read_text(folder / "b"), "new");
  EXPECT_EQ(folder.entries(), 1);
  expect_error(
      [&] { move_file(folder / "a", folder / "b"); }, Fault::environment, "", "cannot write");
  fs::create_directories(folder / "deep/er");
  for (const char* name : {"deep", "b", "none"})
    remove_file(folder / name);
  EXPECT_EQ(folder.entries(), 0);
  write_text(folder / "c", "");
  expect_error([] { remove_file("/proc/self/stat"); }, Fault::environment, "", "cannot remove");
}

}  // namespace
}  // namespace polhode::test
