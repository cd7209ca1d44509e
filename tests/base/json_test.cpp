// SPDX-License-Identifier: MIT
#include "base/json.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

std::string nested(std::size_t levels) {
  return std::string(levels, '[') + std::string(levels, ']');
}

TEST(ForeignJson, IsNullUnlessItIsJsonOfFewLevels) {
  EXPECT_EQ(parse_foreign_json(R"({"b": [1, 2.5], "a": "x"})").dump(), R"({"b":[1,2.5],"a":"x"})");
  EXPECT_TRUE(parse_foreign_json("{").is_null());
  EXPECT_TRUE(parse_foreign_json("").is_null());
  EXPECT_TRUE(parse_foreign_json(nested(90)).is_array());
  constexpr std::size_t kDeep = 300'000;
  EXPECT_TRUE(parse_foreign_json(nested(kDeep)).is_null());
  EXPECT_TRUE(parse_foreign_json(R"({"a": {"b": )" + nested(kDeep) + "}}").is_null());
}

TEST(ForeignJson, IsNullWhereAKeyStandsTwice) {
  EXPECT_TRUE(
      parse_foreign_json(R"({"a": 1, "b": [{"a": 2}, {"a": 3}], "c": {"a": 4}})").is_object());
  EXPECT_TRUE(parse_foreign_json(R"({"a": 1, "b": 2, "a": 1})").is_null());
  EXPECT_TRUE(parse_foreign_json(R"({"b": [{"a": {}, "a": []}]})").is_null());
  std::string many = "{\"k\": 0";
  for (int i = 0; i < 300'000; ++i)
    many += ", \"k" + std::to_string(i) + "\": 0";
  EXPECT_TRUE(parse_foreign_json(many + "}").is_null());
}

}  // namespace
}  // namespace polhode
