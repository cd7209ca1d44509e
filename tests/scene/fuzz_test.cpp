// SPDX-License-Identifier: MIT
// Seeded damage to valid scenes: reading them ends in a scene or in an Error, and in nothing else.
#include <algorithm>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/scene_file.h"
#include "scene/scene_texts.h"

namespace polhode {
namespace {

// one random change: flip a bit, put a byte, delete, duplicate, move, or put a piece of grammar
std::string damaged(std::string text, std::mt19937& random) {
  static const char* const kPieces[] = {"[",     "]",          "{",      "}",
                                        "\"",    "'",          "\"\"\"", ".",
                                        "=",     "\n",         "#",      ",",
                                        "-",     "1e308",      "nan",    "inf",
                                        "0x",    "\\u",        "\\",     "9223372036854775807",
                                        "[[a]]", "1979-05-27", "_",      "true",
                                        "\xff",  "\r"};
  const auto below = [&](std::size_t n) {
    return static_cast<std::size_t>(random() % n);
  };
  if (text.empty()) return "[";
  const std::size_t at = below(text.size());
  const std::size_t length = 1 + below(20);
  switch (below(6)) {
    case 0:
      text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
      break;
    case 1:
      text[at] = static_cast<char>(below(256));
      break;
    case 2:
      text.erase(at, length);
      break;
    case 3:
      text.insert(at, text.substr(at, length));
      break;
    case 4:
      text.insert(below(text.size()), text.substr(at, length));
      break;
    default:
      text.insert(at, kPieces[below(std::size(kPieces))]);
      break;
  }
  return text;
}

TEST(Fuzz, DamagedScenesEndInASceneOrAnError) {
  std::mt19937 random(20240229);
  int read = 0;
  int refused = 0;
  for (const SceneText& good : good_scenes()) {
    for (int i = 0; i < 1000; ++i) {
      // some changes at once, so that later stages see damage too
      std::string text = good.text;
      const int changes = std::max(1, static_cast<int>(random() % 8) - 4);
      for (int k = 0; k < changes; ++k)
        text = damaged(text, random);
      try {
        scene_hash(parse_scene(text, "fuzz"));
        ++read;
      } catch (const Error& error) {
        ASSERT_EQ(error.fault(), Fault::input);
        ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        ++refused;
      } catch (...) {
        FAIL() << "another exception for:\n" << text;
      }
    }
  }
  // both ends are reached often, or the damage is too weak or too strong to test anything
  EXPECT_GT(read, 200);
  EXPECT_GT(refused, 5000);
}

}  // namespace
}  // namespace polhode
