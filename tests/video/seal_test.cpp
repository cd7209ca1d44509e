// SPDX-License-Identifier: MIT
#include "video/seal.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/run.h"
#include "video/every_format.h"

namespace polhode {
namespace {

using test::TemporaryFolder;

// a film of each container that is sealed, under the name that it has before it is whole
std::string small_film(const TemporaryFolder& folder, const std::string& ending) {
  const FilmFormat& format = *find_film_format("a" + ending);
  const SinkJob job = test::job_for(folder, {&format, &find_encoder(format, "")});
  test::write_film(job, 4);
  const std::string part = folder / ("a" + ending + ".part");
  std::filesystem::rename(job.output, part);
  return part;
}

TEST(Seal, TheTextComesBack) {
  const TemporaryFolder folder;
  const std::string file = folder / "a.mp4.part";
  for (const std::string& text : {std::string("{\"frames\": 3}"),
                                  std::string(),
                                  std::string(100000, 'x'),
                                  std::string("nul\0byte", 8)}) {
    test::write_text(file, "what the film is");
    EXPECT_FALSE(sealed_text(file));
    seal_file(file, text);
    EXPECT_EQ(sealed_text(file), text);
  }
}

// whatever byte is another, whatever is cut off or added, it is seen
TEST(Seal, AnyChangeIsSeen) {
  const TemporaryFolder folder;
  const std::string file = folder / "a.webm.part";
  test::write_text(file, "what the film is");
  seal_file(file, "the text");
  const std::string sealed = test::read_text(file);
  for (std::size_t i = 0; i < sealed.size(); ++i) {
    std::string changed = sealed;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    test::write_text(file, changed);
    EXPECT_FALSE(sealed_text(file)) << i;
  }
  for (const std::size_t length : {std::size_t{0}, std::size_t{20}, sealed.size() - 1}) {
    test::write_text(file, sealed.substr(0, length));
    EXPECT_FALSE(sealed_text(file)) << length;
  }
  test::write_text(file, sealed + "more");
  EXPECT_FALSE(sealed_text(file));
}

// players skip it: the film has the frames that it had
TEST(Seal, ASealedFilmIsTheSameFilm) {
  for (const char* ending : {".mp4", ".webm", ".mov"}) {
    SCOPED_TRACE(ending);
    const TemporaryFolder folder;
    const std::string file = small_film(folder, ending);
    const test::DecodedFilm before = test::decode(file);
    seal_file(file, "the text");
    const test::DecodedFilm after = test::decode(file);
    ASSERT_EQ(after.frames.size(), 4u);
    EXPECT_EQ(after.pts, before.pts);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(after.frames[i].pixels, before.frames[i].pixels);
    EXPECT_EQ(sealed_text(file), "the text");
  }
}

// the boxes of an .mp4 still fill the file exactly, the last of them a free one
TEST(Seal, IsABoxOfItsOwn) {
  const TemporaryFolder folder;
  const std::string file = small_film(folder, ".mp4");
  seal_file(file, "the text");
  const std::string bytes = test::read_text(file);
  std::size_t at = 0;
  std::string last;
  while (at + 8 <= bytes.size()) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < 4; ++i)
      size = size << 8 | static_cast<unsigned char>(bytes[at + i]);
    ASSERT_GE(size, 8u);
    last = bytes.substr(at + 4, 4);
    at += size;
  }
  EXPECT_EQ(at, bytes.size());
  EXPECT_EQ(last, "free");
}

TEST(Seal, AFileThatIsNotThereIsAnError) {
  test::expect_input_error([] { sealed_text("/nowhere/a.mp4"); }, "", "cannot be read");
}

}  // namespace
}  // namespace polhode
