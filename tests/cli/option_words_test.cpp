// SPDX-License-Identifier: MIT
#include "cli/option_words.h"

#include <set>

#include <gtest/gtest.h>

#include "film/overrides.h"
#include "motion/stepper_table.h"
#include "support/run.h"
#include "video/encoders.h"

namespace polhode {
namespace {

TEST(OptionWords, NoneIsThereTwice) {
  for (const auto& list : {backend_words(),
                           codec_words(),
                           document_words(),
                           method_words(),
                           preset_words(),
                           progress_words(),
                           quality_words(),
                           stepper_words()}) {
    EXPECT_FALSE(list.empty());
    EXPECT_EQ(std::set<std::string>(list.begin(), list.end()).size(), list.size());
  }
}

// every word is taken by what reads it
TEST(OptionWords, EachIsTaken) {
  for (const std::string& method : stepper_words())
    EXPECT_EQ(parse_methods(method).front()->name, method);
  const test::TemporaryFolder folder;
  test::write_text(folder / "scene.toml", test::kSmallScene);
  for (const std::string& method : method_words()) {
    Overrides overrides;
    overrides.method = method;
    EXPECT_EQ(load_with_overrides(folder / "scene.toml", overrides).numerics.method, method);
  }
  for (const std::string& codec : codec_words()) {
    EncoderWish wish;
    wish.codec = codec;
    EXPECT_EQ(settle_encoder("a.mp4", wish).codec, codec);
  }
  for (const std::string& preset : preset_words()) {
    EncoderWish wish;
    wish.forced = preset;
    EXPECT_EQ(settle_encoder("a.mp4", wish).preset, preset);
  }
}

}  // namespace
}  // namespace polhode
