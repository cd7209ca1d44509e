// SPDX-License-Identifier: MIT
// Which name becomes which kind of output.
#include "video/sink_kinds.h"

#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/expect_error.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::TemporaryFolder;

SinkJob plain_job(const std::string& output) {
  SinkJob job;
  job.output = output;
  job.width = 64;
  job.height = 48;
  job.fps = {25, 1};
  return job;
}

TEST(SinkKinds, TheNameTellsTheKind) {
  const std::pair<const char*, const char*> table[] = {{"a.mp4", "mp4"},
                                                       {"dir.png/a.webm", "webm"},
                                                       {"a.mov", "mov"},
                                                       {"a.gif", "gif"},
                                                       {"a.apng", "apng"},
                                                       {"a.y4m", "y4m"},
                                                       {"-", "y4m"},
                                                       {"a.png", "png"},
                                                       {"a_%05d.png", "png sequence"},
                                                       {"a.hash", "hash"},
                                                       {"hash:a.mp4", "hash"},
                                                       {"hash:a_%d.png", "hash"},
                                                       {"null", "null"}};
  std::set<std::string> named;
  for (const auto& [output, kind] : table) {
    EXPECT_EQ(find_sink_kind(output).name, kind) << output;
    named.insert(kind);
  }
  EXPECT_EQ(named.size(), sink_kinds().size()) << "a kind without its name here";
}

TEST(SinkKinds, AnUnknownEndingNamesTheNearest) {
  test::expect_input_error([] { find_sink_kind("a.mp5"); }, "", "'.mp4'");
  test::expect_input_error([] { find_sink_kind("a.mp4/film"); }, "", "ending ''");
  for (const char* picture : {"a.jpg", "a.jpeg", "a.tiff", "a.svg"})
    test::expect_input_error([&] { find_sink_kind(picture); }, "", "'.png'");
  test::expect_input_error([] { find_sink_kind("a.mp5", true); }, "", "'.png'");
  EXPECT_TRUE(find_sink_kind("a.mp4", true).film) << "the caller refuses it";
  test::expect_input_error([] { find_sink_kind("nul"); }, "", "no format has the ending");
}

// ".mp4" would be a hidden file without a name, "%d.mp4" one file of a sequence that is none
TEST(SinkKinds, NamesThatCannotBeMeantAreRefused) {
  const TemporaryFolder folder;
  const auto make = [&](const char* name) {
    return [&, name] {
      make_sink(plain_job(folder / name));
    };
  };
  test::expect_input_error(make(".mp4"), "", "film.mp4");
  test::expect_input_error(make(".gif"), "", "film.gif");
  test::expect_input_error(make("a_%05d.mp4"), "", "numbered .png");
  EXPECT_EQ(folder.entries(), 0);
}

// those that keep no alpha refuse a transparent picture; the others make one
TEST(SinkKinds, AlphaIsKeptOrRefused) {
  for (const SinkKind& kind : sink_kinds()) {
    if (!kind.film || kind.ending.empty()) continue;
    const TemporaryFolder folder;
    SinkJob job = plain_job(folder / ("a" + kind.ending));
    job.transparent = true;
    if (kind.alpha) {
      EXPECT_NO_THROW(make_sink(job)) << kind.name;
    } else {
      test::expect_input_error([&] { make_sink(job); }, "", "no alpha channel");
    }
  }
}

// names, endings and phrases are what `list formats` and the documentation show
TEST(SinkKinds, EveryRowIsWhole) {
  std::set<std::string> names;
  for (const SinkKind& kind : sink_kinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_FALSE(kind.doc.empty()) << kind.name;
    EXPECT_NE(kind.make, nullptr) << kind.name;
    if (kind.accepts == nullptr) {
      EXPECT_EQ(kind.ending.rfind('.', 0), 0U) << kind.name;
    }
    if (kind.film && !kind.ending.empty()) {
      EXPECT_EQ(find_sink_kind("a.b" + kind.ending).name, kind.name);
      EXPECT_FALSE(find_sink_kind("hash:a" + kind.ending).film) << kind.name;
    }
  }
}

TEST(SinkKinds, WhatItCannotDoIsSaid) {
  const TemporaryFolder folder;
  const auto message = [](const SinkJob& job) -> std::string {
    try {
      make_sink(job);
    } catch (const Error& error) {
      EXPECT_EQ(error.fault(), Fault::input);
      return error.what();
    }
    return "";
  };
  SinkJob odd = plain_job(folder / "a.mp4");
  odd.width = 63;
  EXPECT_NE(message(odd).find("64x48"), std::string::npos);
  SinkJob clear = plain_job(folder / "a.mp4");
  clear.transparent = true;
  EXPECT_NE(message(clear).find("png"), std::string::npos);
  SinkJob still = plain_job(folder / "a.mp4");
  still.still = true;
  EXPECT_NE(message(still).find(".png"), std::string::npos);
  EXPECT_NE(message(plain_job(folder / "a.mp5")).find("'.mp4'"), std::string::npos);
  EXPECT_NE(message(plain_job(folder / "film")).find(".mp4"), std::string::npos);
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace polhode
