// SPDX-License-Identifier: MIT
#include "base/system/unfinished.h"

#include <chrono>
#include <csignal>
#include <fstream>
#include <memory>
#include <sched.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "base/system/atomic_file.h"
#include "base/system/scratch_folder.h"
#include "support/in_child.h"

namespace polhode::test {
namespace {

namespace fs = std::filesystem;

TEST(Unfinished, IsRemovedWhenTheProcessEndsAtOnce) {
  const ScratchFolder folder;
  std::ofstream(folder / "a.mp4") << "old";
  const int code = exit_code_in_child([&] {
    AtomicFile half(folder / "a.mp4");
    half.write("half");
    AtomicFile whole(folder / "b.mp4");
    whole.commit_with("whole");
    fs::create_directories(folder / "scratch/deep");
    std::ofstream(folder / "scratch/deep/file") << "x";
    const Unfinished scratch{fs::path(folder / "scratch")};
    { const Unfinished done{fs::path(folder / "b.mp4")}; }
    end_at_once(7);
    return 0;
  });
  EXPECT_EQ(code, 7);
  EXPECT_EQ(read_file(folder / "a.mp4"), "old");
  EXPECT_EQ(read_file(folder / "b.mp4"), "whole");
  EXPECT_FALSE(fs::exists(folder / "a.mp4.part"));
  EXPECT_FALSE(fs::exists(folder / "scratch"));
}

TEST(Unfinished, ChildrenAreEnded) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  exit_code_in_child([&] {
    const pid_t child = fork();
    if (child == 0) {
      while (true)
        pause();
    }
    const Unfinished running(child);
    end_at_once(0);
    return 0;
  });
  // its end closes the last writing end of the pipe
  close(ends[1]);
  char byte = 0;
  EXPECT_EQ(read(ends[0], &byte, 1), 0);
  close(ends[0]);
}

TEST(Unfinished, BelongsToTheProcessThatMadeIt) {
  const ScratchFolder folder;
  const AtomicFile file(folder / "a");
  exit_code_in_child([] {
    end_at_once(0);
    return 0;
  });
  EXPECT_TRUE(fs::exists(folder / "a.part"));
}

TEST(Unfinished, IsRemovedAfterACrash) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "crashes are the sanitizer's";
#endif
  for (const int signal : {SIGSEGV, SIGABRT, SIGTRAP, SIGQUIT, SIGXCPU, SIGUSR1}) {
    const ScratchFolder folder;
    const int code = exit_code_in_child([&] {
      tidy_up_after_crashes();
      AtomicFile half(folder / "a.mp4");
      std::raise(signal);
      return 0;
    });
    EXPECT_EQ(code, -1) << "by the signal, as others see it";
    EXPECT_TRUE(fs::is_empty(fs::path(folder / "")));
  }
}

// as in a container: the kernel keeps from it what it sends to itself
TEST(Unfinished, IsRemovedAlsoByTheFirstProcessOfAll) {
  constexpr int kNotAllowed = 77;
  const ScratchFolder folder;
  const int code = exit_code_in_child([&] {
    if (unshare(CLONE_NEWPID) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWPID) != 0)
      return kNotAllowed;
    return exit_code_in_child([&] {
      tidy_up_after_crashes();
      const AtomicFile half(folder / "a.mp4");
      std::raise(SIGUSR1);
      return 0;
    });
  });
  if (code == kNotAllowed) GTEST_SKIP() << "namespaces are not allowed here";
  EXPECT_EQ(code, 128 + SIGUSR1);
  EXPECT_TRUE(fs::is_empty(fs::path(folder / "")));
}

// the same signal again finds another thread, while the first removes a folder; one to the whole
// group must not end the program that removes it
TEST(Unfinished, IsRemovedAfterASignalThatComesAgainAndAgain) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "threads that do not end are the sanitizer's";
#endif
  for (const int signal : {SIGQUIT, SIGUSR1, SIGPROF}) {
    const ScratchFolder folder;
    const int code = exit_code_in_child([&] {
      setpgid(0, 0);
      std::signal(SIGTERM, [](int) {});
      tidy_up_after_crashes();
      const AtomicFile one(folder / "a");
      fs::create_directory(folder / "many");
      for (int i = 0; i < 2000; ++i)
        std::ofstream(folder / ("many/" + std::to_string(i))) << i;
      const Unfinished many{fs::path(folder / "many")};
      const AtomicFile other(folder / "b");
      std::thread again([signal] {
        while (true) {
          kill(0, signal);
          kill(0, SIGTERM);
          std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
      });
      again.join();
      return 0;
    });
    EXPECT_EQ(code, -1) << "by the signal, as others see it";
    EXPECT_TRUE(fs::is_empty(fs::path(folder / ""))) << signal;
  }
}

// as those of a thousand pictures, which get their names together
TEST(Unfinished, HoweverMuchThereIs) {
  const ScratchFolder folder;
  const int code = exit_code_in_child([&] {
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i) {
      threads.emplace_back([] {
        for (int n = 0; n < 1000; ++n)
          const Unfinished one{fs::path("no such file" + std::string(n % 5 * 200, 'x'))};
      });
    }
    for (std::thread& thread : threads)
      thread.join();
    const Unfinished too_long{fs::path(std::string(5000, 'x'))};
    std::vector<std::unique_ptr<Unfinished>> many;
    for (int i = 0; i < 1000; ++i) {
      const std::string name = folder / std::to_string(i);
      std::ofstream(name) << "x";
      many.push_back(std::make_unique<Unfinished>(fs::path(name)));
    }
    for (int i = 0; i < 1000; i += 3)
      many[i].reset();
    end_at_once(0);
    return 0;
  });
  EXPECT_EQ(code, 0);
  const fs::directory_iterator left(folder / "");
  EXPECT_EQ(std::distance(begin(left), end(left)), 334) << "those that were finished";
}

}  // namespace
}  // namespace polhode::test
