// SPDX-License-Identifier: MIT
#include "cli/option_words.h"

#include <set>

#include <gtest/gtest.h>

#include "base/error.h"
#include "motion/stepper.h"
#include "motion/stepper_table.h"
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
                           quality_words()}) {
    EXPECT_FALSE(list.empty());
    EXPECT_EQ(std::set<std::string>(list.begin(), list.end()).size(), list.size());
  }
}

// every word is taken by what reads it
TEST(OptionWords, EachIsTaken) {
  for (const std::string& method : method_words())
    EXPECT_EQ(find_stepper(method).name, method);
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
