// SPDX-License-Identifier: MIT
#include "base/system/atomic_file.h"

#include <csignal>
#include <fstream>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include "base/error.h"
#include "base/system/interrupt.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

// A folder of its own for each test.
class AtomicFileTest : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override {
    fs::permissions(folder_, fs::perms::owner_all);
    fs::remove_all(folder_);
  }
  std::size_t files_in_folder() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }

  const fs::path folder_ =
      fs::path(::testing::TempDir()) / ("polhode_atomic_" + std::to_string(getpid()));
  const fs::path target_ = folder_ / "out.txt";
};

TEST_F(AtomicFileTest, appears_whole_on_commit) {
  {
    AtomicFile file(target_);
    std::ofstream(file.part()) << "new";
    EXPECT_FALSE(fs::exists(target_));
    file.commit();
  }
  EXPECT_EQ(read_file(target_), "new");
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(AtomicFileTest, leaves_nothing_when_abandoned) {
  {
    AtomicFile file(target_);
    std::ofstream(file.part()) << "new";
  }
  EXPECT_EQ(files_in_folder(), 0u);
}

TEST_F(AtomicFileTest, refuses_the_second_writer_and_takes_over_what_a_killed_one_left) {
  std::ofstream(target_.string() + ".part") << "left behind";
  {
    AtomicFile first(target_);
    try {
      AtomicFile second(target_);
      FAIL();
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("another run"), std::string::npos);
    }
    first.commit_with("whole");
  }
  EXPECT_EQ(read_file(target_), "whole");
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(AtomicFileTest, follows_a_link_and_refuses_a_device) {
  write_file(folder_ / "real.txt", "old");
  fs::create_symlink(folder_ / "real.txt", target_);
  write_file(target_, "new");
  EXPECT_TRUE(fs::is_symlink(target_));
  EXPECT_EQ(read_file(folder_ / "real.txt"), "new");
  EXPECT_THROW(AtomicFile("/dev/null"), Error);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFileTest, leaves_the_old_file_when_abandoned) {
  write_file(target_, "old");
  {
    AtomicFile file(target_);
    std::ofstream(file.part()) << "new";
  }
  EXPECT_EQ(read_file(target_), "old");
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(AtomicFileTest, replaces_the_old_file_on_commit) {
  write_file(target_, "old");
  write_file(target_, std::string("n\0w", 3));
  EXPECT_EQ(read_file(target_), std::string("n\0w", 3));
}

// the input error of opening a target, "" when there is none
std::string error_of(const fs::path& target) {
  try {
    AtomicFile file(target);
  } catch (const Error& error) {
    EXPECT_EQ(error.fault(), Fault::input);
    EXPECT_EQ(error.place().file, target.string());
    return error.message();
  }
  return "";
}

TEST_F(AtomicFileTest, refuses_a_missing_folder) {
  EXPECT_NE(error_of(folder_ / "none" / "out.txt").find("does not exist"), std::string::npos);
}

TEST_F(AtomicFileTest, refuses_a_folder_as_target) {
  EXPECT_EQ(error_of(folder_), "is a folder; give a file name");
  EXPECT_TRUE(fs::is_directory(folder_));
}

// a link where the temporary file goes would have its target overwritten
TEST_F(AtomicFileTest, refuses_a_link_as_temporary_file) {
  const fs::path victim = folder_ / "victim";
  std::ofstream(victim) << "precious";
  fs::create_symlink(victim, folder_ / "out.txt.part");
  EXPECT_NE(error_of(folder_ / "out.txt").find("is a link"), std::string::npos);
  EXPECT_EQ(read_file(victim), "precious");
}

TEST_F(AtomicFileTest, refuses_an_unwritable_folder) {
  // root may write everywhere but where the kernel itself says no
  if (geteuid() == 0) {
    EXPECT_NE(error_of("/proc/out.txt").find("cannot create"), std::string::npos);
    return;
  }
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_NE(error_of(target_).find("cannot create"), std::string::npos);
}

TEST_F(AtomicFileTest, reading_stops_at_the_limit) {
  write_file(target_, "12345");
  EXPECT_EQ(read_file(target_, 5), "12345");
  EXPECT_THROW(read_file(target_, 4), Error);
  EXPECT_THROW(read_file("/dev/zero", 1000000), Error);
}

// the exit code of a child that runs `work`; -1 when it ended otherwise
template <class Work>
int exit_code_of_child(Work work) {
  const pid_t child = fork();
  if (child == 0) _exit(work());
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(AtomicFileTest, a_full_disk_leaves_nothing) {
  // a limit on the size of files stands for the full disk
  const int code = exit_code_of_child([&] {
    watch_for_interrupt();
    const rlimit limit{1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_file(target_, std::string(100000, 'x'));
    } catch (const Error& error) {
      return static_cast<int>(error.fault());
    }
    return 0;
  });
  EXPECT_EQ(code, static_cast<int>(Fault::environment));
  EXPECT_EQ(files_in_folder(), 0u);
}

// the exit code that stop_if_interrupted() would end in
int interruption() {
  try {
    stop_if_interrupted();
  } catch (const Error& error) {
    return static_cast<int>(error.fault());
  }
  return 0;
}

TEST(Interrupt, a_signal_becomes_an_error) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const int code = exit_code_of_child([&] {
      watch_for_interrupt();
      if (interruption() != 0) return 1;
      raise(signal);
      return interruption();
    });
    EXPECT_EQ(code, 130);
  }
}

// a terminal and its shell both send the signal of one key
TEST(Interrupt, two_signals_at_once_are_one) {
  const int code = exit_code_of_child([] {
    watch_for_interrupt();
    raise(SIGHUP);
    raise(SIGHUP);
    return interruption();
  });
  EXPECT_EQ(code, 130);
}

TEST(Interrupt, a_second_signal_later_ends_the_process) {
  const int code = exit_code_of_child([] {
    watch_for_interrupt();
    raise(SIGINT);
    usleep(600'000);
    raise(SIGINT);
    return 0;
  });
  EXPECT_EQ(code, -1);
}

}  // namespace
}  // namespace polhode
