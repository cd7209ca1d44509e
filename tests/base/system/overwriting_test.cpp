// SPDX-License-Identifier: MIT
#include "base/system/overwriting.h"

#include <gtest/gtest.h>

#include "base/system/atomic_file.h"
#include "support/expect_error.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::TemporaryFolder;

// Writes a file that has another name by each kind of link: "link" and "hard".
std::string write_with_links(const TemporaryFolder& folder, const std::string& name) {
  const std::string file = folder / name;
  test::write_text(file, "its content");
  std::filesystem::create_symlink(name, folder / "link");
  std::filesystem::create_hard_link(file, folder / "hard");
  return file;
}

void expect_refused(const std::string& written,
                    const std::filesystem::path& needed,
                    const std::string& words) {
  SCOPED_TRACE(written);
  test::expect_input_error(
      [&] {
        refuse_same_file(written, "--report", {"other", needed});
      },
      "",
      words);
}

TEST(RefuseSameFile, OneFileHasManyNames) {
  const TemporaryFolder folder;
  const std::string film = write_with_links(folder, "film.mp4");
  std::filesystem::create_directory(folder / "in");
  const std::string words = "--report would overwrite " + film;
  for (const char* name : {"film.mp4", "./film.mp4", "in/../film.mp4", "link", "hard"})
    expect_refused(folder / name, film, words);
}

// what is not written yet has only its name
TEST(RefuseSameFile, FilesThatAreNotThereYetAreComparedByName) {
  expect_refused("no/such/film.mp4", "no/such/../such/film.mp4", "would overwrite");
  EXPECT_NO_THROW(refuse_same_file("no/such/film.mp4", "--report", {"no/such/film.mkv"}));
}

// what stands unfinished beside the output would take the place of an input
TEST(RefuseSameFile, UnfinishedFilesAreFilesToo) {
  const TemporaryFolder folder;
  test::write_text(folder / "film.mp4.part", "a scene");
  test::expect_input_error(
      [&] { refuse_same_file(folder / "film.mp4", "the output", {folder / "film.mp4.part"}); },
      "",
      "the output would overwrite");
  test::expect_input_error(
      [&] {
        refuse_same_files(folder.path(), {"a.csv", "b.csv"}, {folder / "b.csv"});
      },
      "",
      "--output would overwrite");
  EXPECT_NO_THROW(refuse_same_files(folder.path(), {"a.csv"}, {folder / "b.csv"}));
}

TEST(RefuseSameFile, SceneFilesAreNeverWritten) {
  expect_refused("other.toml", "film.mp4", "'other.toml' has the ending of scene files");
}

TEST(RefuseSameFile, OtherFilesAndNoFileAreFine) {
  const TemporaryFolder folder;
  test::write_text(folder / "a.json", "same");
  test::write_text(folder / "b.json", "same");
  EXPECT_NO_THROW(refuse_same_file(folder / "a.json", "--report", {folder / "b.json"}));
  EXPECT_NO_THROW(refuse_same_file("", "--report", {""}));
}

TEST(ProtectedFile, IsNeverWrittenByAnyName) {
  const TemporaryFolder folder;
  const std::string scene = write_with_links(folder, "scene");
  protect_file(scene);
  for (const char* name : {"scene", "link", "hard"}) {
    SCOPED_TRACE(name);
    test::expect_input_error(
        [&] { write_file(folder / name, "a film"); }, "", "would overwrite " + scene);
  }
  EXPECT_EQ(test::read_text(scene), "its content");
  EXPECT_NO_THROW(write_file(folder / "other", "a film"));
}

// a new file may get the inode of one that is gone
TEST(ProtectedFile, IsForgottenWhenItIsGone) {
  const TemporaryFolder folder;
  test::write_text(folder / "scene", "a scene");
  protect_file(folder / "scene");
  std::filesystem::rename(folder / "scene", folder / "film");
  EXPECT_NO_THROW(write_file(folder / "film", "a film"));
}

}  // namespace
}  // namespace polhode
