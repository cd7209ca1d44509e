// SPDX-License-Identifier: MIT
// Films drawn by several processes, and what becomes of the film when one of them dies.
#include <algorithm>

#include <fmt/format.h>

#include "support/background.h"

namespace polhode {
namespace {

using test::Background;
using test::Ran;
using test::read_text;
using test::run_polhode;
using test::TemporaryFolder;

class Jobs : public ::testing::Test {
 protected:
  Jobs() { test::write_text(folder_ / "scene.toml", test::kSmallScene); }

  TemporaryFolder folder_;
};

TEST_F(Jobs, PixelsDoNotDependOnTheirNumber) {
  for (const std::string more :
       {"--size 128x72", "--size 960x540 --to 0.5", "--size 128x72 --no-text", "--transparent"}) {
    std::string one;
    for (const int jobs : {1, 2, 4}) {
      const Ran ran = run_polhode(fmt::format("render '{}' -o '{}' --jobs {} {}",
                                              folder_ / "scene.toml",
                                              folder_ / "a.hash",
                                              jobs,
                                              more));
      ASSERT_EQ(ran.code, 0) << ran.err;
      if (jobs == 1) one = read_text(folder_ / "a.hash");
      EXPECT_EQ(read_text(folder_ / "a.hash"), one) << jobs << more;
    }
  }
}

class JobsKilled : public Jobs {
 protected:
  // a film that takes long, by two processes
  JobsKilled() { test::write_text(folder_ / "scene.toml", test::long_scene()); }
  std::vector<std::string> long_film() const {
    return {"render",
            folder_ / "scene.toml",
            "-o",
            folder_ / "a.mp4",
            "--jobs",
            "2",
            "--progress",
            "json"};
  }
  std::vector<pid_t> workers(const Background& run) const {
    EXPECT_TRUE(test::becomes([&] { return run.children().size() == 2; }));
    run.await_progress();
    return run.children();
  }
  void expect_gone(const std::vector<pid_t>& processes) const {
    for (const pid_t id : processes) {
      EXPECT_TRUE(test::becomes([&] { return !test::runs(id); })) << "an orphan";
    }
  }
};

TEST_F(JobsKilled, AWorkerThatIsKilledEndsTheFilmInOneLine) {
  Background run(long_film());
  const std::vector<pid_t> crew = workers(run);
  ASSERT_EQ(crew.size(), 2u);
  kill(crew[1], SIGKILL);
  const Ran ran = run.end();
  EXPECT_EQ(ran.code, 3);
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  EXPECT_NE(ran.err.find("a drawing process was ended by signal 9"), std::string::npos) << ran.err;
  EXPECT_EQ(folder_.entries(), 1);
  expect_gone(crew);
}

TEST_F(JobsKilled, WorkersEndWithTheirParent) {
  for (const int signal : {SIGKILL, SIGINT}) {
    Background run(long_film());
    const std::vector<pid_t> crew = workers(run);
    const Ran ran = run.end(signal);
    EXPECT_EQ(ran.code, signal == SIGINT ? 130 : 128 + SIGKILL) << ran.err;
    expect_gone(crew);
  }
  EXPECT_EQ(folder_.entries(), 1) << "the second run has taken over what the first left";
}

TEST_F(Jobs, AWorkerWithoutMemoryIsOneLine) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer itself needs terabytes of addresses";
#endif
  const Ran ran = run_polhode(fmt::format("render '{}' -o '{}' --size 4096x4096 --jobs 2",
                                          folder_ / "scene.toml",
                                          folder_ / "a.hash"),
                              "ulimit -v 900000;");
  EXPECT_EQ(ran.code, 3) << ran.err;
  EXPECT_EQ(folder_.entries(), 1);
}

}  // namespace
}  // namespace polhode
