// SPDX-License-Identifier: MIT
#include "video/libav/film_output.h"

#include <fcntl.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "support/expect_error.h"
#include "support/run.h"
#include "video/libav/libav.h"
#include "video/seal.h"

namespace polhode {
namespace {

using test::TemporaryFolder;

void put(const FilmOutput& output, const std::string& text) {
  avio_write(output.stream(),
             reinterpret_cast<const unsigned char*>(text.data()),
             static_cast<int>(text.size()));
}

TEST(FilmOutput, AFileAppearsWhenItIsWhole) {
  const TemporaryFolder folder;
  // libav would take what stands before a colon for a protocol
  for (const char* name : {"a.mp4", "take:1.mp4", "%s.mp4"}) {
    const std::string file = folder / name;
    FilmOutput output(file);
    put(output, "all of it");
    EXPECT_FALSE(std::filesystem::exists(file));
    output.finish();
    EXPECT_EQ(test::read_text(file), "all of it") << name;
  }
  EXPECT_EQ(folder.entries(), 3);
}

TEST(FilmOutput, WithoutItsEndNothingIsLeft) {
  const TemporaryFolder folder;
  test::write_text(folder / "a.mp4", "an older film");
  {
    const FilmOutput output(folder / "a.mp4");
    put(output, std::string(200000, 'x'));
  }
  EXPECT_EQ(folder.entries(), 1);
  EXPECT_EQ(test::read_text(folder / "a.mp4"), "an older film");
}

TEST(FilmOutput, ASealIsPartOfTheFile) {
  const TemporaryFolder folder;
  FilmOutput output(folder / "a.mp4");
  put(output, "all of it");
  output.finish("sealed");
  EXPECT_EQ(sealed_text(folder / "a.mp4"), "sealed");
  EXPECT_TRUE(test::read_text(folder / "a.mp4").starts_with("all of it"));
}

// what goes to standard output is what was written, whole, and nothing else
TEST(FilmOutput, StandardOutputCarriesTheBytes) {
  const TemporaryFolder folder;
  const std::string file = folder / "stdout";
  std::string sent;
  for (int i = 0; i < 50000; ++i)
    sent += std::to_string(i) + " ";
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    dup2(open(file.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
    try {
      FilmOutput output(kStandardOutput);
      put(output, sent);
      output.finish();
    } catch (const Error&) {
      _exit(1);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(test::read_text(file), sent);
}

TEST(FilmOutput, AFolderThatIsNotThereIsAnError) {
  test::expect_error([] { FilmOutput{"/nowhere/a.mp4"}; }, Fault::input, "", "");
}

}  // namespace
}  // namespace polhode
