// SPDX-License-Identifier: MIT
#include "base/system/atomic_file.h"

#include <fcntl.h>
#include <fstream>
#include <iostream>
#include <string>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/xattr.h>

#include "base/error.h"
#include "support/full_disk.h"

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

TEST_F(AtomicFileTest, AppearsWholeOnCommit) {
  {
    AtomicFile file(target_);
    std::ofstream(file.part()) << "new";
    EXPECT_FALSE(fs::exists(target_));
    file.commit();
  }
  EXPECT_EQ(read_file(target_), "new");
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(AtomicFileTest, WhatOnlySomeMayReadStaysSo) {
  for (const mode_t mode : {0600U, 0640U, 0664U}) {
    std::ofstream(target_) << "old";
    ASSERT_EQ(chmod(target_.c_str(), mode), 0);
    AtomicFile file(target_);
    EXPECT_EQ(static_cast<mode_t>(fs::status(file.part()).permissions()), mode);
    file.commit_with("new");
    EXPECT_EQ(static_cast<mode_t>(fs::status(target_).permissions()), mode);
  }
}

TEST_F(AtomicFileTest, OwnerAndGroupStay) {
  if (geteuid() != 0) GTEST_SKIP() << "only root may give files away";
  std::ofstream(target_) << "old";
  ASSERT_EQ(chown(target_.c_str(), 1500, 1234), 0);
  AtomicFile(target_).commit_with("new");
  struct stat its = {};
  ASSERT_EQ(stat(target_.c_str(), &its), 0);
  EXPECT_EQ(its.st_uid, 1500U);
  EXPECT_EQ(its.st_gid, 1234U);
}

// the mode alone would give the group what the list gives one user
TEST_F(AtomicFileTest, ListsOfUsersStay) {
  // acl(5) as the kernel has it: version 2, then kind, rights and number of each, little-endian
  const std::string nobody = "\xff\xff\xff\xff";
  const std::string list = std::string("\2\0\0\0", 4) + std::string("\1\0\6\0", 4) + nobody +
                           std::string("\2\0\6\0\x92\x10\0\0", 8) + std::string("\4\0\0\0", 4) +
                           nobody + std::string("\x10\0\6\0", 4) + nobody +
                           std::string("\x20\0\0\0", 4) + nobody;
  const char* const name = "system.posix_acl_access";
  std::ofstream(target_) << "old";
  if (setxattr(target_.c_str(), name, list.data(), list.size(), 0) != 0)
    GTEST_SKIP() << "this file system has no lists";
  AtomicFile(target_).commit_with("new");
  std::string kept(200, '\0');
  const ssize_t length = getxattr(target_.c_str(), name, kept.data(), kept.size());
  ASSERT_GT(length, 0);
  kept.resize(static_cast<std::size_t>(length));
  EXPECT_EQ(kept, list);
  EXPECT_EQ(read_file(target_), "new");
}

TEST_F(AtomicFileTest, WhatHadTheNameGetsItBack) {
  for (const bool is_new : {true, false}) {
    fs::remove(target_);
    if (!is_new) std::ofstream(target_) << "old";
    AtomicFile file(target_);
    file.write("new");
    file.commit_for_now();
    EXPECT_EQ(read_file(target_), "new");
    file.withdraw();
    EXPECT_EQ(fs::exists(target_), !is_new);
    if (!is_new) {
      EXPECT_EQ(read_file(target_), "old");
    }
  }
  EXPECT_EQ(files_in_folder(), 1U);
  {
    AtomicFile file(target_);
    file.write("new");
    file.commit_for_now();
  }
  EXPECT_EQ(read_file(target_), "new");
  EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(AtomicFileTest, LeavesNothingWhenAbandoned) {
  {
    AtomicFile file(target_);
    std::ofstream(file.part()) << "new";
  }
  EXPECT_EQ(files_in_folder(), 0u);
}

TEST_F(AtomicFileTest, RefusesTheSecondWriterAndTakesOverWhatAKilledOneLeft) {
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

TEST_F(AtomicFileTest, FollowsALinkAndRefusesADevice) {
  write_file(folder_ / "real.txt", "old");
  fs::create_symlink(folder_ / "real.txt", target_);
  write_file(target_, "new");
  EXPECT_TRUE(fs::is_symlink(target_));
  EXPECT_EQ(read_file(folder_ / "real.txt"), "new");
  // to a file that is not there yet, by a link that is relative to its folder
  fs::create_symlink("later.txt", folder_ / "second.txt");
  write_file(folder_ / "second.txt", "made");
  EXPECT_TRUE(fs::is_symlink(folder_ / "second.txt"));
  EXPECT_EQ(read_file(folder_ / "later.txt"), "made");
  fs::create_symlink(folder_ / "none" / "x.txt", folder_ / "astray.txt");
  EXPECT_THROW(AtomicFile(folder_ / "astray.txt"), Error);
  EXPECT_TRUE(fs::is_symlink(folder_ / "astray.txt"));
  EXPECT_THROW(AtomicFile("/dev/null"), Error);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFileTest, LeavesTheOldFileWhenAbandoned) {
  write_file(target_, "old");
  {
    AtomicFile file(target_);
    std::ofstream(file.part()) << "new";
  }
  EXPECT_EQ(read_file(target_), "old");
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(AtomicFileTest, ReplacesTheOldFileOnCommit) {
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

TEST_F(AtomicFileTest, RefusesAMissingFolder) {
  EXPECT_NE(error_of(folder_ / "none" / "out.txt").find("does not exist"), std::string::npos);
}

TEST_F(AtomicFileTest, RefusesAFolderAsTarget) {
  EXPECT_EQ(error_of(folder_), "is a folder; give a file name");
  EXPECT_TRUE(fs::is_directory(folder_));
}

// a link where the temporary file goes would have its target overwritten
TEST_F(AtomicFileTest, RefusesALinkAsTemporaryFile) {
  const fs::path victim = folder_ / "victim";
  std::ofstream(victim) << "precious";
  fs::create_symlink(victim, folder_ / "out.txt.part");
  EXPECT_NE(error_of(folder_ / "out.txt").find("is a link"), std::string::npos);
  fs::remove(folder_ / "out.txt.part");
  fs::create_hard_link(victim, folder_ / "out.txt.part");
  EXPECT_NE(error_of(folder_ / "out.txt").find("is a link"), std::string::npos);
  EXPECT_EQ(read_file(victim), "precious");
}

// opening a pipe to write would wait for somebody who reads it
TEST_F(AtomicFileTest, RefusesAPipeAsTemporaryFile) {
  ASSERT_EQ(mkfifo((folder_ / "out.txt.part").c_str(), 0600), 0);
  EXPECT_NE(error_of(folder_ / "out.txt").find("is not a regular file"), std::string::npos);
}

// as /dev/stdout may be; where it leads, by the words of /proc, is no file
TEST_F(AtomicFileTest, RefusesAPipeWithoutAName) {
  int ends[2] = {};
  ASSERT_EQ(pipe(ends), 0);
  EXPECT_NE(error_of("/proc/self/fd/" + std::to_string(ends[1])).find("standard output is -"),
            std::string::npos);
  close(ends[0]);
  close(ends[1]);
}

// what others have written there before, and will write, would be lost
TEST_F(AtomicFileTest, RefusesFilesThatAreOpen) {
  std::ofstream(target_) << "precious";
  const int file = open(target_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  ASSERT_GE(file, 0);
  std::cout.flush();
  const int before = dup(STDOUT_FILENO);
  dup2(file, STDOUT_FILENO);
  std::vector<std::string> said;
  const std::string by_itself = error_of(target_);
  for (const std::string& name : std::vector<std::string>{
           "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", fmt::format("/dev/fd/{}", file)})
    said.push_back(error_of(name));
  dup2(before, STDOUT_FILENO);
  close(before);
  close(file);
  for (const std::string& one : said)
    EXPECT_NE(one.find("is a file that is open"), std::string::npos) << one;
  EXPECT_NE(by_itself.find("would replace the file of standard output"), std::string::npos);
  EXPECT_EQ(read_file(target_), "precious");
  EXPECT_EQ(files_in_folder(), 1u);
  EXPECT_EQ(error_of(target_), "") << "it is no stream any more";
}

// in a folder like /tmp the system refuses to rename over it, which would be told at the end
TEST_F(AtomicFileTest, RefusesWhatBelongsToSomebodyElse) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can give files to others";
  constexpr uid_t kOne = 65533, kOther = 65534;
  std::ofstream(target_) << "precious";
  ASSERT_EQ(chmod(folder_.c_str(), 01777), 0);
  ASSERT_EQ(chmod(target_.c_str(), 0666), 0);
  ASSERT_EQ(chown(target_.c_str(), kOne, kOne), 0);
  const auto said_to = [&](uid_t user) {
    EXPECT_EQ(seteuid(user), 0);
    const bool may_enter = std::ifstream(target_).is_open();
    const std::string said = may_enter ? error_of(target_) : "may not enter";
    EXPECT_EQ(seteuid(0), 0);
    return said;
  };
  if (said_to(kOther) == "may not enter") GTEST_SKIP() << "the folder of tests is closed to others";
  EXPECT_NE(said_to(kOther).find("belongs to another user"), std::string::npos);
  EXPECT_EQ(said_to(kOne), "");
  ASSERT_EQ(chmod(folder_.c_str(), 0777), 0);
  EXPECT_EQ(said_to(kOther), "") << "there anybody may";
}

TEST_F(AtomicFileTest, RefusesAnUnwritableFolder) {
  // root may write everywhere but where the kernel itself says no
  if (geteuid() == 0) {
    EXPECT_NE(error_of("/proc/out.txt").find("cannot create"), std::string::npos);
    return;
  }
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_NE(error_of(target_).find("cannot create"), std::string::npos);
}

TEST_F(AtomicFileTest, ReadingStopsAtTheLimit) {
  write_file(target_, "12345");
  EXPECT_EQ(read_file(target_, 5), "12345");
  EXPECT_THROW(read_file(target_, 4), Error);
  EXPECT_THROW(read_file("/dev/zero", 1000000), Error);
}

TEST_F(AtomicFileTest, AFullDiskLeavesNothing) {
  const auto work = [&] {
    write_file(target_, std::string(100000, 'x'));
  };
  EXPECT_EQ(test::with_full_disk(1000, work), test::Outcome::environment);
  EXPECT_EQ(files_in_folder(), 0u);
}

}  // namespace
}  // namespace polhode
