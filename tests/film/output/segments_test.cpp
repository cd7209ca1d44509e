// SPDX-License-Identifier: MIT
#include "film/output/segments.h"

#include <gtest/gtest.h>

#include "base/json.h"
#include "support/expect_error.h"

namespace polhode {
namespace {

SegmentRecord record() {
  SegmentRecord record;
  record.version = "1.0";
  record.ffmpeg = "5.1";
  record.scene = "abc";
  record.title = "a; piece {title}";
  record.settings = {{"codec", "h264"},
                     {"preset", "slow"},
                     {"crf", "18"},
                     {"finest", "false"},
                     {"threads", "2"},
                     {"size", "64x64"},
                     {"fps", "25/1"},
                     {"from", "0"},
                     {"to", "1"},
                     {"transparent", "false"}};
  record.shard = {2, 3};
  record.range = {8, 8};
  record.film.frames = 25;
  record.film.chapters = {{0, "Begin"}};
  record.film.captions = {{0, 3, "Words"}};
  return record;
}

// the comment with its record changed by `change`
template <class Change>
std::string changed(const Change& change) {
  const std::string comment = comment_with(record());
  const std::size_t begin = comment.find("; piece ") + 8;
  Json json = Json::parse(comment.substr(begin));
  change(json);
  return comment.substr(0, begin) + json.dump();
}

TEST(Segments, ARecordIsReadAsItWasWritten) {
  const SegmentRecord read = parse_record(comment_with(record()));
  EXPECT_EQ(difference_between(read, record()), "");
  EXPECT_EQ(read.title, record().title);
  EXPECT_EQ(read.settings, record().settings);
  EXPECT_EQ(read.film.captions.at(0).words, "Words");
}

TEST(Segments, WhatARecordLacksIsNamed) {
  const Json whole = Json::parse(comment_with(record()).substr(comment_with(record()).find('{')));
  EXPECT_EQ(whole.size(), 11U);
  for (const auto& item : whole.items()) {
    const std::string& key = item.key();
    const std::string comment = changed([&](Json& json) { json.erase(key); });
    test::expect_input_error(
        [&] { parse_record(comment); }, "", fmt::format("its record lacks '{}'", key));
  }
  for (const auto& setting : record().settings) {
    const std::string& key = setting.first;
    const std::string comment = changed([&](Json& json) { json["settings"].erase(key); });
    test::expect_input_error(
        [&] { parse_record(comment); }, "", fmt::format("its record lacks 'settings.{}'", key));
  }
}

TEST(Segments, ARecordThatContradictsItselfIsNone) {
  const auto refused = [](const std::string& comment, const char* words) {
    test::expect_input_error([&] { parse_record(comment); }, "", words);
  };
  refused("polhode 1.0, scene abc", "is not a piece of a film");
  refused("; piece [", "is not a piece of a film");
  refused("; piece []", "its record lacks 'polhode'");
  refused(changed([](Json& json) { json["first"] = 7; }), "is not a piece of a film");
  refused(changed([](Json& json) { json["title"] = 7; }), "is not a piece of a film");
  refused(changed([](Json& json) { json["settings"]["fps"] = "often"; }), "often");
}

}  // namespace
}  // namespace polhode
