// SPDX-License-Identifier: MIT
#include "batch/task_sizes.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

DividedWork work_of(long pieces, double piece_s, double start_s) {
  DividedWork work;
  work.pieces = pieces;
  work.piece_s = piece_s;
  work.start_s = start_s;
  return work;
}

TEST(TaskSizes, AreLongAgainstTheirStart) {
  // 10,000 s of work that starts in 4 s: tasks of 80 s at least, so 125
  const TaskSizes sizes = sizes_of_tasks(work_of(1000, 10.0, 4.0), 1000);
  EXPECT_EQ(sizes.tasks, 125);
  EXPECT_DOUBLE_EQ(sizes.longest_s, 84.0);
  EXPECT_LE(sizes.start_s, kMostOfStart * sizes.longest_s);
}

TEST(TaskSizes, AreNotShorterThanSchedulersLike) {
  EXPECT_EQ(sizes_of_tasks(work_of(1000, 0.3, 0.0), 1000).tasks, 10);
  EXPECT_EQ(sizes_of_tasks(work_of(1000, 0.001, 0.0), 1000).tasks, 1);
}

TEST(TaskSizes, HaveAPieceEachAndALimit) {
  EXPECT_EQ(sizes_of_tasks(work_of(7, 1000.0, 0.1), 1000).tasks, 7);
  EXPECT_EQ(sizes_of_tasks(work_of(5000, 100.0, 0.1), 1000).tasks, 1000);
}

// 12 pieces in 5 tasks would be 3, 3, 2, 2, 2: 4 tasks of 3 end as soon
TEST(TaskSizes, AreAlike) {
  const TaskSizes sizes = sizes_of_tasks(work_of(12, 15.0, 0.0), 5);
  EXPECT_EQ(sizes.tasks, 4);
  EXPECT_DOUBLE_EQ(sizes.longest_s, 45.0);
}

TEST(TaskSizes, SayHowLongItTakes) {
  const TaskSizes sizes = sizes_of_tasks(work_of(10, 50.0, 0.0), 10.0, 10);
  EXPECT_DOUBLE_EQ(wall_seconds(sizes, 1), 600.0);
  EXPECT_DOUBLE_EQ(wall_seconds(sizes, 4), 180.0);
  EXPECT_DOUBLE_EQ(wall_seconds(sizes, 100), 60.0);
}

}  // namespace
}  // namespace polhode
